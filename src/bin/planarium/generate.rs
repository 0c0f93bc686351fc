//! `planarium generate`: scenarios by seed.

use crate::Answer;
use crate::arguments::Generate;
use crate::files;
use planarium::Error;
use planarium::error::Code;
use planarium::run::Value;
use planarium::scenario::generate;
use serde_json::{Map, json};

/// Generates a scenario and prints its document.
pub fn generate(arguments: &Generate) -> Answer {
    let mut options = Map::new();
    for (key, value) in arguments.set.iter().map(|(key, value)| (key, Value::from_text(value))) {
        let pointer = || format!("/{key}");
        if let Value::Number(number) = value
            && !number.is_finite()
        {
            let sentence = format!("{key} must be a finite number, not {number}");
            return Err(Error::new(Code::NotFinite, pointer(), sentence));
        }
        let value = match value {
            Value::Number(number) => json!(number),
            Value::Text(text) => json!(text),
            Value::Boolean(yes) => json!(yes),
            Value::Other(_) => json!(null),
        };
        if key == "seed" || options.insert(key.clone(), value).is_some() {
            return Err(Error::new(Code::DuplicateField, pointer(), format!("{key} is given twice")));
        }
    }
    options.insert("seed".to_owned(), json!(arguments.seed));
    let scenario = generate::generate(&arguments.kind, &options.into())?;
    files::write(&scenario.to_json_string(), arguments.out.as_deref())?;
    Ok(true)
}
