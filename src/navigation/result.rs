//! The document of a plan by PRM-RL: the path, the rollouts along its edges, and how often it was executed.

use super::document::Navigation;
use super::execution::Executor;
use super::outcome::Outcome;
use super::policy::Policy;
use super::roadmap::{EdgeRollouts, RolloutOptions, edge_rollouts, start};
use crate::error::Error;
use crate::json;
use crate::path::ResultDocument;
use crate::run::Options;
use crate::statistics::{Mean, Share, mean, share};
use serde::Serialize;

/// The result of [`navigate`].
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct NavigationResult {
    /// The plan: `scenario` is the name of the task, `edge_check` is `rollouts`, and configurations are positions. Nothing is
    /// proven.
    #[serde(flatten)]
    pub plan: ResultDocument,
    /// The name of the policy.
    pub policy: String,
    /// For each step of the path, how many rollouts have reached its end, in both directions.
    pub rollouts: Vec<EdgeRollouts>,
    /// The executions of the path that have reached the goal; none if there is no path.
    pub reached: Share,
    /// Those that ended in a collision.
    pub collisions: Share,
    /// Those in which the load swung too far; of a robot without a load none.
    pub swings: Share,
    /// The lengths of the executions that reached the goal, in metres.
    pub driven_length: Mean,
    /// Their times, in seconds.
    pub driven_time: Mean,
}

impl NavigationResult {
    /// The document as one line of JSON.
    pub fn to_json(&self) -> String {
        json::to_string(self)
    }
}

/// Plans for a query with edges that a policy drives reliably, as [`start`] does, and executes the path `trials` times with
/// noise.
///
/// # Errors
/// Those of [`start`].
pub fn navigate(
    task: &Navigation,
    policy: &Policy,
    rollouts: &RolloutOptions,
    options: &Options,
    trials: u64,
) -> Result<NavigationResult, Error> {
    let mut run = start(task, policy, rollouts, options)?;
    run.step(u64::MAX);
    let plan = run.result();
    let path: Vec<[f64; 2]> = plan.path.iter().map(|q| [q[0], q[1]]).collect();
    let (_, query) = task.find_query(options.query.as_deref())?;
    let executor = Executor::new(task, Some(policy))?;
    let trials = if path.is_empty() { 0 } else { trials };
    let time_step = task.robot().time_step();
    let driven = |trial| {
        let drive = executor.drive(query.start, &path, options.seed, trial)?;
        Ok((drive.outcome, drive.length(), (drive.trace.len() - 1) as f64 * time_step))
    };
    let drives = (0..trials).map(driven).collect::<Result<Vec<_>, Error>>()?;
    let is = |outcome: Outcome| share(&drives.iter().map(|drive| f64::from(drive.0 == outcome)).collect::<Vec<_>>());
    let reached = || drives.iter().filter(|drive| drive.0 == Outcome::Reached);
    let lengths: Vec<f64> = reached().map(|drive| drive.1).collect();
    let times: Vec<f64> = reached().map(|drive| drive.2).collect();
    Ok(NavigationResult {
        rollouts: edge_rollouts(task, policy, rollouts, options.seed, &path)?,
        plan,
        policy: policy.name().to_owned(),
        reached: is(Outcome::Reached),
        collisions: is(Outcome::Collision),
        swings: is(Outcome::Swing),
        driven_length: mean(&lengths),
        driven_time: mean(&times),
    })
}
