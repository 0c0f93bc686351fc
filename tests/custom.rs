//! Robots of one's own: told by a space and by what is free, through the public API alone. Twins of the robots of scenarios are
//! judged by the verifier of scenarios.

use crate::common::documents::judged;
use crate::common::golden::check;
use crate::common::requests;
use crate::common::requests::{resume_problem, start_problem};
use crate::common::{
    PLANNERS, SAMPLERS, arm_and_wall, arm_of, deep, disc_and_wall, finish, fitting, of_run, options, sliced,
};
use planarium::problem::Stats;
use planarium::run::inspect::Inspector;
use planarium::run::storage::{RoadmapDocument, RoadmapMetric, fingerprint};
use planarium::run::{CoordinateDescription, CustomProblem, Free, Request, Run, SpaceDescription, Status};
use planarium::scenario::{Robot, Scenario};
use planarium::space::MetricKind;
use planarium::{Code, Error};
use serde_json::{Value as Json, json};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
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
    // Its checker is of one thread.
    let inspector = Mutex::new(Inspector::new(scenario));
    let radius = if let Robot::Disc(disc) = scenario.robot() { disc.radius() } else { 0.0 };
    let bounds = world.bounds;
    let clearance_of = move |q: &[f64]| -> Result<f64, Error> {
        let depth = match &bounds {
            Some(bounds) if radius > 0.0 => {
                (q[0] - bounds.min.x).min(bounds.max.x - q[0]).min((q[1] - bounds.min.y).min(bounds.max.y - q[1]))
            }
            _ => f64::INFINITY,
        };
        let clearance = inspector.lock().expect("no call has panicked").clearance(q)?;
        Ok(clearance.map_or(-1.0, |clearance| clearance.distance).min(depth - radius))
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
                let most = if deep() { 2000 } else { 1000 };
                let settings = format!("{} max_iterations={most}", settings_of(&fitting(&world, settings)));
                let what = format!("{planner} {settings} on {} by {kind:?}", world.name());
                let whole = sliced(&what, || begin(&problem, planner, 5, &settings), of_run);
                assert_eq!(
                    whole.result().edge_check.as_deref(),
                    (kind == Kind::Samples).then_some("sampled"),
                    "{what}"
                );
                assert_eq!(whole.failure(), None, "{what}");
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
    let samples = if deep() { 200 } else { 60 };
    for sampler in SAMPLERS {
        let settings = format!("sampler={sampler} samples={samples} k=10");
        let run = finish(begin(&twin(&world, Kind::Clearance), "prm", 1, &settings));
        // Few bridges are as short as the default spread of the bridge test.
        assert!(run.failure().is_none() && run.stats().configuration_checks > samples, "{sampler}");
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
    let options = Request {
        planner: Some(text("planner").to_owned()),
        seed: case["seed"].as_u64().expect("a seed"),
        parameters: given.iter().map(|(name, value)| (name.clone(), value.into())).collect(),
        ..Request::default()
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
        let count = AtomicU64::new(0);
        let free = Free::by_reach(&[1.0; 4], move |rows, clearances| {
            let before = count.fetch_add(clearances.len() as u64, Ordering::Relaxed);
            if before + clearances.len() as u64 > good {
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
            let before = sound.edge_rows(0);
            assert_eq!(run.edge_rows(0)[..before.len()], before[..], "{planner} {settings} {good}");
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
    let is_broken = Arc::new(AtomicBool::new(false));
    let broken = Arc::clone(&is_broken);
    let free = Free::by_clearance(move |rows, clearances| {
        if broken.load(Ordering::Relaxed) {
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
    is_broken.store(true, Ordering::Relaxed);
    for _ in 0..2 {
        let error = run.query(&[-1.5, 0.0], &[0.0, 1.5], false).expect_err("not a number");
        assert_eq!(error.code(), Code::NotFinite, "{error}");
    }
    assert_eq!((run.status(), run.step(5)), (Status::Solved, Status::Solved));
}

/// A point in a box and on a circle of weight 2, around a disc that stands at `x`.
fn around_a_disc(kind: Kind, x: f64) -> CustomProblem {
    let clearance = move |q: &[f64]| ((q[0] - x) * (q[0] - x) + q[1] * q[1]).sqrt() - 1.0;
    let free = match kind {
        Kind::Clearance => Free::by_reach(&[1.0, 1.0, 0.0], move |rows, clearances| {
            rows.chunks(3).zip(clearances).for_each(|(q, to)| *to = clearance(q));
            Ok(())
        }),
        Kind::Samples => Free::by_samples(Some(0.02), move |rows, free| {
            rows.chunks(3).zip(free).for_each(|(q, to)| *to = clearance(q) > 0.0);
            Ok(())
        }),
    };
    CustomProblem::new(turning_point(), free, &[-1.5, 0.0, 3.0], &[vec![1.5, 0.0, -3.0]]).expect("a problem")
}

fn turning_point() -> SpaceDescription {
    let side = CoordinateDescription::interval(-2.0, 2.0);
    let coordinates = vec![side, CoordinateDescription::line(-2.0, 2.0), CoordinateDescription::circle().weighted(2.0)];
    SpaceDescription { coordinates, metric: None }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_saved_roadmap_is_continued_in_any_slices_once_all_of_it_is_free_again() {
    for kind in [Kind::Clearance, Kind::Samples] {
        for (planner, settings) in [
            ("prm", "samples=80 k=6"),
            ("prm", "samples=80 k=6 insertion=one-by-one discard=true"),
            ("prm-star", "samples=60"),
            ("visibility-prm", "failures=30"),
            ("lazy-prm", "samples=80 k=6"),
            ("lazy-prm-star", "improve_iterations=80"),
        ] {
            let what = format!("{planner} {settings} by {kind:?}");
            let run = finish(begin(&around_a_disc(kind, 0.0), planner, 3, settings));
            assert_eq!(run.status(), Status::Solved, "{what}");
            let document = run.roadmap().expect("a roadmap");
            for form in [document.to_json().into_bytes(), document.to_bytes()] {
                assert_eq!(RoadmapDocument::read(&form).as_ref(), Ok(&document), "{what}");
            }
            let again = || resume_problem(&around_a_disc(kind, 0.0), &options(planner, 0, ""), &document);
            let again = || again().unwrap_or_else(|error| panic!("{what}: {error}"));
            let mut whole = sliced(&what, again, of_run);
            assert_eq!(
                (whole.status(), whole.result().edge_check),
                (Status::Solved, run.result().edge_check),
                "{what}"
            );
            if !planner.starts_with("lazy") {
                assert_eq!((whole.path(), whole.roadmap()), (run.path(), Some(document.clone())), "{what}");
            }
            let asked = whole.query(&[0.0, 1.5, 0.0], &[0.0, -1.5, 1.0], false).expect("a query");
            assert_eq!(asked.status, Status::Solved, "{what}");
            // The disc has moved upon the roadmap.
            let refused = resume_problem(&around_a_disc(kind, 0.4), &options(planner, 0, ""), &document);
            let error = refused.map(|_| ()).expect_err("not free");
            assert_eq!(error.code(), Code::InvalidRoadmap, "{what}");
            assert!(error.pointer().starts_with("/vertices/") || error.pointer().starts_with("/edges/"), "{error}");
        }
    }
    // The form is the same on every platform.
    let document =
        finish(begin(&two_discs(Kind::Clearance), "prm", 1, "samples=100 k=8")).roadmap().expect("a roadmap");
    assert_eq!(format!("{:016x}", document.checksum()), "e442a668a112afdb");
}

#[wasm_bindgen_test(unsupported = test)]
fn between_two_configurations_circles_go_the_short_way() {
    let problem = around_a_disc(Kind::Clearance, 0.0);
    let (a, b) = ([-1.0, 0.0, 3.0], [1.0, 4.0, -3.0]);
    let middle = problem.interpolate(&a, &b, 0.5).expect("a configuration");
    assert_eq!(middle[..2], [0.0, 2.0]);
    assert!((middle[2].abs() - std::f64::consts::PI).abs() < 1e-12, "{middle:?}");
    assert_eq!((problem.interpolate(&a, &b, 0.0), problem.interpolate(&a, &b, 1.0)), (Ok(a.to_vec()), Ok(b.to_vec())));
    for (a, t, code, pointer) in [
        (&a[..2], 0.5, Code::WrongDimension, "/a"),
        (&[9.0, 0.0, 0.0], 0.5, Code::OutOfRange, "/a"),
        (&a, 1.5, Code::OutOfRange, "/t"),
        (&a, f64::NAN, Code::NotFinite, "/t"),
    ] {
        let error = problem.interpolate(a, &b, t).expect_err("refused");
        assert_eq!((error.code(), error.pointer()), (code, pointer));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_saved_roadmap_of_another_space_is_refused_where_it_differs() {
    use CoordinateDescription as C;
    let document = finish(begin(&around_a_disc(Kind::Clearance, 0.0), "prm", 1, "samples=20 k=4")).roadmap();
    let document = document.expect("a roadmap");
    let refused = |problem: &CustomProblem, document: &RoadmapDocument, settings: &str| {
        let error = resume_problem(problem, &options(&document.planner, 0, settings), document).map(|_| ());
        let error = error.expect_err("refused");
        (error.code(), error.pointer().to_owned())
    };
    let same = around_a_disc(Kind::Clearance, 0.0);
    let [x, y, angle] = turning_point().coordinates[..] else { panic!("three coordinates") };
    for (coordinates, metric, pointer) in [
        (vec![x, y], None, "/coordinates"),
        (vec![C::line(-2.0, 2.0), y, angle], None, "/coordinates/0/kind"),
        (vec![C::interval(-2.0, 2.5), y, angle], None, "/coordinates/0/high"),
        (vec![x, C::line(-3.0, 2.0), angle], None, "/coordinates/1/low"),
        (vec![x, y, C::circle()], None, "/coordinates/2/weight"),
        (vec![x, y, angle], Some(MetricKind::Sum), "/metric"),
    ] {
        let (space, n) = (SpaceDescription { coordinates, metric }, document.dimension());
        let ends = [[-1.5, 0.0, 3.0], [1.5, 0.0, -3.0]].map(|q| q[..n.min(space.coordinates.len())].to_vec());
        let free = Free::by_clearance(|_, clearances| {
            clearances.fill(1.0);
            Ok(())
        });
        let problem = CustomProblem::new(space, free, &ends[0], &[ends[1].clone()]).expect("a problem");
        assert_eq!(refused(&problem, &document, ""), (Code::OtherScenario, format!("/metric/space{pointer}")));
    }
    let sampled = around_a_disc(Kind::Samples, 0.0);
    assert_eq!(refused(&sampled, &document, ""), (Code::OtherScenario, "/edge_check".to_owned()));
    let of_sampled = finish(begin(&sampled, "prm", 1, "samples=20 k=4")).roadmap().expect("a roadmap");
    assert_eq!(refused(&same, &of_sampled, ""), (Code::OtherScenario, "/edge_check".to_owned()));
    for (settings, code, pointer) in [
        ("k=5", Code::OutOfRange, "/k"),
        ("samples=30", Code::Unsupported, "/samples"),
        ("metric=sum", Code::Unsupported, "/metric"),
        ("edge_check=none", Code::OutOfRange, "/edge_check"),
    ] {
        assert_eq!(refused(&same, &document, settings), (code, pointer.to_owned()));
    }
    // Neither kind of roadmap serves for the other, whatever it says of itself.
    let world = arm_and_wall(0.1);
    let of_arm = finish(requests::start(&world, &options("prm", 1, "samples=20")).expect("it starts")).roadmap();
    assert_eq!(refused(&same, &of_arm.expect("a roadmap"), ""), (Code::OtherScenario, "/metric".to_owned()));
    for (fingerprint, code, pointer) in [
        (document.fingerprint, Code::OtherScenario, "/fingerprint"),
        (fingerprint(&world), Code::InvalidRoadmap, "/metric"),
    ] {
        let document = RoadmapDocument { fingerprint, ..document.clone() };
        let error = requests::resume(&world, &Request::default(), &document).map(|_| ()).expect_err("refused");
        assert_eq!((error.code(), error.pointer()), (code, pointer));
    }
    let RoadmapMetric::Space(space) = &document.metric else { panic!("the metric is that of a space") };
    let with = |change: &dyn Fn(&mut SpaceDescription)| {
        let mut space = space.clone();
        change(&mut space);
        RoadmapDocument { metric: RoadmapMetric::Space(space), ..document.clone() }
    };
    for (damaged, pointer) in [
        (with(&|space| space.metric = None), "/metric/space"),
        (with(&|space| space.coordinates[2].weight = None), "/metric/space"),
        (with(&|space| space.coordinates[0].high = Some(-2.0)), "/metric/space/coordinates/0/high"),
        (with(&|space| space.coordinates.truncate(2)), "/circles"),
        (RoadmapDocument { circles: vec![false; 3], ..document.clone() }, "/circles"),
        (RoadmapDocument { edge_samples: Some(3), ..document.clone() }, "/edge_samples"),
        (RoadmapDocument { fingerprint: 1, ..document.clone() }, "/fingerprint"),
    ] {
        assert_eq!(refused(&same, &damaged, ""), (Code::InvalidRoadmap, pointer.to_owned()));
    }
    // What the function fails with is the error, whenever it fails.
    for good in [2, 10, 60] {
        let count = AtomicUsize::new(0);
        let failing = Free::by_reach(&[1.0, 1.0, 0.0], move |rows, clearances| {
            if count.fetch_add(clearances.len(), Ordering::Relaxed) + clearances.len() > good {
                return Err(Error::new(Code::File, "/sensor", "the sensor is gone"));
            }
            rows.chunks(3).zip(clearances).for_each(|(q, to)| *to = (q[0] * q[0] + q[1] * q[1]).sqrt() - 1.0);
            Ok(())
        });
        let problem = CustomProblem::new(turning_point(), failing, &[-1.5, 0.0, 3.0], &[vec![1.5, 0.0, -3.0]]);
        assert_eq!(refused(&problem.expect("a problem"), &document, ""), (Code::File, "/sensor".to_owned()));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn limits_and_ends_that_are_no_numbers_are_refused() {
    let free = || Free::by_samples(None, |_, _| Ok(()));
    let refused = |high: f64, start: f64| {
        let space = SpaceDescription { coordinates: vec![CoordinateDescription::interval(0.0, high)], metric: None };
        let error = CustomProblem::new(space, free(), &[start], &[vec![1.0]]).map(|_| ()).expect_err("refused");
        (error.code(), error.pointer().to_owned())
    };
    assert_eq!(refused(f64::NAN, 0.0), (Code::NotFinite, "/space/coordinates/0/high".to_owned()));
    assert_eq!(refused(1.0, f64::NAN), (Code::NotFinite, "/start/0".to_owned()));
}

#[wasm_bindgen_test(unsupported = test)]
fn edges_of_a_clearance_are_sampled_if_that_is_asked_for() {
    let sampled = finish(begin(&two_discs(Kind::Clearance), "rrt-connect", 1, "edge_check=sampled edge_samples=4"));
    assert_eq!(sampled.result().edge_check.as_deref(), Some("sampled"));
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
        let error = start_problem(&problem, &Request::default()).map(|_| ()).expect_err("in collision");
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
