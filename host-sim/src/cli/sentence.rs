//! What the parser of the command line refuses, in one sentence: the value, where it stands, and what
//! would be allowed there.

use std::error::Error as _;
use std::num::{IntErrorKind, ParseFloatError, ParseIntError};

use clap::CommandFactory;
use clap::error::{ContextKind, ContextValue, Error, ErrorKind};

use super::Cli;

/// The sentence of a refusal.
///
/// ```
/// use clap::Parser;
/// use host_sim::cli::{Cli, sentence};
/// let refused = Cli::try_parse_from(["host-sim", "forage", "--specimens", "many"]).unwrap_err();
/// let said = "--specimens <N> takes a whole number, not \"many\"; see host-sim --help";
/// assert_eq!(sentence(&refused), said);
/// ```
#[must_use]
pub fn sentence(error: &Error) -> String {
    let text = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.clone()),
        Some(ContextValue::Strings(all)) => Some(all.join(", ")),
        _ => None,
    };
    let argument = text(ContextKind::InvalidArg).unwrap_or_default();
    let value = text(ContextKind::InvalidValue).unwrap_or_default();
    let said = match error.kind() {
        ErrorKind::ValueValidation => {
            format!("{argument} takes {}, not {value:?}", allowed(error, &value))
        }
        ErrorKind::InvalidValue if value.is_empty() => format!("{argument} needs a value"),
        ErrorKind::InvalidValue => {
            let known = text(ContextKind::ValidValue).unwrap_or_default();
            format!("{argument} takes {known}, not {value:?}")
        }
        ErrorKind::MissingRequiredArgument => format!("{argument} is missing"),
        ErrorKind::InvalidSubcommand => {
            let name = text(ContextKind::InvalidSubcommand).unwrap_or_default();
            let cli = Cli::command();
            let known: Vec<&str> = cli.get_subcommands().map(clap::Command::get_name).collect();
            format!("{name:?} is no command: there are {}", known.join(", "))
        }
        _ => first_line(error),
    };
    let meant = text(ContextKind::SuggestedArg).or_else(|| text(ContextKind::SuggestedSubcommand));
    let meant = meant.map(|it| format!("; did you mean {it}?"));
    format!("{said}{}; see host-sim --help", meant.unwrap_or_default())
}

/// What would be a value in the place of this one.
fn allowed(error: &Error, value: &str) -> String {
    let Some(why) = error.source() else {
        return "another value".to_owned();
    };
    if why.is::<ParseFloatError>() {
        "a number".to_owned()
    } else if let Some(why) = why.downcast_ref::<ParseIntError>() {
        match why.kind() {
            _ if value.starts_with('-') => "a whole number from 0 on".to_owned(),
            IntErrorKind::PosOverflow => "a smaller whole number".to_owned(),
            _ => "a whole number".to_owned(),
        }
    } else {
        // Such as "4000000000 is not in 0..=4294967295", of which the end is the answer.
        let why = why.to_string();
        let range = why.split_once(" is not in ").map(|(_, range)| range);
        range.map_or(why.clone(), |range| format!("a whole number in {range}"))
    }
}

fn first_line(error: &Error) -> String {
    let text = error.to_string();
    let line = text.lines().next().unwrap_or("nothing to do");
    line.trim_start_matches("error: ").to_owned()
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::{Cli, sentence};

    #[test]
    fn a_refusal_names_the_value_and_what_is_allowed() {
        for (arguments, said) in [
            (
                "forage --specimens many",
                "--specimens <N> takes a whole number, not \"many\"",
            ),
            (
                "forage --specimens -1",
                "takes a whole number from 0 on, not \"-1\"",
            ),
            (
                "forage --specimens 18446744073709551616",
                "takes a smaller whole number, not \"18446744073709551616\"",
            ),
            (
                "forage --actions -1000",
                "takes a whole number in 0..=4294967295, not \"-1000\"",
            ),
            (
                "forage --radius wide",
                "--radius <M> takes a number, not \"wide\"",
            ),
            ("forage --radios 5", "; did you mean --radius?"),
            ("forage --seeds", "--seeds <A..B> needs a value"),
            ("export a.brain", "--json is missing"),
            ("diff a.brain", "<AFTER> is missing"),
            ("sweep --shard 0/2", "--out <DIR> is missing"),
            (
                "fly",
                "\"fly\" is no command: there are forage, calibrate, ",
            ),
            ("forrage", "; did you mean forage?"),
            (
                "forage --force --resume --out a",
                "'--force' cannot be used with '--resume'",
            ),
        ] {
            let words = ["host-sim"].into_iter().chain(arguments.split(' '));
            let refused = Cli::try_parse_from(words).unwrap_err();
            let sentence = sentence(&refused);
            assert!(sentence.contains(said), "{arguments}: {sentence}");
            assert!(
                !sentence.contains('\n') && !sentence.contains("error"),
                "{sentence}"
            );
        }
    }
}
