//! `planarium fleet`: plans for all robots of a fleet, with the time that took.

use crate::output::{Kind, Outputs};
use crate::{Answer, arguments, files};
use planarium::fleet::{Fleet, FleetOptions, FleetPlanner, FleetResult};
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
    let FleetResult { robots, makespan, sum_of_costs, waits, .. } = result;
    match (&result.blocked, result.status) {
        (_, Status::Solved) => {
            let count = robots.len();
            format!(
                "solved: {count} robots, makespan {makespan:.3} s, sum of costs {sum_of_costs:.3} s, waits {waits:.3} s"
            )
        }
        (Some(blocked), _) if blocked.by.is_empty() => format!("exhausted: robot {} has no way", blocked.robot),
        (Some(blocked), _) => {
            format!("exhausted: robot {} finds no way; in its way: {}", blocked.robot, blocked.by.join(", "))
        }
        _ => "exhausted: no plan found".to_owned(),
    }
}
