//! A rule as text and back: what stands in a summary is what is evaluated.

use core::fmt;
use core::str::FromStr;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use super::rule::{Better, Bound, Rule, Statistic};

/// The words of the statistics; a rule begins with one of them.
const STATISTICS: [(Statistic, &str); 9] = [
    (Statistic::Mean, "mean"),
    (Statistic::Median, "median"),
    (Statistic::Every, "every seed"),
    (Statistic::T, "t"),
    (Statistic::Holm, "Holm p"),
    (Statistic::P, "p"),
    (Statistic::Ahead, "share ahead"),
    (Statistic::Low, "lower end"),
    (Statistic::High, "upper end"),
];

/// The sentences of the rules that have no bound.
const SENTENCES: [(Rule, &str); 5] = [
    (
        Rule::Book(Better::Higher),
        "mean within 2 sd of the book and sd within a factor 2; exceeded: higher by 2 sd of both",
    ),
    (
        Rule::Book(Better::Lower),
        "mean within 2 sd of the book and sd within a factor 2; exceeded: lower by 2 sd of both",
    ),
    (
        Rule::Book(Better::Neither),
        "mean within 2 sd of the book and sd within a factor 2",
    ),
    (Rule::Compared, "compared: no error is printed"),
    (Rule::Measured, "measured: nothing is asked"),
];

/// What follows the bound of an equivalence.
const EQUIVALENT: &str = " with n >= 60 or the same to the bit";

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AtLeast(bound) => write!(f, ">= {bound}"),
            Self::AtMost(bound) => write!(f, "<= {bound}"),
            Self::Above(bound) => write!(f, "> {bound}"),
            Self::Below(bound) => write!(f, "< {bound}"),
            Self::Between(low, high) => write!(f, "in [{low}, {high}]"),
        }
    }
}

impl fmt::Display for Statistic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let word = STATISTICS.iter().find(|(it, _)| it == self);
        f.write_str(word.map_or("", |(_, word)| word))
    }
}

impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Keeps(statistic, bound) => write!(f, "{statistic} {bound}"),
            Self::Equivalent(statistic, bound) => write!(f, "{statistic} {bound}{EQUIVALENT}"),
            Self::All(rules) => {
                for (index, rule) in rules.iter().enumerate() {
                    let between = if index == 0 { "" } else { " and " };
                    write!(f, "{between}{rule}")?;
                }
                Ok(())
            }
            sentence => {
                let words = SENTENCES.iter().find(|(it, _)| it == sentence);
                f.write_str(words.map_or("", |(_, words)| words))
            }
        }
    }
}

/// A text that is no rule.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoRule(String);

impl fmt::Display for NoRule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?} is no rule", self.0)
    }
}

impl std::error::Error for NoRule {}

impl FromStr for Rule {
    type Err = NoRule;

    fn from_str(text: &str) -> Result<Self, NoRule> {
        if let Some((rule, _)) = SENTENCES.iter().find(|(_, words)| *words == text) {
            return Ok(rule.clone());
        }
        if let Some(rest) = text.strip_suffix(EQUIVALENT) {
            return match keeps(rest) {
                Some((statistic, bound)) => Ok(Self::Equivalent(statistic, bound)),
                None => Err(NoRule(text.to_owned())),
            };
        }
        let parts: Option<Vec<Self>> = text
            .split(" and ")
            .map(|part| keeps(part).map(|(statistic, bound)| Self::Keeps(statistic, bound)))
            .collect();
        let mut parts = parts.ok_or_else(|| NoRule(text.to_owned()))?;
        match (parts.len(), parts.pop()) {
            (1, Some(only)) => Ok(only),
            (_, Some(last)) => {
                parts.push(last);
                Ok(Self::All(parts))
            }
            (_, None) => Err(NoRule(text.to_owned())),
        }
    }
}

fn keeps(text: &str) -> Option<(Statistic, Bound)> {
    STATISTICS.iter().find_map(|(statistic, word)| {
        let rest = text.strip_prefix(word)?.strip_prefix(' ')?;
        bound(rest).map(|bound| (*statistic, bound))
    })
}

fn bound(text: &str) -> Option<Bound> {
    let number = |text: &str| text.parse().ok().filter(|it: &f64| it.is_finite());
    if let Some(range) = text.strip_prefix("in [") {
        let (low, high) = range.strip_suffix(']')?.split_once(", ")?;
        return Some(Bound::Between(number(low)?, number(high)?));
    }
    let (sign, edge) = text.split_once(' ')?;
    let edge = number(edge)?;
    match sign {
        ">=" => Some(Bound::AtLeast(edge)),
        "<=" => Some(Bound::AtMost(edge)),
        ">" => Some(Bound::Above(edge)),
        "<" => Some(Bound::Below(edge)),
        _ => None,
    }
}

impl Serialize for Rule {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Rule {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        text.parse().map_err(de::Error::custom)
    }
}
