//! Attention: items of contexts that trials bore out are looked at first.
//!
//! Of the items that would explain a change after few samples, many do so by accident; those that
//! matter to one result of an action mostly matter to its others too (where the eye is, to what it
//! will see).
//! Nothing here is stored: it is counted in the table whenever a schema grows.

use super::simple_schema::SimpleSchema;
use crate::snapshot::stored;
use crate::word::{ActionId, ItemId};

/// How often each item stands in contexts of one action.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Attention<const WORDS: usize> {
    named: [[u16; 32]; WORDS],
    most: u16,
}

impl<const WORDS: usize> Attention<WORDS> {
    /// A schema counts from this many successes on.
    const BORNE_OUT: u16 = 8;

    /// All items alike.
    pub(crate) const NONE: Self = Self {
        named: [[0; 32]; WORDS],
        most: 0,
    };

    /// What the contexts of an action's schemas name; a result item's own state before says nothing
    /// of others.
    pub(crate) fn of(action: ActionId, schemas: &[SimpleSchema]) -> Self {
        let mut it = Self::NONE;
        let borne_out = |schema: &&SimpleSchema| {
            schema.action() == action && schema.successes() >= Self::BORNE_OUT
        };
        for schema in schemas.iter().filter(borne_out) {
            for (item, _) in schema.context() {
                if item == schema.result_item() {
                    continue;
                }
                let counts = it.named.as_flattened_mut();
                if let Some(count) = counts.get_mut(usize::from(item.0)) {
                    *count = count.saturating_add(1);
                    it.most = it.most.max(*count);
                }
            }
        }
        it
    }

    /// Between 1 for an item that no context names and 1 + `strength` for the one that most name.
    pub(crate) fn weight(&self, item: ItemId, strength: f32) -> f32 {
        if self.most == 0 {
            return 1.0;
        }
        let count = self.named.as_flattened().get(usize::from(item.0));
        1.0 + strength * f32::from(count.copied().unwrap_or(0)) / f32::from(self.most)
    }
}

stored! { impl[const WORDS: usize] Attention<WORDS> { named, most } }

#[cfg(test)]
mod tests {
    use super::Attention;
    use crate::growth::SimpleSchema;
    use crate::word::{ActionId, ItemId, SchemaText, Vocabulary};

    const WORDS: Vocabulary = Vocabulary {
        items: &["a", "b", "c", "d"],
        actions: &["x", "y"],
    };

    fn tried(text: &str, times: u16) -> SimpleSchema {
        let text = SchemaText::<1>::parse(text, &WORDS).unwrap();
        let mut schema = SimpleSchema::pack(&text).unwrap();
        (0..times).for_each(|_| schema.record(true));
        schema
    }

    #[test]
    fn what_tried_contexts_of_the_same_action_name_weighs_more() {
        let schemas = [
            tried("+a-d/x/+d", 9),
            tried("+a+b-c/x/+c", 9),
            tried("+c/x/+b", 2),
            tried("+c/y/+b", 9),
        ];
        let attention = Attention::<1>::of(ActionId(0), &schemas);
        let weights = [0, 1, 2, 3].map(|item| attention.weight(ItemId(item), 3.0));
        // d and c stand only before their own change, c else hardly tried or with another action.
        assert_eq!(weights, [4.0, 2.5, 1.0, 1.0]);
        assert_eq!(Attention::<1>::NONE.weight(ItemId(0), 3.0), 1.0);
    }
}
