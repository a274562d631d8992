//! The choice of an action from the schemas that apply now (book, 6.1.1, 6.2.3).

use super::value::ValueConfig;
use crate::knowledge::{KnowledgeBase, Others, SchemaId};
use crate::snapshot::stored_codes;
use crate::word::{ActionId, ItemStates};

/// By which rule the best action is found.
///
/// ```
/// use cla_core::choice::ChoiceRule;
/// assert_ne!(ChoiceRule::Lexicographic, ChoiceRule::ExpectedValue);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum ChoiceRule {
    /// The book's: the applicable schema with the most valuable result; of equally valuable ones
    /// the most reliable, then the first (6.2.3).
    Lexicographic,
    /// The action with the largest expected value; ties go to the first.
    ExpectedValue,
}

/// The best action by a rule, and why.
///
/// ```
/// use cla_core::choice::Preference;
/// use cla_core::word::ActionId;
/// let it = Preference { action: ActionId(1), schema: None, value: 9.5 };
/// assert!(it.value > 9.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Preference {
    /// What to do.
    pub action: ActionId,
    /// The schema that speaks for it most.
    pub schema: Option<SchemaId>,
    /// The value that decided.
    pub value: f32,
}

/// What habit holds each action to be worth, and how much of the decision is its.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Voice<const ACTIONS: usize> {
    pub(crate) weight: f32,
    pub(crate) worth: [f32; ACTIONS],
}

/// The action that is worth most by what schemas promise and habit says, or `None` when schemas
/// promise nothing; of equals the first.
pub(crate) fn most_worth<const ACTIONS: usize>(
    promised: &[f32; ACTIONS],
    voice: Option<&Voice<ACTIONS>>,
) -> Option<(ActionId, f32)> {
    let mut best: Option<(ActionId, f32)> = None;
    let mut promising = false;
    for (action, &value) in promised.iter().enumerate() {
        promising |= value > 0.0;
        let value = match voice {
            Some(voice) => match voice.worth.get(action) {
                Some(worth) => value + voice.weight * (worth - value),
                None => value,
            },
            None => value,
        };
        if !value.is_nan() && best.is_none_or(|(_, other)| value > other) {
            best = Some((ActionId(action as u16), value));
        }
    }
    best.filter(|_| promising)
}

impl<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>
    KnowledgeBase<WORDS, PATTERNS, SCHEMAS>
{
    /// The best of `ACTIONS` actions in `state`, or `None` when no schema applies or, by expected
    /// value, when no action promises anything.
    ///
    /// A discount out of its range counts as the nearest in it, NaN as 0.
    pub fn prefer<const ACTIONS: usize>(
        &mut self,
        state: &ItemStates<WORDS>,
        rule: ChoiceRule,
        config: &ValueConfig,
    ) -> Option<Preference> {
        self.prefer_with::<ACTIONS>(state, rule, config, None)
    }

    /// As [`prefer`](Self::prefer); habit has its say where expected values decide.
    pub(crate) fn prefer_with<const ACTIONS: usize>(
        &mut self,
        state: &ItemStates<WORDS>,
        rule: ChoiceRule,
        config: &ValueConfig,
        voice: Option<&Voice<ACTIONS>>,
    ) -> Option<Preference> {
        match rule {
            ChoiceRule::Lexicographic => self.most_valuable::<ACTIONS>(state, config),
            ChoiceRule::ExpectedValue => self.most_promising::<ACTIONS>(state, config, voice),
        }
    }

    fn most_valuable<const ACTIONS: usize>(
        &mut self,
        state: &ItemStates<WORDS>,
        config: &ValueConfig,
    ) -> Option<Preference> {
        self.look_at(state);
        let mut best: Option<(f32, f32, Preference)> = None;
        for (index, schema) in self.schemas.iter().enumerate() {
            let context = self.patterns.get(usize::from(schema.context.0));
            if !context.is_some_and(|pattern| pattern.holds)
                || usize::from(schema.action.0) >= ACTIONS
            {
                continue;
            }
            let value = match self.patterns.get(usize::from(schema.result.0)) {
                Some(result) => self.largest_value(&result.items),
                None => 0.0,
            };
            let reliability = schema.reliability.value(config.estimate);
            let better = best.as_ref().is_none_or(|&(other, tie, _)| {
                value > other || (value == other && reliability > tie)
            });
            if better {
                let schema_id = Some(SchemaId(index as u16));
                let found = Preference {
                    action: schema.action,
                    schema: schema_id,
                    value,
                };
                best = Some((value, reliability, found));
            }
        }
        best.map(|(_, _, preference)| preference)
    }

    fn most_promising<const ACTIONS: usize>(
        &mut self,
        state: &ItemStates<WORDS>,
        config: &ValueConfig,
        voice: Option<&Voice<ACTIONS>>,
    ) -> Option<Preference> {
        let appraisals = self.expected_values::<ACTIONS>(state, config);
        let promised = appraisals.map(|appraisal| appraisal.value);
        let (action, value) = most_worth(&promised, voice)?;
        Some(Preference {
            action,
            schema: self.most_reliable_applicable(state, action, config),
            value,
        })
    }

    /// Of the schemas that apply in `state`, the most reliable for an action; of equals the first.
    pub(crate) fn most_reliable_applicable(
        &mut self,
        state: &ItemStates<WORDS>,
        action: ActionId,
        config: &ValueConfig,
    ) -> Option<SchemaId> {
        let mut best: Option<(f32, SchemaId)> = None;
        let mut others = Others::none();
        let mut applicable = self.applicable(state, &mut others);
        while let Some(index) = applicable.next(self) {
            if let Some(schema) = self.schemas.get(index)
                && schema.action == action
            {
                let reliability = schema.reliability.value(config.estimate);
                if best.is_none_or(|(other, _)| reliability > other) {
                    best = Some((reliability, SchemaId(index as u16)));
                }
            }
        }
        self.count_schemas(applicable.seen());
        best.map(|(_, schema)| schema)
    }
}

