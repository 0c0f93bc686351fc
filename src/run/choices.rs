//! From a planner's parameters to the planner: where the names of planners, samplers and searches become types.

use super::controls::{rrt_control_options, sst_options};
use crate::decimal::Decimal;
use crate::error::{Code, Error};
use crate::kept::RoadmapDocument;
use crate::planner::{
    Algorithm, Connection, Cost, Extend, GoalBias, Heuristic, Order, Parameters, Planner, Prm, PrmOptions, Rrt,
    RrtConnect, RrtControl, RrtOptions, SearchRules, Sst, VisibilityPrm, logarithmic_k, prm_star_k,
};
use crate::problem::Problem;
use crate::random::{Random, Stream};
use crate::sampling::{BridgeTest, Gaussian, GoalBiased, Halton, Lattice, ObstacleBased, Sampler, Uniform};
use crate::space::Space;

/// Of the space's extent, the step taken where none is given.
const DEFAULT_STEP: f64 = 0.2;
/// Of the space's extent, the smallest step: it bounds the motions of one greedy connection.
const SMALLEST_STEP: f64 = 1e-4;
/// Of the space's extent a dimension, the deviation of samplers where none is given.
const DEFAULT_SPREAD: f64 = 0.05;
/// The number of neighbours where neither it nor a radius is given.
const DEFAULT_K: u64 = 15;
/// More guards than there ever are.
const MOST_GUARDS: usize = 1_000_000;
/// The most motions that a roadmap may try: it keeps what became of each.
const MOST_MOTIONS: u64 = 20_000_000;

/// The planner of the given id at its beginning.
pub(super) fn planner<S: Space + 'static>(
    id: &str,
    parameters: &Parameters,
    problem: &Problem<S>,
    seed: u64,
) -> Result<Box<dyn Planner<S>>, Error> {
    let space = problem.space();
    let sampler = sampler(parameters, space, seed);
    Ok(match id {
        "prm" | "prm-star" => Box::new(Prm::new(problem, &prm_options(id, parameters, space.dimension())?, sampler)),
        "visibility-prm" => {
            // Guards are few: questions are joined to all that see them.
            let connection = Connection { k: MOST_GUARDS, radius: f64::INFINITY };
            let failures = parameters.integer("failures") as u32;
            Box::new(VisibilityPrm::new(problem, failures, connection, rules(parameters), sampler))
        }
        "rrt" => {
            let options = RrtOptions {
                step: step(parameters, space.extent())?,
                extend: extend(parameters),
                bias: bias(parameters),
            };
            Box::new(Rrt::new(problem, options, sampler, Random::new(seed, Stream::Bias)))
        }
        "rrt-connect" => Box::new(RrtConnect::new(problem, step(parameters, space.extent())?, sampler)),
        "rrt-control" => {
            let options = rrt_control_options(parameters, problem)?;
            Box::new(RrtControl::new(problem, options, sampler, driving(seed)))
        }
        "sst" => Box::new(Sst::new(problem, sst_options(parameters, problem)?, sampler, driving(seed))),
        other => unreachable!("the catalogue lists {other}, nothing here makes it"),
    })
}

/// The streams that decide when a tree reaches for the goal, and what is driven.
fn driving(seed: u64) -> [Random; 2] {
    [Stream::Bias, Stream::Controls].map(|stream| Random::new(seed, stream))
}

/// A planner that goes on with a roadmap that was built: one for all kinds, as none grows any more.
pub(super) fn resumed<S: Space + 'static>(
    parameters: &Parameters,
    problem: &Problem<S>,
    seed: u64,
    document: &RoadmapDocument,
    states: &[S::State],
) -> Box<dyn Planner<S>> {
    let connection = Connection { k: document.k as usize, radius: document.radius };
    // It draws nothing any more.
    let sampler = Box::new(Uniform::new(Random::new(seed, Stream::Samples)));
    Box::new(Prm::resume(problem, connection, rules(parameters), sampler, states, &document.edges))
}

