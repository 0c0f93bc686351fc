//! OxMPL's side of the benchmark: PRM and RRT-Connect for planar arms, one job per line of standard input, one line of JSON for
//! each. The jobs are those of the C++ peer:
//!
//!   FILE prm SEED RUNS samples k                        build and one query
//!   FILE rrt-connect SEED RUNS range resolution limit   up to the first path
//!
//! OxMPL connects all vertices within a radius and stops its PRM by the clock. So the radius is chosen to try about samples x k
//! motions, and the sampler ends the construction once there are enough. Its query connects the start only, so the goal is the
//! first sample.

mod world;

use oxmpl::base::error::StateSamplingError;
use oxmpl::base::goal::{Goal, GoalRegion, GoalSampleableRegion};
use oxmpl::base::planner::{Path, Planner, PlannerConfig};
use oxmpl::base::problem_definition::ProblemDefinition;
use oxmpl::base::space::StateSpace;
use oxmpl::base::state::State;
use oxmpl::base::validity::StateValidityChecker;
use oxmpl::geometric::{PRM, RRTConnect};
use rand::{Rng, RngExt};
use std::cell::Cell;
use std::f64::consts::{PI, TAU};
use std::io::{BufRead, Write};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};
use world::World;

/// The number of configurations at which the reports test an edge.
const SAMPLES: f64 = 20.0;

/// The most joints of an arm.
const JOINTS: usize = 8;

/// Angles; those past the arm's joints are 0.
#[derive(Clone, Debug)]
struct Angles([f64; JOINTS]);

impl State for Angles {}

impl Angles {
    fn new(values: &[f64]) -> Self {
        let mut angles = [0.0; JOINTS];
        angles[..values.len()].copy_from_slice(values);
        Self(angles)
    }
}

/// The state that the space and the checker share.
#[derive(Default)]
struct Tally {
    motions: Cell<usize>,
    /// Whether the next configuration to be checked is a new sample.
    is_fresh: Cell<bool>,
    /// The number of free samples.
    accepted: Cell<usize>,
    /// The number of free samples that ends the construction.
    wanted: Cell<Option<usize>>,
}

/// How an edge is tested.
#[derive(Clone, Copy)]
enum Test {
    /// At a fixed number of samples.
    Samples,
    /// The step, in radians.
    Resolution(f64),
}

/// One circle per joint; the distance is the sum of the turns.
struct Torus {
    joints: usize,
    test: Test,
    /// The first sample of a roadmap.
    goal: Angles,
    /// The last distance computed: that of the motion about to be tested.
    last: Cell<f64>,
    tally: Arc<Tally>,
}

/// The turn in the shorter direction.
fn shorter(turn: f64) -> f64 {
    turn - TAU * (turn / TAU).round()
}

impl StateSpace for Torus {
    type StateType = Angles;

    fn distance(&self, a: &Angles, b: &Angles) -> f64 {
        let mut sum = 0.0;
        for i in 0..self.joints {
            sum += shorter(a.0[i] - b.0[i]).abs();
        }
        self.last.set(sum);
        sum
    }

    fn interpolate(&self, from: &Angles, to: &Angles, t: f64, at: &mut Angles) {
        for i in 0..self.joints {
            at.0[i] = from.0[i] + t * shorter(to.0[i] - from.0[i]);
        }
    }

    fn enforce_bounds(&self, _: &mut Angles) {}

    fn satisfies_bounds(&self, _: &Angles) -> bool {
        true
    }

    fn sample_uniform(&self, rng: &mut impl Rng) -> Result<Angles, StateSamplingError> {
        let Tally { accepted, wanted, is_fresh, .. } = &*self.tally;
        is_fresh.set(true);
        if let Some(wanted) = wanted.get() {
            if accepted.get() == 0 {
                return Ok(self.goal.clone());
            }
            if accepted.get() == wanted {
                // After an error OxMPL would drop its roadmap; after unwinding it does not.
                resume_unwind(Box::new(Instant::now()));
            }
        }
        let mut angles = [0.0; JOINTS];
        angles[..self.joints].fill_with(|| rng.random_range(0.0..TAU));
        Ok(Angles(angles))
    }

    /// Called once per motion. OxMPL steps by a tenth of it.
    fn get_longest_valid_segment_length(&self) -> f64 {
        self.tally.motions.set(self.tally.motions.get() + 1);
        match self.test {
            Test::Samples => self.last.get() * (10.0 / SAMPLES) * (1.0 + 1e-12),
            Test::Resolution(resolution) => 10.0 * resolution,
        }
    }
}

struct Checker {
    world: Arc<World>,
    tally: Arc<Tally>,
}

impl StateValidityChecker<Angles> for Checker {
    fn is_valid(&self, state: &Angles) -> bool {
        let is_free = self.world.is_free(&state.0);
        if self.tally.is_fresh.replace(false) && is_free {
            self.tally.accepted.set(self.tally.accepted.get() + 1);
        }
        is_free
    }
}

struct At {
    goal: Angles,
    space: Arc<Torus>,
}

impl Goal<Angles> for At {
    fn is_satisfied(&self, state: &Angles) -> bool {
        self.distance_goal(state) <= 1e-9
    }
}

impl GoalRegion<Angles> for At {
    fn distance_goal(&self, state: &Angles) -> f64 {
        self.space.distance(state, &self.goal)
    }
}

