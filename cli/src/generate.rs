//! `planarium generate`: scenarios, fleets and navigation tasks by seed.

use crate::arguments::{Answer, Given};
use crate::kind::Kind;
use crate::output::Destination;
use clap::Args;
use planarium::fleet::{self, fleet_generators};
use planarium::navigation::{self, navigation_generators};
use planarium::options::Info;
use planarium::run::Value;
use planarium::worlds::generate_with;

#[derive(Args)]
#[command(after_help = "\
`planarium list` describes the generators and their options. With --set ensure=path (or no-path) scenarios are drawn
again until a path is known (or until it is proven that none exists).

Examples:
  planarium generate forest --set links=4 --seed 1
  planarium generate maze --set difficulty=hard --seed 3
  planarium generate clutter --set robot=arm --set links=3 --seed 2 --out clutter.json
  planarium generate discs --set robot=arm --set count=12 --set ensure=path")]
pub struct Arguments {
    /// The generator: forest, clutter, discs, maze, gap or bug-trap; or swap, corridor, crossroads, ring or hall, which make
    /// fleets; or rooms or furnished, which make navigation tasks
    kind: String,

    #[command(flatten)]
    given: Given,

    #[command(flatten)]
    destination: Destination,
}

pub fn generate(arguments: &Arguments) -> Answer {
    let options = arguments.given.parameters("seed", Some(Value::Number(arguments.given.seed as f64)));
    let is_one_of = |infos: Vec<Info>| infos.iter().any(|info| info.id == arguments.kind);
    let (is_navigation, is_fleet) = (is_one_of(navigation_generators()), is_one_of(fleet_generators()));
    let kind = match (is_navigation, is_fleet) {
        (true, _) => Kind::NAVIGATION,
        (_, true) => Kind::FLEET,
        _ => Kind::SCENARIO,
    };
    let (_, out) = arguments.destination.beside([], kind)?;
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
