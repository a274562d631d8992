//! A schema as it is stored: context / action / result by reference, and its trials (book, 5.1.1).

use super::reliability::Reliability;
use crate::snapshot::{stored, stored_as};
use crate::word::ActionId;

/// The index of a conjunction in a knowledge base.
///
/// ```
/// use cla_core::knowledge::PatternId;
/// assert!(PatternId(0) < PatternId(1));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PatternId(pub u16);

/// The index of a schema in a knowledge base; valid until the next harvest.
///
/// ```
/// use cla_core::knowledge::SchemaId;
/// assert!(SchemaId(0) < SchemaId(1));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SchemaId(pub u16);

/// The index of a synthetic item.
///
/// ```
/// use cla_core::knowledge::SyntheticId;
/// assert!(SyntheticId(0) < SyntheticId(1));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SyntheticId(pub u16);

/// A prediction: if the context holds and the action is done, the result is expected.
///
/// In the field: a probabilistic rule of a factored transition model, a STRIPS operator with a rate.
///
/// Contexts and results repeat, so each is stored once and named by its [`PatternId`].
///
/// ```
/// assert_eq!(core::mem::size_of::<cla_core::knowledge::Schema>(), 32);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schema {
    /// What must hold before.
    pub context: PatternId,
    /// What is done.
    pub action: ActionId,
    /// What is expected afterwards.
    pub result: PatternId,
    /// How often nodes of the last harvest that say this had won; 0 when none says it any more.
    pub support: u16,
    /// The synthetic item that stands for it at level 2, or [`NONE`].
    item: u16,
    /// How many schemas lie between it and the next one of the same context, or [`NONE`] (see
    /// `applicable`): whatever stands here, a chain leads onwards and ends.
    pub(crate) skip: u16,
    /// Its trials.
    pub reliability: Reliability,
    /// What it keeps while an agent doubts what it knows.
    pub doubt: Doubt,
}

/// What a schema keeps while its context and action are doubted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Doubt {
    /// Its reliability when the doubt began, in 65,535ths.
    pub(crate) old: u16,
    /// Successes since.
    pub(crate) hits: u16,
    /// What its context and action may be worth beyond what is known; 0 when nothing is doubted.
    pub(crate) bonus: f32,
}

/// No item, or no schema.
pub(crate) const NONE: u16 = u16::MAX;

impl Schema {
    /// A schema without trials of its own, said by nodes that have won `support` times.
    pub(crate) fn new(
        context: PatternId,
        action: ActionId,
        result: PatternId,
        support: u16,
    ) -> Self {
        Self {
            context,
            action,
            result,
            support,
            item: NONE,
            skip: NONE,
            reliability: Reliability::default(),
            doubt: Doubt::default(),
        }
    }

    /// The synthetic item that stands for it at level 2, if it has one.
    #[must_use]
    pub const fn synthetic(&self) -> Option<SyntheticId> {
        match self.item {
            NONE => None,
            item => Some(SyntheticId(item)),
        }
    }

    pub(crate) fn set_synthetic(&mut self, item: Option<SyntheticId>) {
        self.item = item.map_or(NONE, |item| item.0);
    }
}

stored_as!(impl[] PatternId, below patterns);
stored_as!(impl[] SchemaId, below schemas);
stored_as!(impl[] SyntheticId, below synthetic);

// Which schema is the next of its context is found again.
stored! {
    impl[] Schema { context, action, result, support, item, reliability, doubt; skip: NONE }
    counted schemas
}

stored! {
    impl[] Doubt { old, hits, bonus }
    sound |it, _limits| it.bonus >= 0.0
}
