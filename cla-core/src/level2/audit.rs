//! The second level looked through for what cannot be so.

use super::belief::{BeliefTable, Row};
use super::second_level::{MOST_SHARE, SecondLevel};
use crate::knowledge::{KnowledgeBase, SyntheticId};
use crate::snapshot::{LARGEST, LARGEST_COUNT, Stored};
use crate::word::ActionId;

/// How many times as much as was tried is believed together at most.
///
/// In a life it is as much and no more, but for rounding: of millions that forget a ten-millionth at a
/// time a step takes between ⅔ and 1¼ of what it should, so that their sum may grow to 1⅞ of what was
/// tried; with a hundredth it is a few millionths.
/// Not just 2, so that no small counts stand on the edge.
const TOGETHER: f32 = 2.001;

/// Whether a number is at least 0 and at most another.
fn within(number: f32, most: f32) -> bool {
    (0.0..=most).contains(&number)
}

impl<const ACTIONS: usize> Row<ACTIONS> {
    fn is_sound(&self) -> bool {
        self.action < ActionId(ACTIONS as u16)
            && within(self.value, LARGEST)
            && self.experienced.abs() <= LARGEST
            && within(self.visits, LARGEST_COUNT)
            && within(self.eligibility, 1.0)
            && self
                .tried
                .iter()
                .fold(true, |all, &it| all & within(it, LARGEST_COUNT))
    }
}

impl<const ACTIONS: usize, const ITEMS: usize, const BELIEFS: usize>
    BeliefTable<ACTIONS, ITEMS, BELIEFS>
{
    /// Frees rows and drops beliefs that cannot be so; answers how many.
    fn audit<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>(
        &mut self,
        knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
    ) -> u32 {
        let mut mended = 0;
        for index in 0..self.rows.len() {
            let id = SyntheticId(index as u16);
            let Some(row) = self.rows.get_mut(index) else {
                break;
            };
            let action = row.action;
            let points = row.schema.is_none_or(|it| {
                let schema = knowledge.schemas.get(usize::from(it.0));
                // The schema whose item it is has its action.
                schema.is_some_and(|it| it.synthetic() != Some(id) || it.action == action)
            });
            let sound = row.is_sound();
            if !sound {
                *row = Row {
                    used: row.used,
                    ..Row::BLANK
                };
            }
            if !(sound && points) {
                self.free(id);
                mended += 1;
            }
        }
        let (rows, before) = (self.rows.len(), self.beliefs.len());
        let mut last = None;
        self.beliefs.retain(|it| {
            let key = (it.trace, it.item);
            let sound = usize::from(it.trace.0) < rows
                && usize::from(it.item.0) < rows
                && within(it.on, LARGEST_COUNT)
                && last.is_none_or(|last| last < key);
            if sound {
                last = Some(key);
            }
            sound
        });
        mended + (before - self.beliefs.len()) as u32 + self.audit_counts()
    }

    /// Lets nothing be believed more often than it was tried, alone or together with what else is
    /// believed about that action after that trace; answers how often something was.
    ///
    /// Both counts of a belief are always changed by the same numbers, so that alone it is at most what
    /// was tried, to the bit.
    fn audit_counts(&mut self) -> u32 {
        let mut mended = 0;
        let Self { rows, beliefs, .. } = self;
        for belief in beliefs.iter_mut() {
            let row = |id: SyntheticId| rows.get(usize::from(id.0));
            let (Some(trace), Some(item)) = (row(belief.trace), row(belief.item)) else {
                continue;
            };
            if let Some(&tried) = trace.tried.get(usize::from(item.action.0))
                && belief.on > tried
            {
                belief.on = tried;
                mended += 1;
            }
        }
        for index in 0..self.rows.len() {
            let trace = SyntheticId(index as u16);
            let mut sums = [0.0; ACTIONS];
            for belief in self.after(trace) {
                let row = self.row(belief.item);
                let action = row.map_or(ACTIONS, |row| usize::from(row.action.0));
                if let Some(sum) = sums.get_mut(action) {
                    *sum += belief.on;
                }
            }
            let tried = self.row(trace).map_or([0.0; ACTIONS], |row| row.tried);
            for (action, (sum, tried)) in (0..).zip(sums.into_iter().zip(tried)) {
                // The smallest counts have few digits.
                if sum > TOGETHER * tried + f32::MIN_POSITIVE {
                    self.weaken(trace, ActionId(action), tried / sum);
                    mended += 1;
                }
            }
        }
        mended
    }
}

impl<const ACTIONS: usize, const SYNTHETIC: usize, const BELIEFS: usize>
    SecondLevel<ACTIONS, SYNTHETIC, BELIEFS>
{
    /// Frees rows and drops beliefs that cannot be so, and lets schemas lose items that are none;
    /// answers how many. Schemas may have `moved` in their table.
    pub(crate) fn audit<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>(
        &mut self,
        knowledge: &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        moved: bool,
    ) -> u32 {
        if moved {
            self.follow(knowledge);
        }
        let mut mended = self.table.audit(knowledge);
        let rows = self.table.rows.len();
        for schema in &mut knowledge.schemas {
            let item = schema.synthetic().map(|item| self.table.row(item));
            let free = item.is_some_and(|row| row.is_none_or(|row| row.schema.is_none()));
            if rows > 0 && free {
                schema.set_synthetic(None);
                mended += 1;
            }
        }
        for share in [
            &mut self.slow,
            &mut self.fast,
            &mut self.rates.discount,
            &mut self.rates.experience,
        ] {
            if !within(*share, MOST_SHARE) {
                *share = 0.0;
                mended += 1;
            }
        }
        self.rebuild();
        mended
    }
}

