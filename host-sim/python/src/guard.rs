//! What may go wrong on the way from Python and back: one sentence, and never a panic.

use std::fmt::Display;
use std::panic::{AssertUnwindSafe, catch_unwind};

use pyo3::PyErr;
use pyo3::exceptions::{PyRuntimeError, PyValueError};

/// A `ValueError` with one sentence.
pub(crate) fn refused(why: impl Display) -> PyErr {
    PyValueError::new_err(why.to_string().replace('\n', " "))
}

/// Does something in which a fault of ours becomes a `RuntimeError` and not a panic in Python.
///
/// # Errors
/// Those of `what`, and `RuntimeError` where it panicked.
pub(crate) fn guarded<T>(what: impl FnOnce() -> Result<T, PyErr>) -> Result<T, PyErr> {
    catch_unwind(AssertUnwindSafe(what)).unwrap_or_else(|panic| {
        let said = panic
            .downcast_ref::<String>()
            .map(String::as_str)
            .or_else(|| panic.downcast_ref::<&str>().copied())
            .unwrap_or("nothing was said");
        Err(PyRuntimeError::new_err(format!(
            "a fault in cla, please report it: {said}"
        )))
    })
}
