//! A run is the same with any number of threads: after every iteration, in any slices.

use crate::common::{SAMPLERS, arm_of, begin_with, car_and_wall, disc_and_wall, finish};
use crate::termination::every_planner;
use planarium::path::Wanted;
use planarium::planner::{Limits, PlannerKind, PrmOptions};
use planarium::problem::{Contact, Problem, Stats, Touched, Validity};
use planarium::run::{Run, Status, start_on};
use planarium::scenario::{Scenario, generate::generate};
use planarium::space::{MotionSpace, ProductSpace};
use serde_json::json;
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What is `Send` natively: custom problems, prepared worlds, planners of fleets, certificates, and runs of every planner.
#[test]
fn a_run_begun_in_one_thread_ends_in_another() {
    fn is_send<T: Send>() {}
    is_send::<planarium::run::CustomProblem>();
    is_send::<planarium::world::PlanningWorld>();
    is_send::<planarium::fleet::FleetPlanner>();
    is_send::<planarium::certificate::Subdivision>();
    let (disc, car) = (disc_and_wall(0.3, 0.5), car_and_wall(0.1));
    for (planner, world) in every_planner(&disc, &car) {
        let settings = "max_work=200000";
        let one = finish(begin_with(world, planner, 3, settings));
        let mut run = begin_with(world, planner, 3, settings);
        run.step(20);
        let other = std::thread::spawn(move || {
            run.step(u64::MAX);
            run
        });
        let other = other.join().expect("it ends");
        assert_eq!((other.fingerprint(), other.stats()), (one.fingerprint(), one.stats()), "{planner}");
    }
}

/// The counts after every iteration, from 0, of a run on one thread to its end; and the run.
fn on_one_thread(mut run: Box<dyn Run>) -> (Vec<Stats>, Box<dyn Run>) {
    let mut stats = vec![run.stats()];
    while run.status() == Status::Running {
        run.step(1);
        stats.push(run.stats());
    }
    (stats, run)
}

/// Steps a run to its end in slices, by so many threads each, in turns, and compares it with that on one thread.
#[track_caller]
fn assert_same(mut run: Box<dyn Run>, turns: &[(usize, u64)], (stats, one): &(Vec<Stats>, Box<dyn Run>), what: &str) {
    for &(threads, slice) in turns.iter().cycle() {
        run.set_threads(NonZeroUsize::new(threads).expect("at least one"));
        let status = run.step(slice);
        let iterations = run.iterations() as usize;
        assert_eq!(run.stats(), stats[iterations], "{what}: {turns:?}, after iteration {iterations}");
        if status != Status::Running {
            break;
        }
    }
    assert_eq!(run.iterations(), one.iterations(), "{what}: {turns:?}");
    assert_eq!(run.event_rows(0), one.event_rows(0), "{what}: {turns:?}");
    assert_eq!(run.result().to_json(), one.result().to_json(), "{what}: {turns:?}");
}

/// Threads, each with the iterations of a slice.
const TURNS: &[&[(usize, u64)]] = &[
    &[(2, 1)],
    &[(2, u64::MAX)],
    &[(3, 7)],
    &[(3, u64::MAX)],
    // A run whose threads change while results are left.
    &[(1, 100), (3, 100), (2, 30), (1, 1000)],
];

fn world(kind: &str, options: serde_json::Value) -> Scenario {
    generate(kind, &options).expect("it can be generated")
}

#[test]
fn threads_change_neither_result_nor_counts() {
    let [arm, disc] = [world("forest", json!({ "links": 4, "seed": 1 })), disc_and_wall(0.3, 0.5)];
    for (world, planner, settings) in [
        // Several blocks of vertices.
        (&arm, "prm", "samples=500 k=480"),
        (&arm, "prm", "samples=300 radius=2.5"),
        (&arm, "prm-star", "samples=400"),
        (&arm_of(2, true, 0.05), "prm", "samples=300 k=9 metric=naive shortcut=20"),
        (&arm_of(6, false, 0.0), "prm-star", "samples=200 k_rule=log-n"),
        (&disc, "prm", "samples=800 k=500"),
        // Several blocks of samples.
        (&disc, "prm", "samples=7000 k=4"),
        (&disc, "prm", "samples=300 radius=3 search=dijkstra"),
        (&disc, "prm-star", "samples=500 edge_check=sampled"),
        (&arm, "prm", "samples=300 k=9 neighbour_index=forest neighbour_metric=naive edge_check=none"),
        // It ends while samples are drawn, and while they are connected.
        (&disc, "prm", "k=9 max_iterations=333"),
        (&disc, "prm", "k=9 max_iterations=2222"),
        // Too few for threads.
        (&disc, "prm", "samples=20 k=5"),
        (&world("clutter", json!({ "robot": "rigid_body", "seed": 2 })), "prm", "samples=300 k=12"),
        (&car_and_wall(0.1), "prm", "samples=150 k=8 steering=reeds-shepp"),
        (&car_and_wall(0.1), "prm-star", "samples=150 steering=dubins"),
    ] {
        let one = on_one_thread(begin_with(world, planner, 3, settings));
        assert!(one.1.edge_count() > 0 || settings.contains("max_iterations"), "{planner} {settings}");
        let what = format!("{planner} {settings} on {}", world.name());
        for turns in TURNS {
            assert_same(begin_with(world, planner, 3, settings), turns, &one, &what);
        }
    }
}

