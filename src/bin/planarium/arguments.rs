//! The arguments, with their help.

use crate::sweep::rows::Format;
use clap::{Args, Parser, Subcommand, ValueEnum};
use planarium::certificate::DEFAULT_CELLS;
use planarium::random::{MAX_SEED, random_seed};
use planarium::run::Value;
use std::num::NonZeroUsize;
use std::ops::Range;

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
contains {\"error\": {\"code\", \"message\", \"pointer\"}}. `planarium list` explains the codes.

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
    /// Prove that no path keeps more than a clearance, or that one does, and print the certificate
    Certify(Certify),
    /// Plan for all robots of a fleet, without conflict, and print the result document
    Fleet(Fleet),
    /// Train a policy that drives by what it senses, and print it
    Train(Train),
    /// Plan with edges that a policy drives reliably (PRM-RL), execute the path with noise, and print the result document
    Navigate(Navigate),
    /// Compare a policy alone, straight edges, and PRM-RL, on one floor with the same queries
    Compare(Compare),
    /// Find joint angles that bring the tip of an arm to a target and print the result document
    Reach(Reach),
    /// Verify a result or a certificate against its scenario, by other code than that which made it
    Verify(Verify),
    /// Print the shortest path of a query: exact for a disc, a reference for an arm of two joints or a body that does not turn
    Optimum(Optimum),
    /// Run the trials of an experiment, a row each, and print their statistics
    Sweep(Sweep),
    /// Find the configurations nearest to a target, in a list or among random ones
    Nearest(Nearest),
    /// List the planners and the indexes with their parameters, the generators with their options, and the error codes
    List(List),
    /// Generate a scenario, a fleet or a navigation task by seed and print it
    Generate(Generate),
    /// Add random trajectories of particles one by one, none of which crosses another, and print counts
    Trajectories(Trajectories),
    /// Print the JSON Schema of scenarios, of experiments, of fleets, or of navigation tasks
    #[cfg(feature = "schema")]
    Schema(Schema),
}

#[cfg(feature = "schema")]
#[derive(Args)]
pub struct Schema {
    /// The kind of document
    #[arg(value_enum, default_value_t = Document::Scenario)]
    pub document: Document,
}

#[cfg(feature = "schema")]
#[derive(Clone, Copy, ValueEnum)]
pub enum Document {
    Scenario,
    Experiment,
    Fleet,
    Navigation,
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

    /// The query, by name [default: the first of the scenario]
    #[arg(long, value_name = "NAME")]
    pub query: Option<String>,

    /// The planner, by id; see `planarium list` [default: rrt-connect, for a car rrt-control; with a roadmap the one that built it]
    #[arg(long, value_name = "ID")]
    pub planner: Option<String>,

    #[command(flatten)]
    pub given: Given,

    /// The most iterations; the same as --set max_iterations=N
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub max_iterations: Option<u64>,

    /// Stop after this many seconds with status "running"; the result contains the iterations made
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = seconds)]
    pub max_seconds: Option<f64>,

    /// The threads to use; the result is the same with any number [default: one per core]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = threads)]
    pub threads: Option<NonZeroUsize>,

    /// Continue with a roadmap saved for the same world and robot, which is proven again, instead of building one; - reads it
    /// from standard input
    #[arg(long, value_name = "FILE")]
    pub roadmap: Option<String>,

    /// Save the roadmap when the run ends (of planners that build one: their names contain "prm")
    #[arg(long, value_name = "FILE")]
    pub save_roadmap: Option<String>,

    /// The format of the saved roadmap [default: json for FILE.json, graphml for FILE.graphml, else binary]; graphml is for other
    /// programs
    #[arg(long, value_name = "FORMAT", requires = "save_roadmap")]
    pub roadmap_format: Option<RoadmapFormat>,

    /// Write the result to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    pub out: Option<String>,

    /// Replace files that contain something else
    #[arg(long)]
    pub force: bool,
}

#[derive(Args)]
#[command(after_help = "\
For an arm of two links and for a disc. The verdict is \"infeasible\" (no path keeps more than the clearance), \"connected\" (a
path does), or \"unknown\" once --cells are spent; then no path keeps more than \"clearance_at_most\", if that is there.
Clearances are known to within \"slack\"; contact is collision.
Exit codes: 0 infeasible or connected; 1 unknown; 2 the input is wrong.

