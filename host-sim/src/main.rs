//! The command line of the simulator: what was asked for is checked, run, shown and written.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use host_sim::cli::{Cli, Command, Errand, sentence};
use host_sim::experiment::sweep;
use host_sim::failure::{Failure, Impossible};
use host_sim::keeping;
use host_sim::logs;
use host_sim::options::{self, Order};
use host_sim::progress::Progress;
use host_sim::report::{Circumstances, Journal, Output};
use host_sim::teaching;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) if error.use_stderr() => return refuse(&sentence(&error)),
        Err(help) => {
            // Help goes to standard output; nothing is left to do when that is closed.
            let _ = help.print();
            return ExitCode::SUCCESS;
        }
    };
    if let Some(Command::Errand(errand)) = &cli.command {
        return do_errand(errand);
    }
    let ready = Order::new(&cli).and_then(|order| {
        order.plan.look_for_tools()?;
        Ok(order)
    });
    match ready {
        Ok(order) => run(&order).unwrap_or_else(|failure| fail(&failure)),
        Err(impossible) => refuse(&impossible.to_string()),
    }
}

/// What is done with one brain.
fn do_errand(errand: &Errand) -> ExitCode {
    let done = match errand {
        Errand::Inspect { file, most, page } => keeping::inspect(file, *most, page.as_deref()),
        Errand::Diff {
            before,
            after,
            most,
        } => keeping::diff(before, after, *most),
        Errand::Replay { file, page } => {
            let beside = file.with_extension("html");
            logs::replayed(file, page.as_deref().unwrap_or(&beside))
        }
        Errand::Export { file, out, .. } => keeping::export(file, out.as_deref()),
        Errand::Merge { shards, out, force } => merged(shards, out, *force),
        Errand::Teach(args) => ordered(options::teaching(args), teaching::taught),
        Errand::Size(args) => ordered(options::sizing(args), keeping::size),
        Errand::Train(args) => ordered(options::training(args), keeping::train),
    };
    match done.and_then(|text| say(&text)) {
        Ok(()) => ExitCode::SUCCESS,
        // Shards that do not fit, or a log that cannot be, are options that cannot be.
        Err(failure) if failure.is::<Impossible>() => refuse(&failure.to_string()),
        Err(failure) => fail(&failure),
    }
}

/// Does what was asked for, where it can be.
fn ordered<O>(
    order: Result<O, Impossible>,
    done: fn(&O) -> Result<String, Failure>,
) -> Result<String, Failure> {
    done(&order?)
}

/// Puts shards together and writes what comes of them.
fn merged(shards: &[PathBuf], out: &Path, force: bool) -> Result<String, Failure> {
    if out.join(Output::SUMMARY).exists() && !force {
        let sentence = format!("{} holds a run already: --force replaces it", out.display());
        return Err(Impossible::new(sentence).into());
    }
    let mut results = sweep::merge(shards)?;
    let circumstances = Circumstances::begin();
    results.summary.command = command_line();
    results.summary.commit = circumstances.commit().map(str::to_owned);
    let output = Output::prepare(out)?;
    results.write(&output)?;
    Ok(results.brief(output.directory()))
}

/// The command, without how often it was begun and what is printed.
fn command_line() -> String {
    let arguments = std::env::args_os().skip(1);
    let arguments = arguments.map(|it| it.display().to_string());
    let arguments: Vec<_> = arguments
        .filter(|it| !["--resume", "--force", "--table"].contains(&it.as_str()))
        .collect();
    format!("host-sim {}", arguments.join(" "))
}

/// Shows a text to whoever still reads along.
fn say(text: &str) -> Result<(), Failure> {
    match writeln!(std::io::stdout(), "{text}") {
        // Whoever read along has seen enough.
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
        written => Ok(written?),
    }
}

fn run(order: &Order) -> Result<ExitCode, Failure> {
    let circumstances = Circumstances::begin();
    let mut progress = Progress::of_program()?;
    if let Some(folder) = &order.brains {
        progress = progress.keeping_brains(folder)?;
    }
    let (output, journal) = order.place.open()?;
    let go_on = order.go_on(output.directory());
    let mut results = match order.run(&progress, &journal) {
        Err(failure) if progress.stopped().is_some() => {
            return interrupted(&progress, &format!("{failure}; {go_on}"));
        }
        done => done?,
    };
    results.summary.command = command_line();
    results.summary.commit = circumstances.commit().map(str::to_owned);
    let circumstances = circumstances.to_json(&results.summary.command);
    output.write(Circumstances::NAME, circumstances.as_bytes())?;
    results.write(&output)?;
    let mut text = match (&results.story, order.table) {
        (_, true) => results.text(),
        (Some(story), false) => format!("{story}\n"),
        (None, false) => String::new(),
    };
    if !text.is_empty() {
        text.push('\n');
    }
    text.push_str(&results.brief(output.directory()));
    say(&text)?;
    if let Some(how_far) = results.summary.parameters.get(Journal::UNFINISHED) {
        let how_far = how_far.as_str().unwrap_or_default();
        let sentence = format!("interrupted: the summary is of {how_far}; {go_on}");
        return interrupted(&progress, &sentence);
    }
    match results.over_budget {
        Some(why) => Err(why.into()),
        None => Ok(ExitCode::SUCCESS),
    }
}

/// What ends with a signal ends with its number, as shells have it.
fn interrupted(progress: &Progress, sentence: &str) -> Result<ExitCode, Failure> {
    eprintln!("host-sim: {sentence}");
    Ok(ExitCode::from(128 + progress.stopped().unwrap_or_default()))
}

fn refuse(sentence: &str) -> ExitCode {
    eprintln!("host-sim: {sentence}");
    ExitCode::from(2)
}

fn fail(failure: &Failure) -> ExitCode {
    eprintln!("host-sim: {failure}");
    ExitCode::FAILURE
}
