//! The arguments, with their help.

use clap::{Args, Parser, Subcommand, ValueEnum};
use planarium::random::{MAX_SEED, random_seed};

/// Motion planning that a person can watch: stepping planners with proven edges.
#[derive(Parser)]
#[command(
    name = "planarium",
    version,
    about,
    max_term_width = 110,
    arg_required_else_help = true,
    after_help = "\
JSON goes to standard output, messages to standard error.
Exit codes: 0 solved or valid; 1 not solved or not valid; 2 the input is wrong, and standard output
holds {\"error\": {\"code\", \"message\", \"pointer\"}}. `planarium list` tells what the codes mean.

Examples:
  planarium generate forest --set links=3 --seed 4 --out forest.json
  planarium plan forest.json --planner prm --set samples=700 --set k=30 --out result.json
  planarium verify forest.json result.json"
)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    /// Plan a path for one query of a scenario and print the result document
    Plan(Plan),
    /// Find joint angles that bring the tip of an arm to a target and print the result document
    Reach(Reach),
    /// Judge a result against its scenario, independently of the planners
    Verify(Verify),
    /// Find the configurations nearest to a target, among those of a list or drawn by seed
    Nearest(Nearest),
    /// List the planners and the indexes with their parameters, the generators with their options, and the error codes
    List(List),
    /// Generate a scenario by seed and print it
    Generate(Generate),
    /// Add random trajectories of particles one by one, none of which crosses another, and print counts
    Trajectories(Trajectories),
    /// Print the JSON Schema of scenarios
    #[cfg(feature = "schema")]
    Schema,
}

#[derive(Args)]
#[command(after_help = "\
Exit codes: 0 solved; 1 exhausted, or still running when the time was up; 2 the input is wrong.

Examples:
  planarium plan arm.json
  planarium plan arm.json --query report --planner prm --set samples=700 --set k=30 --seed 7
  planarium generate clutter --seed 3 | planarium plan - --set shortcut=200 --max-seconds 2
  planarium plan arm.json --planner prm --save-roadmap arm.roadmap
  planarium plan arm.json --roadmap arm.roadmap --query another")]
pub struct Plan {
    /// The scenario, a JSON file; - reads it from standard input
    pub file: String,

    /// The query to answer, by name [default: the first of the scenario]
    #[arg(long, value_name = "NAME")]
    pub query: Option<String>,

    /// The planner, by id; `planarium list` shows them all [default: rrt-connect, of a car rrt-control; with a roadmap the one that built it]
    #[arg(long, value_name = "ID")]
    pub planner: Option<String>,

    /// The seed: with scenario, planner and parameters it decides every bit of the result; "random" draws one, which the result tells
    #[arg(long, value_name = "N|random", default_value_t = 0, allow_negative_numbers = true, value_parser = seed)]
    pub seed: u64,

    /// Set a parameter of the planner; may be repeated
    #[arg(long, value_name = "KEY=VALUE", value_parser = setting)]
    pub set: Vec<(String, String)>,

    /// Give up after so many iterations; the same as --set max_iterations=N
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub max_iterations: Option<u64>,

    /// Stop after so many seconds with status "running"; the result tells the iterations made
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = seconds)]
    pub max_seconds: Option<f64>,

    /// Go on with a roadmap that was saved for the same world and robot, proven again, instead of building one; - reads it
    /// from standard input
    #[arg(long, value_name = "FILE")]
    pub roadmap: Option<String>,

    /// Save the roadmap, as far as it is built when the run ends (prm, prm-star and visibility-prm)
    #[arg(long, value_name = "FILE")]
    pub save_roadmap: Option<String>,

    /// How to save it [default: json for FILE.json, graphml for FILE.graphml, else binary]; graphml is for other programs
    #[arg(long, value_name = "FORMAT", requires = "save_roadmap")]
    pub roadmap_format: Option<RoadmapFormat>,

    /// Write the result to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    pub out: Option<String>,
}

#[derive(Args)]
#[command(after_help = "\
Where the target is out of reach, the result tells why, and the nearest point that can be reached.
Exit codes: 0 reached; 1 not reached; 2 the input is wrong.