#[test]
fn every_sampler_draws_the_same_on_several_threads() {
    for sampler in SAMPLERS {
        let settings = format!("samples=200 k=6 sampler={sampler} max_iterations=20000");
        let begin = || begin_with(&disc_and_wall(0.3, 0.5), "prm", 1, &settings);
        assert_same(begin(), &[(2, 50)], &on_one_thread(begin()), sampler);
    }
}

#[test]
fn questions_to_a_run_do_not_disturb_what_is_computed_ahead() {
    let begin = || begin_with(&disc_and_wall(0.3, 0.5), "prm", 2, "samples=300 k=9");
    let whole = finish(begin());
    let mut run = begin();
    run.set_threads(NonZeroUsize::new(2).expect("two"));
    while run.step(40) == Status::Running {
        let saved = run.roadmap().expect("a roadmap");
        assert_eq!(saved.vertex_count(), run.vertex_count(), "what is computed ahead is not saved");
        assert_eq!(run.first_hits(&[1.0, 1.0, 9.0, 1.0]).expect("a motion").len(), 1);
    }
    assert_eq!(run.result().to_json(), whole.result().to_json());
}

/// The unit square without obstacles; counts what it checks.
struct Open(Arc<AtomicUsize>);

impl Validity<[f64; 2]> for Open {
    fn contacts(&self, q: &[f64; 2]) -> Vec<Contact> {
        self.0.fetch_add(1, Ordering::Relaxed);
        let is_inside = q.iter().all(|x| (0.0..=1.0).contains(x));
        (!is_inside).then_some(Contact { part: 0, with: Touched::Bounds }).into_iter().collect()
    }

    fn is_motion_free(&self, _: &[f64; 2], _: &[f64; 2]) -> bool {
        self.0.fetch_add(1, Ordering::Relaxed);
        true
    }
}

#[test]
fn other_threads_use_checkers_of_their_own() {
    for (threads, has_checkers) in [(1, true), (2, false), (2, true)] {
        let [own, others] = [(); 2].map(|()| Arc::new(AtomicUsize::new(0)));
        let space: ProductSpace<2> = ProductSpace::of_box(&[0.0; 2], &[1.0; 2]);
        let ends = [[0.1, 0.1], [0.9, 0.9]];
        let validity = Box::new(Open(Arc::clone(&own)));
        let mut problem = Problem::new(MotionSpace::new(space), validity, ends[0], ends[1]).expect("both are free");
        let counted = Arc::clone(&others);
        problem.checkers = has_checkers.then(|| -> Box<dyn Fn() -> Box<dyn Validity<[f64; 2]>> + Send + Sync> {
            Box::new(move || Box::new(Open(Arc::clone(&counted))))
        });
        let planner =
            PrmOptions { samples: Some(300), k: Some(9), ..Default::default() }.begin(&problem, 1).expect("options");
        let mut run = start_on(problem, planner, Limits::default(), None, Wanted::default(), 1);
        run.set_threads(NonZeroUsize::new(threads).expect("at least one"));
        assert_eq!(run.step(u64::MAX), Status::Solved);
        let stats = run.stats();
        let [own, others] = [own, others].map(|count| count.load(Ordering::Relaxed) as u64);
        // Both ends are checked before the run.
        assert_eq!(own + others, stats.configuration_checks + stats.motion_checks + 2, "nothing is checked twice");
        assert_eq!(others > 0, threads > 1 && has_checkers);
        assert!(others == 0 || others > 5 * own, "{own} checks on the thread of the run, {others} on others");
    }
}
