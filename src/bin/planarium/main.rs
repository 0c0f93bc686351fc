//! The command line: plan, fleet, train, navigate, compare, optimum, certify, verify, sweep, nearest, list, generate, reach, trajectories.
//!
//! JSON goes to standard output, messages and the progress bar to standard error. Exit code 0 means solved or valid, 1 not
//! solved or not valid, 2 that the input is wrong; then standard output contains `{"error": {"code", "message", "pointer"}}`.
#![deny(unsafe_code)]
#![deny(clippy::unwrap_used)]

mod arguments;
mod certify;
mod files;
mod fleet;
mod generate;
mod list;
mod navigation;
mod nearest;
mod npy;
mod optimum;
mod output;
mod plan;
mod reach;
mod sweep;
mod trajectories;
mod verify;

use arguments::{Arguments, Command};
use clap::Parser;
use planarium::Error;
use planarium::error::Code;
use std::process::ExitCode;

/// The result of a command without an error: true is exit code 0, false is 1.
type Answer = Result<bool, Error>;

fn main() -> ExitCode {
    let answer = match Arguments::try_parse() {
        Ok(arguments) => run(&arguments.command),
        Err(error) if !error.use_stderr() => {
            // Help or version, as requested. A closed pipe is not an error.
            let _ = error.print();
            return ExitCode::SUCCESS;
        }
        Err(error) => {
            let _ = error.print();
            return report(&usage(&error));
        }
    };
    match answer {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(error) => {
            files::say(&format!("error: {error}"));
            report(&error)
        }
    }
}

fn run(command: &Command) -> Answer {
    match command {
        Command::Plan(arguments) => plan::plan(arguments),
        Command::Certify(arguments) => certify::certify(arguments),
        Command::Fleet(arguments) => fleet::fleet(arguments),
        Command::Train(arguments) => navigation::train(arguments),
        Command::Navigate(arguments) => navigation::navigate(arguments),
        Command::Compare(arguments) => navigation::compare(arguments),
        Command::Reach(arguments) => reach::reach(arguments),
        Command::Verify(arguments) => verify::verify(arguments),
        Command::Optimum(arguments) => optimum::optimum(arguments),
        Command::Sweep(arguments) => sweep::sweep(arguments),
        Command::Nearest(arguments) => nearest::nearest(arguments),
        Command::List(arguments) => list::list(arguments),
        Command::Generate(arguments) => generate::generate(arguments),
        Command::Trajectories(arguments) => trajectories::trajectories(arguments),
        #[cfg(feature = "schema")]
        Command::Schema(arguments) => {
            let schema = match arguments.document {
                arguments::Document::Scenario => planarium::scenario::schema(),
                arguments::Document::Experiment => planarium::experiment::schema(),
                arguments::Document::Fleet => planarium::fleet::schema(),
                arguments::Document::Navigation => planarium::navigation::schema(),
            };
            files::print(&format!("{schema:#}")).map(|()| true)
        }
    }
}

/// The error for arguments that clap refuses: its first sentence, without the decoration.
fn usage(error: &clap::Error) -> Error {
    let text = error.to_string();
    let sentence = text.lines().next().unwrap_or_default().trim_start_matches("error: ");
    let sentence = match error.kind() {
        clap::error::ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => "a command is missing",
        _ => sentence,
    };
    Error::new(Code::Usage, "", sentence)
}

/// Prints the error as JSON; exit code 2.
fn report(error: &Error) -> ExitCode {
    let mut fields = serde_json::json!({
        "error": { "code": error.code().as_str(), "message": error.message(), "pointer": error.pointer() }
    });
    if let Some(nearest) = error.nearest() {
        fields["error"]["nearest"] = nearest.into();
    }
    if let Err(unwritten) = files::print(&fields.to_string()) {
        files::say(&format!("error: {unwritten}"));
    }
    ExitCode::from(2)
}
