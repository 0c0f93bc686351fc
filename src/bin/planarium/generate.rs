//! `planarium generate`: scenarios and fleets by seed.

use crate::arguments::Generate;
use crate::{Answer, files};
use planarium::fleet::{self, fleet_generators};
use planarium::run::Value;
use planarium::scenario::generate::generate_with;

pub fn generate(arguments: &Generate) -> Answer {
    let options = arguments.given.parameters("seed", Some(Value::Number(arguments.given.seed as f64)));
    let is_fleet = fleet_generators().iter().any(|info| info.id == arguments.kind);
    let document = if is_fleet {
        fleet::generate_with(&arguments.kind, &options)?.to_json_string()
    } else {
        generate_with(&arguments.kind, &options)?.to_json_string()
    };
    files::write(&document, arguments.out.as_deref())?;
    Ok(true)
}
