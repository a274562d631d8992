//! Harvest into the tables: what all maps say now becomes the schemas (book, 5.3.1).
//!
//! The reading of one node is the map's; here it finds its row, or one makes room for it.

use super::tables::{KnowledgeBase, WhenFull};
use crate::map::{ActionSom, HarvestConfig, HarvestedNode, ResultCoding, harvest_node};
use crate::som::Prototypes;
use crate::word::ActionId;

impl<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>
    KnowledgeBase<WORDS, PATTERNS, SCHEMAS>
{
    /// Replaces the schemas by what the maps say now; those that were known keep their trials.
    ///
    /// Reads every node of every map once.
    /// A new schema starts from the wins of its nodes among those of its context and action.
    /// Schemas that no node says any more leave.
    pub fn harvest<
        const WIDTH: usize,
        const HEIGHT: usize,
        const ITEMS: usize,
        M: Prototypes<WIDTH, HEIGHT>,
    >(
        &mut self,
        maps: &[ActionSom<WIDTH, HEIGHT, ITEMS, M>],
        coding: ResultCoding,
        config: &HarvestConfig,
    ) {
        // What is still said is marked before anything is evicted for something new: only what no
        // node says any more makes room.
        let before = self.losses;
        if !self.support_all(maps, coding, config, WhenFull::Refuse) {
            self.losses = before;
            self.support_all(maps, coding, config, WhenFull::Evict);
        }
        self.start_new_records();
    }

    /// Supports the schemas of all nodes and drops what none says; whether everything found room.
    fn support_all<
        const WIDTH: usize,
        const HEIGHT: usize,
        const ITEMS: usize,
        M: Prototypes<WIDTH, HEIGHT>,
    >(
        &mut self,
        maps: &[ActionSom<WIDTH, HEIGHT, ITEMS, M>],
        coding: ResultCoding,
        config: &HarvestConfig,
        when_full: WhenFull,
    ) -> bool {
        for schema in &mut self.schemas {
            schema.support = 0;
        }
        self.least_standing = 0;
        let mut complete = true;
        for (action, map) in maps.iter().enumerate() {
            let action = ActionId(action as u16);
            for node in map.nodes() {
                let Some(node) = harvest_node(map, node, coding, config) else {
                    continue;
                };
                let HarvestedNode {
                    context,
                    result,
                    wins,
                } = node;
                let found = self.support(&context, action, &result, wins.max(1), when_full);
                complete &= found.is_ok();
            }
        }
        self.schemas.retain(|schema| schema.support > 0);
        self.least_standing = 0;
        self.drop_unused_patterns();
        self.link();
        complete
    }
}
