//! What the experiment with aliased worlds varies.

use serde::Serialize;

use super::places::Place;
use crate::failure::Impossible;

/// What is varied.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AliasedOptions {
    /// The seeds.
    pub seeds: Vec<u64>,
    /// Where one lives, in the order of [`Place::ALL`], each once.
    pub places: Vec<Place>,
    /// By what all lives are shorter than the claims ask; at least 1.
    pub shorter: u32,
}

impl AliasedOptions {
    /// All worlds at the lengths that the claims ask for.
    #[must_use]
    pub fn standard(seeds: Vec<u64>) -> Self {
        Self {
            seeds,
            places: Place::ALL.to_vec(),
            shorter: 1,
        }
    }

    /// Worlds by their names, all where none is named.
    ///
    /// # Errors
    /// [`Impossible`] for a name that is none.
    ///
    /// ```
    /// use host_sim::experiment::aliased::{AliasedOptions, Place};
    /// let options = AliasedOptions::new(vec![1], &["cheese".into(), "shuttle".into()])?;
    /// assert_eq!(options.places, [Place::Shuttle, Place::Cheese]);
    /// assert!(AliasedOptions::new(vec![1], &["moon".into()]).is_err());
    /// # Ok::<(), host_sim::failure::Impossible>(())
    /// ```
    pub fn new(seeds: Vec<u64>, names: &[String]) -> Result<Self, Impossible> {
        for name in names {
            if Place::ALL.iter().all(|place| place.name() != name) {
                let known = Place::ALL.map(Place::name).join(", ");
                let sentence = format!("--worlds: there is no {name:?}; there are {known}");
                return Err(Impossible::new(sentence));
            }
        }
        let asked = |it: &Place| names.is_empty() || names.iter().any(|name| it.name() == name);
        Ok(Self {
            places: Place::ALL.into_iter().filter(asked).collect(),
            ..Self::standard(seeds)
        })
    }

    /// A length of the claims, as it is lived here.
    pub(super) fn length(&self, actions: u32) -> u32 {
        (actions / self.shorter.max(1)).max(1)
    }
}
