//! Continuing with a saved roadmap: whether it fits the scenario, or the space of a robot of one's own, whether all of it is free, and which options it admits.

use super::custom::{CustomProblem, launch_problem};
use super::factory::{launch, only_metric};
use super::{Options, Run};
use crate::error::{Code, Error, quoted};
use crate::options::{Choice, Options as _, Value, out_of_range, refusal};
use crate::planner::{EdgeCheck, Grows, Improving, Limits, PlannerOptions, Searching};
use crate::random::check_seed;
use crate::robot::Car;
use crate::run::storage::{RoadmapDocument, RoadmapMetric, damaged, fingerprint, fingerprint_of_space};
use crate::scenario::Robot;
use crate::space::MetricKind;
use crate::space::steering::Steering;
use crate::world::PlanningWorld;

/// Begins a run of the planner that built the roadmap, with the roadmap as it was saved: start and goals of the query are its
/// first vertices, connected to their neighbours unless the roadmap has them already, and it is searched. The
/// roadmap is not extended, even if it was saved unfinished. First every vertex is checked and every edge proven again; a roadmap whose edges were
/// sampled is sampled again, and still named as such.
///
/// How the roadmap was built is the document's: `options` name its planner, how to search, and what to do with the path.
/// Parameters that the document holds (`metric`, `steering`, `k`, `radius`, `edge_check`, `edge_samples`, `tolerance`) may be given
/// again.
///
/// # Errors
/// `other-scenario` if world or robot are not those that the roadmap was built for; `invalid-roadmap`, with a pointer into
/// the JSON form, if the document contradicts itself, a vertex lies outside the space or in collision, or an edge is not
/// free; `out-of-range` if another planner or another value of what the document holds is given, `unsupported` for
/// parameters of a growth that is over; and those of [`start`](super::start).
pub fn resume(
    scenario: impl Into<PlanningWorld>,
    options: &Options,
    document: &RoadmapDocument,
) -> Result<Box<dyn Run>, Error> {
    let world = scenario.into();
    let scenario = world.scenario();
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
        return Err(damaged("/metric", "the metric is that of a robot of one's own"));
    }
    let dimension = scenario.robot().dimension();
    if document.dimension() != dimension {
        let sentence = format!("this robot has {dimension} coordinates, not {}", document.dimension());
        return Err(damaged("/dimension", sentence));
    }
    let robot = scenario.robot();
    // A car's roadmap is one of curves.
    let steering = if let Robot::Car(car) = robot { Some(steering(car, document)?) } else { None };
    let only = (!matches!(robot, Robot::Arm(_) | Robot::Car(_))).then(|| only_metric(robot));
    if let Some(metric) = only.filter(|metric| document.metric != *metric) {
        let sentence = format!("the metric of this robot is {metric}, not {}", document.metric);
        return Err(damaged("/metric", sentence));
    }
    let planner = settings(builder(options, document)?, options, document, steering)?;
    launch(&world, options, planner, Some(document))
}

/// The same for a robot of one's own: its function proves or samples all of the roadmap again, whatever function it was built with. So a
/// roadmap can be continued after obstacles have moved, as long as all of it is still free. Start and goals are those of the problem.
///
/// # Errors
/// `other-scenario` with a pointer into the JSON form if the roadmap was built in another space (other coordinates, limits or weights, or
/// another metric), or if edges were sampled by `Free::Samples` and are to be proven, or the reverse; `invalid-roadmap`, `out-of-range`
/// and `unsupported` as [`resume`]; those of [`start_problem`](super::start_problem); the error of the function.
pub fn resume_problem(
    problem: &CustomProblem,
    options: &Options,
    document: &RoadmapDocument,
) -> Result<Box<dyn Run>, Error> {
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
    let planner = settings(builder(options, document)?, options, document, None)?;
    launch_problem(problem, options, planner, Some(document))
}

/// The planner that built the roadmap.
fn builder(options: &Options, document: &RoadmapDocument) -> Result<PlannerOptions, Error> {
    let builds_roadmap = |planner: &PlannerOptions| planner.grows() == Grows::Roadmap;
    let Some(planner) = PlannerOptions::of(&document.planner).ok().filter(builds_roadmap) else {
        return Err(damaged(
            "/planner",
            format!("{} is not a planner that builds a roadmap", quoted(&document.planner)),
        ));
    };
    if let Some(other) = options.planner.as_ref().filter(|other| *other != planner.id()) {
        let sentence = format!("the roadmap was built by {}, not {other}", planner.id());
        return Err(Error::new(Code::OutOfRange, "/algorithm", sentence));
    }
    check_seed(options.seed)?;
    Ok(planner)
}

/// How the car was steered when the roadmap was built.
fn steering(car: &Car, document: &RoadmapDocument) -> Result<Steering, Error> {
    let radius = car.turning_radius().map(|(radius, _)| radius);
    document.metric.curves().filter(|&(_, known)| radius == Some(known)).map(|(steering, _)| steering).ok_or_else(
        || {
            let known = radius.map_or("none".to_owned(), |radius| {
                let known = [Steering::Dubins, Steering::ReedsShepp].map(|word| RoadmapMetric::of_curves(word, radius));
                known.map(|metric| metric.to_string()).join(" or ")
            });
            damaged("/metric", format!("the metric of this car is {known}, not {}", document.metric))
        },
    )
}

/// The options of the run: the values stored in the document, and the given options that may still be chosen.
fn settings(
    planner: PlannerOptions,
    options: &Options,
    document: &RoadmapDocument,
    steering: Option<Steering>,
) -> Result<PlannerOptions, Error> {
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
    all.extend(steering.map(|steering| text("steering", steering.word())));
    all.extend(document.edge_samples.map(|samples| number("edge_samples", f64::from(samples))));
    planner.read(&all).map_err(|error| damaged(error.pointer(), error.message()))?;
    let stored = [&all[..], &[number("k", f64::from(document.k)), number("radius", document.radius)]].concat();
    // Options about the use of a roadmap, not about its construction.
    let is_free = |name: &str| Searching::has(name) || Improving::has(name) || Limits::has(name);
    for (name, value) in &options.parameters {
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
    planner.read(&all)
}
