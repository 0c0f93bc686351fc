//! `planarium widest`: how wide a robot may be to pass; and `planarium safest`: the path of the widest.

use crate::arguments::Answer;
use crate::files;
use crate::kind::Kind;
use crate::output::Destination;
use crate::world::{self, WorldOptions};
use clap::Args;
use planarium::json;
use planarium::optimum::{Limit, Widest, safest, widest};
use planarium::problem::Touched;

/// What `planarium safest --help` ends with.
pub const SAFEST: &str = "\
Prints what `planarium widest` does, and {\"clearance\", \"length\", \"path\"}. No path from the start to the goal keeps farther from all obstacles
and from the bounds than the widest disc that passes, and this is the shortest that keeps as far: \"clearance\" is its distance. The radius
and the margin of the scenario's own disc do not matter. If not even a point passes, the path is empty.
Exit codes: 0 there is a path; 1 there is none; 2 the input is wrong.

Examples:
  planarium safest discs.json --query across
  planarium safest map.yaml --start 1,1 --goal 8,5";

#[derive(Args)]
#[command(after_help = "\
Prints {\"radius\", \"limit\", \"bottleneck\", \"between\", ...}. Narrower discs have a path from the start to the goal, wider ones have none;
the radius and the margin of the scenario's own disc do not matter. It is limited by the room at the \"start\" or at the \"goal\", or by a
\"gap\": \"bottleneck\" has its two ends, \"between\" the obstacles there. If not even a point passes, the radius is null.
Exit codes: 0 a disc passes; 1 none does; 2 the input is wrong.

Examples:
  planarium widest discs.json --query across
  planarium widest map.yaml --start 1,1 --goal 8,5")]
pub struct Arguments {
    /// The scenario, a JSON file, or a map (see `planarium import`); - reads it from standard input
    file: String,

    /// The query, by name [default: the first of the scenario]
    #[arg(long, value_name = "NAME")]
    query: Option<String>,

    #[command(flatten)]
    destination: Destination,

    #[command(flatten)]
    world: WorldOptions,
}

/// Prints the widest disc; true if one of a positive radius passes.
pub fn print(arguments: &Arguments) -> Answer {
    let (outputs, out) = arguments.destination.beside([&*arguments.file], Kind::WIDEST)?;
    let scenario = world::scenario(&arguments.file, None, &arguments.world, &outputs)?;
    let found = widest(&scenario, arguments.query.as_deref())?;
    files::say(&message(&found));
    out.write(&json::to_string(&found))?;
    Ok(found.radius.is_some_and(|radius| radius > 0.0))
}

/// Prints the safest path; true if there is one.
pub fn print_safest(arguments: &Arguments) -> Answer {
    let (outputs, out) = arguments.destination.beside([&*arguments.file], Kind::WIDEST)?;
    let scenario = world::scenario(&arguments.file, None, &arguments.world, &outputs)?;
    let found = safest(&scenario, arguments.query.as_deref())?;
    let length = found.length.map_or(String::new(), |length| format!("; the safest path has length {length:.6}"));
    files::say(&(message(&found.widest) + &length));
    out.write(&json::to_string(&found))?;
    Ok(found.length.is_some())
}

/// The result for people.
fn message(found: &Widest) -> String {
    let Some((radius, [[x, y], [u, v]])) = found.radius.zip(found.bottleneck) else {
        return "there is no free path, not even for a point: obstacles in contact separate start and goal".to_owned();
    };
    let name = |with: &Touched| match with {
        Touched::Bounds => "the bounds".to_owned(),
        Touched::Obstacle(i) => format!("obstacle {i}"),
    };
    let names = found.between.iter().map(name).collect::<Vec<_>>().join(" and ");
    let by = match found.limit {
        Limit::Start => format!("{names} beside the start"),
        Limit::Goal => format!("{names} beside the goal"),
        _ => format!("the gap from ({x:.3}, {y:.3}) to ({u:.3}, {v:.3}), of {names}"),
    };
    format!("the widest disc that passes has a radius of {radius:.6} m; it is limited by {by}")
}
