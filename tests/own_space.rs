//! Planning in a space and among obstacles that the test defines itself, through the public API alone.

use nalgebra::Vector3;
use planarium::path::Wanted;
use planarium::planner::{Limits, PlannerKind, PrmOptions, RrtConnectOptions};
use planarium::problem::{Contact, Problem, Touched, Validity};
use planarium::run::{self, Run, Status};
use planarium::space::Space;
use std::f64::consts::{PI, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

/// The unit sphere with distances along great circles, in radians. Coordinates are those of a unit vector.
#[derive(Clone)]
struct Sphere;

fn unit(v: Vector3<f64>) -> [f64; 3] {
    v.normalize().map(|x| x + 0.0).into()
}

fn angle(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    let [a, b] = [a, b].map(|q| Vector3::from(*q));
    libm::atan2(a.cross(&b).norm(), a.dot(&b))
}

/// Only the methods without a default.
impl Space for Sphere {
    type State = [f64; 3];

    fn dimension(&self) -> usize {
        3
    }

    fn coordinates<'a>(&self, q: &'a [f64; 3]) -> &'a [f64] {
        q
    }

    fn state(&self, numbers: &[f64]) -> [f64; 3] {
        unit(Vector3::from_column_slice(&numbers[..3]))
    }

    fn distance(&self, a: &[f64; 3], b: &[f64; 3]) -> f64 {
        angle(a, b)
    }

    fn interpolate(&self, a: &[f64; 3], b: &[f64; 3], t: f64) -> [f64; 3] {
        let whole = angle(a, b);
        if t == 0.0 || whole == 0.0 {
            return *a;
        }
        if t == 1.0 {
            return *b;
        }
        let [from, to] = [(1.0 - t) * whole, t * whole].map(libm::sin);
        unit(from * Vector3::from(*a) + to * Vector3::from(*b))
    }

    /// Archimedes: heights and longitudes drawn uniformly give points drawn uniformly.
    fn at(&self, place: &[f64]) -> [f64; 3] {
        let z = 2.0 * place[0] - 1.0;
        let (sin, cos) = libm::sincos(TAU * place[1]);
        let radius = (1.0 - z * z).sqrt();
        unit(Vector3::new(radius * cos, radius * sin, z))
    }

    fn contains(&self, _: &[f64; 3]) -> bool {
        true
    }

    fn extent(&self) -> f64 {
        PI
    }
}

/// Round caps to stay out of: centres, and radii in radians.
struct Caps(Vec<([f64; 3], f64)>);

impl Validity<[f64; 3]> for Caps {
    fn contacts(&self, q: &[f64; 3]) -> Vec<Contact> {
        let touched = (0..self.0.len()).filter(|&i| angle(&self.0[i].0, q) <= self.0[i].1);
        touched.map(|i| Contact { part: 0, with: Touched::Obstacle(i) }).collect()
    }

    /// Exact but for rounding: where the great circle comes nearest to a centre, or else at an end.
    fn is_motion_free(&self, a: &[f64; 3], b: &[f64; 3]) -> bool {
        let [from, to] = [a, b].map(|q| Vector3::from(*q));
        let normal = from.cross(&to);
        let is_clear = |(center, radius): &([f64; 3], f64)| {
            let foot = normal.cross(&Vector3::from(*center)).cross(&normal);
            let is_between = from.cross(&foot).dot(&normal) > 0.0 && foot.cross(&to).dot(&normal) > 0.0;
            !is_between || angle(&unit(foot), center) > *radius
        };
        // Between opposite points no great circle is the shortest.
        (a == b || normal.norm() > 0.0) && self.is_free(a) && self.is_free(b) && self.0.iter().all(is_clear)
    }
}

/// Five caps on the equator with gaps between them, start and goal at the poles; `closed` makes of them a belt without gaps.
fn problem(closed: bool) -> Problem<Sphere> {
    let radius = if closed { 0.65 } else { 0.45 };
    let center = |i: u32| {
        let (sin, cos) = libm::sincos(TAU * f64::from(i) / 5.0);
        ([cos, sin, 0.0], radius)
    };
    let caps = Caps((0..5).map(center).collect());
    Problem::new(Sphere, Box::new(caps), [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]).expect("both poles are free")
}

fn run(id: &str, closed: bool, seed: u64) -> Box<dyn Run> {
    let problem = problem(closed);
    let planner = match id {
        "rrt-connect" => RrtConnectOptions { step: Some(0.3), ..Default::default() }.begin(&problem, seed),
        _ => PrmOptions { samples: Some(200), k: Some(8), ..Default::default() }.begin(&problem, seed),
    };
    let limits = Limits { max_iterations: Some(2000), ..Limits::default() };
    let wanted = Wanted { reduce: true, shortcuts: 20, blend: 0.5, ..Wanted::default() };
    run::start_on(problem, planner.expect("the options fit the space"), limits, None, wanted, seed)
}

#[wasm_bindgen_test(unsupported = test)]
fn planners_find_free_paths_in_a_space_of_ones_own() {
    for (id, seed) in [("rrt-connect", 1), ("rrt-connect", 2), ("prm", 1), ("prm", 2)] {
        let mut run = run(id, false, seed);
        assert_eq!(run.step(100_000), Status::Solved, "{id} {seed}");
        let path: Vec<[f64; 3]> = run.path().iter().map(|q| Sphere.state(q)).collect();
        assert_eq!((path[0], path[path.len() - 1]), ([0.0, 0.0, 1.0], [0.0, 0.0, -1.0]));
        let caps = problem(false);
        for pair in path.windows(2) {
            for i in 0..=1000 {
                let q = Sphere.interpolate(&pair[0], &pair[1], f64::from(i) / 1000.0);
                assert!(caps.validity().is_free(&q), "{id} {seed}: {q:?} lies in a cap");
            }
        }
        // No blend is proven by default, so all corners stay.
        assert!(run.result().blends.is_none_or(|blends| blends.iter().all(|shares| *shares == [0.0; 2])));
        let length: f64 = path.windows(2).map(|pair| Sphere.distance(&pair[0], &pair[1])).sum();
        assert!((run.length() - length).abs() < 1e-12 && (3.1..8.0).contains(&length), "{id} {seed}: {length}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_belt_without_gaps_exhausts_the_run() {
    for id in ["rrt-connect", "prm"] {
        assert_eq!(run(id, true, 3).step(100_000), Status::Exhausted, "{id}");
    }
}
