//! `planarium schema`: the JSON Schemas of documents.

use crate::arguments::Answer;
use crate::files;
use clap::{Args, ValueEnum};

#[derive(Args)]
pub struct Arguments {
    /// The kind of document
    #[arg(value_enum, default_value_t = Document::Scenario)]
    document: Document,
}

#[derive(Clone, Copy, ValueEnum)]
enum Document {
    Scenario,
    Experiment,
    Fleet,
    Navigation,
}

/// Prints the schema.
pub fn schema(arguments: &Arguments) -> Answer {
    let schema = match arguments.document {
        Document::Scenario => planarium::scenario::schema(),
        Document::Experiment => planarium::experiment::schema(),
        Document::Fleet => planarium::fleet::schema(),
        Document::Navigation => planarium::navigation::schema(),
    };
    files::print(&format!("{schema:#}"))?;
    Ok(true)
}