impl GoalSampleableRegion<Angles> for At {
    fn sample_goal(&self, _: &mut impl Rng) -> Result<Angles, StateSamplingError> {
        Ok(self.goal.clone())
    }
}

/// The problem of one run.
struct Task {
    space: Arc<Torus>,
    problem: Arc<ProblemDefinition<Angles, Torus, At>>,
    checker: Arc<Checker>,
    tally: Arc<Tally>,
}

// OxMPL requires `Arc`, and this program has one thread.
#[allow(clippy::arc_with_non_send_sync)]
fn task(world: &Arc<World>, test: Test) -> Task {
    let tally = Arc::new(Tally::default());
    let goal = Angles::new(&world.goal);
    let (joints, last) = (world.links.len(), Cell::new(0.0));
    let space = Arc::new(Torus { joints, test, goal: goal.clone(), last, tally: tally.clone() });
    let goal = Arc::new(At { goal, space: space.clone() });
    let start_states = vec![Angles::new(&world.start)];
    let problem = Arc::new(ProblemDefinition { space: space.clone(), start_states, goal });
    let checker = Arc::new(Checker { world: world.clone(), tally: tally.clone() });
    Task { space, problem, checker, tally }
}

/// The radius of the ball of the sum metric that contains 2 k of the samples: each tries those before it, k on average.
fn radius(joints: usize, samples: usize, k: f64) -> f64 {
    let factorial: f64 = (1..=joints).map(|i| i as f64).product();
    PI * (2.0 * k * factorial / samples as f64).powf(1.0 / joints as f64)
}

struct Outcome {
    setup: f64,
    build: f64,
    search: f64,
    motions: usize,
    vertices: usize,
    path: Option<Path<Angles>>,
}

fn prm(world: &Arc<World>, seed: u64, samples: usize, k: f64) -> (Outcome, Task) {
    let created = Instant::now();
    let task = task(world, Test::Samples);
    let config = PlannerConfig { seed: Some(seed) };
    let mut planner = PRM::new(60.0, radius(world.links.len(), samples, k), &config);
    planner.setup(task.problem.clone(), task.checker.clone());
    task.tally.wanted.set(Some(samples + 1));
    let began = Instant::now();
    let ended = catch_unwind(AssertUnwindSafe(|| planner.construct_roadmap())).expect_err("a minute is enough");
    let built = *ended.downcast::<Instant>().expect("the sampler unwinds with the time");
    let vertices = task.tally.accepted.get();
    let queried = Instant::now();
    let path = planner.solve(Duration::from_secs(10)).ok();
    let search = queried.elapsed().as_secs_f64();
    let (setup, build) = ((began - created).as_secs_f64(), (built - began).as_secs_f64());
    (Outcome { setup, build, search, motions: task.tally.motions.get(), vertices, path }, task)
}

fn rrt_connect(world: &Arc<World>, seed: u64, range: f64, resolution: f64, limit: f64) -> (Outcome, Task) {
    let created = Instant::now();
    let task = task(world, Test::Resolution(resolution));
    let mut planner = RRTConnect::new(range, 0.0, &PlannerConfig { seed: Some(seed) });
    planner.setup(task.problem.clone(), task.checker.clone());
    let began = Instant::now();
    let path = planner.solve(Duration::from_secs_f64(limit)).ok();
    let (setup, build) = ((began - created).as_secs_f64(), began.elapsed().as_secs_f64());
    (Outcome { setup, build, search: 0.0, motions: task.tally.motions.get(), vertices: 0, path }, task)
}

fn reply_to(job: &str) -> Result<String, Box<dyn std::error::Error>> {
    let words: Vec<&str> = job.split(' ').collect();
    let word = |i: usize| words.get(i).copied().ok_or("a job is too short");
    let world = Arc::new(World::read(word(0)?)?);
    let (seed, runs): (u64, u64) = (word(2)?.parse()?, word(3)?.parse()?);
    let mut done = Vec::new();
    for seed in seed..seed + runs {
        let (outcome, task) = match word(1)? {
            "prm" => prm(&world, seed, word(4)?.parse()?, word(5)?.parse()?),
            "rrt-connect" => rrt_connect(&world, seed, word(4)?.parse()?, word(5)?.parse()?, word(6)?.parse()?),
            other => return Err(format!("unknown planner {other}").into()),
        };
        let length = |path: &Path<Angles>| path.0.windows(2).map(|step| task.space.distance(&step[0], &step[1])).sum();
        let (is_solved, length) = (outcome.path.is_some(), outcome.path.as_ref().map_or(0.0, length));
        let Outcome { setup, build, search, motions, vertices, .. } = outcome;
        // OxMPL does not expose its edges, nor the vertices of its trees.
        done.push(format!(
            r#"{{"setup":{setup},"build":{build},"search":{search},"solved":{is_solved},"length":{length},"motions":{motions},"vertices":{vertices},"edges":0}}"#
        ));
    }
    Ok(format!(r#"{{"runs":[{}]}}"#, done.join(",")))
}

fn main() {
    println!(r#"{{"name":"OxMPL 0.8.1"}}"#);
    for job in std::io::stdin().lock().lines() {
        let reply = reply_to(&job.expect("standard input is text"));
        println!("{}", reply.unwrap_or_else(|error| format!(r#"{{"error":"{error}"}}"#)));
        std::io::stdout().flush().expect("standard output can be written");
    }
}