stored_codes!(ChoiceRule {
    0: (Self::Lexicographic),
    1: (Self::ExpectedValue)
});

#[cfg(test)]
mod tests {
    use super::{ActionId, ChoiceRule, KnowledgeBase, SchemaId, ValueConfig, Voice, most_worth};
    use crate::word::{ItemId, ItemStates, SchemaText, Vocabulary};

    const WORDS: Vocabulary = Vocabulary {
        items: &["here", "gold", "path"],
        actions: &["leap", "walk"],
    };

    fn knowledge(schemas: &[(&str, u32, u32)]) -> KnowledgeBase<1, 16, 16> {
        let mut knowledge = KnowledgeBase::new();
        knowledge.set_inherent_value(ItemId(1), 10.0).unwrap();
        for &(text, successes, activations) in schemas {
            let text = SchemaText::parse(text, &WORDS).unwrap();
            knowledge.insert(&text, successes, activations).unwrap();
        }
        knowledge.defer_values(&ValueConfig::BOOK);
        knowledge.settle_values::<2>(100, &ValueConfig::BOOK);
        knowledge
    }

    fn here() -> ItemStates<1> {
        let mut now = ItemStates::all_off(3);
        now.set(ItemId(0), Some(true)).unwrap();
        now
    }

    #[test]
    fn the_book_leaps_at_the_largest_value_and_expectation_walks_the_sure_way() {
        let mut it = knowledge(&[
            ("+here/leap/+gold", 1, 10),
            ("+here/leap/+here", 9, 10),
            ("+here/walk/+path", 10, 10),
            ("+path/walk/+gold", 10, 10),
        ]);
        let choose = |it: &mut KnowledgeBase<1, 16, 16>, rule| {
            it.prefer::<2>(&here(), rule, &ValueConfig::BOOK)
                .unwrap()
                .action
        };
        assert_eq!(choose(&mut it, ChoiceRule::Lexicographic), ActionId(0));
        assert_eq!(choose(&mut it, ChoiceRule::ExpectedValue), ActionId(1));
    }

    #[test]
    fn the_more_reliable_of_two_equally_valuable_schemas_is_chosen() {
        let mut it = knowledge(&[("+here/leap/+gold", 3, 10), ("+here/walk/+gold", 4, 10)]);
        let best = it
            .prefer::<2>(&here(), ChoiceRule::Lexicographic, &ValueConfig::BOOK)
            .unwrap();
        assert_eq!((best.action, best.value), (ActionId(1), 10.0));
    }

    #[test]
    fn nothing_is_preferred_where_no_schema_applies() {
        let mut it = knowledge(&[("+path/walk/+gold", 1, 1)]);
        for rule in [ChoiceRule::Lexicographic, ChoiceRule::ExpectedValue] {
            assert_eq!(it.prefer::<2>(&here(), rule, &ValueConfig::BOOK), None);
        }
    }

    #[test]
    fn values_fall_by_five_percent_a_link_as_in_table_6_3() {
        let it = knowledge(&[("+path/walk/+gold", 1, 1), ("+here/walk/+path", 1, 1)]);
        assert!((it.deferred_value(ItemId(2)) - 9.5).abs() < 1e-5);
        assert!((it.deferred_value(ItemId(0)) - 9.025).abs() < 1e-5);
    }

    #[test]
    fn an_expected_value_is_the_mean_over_alternative_results() {
        let mut it = knowledge(&[("+here/leap/+gold", 1, 4), ("+here/leap/-here", 3, 4)]);
        let [leap, walk] = it.expected_values::<2>(&here(), &ValueConfig::BOOK);
        assert!((leap.value - 2.5).abs() < 1e-5, "{leap:?}");
        assert!(!walk.applicable);
    }