/// How a PRM or PRM* is built.
fn prm_options(id: &str, parameters: &Parameters, dimension: usize) -> Result<PrmOptions, Error> {
    let samples = parameters.integer("samples");
    let vertices = samples as usize + 2;
    let star_k = |rule: Option<&str>| match rule {
        Some("log-n") => logarithmic_k(vertices),
        _ => prm_star_k(vertices, dimension),
    };
    let is_star = id == "prm-star";
    let radius = if is_star { None } else { parameters.number("radius") };
    let k = match (is_star, radius) {
        (true, _) => star_k(parameters.text("k_rule")) as u64,
        (false, None) => parameters.number("k").map_or(DEFAULT_K, |k| k as u64),
        // All within the radius.
        (false, Some(_)) => parameters.number("k").map_or(vertices as u64, |k| k as u64),
    };
    if samples * k > MOST_MOTIONS {
        let sentence = format!(
            "samples times k (without k all samples, where there is a radius) must be at most {MOST_MOTIONS}, not {samples} times {k}"
        );
        return Err(Error::new(Code::OutOfRange, "/samples", sentence));
    }
    let order = match (is_star, parameters) {
        (false, given) if given.text("insertion") == Some("one-by-one") => {
            Order::OneByOne { discard: given.is_on("discard") }
        }
        (false, given) if given.is_on("discard") => {
            let sentence = "samples can be discarded only where insertion is \"one-by-one\", not \"batch\"";
            return Err(Error::new(Code::OutOfRange, "/discard", sentence));
        }
        _ => Order::Batch,
    };
    let connection = Connection { k: k as usize, radius: radius.unwrap_or(f64::INFINITY) };
    Ok(PrmOptions { samples: samples as usize, connection, order, rules: rules(parameters) })
}

fn sampler<S: Space>(parameters: &Parameters, space: &S, seed: u64) -> Box<dyn Sampler<S>> {
    let random = Random::new(seed, Stream::Samples);
    let default = DEFAULT_SPREAD * space.extent() / space.dimension() as f64;
    let spread = parameters.number("spread").unwrap_or(default);
    match parameters.text("sampler") {
        Some("halton") => Box::new(Halton::new(random)),
        Some("lattice") => Box::new(Lattice::new(space.dimension(), random)),
        Some("gaussian") => Box::new(Gaussian::new(random, spread)),
        Some("bridge") => Box::new(BridgeTest::new(random, spread)),
        Some("obstacle-based") => Box::new(ObstacleBased::new(random)),
        Some("goal-biased") => Box::new(GoalBiased::new(random, spread)),
        _ => Box::new(Uniform::new(random)),
    }
}

fn rules(parameters: &Parameters) -> SearchRules {
    let algorithm = match parameters.text("search") {
        Some("dijkstra") => Algorithm::Dijkstra,
        Some("breadth-first") => Algorithm::BreadthFirst,
        Some("bidirectional") => Algorithm::Bidirectional,
        _ => Algorithm::AStar,
    };
    let cost = if parameters.text("cost") == Some("hops") { Cost::Hops } else { Cost::Metric };
    let heuristic = match parameters.text("heuristic") {
        Some("end-effector") => Heuristic::EndEffector,
        Some("metric-as-hops") => Heuristic::MetricAsHops,
        Some("none") => Heuristic::None,
        _ => Heuristic::Metric,
    };
    SearchRules { algorithm, cost, heuristic }
}

fn extend(parameters: &Parameters) -> Extend {
    match parameters.text("extend") {
        Some("half") => Extend::Half,
        Some("until-obstacle") => Extend::UntilObstacle,
        _ => Extend::Step,
    }
}

pub(super) fn bias(parameters: &Parameters) -> GoalBias {
    let share = parameters.number("goal_bias").expect("the goal bias has a fixed default");
    parameters.number("goal_every").map_or(GoalBias::Share(share), |n| GoalBias::Every(n as u32))
}

/// The step given, or the default for a space of this extent.
fn step(parameters: &Parameters, extent: f64) -> Result<f64, Error> {
    let Some(step) = parameters.number("step") else { return Ok(DEFAULT_STEP * extent) };
    let smallest = SMALLEST_STEP * extent;
    if step < smallest {
        let [smallest, step] = [smallest, step].map(Decimal);
        let sentence = format!("step must be at least {smallest}, a 10,000th of the space's extent, not {step}");
        return Err(Error::new(Code::OutOfRange, "/step", sentence));
    }
    Ok(step)
}