Examples:
  planarium certify arm.json --out certificate.json
  planarium verify arm.json certificate.json
  planarium certify arm.json --query report --clearance 0.01 --cells 200000")]
pub struct Certify {
    /// The scenario, a JSON file; - reads it from standard input
    pub file: String,

    /// The query, by name [default: the first of the scenario]
    #[arg(long, value_name = "NAME")]
    pub query: Option<String>,

    /// The clearance that paths have to exceed, in metres
    #[arg(long, value_name = "E", default_value_t = 0.0, allow_negative_numbers = true)]
    pub clearance: f64,

    /// The most cells, divided ones too
    #[arg(long, value_name = "N", default_value_t = DEFAULT_CELLS, allow_negative_numbers = true)]
    pub cells: usize,

    /// Write the certificate to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    pub out: Option<String>,

    /// Replace files that contain something else
    #[arg(long)]
    pub force: bool,
}

#[derive(Args)]
#[command(after_help = "\
If the target is out of reach, the result contains the reason and the nearest point that can be reached.
Exit codes: 0 reached; 1 not reached; 2 the input is wrong.

Examples:
  planarium reach arm.json --target 1.2,0.4
  planarium reach arm.json --target 1.2,0.4 --orientation 0.5 --method newton --seed 3
  planarium reach arm.json --target=-0.5,1 --solutions 4 --set free_only=true")]
pub struct Reach {
    /// The scenario, a JSON file; - reads it from standard input
    pub file: String,

    /// The target of the tip, in metres
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, value_parser = point)]
    pub target: [f64; 2],

    /// The absolute angle of the last link, in radians [default: any]
    #[arg(long, value_name = "PHI", allow_negative_numbers = true)]
    pub orientation: Option<f64>,

    /// The method, by id; see `planarium list` [default: damped-least-squares]
    #[arg(long, value_name = "ID")]
    pub method: Option<String>,

    /// The joint angles of the start, in radians [default: the start of the first query, else 0 as far as limits allow]
    #[arg(long, value_name = "Q1,Q2,..", allow_hyphen_values = true, value_parser = angles)]
    pub start: Option<Angles>,

    #[command(flatten)]
    pub given: Given,

    /// The number of distinct solutions to search for; the same as --set solutions=N
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub solutions: Option<u64>,

    /// Write the result to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    pub out: Option<String>,

    /// Replace files that contain something else
    #[arg(long)]
    pub force: bool,
}

/// The angles of a configuration, in one argument.
#[derive(Clone)]
pub struct Angles(pub Vec<f64>);

/// The arguments of every command that draws random numbers and has options.
#[derive(Args)]
pub struct Given {
    /// The seed: together with the scenario and all options it decides every bit of the result; "random" draws one, which is printed
    /// with the result
    #[arg(long, value_name = "N|random", default_value_t = 0, allow_negative_numbers = true, value_parser = seed)]
    pub seed: u64,

    /// Set an option; may be repeated; see `planarium list`
    #[arg(long, value_name = "KEY=VALUE", value_parser = setting)]
    pub set: Vec<(String, Value)>,
}

impl Given {
    /// The options, with one that has an argument of its own.
    pub fn parameters(&self, name: &str, value: Option<Value>) -> Vec<(String, Value)> {
        self.set.iter().cloned().chain(value.map(|value| (name.to_owned(), value))).collect()
    }
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum RoadmapFormat {
    Json,
    Binary,
    Graphml,
}

#[derive(Args)]
#[command(after_help = "\
`planarium list` describes the options. The same seed gives the same policy, with any number of threads.

Examples:
  planarium train --seed 1 --out policy.json
  planarium train rooms.json --set generations=100 --set hidden=24 --seed 2 --out policy.json")]
pub struct Train {
    /// A navigation task, whose robot is trained; - reads it from standard input [default: a disc of radius 0.25 m]
    pub file: Option<String>,

    #[command(flatten)]
    pub given: Given,

    /// The threads to use; the result is the same with any number [default: one per core]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = threads)]
    pub threads: Option<NonZeroUsize>,

    /// Write the policy to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    pub out: Option<String>,

