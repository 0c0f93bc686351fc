//! Sequences of calls of the public API that any bytes stand for: runs of every planner that are stepped, asked, saved, continued and
//! opened among other obstacles, and what else can be asked of a world. No sequence panics; at its end every path is valid, and a
//! run is the same as one that was stepped by itself.

use super::readers::{WORLDS, assert_valid};
use arbitrary::{Result, Unstructured};
use planarium::certificate::{self, Subdivision};
use planarium::driving::{Drive, Key};
use planarium::geometry::Point;
use planarium::ik::{self, Solver, SolverOptions};
use planarium::options::{Kind, OptionInfo, Options as _};
use planarium::problem::Stepped;
use planarium::robot::Target;
use planarium::run::inspect::Inspector;
use planarium::run::neighbours::{IndexOptions, index, indexes};
use planarium::run::storage::RoadmapDocument;
use planarium::run::{self, Options, PlannerOptions, Request, Run, Value, planners};
use planarium::scenario::{Obstacle, Robot, Scenario};
use planarium::trajectories::{Trajectories, TrajectoryOptions};
use planarium::{PlanningWorld, optimum};

/// The most calls, and the most iterations that one makes.
const CALLS: usize = 40;
const ITERATIONS: u64 = 60;

/// Plays the sequence of calls that bytes stand for.
pub fn calls(bytes: &[u8]) {
    let mut bytes = Unstructured::new(bytes);
    play(&mut bytes).expect("bytes that have run out are zeros");
}

/// A run, its world, and what it takes to begin it again.
struct Started {
    world: PlanningWorld,
    options: Options,
    run: Box<dyn Run>,
    /// Whether it is as its options and its iterations say: not continued, not ended early, nothing added.
    is_plain: bool,
}

fn play(u: &mut Unstructured) -> Result<()> {
    let world = u.choose(&*WORLDS)?.clone();
    let mut runs: Vec<Started> = Vec::new();
    for _ in 0..CALLS {
        if u.is_empty() {
            break;
        }
        if runs.is_empty() || u.ratio(1, 8)? {
            let (call, request) = (u.int_in_range(0..=5)?, request(u, &world)?);
            match call {
                0 => look(u, &world)?,
                1 => reach(u, &world)?,
                2 => drive(u, &world)?,
                3 => subdivide(u, &world)?,
                _ => {
                    let Ok(options) = request.for_robot(world.scenario().robot()) else { continue };
                    if let Ok(run) = run::start(&world, &options) {
                        runs.push(Started { world: world.clone(), options, run, is_plain: true });
                    }
                }
            }
            continue;
        }
        let at = u.choose_index(runs.len())?;
        if let Some(other) = call(u, &mut runs[at])? {
            runs.push(other);
        }
        if runs.len() > 3 {
            check(runs.remove(0));
        }
    }
    runs.into_iter().for_each(check);
    Ok(())
}

/// One call on a run; a run that it begins.
fn call(u: &mut Unstructured, started: &mut Started) -> Result<Option<Started>> {
    let Started { world, options, run, is_plain } = started;
    match u.int_in_range(0..=9)? {
        0..=2 => drop(run.step(u.int_in_range(0..=ITERATIONS)?)),
        3 => {
            *is_plain = false;
            run.finish();
        }
        4 => drop(run.record()),
        5 => {
            let row = u.choose(&[0, 1, 7, usize::MAX])?;
            let _ = (run.vertex_rows(*row), run.edge_rows(*row), run.event_rows(*row), run.history_since(*row));
            let _ = (run.motion_rows(*row), run.trace_rows(*row), run.goals(), run.raw_path(), run.length());
        }
        6 => {
            let hits = run.first_hits(&numbers(u, 2 * run.dimension())?);
            assert!(hits.into_iter().flatten().all(|part| (0.0..=1.0).contains(&part)));
        }
        7 => {
            let (start, goal) = (numbers(u, run.dimension())?, numbers(u, run.dimension())?);
            let keep = u.arbitrary()?;
            *is_plain &= run.query(&start, &goal, keep).is_err() || !keep;
        }
        8 => {
            let Some(roadmap) = run.roadmap() else { return Ok(None) };
            assert_eq!(RoadmapDocument::from_bytes(&roadmap.to_bytes()).as_ref(), Ok(&roadmap));
            // A start in collision is moved again.
            let planner = options.planner.expect("one was chosen");
            let moved = planner.changes().into_iter().filter(|change| change.name == "free_ends");
            let moved: Vec<_> = moved.map(|change| (change.name.to_owned(), change.value)).collect();
            let planner = PlannerOptions::read(planner.id(), &moved).expect("it was read before");
            let again = Options { seed: 1, query: options.query.clone(), ..Options::new(planner) };
            let resumed = run::resume(&*world, &again, &roadmap);
            let resumed = resumed.unwrap_or_else(|error| panic!("its own roadmap: {error}"));
            return Ok(Some(Started { world: world.clone(), options: again, run: resumed, is_plain: false }));
        }
        _ => {
            let other = moved(u, world.scenario())?;
            let Ok(reopened) = run.reopen(&other) else { return Ok(None) };
            return Ok(Some(Started { world: other, options: options.clone(), run: reopened, is_plain: false }));
        }
    }
    Ok(None)
}

