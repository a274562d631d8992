//! What an agent knows, without its maps: for another life, or a robot that has grown.
//!
//! Schemas with their trials, values, synthetic items with their beliefs, and habits.
//! Maps are not carried: each schema is imprinted on a node of the map of its action, so that a harvest
//! finds it again.

use super::config::Settings;
use super::life::Agent;
use crate::choice::Habits;
use crate::knowledge::KnowledgeBase;
use crate::level2::SecondLevel;
use crate::map::Sample;
use crate::snapshot::{Knowing, Origin, Reader, Stored, Writer};
use crate::som::Prototypes;

/// Which capacity is which, in the order of the profile.
const WORDS_AT: usize = 0;
const ITEMS_AT: usize = 1;
const SIDES_AT: [usize; 2] = [2, 3];
const ACTIONS_AT: usize = 4;

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const WIDTH: usize,
    const HEIGHT: usize,
    const ACTIONS: usize,
    const PATTERNS: usize,
    const SCHEMAS: usize,
    const SYNTHETIC: usize,
    const BELIEFS: usize,
    M: Prototypes<WIDTH, HEIGHT> + Stored,
> Knowing
    for Agent<WORDS, ITEMS, WIDTH, HEIGHT, ACTIONS, PATTERNS, SCHEMAS, SYNTHETIC, BELIEFS, M>
{
    const KNOWLEDGE: &'static [&'static str] = &["knowledge", "second level", "habits"];
    const ROBOT: [usize; 2] = [ITEMS_AT, ACTIONS_AT];

    fn store_knowledge(&self, number: usize, to: &mut Writer<'_>) {
        match number {
            0 => self.faculties.knowledge.carry(ITEMS, to),
            1 => self.faculties.level2.carry(to),
            _ => self
                .faculties
                .habits
                .carry(self.faculties.level2.rows(), to),
        }
    }

    fn take_knowledge(
        into: Option<&mut Self>,
        number: usize,
        origin: &Origin,
        from: &mut Reader<'_>,
    ) {
        let faculties = into.map(|it| &mut it.faculties);
        let words = origin.capacity(WORDS_AT, usize::from(u16::MAX));
        let items = origin.capacity(ITEMS_AT, ITEMS);
        let actions = origin.capacity(ACTIONS_AT, ACTIONS);
        from.limits.actions = actions as u16;
        match number {
            0 => {
                // What its own maps had no node for, as in a doubt, would have left there, too.
                let sides = SIDES_AT.map(|at| origin.capacity(at, usize::from(u16::MAX)));
                let [columns, rows] = sides;
                let nodes = if columns * rows > WIDTH * HEIGHT {
                    WIDTH * HEIGHT
                } else {
                    SCHEMAS
                };
                KnowledgeBase::<WORDS, PATTERNS, SCHEMAS>::take::<ACTIONS>(
                    faculties.map(|it| &mut it.knowledge),
                    (words, items),
                    nodes,
                    from,
                );
            }
            1 => SecondLevel::<ACTIONS, SYNTHETIC, BELIEFS>::take(
                faculties.map(|it| &mut it.level2),
                actions,
                from,
            ),
            _ => Habits::<WORDS, ITEMS, ACTIONS, SYNTHETIC>::take(
                faculties.map(|it| &mut it.habits),
                (items, actions),
                from,
            ),
        }
    }

    fn settle_knowledge(&mut self) {
        self.faculties.knowledge.rebuild();
        self.faculties.level2.rebuild();
        self.faculties.trail.leave();
        self.chosen = None;
        self.decided_after = None;
        self.since_harvest = 0;
        self.begin_health();
        let Settings::Present(config) = &self.config else {
            return;
        };
        self.bank.randomize(&mut self.rng);
        let knowledge = &self.faculties.knowledge;
        for schema in knowledge.schemas() {
            let context = knowledge.pattern(schema.context);
            let result = knowledge.pattern(schema.result);
            let map = self.bank.maps.get_mut(usize::from(schema.action.0));
            if let (Some(context), Some(result), Some(map)) = (context, result, map) {
                let sample = Sample::of_schema(&context, &result, config.coding, ITEMS as u16);
                map.imprint(&sample, schema.support);
            }
        }
    }
}
