//! `planarium generate`: scenarios by seed.

use crate::Answer;
use crate::arguments::Generate;
use crate::files;
use planarium::run::Value;
use planarium::scenario::{Node, generate};

/// Generates a scenario and prints its document.
pub fn generate(arguments: &Generate) -> Answer {
    let set = arguments.set.iter().map(|(key, value)| (key.clone(), node(value)));
    let seed = [("seed".to_owned(), Node::Number(arguments.seed as f64))];
    let scenario = generate::generate(&arguments.kind, &Node::Object(set.chain(seed).collect()))?;
    files::write(&scenario.to_json_string(), arguments.out.as_deref())?;
    Ok(true)
}

/// The value of an option as a node of a document.
fn node(text: &str) -> Node {
    match Value::from_text(text) {
        Value::Number(number) => Node::Number(number),
        Value::Text(text) => Node::String(text),
        Value::Boolean(yes) => Node::Bool(yes),
    }
}
