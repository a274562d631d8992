//! What keeps a brain: audits, seals, knowledge that moves; and a robot that speaks its own words.

use cla_core::forest::Filled;
use cla_core::snapshot::{
    Audit, LoadError, SaveError, Scrub, SinkFull, SliceSink, SourceEnd, TooManyChunks,
};
use cla_core::snapshot::{load_knowledge, save_knowledge};

use cla_core::forager::pioneer::{Brain as Agent6, VOCABULARY};
use cla_core::forest;
use cla_core::word::{Health, ItemId};

type Forest = forest::Mind<1, 7, 6, 448, 200, 512, 512, 2048>;

cla_core::brain! {
    /// A robot with everything that a description can have.
    #[allow(unreachable_pub, dead_code, missing_docs)]
    pub mod crab {
        items: [left_rock, right_rock, food, heron],
        actions: [left, right, hide],
        values: [food = 1.0, heron = -3.0],
        safe: hide,
        samples: 64,
        imagines: 32,
        ram: 40_000,
    }
}

pub(super) fn audit_in_parts(brain: &mut Agent6, mind: &mut Forest, part: usize) -> Audit {
    brain.audit_part(part).and(mind.audit_part(part))
}

pub(super) fn sealed(
    brain: &mut Agent6,
    scrub: &mut Scrub<256>,
) -> Result<Option<Audit>, TooManyChunks> {
    let found = scrub.check(brain);
    scrub.seal(brain)?;
    Ok(found)
}

pub(super) fn known(
    brain: &Agent6,
    mind: &Forest,
    to: &mut SliceSink<'_>,
) -> Result<u32, SaveError<SinkFull>> {
    let words = VOCABULARY.names();
    Ok(save_knowledge(brain, words, to)? + save_knowledge(mind, words, to)?)
}

pub(super) fn taken(
    brain: &mut Agent6,
    mind: &mut Forest,
    from: &mut &[u8],
) -> Result<u32, LoadError<SourceEnd>> {
    let (items, actions) = (VOCABULARY.items, VOCABULARY.actions);
    let first = load_knowledge(brain, items, actions, from)?;
    Ok(first + load_knowledge(mind, items, actions, from)?)
}

pub(super) fn asked(mind: &Forest, item: ItemId) -> (Filled, [f32; 6], bool) {
    (mind.filled(), mind.habit(item), mind.acts())
}

pub(super) fn well(brain: &Agent6, mind: &Forest) -> [Health; 2] {
    [brain.health(), mind.health()]
}

pub(super) fn in_words(brain: &mut crab::Brain, now: &crab::Percept) -> Option<crab::Action> {
    let action = brain.choose_or_safe(now);
    let among = brain.choose_among(now, &[crab::Action::left]).ok()?;
    brain.learn_with(now, among.value).ok()?;
    brain.observe(now, action, now).ok()?;
    brain
        .pursue(&[crab::Item::food], &[crab::Item::heron], 20, now)
        .ok()?;
    let _ = brain.way(now);
    brain.revalue(crab::Item::food, among.value).ok()?;
    brain.choose(now).ok().map(|choice| choice.action)
}
