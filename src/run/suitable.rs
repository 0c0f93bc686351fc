//! Which planners and options are for which robots: the one place that enforces what the tables of options say.

use crate::error::{Code, Error};
use crate::options::{Change, Single, is_for, refusal};
use crate::planner::{EdgeCheck, EdgeOptions, PlannerOptions, planners};

/// The refusal of options about edges that are sampled at the resolution of a problem.
pub(super) fn at_resolution() -> Error {
    Error::new(Code::Unsupported, "/edge_check", "edges are sampled at the resolution of the problem")
}

/// The robot of a [`CustomProblem`](super::CustomProblem), where robots are named by their types.
pub(crate) const OWN: &str = "own";

/// The robot whose motions are rolled out under a learned policy, likewise.
pub(crate) const LEARNED: &str = "learned";

/// Options of checking that rollouts do not have; nor are ends moved, as the start has a heading and the robot turns at the goal.
const NOT_LEARNED: [&str; 3] = ["edge_check", "edge_samples", "free_ends"];

/// A robot by its type, in words.
fn whose(robot: &str) -> &str {
    match robot {
        OWN => "a custom robot",
        LEARNED => "learned edges, which are checked by rollouts in the plane",
        kind => kind,
    }
}

/// Refuses a planner that is not for a robot of this type, and options that are not, unless they have their defaults.
///
/// # Errors
/// `unsupported` for a planner (pointer `/algorithm`), `out-of-range` or `unsupported` with the pointer of the option.
pub(crate) fn check_use(planner: &PlannerOptions, robot: &str) -> Result<(), Error> {
    let whose = whose(robot);
    if !planner.is_for(robot) {
        let fitting: Vec<&str> =
            planners().into_iter().filter(|other| other.is_for(robot)).map(|other| other.id()).collect();
        let (id, own, fitting) = (planner.id(), planner.robots().join(", "), fitting.join(", "));
        let sentence = format!("{id} plans for robots of type {own}, not {whose}; planners for it are {fitting}");
        return Err(Error::new(Code::Unsupported, "/algorithm", sentence));
    }
    check_options(&planner.changes(), planner.group::<EdgeOptions>(), robot)
}

/// The same for options that differ from their defaults, among them those of edges.
pub(super) fn check_options(changes: &[Change], edges: Option<&EdgeOptions>, robot: &str) -> Result<(), Error> {
    let whose = whose(robot);
    for Change { name, robots, value } in changes {
        let is_of_joints = *name == "edge_check" && *value == EdgeCheck::JointLines.to_value();
        let robots = if is_of_joints { &["arm"] } else { *robots };
        if !is_for(robots, robot) || robot == LEARNED && NOT_LEARNED.contains(name) {
            let code = if robot == LEARNED || *name == "blend" { Code::Unsupported } else { Code::OutOfRange };
            let sentence = match is_for(robots, robot) {
                true => format!("{name} is not for {whose}"),
                false => format!("{name} = {value} is for robots of type {}, not {whose}", robots.join(", ")),
            };
            return Err(refusal(code, name, sentence));
        }
    }
    if edges.is_some_and(|edges| edges.improving.blend > 0.0 && edges.edge_check != EdgeCheck::Proven) {
        let sentence = "corners are rounded only between proven motions, not with another edge_check";
        return Err(Error::new(Code::Unsupported, "/blend", sentence));
    }
    if edges.is_some_and(|edges| edges.improving.blend > 0.0 && edges.keeping_away.clearance_weight > 0.0) {
        let sentence = "blend cannot be combined with clearance_weight";
        return Err(Error::new(Code::Unsupported, "/blend", sentence));
    }
    Ok(())
}
