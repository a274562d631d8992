//! Reads Cassandra's file format: the names, the start, and that all is there; chances and rewards are
//! read in `entries`.
//!
//! Source: A. Cassandra, "POMDP file format" (pomdp.org), grammar of `pomdp-solve` 5.3.

use super::model::Pomdp;
use super::parser::{Body, Head, Parser, ROUNDING, Rows};
use super::words::{Place, PomdpError, Words, quoted};
use crate::world::WORLD_WORDS;
use crate::world::names::{Names, kept};

/// Most observations, because each becomes an item.
const MOST_OBSERVATIONS: usize = 32 * WORLD_WORDS;

/// Most actions: those of a brain.
const MOST_ACTIONS: usize = 256;

/// Most chances of one kind: states × states × actions, or states × observations × actions.
const MOST_CHANCES: usize = 1 << 22;

/// Most states: where there is one action, from each to each is a chance.
const MOST_STATES: usize = 1 << 11;

impl Pomdp {
    /// Reads a file.
    ///
    /// # Errors
    /// [`PomdpError`] says in one sentence, with line and column, what cannot be read.
    pub fn parse(text: &str) -> Result<Self, PomdpError> {
        let mut parser = Parser {
            words: Words::of(text),
            head: Head::default(),
            body: None,
        };
        while let Some(word) = parser.words.peek() {
            parser.part(word.text, word.place)?;
        }
        parser.close()
    }
}

