//! The portrait of the book's learner.

use cla_core::agent::Agent;
use cla_core::knowledge::{Estimate, KnowledgeBase, SchemaId, SyntheticId};
use cla_core::level2::SecondLevel;
use cla_core::snapshot::Stored;
use cla_core::som::Prototypes;
use cla_core::word::{ActionId, ItemId, ItemSet, SignedItems, Vocabulary};

use super::portrait::{Belief, Count, Filling, Item, Portrait, Schema, Sign, by_worth, written};

pub(super) fn portrait<
    const WORDS: usize,
    const ITEMS: usize,
    const W: usize,
    const H: usize,
    const ACTIONS: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H> + Stored,
>(
    brain: &Agent<WORDS, ITEMS, W, H, ACTIONS, P, S, Y, B, M>,
    words: &Vocabulary,
) -> Portrait {
    let knowledge = brain.knowledge();
    let level2 = brain.second_level();
    let maps = brain.bank().maps().iter();
    let samples = maps.clone().map(|map| u64::from(map.samples()));
    let displaced = maps.map(|map| map.displaced()).fold(0, u32::saturating_add);
    let (lost, doubted) = (knowledge.losses(), level2.losses());
    let filling = |name, used: usize, most| Filling::new(name, used as u32, most as u32);
    Portrait {
        kind: "agent".to_owned(),
        stage: format!("{:?}", brain.stage()),
        samples: samples.fold(0, u64::wrapping_add),
        alarms: brain.alarms(),
        actions: words.actions.iter().map(|&it| it.to_owned()).collect(),
        items: items(brain, words),
        schemas: schemas(knowledge, words),
        beliefs: beliefs(knowledge, level2, words),
        tables: vec![
            filling("patterns", usize::from(knowledge.patterns()), P),
            filling("schemas", knowledge.schemas().len(), S),
            filling("synthetic items", usize::from(level2.items()), Y),
            filling("beliefs", level2.beliefs().len(), B),
        ],
        losses: vec![
            Count::new("schemas evicted for better ones", lost.evicted_schemas),
            Count::new(
                "schemas refused, the table being full",
                lost.refused_schemas,
            ),
            Count::new(
                "schemas refused for want of patterns",
                lost.refused_patterns,
            ),
            Count::new("synthetic items evicted", doubted.evicted_items),
            Count::new("synthetic items refused", doubted.refused_items),
            Count::new("beliefs evicted", doubted.evicted_beliefs),
            Count::new("nodes of maps given to other events", displaced),
            Count::new(
                "mean reliability of schemas",
                knowledge.mean_reliability(Estimate::Recent),
            ),
        ],
        ..Portrait::default()
    }
}

fn items<
    const WORDS: usize,
    const ITEMS: usize,
    const W: usize,
    const H: usize,
    const ACTIONS: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H>,
>(
    brain: &Agent<WORDS, ITEMS, W, H, ACTIONS, P, S, Y, B, M>,
    words: &Vocabulary,
) -> Vec<Item> {
    let always = brain.habits().worth(&ItemSet::EMPTY, None);
    let item = |number: u16| {
        let id = ItemId(number);
        let mut alone = ItemSet::EMPTY;
        // An item of the robot fits its sets.
        let _ = alone.insert(id);
        let worth = brain.habits().worth(&alone, None);
        let added = worth.iter().zip(always);
        Item {
            name: words.item_name(id).to_string(),
            inherent: brain.knowledge().inherent_value(id).into(),
            deferred: Some(brain.knowledge().deferred_value(id).into()),
            relevance: None,
            habits: added
                .map(|(worth, always)| f64::from(worth - always))
                .collect(),
        }
    };
    (0..ITEMS as u16).map(item).collect()
}

fn signs<const WORDS: usize>(items: &SignedItems<WORDS>, words: &Vocabulary) -> Vec<Sign> {
    let on = items.positive().iter().map(|item| (item, true));
    let off = items.negative().iter().map(|item| (item, false));
    let mut all: Vec<(ItemId, bool)> = on.chain(off).collect();
    all.sort_unstable_by_key(|(item, _)| item.0);
    let sign = |(item, on)| Sign {
        item: words.item_name(item).to_string(),
        on,
    };
    all.into_iter().map(sign).collect()
}

fn schema<const WORDS: usize, const P: usize, const S: usize>(
    knowledge: &KnowledgeBase<WORDS, P, S>,
    id: SchemaId,
    words: &Vocabulary,
) -> Option<Schema> {
    let row = knowledge.schemas().get(usize::from(id.0))?;
    let text = knowledge.text(id)?;
    let (context, result) = (signs(&text.context, words), signs(&text.result, words));
    let action = words.action_name(text.action).to_string();
    let all = |all| {
        let (before, after) = (written(&context, all), written(&result, all));
        format!("{before}/{action}/{after}")
    };
    Some(Schema {
        text: all(true),
        brief: all(false),
        value: knowledge.value(row.result).unwrap_or_default().into(),
        reliability: Some(row.reliability.value(Estimate::Recent).into()),
        trials: Some(row.reliability.activations()),
        context,
        action,
        result,
    })
}

fn schemas<const WORDS: usize, const P: usize, const S: usize>(
    knowledge: &KnowledgeBase<WORDS, P, S>,
    words: &Vocabulary,
) -> Vec<Schema> {
    let ids = (0..knowledge.schemas().len() as u16).map(SchemaId);
    let mut all: Vec<Schema> = ids.filter_map(|id| schema(knowledge, id, words)).collect();
    by_worth(&mut all);
    all
}

fn beliefs<
    const WORDS: usize,
    const ACTIONS: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
>(
    knowledge: &KnowledgeBase<WORDS, P, S>,
    level2: &SecondLevel<ACTIONS, Y, B>,
    words: &Vocabulary,
) -> Vec<Belief> {
    let named = |item: SyntheticId| {
        let id = level2.schema(item);
        let said = id.and_then(|id| schema(knowledge, id, words));
        said.map_or_else(|| "?".to_owned(), |it| it.brief)
    };
    let mut all: Vec<Belief> = level2
        .beliefs()
        .iter()
        .map(|belief| {
            let id = level2.schema(belief.item);
            let row = id.and_then(|id| knowledge.schemas().get(usize::from(id.0)));
            let action = row.map_or(ActionId(0), |it| it.action);
            Belief {
                after: named(belief.trace),
                item: named(belief.item),
                on: belief.on.into(),
                tried: level2.tried(belief.trace, action).into(),
            }
        })
        .collect();
    all.sort_by(|a, b| b.on.total_cmp(&a.on));
    all
}
