//! Hindsight: a sample waits one action, so that what the next one reveals labels its end (book,
//! 5.3.1 and 6.2.6; after Drescher 1991).
//!
//! Read literally, a synthetic item is on only right after its own schema succeeded, so it can never
//! stand in the result of another action; with hindsight it can.
//! What stands before the action is what was known then; only the end is labelled afterwards, so
//! nothing of the future leaks into a context.

use super::synthetic::SyntheticItems;
use crate::growth::evidence::Evidence;
use crate::word::{ItemId, ItemSet, ItemStates};

/// One completed action with what was known before it, and its end as far as it is known so far.
///
/// ```
/// use cla_core::growth::{Evidence, HindsightSample, SyntheticItems};
/// use cla_core::word::{ActionId, ItemStates, SchemaText, Vocabulary};
/// let words = Vocabulary { items: &["door", "open"], actions: &["walk", "push"] };
/// let mut items = SyntheticItems::<1, 4>::new(2);
/// let openable = items.reify(&SchemaText::parse("+door/push/+open", &words)?).unwrap();
/// let state = |on: &[&str]| {
///     let mut states = ItemStates::all_off(2);
///     on.iter().for_each(|name| states.set(words.item(name).unwrap(), Some(true)).unwrap());
///     states
/// };
/// // It walked to the door; whether that can be opened nobody knows yet.
/// let mut walked = HindsightSample::waiting(&items.view(&state(&[])), &state(&["door"]), &items);
/// assert_eq!(walked.outcome(openable), None);
/// // It pushes, and the door opens: so it could be opened at the end of the walk.
/// walked.label(&items.revealed(&state(&["door"]), ActionId(1), &state(&["door", "open"])));
/// assert_eq!(walked.outcome(openable), Some(true));
/// # Ok::<(), cla_core::word::NotationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HindsightSample<const WORDS: usize> {
    before: ItemStates<WORDS>,
    after: ItemStates<WORDS>,
    /// Items that the next action revealed.
    revealed: ItemSet<WORDS>,
}

impl<const WORDS: usize> HindsightSample<WORDS> {
    /// An action that led from what was known `before` (see [`SyntheticItems::view`]) to what is
    /// `sensed` now; synthetic items are unknown at its end, except those that are off for certain.
    #[must_use]
    pub fn waiting<const ITEMS: usize>(
        before: &ItemStates<WORDS>,
        sensed: &ItemStates<WORDS>,
        items: &SyntheticItems<WORDS, ITEMS>,
    ) -> Self {
        let off = sensed.off().union(&items.ruled_out(sensed));
        Self {
            before: *before,
            after: ItemStates::from_sets(sensed.on(), &off),
            revealed: ItemSet::EMPTY,
        }
    }

    /// Adds what the next action revealed about the end.
    pub fn label(&mut self, revealed: &ItemStates<WORDS>) {
        let off = self.after.off().union(revealed.off());
        let off = off.difference(revealed.on());
        self.after = ItemStates::from_sets(&self.after.on().union(revealed.on()), &off);
        self.revealed = self.revealed.union(&revealed.known());
    }

    /// What was known before the action.
    #[must_use]
    pub const fn before(&self) -> &ItemStates<WORDS> {
        &self.before
    }

    /// The items that the next action revealed.
    #[must_use]
    pub const fn revealed(&self) -> &ItemSet<WORDS> {
        &self.revealed
    }
}

impl<const WORDS: usize> Evidence<WORDS> for HindsightSample<WORDS> {
    const CHANGES: bool = false;

    fn on_before(&self) -> ItemSet<WORDS> {
        *self.before.on()
    }

    fn off_before(&self) -> ItemSet<WORDS> {
        *self.before.off()
    }

    fn outcome(&self, item: ItemId) -> Option<bool> {
        self.after.get(item)
    }

    /// What was revealed to be on, and what was revealed to be off though it was known to be on.
    fn telling(&self) -> ItemSet<WORDS> {
        let went = self.after.off().intersection(self.before.on());
        let on = self.after.on().union(&went);
        on.intersection(&self.revealed)
    }

    fn renewed(&self, newer: &Self) -> Self {
        let mut both = *self;
        both.label(&newer.after);
        both.revealed = self.revealed.union(&newer.revealed);
        both
    }
}

#[cfg(test)]
mod tests {
    use super::HindsightSample;
    use crate::growth::{
        Accommodation, AccommodationConfig, Evidence, SimpleSchema, SyntheticItems,
    };
    use crate::num::Rng;
    use crate::word::{ActionId, ItemId, ItemStates, SchemaText, Vocabulary};

    /// A switch lights a lamp in one room; whether there is current nobody sees.
    const WORDS: Vocabulary = Vocabulary {
        items: &["room", "lit", "current"],
        actions: &["flip", "plug", "pull", "wait"],
    };
    const CURRENT: ItemId = ItemId(2);

    type Items = SyntheticItems<1, 1>;

    fn sensed(lit: bool) -> ItemStates<1> {
        let mut states = ItemStates::all_off(2);
        states.set(ItemId(0), Some(true)).unwrap();
        states.set(ItemId(1), Some(lit)).unwrap();
        states
    }

