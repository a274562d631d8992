//! What a mind knows, for another life, or a robot that has grown: its samples, what its habits hold
//! items to be worth, which items matter and how long they stay on, and the schemas of its reason.
//!
//! Trees grow anew from the samples; the rows of the habits and the model are found by hashes of whole
//! percepts, which a robot with other items has not, and are learned anew; imagined states, too.

use super::mind::Mind;
use super::moment::NO_ACTION;
use super::runs::Runs;
use super::sarsa::Sarsa;
use super::step::Said;
use super::trees::Forest;
use super::voices::Voices;
use crate::reason::Reasoning;
use crate::snapshot::{Knowing, Origin, Reader, Stored, Writer};

/// Which capacity is which, in the order of the profile.
const WORDS_AT: usize = 0;
const ITEMS_AT: usize = 1;
const ACTIONS_AT: usize = 2;
const REASON_AT: [usize; 3] = [8, 9, 10];

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
    const ROWS: usize,
    const STATES: usize,
    const LINKS: usize,
    R: Reasoning<WORDS, ITEMS, ACTIONS> + Stored,
> Knowing for Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS, R>
{
    const KNOWLEDGE: &'static [&'static str] = &["samples", "habits", "reason"];
    const ROBOT: [usize; 2] = [ITEMS_AT, ACTIONS_AT];

    fn store_knowledge(&self, number: usize, to: &mut Writer<'_>) {
        match number {
            0 => self.forest.carry(to),
            1 => {
                self.habits.carry(to);
                self.runs.store(to);
            }
            _ => self.reason.carry(to),
        }
    }

    fn take_knowledge(
        into: Option<&mut Self>,
        number: usize,
        origin: &Origin,
        from: &mut Reader<'_>,
    ) {
        let words = origin.capacity(WORDS_AT, usize::from(u16::MAX));
        let items = origin.capacity(ITEMS_AT, ITEMS);
        let actions = origin.capacity(ACTIONS_AT, ACTIONS);
        from.limits.actions = actions as u16;
        match number {
            0 => Forest::<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES>::take(
                into.map(|it| &mut it.forest),
                (words, items, actions),
                from,
            ),
            1 => {
                let (habits, runs) = into.map(|it| (&mut it.habits, &mut it.runs)).unzip();
                Sarsa::<WORDS, ITEMS, ACTIONS, ROWS>::take(habits, (items, actions), from);
                Runs::take(runs, items, from);
            }
            _ => {
                let (values, rng) = into.as_ref().map(|it| (it.values, it.rng.clone())).unzip();
                let reason = into.map(|it| &mut it.reason);
                let capacities = REASON_AT.map(|at| origin.capacity(at, usize::from(u16::MAX)));
                let reason = match (reason, values, rng) {
                    (Some(reason), Some(values), Some(mut rng)) => {
                        reason.begin(values, rng.next_seed());
                        Some(reason)
                    }
                    _ => None,
                };
                R::take(reason, capacities, (words, actions), from);
            }
        }
    }

    fn settle_knowledge(&mut self) {
        self.model.clear();
        self.did = NO_ACTION;
        self.last = NO_ACTION;
        self.chosen = NO_ACTION;
        self.voices = Voices::new();
        self.said = Said::NOTHING;
        self.begin_health();
    }
}
