//! Which schemas apply: found by their contexts, without a look at the others.
//!
//! Every conjunction knows the first schema of which it is the context, and every schema how far it is
//! to the next one of the same context, in ascending order: a link that was damaged leads onwards, too.
//! What applies in a state is the union of the chains of the contexts that hold, merged in the order
//! of the table: sums over it have the bits of a walk over the whole table.

use super::schema::NONE;
use super::tables::KnowledgeBase;
use crate::word::ItemStates;

/// Contexts that may hold at once before the whole table is walked instead; bounds the stack.
const CHAINS: usize = 8;

/// The schemas that apply in a state, in the order of the table.
pub(crate) struct Applicable<'a, const WORDS: usize> {
    /// The next schema; it and `several` stay in registers because the chains lie elsewhere.
    next: usize,
    /// Whether more than one context holds.
    several: bool,
    /// Schemas answered so far.
    seen: u32,
    others: &'a mut Others<WORDS>,
}

/// What has to be looked at beside one chain.
pub(crate) enum Others<const WORDS: usize> {
    /// The next schema of each other context that holds.
    Chains(heapless::Vec<u16, CHAINS, u16>),
    /// There are too many: the whole table.
    All(ItemStates<WORDS>),
}

impl<const WORDS: usize> Applicable<'_, WORDS> {
    /// The index of the next schema; a schema that has been answered may be changed, but no schema
    /// added or moved.
    #[inline(always)]
    pub(crate) fn next<const PATTERNS: usize, const SCHEMAS: usize>(
        &mut self,
        knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
    ) -> Option<usize> {
        let index = self.next;
        self.next = index + 1 + usize::from(knowledge.schemas.get(index)?.skip);
        if self.several {
            self.next = self.others.next(knowledge, index, self.next);
        }
        self.seen += 1;
        Some(index)
    }

    /// How many schemas were answered.
    pub(crate) const fn seen(&self) -> usize {
        self.seen as usize
    }
}

impl<const WORDS: usize> Others<WORDS> {
    pub(crate) const fn none() -> Self {
        Self::Chains(heapless::Vec::new())
    }

    /// What follows the schema at `index`, whose own chain goes on at `next`.
    #[inline(never)]
    fn next<const PATTERNS: usize, const SCHEMAS: usize>(
        &mut self,
        knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        index: usize,
        next: usize,
    ) -> usize {
        match self {
            Self::Chains(heads) => {
                let mut least = next.min(usize::from(NONE)) as u16;
                for head in heads {
                    if *head < least {
                        core::mem::swap(head, &mut least);
                    }
                }
                usize::from(least)
            }
            Self::All(state) => usize::from(knowledge.next_applicable(index + 1, state)),
        }
    }
}

impl<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>
    KnowledgeBase<WORDS, PATTERNS, SCHEMAS>
{
    /// The schemas whose context holds in `state`; `others` is work memory.
    #[inline(always)]
    pub(crate) fn applicable<'a>(
        &mut self,
        state: &ItemStates<WORDS>,
        others: &'a mut Others<WORDS>,
    ) -> Applicable<'a, WORDS> {
        self.count_look();
        let (next, several) = self.first_applicable(state, others);
        Applicable {
            next: usize::from(next),
            several,
            seen: 0,
            others,
        }
    }

    /// The first schema that applies, and whether `others` has to be looked at for the next ones.
    #[inline(never)]
    fn first_applicable(
        &self,
        state: &ItemStates<WORDS>,
        others: &mut Others<WORDS>,
    ) -> (u16, bool) {
        let mut least = NONE;
        let mut chains = heapless::Vec::new();
        for pattern in &self.patterns {
            if pattern.first == NONE || !pattern.items.holds_in(state) {
                continue;
            }
            let other = least.max(pattern.first);
            least = least.min(pattern.first);
            if other != NONE && chains.push(other).is_err() {
                *others = Others::All(*state);
                return (self.next_applicable(0, state), true);
            }
        }
        let several = !chains.is_empty();
        if several {
            *others = Others::Chains(chains);
        }
        (least, several)
    }

    /// The first schema from `index` on whose context holds.
    fn next_applicable(&self, index: usize, state: &ItemStates<WORDS>) -> u16 {
        let rest = self.schemas.iter().enumerate().skip(index);
        for (index, schema) in rest {
            let context = self.patterns.get(usize::from(schema.context.0));
            if context.is_some_and(|context| context.items.holds_in(state)) {
                return index as u16;
            }
        }
        NONE
    }
}

#[cfg(test)]
mod tests {
    use super::{CHAINS, KnowledgeBase, Others};
    use crate::num::Rng;
    use crate::word::{ActionId, ItemId, ItemStates, SchemaText, SignedItems};

    fn some(rng: &mut Rng, items: u32) -> SignedItems<1> {
        let mut some = SignedItems::EMPTY;
        for _ in 0..items {
            let item = ItemId(rng.below(6) as u16);
            some.insert(item, rng.chance(0.5)).unwrap();
        }
        some
    }

    #[test]
    fn the_chains_merge_to_what_a_walk_over_the_whole_table_finds() {
        let mut rng = Rng::new(1);
        let (mut few, mut many) = (0, 0);
        for _ in 0..40 {
            let mut knowledge = KnowledgeBase::<1, 64, 128>::new();
            let most = 1 + rng.below(3);
            for _ in 0..200 {
                let length = 1 + rng.below(most);
                let text = SchemaText {
                    context: some(&mut rng, length),
                    action: ActionId(rng.below(3) as u16),
                    result: some(&mut rng, 1),
                };
                // A full table evicts, and that moves conjunctions.
                let _ = knowledge.insert(&text, 1 + rng.below(9), 9);
            }
            let mut state = ItemStates::all_off(6);
            for item in 0..6 {
                let known = rng.chance(0.9).then(|| rng.chance(0.5));
                state.set(ItemId(item), known).unwrap();
            }
            let mut found = std::vec::Vec::new();
            let mut others = Others::none();
            let mut applicable = knowledge.applicable(&state, &mut others);
            while let Some(index) = applicable.next(&knowledge) {
                found.push(index);
            }
            let walked: std::vec::Vec<usize> = (0..knowledge.schemas.len())
                .filter(|&index| {
                    let context = knowledge.pattern(knowledge.schemas[index].context);
                    context.unwrap().truth(&state) == Some(true)
                })
                .collect();
            assert_eq!(found, walked);
            match others {
                Others::All(_) => many += 1,
                Others::Chains(_) => few += 1,
            }
        }
        assert!(
            few > 5 && many > 5,
            "{few} within {CHAINS} chains, {many} not"
        );
    }
}