/// What holds of every run.
fn check(Started { world, options, run, is_plain }: Started) {
    assert_eq!(run.vertex_rows(0).len(), run.vertex_count() * run.dimension());
    assert_eq!(run.edge_rows(0).len(), run.edge_count() * 2);
    assert!(run.edge_rows(0).iter().all(|&vertex| (vertex as usize) < run.vertex_count()));
    assert_valid(world.scenario(), &*run);
    if is_plain {
        let mut other = run::start(&world, &options).expect("it was started before");
        other.step(run.iterations());
        assert_eq!(other.fingerprint(), run.fingerprint(), "{options:?}");
        assert_eq!(other.path(), run.path(), "{options:?}");
    }
}

/// Questions about a world.
fn look(u: &mut Unstructured, world: &PlanningWorld) -> Result<()> {
    let inspector = Inspector::new(world);
    let (a, b) = (numbers(u, inspector.dimension())?, numbers(u, inspector.dimension())?);
    let t = number(u)?;
    let _ = (inspector.check(&a), inspector.footprint(&a), inspector.end_effector(&a), inspector.clearance(&a));
    let _ = (inspector.interpolate(&a, &b, t), inspector.interpolate_by_sign(&a, &b, t), inspector.distance(&a, &b));
    if let Ok(Some(hit)) = inspector.first_hit(&a, &b) {
        assert!((0.0..=1.0).contains(&hit));
    }
    let _ = inspector.configuration_space(u.int_in_range(0..=9)?, u.int_in_range(0..=9)?);
    let _ = inspector.samples(u.int_in_range(0..=50)?, u.arbitrary()?, u.arbitrary()?);
    let indexes = indexes();
    let kind = u.choose(&indexes)?;
    let parameters = parameters(u, &kind.parameters)?;
    if let Ok(mut index) = IndexOptions::read(Some(kind.id), &parameters).and_then(|options| index(world, &options)) {
        let (before, rows) = (index.len(), numbers(u, 4 * inspector.dimension())?);
        let added = index.add(&rows).map_or(0, |()| rows.len() / index.dimension());
        assert_eq!(index.len(), before + added);
        if let Ok(found) = index.k_nearest(&a, u.int_in_range(0..=9)?) {
            assert!(found.neighbours.is_sorted_by(|a, b| a.distance <= b.distance));
        }
        let _ = index.within(&a, t);
    }
    Ok(())
}

/// Inverse kinematics, and trajectories.
fn reach(u: &mut Unstructured, world: &PlanningWorld) -> Result<()> {
    let target =
        Target { point: Point::new(number(u)?, number(u)?), orientation: u.ratio(1, 2)?.then_some(number(u)?) };
    let methods = ik::methods();
    let method = u.choose(&methods)?;
    let start = if u.arbitrary()? { Some(numbers(u, 2)?) } else { None };
    let (seed, parameters_of_method) = (u.arbitrary()?, parameters(u, &method.options)?);
    let begun = ik::MethodOptions::read(Some(method.id), &parameters_of_method)
        .and_then(|method| Solver::new(world, &SolverOptions { target, method, start, seed }));
    if let Ok(mut solver) = begun {
        solver.step(ITERATIONS);
        let _ = (solver.explain(), solver.result().to_json());
    }
    if let Robot::Arm(arm) = world.scenario().robot() {
        let _ = (ik::follow(arm, &numbers(u, 2)?, target), ik::nearest_reachable(arm, target));
    }
    let given = parameters(u, &TrajectoryOptions::table())?;
    let seed = u.arbitrary()?;
    let begun = TrajectoryOptions::read(&given).and_then(|options| Trajectories::new(&options, seed));
    if let Ok(mut trajectories) = begun {
        trajectories.step(ITERATIONS);
        trajectories.result();
    }
    Ok(())
}