impl Parser<'_> {
    fn part(&mut self, part: &str, place: Place) -> Result<(), PomdpError> {
        let wrong = |sentence: String| Err(PomdpError::new(place, sentence));
        if !self.words.at_part() {
            return wrong(format!(
                "a part such as \"states:\" or \"T:\" should begin here, not {}",
                quoted(part)
            ));
        }
        self.words.word("a part")?;
        let again = match part {
            "discount" => self.head.discount.is_some(),
            "values" => self.head.cost.is_some(),
            "states" => self.head.states.is_some(),
            "actions" => self.head.actions.is_some(),
            "observations" => self.head.observations.is_some(),
            "start" => self.head.start.is_some(),
            _ => false,
        };
        if again {
            return wrong(format!("{part:?} stands here for the second time"));
        }
        if part == "start" {
            return self.start();
        }
        self.words.need_colon(&format!("{part:?}"))?;
        match part {
            "discount" => {
                let (number, place) = self.words.number("the discount")?;
                if !(0.0..=1.0).contains(&number) {
                    let sentence = format!("the discount lies between 0 and 1, not at {number}");
                    return Err(PomdpError::new(place, sentence));
                }
                self.head.discount = Some(number);
            }
            "values" => {
                let word = self.words.word("\"reward\" or \"cost\"")?;
                self.head.cost = Some(match word.text {
                    "reward" => false,
                    "cost" => true,
                    other => {
                        let sentence =
                            format!("values are \"reward\" or \"cost\", not {}", quoted(other));
                        return Err(PomdpError::new(word.place, sentence));
                    }
                });
            }
            "states" => self.head.states = Some(self.names("state", MOST_STATES)?),
            "actions" => self.head.actions = Some(self.names("action", MOST_ACTIONS)?),
            "observations" => {
                self.head.observations = Some(self.names("observation", MOST_OBSERVATIONS)?);
            }
            _ => {
                self.body(place)?;
                match part {
                    "T" => self.transition()?,
                    "O" => self.observation()?,
                    _ => self.reward()?,
                }
            }
        }
        Ok(())
    }

    /// A count, or names up to the next part.
    fn names(&mut self, kind: &str, most: usize) -> Result<Names, PomdpError> {
        let wanted = format!("a number of {kind}s, or their names,");
        if self.words.at_part() {
            return Err(self.words.expected(&wanted, self.words.peek()));
        }
        let first = self.words.word(&wanted)?;
        let too_many = |place| {
            let sentence = format!("more than {most} {kind}s do not fit");
            Err(PomdpError::new(place, sentence))
        };
        if first.text.starts_with(|it: char| it.is_ascii_digit()) {
            let count = first.text.parse::<usize>().unwrap_or(usize::MAX);
            if count == 0 || !first.text.bytes().all(|it| it.is_ascii_digit()) {
                let found = quoted(first.text);
                let sentence = format!("a number of {kind}s is a whole one from 1 on, not {found}");
                return Err(PomdpError::new(first.place, sentence));
            }
            if count > most {
                return too_many(first.place);
            }
            let names: Vec<String> = (0..count).map(|it| format!("{kind}{it}")).collect();
            return Ok(kept(&names));
        }
        let mut names: Vec<&str> = Vec::new();
        let mut word = first;
        loop {
            let letters = |it: char| it.is_alphanumeric() || it == '_' || it == '-';
            let alpha = word.text.starts_with(|it: char| it.is_alphabetic());
            if !alpha || !word.text.chars().all(letters) {
                let found = quoted(word.text);
                let sentence =
                    format!("the name of a {kind} has letters, digits, _ and -, not {found}");
                return Err(PomdpError::new(word.place, sentence));
            }
            if names.contains(&word.text) {
                let sentence = format!("there are two {kind}s {}", quoted(word.text));
                return Err(PomdpError::new(word.place, sentence));
            }
            names.push(word.text);
            if names.len() > most {
                return too_many(word.place);
            }
            if self.words.at_part() {
                return Ok(kept(&names));
            }
            word = self.words.word(&format!("the name of a {kind}"))?;
        }
    }

    fn start(&mut self) -> Result<(), PomdpError> {
        let place = self.words.peek().map_or(self.words.end(), |it| it.place);
        let listed = match self.words.peek().map(|it| it.text) {
            Some(":") => None,
            _ => Some(self.words.word("\"include\" or \"exclude\"")?.text == "include"),
        };
        self.words.need_colon("\"start\"")?;
        let Some(states) = self.head.states else {
            let sentence = "\"states:\" must stand before \"start\"".to_owned();
            return Err(PomdpError::new(place, sentence));
        };
        let count = states.len();
        let mut start = vec![0.0; count];
        if let Some(included) = listed {
            let mut named = vec![false; count];
            while named.iter().all(|it| !it) || !self.words.at_part() {
                match self.which("state", states)? {
                    Some(state) => named[state] = true,
                    None => named.fill(true),
                }
            }
            let in_it = named.iter().filter(|&&it| it == included).count();
            if in_it == 0 {
                let sentence = "no state is left to start in".to_owned();
                return Err(PomdpError::new(place, sentence));
            }
            for (chance, named) in start.iter_mut().zip(named) {
                *chance = f64::from(u8::from(named == included)) / in_it as f64;
            }
            self.head.start = Some(start);
            return Ok(());
        }
        let first = self.words.peek();
        let text = first.map_or("", |it| it.text);
        let place = first.map_or(self.words.end(), |it| it.place);
        if text == "uniform" {
            self.words.word("")?;
            start.fill(1.0 / count as f64);
        } else if states.contains(&text) || (count > 1 && is_single(&self.words, text)) {
            if let Some(state) = self.which("state", states)? {
                start[state] = 1.0;
            }
        } else {
            for chance in &mut start {
                *chance = self.words.probability("a state to start in")?;
            }
            let total = start.iter().fold(0.0, |sum, chance| sum + chance);
            if (total - 1.0).abs() > ROUNDING {
                let sentence = format!("the chances of the start sum up to {total}, not to 1");
                return Err(PomdpError::new(place, sentence));
            }
            for chance in &mut start {
                *chance /= total;
            }
        }
        self.head.start = Some(start);
        Ok(())
    }

    /// Makes the tables when the first chance or reward is met at `place`.
    fn body(&mut self, place: Place) -> Result<(), PomdpError> {
        if self.body.is_some() {
            return Ok(());
        }
        let [states, actions, observations] = self.sizes(place)?;
        let most = states.saturating_mul(states.max(observations));
        if most.saturating_mul(actions) > MOST_CHANCES {
            let sentence = format!(
                "{states} states, {actions} actions and {observations} observations have more \
                 chances than the {MOST_CHANCES} that fit"
            );
            return Err(PomdpError::new(place, sentence));
        }
        self.body = Some(Body {
            sizes: [states, actions, observations],
            transitions: Rows::new(actions * states, states),
            observes: Rows::new(actions * states, observations),
            rewards: Vec::new(),
        });
        Ok(())
    }

    fn sizes(&self, place: Place) -> Result<[usize; 3], PomdpError> {
        let missing = |part: &str| {
            let sentence = format!("\"{part}:\" must stand before chances and rewards");
            PomdpError::new(place, sentence)
        };
        let size = |names: Option<Names>, part| names.map(<[_]>::len).ok_or_else(|| missing(part));
        Ok([
            size(self.head.states, "states")?,
            size(self.head.actions, "actions")?,
            size(self.head.observations, "observations")?,
        ])
    }

    fn close(mut self) -> Result<Pomdp, PomdpError> {
        let end = self.words.end();
        self.body(end)?;
        let (states, actions) = (self.list("state"), self.list("action"));
        let observations = self.list("observation");
        let Some(mut body) = self.body else {
            return Err(PomdpError::new(end, "the file says nothing".to_owned()));
        };
        let count = states.len();
        let row = |row: usize| (actions[row / count], states[row % count]);
        body.transitions.close(end, |it| {
            let (action, state) = row(it);
            format!("action {} in state {}", quoted(action), quoted(state))
        })?;
        body.observes.close(end, |it| {
            let (action, state) = row(it);
            let (action, state) = (quoted(action), quoted(state));
            format!("observations in state {state} after action {action}")
        })?;
        let uniform = || vec![1.0 / count as f64; count];
        Ok(Pomdp {
            states,
            actions,
            observations,
            discount: self.head.discount.unwrap_or(1.0),
            start: self.head.start.unwrap_or_else(uniform),
            transitions: body.transitions.chances,
            observes: body.observes.chances,
            rewards: body.rewards,
        })
    }
}

/// Whether a number stands alone, so that it is the index of a state.
fn is_single(words: &Words<'_>, text: &str) -> bool {
    let mut after = words.clone();
    text.parse::<usize>().is_ok() && after.word("").is_ok() && after.at_part()
}
