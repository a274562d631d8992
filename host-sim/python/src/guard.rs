//! What may go wrong on the way from Python and back: one sentence, and never a panic.

use std::fmt::Display;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::thread;

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

/// Bytes of stack in which the largest mind can be made, whatever thread Python calls from.
const ROOM: usize = 64 << 20;

/// Does something that may lie on the stack for a moment, where there is room for it.
///
/// # Errors
/// Those of `what`, and `RuntimeError` where it panicked or there is no thread.
pub(crate) fn with_room<T: Send>(
    what: impl FnOnce() -> Result<T, String> + Send,
) -> Result<T, PyErr> {
    let done = thread::scope(|scope| {
        let thread = thread::Builder::new().stack_size(ROOM);
        let thread = thread.spawn_scoped(scope, || guarded(|| what().map_err(refused)))?;
        Ok(thread.join())
    });
    let done = done.map_err(|it: std::io::Error| PyRuntimeError::new_err(it.to_string()))?;
    done.unwrap_or_else(|_| Err(PyRuntimeError::new_err("a fault in cla, please report it")))
}