/// A car that is driven, and driven again by its record.
fn drive(u: &mut Unstructured, world: &PlanningWorld) -> Result<()> {
    let start = if u.arbitrary()? { Some(numbers(u, 3)?) } else { None };
    let Ok(mut drive) = Drive::new(world, start.as_deref()) else { return Ok(()) };
    for _ in 0..u.int_in_range(0..=20)? {
        let _ = drive.press(*u.choose(&[Key::Faster, Key::Slower, Key::Left, Key::Right, Key::Keep])?);
        let _ = drive.tick(u.int_in_range(0..=40)?);
    }
    let mut again = Drive::new(world, start.as_deref()).expect("it was started before");
    again.replay(drive.record(), drive.steps()).expect("its own record");
    assert_eq!(again.trace(), drive.trace());
    Ok(())
}

/// A certificate, judged by other code; and the shortest path.
fn subdivide(u: &mut Unstructured, world: &PlanningWorld) -> Result<()> {
    let clearance = number(u)?;
    let options =
        certificate::Options { clearance, cells: u.int_in_range(0..=200)?, ..certificate::Options::default() };
    if let Ok(mut subdivision) = Subdivision::new(world, &options) {
        subdivision.step(ITERATIONS);
        let _ = subdivision.greatest_clearance();
        if subdivision.verdict().is_some() {
            let certificate = subdivision.certificate();
            assert_eq!(certificate::verify(world.scenario(), &certificate), Ok(None), "{}", certificate.to_json());
        }
    }
    if matches!(world.scenario().robot(), Robot::Disc(_)) {
        let _ = optimum::optimum(world, None, optimum::MetricOptions::default());
    }
    Ok(())
}

/// The same world with its first obstacle elsewhere, or without it.
fn moved(u: &mut Unstructured, scenario: &Scenario) -> Result<PlanningWorld> {
    let mut tree: serde_json::Value = serde_json::from_str(&scenario.to_json_string()).expect("JSON");
    let (dx, dy) = (small(u)? / 4.0, small(u)? / 4.0);
    let center = match scenario.world().obstacles.first() {
        Some(Obstacle::Disc(disc)) => [disc.center.x + dx, disc.center.y + dy],
        _ => [dx, dy],
    };
    let disc = serde_json::json!({ "type": "disc", "center": center, "radius": 0.2 });
    tree["world"]["obstacles"] = if u.arbitrary()? { vec![disc].into() } else { Vec::<i32>::new().into() };
    Ok((&Scenario::parse(&tree.to_string()).unwrap_or_else(|_| scenario.clone())).into())
}

/// A run, requested by names.
fn request(u: &mut Unstructured, world: &PlanningWorld) -> Result<Request> {
    let planners = planners();
    let planner = u.choose(&planners)?;
    let queries = world.scenario().queries();
    Ok(Request {
        planner: Some(planner.info().id.to_owned()),
        query: Some(u.choose(queries)?.name.clone()),
        seed: u.int_in_range(0..=255)?,
        parameters: parameters(u, &planner.table())?,
        events: u.arbitrary()?,
    })
}

/// A few options of a table, each once, seldom out of range.
fn parameters(u: &mut Unstructured, table: &[OptionInfo]) -> Result<Vec<(String, Value)>> {
    let mut given: Vec<(String, Value)> = Vec::new();
    for _ in 0..u.int_in_range(0..=4)? {
        if table.is_empty() {
            break;
        }
        let option = u.choose(table)?;
        let value = match &option.kind {
            Kind::Switch => Value::Boolean(u.arbitrary()?),
            Kind::Choice(words) => Value::Text((*u.choose(words)?).to_owned()),
            Kind::Integer(range) | Kind::Number(range) if u.ratio(1, 16)? => {
                Value::Number(*u.choose(&[*range.start(), *range.end(), -1.0, f64::NAN])?)
            }
            Kind::Integer(range) => {
                Value::Number((f64::from(u.int_in_range(0..=60)?)).clamp(*range.start(), *range.end()))
            }
            Kind::Number(range) => Value::Number(small(u)?.clamp(*range.start(), *range.end())),
        };
        if given.iter().all(|(name, _)| *name != option.name) {
            given.push((option.name.to_owned(), value));
        }
    }
    Ok(given)
}

/// Some numbers, nearly always as many as wanted.
fn numbers(u: &mut Unstructured, wanted: usize) -> Result<Vec<f64>> {
    let count = if u.ratio(1, 16)? { u.int_in_range(0..=9)? } else { wanted };
    (0..count).map(|_| number(u)).collect()
}

/// A number, nearly always a small one.
fn number(u: &mut Unstructured) -> Result<f64> {
    if u.ratio(1, 16)? { u.arbitrary() } else { small(u) }
}

/// A number from -4 to 4.
fn small(u: &mut Unstructured) -> Result<f64> {
    Ok(f64::from(u.arbitrary::<i16>()?) / 8192.0)
}
