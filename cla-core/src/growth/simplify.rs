//! Simplification: harvested schemas cut down to what they need (book, 5.4.4).
//!
//! "Simpler schemas are easy to derive from the final product, should they be desired": a schema
//! with many results becomes one for each result item, and its context loses, one by one, the items
//! without which it still holds on remembered samples.
//! On the Microworld that lifts recall from under .5 to about .8, because over-specific contexts,
//! not missing nodes, are what limits a harvest.

use super::evidence::Transition;
use super::grow::{Conclusion, GrowthConfig, reduce};
use super::simple_schema::SimpleSchema;
use crate::word::SchemaText;

/// The simple schemas that a harvested one says, as far as the samples of its action bear them out.
///
/// A result item that more samples contradict than `config` tolerates, or that needs more than
/// seven context items, is left out.
///
/// ```
/// use cla_core::growth::{GrowthConfig, Transition, simplify};
/// use cla_core::word::{ItemSet, SchemaText, Vocabulary};
/// let words = Vocabulary { items: &["here", "there", "noise"], actions: &["go"] };
/// let schema = SchemaText::<1>::parse("+here-there-noise/go/-here+there", &words)?;
/// let set = |names: &[&str]| {
///     let mut set = ItemSet::<1>::EMPTY;
///     names.iter().for_each(|name| set.insert(words.item(name).unwrap()).unwrap());
///     set
/// };
/// let samples = [
///     Transition { before: set(&["here"]), after: set(&["there"]) },
///     Transition { before: set(&["here", "noise"]), after: set(&["there", "noise"]) },
///     Transition { before: set(&[]), after: set(&[]) },
/// ];
/// let simple: Vec<SchemaText<1>> = simplify(&schema, &samples, &GrowthConfig::EXACT)
///     .map(|it| it.text())
///     .collect();
/// let expected = ["+here/go/+there", "/go/-here"].map(|text| SchemaText::parse(text, &words).unwrap());
/// assert_eq!(simple, expected);
/// # Ok::<(), cla_core::word::NotationError>(())
/// ```
pub fn simplify<'a, const WORDS: usize>(
    schema: &'a SchemaText<WORDS>,
    samples: &'a [Transition<WORDS>],
    config: &'a GrowthConfig,
) -> impl Iterator<Item = SimpleSchema> + 'a {
    let on = schema.result.positive().iter().map(|item| (item, true));
    let off = schema.result.negative().iter().map(|item| (item, false));
    on.chain(off).filter_map(move |(item, sign)| {
        let conclusion = Conclusion {
            action: schema.action,
            item,
            sign,
        };
        reduce(schema.context, conclusion, samples, config)
    })
}
