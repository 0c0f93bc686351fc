//! `planarium generate`: scenarios by seed.

use crate::arguments::Generate;
use crate::{Answer, files};
use planarium::run::Value;
use planarium::scenario::generate::generate_with;

pub fn generate(arguments: &Generate) -> Answer {
    let options = arguments.given.parameters("seed", Some(Value::Number(arguments.given.seed as f64)));
    let scenario = generate_with(&arguments.kind, &options)?;
    files::write(&scenario.to_json_string(), arguments.out.as_deref())?;
    Ok(true)
}
