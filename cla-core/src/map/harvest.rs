//! Harvest: the nodes of a trained Action SOM read as schemas (book, 5.3.1).

use super::action_som::ActionSom;
use super::sample::ResultCoding;
use crate::check::{Config, ConfigError, Range};
use crate::snapshot::stored;
use crate::som::{NodeId, Prototypes};
use crate::word::{ItemId, SignedItems};

/// Which weights become items of a schema.
///
/// ```
/// use cla_core::map::HarvestConfig;
/// assert_eq!(HarvestConfig::BOOK.on, 0.9);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
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

impl Config for HarvestConfig {
    fn check(&self) -> Result<(), ConfigError> {
        Range::SHARE.check("HarvestConfig::on", self.on)?;
        Range::below(self.on).check("HarvestConfig::off", self.off)
    }
}

/// What one node says.
///
/// ```
/// use cla_core::map::HarvestedNode;
/// use cla_core::word::SignedItems;
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

stored! { impl[] HarvestConfig { on, off, minimum_wins } }

#[cfg(test)]
#[path = "harvest_tests.rs"]
mod tests;
