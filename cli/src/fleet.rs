//! `planarium fleet`: plans for all robots of a fleet, with the time that took.

use crate::arguments::{Answer, Given, trimmed};
use crate::files;
use crate::kind::Kind;
use crate::output::Destination;
use clap::Args;
use planarium::fleet::{Fleet, FleetOptions, FleetPlanner, FleetReason, FleetResult};
use planarium::problem::{Status, Stepped};
use std::time::Instant;

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
pub struct Arguments {
    /// The fleet, a JSON file; - reads it from standard input
    file: String,

    /// The planner, by id; see `planarium list` [default: pbs, or prioritized if there is an order]
    #[arg(long, value_name = "ID")]
    planner: Option<String>,

    /// The order of priorities, the highest first: every robot once, by its name, or by its index from 0; for prioritized, which
    /// begins with that of the fleet by default
    #[arg(long, value_name = "A,B,..", value_delimiter = ',', value_parser = trimmed)]
    order: Option<Vec<String>>,

    #[command(flatten)]
    given: Given,

    #[command(flatten)]
    destination: Destination,
}

/// Plans and prints the result; true if it is solved.
pub fn fleet(arguments: &Arguments) -> Answer {
    let (_, out) = arguments.destination.beside([&*arguments.file], Kind::FLEET_PLAN)?;
    let fleet = Fleet::parse(&files::read(&arguments.file)?)?;
    let Given { seed, set } = &arguments.given;
    let options = FleetOptions { planner: None, seed: *seed, order: arguments.order.clone() };
    let options = options.with(arguments.planner.as_deref(), set)?;
    let begun = Instant::now();
    let mut planner = FleetPlanner::new(&fleet, &options)?;
    planner.step(u64::MAX);
    let seconds = begun.elapsed().as_secs_f64();
    let result = planner.result();
    out.write(&result.to_json())?;
    files::say(&format!("{}; {seconds:.3} s", summary(&result)));
    Ok(result.status == Status::Solved)
}

fn summary(result: &FleetResult) -> String {
    let FleetResult { robots, makespan, sum_of_costs, waits, stats, blocked, .. } = result;
    if result.status == Status::Solved {
        let count = robots.len();
        return format!(
            "solved: {count} robots, makespan {makespan:.3} s, sum of costs {sum_of_costs:.3} s, waits {waits:.3} s"
        );
    }
    let last = blocked.as_ref().filter(|blocked| !blocked.by.is_empty()).map_or_else(String::new, |blocked| {
        format!("; at last robot {} found no way, and in its way were: {}", blocked.robot, blocked.by.join(", "))
    });
    let alone = blocked.as_ref().map_or("a robot", |blocked| &blocked.robot);
    let why = match result.reason {
        Some(FleetReason::NotConnected) => {
            let vertices = stats.vertices;
            format!("the roadmap does not connect the start of robot {alone} to its goal ({vertices} vertices in all)")
        }
        Some(FleetReason::NoOrder) => format!("every order of priorities fails on these roadmaps{last}"),
        Some(FleetReason::OrderLimit) => {
            let tried = stats.restarts + 1;
            format!("gave up after {tried} order{} of priorities{last}", if tried == 1 { "" } else { "s" })
        }
        Some(FleetReason::GraphFull) => "gave up, for there is no memory for more vertices".to_owned(),
        Some(FleetReason::TooLate) => "the plan lasts too long for the speed of its fastest robots".to_owned(),
        Some(FleetReason::IterationLimit) | None => format!("gave up after {} iterations{last}", stats.iterations),
    };
    format!("exhausted, no plan found: {why}")
}
