//! Names that are made while the program runs and live as long as it does.
//!
//! Worlds name their items and actions with `&'static` lists; those of a file, or of a world with
//! items added to it, are kept here, each list once, however many worlds share it.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

/// A list of names for ever.
pub type Names = &'static [&'static str];

static KNOWN: Mutex<BTreeMap<Vec<String>, Names>> = Mutex::new(BTreeMap::new());

/// The list of these names; the same list for the same names.
///
/// ```
/// use host_sim::world::names::kept;
/// let names = kept(&["door", "key"]);
/// assert!(std::ptr::eq(names, kept(&["door".to_owned(), "key".to_owned()])));
/// ```
#[must_use]
pub fn kept<S: AsRef<str>>(names: &[S]) -> Names {
    // Whoever panicked while it held the lock has left the map whole.
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let wanted: Vec<String> = names.iter().map(|it| it.as_ref().to_owned()).collect();
    if let Some(&same) = known.get(&wanted) {
        return same;
    }
    let leak = |name: &String| -> &'static str { Box::leak(name.clone().into_boxed_str()) };
    let list: Vec<&'static str> = wanted.iter().map(leak).collect();
    let list: Names = Box::leak(list.into_boxed_slice());
    known.insert(wanted, list);
    list
}
