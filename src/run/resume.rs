//! Continuing with a saved roadmap: whether it fits the scenario, or the space of a custom robot, whether all of it is
//! free, and which options it admits.

use super::custom::{CustomProblem, launch_problem};
use super::factory::{launch, only_metric};
use super::{Options, Run};
use crate::error::{Code, Error, quoted};
use crate::options::{Choice, Options as _, Value, out_of_range, refusal};
use crate::planner::{EdgeCheck, Grows, Improving, KeepingAway, Limits, PlannerOptions, Searching};
use crate::random::check_seed;
use crate::robot::Car;
use crate::run::storage::{RoadmapDocument, RoadmapMetric, damaged, fingerprint, fingerprint_of_space};
use crate::scenario::{Robot, Scenario};
use crate::space::MetricKind;
use crate::space::steering::Steering;
use crate::world::PlanningWorld;

/// Begins a run of the planner that built the roadmap, with the roadmap as it was saved: start and goals of the query are its
/// first vertices, connected to their neighbours unless the roadmap has them already, and it is searched. The roadmap is not
/// extended, even if it was saved unfinished. First every vertex is checked and every edge proven again; a roadmap whose edges
/// were sampled is sampled again, and still named as such.
///
/// How the roadmap was built is the document's: `options` name its planner, how to search, and what to do with the path.
/// Parameters that the document holds (`metric`, `steering`, `k`, `radius`, `edge_check`, `edge_samples`, `tolerance`) may be
/// given again. An option with its default counts as not given: the value of the document holds.
/// [`Request::for_roadmap`](super::Request::for_roadmap) reads which parameters were given by name, and refuses those too.
///
/// # Errors
/// `other-scenario` if world or robot are not those that the roadmap was built for; `invalid-roadmap`, with a pointer into
/// the JSON form, if the document contradicts itself, a vertex lies outside the space or in collision, or an edge is not
/// free; `out-of-range` if another planner or another value of what the document holds is given, `unsupported` for
/// parameters of a growth that is over; and those of [`start`](super::start).
pub fn resume(
    scenario: impl Into<PlanningWorld>,
    options: impl Into<Options>,
    document: &RoadmapDocument,
) -> Result<Box<dyn Run>, Error> {
    let world = scenario.into();
    check_scenario(world.scenario(), document)?;
    launch(&world, continued(&options.into(), document)?, Some(document))
}

/// Refuses a roadmap of another world or robot.
pub(super) fn check_scenario(scenario: &Scenario, document: &RoadmapDocument) -> Result<(), Error> {
    document.check()?;
    let found = fingerprint(scenario);
    if document.fingerprint != found {
        let sentence = format!(
            "the roadmap was built for another world or robot (of scenario {}, fingerprint {:016x}, not {found:016x})",
            quoted(&document.scenario),
            document.fingerprint
        );
        return Err(Error::new(Code::OtherScenario, "/fingerprint", sentence));
    }
    if matches!(document.metric, RoadmapMetric::Space(_)) {
        return Err(damaged("/metric", "the metric is that of a custom robot"));
    }
    let dimension = scenario.robot().dimension();
    if document.dimension() != dimension {
        let sentence = format!("this robot has {dimension} coordinates, not {}", document.dimension());
        return Err(damaged("/dimension", sentence));
    }
    let robot = scenario.robot();
    // A car's roadmap is one of curves.
    if let Robot::Car(car) = robot {
        check_curves(car, document)?;
    }
    let only = (!matches!(robot, Robot::Arm(_) | Robot::Car(_))).then(|| only_metric(robot));
    if let Some(metric) = only.filter(|metric| document.metric != *metric) {
        let sentence = format!("the metric of this robot is {metric}, not {}", document.metric);
        return Err(damaged("/metric", sentence));
    }
    Ok(())
}

/// The same for a custom robot: its function proves or samples all of the roadmap again, whatever function it was built
/// with. So a roadmap can be continued after obstacles have moved, as long as all of it is still free. Start and goals are those
/// of the problem.
///
/// # Errors
/// `other-scenario` with a pointer into the JSON form if the roadmap was built in another space (other coordinates, limits or
/// weights, or another metric), or if edges were sampled by `Free::Samples` and are to be proven, or the reverse;
/// `invalid-roadmap`, `out-of-range` and `unsupported` as [`resume`]; those of [`start_problem`](super::start_problem); the error
/// of the function.
pub fn resume_problem(
    problem: &CustomProblem,
    options: impl Into<Options>,
    document: &RoadmapDocument,
) -> Result<Box<dyn Run>, Error> {
    check_problem(problem, document)?;
    launch_problem(problem, &continued(&options.into(), document)?, Some(document))
}

