//! `planarium generate`: scenarios, fleets and navigation tasks by seed.

use crate::arguments::Generate;
use crate::{Answer, files};
use planarium::fleet::{self, fleet_generators};
use planarium::navigation::{self, navigation_generators};
use planarium::options::Info;
use planarium::run::Value;
use planarium::worlds::generate_with;

pub fn generate(arguments: &Generate) -> Answer {
    let options = arguments.given.parameters("seed", Some(Value::Number(arguments.given.seed as f64)));
    let is_one_of = |infos: Vec<Info>| infos.iter().any(|info| info.id == arguments.kind);
    let document = if is_one_of(navigation_generators()) {
        navigation::generate_with(&arguments.kind, &options)?.to_json_string()
    } else if is_one_of(fleet_generators()) {
        fleet::generate_with(&arguments.kind, &options)?.to_json_string()
    } else {
        generate_with(&arguments.kind, &options)?.to_json_string()
    };
    files::write(&document, arguments.out.as_deref())?;
    Ok(true)
}
