//! Readers of documents, given any bytes: they refuse them with an error that points into the document, or read them, and then
//! what was read is written, read again, and used for a little while. Each function is the target of a fuzzer, and `tests/fuzz.rs`
//! calls it on the corpus.

use planarium::certificate::{self, Certificate};
use planarium::error::Code;
use planarium::experiment::{Experiment, Trials};
use planarium::fleet::{self, CompositeOptions, Fleet, FleetOptions, FleetPlanner, FleetResult, PrioritizedOptions};
use planarium::navigation::{self, Executor, Navigation, Policy, RolloutOptions, Training, TrainingOptions};
use planarium::path::{ResultDocument, Verdict, verify};
use planarium::problem::{Status, Stepped};
use planarium::run::storage::{MAGIC, RoadmapDocument, RoadmapMetric};
use planarium::run::{self, CustomProblem, Free, LazyPrmOptions, Options, PrmOptions, Run};
use planarium::scenario::Scenario;
use planarium::timing::Trajectory;
use planarium::{Error, PlanningWorld};
use serde_json::Value as Json;
use std::sync::{Arc, LazyLock};

/// The iterations of a run.
const ITERATIONS: u64 = 40;
/// The iterations of a planner of a fleet, a multiple of 7.
const FLEET_ITERATIONS: u64 = 700;

/// A scenario: its normal form reads back as the same, and a short run keeps the laws of stepping and proof.
pub fn scenario(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let Some(scenario) = read(text, Scenario::parse) else { return };
    let normal = scenario.to_json_string();
    let again = Scenario::parse(&normal).expect("the normal form is a scenario");
    assert_eq!(again, scenario);
    assert_eq!(again.to_json_string(), normal);
    let Ok(mut run) = run::start(&scenario, Options::default()) else { return };
    let mut sliced = run::start(&scenario, Options::default()).expect("it has just started");
    run.step(ITERATIONS);
    (0..ITERATIONS).for_each(|_| {
        sliced.step(1);
    });
    assert_eq!(run.fingerprint(), sliced.fingerprint(), "slices change nothing");
    assert_valid(&scenario, &*run);
}

/// An experiment: one trial of it, and its row.
pub fn experiment(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let Some(experiment) = read(text, Experiment::parse) else { return };
    let last = experiment.trial_count() - 1;
    let experiment = Arc::new(experiment);
    for number in [0, last] {
        let Ok(mut trial) = Trials::new(&experiment).start(number) else { continue };
        trial.step(ITERATIONS);
        let row = trial.row().expect("the result is of this scenario");
        assert_eq!(row.len(), experiment.columns().len());
    }
}

