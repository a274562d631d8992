//! The book's notation, `+s3/forward/+s3+ingrip`, written and read in one place (book, 5.1.1).

use core::fmt;

use super::action::{ActionId, Vocabulary};
use super::item::ItemId;
use super::signed_items::SignedItems;

/// How much of a conjunction is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detail {
    /// Every signed item.
    Full,
    /// Positive items only, as the book does where items exclude each other (6.2.6).
    Abbreviated,
}

/// A context, action and result spelled out: what a schema says, without what is known of it.
///
/// ```
/// use cla_core::word::{Detail, SchemaText, Vocabulary};
/// let words = Vocabulary { items: &["s3", "ingrip", "bump"], actions: &["forward"] };
/// let text = SchemaText::<1>::parse("+s3-bump/forward/+s3+ingrip", &words)?;
/// assert_eq!(text.display(&words, Detail::Full).to_string(), "+s3-bump/forward/+s3+ingrip");
/// assert_eq!(text.display(&words, Detail::Abbreviated).to_string(), "+s3/forward/+s3+ingrip");
/// assert!(SchemaText::<1>::parse("+s3/fly/", &words).is_err());
/// # Ok::<(), cla_core::word::NotationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SchemaText<const WORDS: usize> {
    /// What must hold before.
    pub context: SignedItems<WORDS>,
    /// What is done.
    pub action: ActionId,
    /// What is expected afterwards.
    pub result: SignedItems<WORDS>,
}

/// Why a text is not a schema.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotationError {
    /// There are not two slashes.
    Slashes,
    /// An item does not begin with `+` or `-`.
    Sign,
    /// The vocabulary has no such item, or it does not fit the capacity.
    Item,
    /// The vocabulary has no such action.
    Action,
}

impl fmt::Display for NotationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Slashes => "a schema is written context/action/result",
            Self::Sign => "an item is written with its sign, +item or -item",
            Self::Item => "no item has that name",
            Self::Action => "no action has that name",
        })
    }
}

impl core::error::Error for NotationError {}

impl<const WORDS: usize> SchemaText<WORDS> {
    /// Reads `context/action/result`.
    ///
    /// # Errors
    /// [`NotationError`] names what is wrong.
    pub fn parse(text: &str, words: &Vocabulary) -> Result<Self, NotationError> {
        let (context, rest) = text.split_once('/').ok_or(NotationError::Slashes)?;
        let (action, result) = rest.split_once('/').ok_or(NotationError::Slashes)?;
        Ok(Self {
            context: parse_items(context, words)?,
            action: words.action(action).ok_or(NotationError::Action)?,
            result: parse_items(result, words)?,
        })
    }

    /// The text, to print.
    #[must_use]
    pub const fn display<'a>(
        &'a self,
        words: &'a Vocabulary,
        detail: Detail,
    ) -> Written<'a, WORDS> {
        Written {
            text: self,
            words,
            detail,
        }
    }
}

fn parse_items<const WORDS: usize>(
    text: &str,
    words: &Vocabulary,
) -> Result<SignedItems<WORDS>, NotationError> {
    let mut items = SignedItems::EMPTY;
    let mut rest = text;
    while let Some(sign) = rest.chars().next() {
        let positive = match sign {
            '+' => true,
            '-' => false,
            _ => return Err(NotationError::Sign),
        };
        let tail = rest.get(1..).unwrap_or("");
        let end = tail.find(['+', '-']).unwrap_or(tail.len());
        let (name, others) = tail.split_at_checked(end).unwrap_or((tail, ""));
        let item = words.item(name).ok_or(NotationError::Item)?;
        items
            .insert(item, positive)
            .map_err(|_| NotationError::Item)?;
        rest = others;
    }
    Ok(items)
}

/// A [`SchemaText`] on its way to a page; made by [`SchemaText::display`].
///
/// ```
/// use cla_core::word::{Detail, SchemaText, Vocabulary};
/// let words = Vocabulary { items: &["s1"], actions: &["turnl"] };
/// let text = SchemaText::<1>::parse("/turnl/+s1", &words)?;
/// assert_eq!(format!("{}", text.display(&words, Detail::Full)), "/turnl/+s1");
/// # Ok::<(), cla_core::word::NotationError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Written<'a, const WORDS: usize> {
    text: &'a SchemaText<WORDS>,
    words: &'a Vocabulary,
    detail: Detail,
}

impl<const WORDS: usize> fmt::Display for Written<'_, WORDS> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_items(f, &self.text.context, self.words, self.detail)?;
        write!(f, "/{}/", self.words.action_name(self.text.action))?;
        write_items(f, &self.text.result, self.words, self.detail)
    }
}

fn write_items<const WORDS: usize>(
    f: &mut fmt::Formatter<'_>,
    items: &SignedItems<WORDS>,
    words: &Vocabulary,
    detail: Detail,
) -> fmt::Result {
    let signed = |f: &mut fmt::Formatter<'_>, sign: &str, item: ItemId| {
        write!(f, "{sign}{}", words.item_name(item))
    };
    for item in items.positive().iter() {
        signed(f, "+", item)?;
    }
    if detail == Detail::Full {
        for item in items.negative().iter() {
            signed(f, "-", item)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{Detail, NotationError, SchemaText, Vocabulary};
    use std::string::ToString;

    const WORDS: Vocabulary = Vocabulary {
        items: &["s1", "s2", "ingrip"],
        actions: &["turnl", "grip"],
    };

    #[test]
    fn every_schema_of_the_vocabulary_survives_writing_and_reading() {
        for text in ["/grip/-ingrip", "+s1/turnl/+s2-s1", "+ingrip-s1-s2/grip/"] {
            let schema = SchemaText::<1>::parse(text, &WORDS).unwrap();
            let written = schema.display(&WORDS, Detail::Full).to_string();
            assert_eq!(SchemaText::parse(&written, &WORDS), Ok(schema));
        }
    }

    #[test]
    fn each_error_names_its_cause() {
        let parse = |text| SchemaText::<1>::parse(text, &WORDS).unwrap_err();
        assert_eq!(parse("+s1"), NotationError::Slashes);
        assert_eq!(parse("s1/turnl/"), NotationError::Sign);
        assert_eq!(parse("+s9/turnl/"), NotationError::Item);
        assert_eq!(parse("+/turnl/"), NotationError::Item);
        assert_eq!(parse("+s1/jump/"), NotationError::Action);
    }
}
