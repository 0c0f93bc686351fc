//! `planarium time`: the fastest timing of the path of a result within limits.

use crate::arguments::Answer;
use crate::files;
use crate::kind::Kind;
use crate::output::Destination;
use crate::world::{self, WorldOptions};
use clap::Args;
use planarium::path::{self, ResultDocument};
use planarium::timing::{self, LimitOptions};

#[derive(Args)]
#[command(after_help = "\
Prints a trajectory document, planarium-trajectory-1: the pieces of the path, and when the robot is where on each. It begins and ends at rest,
and rests in between at corners without a blend (plan with --set blend=0.5), and where a car changes its direction. No limit is exceeded at any time.
With --differential a configuration is x, y and the heading.
Exit codes: 0 the path is timed; 2 the input is wrong, or the path is not valid.

Examples:
  planarium plan arm.json --set shortcut=100 --set blend=0.5 --out result.json
  planarium time arm.json result.json --speed 1 --acceleration 2 --out trajectory.json
  planarium time arm.json result.json --speed 1,1,2 --acceleration 2,2,4
  planarium time body.json result.json --speed 0.5 --acceleration 1 --turn-rate 1 --turn-acceleration 2
  planarium time room.json result.json --differential --speed 0.5 --acceleration 1 --turn-rate 2 --turn-acceleration 4
  planarium verify arm.json result.json --trajectory trajectory.json")]
pub struct Arguments {
    /// The scenario, a JSON file, or a map with the options that it was planned with; - reads it from standard input
    file: String,

    /// The result document; - reads it from standard input
    result: String,

    /// The greatest speed: of every joint of an arm, in radians or metres per second; in the plane, of a disc, a body or a car.
    /// Or of each coordinate by itself, in order
    #[arg(long, value_name = "V[,V...]", value_delimiter = ',', required = true, allow_negative_numbers = true)]
    speed: Vec<f64>,

    /// The greatest acceleration, of the same; of a car along its path
    #[arg(long, value_name = "A[,A...]", value_delimiter = ',', required = true, allow_negative_numbers = true)]
    acceleration: Vec<f64>,

    /// Of a body, and of a disc with --differential, the greatest turn rate, in radians per second
    #[arg(long, value_name = "W", allow_negative_numbers = true)]
    turn_rate: Option<f64>,

    /// Of the same, the greatest acceleration of the turn, in radians per second squared
    #[arg(long, value_name = "A", allow_negative_numbers = true)]
    turn_acceleration: Option<f64>,

    /// Of a car, the greatest acceleration across its path, in metres per second squared [default: none]
    #[arg(long, value_name = "A", allow_negative_numbers = true)]
    lateral_acceleration: Option<f64>,

    /// A disc is a robot with two driven wheels: it drives straight edges forward and turns on the spot at each corner, without
    /// blends
    #[arg(long)]
    differential: bool,

    #[command(flatten)]
    destination: Destination,

    #[command(flatten)]
    world: WorldOptions,
}

/// Times the path and prints the trajectory.
pub fn time(arguments: &Arguments) -> Answer {
    let (outputs, out) = arguments.destination.beside([&*arguments.file, &*arguments.result], Kind::TRAJECTORY)?;
    let other = Some(("result", &*arguments.result));
    let scenario = world::scenario(&arguments.file, other, &arguments.world, &outputs)?;
    let result = ResultDocument::parse(&files::read(&arguments.result)?)?;
    let options = LimitOptions {
        speed: arguments.speed.clone(),
        acceleration: arguments.acceleration.clone(),
        turn_rate: arguments.turn_rate,
        turn_acceleration: arguments.turn_acceleration,
        lateral_acceleration: arguments.lateral_acceleration,
        differential: arguments.differential,
    };
    let limits = options.limits(scenario.robot())?;
    path::verify(&scenario, &result)?.required()?;
    let trajectory = timing::time(&scenario, &result, &limits)?;
    out.write(&trajectory.to_json())?;
    let (duration, rests) = (trajectory.duration(), trajectory.rests());
    files::say(&format!("{duration:.6} s, {} pieces, {rests} rests on the way", trajectory.pieces().len()));
    Ok(true)
}