    fn items() -> Items {
        let mut items = Items::new(2);
        let schema = SchemaText::parse("+room/flip/+lit", &WORDS).unwrap();
        assert_eq!(items.reify(&schema), Ok(CURRENT));
        items
    }

    /// What was known before each action, and the labelled samples.
    type Course = (
        std::vec::Vec<ItemStates<1>>,
        std::vec::Vec<(u16, HindsightSample<1>)>,
    );

    /// Lives a series of actions; `promises` are schemas about the current that it trusts.
    fn live(actions: &[u16], promises: &[&str]) -> Course {
        let trusted = promises.iter().map(|text| {
            let text = SchemaText::<1>::parse(text, &WORDS).unwrap();
            let mut schema = SimpleSchema::pack(&text).unwrap();
            schema.record(true);
            schema
        });
        let trusted: std::vec::Vec<SimpleSchema> = trusted.collect();
        let mut items = items();
        let (mut current, mut now) = (false, sensed(false));
        let (mut known, mut samples) = Course::default();
        let mut waiting: Option<(u16, HindsightSample<1>)> = None;
        for &action in actions {
            let before = items.view(&now);
            known.push(before);
            match action {
                1 => current = true,
                2 => current = false,
                _ => {}
            }
            let after = sensed(action == 0 && current);
            let id = ActionId(action);
            if let Some((earlier, mut sample)) = waiting.take() {
                sample.label(&items.revealed(&before, id, &after));
                samples.push((earlier, sample));
            }
            let sample = HindsightSample::waiting(&before, &after, &items);
            waiting = Some((action, sample));
            items.complete(&before, id, &after);
            items.expect(&sample, id, &trusted, 0.9, 1);
            now = after;
        }
        (known, samples)
    }

    fn random_actions(seed: u64, count: usize) -> std::vec::Vec<u16> {
        let mut rng = Rng::new(seed);
        (0..count).map(|_| rng.below(4) as u16).collect()
    }

    #[test]
    fn nothing_that_happens_later_changes_what_was_known() {
        let actions = random_actions(1, 200);
        let (known, samples) = live(&actions, &["/plug/+current"]);
        for moment in [1, 17, 60, 150, 199] {
            let mut other = actions[..moment].to_vec();
            other.extend(random_actions(2, 200 - moment));
            assert_ne!(other, actions);
            let (known_then, samples_then) = live(&other, &["/plug/+current"]);
            assert_eq!(known_then[..=moment], known[..=moment]);
            for (one, two) in samples.iter().zip(&samples_then).take(moment) {
                assert_eq!(
                    one.1.before(),
                    two.1.before(),
                    "contexts do not know the future"
                );
            }
        }
        // The labels do, and that is the point: plugging ends in current when the next flip says so.
        let labels = samples.iter().filter(|it| it.1.outcome(CURRENT).is_some());
        assert!(labels.count() > 20);
    }

    #[test]
    fn with_hindsight_another_action_gets_the_item_into_its_result() {
        let promises = ["/plug/+current", "/pull/-current"];
        let (_, samples) = live(&random_actions(3, 2000), &promises);
        let mut brain = Accommodation::<1, 32, 32, 4, HindsightSample<1>>::new();
        let mut rng = Rng::new(4);
        for (action, sample) in &samples {
            brain.observe(
                ActionId(*action),
                sample,
                &AccommodationConfig::EXACT,
                &mut rng,
            );
        }
        let says = |action: u16, sign: bool| {
            brain.schemas().iter().any(|it| {
                it.action() == ActionId(action)
                    && it.result_item() == CURRENT
                    && it.result_sign() == sign
                    && it.context().count() == 0
                    && it.successes() == it.activations()
                    && it.activations() > 50
            })
        };
        assert!(
            says(1, true),
            "plugging in: there is current, whatever was before"
        );
        assert!(says(2, false), "pulling out: there is none");
        assert!(
            !says(3, true) && !says(3, false),
            "waiting says neither without a context"
        );
        let stays = brain.schemas().iter().find(|it| {
            it.action() == ActionId(3) && it.context().eq([(CURRENT, true)]) && it.result_sign()
        });
        assert!(
            stays.is_some_and(|it| it.activations() > 20),
            "waiting leaves it as it was"
        );
    }

    #[test]
    fn read_literally_no_other_action_ever_has_it() {
        // On only right after its own schema succeeded: the end of another action is never on.
        let items = items();
        let mut now = sensed(false);
        for action in random_actions(5, 500) {
            let before = items.view(&now);
            let after = sensed(action == 0);
            let literal = items.revealed(&before, ActionId(action), &after);
            assert_eq!(literal.on().contains(CURRENT), action == 0);
            now = after;
        }
    }

    #[test]
    fn later_labels_join_earlier_ones_of_the_same_context() {
        let items = items();
        let (before, after) = (items.view(&sensed(false)), sensed(false));
        let unlabelled = HindsightSample::waiting(&before, &after, &items);
        let mut labelled = unlabelled;
        labelled.label(&items.revealed(&after, ActionId(0), &sensed(true)));
        assert_eq!(labelled.outcome(CURRENT), Some(true));
        assert_eq!(labelled.renewed(&unlabelled).outcome(CURRENT), Some(true));
        assert_eq!(unlabelled.renewed(&labelled), labelled);
        assert!(labelled.began_as(&unlabelled));
    }
}