    /// Replace files that contain something else
    #[arg(long)]
    pub force: bool,
}

#[derive(Args)]
#[command(after_help = "\
Options are those of the planner, and rollouts, least_share and longest_edge.
Nothing is proven: the result has for each edge how many rollouts reached its end.
Exit codes: 0 solved; 1 no path; 2 the input is wrong.

Examples:
  planarium generate rooms --seed 1 --out rooms.json
  planarium navigate rooms.json --policy policy.json --set samples=800 --set k=20
  planarium navigate rooms.json --policy policy.json --planner lazy-prm --set samples=800 --set k=20 --trials 100")]
pub struct Navigate {
    /// The navigation task, a JSON file; - reads it from standard input
    pub file: String,

    /// The policy, a JSON file; - reads it from standard input
    #[arg(long, value_name = "FILE")]
    pub policy: String,

    /// The query, by name [default: the first of the task]
    #[arg(long, value_name = "NAME")]
    pub query: Option<String>,

    /// The planner, by id; see `planarium list` [default: lazy-prm]
    #[arg(long, value_name = "ID")]
    pub planner: Option<String>,

    #[command(flatten)]
    pub given: Given,

    /// How many times the path is executed with noise
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u64).range(..=100_000))]
    pub trials: u64,

    /// Write the result to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    pub out: Option<String>,

    /// Replace files that contain something else
    #[arg(long)]
    pub force: bool,
}

#[derive(Args)]
#[command(after_help = "\
`planarium list` describes the options. Intervals have a confidence of 95 %.

Examples:
  planarium compare rooms.json --policy policy.json --seed 1
  planarium compare rooms.json --policy policy.json --set queries=50 --set trials=10 --set margin=0.15")]
pub struct Compare {
    /// The navigation task, a JSON file; - reads it from standard input
    pub file: String,

    /// The policy, a JSON file; - reads it from standard input
    #[arg(long, value_name = "FILE")]
    pub policy: String,

    #[command(flatten)]
    pub given: Given,

    /// Write the summary to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    pub out: Option<String>,

    /// Replace files that contain something else
    #[arg(long)]
    pub force: bool,
}

#[derive(Args)]
#[command(after_help = "\
Without a plan the result has the reason, and mostly the robot that found no way last, and who was in its way.
Exit codes: 0 solved; 1 exhausted; 2 the input is wrong.

Examples:
  planarium generate hall --set count=20 --seed 1 --out hall.json
  planarium fleet hall.json --out plan.json
  planarium verify hall.json plan.json
  planarium generate swap | planarium fleet - --order 2,1
  planarium generate swap | planarium fleet - --planner composite --seed 3")]
pub struct Fleet {
    /// The fleet, a JSON file; - reads it from standard input
    pub file: String,

    /// The planner, by id; see `planarium list` [default: pbs, or prioritized if there is an order]
    #[arg(long, value_name = "ID")]
    pub planner: Option<String>,

    /// The order of priorities, the highest first: every robot once, by its name, or by its index from 0; for prioritized, which
    /// begins with that of the fleet by default
    #[arg(long, value_name = "A,B,..", value_delimiter = ',')]
    pub order: Option<Vec<String>>,

    #[command(flatten)]
    pub given: Given,

    /// Write the result to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    pub out: Option<String>,

    /// Replace files that contain something else
    #[arg(long)]
    pub force: bool,
}