#[cfg(test)]
mod tests {
    use super::{KnowledgeBase, SecondLevel, SyntheticId};
    use crate::knowledge::SchemaId;
    use crate::word::{ActionId, SchemaText, Vocabulary};

    const WORDS: Vocabulary = Vocabulary {
        items: &["a", "b", "c", "gold"],
        actions: &["go", "stay"],
    };
    const GO: ActionId = ActionId(0);
    const STAY: ActionId = ActionId(1);

    type Knowledge = KnowledgeBase<1, 16, 16>;
    type Two = SecondLevel<2, 6, 16>;

    /// After the first item going was tried ten times, with three results, and staying once.
    fn met() -> (Knowledge, Two) {
        let (mut knowledge, mut level) = (Knowledge::new(), Two::new());
        let texts = ["+a/go/+b", "+a/go/+c", "+a/go/+gold", "+a/stay/+a"];
        for (index, text) in (0..).zip(texts) {
            let text = SchemaText::parse(text, &WORDS).unwrap();
            knowledge.insert(&text, 1, 1).unwrap();
            let made = level.reify(&mut knowledge, SchemaId(index));
            assert_eq!(made, Some(SyntheticId(index)));
        }
        for (item, action, times) in [(0, GO, 5), (1, GO, 3), (2, GO, 2), (3, STAY, 1)] {
            for _ in 0..times {
                let item = Some(SyntheticId(item));
                level.table.record(SyntheticId(0), action, item, 0.0);
            }
        }
        (knowledge, level)
    }

    #[test]
    fn nothing_is_believed_more_often_than_it_was_tried_alone_or_together() {
        let (mut knowledge, mut level) = met();
        let sound = level.clone();
        assert_eq!(level.audit(&mut knowledge, false), 0);
        assert_eq!(level, sound);
        level.table.beliefs[0].on = 11.0;
        assert_eq!(level.audit(&mut knowledge, false), 1);
        let on = |level: &Two| [0, 1, 2, 3].map(|at| level.beliefs()[at].on);
        assert_eq!(on(&level), [10.0, 3.0, 2.0, 1.0]);
        // Each of them may be so, and not all.
        for (belief, on) in level.table.beliefs.iter_mut().zip([10.0, 8.0, 7.0]) {
            belief.on = on;
        }
        assert_eq!(level.audit(&mut knowledge, false), 1);
        for (on, expected) in on(&level).into_iter().zip([4.0, 3.2, 2.8, 1.0]) {
            assert!((on - expected).abs() < 1e-5, "{on}, not {expected}");
        }
        assert_eq!(level.audit(&mut knowledge, false), 0);
    }

    #[test]
    fn what_counts_for_less_and_less_stays_within_what_was_tried() {
        for forgetting in [0.0, 1e-3, 0.01, 0.3, 0.999_999_94] {
            let (mut knowledge, mut level) = met();
            let mut turn = 0_u32;
            for share in [1.0, 0.7, 0.123_456_7, 1e-3, 1e-30] {
                level.table.forget(SyntheticId(0), GO, share);
                assert_eq!(
                    level.audit(&mut knowledge, false),
                    0,
                    "{forgetting} {share}"
                );
                for _ in 0..3000 {
                    turn = turn.wrapping_mul(0x9E37_79B1).wrapping_add(1);
                    let item = Some(SyntheticId((turn >> 20) as u16 % 3));
                    level.table.record(SyntheticId(0), GO, item, forgetting);
                }
                assert_eq!(
                    level.audit(&mut knowledge, false),
                    0,
                    "{forgetting} {share}"
                );
            }
        }
    }

    #[test]
    fn as_much_too_much_as_rounding_brings_is_sound_and_more_is_not() {
        for (times, mended) in [(1.87, 0), (2.1, 1)] {
            let (mut knowledge, mut level) = met();
            level.table.rows[0].tried[usize::from(GO.0)] = 6.71e6;
            for belief in &mut level.table.beliefs[..3] {
                belief.on = 6.71e6 * times / 3.0;
            }
            assert_eq!(level.audit(&mut knowledge, false), mended, "{times}");
        }
    }

    #[test]
    fn an_item_of_another_action_than_its_schemas_is_freed_and_never_followed() {
        let (mut knowledge, mut level) = met();
        level.table.rows[1].action = STAY;
        // The item, and its schema's mark.
        assert_eq!(level.audit(&mut knowledge, false), 2);
        assert_eq!(level.schema(SyntheticId(1)), None);
        assert_eq!(knowledge.schemas()[1].synthetic(), None);
        assert_eq!(level.audit(&mut knowledge, false), 0);
        let (mut knowledge, mut level) = met();
        knowledge.schemas[0].set_synthetic(Some(SyntheticId(3)));
        level.follow(&knowledge);
        assert_eq!(level.schema(SyntheticId(3)), Some(SchemaId(3)));
        assert_eq!(level.schema(SyntheticId(0)), None);
    }
}
