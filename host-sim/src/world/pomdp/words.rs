//! The words of a `.POMDP` file, each with its line and column, and what can be wrong with them.

use core::fmt;

/// A place in a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Place {
    /// Line, from 1.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
}

/// A file that is no POMDP, in one sentence with the place where it went wrong.
///
/// ```
/// use host_sim::world::pomdp::Pomdp;
/// let wrong = Pomdp::parse("discount: 2\n").unwrap_err();
/// assert_eq!((wrong.place.line, wrong.place.column), (1, 11));
/// assert!(wrong.to_string().starts_with("line 1, column 11: "));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PomdpError {
    /// Where.
    pub place: Place,
    sentence: String,
}

impl PomdpError {
    pub(super) const fn new(place: Place, sentence: String) -> Self {
        Self { place, sentence }
    }
}

impl fmt::Display for PomdpError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Place { line, column } = self.place;
        write!(f, "line {line}, column {column}: {}", self.sentence)
    }
}

impl core::error::Error for PomdpError {}

/// A word, or a colon, which is a word of its own.
#[derive(Clone, Copy, Debug)]
pub(super) struct Word<'a> {
    pub(super) text: &'a str,
    pub(super) place: Place,
}

/// The words of a file in turn.
#[derive(Clone, Debug)]
pub(super) struct Words<'a> {
    words: Vec<Word<'a>>,
    next: usize,
    end: Place,
}

/// Longest piece of a file that is said again in a sentence.
const QUOTED: usize = 24;

/// A word as it is said again: in quotes, without what a terminal would take for a command.
pub(super) fn quoted(text: &str) -> String {
    let mut short: String = text.chars().take(QUOTED).collect();
    if short.len() < text.len() {
        short.push('…');
    }
    format!("{short:?}")
}

impl<'a> Words<'a> {
    /// Splits a text; from `#` to the end of its line is a comment.
    pub(super) fn of(text: &'a str) -> Self {
        let mut words = Vec::new();
        let mut end = Place { line: 1, column: 1 };
        for (line, text) in (1..).zip(text.lines()) {
            let code = text.split('#').next().unwrap_or("");
            let mut start: Option<(usize, u32)> = None;
            let mut column = 0;
            let mut push = |from: Option<(usize, u32)>, to: usize| {
                if let Some((from, column)) = from {
                    let place = Place { line, column };
                    let text = &code[from..to];
                    words.push(Word { text, place });
                }
            };
            for (at, letter) in code.char_indices() {
                column += 1;
                if letter.is_whitespace() || letter == ':' {
                    push(start.take(), at);
                    if letter == ':' {
                        push(Some((at, column)), at + 1);
                    }
                } else if start.is_none() {
                    start = Some((at, column));
                }
            }
            push(start, code.len());
            let column = text.chars().count() as u32 + 1;
            end = Place { line, column };
        }
        Self {
            words,
            next: 0,
            end,
        }
    }

    pub(super) fn peek(&self) -> Option<Word<'a>> {
        self.words.get(self.next).copied()
    }

    /// Whether a colon comes next; if so it is taken.
    pub(super) fn colon(&mut self) -> bool {
        let is = self.peek().is_some_and(|word| word.text == ":");
        self.next += usize::from(is);
        is
    }

    /// The next word, which is `what` for the sentence if there is none.
    pub(super) fn word(&mut self, what: &str) -> Result<Word<'a>, PomdpError> {
        match self.peek() {
            Some(word) if word.text != ":" => {
                self.next += 1;
                Ok(word)
            }
            Some(word) => Err(self.expected(what, Some(word))),
            None => Err(self.expected(what, None)),
        }
    }

    /// A colon must come next.
    pub(super) fn need_colon(&mut self, after: &str) -> Result<(), PomdpError> {
        if self.colon() {
            return Ok(());
        }
        Err(self.expected(&format!("a colon after {after}"), self.peek()))
    }

    /// That something else should stand where `found` is, or at the end of the file.
    pub(super) fn expected(&self, what: &str, found: Option<Word<'_>>) -> PomdpError {
        let found_text = found.map_or("the end of the file".to_owned(), |it| quoted(it.text));
        let place = found.map_or(self.end, |it| it.place);
        PomdpError::new(place, format!("{what} should stand here, not {found_text}"))
    }

    /// A finite number must come next.
    pub(super) fn number(&mut self, what: &str) -> Result<(f64, Place), PomdpError> {
        let word = self.word(what)?;
        let number = word.text.parse::<f64>().ok();
        match number.filter(|it| it.is_finite()) {
            Some(number) => Ok((number, word.place)),
            None => Err(self.expected(what, Some(word))),
        }
    }

    /// A probability must come next.
    pub(super) fn probability(&mut self, of: &str) -> Result<f64, PomdpError> {
        let (number, place) = self.number(&format!("the probability of {of}"))?;
        if (0.0..=1.0).contains(&number) {
            return Ok(number);
        }
        let sentence = format!("a probability lies between 0 and 1, not at {number}");
        Err(PomdpError::new(place, sentence))
    }

    /// Whether the next word begins a part of the file, such as `states:` or `start include:`.
    pub(super) fn at_part(&self) -> bool {
        let text = |ahead: usize| self.words.get(self.next + ahead).map(|word| word.text);
        let Some(word) = text(0) else {
            return true;
        };
        let colon = text(1) == Some(":");
        match word {
            "start" => colon || matches!(text(1), Some("include" | "exclude")),
            "discount" | "values" | "states" | "actions" | "observations" | "T" | "O" | "R" => {
                colon
            }
            _ => false,
        }
    }

    /// The place after the last word.
    pub(super) const fn end(&self) -> Place {
        self.end
    }
}