    #[test]
    fn overlapping_contexts_do_not_promise_more_than_certainty() {
        let mut it = knowledge(&[
            ("+here/leap/+gold", 9, 10),
            ("+here-gold/leap/+gold", 8, 10),
        ]);
        let [leap, _] = it.expected_values::<2>(&here(), &ValueConfig::BOOK);
        assert!((leap.value - 10.0).abs() < 1e-4, "{leap:?}");
    }

    #[test]
    fn habit_has_its_share_of_an_actions_worth_and_schemas_have_the_rest() {
        let promised = [4.0, 2.0, 0.0];
        let say = |weight| {
            let voice = Voice {
                weight,
                worth: [0.0, 20.0, 6.0],
            };
            most_worth(&promised, Some(&voice))
        };
        assert_eq!(most_worth(&promised, None), Some((ActionId(0), 4.0)));
        assert_eq!(say(0.0), Some((ActionId(0), 4.0)));
        assert_eq!(say(0.25), Some((ActionId(1), 0.75 * 2.0 + 0.25 * 20.0)));
        assert_eq!(say(1.0), Some((ActionId(1), 20.0)));
    }

    #[test]
    fn of_actions_worth_the_same_the_first_is_done_and_without_a_promise_none() {
        assert_eq!(most_worth(&[1.0, 3.0, 3.0], None), Some((ActionId(1), 3.0)));
        let voice = Voice {
            weight: 0.5,
            worth: [7.0, 9.0],
        };
        assert_eq!(most_worth(&[0.0, 0.0], Some(&voice)), None);
        assert_eq!(most_worth(&[0.0, 0.0], None), None);
        // One promise lets habit speak for the other action.
        assert_eq!(
            most_worth(&[1.0, 0.0], Some(&voice)),
            Some((ActionId(1), 4.5))
        );
        assert_eq!(most_worth(&[f32::NAN, 1.0], None), Some((ActionId(1), 1.0)));
    }

    #[test]
    fn the_schema_that_speaks_for_an_action_is_its_most_reliable_that_applies() {
        let mut it = knowledge(&[
            ("+here/leap/+gold", 3, 10),
            ("+here/leap/+path", 7, 10),
            ("+here/leap/-here", 7, 10),
            ("+here/walk/+here", 9, 10),
            ("+path/leap/+gold", 10, 10),
        ]);
        let best = it
            .prefer::<2>(&here(), ChoiceRule::ExpectedValue, &ValueConfig::BOOK)
            .unwrap();
        assert_eq!((best.action, best.schema), (ActionId(0), Some(SchemaId(1))));
        let seen = it.cost.schemas;
        let of = |it: &mut KnowledgeBase<1, 16, 16>, action| {
            it.most_reliable_applicable(&here(), ActionId(action), &ValueConfig::BOOK)
        };
        assert_eq!(of(&mut it, 1), Some(SchemaId(3)));
        assert_eq!(it.cost.schemas - seen, 4, "those that apply");
        assert_eq!(of(&mut it, 2), None);
    }

    #[test]
    fn the_books_rule_takes_value_first_reliability_second_and_the_first_of_equals() {
        let choose = |schemas: &[(&str, u32, u32)]| {
            let mut it = knowledge(schemas);
            let best = it.prefer::<2>(&here(), ChoiceRule::Lexicographic, &ValueConfig::BOOK);
            let best = best.unwrap();
            (best.schema.unwrap().0, best.action.0, best.value)
        };
        // The surer schema of lower value loses, whatever the order.
        let (sure, bold) = (("+here/walk/+path", 9, 10), ("+here/leap/+gold", 1, 10));
        assert_eq!(choose(&[sure, bold]), (1, 0, 10.0));
        assert_eq!(choose(&[bold, sure]), (0, 0, 10.0));
        // Of equals the first; the surer of equally valuable ones, whatever the order.
        let (other, better) = (("+here/walk/+gold", 1, 10), ("+here/walk/+gold", 2, 10));
        assert_eq!(choose(&[bold, other]), (0, 0, 10.0));
        assert_eq!(choose(&[bold, better]), (1, 1, 10.0));
        assert_eq!(choose(&[better, bold]), (0, 1, 10.0));
        // A result without value is better than nothing, and the robot has no third action.
        assert_eq!(choose(&[("+here/walk/-path", 1, 10)]), (0, 1, 0.0));
        let mut it = knowledge(&[("+here/walk/+gold", 1, 10)]);
        let none = it.prefer::<1>(&here(), ChoiceRule::Lexicographic, &ValueConfig::BOOK);
        assert_eq!(none, None);
    }
}
