//! `planarium generate`: scenarios by seed.

use crate::arguments::Generate;
use crate::{Answer, files};
use planarium::Error;
use planarium::error::Code;
use planarium::run::Value;
use planarium::scenario::generate;
use serde_json::{Map, json};

pub fn generate(arguments: &Generate) -> Answer {
    let mut options = Map::from_iter([("seed".to_owned(), json!(arguments.given.seed))]);
    for (key, value) in &arguments.given.set {
        let refused = |code, sentence: String| Err(Error::new(code, format!("/{key}"), sentence));
        let value = match value {
            Value::Number(number) if !number.is_finite() => {
                return refused(Code::NotFinite, format!("{key} must be a finite number, not {number}"));
            }
            Value::Number(number) => json!(number),
            Value::Text(text) => json!(text),
            Value::Boolean(yes) => json!(yes),
            Value::Other(_) => json!(null),
        };
        if options.insert(key.clone(), value).is_some() {
            return refused(Code::DuplicateField, format!("{key} is given twice"));
        }
    }
    let scenario = generate::generate(&arguments.kind, &options.into())?;
    files::write(&scenario.to_json_string(), arguments.out.as_deref())?;
    Ok(true)
}
