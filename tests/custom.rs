//! Robots of one's own: told by a space and by what is free, through the public API alone. Twins of the robots of scenarios are
//! judged by the verifier of scenarios.

use crate::common::documents::judged;
use crate::common::golden::check;
use crate::common::{PLANNERS, SAMPLERS, arm_and_wall, arm_of, deep, disc_and_wall, finish, fitting, options};
use planarium::problem::Stats;
use planarium::run::inspect::Inspector;
use planarium::run::{
    CoordinateDescription, CustomProblem, Free, Options, Run, SpaceDescription, Status, start_problem,
};
use planarium::scenario::{Robot, Scenario};
use planarium::space::MetricKind;
use planarium::{Code, Error};
use serde_json::{Value as Json, json};
use std::cell::Cell;
use std::rc::Rc;
use wasm_bindgen_test::wasm_bindgen_test;

const THICKNESSES: [f64; 7] = [0.5, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6];

/// How motions of a twin are checked.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Clearance,
    Samples,
}

/// The robot of a scenario, an arm or a disc, told as a stranger's.
fn twin(scenario: &Scenario, kind: Kind) -> CustomProblem {
    let world = scenario.world();
    let (coordinates, metric, reach) = match scenario.robot() {
        Robot::Arm(arm) => {
            let reach = (0..arm.links().len()).map(|i| arm.links()[i..].iter().sum()).collect();
            let circle = |limit: Option<[f64; 2]>| {
                limit.map_or_else(CoordinateDescription::circle, |[low, high]| {
                    CoordinateDescription::interval(low, high)
                })
            };
            let limits = (0..arm.links().len()).map(|i| arm.joint_limits().map(|limits| limits[i]));
            (limits.map(circle).collect(), MetricKind::Sum, Some(reach))
        }
        _ => {
            let bounds = world.bounds.as_ref().expect("a disc has bounds");
            let side = |low, high| CoordinateDescription::interval(low, high);
            let sides = vec![side(bounds.min.x, bounds.max.x), side(bounds.min.y, bounds.max.y)];
            (sides, MetricKind::Euclidean, None)
        }
    };
    let inspector = Inspector::new(scenario);
    let radius = if let Robot::Disc(disc) = scenario.robot() { disc.radius() } else { 0.0 };
    let bounds = world.bounds;
    let clearance_of = move |q: &[f64]| -> Result<f64, Error> {
        let depth = match &bounds {
            Some(bounds) if radius > 0.0 => {
                (q[0] - bounds.min.x).min(bounds.max.x - q[0]).min((q[1] - bounds.min.y).min(bounds.max.y - q[1]))
            }
            _ => f64::INFINITY,
        };
        Ok(inspector.clearance(q)?.map_or(-1.0, |clearance| clearance.distance).min(depth - radius))
    };
    let space = SpaceDescription { coordinates, metric: Some(metric) };
    let n = space.coordinates.len();
    let clearance = move |rows: &[f64], clearances: &mut [f64]| -> Result<(), Error> {
        for (q, clearance) in rows.chunks(n).zip(clearances) {
            *clearance = clearance_of(q)?;
        }
        Ok(())
    };
    let free = match (kind, reach) {
        (Kind::Clearance, None) => Free::by_clearance(clearance),
        (Kind::Clearance, Some(reach)) => Free::by_reach(&Vec::from_iter::<Vec<f64>>(reach), clearance),
        (Kind::Samples, _) => Free::by_samples(Some(0.05), move |rows, free| {
            let mut clearances = vec![0.0; free.len()];
            clearance(rows, &mut clearances)?;
            free.iter_mut().zip(clearances).for_each(|(free, clearance)| *free = clearance > 0.0);
            Ok(())
        }),
    };
    let query = &scenario.queries()[0];
    let goal = query.configuration().expect("a goal").to_vec();
    CustomProblem::new(space, free, &query.start, &[goal]).expect("a problem")
}