/// Refuses a roadmap of another space, or whose edges were checked in another way.
pub(super) fn check_problem(problem: &CustomProblem, document: &RoadmapDocument) -> Result<(), Error> {
    document.check()?;
    let other = |pointer: &str, sentence| Err(Error::new(Code::OtherScenario, pointer, sentence));
    let RoadmapMetric::Space(built) = &document.metric else {
        let sentence = format!("the roadmap was built for scenario {}, not for this robot", quoted(&document.scenario));
        return other("/metric", sentence);
    };
    let space = problem.space().in_full();
    if let Some((pointer, [there, here])) = built.difference(&space) {
        let sentence = format!("the roadmap was built in another space: {there}, here {here}");
        return other(&format!("/metric/space{pointer}"), sentence);
    }
    if document.fingerprint != fingerprint_of_space(&space) {
        return Err(damaged("/fingerprint", "the fingerprint is not that of the space"));
    }
    let is_at_resolution = document.edge_check == EdgeCheck::Sampled && document.edge_samples.is_none();
    if is_at_resolution != problem.is_sampled() {
        let [there, here] = [is_at_resolution, problem.is_sampled()]
            .map(|is_sampled| if is_sampled { "whether a configuration is free" } else { "a bound on clearance" });
        return other("/edge_check", format!("the roadmap was built with {there}, and the problem tells {here}"));
    }
    Ok(())
}

/// The planner that built the roadmap.
fn builder(named: Option<&str>, document: &RoadmapDocument) -> Result<PlannerOptions, Error> {
    let builds_roadmap = |planner: &PlannerOptions| planner.grows() == Grows::Roadmap;
    let Some(planner) = PlannerOptions::of(&document.planner).ok().filter(builds_roadmap) else {
        return Err(damaged(
            "/planner",
            format!("{} is not a planner that builds a roadmap", quoted(&document.planner)),
        ));
    };
    if let Some(other) = named.filter(|other| *other != planner.id()) {
        let sentence = format!("the roadmap was built by {}, not {other}", planner.id());
        return Err(Error::new(Code::OutOfRange, "/algorithm", sentence));
    }
    Ok(planner)
}

/// The options of a run on the roadmap. What differs from its default in those given has been chosen.
fn continued(options: &Options, document: &RoadmapDocument) -> Result<Options, Error> {
    check_seed(options.seed)?;
    let planner = match options.planner {
        None => settings(None, &[], document)?,
        Some(planner) => {
            planner.check()?;
            let changes = planner.changes().into_iter().map(|change| (change.name.to_owned(), change.value));
            settings(Some(planner.id()), &changes.collect::<Vec<_>>(), document)?
        }
    };
    Ok(Options { planner: Some(planner), ..options.clone() })
}

/// Refuses a roadmap that was not built with curves of this car.
fn check_curves(car: &Car, document: &RoadmapDocument) -> Result<(), Error> {
    let radius = car.turning_radius().map(|(radius, _)| radius);
    if document.metric.curves().is_some_and(|(_, known)| radius == Some(known)) {
        return Ok(());
    }
    let known = radius.map_or("none".to_owned(), |radius| {
        let known = [Steering::Dubins, Steering::ReedsShepp].map(|word| RoadmapMetric::of_curves(word, radius));
        known.map(|metric| metric.to_string()).join(" or ")
    });
    Err(damaged("/metric", format!("the metric of this car is {known}, not {}", document.metric)))
}

/// The planner of a run on the roadmap, whose id may be given: with the options that the document holds, and of those given by
/// name those that may still be chosen.
pub(super) fn settings(
    named: Option<&str>,
    given: &[(String, Value)],
    document: &RoadmapDocument,
) -> Result<PlannerOptions, Error> {
    let planner = builder(named, document)?;
    let number = |name: &str, value: f64| (name.to_owned(), Value::Number(value));
    let text = |name: &str, value: &str| (name.to_owned(), Value::Text(value.to_owned()));
    // An option chooses among the metrics of joints; that of placements is the scenario's.
    let metric = match document.metric {
        RoadmapMetric::Sum => Some(MetricKind::Sum),
        RoadmapMetric::Euclidean => Some(MetricKind::Euclidean),
        RoadmapMetric::Naive => Some(MetricKind::Naive),
        RoadmapMetric::Placement { .. }
        | RoadmapMetric::Dubins { .. }
        | RoadmapMetric::ReedsShepp { .. }
        | RoadmapMetric::Space(_) => None,
    };
    let mut all = vec![number("tolerance", document.tolerance)];
    // Else edges are sampled at the resolution of a problem, whatever the options.
    if document.edge_check != EdgeCheck::Sampled || document.edge_samples.is_some() {
        all.push(text("edge_check", document.edge_check.word()));
    }
    all.extend(metric.map(|metric| text("metric", metric.word())));
    all.extend(document.metric.curves().map(|(steering, _)| text("steering", steering.word())));
    all.extend(document.edge_samples.map(|samples| number("edge_samples", f64::from(samples))));
    planner.updated(&all).map_err(|error| damaged(error.pointer(), error.message()))?;
    let stored = [&all[..], &[number("k", f64::from(document.k)), number("radius", document.radius)]].concat();
    // Options about the use of a roadmap, not about its construction.
    let is_free =
        |name: &str| Searching::has(name) || Improving::has(name) || KeepingAway::has(name) || Limits::has(name);
    for (name, value) in given {
        let is_known = planner.has(name);
        match stored.iter().find(|(other, _)| is_known && other == name) {
            Some((_, stored)) if stored == value => {}
            Some((_, stored)) => {
                return Err(out_of_range(name, format!("the roadmap was built with {name} = {stored}, not {value}")));
            }
            None if is_known && !is_free(name) => {
                let sentence = format!("{name} affects how a roadmap is built; this one is complete");
                return Err(refusal(Code::Unsupported, name, sentence));
            }
            None => all.push((name.clone(), value.clone())),
        }
    }
    planner.updated(&all)
}