Examples:
  planarium reach arm.json --target 1.2,0.4
  planarium reach arm.json --target 1.2,0.4 --orientation 0.5 --method newton --seed 3
  planarium reach arm.json --target=-0.5,1 --solutions 4 --set free_only=true")]
pub struct Reach {
    /// The scenario, a JSON file; - reads it from standard input
    pub file: String,

    /// Where the tip is to be, in metres
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, value_parser = point)]
    pub target: [f64; 2],

    /// The absolute angle that the last link is to have, in radians [default: any]
    #[arg(long, value_name = "PHI", allow_negative_numbers = true)]
    pub orientation: Option<f64>,

    /// The method, by id; `planarium list` shows them all [default: damped-least-squares]
    #[arg(long, value_name = "ID")]
    pub method: Option<String>,

    /// The joint angles to start from, in radians [default: the start of the first query, else 0 as far as limits allow]
    #[arg(long, value_name = "Q1,Q2,..", allow_hyphen_values = true, value_parser = angles)]
    pub start: Option<Angles>,

    /// The seed of further starts: with all else it decides every bit of the result; "random" draws one, which the result tells
    #[arg(long, value_name = "N|random", default_value_t = 0, allow_negative_numbers = true, value_parser = seed)]
    pub seed: u64,

    /// How many distinct solutions to look for; the same as --set solutions=N
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub solutions: Option<u64>,

    /// Set a parameter of the method; may be repeated
    #[arg(long, value_name = "KEY=VALUE", value_parser = setting)]
    pub set: Vec<(String, String)>,

    /// Write the result to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    pub out: Option<String>,
}

/// The angles of a configuration, in one argument.
#[derive(Clone)]
pub struct Angles(pub Vec<f64>);

/// The forms of a roadmap in a file.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum RoadmapFormat {
    Json,
    Binary,
    Graphml,
}

