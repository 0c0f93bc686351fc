//! `planarium fleet`: plans for all robots of a fleet, with the time that took.

use crate::output::{Kind, Outputs};
use crate::{Answer, arguments, files};
use planarium::fleet::{Fleet, FleetOptions, FleetPlanner, FleetReason, FleetResult};
use planarium::problem::Status;
use std::time::Instant;

/// Plans and prints the result; true if it is solved.
pub fn fleet(arguments: &arguments::Fleet) -> Answer {
    let out = Outputs::beside([&*arguments.file], arguments.force).add(arguments.out.as_deref(), Kind::FLEET_PLAN)?;
    let fleet = Fleet::parse(&files::read(&arguments.file)?)?;
    let options = FleetOptions {
        planner: arguments.planner.clone(),
        seed: arguments.given.seed,
        order: arguments.order.clone(),
        parameters: arguments.given.set.clone(),
    };
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