/// A roadmap in either form, with its checksum made right: both forms read back as the same, and a run continues with it.
pub fn roadmap(bytes: &[u8]) {
    let mut bytes = bytes.to_vec();
    if bytes.starts_with(&MAGIC) && bytes.len() > 16 {
        // Read as damaged first: then the checksum is that of the payload.
        let _ = RoadmapDocument::read(&bytes);
        let end = bytes.len() - 8;
        let checksum = bytes[..end]
            .iter()
            .fold(0xcbf2_9ce4_8422_2325_u64, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
        bytes[end..].copy_from_slice(&checksum.to_le_bytes());
    }
    let Ok(document) = RoadmapDocument::read(&bytes) else { return };
    assert_eq!(RoadmapDocument::from_bytes(&document.to_bytes()).as_ref(), Ok(&document));
    assert_eq!(RoadmapDocument::parse(&document.to_json()).as_ref(), Ok(&document));
    document.to_graphml();
    for (i, world) in WORLDS.iter().enumerate() {
        // That of another world is refused; so it is made one of this.
        for fingerprint in [document.fingerprint, run::storage::fingerprint(world.scenario())] {
            let document = RoadmapDocument { fingerprint, ..document.clone() };
            let Ok(mut run) = run::resume(world, Options::default(), &document) else { continue };
            run.step(ITERATIONS);
            assert_valid(world.scenario(), &*run);
            assert!(run.roadmap().is_some(), "world {i}");
        }
    }
    own_roadmap(&document);
}

/// Continues the roadmap of a custom robot, all of whose space is free, and that of its fingerprint made right.
fn own_roadmap(document: &RoadmapDocument) {
    let (RoadmapMetric::Space(space), Some(q)) = (&document.metric, document.rows().next()) else { return };
    let clearance = Free::by_clearance(|_, clearances| {
        clearances.fill(f64::INFINITY);
        Ok(())
    });
    let samples = Free::by_samples(None, |_, free| {
        free.fill(true);
        Ok(())
    });
    for free in [clearance, samples] {
        let Ok(problem) = CustomProblem::new(space.clone(), free, q, &[q.to_vec()]) else { return };
        let _ = run::resume_problem(&problem, Options::default(), document).map(|mut run| run.step(ITERATIONS));
        let options = Options::new(PrmOptions { samples: Some(0), ..PrmOptions::default() });
        let own = run::start_problem(&problem, &options).expect("it is free").roadmap().expect("a roadmap");
        let document = RoadmapDocument { fingerprint: own.fingerprint, ..document.clone() };
        let Ok(mut run) = run::resume_problem(&problem, Options::default(), &document) else { continue };
        run.step(ITERATIONS);
        let again = run.roadmap().expect("a roadmap");
        assert_eq!(RoadmapDocument::from_bytes(&again.to_bytes()).as_ref(), Ok(&again));
    }
}

/// A navigation task: its normal form reads back as the same, its robot drives, and a training and a planner are the same in slices. Or a
/// policy: it reads back as the same.
pub fn navigation(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if let Some(policy) = read(text, Policy::parse) {
        assert_eq!(Policy::parse(&policy.to_json_string()).as_ref(), Ok(&policy));
    }
    let Some(task) = read(text, Navigation::parse) else { return };
    assert_eq!(Navigation::parse(&task.to_json_string()).as_ref(), Ok(&task));
    let Some(query) = task.queries().first() else { return };
    assert!(task.sense(query.start).iter().all(|distance| (0.0..=task.robot().sensor().range).contains(distance)));
    let path = [[query.start[0], query.start[1]], query.goal];
    let drive = Executor::new(&task, None).and_then(|executor| executor.drive(query.start, &path, 0, 0));
    assert!(drive.expect("its ends are checked").trace.iter().flatten().all(|x| x.is_finite()));
    let small =
        TrainingOptions { generations: 1, pairs: 2, tasks: 2, floors: 1, hidden: 2, ..TrainingOptions::default() };
    let training = || Training::new(&task, &small, 0);
    let (Ok(mut whole), Ok(mut sliced)) = (training(), training()) else { return };
    whole.step(u64::MAX);
    while sliced.step(1) == Status::Running {}
    assert_eq!(whole.fingerprint(), sliced.fingerprint(), "slices change nothing");
    let rollouts = RolloutOptions { rollouts: 1, least_share: Some(0.0), ..RolloutOptions::default() };
    let options = Options::new(LazyPrmOptions { samples: Some(8), ..LazyPrmOptions::default() });
    let run = || navigation::start(&task, &whole.policy(), &rollouts, &options);
    let (Ok(mut run), Ok(mut sliced)) = (run(), run()) else { return };
    run.step(ITERATIONS);
    (0..ITERATIONS).for_each(|_| {
        sliced.step(1);
    });
    assert_eq!(run.fingerprint(), sliced.fingerprint(), "slices change nothing");
}

/// A trajectory of one of the worlds: it reads back as the same, and the robot is somewhere at every time.
fn trajectory(text: &str) {
    for world in WORLDS.iter() {
        let scenario = world.scenario();
        let Some(trajectory) = read(text, |text| Trajectory::parse(text, scenario)) else { continue };
        assert_eq!(Trajectory::parse(&trajectory.to_json(), scenario).as_ref(), Ok(&trajectory));
        let duration = trajectory.duration();
        let states = trajectory.sampled(duration.max(1e-300) / 7.0).expect("few states");
        for state in states.chain(trajectory.rows(1e3).unwrap_or_default()) {
            assert!((0.0..=duration).contains(&state.time));
            let numbers = [state.configuration, state.velocity, state.acceleration].concat();
            assert!(numbers.iter().all(|x| x.is_finite()), "{numbers:?} at {}", state.time);
        }
    }
}

/// A result, a certificate or a trajectory: what it claims is judged, in every world.
pub fn judged(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    trajectory(text);
    if let Some(result) = read(text, ResultDocument::parse) {
        assert_eq!(ResultDocument::parse(&result.to_json()).as_ref(), Ok(&result));
        for world in WORLDS.iter() {
            let scenario = world.scenario().name().to_owned();
            let _ = verify(world.scenario(), &ResultDocument { scenario, ..result.clone() });
        }
    }
    if let Some(certificate) = read(text, Certificate::parse) {
        assert_eq!(Certificate::parse(&certificate.to_json()).as_ref(), Ok(&certificate));
        for world in WORLDS.iter() {
            let scenario = world.scenario().name().to_owned();
            let _ = certificate::verify(world.scenario(), &Certificate { scenario, ..certificate.clone() });
        }
    }
}

/// A fleet, or a plan of one: a fleet reads back as the same, slices change no plan of it, and a plan is valid for the verifier; a plan
/// that is read is judged in every fleet.
pub fn fleet(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if let Some(fleet) = read(text, Fleet::parse) {
        let normal = fleet.to_json_string();
        let again = Fleet::parse(&normal).expect("the normal form is a fleet");
        assert_eq!((&again, again.to_json_string()), (&fleet, normal));
        let prioritized = PrioritizedOptions { samples: Some(ITERATIONS as usize), ..PrioritizedOptions::default() };
        for planner in [prioritized.into(), CompositeOptions::default().into()] {
            let options = FleetOptions { planner: Some(planner), ..FleetOptions::default() };
            let Ok(mut whole) = FleetPlanner::new(&fleet, &options) else { continue };
            let mut sliced = FleetPlanner::new(&fleet, &options).expect("it has just begun");
            whole.step(FLEET_ITERATIONS);
            (0..FLEET_ITERATIONS / 7).for_each(|_| {
                sliced.step(7);
            });
            assert_plan(&fleet, &whole.result(), &sliced.result());
        }
    }
    if let Some(result) = read(text, FleetResult::parse) {
        assert_eq!(FleetResult::parse(&result.to_json()).as_ref(), Ok(&result));
        for fleet in FLEETS.iter() {
            // That of another fleet is refused; so it is made one of this.
            let mut result = FleetResult { fleet: fleet.name().to_owned(), ..result.clone() };
            let _ = fleet::verify(fleet, &result);
            result.status = Status::Solved;
            result.robots.truncate(fleet.robots().len());
            result.robots.iter_mut().zip(fleet.robots()).for_each(|(of, robot)| of.name.clone_from(&robot.name));
            if let Ok(verification) = fleet::verify(fleet, &result) {
                let fleet::Verification { conflicts, faults, claims, .. } = &verification;
                let is_clean = conflicts.is_empty() && faults.is_empty() && claims.is_empty();
                assert_eq!(verification.is_valid(), is_clean);
            }
        }
    }
}

/// The plan in one slice is that in many, reads back as the same, and is valid if there is one.
fn assert_plan(fleet: &Fleet, whole: &FleetResult, sliced: &FleetResult) {
    assert_eq!(whole, sliced, "slices change nothing");
    assert_eq!(FleetResult::parse(&whole.to_json()).as_ref(), Ok(whole));
    if whole.status == Status::Solved {
        let verification = fleet::verify(fleet, whole).expect("a plan of this fleet");
        assert!(verification.is_valid(), "{verification:?}: {}", whole.to_json());
    }
}

/// A scenario for each robot.
pub static WORLDS: LazyLock<[PlanningWorld; 4]> = LazyLock::new(|| {
    let texts = [
        include_str!("corpus/scenario/arm.json"),
        include_str!("corpus/scenario/disc.json"),
        include_str!("corpus/scenario/body.json"),
        include_str!("corpus/scenario/car.json"),
    ];
    texts.map(|text| (&Scenario::parse(text).expect("a scenario")).into())
});

/// A fleet of discs, and one of bodies.
static FLEETS: LazyLock<[Fleet; 2]> = LazyLock::new(|| {
    let texts = [include_str!("corpus/fleet/discs.json"), include_str!("corpus/fleet/bodies.json")];
    texts.map(|text| Fleet::parse(text).expect("a fleet"))
});

/// What a reader makes of a text. If it refuses it, then with a pointer to something in it, or to what is missing there.
fn read<T>(text: &str, parse: impl Fn(&str) -> Result<T, Error>) -> Option<T> {
    let error = parse(text).err();
    let Some(error) = error else { return parse(text).ok() };
    assert!(!error.message().is_empty());
    let is_whole = !matches!(error.code(), Code::InvalidJson | Code::DuplicateField | Code::TooLarge);
    if let Some(tree) = serde_json::from_str::<Json>(text).ok().filter(|_| is_whole)
        && let Some((above, _)) = error.pointer().rsplit_once('/')
    {
        assert!(tree.pointer(above).is_some(), "{error}");
    }
    None
}

/// The result of a run is a document that reads back as the same, and the path in it is valid if its edges are proven.
pub fn assert_valid(scenario: &Scenario, run: &dyn Run) {
    let result = run.result();
    assert_eq!(ResultDocument::parse(&result.to_json()).as_ref(), Ok(&result));
    if result.path.is_empty() || result.edge_check.is_some() || result.integration.is_some() {
        return;
    }
    if let Verdict::Invalid { why } = verify(scenario, &result).expect("a result of this scenario") {
        panic!("{why}: {}", result.to_json());
    }
}
