//! Nodes of level-2 maps read as level-2 schemas, and percepts widened by a trace (5.3.1, 6.2.6).
//!
//! The helpers of `som_level`: nothing here remembers anything.

use super::config::SomLevelConfig;
use super::implication::Implications;
use crate::knowledge::SyntheticId;
use crate::map::{ActionSomBank, ResultCoding, harvest_node};
use crate::som::{BinarySom, Grid};
use crate::word::{ActionId, ItemId, ItemSet, ItemStates, SchemaText, SignedItems};

/// Maps whose context half has every feature and whose result half only the primitive items: of the
/// synthetic items after an action nodes keep counters instead of weights.
pub(crate) type Bank<
    const ITEMS: usize,
    const FEATURES: usize,
    const WIDTH: usize,
    const HEIGHT: usize,
    const ACTIONS: usize,
> = ActionSomBank<
    WIDTH,
    HEIGHT,
    FEATURES,
    ACTIONS,
    BinarySom<WIDTH, HEIGHT, FEATURES>,
    BinarySom<WIDTH, HEIGHT, ITEMS>,
>;

/// What one node says: a level-2 schema.
pub(crate) struct Said {
    pub(crate) host: SyntheticId,
    pub(crate) trace: Option<SyntheticId>,
    pub(crate) node: u16,
}

/// Reads every node that says something about an item's schema; how many others have won.
pub(crate) fn read<
    const WORDS: usize,
    const ITEMS: usize,
    const WIDE: usize,
    const FEATURES: usize,
    const WIDTH: usize,
    const HEIGHT: usize,
    const ACTIONS: usize,
    const ROWS: usize,
    const LABELS: usize,
>(
    bank: &Bank<ITEMS, FEATURES, WIDTH, HEIGHT, ACTIONS>,
    implied: &mut Implications<WORDS, FEATURES, ACTIONS, ROWS, LABELS>,
    config: &SomLevelConfig,
    mut found: impl FnMut(&mut Implications<WORDS, FEATURES, ACTIONS, ROWS, LABELS>, Said),
) -> u32 {
    let mut unread = 0;
    let nodes = Grid::<f32, WIDTH, HEIGHT>::NODES;
    for (action, map) in bank.maps().iter().enumerate() {
        for node in map.nodes() {
            let coding = ResultCoding::EndState;
            let Some(said) =
                harvest_node::<WIDE, _, _, _, _, _>(map, node, coding, &config.harvest)
            else {
                continue;
            };
            let text = SchemaText {
                context: primitive(&said.context, ITEMS as u16),
                action: ActionId(action as u16),
                result: primitive(&said.result, ITEMS as u16),
            };
            let Some(host) = implied.item_of(&text) else {
                unread += 1;
                continue;
            };
            let mut traces = said.context.positive().iter();
            let trace = traces.find(|item| usize::from(item.0) >= ITEMS);
            let said = Said {
                host,
                trace: trace.map(|item| SyntheticId(item.0 - ITEMS as u16)),
                node: (action * nodes) as u16 + node.0,
            };
            found(implied, said);
        }
    }
    unread
}

/// The states of the first `items` items among more of them; the others are unknown.
pub(crate) fn widened<const WORDS: usize, const WIDE: usize>(
    states: &ItemStates<WORDS>,
    items: u16,
) -> Option<ItemStates<WIDE>> {
    let mut wide = ItemStates::UNKNOWN;
    for item in 0..items {
        wide.set(ItemId(item), states.get(ItemId(item))).ok()?;
    }
    Some(wide)
}

/// The part of a conjunction that is about the first `items` items.
fn primitive<const WIDE: usize, const WORDS: usize>(
    all: &SignedItems<WIDE>,
    items: u16,
) -> SignedItems<WORDS> {
    let mut part = SignedItems::EMPTY;
    let of = |set: &ItemSet<WIDE>, item: u16| set.contains(ItemId(item));
    for item in 0..items {
        let positive = of(all.positive(), item);
        if positive || of(all.negative(), item) {
            // The item fits: there are no more primitive items than bits.
            let _ = part.insert(ItemId(item), positive);
        }
    }
    part
}
