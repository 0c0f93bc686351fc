//! The command line: import, plan, fleet, train, navigate, compare, optimum, widest, safest, route-graph, certify, verify, time,
//! convert, sweep, nearest, list, generate, reach, trajectories, schema.
//!
//! JSON goes to standard output, messages and the progress bar to standard error. Exit code 0 means solved or valid, 1 not
//! solved or not valid, 2 that the input is wrong; then standard output contains `{"error": {"code", "message", "pointer"}}`.
#![deny(unsafe_code)]
#![deny(clippy::unwrap_used)]

mod arguments;
mod certify;
mod convert;
mod files;
mod fleet;
mod generate;
mod identity;
mod import;
mod judge;
mod kind;
mod list;
mod navigation;
mod nearest;
mod optimum;
mod output;
mod plan;
mod progress;
mod reach;
mod route_graph;
mod schema;
mod sweep;
mod time;
mod trajectories;
mod verify;
mod widest;
mod world;

use arguments::{Answer, Failure};
use clap::{Parser, Subcommand};
use planarium::Error;
use planarium::error::Code;
use std::process::ExitCode;

/// Motion planning that a person can watch: stepping planners with proven edges, the same bits natively and in WebAssembly
#[derive(Parser)]
#[command(
    name = "planarium",
    version,
    max_term_width = 110,
    arg_required_else_help = true,
    after_help = "\
JSON goes to standard output, messages to standard error.
Exit codes: 0 solved or valid; 1 not solved or not valid; 2 the input is wrong, and standard output
contains {\"error\": {\"code\", \"message\", \"pointer\"}}. `planarium list` explains the codes.

Examples:
  planarium import map.yaml --radius 0.2 --start 1,1 --goal 8,5 --out map.json
  planarium generate forest --set links=3 --seed 4 --out forest.json
  planarium plan forest.json --planner prm --set samples=700 --set k=30 --out result.json
  planarium verify forest.json result.json"
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Read a map, a picture or a benchmark file as a scenario and print it
    Import(import::Arguments),
    /// Plan a path for one query of a scenario and print the result document
    Plan(plan::Arguments),
    /// Prove that no path keeps more than a clearance, or that one does, and print the certificate
    Certify(certify::Arguments),
    /// Plan for all robots of a fleet, without conflict, and print the result document
    Fleet(fleet::Arguments),
    /// Train a policy that drives by what it senses, and print it
    Train(navigation::Train),
    /// Plan with edges that a policy drives reliably (PRM-RL), execute the path with noise, and print the result document
    Navigate(navigation::Navigate),
    /// Compare a policy alone, straight edges, and PRM-RL, on one floor with the same queries
    Compare(navigation::Compare),
    /// Find joint angles that bring the tip of an arm to a target and print the result document
    Reach(reach::Arguments),
    /// Verify a result, its trajectory or a certificate against its scenario, by other code than that which made it
    Verify(verify::Arguments),
    /// Time the path of a result as fast as limits of speed and acceleration allow, and print the trajectory
    Time(time::Arguments),
    /// Write the path of a result as CSV, JSON, GeoJSON, SVG, poses of ROS or a NumPy array, in the coordinates of its map
    Convert(convert::Arguments),
    /// Print the shortest path of a query: exact for a disc, a reference for an arm of two joints or a body that does not turn
    Optimum(optimum::Arguments),
    /// Print how wide a disc may be to pass from the start to the goal of a query, and the bottleneck
    Widest(widest::Arguments),
    /// Print the shortest of the paths of a query that stay as far from obstacles as possible
    #[command(after_help = widest::SAFEST)]
    Safest(widest::Arguments),
    /// Make a sparse graph of proven edges over the free places, and print it as GeoJSON for the route server of Nav2
    RouteGraph(route_graph::Arguments),
    /// Run the trials of an experiment, a row each, and print their statistics
    Sweep(sweep::Arguments),
    /// Find the configurations nearest to a target, in a list or among random ones
    Nearest(nearest::Arguments),
    /// List the planners and the indexes with their parameters, the generators with their options, and the error codes
    List(list::Arguments),
    /// Generate a scenario, a fleet or a navigation task by seed and print it
    Generate(generate::Arguments),
    /// Add random trajectories of particles one by one, none of which crosses another, and print counts
    Trajectories(trajectories::Arguments),
    /// Print the JSON Schema of scenarios, of experiments, of fleets, or of navigation tasks
    Schema(schema::Arguments),
}

fn main() -> ExitCode {
    let answer = match Arguments::try_parse() {
        Ok(arguments) => run(&arguments.command),
        Err(error) if !error.use_stderr() => {
            // Help or version, as requested. A closed pipe is not an error.
            let _ = error.print();
            return ExitCode::SUCCESS;
        }
        Err(error) => {
            let _ = error.print();
            return report(&usage(&error).into());
        }
    };
    match answer {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(error) => {
            files::say(&format!("error: {error}"));
            report(&error)
        }
    }
}

fn run(command: &Command) -> Answer {
    match command {
        Command::Import(arguments) => import::import(arguments),
        Command::Plan(arguments) => plan::plan(arguments),
        Command::Certify(arguments) => certify::certify(arguments),
        Command::Fleet(arguments) => fleet::fleet(arguments),
        Command::Train(arguments) => navigation::train(arguments),
        Command::Navigate(arguments) => navigation::navigate(arguments),
        Command::Compare(arguments) => navigation::compare(arguments),
        Command::Reach(arguments) => reach::reach(arguments),
        Command::Verify(arguments) => verify::verify(arguments),
        Command::Time(arguments) => time::time(arguments),
        Command::Convert(arguments) => convert::convert(arguments),
        Command::Optimum(arguments) => optimum::optimum(arguments),
        Command::Widest(arguments) => widest::print(arguments),
        Command::Safest(arguments) => widest::print_safest(arguments),
        Command::RouteGraph(arguments) => route_graph::route_graph(arguments),
        Command::Sweep(arguments) => sweep::sweep(arguments),
        Command::Nearest(arguments) => nearest::nearest(arguments),
        Command::List(arguments) => list::list(arguments),
        Command::Generate(arguments) => generate::generate(arguments),
        Command::Trajectories(arguments) => trajectories::trajectories(arguments),
        Command::Schema(arguments) => schema::schema(arguments),
    }
}

/// The error for arguments that clap refuses: its first sentence, without the decoration.
fn usage(error: &clap::Error) -> Error {
    let text = error.to_string();
    let sentence = text.lines().next().unwrap_or_default().trim_start_matches("error: ");
    let sentence = match error.kind() {
        clap::error::ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => "a command is missing",
        _ => sentence,
    };
    Error::new(Code::Usage, "", sentence)
}

/// Prints the error as JSON; exit code 2.
fn report(error: &Failure) -> ExitCode {
    if let Err(unwritten) = files::print(&error.document().to_string()) {
        files::say(&format!("error: {unwritten}"));
    }
    ExitCode::from(2)
}
