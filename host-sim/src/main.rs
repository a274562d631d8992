//! The command line of the simulator: what was asked for is checked, run, shown and written.

use std::io::Write;
use std::process::ExitCode;

use clap::Parser;
use host_sim::cli::Cli;
use host_sim::failure::Failure;
use host_sim::options::Order;
use host_sim::progress::Progress;
use host_sim::report::Output;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) if error.use_stderr() => return refuse(&one_sentence(&error.to_string())),
        Err(help) => {
            // Help goes to standard output; nothing is left to do when that is closed.
            let _ = help.print();
            return ExitCode::SUCCESS;
        }
    };
    match Order::new(&cli) {
        Ok(order) => run(&order).map_or_else(|failure| fail(&failure), |()| ExitCode::SUCCESS),
        Err(impossible) => refuse(&impossible.to_string()),
    }
}

fn run(order: &Order) -> Result<(), Failure> {
    let output = Output::prepare(&order.out)?;
    let mut results = order.run(&Progress::on_terminal())?;
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    results.summary.command = format!("host-sim {}", arguments.join(" "));
    let paths = results.write(&output)?;
    let mut text = results.text();
    paths
        .iter()
        .for_each(|path| text.push_str(&format!("\nwrote {}", path.display())));
    match writeln!(std::io::stdout(), "{text}") {
        // Whoever read along has seen enough.
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => {}
        written => written?,
    }
    results.over_budget.map_or(Ok(()), |why| Err(why.into()))
}

/// The first line of what the parser of the command line says, which is the whole of its point.
fn one_sentence(message: &str) -> String {
    let line = message.lines().next().unwrap_or("nothing to do");
    let line = line.trim_start_matches("error: ");
    format!("{line}; see host-sim --help")
}

fn refuse(sentence: &str) -> ExitCode {
    eprintln!("host-sim: {sentence}");
    ExitCode::from(2)
}

fn fail(failure: &Failure) -> ExitCode {
    eprintln!("host-sim: {failure}");
    ExitCode::FAILURE
}