fn begin(problem: &CustomProblem, planner: &str, seed: u64, settings: &str) -> Box<dyn Run> {
    start_problem(problem, &options(planner, seed, settings)).unwrap_or_else(|error| panic!("{planner}: {error}"))
}

/// Judges the path of a twin by the verifier of its scenario.
fn assert_valid(scenario: &Scenario, run: &dyn Run) {
    let mut result = run.result();
    (result.scenario, result.query) = (scenario.name().to_owned(), scenario.queries()[0].name.clone());
    judged(scenario, &result).unwrap_or_else(|why| panic!("{why}: {}", result.to_json()));
}

/// Settings without the metric, which is that of the space.
fn settings_of(settings: &str) -> String {
    settings.split_whitespace().filter(|setting| !setting.starts_with("metric=")).collect::<Vec<_>>().join(" ")
}

#[wasm_bindgen_test(unsupported = test)]
fn every_planner_serves_them_in_any_slicing_and_says_whether_edges_are_proven() {
    for world in [arm_and_wall(1e-6), arm_of(6, true, 0.0), disc_and_wall(0.3, 1e-3)] {
        for kind in [Kind::Clearance, Kind::Samples] {
            let problem = twin(&world, kind);
            let mut solved = 0;
            for &(planner, settings) in PLANNERS {
                let settings = settings_of(&fitting(&world, settings)) + " max_iterations=2000";
                let what = format!("{planner} {settings} on {} by {kind:?}", world.name());
                let whole = finish(begin(&problem, planner, 5, &settings));
                let mut run = begin(&problem, planner, 5, &settings);
                while run.step(7) == Status::Running {}
                assert_eq!(run.result().to_json(), whole.result().to_json(), "{what}");
                assert_eq!(
                    whole.result().edge_check.as_deref(),
                    (kind == Kind::Samples).then_some("sampled"),
                    "{what}"
                );
                assert_eq!((whole.failure(), whole.roadmap()), (None, None), "{what}");
                assert!(whole.stats().clearance_evaluations > 0, "{what}");
                if whole.status() == Status::Solved {
                    solved += 1;
                    if kind == Kind::Clearance {
                        assert_valid(&world, &*whole);
                    }
                }
            }
            assert!(
                2 * solved > PLANNERS.len(),
                "{solved} of {} solved on {} by {kind:?}",
                PLANNERS.len(),
                world.name()
            );
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_sampler_serves_them() {
    let (world, mut solved) = (arm_and_wall(0.1), 0);
    for sampler in SAMPLERS {
        let settings = format!("sampler={sampler} samples=200 k=10");
        let run = finish(begin(&twin(&world, Kind::Clearance), "prm", 1, &settings));
        // Few bridges are as short as the default spread of the bridge test.
        assert!(run.failure().is_none() && run.stats().configuration_checks > 200, "{sampler}");
        if run.status() == Status::Solved {
            solved += 1;
            assert_valid(&world, &*run);
        }
    }
    assert!(solved >= 3, "{solved} of {} solved", SAMPLERS.len());
}

#[wasm_bindgen_test(unsupported = test)]
fn proven_paths_cross_no_wall_however_thin() {
    let all = if deep() { 10_000 } else { 60 };
    let mut solved = 0;
    for seed in 0..all {
        let thickness = THICKNESSES[seed as usize % THICKNESSES.len()];
        let world = if seed % 2 == 0 { arm_and_wall(thickness) } else { disc_and_wall(0.2, thickness) };
        let shortcut = if seed % 3 == 0 { "shortcut=20 reduce=true" } else { "" };
        let run = finish(begin(&twin(&world, Kind::Clearance), "rrt-connect", seed, shortcut));
        if run.status() == Status::Solved {
            solved += 1;
            assert_valid(&world, &*run);
        }
    }
    assert!(solved * 10 >= all * 9, "{solved} of {all} solved");
}

const OBSTACLES: [[f64; 3]; 3] = [[2.0, 2.0, 0.5], [1.0, 3.3, 0.2], [3.1, 0.9, 0.25]];
const RADIUS: f64 = 0.3;

/// The clearance of two discs among round obstacles, and of each other.
fn clearance_of_discs(q: &[f64]) -> f64 {
    let distance = |x: f64, y: f64| (x * x + y * y).sqrt();
    let mut clearance = distance(q[0] - q[2], q[1] - q[3]) - RADIUS - RADIUS;
    for [x, y, radius] in OBSTACLES {
        for disc in [&q[..2], &q[2..]] {
            let apart = distance(disc[0] - x, disc[1] - y) - radius - RADIUS;
            clearance = if apart < clearance { apart } else { clearance };
        }
    }
    clearance
}

/// Two discs that change places.
fn two_discs(kind: Kind) -> CustomProblem {
    let side = CoordinateDescription::interval(RADIUS, 4.0 - RADIUS);
    let space = SpaceDescription { coordinates: vec![side; 4], metric: None };
    let free = match kind {
        Kind::Clearance => Free::by_reach(&[1.0; 4], |rows, clearances| {
            rows.chunks(4).zip(clearances).for_each(|(q, clearance)| *clearance = clearance_of_discs(q));
            Ok(())
        }),
        Kind::Samples => Free::by_samples(Some(0.05), |rows, free| {
            rows.chunks(4).zip(free).for_each(|(q, free)| *free = clearance_of_discs(q) > 0.0);
            Ok(())
        }),
    };
    let (start, goal) = ([0.7, 2.0, 3.3, 2.0], vec![3.3, 2.0, 0.7, 2.0]);
    CustomProblem::new(space, free, &start, &[goal]).expect("a problem")
}

#[wasm_bindgen_test(unsupported = test)]
fn proven_paths_are_free_at_every_one_of_many_points() {
    let (runs, points) = if deep() { (10_000, 100_000) } else { (30, 10_000) };
    let problem = two_discs(Kind::Clearance);
    for seed in 0..runs {
        let run = finish(begin(&problem, "rrt-connect", seed, if seed % 2 == 0 { "shortcut=20" } else { "" }));
        assert_eq!(run.status(), Status::Solved, "{seed}");
        for pair in run.path().windows(2) {
            for i in 0..=points {
                let t = f64::from(i) / f64::from(points);
                let q: Vec<f64> = (0..4).map(|j| pair[0][j] + t * (pair[1][j] - pair[0][j])).collect();
                assert!(clearance_of_discs(&q) > 0.0, "{seed}: {q:?}");
            }
        }
    }
}

/// Status, fingerprint, length and evaluations of a run with the two discs.
fn planned(case: &Json) -> Json {
    let text = |name: &str| case[name].as_str().expect("a word");
    let kind = if text("free") == "clearance" { Kind::Clearance } else { Kind::Samples };
    let given = case["parameters"].as_object().expect("parameters");
    let options = Options {
        planner: Some(text("planner").to_owned()),
        seed: case["seed"].as_u64().expect("a seed"),
        parameters: given.iter().map(|(name, value)| (name.clone(), value.into())).collect(),
        ..Options::default()
    };
    let run = finish(start_problem(&two_discs(kind), &options).expect("it starts"));
    json!({
        "status": run.status().as_str(),
        "fingerprint": format!("{:016x}", run.fingerprint()),
        "length": run.length(),
        "clearance_evaluations": run.stats().clearance_evaluations,
    })
}

#[wasm_bindgen_test(unsupported = test)]
fn two_discs_have_their_golden_outcomes() {
    check("golden-custom.json", include_str!("golden-custom.json"), 10, planned);
}

#[wasm_bindgen_test(unsupported = test)]
fn all_before_the_first_hit_is_proven_and_the_hit_is_at_the_wall() {
    let world = disc_and_wall(0.2, 1e-6);
    let mut run = begin(&twin(&world, Kind::Clearance), "rrt-connect", 1, "");
    let hits = run.first_hits(&[1.0, 1.0, 9.0, 1.0, 1.0, 1.0, 1.0, 7.0, 9.0, 1.0, 1.0, 1.0]).expect("hits");
    let [across, along, back] = hits[..] else { panic!("three motions") };
    let at_wall = (4.8 - 1.0) / 8.0;
    for hit in [across, back] {
        assert!(hit <= at_wall && at_wall - hit < 2e-3, "{hit} {at_wall}");
    }
    assert_eq!(along, 1.0);
    let hits = run.first_hits(&[1.0, 1.0, 1.0 + 8.0 * across, 1.0]).expect("hits");
    assert_eq!(hits, [1.0], "up to the hit all is free");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_failure_ends_the_run_where_it_happens_and_stays() {
    let failing_after = |good: u64| {
        let count = Rc::new(Cell::new(0));
        let free = Free::by_reach(&[1.0; 4], move |rows, clearances| {
            count.set(count.get() + clearances.len() as u64);
            if count.get() > good {
                return Err(Error::new(Code::File, "/sensor", "the sensor is gone"));
            }
            rows.chunks(4).zip(clearances).for_each(|(q, clearance)| *clearance = clearance_of_discs(q));
            Ok(())
        });
        let side = CoordinateDescription::interval(RADIUS, 4.0 - RADIUS);
        let space = SpaceDescription { coordinates: vec![side; 4], metric: None };
        CustomProblem::new(space, free, &[0.7, 2.0, 3.3, 2.0], &[vec![3.3, 2.0, 0.7, 2.0]]).expect("a problem")
    };
    for &(planner, settings) in PLANNERS {
        let settings = settings_of(settings);
        let whole = finish(begin(&two_discs(Kind::Clearance), planner, 3, &settings));
        let Stats { clearance_evaluations, .. } = whole.stats();
        for good in [5, 50, clearance_evaluations / 2] {
            let problem = failing_after(good);
            let mut run = begin(&problem, planner, 3, &settings);
            assert_eq!(run.step(u64::MAX), Status::Failed, "{planner} {settings}");
            let (error, after) = (run.failure().expect("an error"), run.iterations());
            assert_eq!((error.code(), error.pointer()), (Code::File, "/sensor"));
            let edges = run.edge_count();
            assert_eq!((run.step(1000), run.finish(), run.iterations()), (Status::Failed, Status::Failed, after));
            assert_eq!((run.edge_count(), run.failure(), run.path()), (edges, Some(error), Vec::new()));
            // Before that iteration it is the run that does not fail.
            let mut sound = begin(&two_discs(Kind::Clearance), planner, 3, &settings);
            sound.step(after - 1);
            let before = sound.edges_since(0);
            assert_eq!(run.edges_since(0)[..before.len()], before[..], "{planner} {settings} {good}");
            // The same in other slices.
            let mut sliced = begin(&failing_after(good), planner, 3, &settings);
            while sliced.step(1) == Status::Running {}
            assert_eq!(
                (sliced.status(), sliced.iterations(), sliced.fingerprint()),
                (Status::Failed, after, run.fingerprint())
            );
        }
        let refused = start_problem(&failing_after(0), &options(planner, 3, &settings)).map(|_| ());
        assert_eq!(refused.expect_err("the start cannot be evaluated").code(), Code::File);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_kept_roadmap_is_queried_again_and_a_failure_of_a_query_is_its_error() {
    let is_broken = Rc::new(Cell::new(false));
    let broken = Rc::clone(&is_broken);
    let free = Free::by_clearance(move |rows, clearances| {
        if broken.get() {
            clearances[0] = f64::NAN;
            return Ok(());
        }
        rows.chunks(2).zip(clearances).for_each(|(q, clearance)| *clearance = (q[0] * q[0] + q[1] * q[1]).sqrt() - 1.0);
        Ok(())
    });
    let sides = vec![CoordinateDescription::interval(-2.0, 2.0), CoordinateDescription::line(-2.0, 2.0).weighted(2.0)];
    let space = SpaceDescription { coordinates: sides, metric: Some(MetricKind::Sum) };
    // A line has no limits.
    let problem = CustomProblem::new(space, free, &[-1.5, -3.0], &[vec![1.5, 0.0], vec![1.5, 3.0]]).expect("a problem");
    let mut run = begin(&problem, "prm", 1, "samples=100 k=8");
    assert_eq!(run.step(u64::MAX), Status::Solved);
    assert!((run.length() - 3.0).abs() < 1e-9 || run.length() > 3.0);
    let asked = run.query(&[-1.5, 0.0], &[0.0, 1.5], true).expect("a query");
    assert_eq!((asked.status, asked.query.as_str()), (Status::Solved, "asked"));
    assert!(run.reopen(&(&disc_and_wall(0.1, 0.1)).into()).is_err_and(|error| error.code() == Code::Unsupported));
    is_broken.set(true);
    for _ in 0..2 {
        let error = run.query(&[-1.5, 0.0], &[0.0, 1.5], false).expect_err("not a number");
        assert_eq!(error.code(), Code::NotFinite, "{error}");
    }
    assert_eq!((run.status(), run.step(5)), (Status::Solved, Status::Solved));
}

#[wasm_bindgen_test(unsupported = test)]
fn what_makes_no_problem_is_refused_with_code_and_pointer() {
    use CoordinateDescription as C;
    let all_free = || {
        Free::by_clearance(|_, clearances| {
            clearances.fill(f64::INFINITY);
            Ok(())
        })
    };
    let refused = |coordinates: Vec<C>, free: Free, start: &[f64], goals: &[Vec<f64>]| {
        let space = SpaceDescription { coordinates, metric: None };
        let error = CustomProblem::new(space, free, start, goals).map(|_| ()).expect_err("refused");
        (error.code(), error.pointer().to_owned())
    };
    let one = C::interval(0.0, 1.0);
    let goal = [vec![1.0]];
    for (coordinates, code, pointer) in [
        (vec![], Code::OutOfRange, "/space/coordinates"),
        (vec![one; 9], Code::OutOfRange, "/space/coordinates"),
        (vec![C::interval(1.0, 1.0)], Code::OutOfRange, "/space/coordinates/0/high"),
        (vec![one, C::line(-1e7, 1.0)], Code::OutOfRange, "/space/coordinates/1/low"),
        (vec![C::interval(0.0, f64::NAN)], Code::NotFinite, "/space/coordinates/0/high"),
        (vec![C { low: None, ..one }], Code::MissingField, "/space/coordinates/0/low"),
        (vec![C { high: Some(1.0), ..C::circle() }], Code::UnknownField, "/space/coordinates/0/high"),
        (vec![one.weighted(0.0)], Code::OutOfRange, "/space/coordinates/0/weight"),
    ] {
        assert_eq!(refused(coordinates, all_free(), &[0.0], &goal), (code, pointer.to_owned()));
    }
    let by = |reach: &[f64]| Free::by_reach(reach, |_, _| Ok(()));
    let samples = |resolution| Free::by_samples(Some(resolution), |_, _| Ok(()));
    for (free, start, goals, code, pointer) in [
        (all_free(), vec![0.0, 1.0], vec![vec![1.0]], Code::WrongDimension, "/start"),
        (all_free(), vec![f64::NAN], vec![vec![1.0]], Code::NotFinite, "/start/0"),
        (all_free(), vec![0.5], vec![], Code::OutOfRange, "/goals"),
        (all_free(), vec![0.5], vec![vec![1.0], vec![1.5]], Code::OutOfRange, "/goals/1"),
        (by(&[1.0, 1.0]), vec![0.5], vec![vec![1.0]], Code::WrongDimension, "/reach"),
        (by(&[-1.0]), vec![0.5], vec![vec![1.0]], Code::OutOfRange, "/reach/0"),
        (samples(0.0), vec![0.5], vec![vec![1.0]], Code::OutOfRange, "/resolution"),
    ] {
        assert_eq!(refused(vec![one], free, &start, &goals), (code, pointer.to_owned()));
    }
    let discs = [two_discs(Kind::Clearance), two_discs(Kind::Samples)];
    for (i, planner, settings, code, pointer) in [
        (0, "none", "", Code::UnknownPlanner, "/algorithm"),
        (0, "rrt-control", "", Code::Unsupported, "/algorithm"),
        (0, "sst", "", Code::Unsupported, "/algorithm"),
        (0, "rrt", "metric=sum", Code::OutOfRange, "/metric"),
        (0, "rrt", "steering=dubins", Code::OutOfRange, "/steering"),
        (0, "rrt", "edge_check=joint-lines", Code::OutOfRange, "/edge_check"),
        (0, "rrt", "blend=0.5", Code::Unsupported, "/blend"),
        (1, "rrt", "edge_check=proven", Code::Unsupported, "/edge_check"),
        (1, "rrt", "nonsense=1", Code::UnknownParameter, "/nonsense"),
    ] {
        let error = start_problem(&discs[i], &options(planner, 1, settings)).map(|_| ()).expect_err("refused");
        assert_eq!((error.code(), error.pointer()), (code, pointer), "{planner} {settings}");
    }
    let sampled = finish(begin(&discs[0], "rrt-connect", 1, "edge_check=sampled edge_samples=4"));
    assert_eq!(sampled.result().edge_check.as_deref(), Some("sampled"));
    let named = Options { query: Some("a".to_owned()), ..Options::default() };
    assert!(start_problem(&discs[0], &named).is_err_and(|error| error.pointer() == "/query"));
}

#[wasm_bindgen_test(unsupported = test)]
fn a_start_or_a_goal_in_collision_is_refused_with_its_clearance() {
    let space = SpaceDescription { coordinates: vec![CoordinateDescription::interval(-2.0, 2.0)], metric: None };
    let clearance = || {
        Free::by_clearance(|rows, clearances| {
            clearances.copy_from_slice(rows);
            Ok(())
        })
    };
    let samples = || {
        Free::by_samples(None, |rows, free| {
            (0..rows.len()).for_each(|i| free[i] = rows[i] > 0.0);
            Ok(())
        })
    };
    for (free, start, goals, code, pointer, why) in [
        (clearance(), -0.5, vec![vec![1.0]], Code::StartInCollision, "/start", "clearance is -0.5"),
        (clearance(), 0.5, vec![vec![1.0], vec![0.0]], Code::GoalInCollision, "/goals/1", "clearance is 0"),
        (samples(), 0.5, vec![vec![-1.0]], Code::GoalInCollision, "/goals/0", "not free"),
    ] {
        let problem = CustomProblem::new(space.clone(), free, &[start], &goals).expect("a problem");
        let error = start_problem(&problem, &Options::default()).map(|_| ()).expect_err("in collision");
        assert_eq!((error.code(), error.pointer()), (code, pointer));
        assert!(error.message().contains(why), "{error}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn no_motion_is_evaluated_without_bound() {
    let side = CoordinateDescription::interval(0.0, 1e6);
    let space = || SpaceDescription { coordinates: vec![side], metric: None };
    // Free everywhere, with bounds so small that they prove nothing in time.
    let tiny = Free::by_clearance(|_, clearances| {
        clearances.fill(1e-3);
        Ok(())
    });
    let fine = Free::by_samples(Some(1e-3), |_, free| {
        free.fill(true);
        Ok(())
    });
    for free in [tiny, fine] {
        let problem = CustomProblem::new(space(), free, &[0.0], &[vec![1e6]]).expect("a problem");
        let mut run = begin(&problem, "rrt-connect", 1, "tolerance=1e-9");
        assert_eq!(run.step(3), Status::Running);
        let Stats { unproven_motions, clearance_evaluations, motion_checks, .. } = run.stats();
        assert!(
            unproven_motions == motion_checks && clearance_evaluations < 16_400 * motion_checks + 10,
            "{motion_checks}"
        );
    }
}
