//! What commands have in common: how they answer, and the arguments that several take.

use clap::Args;
use planarium::Error;
use planarium::random::{MAX_SEED, random_seed};
use planarium::run::Value;
use planarium_formats::FormatError;
use serde_json::json;
use std::num::NonZeroUsize;

/// The result of a command without an error: true is exit code 0, false is 1.
pub type Answer = Result<bool, Failure>;

/// Why a command cannot answer.
pub enum Failure {
    /// What it was asked is wrong, or a document.
    Library(Error),
    /// A file that is no document.
    Format(FormatError),
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::Library(error)
    }
}

impl From<FormatError> for Failure {
    fn from(error: FormatError) -> Self {
        Self::Format(error)
    }
}

impl std::fmt::Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Library(error) => error.fmt(f),
            Self::Format(error) => error.fmt(f),
        }
    }
}

impl Failure {
    /// The error as it is printed.
    pub fn document(&self) -> serde_json::Value {
        let mut fields = match self {
            Self::Library(error) => {
                json!({ "code": error.code().as_str(), "message": error.message(), "pointer": error.pointer() })
            }
            Self::Format(error) => json!({ "code": error.code().as_str(), "message": error.message(), "pointer": "" }),
        };
        match self {
            Self::Library(error) => {
                if let Some(nearest) = error.nearest() {
                    fields["nearest"] = nearest.into();
                }
            }
            Self::Format(error) => {
                if let Some(file) = error.file() {
                    fields["file"] = file.into();
                }
                if let Some(place) = error.place() {
                    fields["place"] = json!(place);
                }
            }
        }
        json!({ "error": fields })
    }
}

/// The arguments of every command that draws random numbers and has options.
#[derive(Args)]
pub struct Given {
    /// The seed: together with the scenario and all options it decides every bit of the result; "random" draws one, which is
    /// printed with the result
    #[arg(long, value_name = "N|random", default_value_t = 0, allow_negative_numbers = true, value_parser = seed)]
    pub seed: u64,

    /// Set an option; may be repeated; see `planarium list`
    #[arg(long, value_name = "KEY=VALUE", value_parser = setting)]
    pub set: Vec<(String, Value)>,
}

impl Given {
    /// The options, with one that has an argument of its own.
    pub fn parameters(&self, name: &str, value: Option<Value>) -> Vec<(String, Value)> {
        self.set.iter().cloned().chain(value.map(|value| (name.to_owned(), value))).collect()
    }
}

fn setting(text: &str) -> Result<(String, Value), String> {
    match text.split_once('=') {
        Some((key, value)) if !key.is_empty() => Ok((key.to_owned(), Value::from_text(value))),
        _ => Err("a setting reads KEY=VALUE".to_owned()),
    }
}

/// The value of `--seed`.
pub fn seed(text: &str) -> Result<u64, String> {
    if text == "random" {
        return random_seed().map_err(|error| error.to_string());
    }
    let seed = text.parse().ok().filter(|seed| *seed <= MAX_SEED);
    seed.ok_or_else(|| "a seed is an integer from 0 to 2^53 - 1, or \"random\"".to_owned())
}

/// The value of `--threads`.
pub fn threads(text: &str) -> Result<NonZeroUsize, String> {
    let threads = text.parse().ok().filter(|threads: &NonZeroUsize| threads.get() <= 1024);
    threads.ok_or_else(|| "threads are a whole number from 1 to 1024".to_owned())
}

/// A number between commas.
pub fn coordinate(text: &str) -> Result<f64, String> {
    text.trim().parse().map_err(|_| format!("{text:?} is not a number"))
}

/// A name between commas.
#[allow(clippy::unnecessary_wraps, reason = "clap asks for a result")]
pub fn trimmed(text: &str) -> Result<String, String> {
    Ok(text.trim().to_owned())
}
