//! Harvest: the nodes of a trained Action SOM read as schemas (book, 5.3.1).

use super::action_som::ActionSom;
use super::item::ItemId;
use super::sample::ResultCoding;
use super::signed_items::SignedItems;
use crate::som::{NodeId, Prototypes};

/// Which weights become items of a schema.
///
/// ```
/// use cla_core::clasm::HarvestConfig;
/// assert_eq!(HarvestConfig::BOOK.on, 0.9);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HarvestConfig {
    /// Weights above this are positive items (book: .9).
    pub on: f32,
    /// Weights below this are negative items (book: .1).
    pub off: f32,
    /// Nodes that won less often are passed over; 0 reads every node, as the book does.
    pub minimum_wins: u16,
}

impl HarvestConfig {
    /// The book's thresholds, every node (5.3.1).
    pub const BOOK: Self = Self {
        on: 0.9,
        off: 0.1,
        minimum_wins: 0,
    };
    /// The book's thresholds, nodes that have won at least once.
    pub const FORAGER: Self = Self {
        on: 0.9,
        off: 0.1,
        minimum_wins: 1,
    };
}

/// What one node says.
///
/// ```
/// use cla_core::clasm::{HarvestedNode, SignedItems};
/// let node = HarvestedNode::<1> { context: SignedItems::EMPTY, result: SignedItems::EMPTY, wins: 3 };
/// assert_eq!(node.wins, 3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HarvestedNode<const WORDS: usize> {
    /// Items that are consistently on or off before the action.
    pub context: SignedItems<WORDS>,
    /// Items that are consistently on or off (or turned on or off) after it; never empty.
    pub result: SignedItems<WORDS>,
    /// How often the node was the best matching unit.
    pub wins: u16,
}

/// Reads one node; `None` when it has no result item or has won too rarely.
///
/// In end-state coding a result weight below `off` is a negative item; in change coding one below
/// `−on` is (the item has turned off).
#[must_use]
pub fn harvest_node<
    const WORDS: usize,
    const WIDTH: usize,
    const HEIGHT: usize,
    const ITEMS: usize,
    M: Prototypes<WIDTH, HEIGHT>,
    R: Prototypes<WIDTH, HEIGHT>,
>(
    map: &ActionSom<WIDTH, HEIGHT, ITEMS, M, R>,
    node: NodeId,
    coding: ResultCoding,
    config: &HarvestConfig,
) -> Option<HarvestedNode<WORDS>> {
    let wins = map.wins(node);
    if wins < config.minimum_wins {
        return None;
    }
    let mut context = SignedItems::EMPTY;
    let mut result = SignedItems::EMPTY;
    for item in 0..ITEMS as u16 {
        let before = map.context_weight(node, item);
        if before > config.on || before < config.off {
            context.insert(ItemId(item), before > config.on).ok()?;
        }
        let after = map.result_weight(node, item);
        let negative = match coding {
            ResultCoding::EndState => after < config.off,
            ResultCoding::Change => after < -config.on,
        };
        if after > config.on || negative {
            result.insert(ItemId(item), after > config.on).ok()?;
        }
    }
    (!result.is_empty()).then_some(HarvestedNode {
        context,
        result,
        wins,
    })
}

#[cfg(test)]
mod tests {
    use super::{HarvestConfig, harvest_node};
    use crate::clasm::{
        ActionId, ActionSomBank, ItemId, ItemStates, Recruitment, ResultCoding, Sample,
        TrainingConfig,
    };
    use crate::num::Rng;
    use crate::som::NodeId;

    /// A map of one node that holds exactly one sample: item 0 on → items 0 and 1 on, 2 unknown.
    fn one_node(coding: ResultCoding) -> ActionSomBank<1, 1, 3, 1> {
        let mut bank = ActionSomBank::new();
        bank.randomize(&mut Rng::new(8));
        let mut before = ItemStates::<1>::all_off(2);
        before.set(ItemId(0), Some(true)).unwrap();
        let mut after = before;
        after.set(ItemId(1), Some(true)).unwrap();
        let mut config = TrainingConfig::FORAGER;
        config.recruitment = Some(Recruitment {
            vigilance: 0.0,
            after: 0,
        });
        bank.train(
            ActionId(0),
            &Sample::new(&before, &after, coding, 3),
            &config,
        );
        bank
    }

    #[test]
    fn end_states_and_changes_read_differently() {
        let read = |coding| {
            let bank = one_node(coding);
            harvest_node::<1, 1, 1, 3, _, _>(
                &bank.maps()[0],
                NodeId(0),
                coding,
                &HarvestConfig::BOOK,
            )
            .unwrap()
        };
        let end = read(ResultCoding::EndState);
        assert_eq!(end.result.positive().iter().count(), 2);
        let change = read(ResultCoding::Change);
        assert_eq!(
            change
                .result
                .positive()
                .iter()
                .map(|i| i.0)
                .collect::<std::vec::Vec<_>>(),
            [1]
        );
        assert!(change.result.negative().is_empty());
        for node in [end, change] {
            assert!(node.context.positive().contains(ItemId(0)));
            assert!(node.context.negative().contains(ItemId(1)));
            assert!(
                !node.context.positive().contains(ItemId(2)),
                "an unknown item was never seen"
            );
        }
    }

    #[test]
    fn a_node_that_never_won_is_passed_over_on_request() {
        let mut bank = ActionSomBank::<2, 2, 3, 1>::new();
        bank.randomize(&mut Rng::new(8));
        let node = harvest_node::<1, 2, 2, 3, _, _>(
            &bank.maps()[0],
            NodeId(0),
            ResultCoding::EndState,
            &HarvestConfig::FORAGER,
        );
        assert_eq!(node, None);
    }
}