#[derive(Args)]
#[command(after_help = "\
Prints {\"valid\": true, \"waypoints\", \"looks\", \"clearance\"} or {\"valid\": false, \"why\"}.
Clearance is the smallest distance to an obstacle that was seen, in metres; null without obstacles.
Exit codes: 0 valid; 1 not valid; 2 the input is wrong.

Examples:
  planarium verify arm.json result.json
  planarium plan arm.json | planarium verify arm.json -")]
pub struct Verify {
    /// The scenario, a JSON file; - reads it from standard input
    pub file: String,

    /// The result document to judge; - reads it from standard input
    pub result: String,
}

#[derive(Args)]
#[command(after_help = "\
Prints {\"indices\", \"distances\", \"visited\", \"build_seconds\", \"query_seconds\", ...}, nearest first, ties by number; of a
forest also \"recall\", the part of the true nearest that it found. query_seconds is the middle of many repetitions.

Examples:
  planarium nearest arm.json --samples 100000 --target 3.14,0 --k 10
  planarium nearest arm.json --configurations list.npy --target 3.14,0 --k 5 --index linear --metric naive
  planarium nearest arm.json --samples 20000 --target 0,0 --k 20 --index forest --set trees=4")]
pub struct Nearest {
    /// The scenario, whose robot it is; a JSON file; - reads it from standard input
    pub file: String,

    /// The configurations: JSON, an array of arrays of numbers, or an array file of NumPy; - reads them from standard input
    #[arg(long, value_name = "LIST", conflicts_with_all = ["samples", "seed", "free"])]
    pub configurations: Option<String>,

    /// Draw so many configurations uniformly [default: 1000]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub samples: Option<u64>,

    /// The seed of the configurations drawn; "random" draws one, which the result tells
    #[arg(long, value_name = "N|random", default_value_t = 0, allow_negative_numbers = true, value_parser = seed)]
    pub seed: u64,

    /// Keep only configurations that are free
    #[arg(long)]
    pub free: bool,

    /// The configuration whose neighbours are wanted
    #[arg(long, value_name = "Q1,Q2,...", required = true, allow_hyphen_values = true, value_delimiter = ',')]
    pub target: Vec<f64>,

    /// How many neighbours [default: 1]
    #[arg(long, value_name = "K", allow_negative_numbers = true, conflicts_with = "within")]
    pub k: Option<usize>,

    /// All neighbours no farther than this, instead of so many
    #[arg(long, value_name = "RADIUS", allow_negative_numbers = true)]
    pub within: Option<f64>,

    /// The index: linear, kd-tree or forest
    #[arg(long, value_name = "ID", default_value = "kd-tree")]
    pub index: String,

    /// The metric of an arm: sum, euclidean or naive [default: sum]
    #[arg(long, value_name = "NAME")]
    pub metric: Option<String>,

    /// Set a parameter of the index; may be repeated
    #[arg(long, value_name = "KEY=VALUE", value_parser = setting)]
    pub set: Vec<(String, String)>,
}

#[derive(Args)]
#[command(after_help = "\
Examples:
  planarium list
  planarium list --json")]
pub struct List {
    /// Print JSON instead of tables
    #[arg(long)]
    pub json: bool,
}

#[derive(Args)]
#[command(after_help = "\
`planarium list` shows the generators and the options of each.

Examples:
  planarium generate forest --set links=4 --seed 1
  planarium generate maze --set difficulty=hard --seed 3
  planarium generate clutter --set robot=arm --set links=3 --seed 2 --out clutter.json")]
pub struct Generate {
    /// What to generate: forest, clutter, discs, maze, gap or bug-trap
    pub kind: String,

    /// The seed: with the options it decides every bit of the scenario; "random" draws one, which the scenario's name tells
    #[arg(long, value_name = "N|random", default_value_t = 0, allow_negative_numbers = true, value_parser = seed)]
    pub seed: u64,

    /// Set an option of the generator; may be repeated
    #[arg(long, value_name = "KEY=VALUE", value_parser = setting)]
    pub set: Vec<(String, String)>,

    /// Write the scenario to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    pub out: Option<String>,
}

#[derive(Args)]
#[command(after_help = "\
`planarium list` shows the options. The CSV has a row for every accepted trajectory: x, y, theta, v, w,
duration, how many were tried for it, the microseconds that took, and their moving average over 20.
Exit codes: 0 as many are accepted as were asked for; 1 not; 2 the input is wrong.

Examples:
  planarium trajectories
  planarium trajectories --set model=spiral --set count=500 --seed 3 --csv trajectories.csv")]
pub struct Trajectories {
    /// The seed: with the options it decides every bit of the result; "random" draws one, which the result tells
    #[arg(long, value_name = "N|random", default_value_t = 0, allow_negative_numbers = true, value_parser = seed)]
    pub seed: u64,

    /// Set an option; may be repeated
    #[arg(long, value_name = "KEY=VALUE", value_parser = setting)]
    pub set: Vec<(String, String)>,

    /// Write a row for every accepted trajectory to this file
    #[arg(long, value_name = "FILE")]
    pub csv: Option<String>,
}

/// Reads KEY=VALUE.
fn setting(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((key, value)) if !key.is_empty() => Ok((key.to_owned(), value.to_owned())),
        _ => Err("a setting reads KEY=VALUE".to_owned()),
    }
}

/// Reads a seed, or draws one.
fn seed(text: &str) -> Result<u64, String> {
    if text == "random" {
        return random_seed().map_err(|error| error.to_string());
    }
    let seed = text.parse().ok().filter(|seed| *seed <= MAX_SEED);
    seed.ok_or_else(|| "a seed is an integer from 0 to 2^53 - 1, or \"random\"".to_owned())
}

/// Reads numbers with commas between them.
fn numbers(text: &str) -> Result<Vec<f64>, String> {
    let number = |part: &str| part.trim().parse().map_err(|_| format!("{part:?} is not a number"));
    text.split(',').map(number).collect()
}

/// Reads X,Y.
fn point(text: &str) -> Result<[f64; 2], String> {
    let numbers = numbers(text)?;
    numbers.try_into().map_err(|_| "a point reads X,Y".to_owned())
}

/// Reads Q1,Q2,...
fn angles(text: &str) -> Result<Angles, String> {
    numbers(text).map(Angles)
}

/// Reads a number of seconds, 0 or more.
fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(seconds) if seconds.is_finite() && seconds >= 0.0 => Ok(seconds),
        _ => Err("seconds are a number, 0 or more".to_owned()),
    }
}
