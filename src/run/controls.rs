//! From the parameters of the planners by controls to their options.

use super::choices::bias;
use crate::control::{Control, Motion};
use crate::error::{Code, Error};
use crate::planner::{
    Blocked, Blossom, Durations, GoalBias, GoalTest, Late, MOST_STEPS, Origin, Parameters, RrtControlOptions,
    SstOptions,
};
use crate::problem::Problem;
use crate::space::Space;

/// Of the space's extent, how far the fastest straight drive of the longest duration goes where none is given: for the cars
/// of the course reports that is their 2.5 s.
const DEFAULT_DRIVE: f64 = 0.3;
/// Of the space's extent, the selection radius where none is given.
const DEFAULT_SELECTION: f64 = 0.06;
/// Of the space's extent, the pruning radius where none is given.
const DEFAULT_PRUNING: f64 = 0.03;

/// How an RRT by controls grows.
pub(super) fn rrt_control_options<S: Space>(
    parameters: &Parameters,
    problem: &Problem<S>,
) -> Result<RrtControlOptions, Error> {
    let durations = durations(parameters, problem)?;
    let bias = bias(parameters);
    Ok(RrtControlOptions {
        origin: match parameters.text("nearest") {
            Some("nearest-visible") => Origin::NearestVisible,
            _ => Origin::Nearest,
        },
        once: parameters.is_on("once"),
        blossom: match parameters.text("controls") {
            Some("reeds-shepp") => Blossom::ReedsShepp,
            _ => Blossom::Random(parameters.integer("blossom") as u32),
        },
        durations,
        near_goal: parameters.number("near_goal_steps").map(|steps| steps as u32),
        blocked: blocked(parameters),
        bias,
        late: late(parameters, durations, bias)?,
        goal_test: goal_test(parameters),
    })
}

/// How an SST grows.
pub(super) fn sst_options<S: Space>(parameters: &Parameters, problem: &Problem<S>) -> Result<SstOptions, Error> {
    let radius = |name, default: f64| parameters.number(name).unwrap_or(default * problem.space().extent());
    Ok(SstOptions {
        selection_radius: radius("selection_radius", DEFAULT_SELECTION),
        pruning_radius: radius("pruning_radius", DEFAULT_PRUNING),
        durations: durations(parameters, problem)?,
        blocked: blocked(parameters),
        bias: bias(parameters),
        goal_test: goal_test(parameters),
        improve_iterations: parameters.integer("improve_iterations") as u32,
    })
}

/// How long controls are held.
fn durations<S: Space>(parameters: &Parameters, problem: &Problem<S>) -> Result<Durations, Error> {
    let longest = parameters.number("duration_steps").map_or_else(|| default_steps(problem), |steps| steps as u32);
    match parameters.number("shortest_steps").map(|steps| steps as u32) {
        Some(shortest) if shortest > longest => Err(too_long("shortest_steps", shortest, longest)),
        shortest => Ok(Durations { shortest: shortest.unwrap_or(longest), longest }),
    }
}

/// The longest duration where none is given.
fn default_steps<S: Space>(problem: &Problem<S>) -> u32 {
    let dynamics = problem.dynamics().expect("what is planned by controls is driven");
    let straight =
        |control: Control| Motion { control: Control { steering: 0.0, ..control }, duration: dynamics.step() };
    let step = dynamics.extremes().into_iter().map(|control| dynamics.length(straight(control))).fold(0.0, f64::max);
    ((DEFAULT_DRIVE * problem.space().extent() / step).min(MOST_STEPS) as u32).max(1)
}

/// What is different in the last quarter of the iterations, if anything is.
fn late(parameters: &Parameters, durations: Durations, bias: GoalBias) -> Result<Option<Late>, Error> {
    let [longest, every] = ["late_duration_steps", "late_goal_every"].map(|name| parameters.number(name));
    if longest.is_none() && every.is_none() {
        return Ok(None);
    }
    let longest = longest.map_or(durations.longest, |steps| steps as u32);
    if parameters.is_given("shortest_steps") && durations.shortest > longest {
        return Err(too_long("shortest_steps", durations.shortest, longest));
    }
    let most = parameters.integer("max_iterations") as u32;
    Ok(Some(Late {
        from: most - most / 4 + 1,
        durations: Durations { shortest: durations.shortest.min(longest), longest },
        bias: every.map_or(bias, |n| GoalBias::Every(n as u32)),
    }))
}

fn too_long(name: &str, steps: u32, most: u32) -> Error {
    let sentence = format!("{name} must be at most the longest duration, {most}, not {steps}");
    Error::new(Code::OutOfRange, format!("/{name}"), sentence)
}

fn blocked(parameters: &Parameters) -> Blocked {
    if parameters.text("blocked") == Some("refused") { Blocked::Refused } else { Blocked::Cut }
}

fn goal_test(parameters: &Parameters) -> GoalTest {
    if parameters.text("goal_test") == Some("ends") { GoalTest::Ends } else { GoalTest::Along }
}
