//! `planarium generate`: scenarios, fleets and navigation tasks by seed.

use crate::Answer;
use crate::arguments::Generate;
use crate::output::{Kind, Outputs};
use planarium::fleet::{self, fleet_generators};
use planarium::navigation::{self, navigation_generators};
use planarium::options::Info;
use planarium::run::Value;
use planarium::worlds::generate_with;

pub fn generate(arguments: &Generate) -> Answer {
    let options = arguments.given.parameters("seed", Some(Value::Number(arguments.given.seed as f64)));
    let is_one_of = |infos: Vec<Info>| infos.iter().any(|info| info.id == arguments.kind);
    let (is_navigation, is_fleet) = (is_one_of(navigation_generators()), is_one_of(fleet_generators()));
    let kind = match (is_navigation, is_fleet) {
        (true, _) => Kind::NAVIGATION,
        (_, true) => Kind::FLEET,
        _ => Kind::SCENARIO,
    };
    let out = Outputs::beside([], arguments.force).add(arguments.out.as_deref(), kind)?;
    let document = if is_navigation {
        navigation::generate_with(&arguments.kind, &options)?.to_json_string()
    } else if is_fleet {
        fleet::generate_with(&arguments.kind, &options)?.to_json_string()
    } else {
        generate_with(&arguments.kind, &options)?.to_json_string()
    };
    out.write(&document)?;
    Ok(true)
}
