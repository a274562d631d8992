//! Labels in hindsight: how often a synthetic item was on after a place, by the action done there.
//!
//! A place is a node of a level-2 map or a level-2 schema harvested from such nodes; both keep the
//! same counters, so a harvest only adds them up.
//! How often an item was *known* is how often its schema's action was done there: one number for
//! all items of an action, or their shares could exceed 1.

use crate::knowledge::SyntheticId;
use crate::num::ordered::{insert, remove};
use crate::word::ActionId;

/// `item` was on `on` times when `action` was done at `place`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Label {
    pub(crate) place: u16,
    pub(crate) action: ActionId,
    pub(crate) item: SyntheticId,
    pub(crate) on: f32,
}

/// Up to `LABELS` counters, in ascending order of (place, action, item).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Labels<const LABELS: usize> {
    all: heapless::Vec<Label, LABELS, u16>,
    /// Counters with the lowest count that made room for new ones.
    pub(crate) evicted: u32,
}

impl<const LABELS: usize> Labels<LABELS> {
    pub(crate) const fn new() -> Self {
        const {
            assert!(
                LABELS > 0 && LABELS < u16::MAX as usize,
                "1 to 65,534 labels"
            );
        }
        Self {
            all: heapless::Vec::new(),
            evicted: 0,
        }
    }

    pub(crate) fn clear(&mut self) {
        self.all.clear();
    }

    /// The counters of an action done at a place.
    pub(crate) fn after(&self, place: u16, action: ActionId) -> &[Label] {
        let key = |label: &Label| (label.place, label.action);
        let from = self.all.partition_point(|it| key(it) < (place, action));
        let to = self.all.partition_point(|it| key(it) <= (place, action));
        self.all.get(from..to).unwrap_or(&[])
    }

    /// All counters of a place.
    pub(crate) fn of(&self, place: u16) -> &[Label] {
        let from = self.all.partition_point(|it| it.place < place);
        let to = self.all.partition_point(|it| it.place <= place);
        self.all.get(from..to).unwrap_or(&[])
    }

    /// Of the items of an action, the one that was on most often; of equals the first.
    pub(crate) fn most(&self, place: u16, action: ActionId) -> Option<SyntheticId> {
        let mut best: Option<&Label> = None;
        for label in self.after(place, action) {
            if best.is_none_or(|other| label.on > other.on) {
                best = Some(label);
            }
        }
        best.map(|label| label.item)
    }

    /// Labels the items of `action` at `place`: `item` was on, the others were off.
    ///
    /// `tried` is how often the action was done there.
    /// With `forgetting` above 0 at most 1 / `forgetting` labels count, the newest most.
    pub(crate) fn record(
        &mut self,
        place: u16,
        action: ActionId,
        item: SyntheticId,
        tried: &mut f32,
        forgetting: f32,
    ) {
        if *tried * forgetting >= 1.0 {
            *tried *= 1.0 - forgetting;
            self.weaken(place, action, 1.0 - forgetting);
        }
        *tried += 1.0;
        self.add(place, action, item, 1.0);
    }

    /// Lets the counters of an action done at a place count for `share` of what they did.
    pub(crate) fn weaken(&mut self, place: u16, action: ActionId, share: f32) {
        let key = |label: &Label| (label.place, label.action);
        let from = self.all.partition_point(|it| key(it) < (place, action));
        for label in self.all.iter_mut().skip(from) {
            if key(label) != (place, action) {
                return;
            }
            label.on *= share;
        }
    }

    /// Adds `on` to a counter; a full table drops the one with the lowest count.
    pub(crate) fn add(&mut self, place: u16, action: ActionId, item: SyntheticId, on: f32) {
        let key = |label: &Label| (label.place, label.action, label.item);
        let new = Label {
            place,
            action,
            item,
            on,
        };
        match self.all.binary_search_by_key(&key(&new), key) {
            Ok(index) => {
                if let Some(label) = self.all.get_mut(index) {
                    label.on += on;
                }
            }
            Err(index) if insert(&mut self.all, index, new) => {}
            Err(_) => {
                self.drop_weakest();
                let index = self.all.partition_point(|it| key(it) < key(&new));
                // There is room now.
                let _ = insert(&mut self.all, index, new);
            }
        }
    }

    /// Forgets all that was counted at a place.
    pub(crate) fn forget(&mut self, place: u16) {
        self.all.retain(|label| label.place != place);
    }

    fn drop_weakest(&mut self) {
        let mut least: Option<(f32, usize)> = None;
        for (index, label) in self.all.iter().enumerate() {
            if least.is_none_or(|(other, _)| label.on < other) {
                least = Some((label.on, index));
            }
        }
        if let Some((_, index)) = least {
            remove(&mut self.all, index);
            self.evicted = self.evicted.saturating_add(1);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{ActionId, Labels, SyntheticId};

    const GO: ActionId = ActionId(0);
    const STAY: ActionId = ActionId(1);

    #[test]
    fn counters_are_kept_by_place_and_action() {
        let mut it = Labels::<8>::new();
        let mut tried = 0.0;
        for item in [4, 2, 4] {
            it.record(7, GO, SyntheticId(item), &mut tried, 0.0);
        }
        it.record(7, STAY, SyntheticId(9), &mut 0.0, 0.0);
        it.record(3, GO, SyntheticId(2), &mut 0.0, 0.0);
        let after: std::vec::Vec<_> = it.after(7, GO).iter().map(|l| (l.item.0, l.on)).collect();
        assert_eq!((tried, after), (3.0, std::vec![(2, 1.0), (4, 2.0)]));
        assert_eq!(it.most(7, GO), Some(SyntheticId(4)));
        assert_eq!(it.of(7).len(), 3);
        it.forget(7);
        assert_eq!((it.of(7).len(), it.of(3).len()), (0, 1));
    }

    #[test]
    fn at_most_one_over_forgetting_labels_count_and_shares_stay_shares() {
        let mut it = Labels::<8>::new();
        let mut tried = 0.0;
        for turn in 0..200_u16 {
            it.record(0, GO, SyntheticId(turn / 150), &mut tried, 0.1);
        }
        assert!((tried - 10.0).abs() < 0.01, "{tried}");
        let [old, new] = it.after(0, GO) else {
            panic!("two items")
        };
        assert!((old.on + new.on - tried).abs() < 1e-3);
        assert!(old.on < 0.1);
    }

    #[test]
    fn a_full_table_drops_the_least_evidence_and_says_so() {
        let mut it = Labels::<2>::new();
        it.add(0, GO, SyntheticId(0), 3.0);
        it.add(0, GO, SyntheticId(1), 1.0);
        it.add(1, GO, SyntheticId(0), 2.0);
        assert_eq!((it.of(0).len() + it.of(1).len(), it.evicted), (2, 1));
        assert_eq!(it.most(0, GO), Some(SyntheticId(0)));
        assert_eq!(it.most(1, GO), Some(SyntheticId(0)));
    }
}