#[derive(Args)]
#[command(after_help = "\
Prints {\"valid\": true, \"waypoints\", \"looks\", \"clearance\"} or {\"valid\": false, \"why\"}; of a certificate without counts.
Clearance is the smallest distance to an obstacle found, in metres; null without obstacles.
Of a plan of a fleet it prints {\"valid\", \"conflicts\", \"faults\", \"looks\"}.
Exit codes: 0 valid; 1 not valid; 2 the input is wrong.

Examples:
  planarium verify arm.json result.json
  planarium plan arm.json | planarium verify arm.json -")]
pub struct Verify {
    /// The scenario or the fleet, a JSON file; - reads it from standard input
    pub file: String,

    /// The result document, or the certificate; - reads it from standard input
    pub result: String,
}

#[derive(Args)]
#[command(after_help = "\
Prints {\"length\", \"path\", \"method\", \"exact\", \"resolution\", ...}. Of a disc or a point, the length is the infimum of all free
paths, and null if there is none. Of an arm of two joints, and of a rigid body whose query keeps its angle, it is the length of a proven path on
a grid, made shorter by shortcuts. With a result document it prints as well by how much its path is longer: \"gap\", in percent.
Exit codes: 0 there is a path; 1 none was found; 2 the input is wrong.

Examples:
  planarium optimum discs.json --query across
  planarium plan discs.json --planner rrt-star | planarium optimum discs.json --result -")]
pub struct Optimum {
    /// The scenario, a JSON file; - reads it from standard input
    pub file: String,

    /// The query, by name [default: that of the result, else the first of the scenario]
    #[arg(long, value_name = "NAME")]
    pub query: Option<String>,

    /// The metric of an arm: sum, euclidean or naive [default: sum]
    #[arg(long, value_name = "NAME")]
    pub metric: Option<String>,

    /// A result document to compare; - reads it from standard input
    #[arg(long, value_name = "FILE")]
    pub result: Option<String>,

    /// Write the document to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    pub out: Option<String>,

    /// Replace files that contain something else
    #[arg(long)]
    pub force: bool,
}

#[derive(Args)]
#[command(after_help = "\
Every trial has a row, in the order of trials; the times of runs.csv are in runs.times.csv. Rows are the same with any number of
threads, and the files of shards 1/N to N/N, one after another, are the file of one run. A sweep that was stopped, by whatever
means, goes on after its last complete row when it is started again. Prints the statistics of all rows as JSON.
Exit codes: 0 all trials have rows, solved or not; 2 the input is wrong, or the file has rows of another experiment.

Examples:
  planarium sweep experiment.json --out runs.csv
  planarium sweep experiment.json --out part2.csv --shard 2/8 --threads 4
  planarium sweep experiment.json --out runs.csv --ompl-log runs.log")]
pub struct Sweep {
    /// The experiment, a JSON file; - reads it from standard input
    pub file: String,

    /// The file of rows; it is continued if it exists
    #[arg(long, value_name = "FILE")]
    pub out: String,

    /// The format of rows
    #[arg(long, value_name = "FORMAT", value_enum, default_value_t = Format::Csv)]
    pub format: Format,

    /// Run only part I of N equal parts, from 1
    #[arg(long, value_name = "I/N", value_parser = shard)]
    pub shard: Option<Shard>,

    /// The threads to use; the rows are the same with any number [default: one per core]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = threads)]
    pub threads: Option<NonZeroUsize>,

    /// Write all rows to this file as a log of OMPL's benchmarks
    #[arg(long, value_name = "FILE")]
    pub ompl_log: Option<String>,

    /// Replace files that contain something else; rows of this experiment are continued all the same
    #[arg(long)]
    pub force: bool,
}

/// Part `index`, from 1, of `count` equal parts; all of it by default.
#[derive(Clone, Copy)]
pub struct Shard {
    index: u64,
    count: u64,
}

impl Default for Shard {
    fn default() -> Self {
        Self { index: 1, count: 1 }
    }
}

impl Shard {
    /// Whether it is the first part.
    pub fn is_first(self) -> bool {
        self.index == 1
    }

    /// The trials of this part.
    pub fn trials(self, all: u64) -> Range<u64> {
        let until = |index: u64| (u128::from(all) * u128::from(index) / u128::from(self.count)) as u64;
        until(self.index - 1)..until(self.index)
    }
}

#[derive(Args)]
#[command(after_help = "\
Prints {\"indices\", \"distances\", \"visited\", \"build_seconds\", \"query_seconds\", ...}, nearest first, ties by index; for a
forest also \"recall\", the fraction of the true nearest that it found. query_seconds is the median of many repetitions.

Examples:
  planarium nearest arm.json --samples 100000 --target 3.14,0 --k 10
  planarium nearest arm.json --configurations list.npy --target 3.14,0 --k 5 --index linear --metric naive
  planarium nearest arm.json --samples 20000 --target 0,0 --k 20 --index forest --set trees=4")]
pub struct Nearest {
    /// The scenario, a JSON file; - reads it from standard input
    pub file: String,

    /// The configurations: JSON, an array of arrays of numbers, or a NumPy array file; - reads them from standard input
    #[arg(long, value_name = "LIST", conflicts_with_all = ["samples", "seed", "free"])]
    pub configurations: Option<String>,

    /// The number of configurations drawn uniformly [default: 1000]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub samples: Option<u64>,

    #[command(flatten)]
    pub given: Given,

    /// Draw only configurations that are free
    #[arg(long)]
    pub free: bool,

    /// The configuration whose neighbours are searched for
    #[arg(long, value_name = "Q1,Q2,...", required = true, allow_hyphen_values = true, value_delimiter = ',')]
    pub target: Vec<f64>,

    /// The number of neighbours [default: 1]
    #[arg(long, value_name = "K", allow_negative_numbers = true, conflicts_with = "within")]
    pub k: Option<usize>,

    /// All neighbours within this distance, instead of a number of them
    #[arg(long, value_name = "RADIUS", allow_negative_numbers = true)]
    pub within: Option<f64>,

    /// The index: linear, kd-tree or forest
    #[arg(long, value_name = "ID", default_value = "kd-tree")]
    pub index: String,

    /// The metric of an arm: sum, euclidean or naive [default: sum]
    #[arg(long, value_name = "NAME")]
    pub metric: Option<String>,
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
`planarium list` describes the generators and their options. With --set ensure=path (or no-path) scenarios are drawn
again until a path is known (or until it is proven that none exists).

Examples:
  planarium generate forest --set links=4 --seed 1
  planarium generate maze --set difficulty=hard --seed 3
  planarium generate clutter --set robot=arm --set links=3 --seed 2 --out clutter.json
  planarium generate discs --set robot=arm --set count=12 --set ensure=path")]
pub struct Generate {
    /// The generator: forest, clutter, discs, maze, gap or bug-trap; or swap, corridor, crossroads, ring or hall, which make fleets;
    /// or rooms or furnished, which make navigation tasks
    pub kind: String,

    #[command(flatten)]
    pub given: Given,

    /// Write the scenario to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    pub out: Option<String>,

    /// Replace files that contain something else
    #[arg(long)]
    pub force: bool,
}

#[derive(Args)]
#[command(after_help = "\
`planarium list` describes the options. The CSV has a row for every accepted trajectory: x, y, theta, v, w,
duration, how many were tried for it, the microseconds that took, and their moving average over 20.
Exit codes: 0 the requested number is accepted; 1 not; 2 the input is wrong.

Examples:
  planarium trajectories
  planarium trajectories --set model=spiral --set count=500 --seed 3 --csv trajectories.csv")]
pub struct Trajectories {
    #[command(flatten)]
    pub given: Given,

    /// Write a row for every accepted trajectory to this file
    #[arg(long, value_name = "FILE")]
    pub csv: Option<String>,

    /// Replace files that contain something else
    #[arg(long)]
    pub force: bool,
}

fn setting(text: &str) -> Result<(String, Value), String> {
    match text.split_once('=') {
        Some((key, value)) if !key.is_empty() => Ok((key.to_owned(), Value::from_text(value))),
        _ => Err("a setting reads KEY=VALUE".to_owned()),
    }
}

fn seed(text: &str) -> Result<u64, String> {
    if text == "random" {
        return random_seed().map_err(|error| error.to_string());
    }
    let seed = text.parse().ok().filter(|seed| *seed <= MAX_SEED);
    seed.ok_or_else(|| "a seed is an integer from 0 to 2^53 - 1, or \"random\"".to_owned())
}

fn shard(text: &str) -> Result<Shard, String> {
    let parts = text.split_once('/').and_then(|(index, count)| Some((index.parse().ok()?, count.parse().ok()?)));
    let shard =
        parts.map(|(index, count)| Shard { index, count }).filter(|shard| (1..=shard.count).contains(&shard.index));
    shard.ok_or_else(|| "a shard reads I/N, with I from 1 to N".to_owned())
}

fn angles(text: &str) -> Result<Angles, String> {
    let number = |part: &str| part.trim().parse().map_err(|_| format!("{part:?} is not a number"));
    text.split(',').map(number).collect::<Result<_, _>>().map(Angles)
}

fn point(text: &str) -> Result<[f64; 2], String> {
    angles(text)?.0.try_into().map_err(|_| "a point reads X,Y".to_owned())
}

fn threads(text: &str) -> Result<NonZeroUsize, String> {
    let threads = text.parse().ok().filter(|threads: &NonZeroUsize| threads.get() <= 1024);
    threads.ok_or_else(|| "threads are a whole number from 1 to 1024".to_owned())
}

fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(seconds) if seconds.is_finite() && seconds >= 0.0 => Ok(seconds),
        _ => Err("seconds are a number, 0 or more".to_owned()),
    }
}
