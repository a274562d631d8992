//! Percepts as Python has them: an array of −1 (unknown), 0 (off) and 1 (on) for every item.

use cla_core::word::ItemId;
use host_sim::world::Percept;
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::guard::refused;

/// Reads a percept of so many items.
///
/// # Errors
/// `ValueError` that names the first item that is wrong.
pub(crate) fn read(array: &PyReadonlyArray1<'_, i8>, items: usize) -> PyResult<Percept> {
    let states = array
        .as_slice()
        .map_err(|_| refused("a percept is contiguous in memory"))?;
    if states.len() != items {
        return Err(refused(format_args!(
            "a percept of this robot has {items} items, not {}",
            states.len()
        )));
    }
    let mut percept = Percept::UNKNOWN;
    for (index, &state) in states.iter().enumerate() {
        let state = match state {
            0 => Some(false),
            1 => Some(true),
            -1 => None,
            other => {
                return Err(refused(format_args!(
                    "item {index} is 0, 1 or -1 for unknown, not {other}"
                )));
            }
        };
        percept.set(ItemId(index as u16), state).map_err(refused)?;
    }
    Ok(percept)
}

/// A percept of so many items as an array.
pub(crate) fn written<'py>(
    py: Python<'py>,
    percept: &Percept,
    items: usize,
) -> Bound<'py, PyArray1<i8>> {
    let state = |index| match percept.get(ItemId(index as u16)) {
        Some(true) => 1,
        Some(false) => 0,
        None => -1,
    };
    PyArray1::from_iter(py, (0..items).map(state))
}
