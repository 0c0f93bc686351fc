//! A run: iterations of a method from one start after another, until enough solutions are found or the budget is spent.

use super::closed_form::closed_form;
use super::gradient_descent::GradientDescent;
use super::iterative::{DampedLeastSquares, Method, Newton};
use super::kinematics::manipulability;
use super::methods::{MethodId, SolverOptions, Stopping, arm_of};
use super::nearest::nearest;
use super::result::{Rejected, SolverResult, SolverStats, Verdict};
use super::task::{Task, configuration};
use crate::error::Error;
use crate::fingerprint::Fingerprint;
use crate::problem::{Status, Stepped, Validity};
use crate::random::{Random, Stream, check_seed};
use crate::robot::{Arm, Joint, MAX_LINKS, Target};
use crate::space::{MotionSpace, angular_distance};
use crate::world::PlanningWorld;
use std::iter::Enumerate;
use std::vec::IntoIter;

/// Unused: only configurations are checked, not motions.
const TOLERANCE: f64 = 1e-4;

/// Solutions nearer to each other than this, in radians, or parts of the reach for prismatic joints, are one; the second is for
/// redundant arms.
const SEPARATION: [f64; 2] = [1e-3, 0.5];

/// One iterate of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Iterate {
    /// The number of starts drawn before: 0 for the given start. For the closed form, the index of the solution.
    pub restart: u32,
    /// The distance of the tip from the target in metres, or of its orientation in radians, whichever is larger.
    pub error: f64,
    /// The configuration; entries past the last joint are 0.
    pub configuration: [f64; MAX_LINKS],
}

/// The source of the next iterate.
enum Strategy {
    /// From one configuration to the next.
    Iterative(Box<dyn Method>),
    /// The solutions, known already, with their indices.
    Listed(Enumerate<IntoIter<[f64; MAX_LINKS]>>),
}

/// A search for configurations of an arm that bring its tip to a target: a value that is stepped. The result does not depend on
/// the slices; everything found is saved, in the order in which it was found.
pub struct Solver {
    arm: Arm,
    task: Task,
    target: Target,
    scenario: String,
    method: &'static str,
    seed: u64,
    strategy: Strategy,
    random: Random,
    validity: Option<Box<dyn Validity<[f64; MAX_LINKS]>>>,
    stopping: Stopping,
    separation: f64,
    max_restarts: u64,
    wanted: u64,
    status: Status,
    stats: SolverStats,
    /// Whether the next iteration draws a new start.
    is_over: bool,
    /// The smallest error that counted as progress, and how many updates ago.
    mark: (f64, u32),
    iterates: Vec<Iterate>,
    solutions: Vec<Vec<f64>>,
    rejected: Vec<Rejected>,
}

impl Stepped for Solver {
    fn iterate(&mut self) {
        self.stats.iterations += 1;
        self.update();
        if self.stats.iterations >= self.stopping.max_iterations {
            self.end();
        }
    }

    /// `Solved` once the wanted number of solutions is found, or if any is found when the budget is spent.
    fn status(&self) -> Status {
        self.status
    }

    fn iterations(&self) -> u64 {
        self.stats.iterations
    }
}

impl Solver {
    /// A run for the scenario's arm. The start is its first iterate, and may be a solution already.
    ///
    /// # Errors
    /// `unsupported` if the robot is not an arm, if the arm has one link and an orientation is wanted, or if it has no closed
    /// form (pointer `/method`); `out-of-range` for a seed beyond 2^53 - 1; of the target (pointers
    /// `/target/0`, `/target/1`, `/orientation`), of the start (below `/start`) and of options (`/name`): `not-finite`,
    /// `out-of-range`, `wrong-dimension`.
    pub fn new(scenario: impl Into<PlanningWorld>, options: &SolverOptions) -> Result<Self, Error> {
        let world = scenario.into();
        let scenario = world.scenario();
        let arm = arm_of(scenario)?;
        check_seed(options.seed)?;
        let target = options.target.checked(arm)?;
        let (id, mut stopping, max_restarts, finding) = options.method.checked()?;
        let task = Task::new(arm, &target);
        let query = scenario.queries().first().map(|query| query.start.as_slice());
        let start = match options.start.as_deref().or(query) {
            Some(start) => configuration(arm, start, "/start")?,
            None => task.joints.rest(),
        };
        stopping.tolerance = stopping.tolerance.max(task.finest);
        let strategy = match id {
            MethodId::ClosedForm => {
                Strategy::Listed(closed_form(&task, &start, stopping.tolerance)?.into_iter().enumerate())
            }
            MethodId::Newton => Strategy::Iterative(Box::new(Newton)),
            MethodId::GradientDescent => Strategy::Iterative(Box::<GradientDescent>::default()),
            MethodId::DampedLeastSquares => Strategy::Iterative(Box::new(DampedLeastSquares::new())),
        };
        let needed = 2 + usize::from(target.orientation.is_some());
        let separation = SEPARATION[usize::from(arm.links().len() > needed)];
        let validity = || world.checker(&MotionSpace::new(world.default_space()), TOLERANCE).validity();
        let mut solver = Self {
            arm: arm.clone(),
            target,
            scenario: scenario.name().to_owned(),
            method: id.as_str(),
            seed: options.seed,
            strategy,
            random: Random::new(options.seed, Stream::Starts),
            validity: finding.free_only.then(validity),
            stopping,
            separation: finding.separation.unwrap_or(separation),
            max_restarts,
            wanted: finding.solutions,
            status: Status::Running,
            stats: SolverStats::default(),
            is_over: false,
            mark: (f64::INFINITY, 0),
            iterates: Vec::new(),
            solutions: Vec::new(),
            rejected: Vec::new(),
            task,
        };
        match &solver.strategy {
            Strategy::Iterative(_) => solver.arrive(&start),
            Strategy::Listed(_) => solver.note(&start),
        }
        if solver.stopping.max_iterations == 0 {
            solver.end();
        }
        Ok(solver)
    }

    fn update(&mut self) {
        let q = self.configuration();
        let next = match &mut self.strategy {
            Strategy::Listed(solutions) => {
                let Some((i, solution)) = solutions.next() else { return self.end() };
                self.stats.restarts = i as u32;
                return self.arrive(&solution);
            }
            Strategy::Iterative(_) if self.is_over => None,
            Strategy::Iterative(method) => method.update(&self.task, &q),
        };
        match next {
            Some(next) => self.arrive(&next),
            None => self.restart(),
        }
    }

    /// Draws a new start, unless the limit of restarts is reached.
    fn restart(&mut self) {
        if u64::from(self.stats.restarts) >= self.max_restarts {
            return self.end();
        }
        if let Strategy::Iterative(method) = &mut self.strategy {
            self.stats.restarts += 1;
            (self.mark, self.is_over) = ((f64::INFINITY, 0), false);
            method.begin();
            let q = self.task.joints.draw(&mut self.random);
            self.arrive(&q);
        }
    }

    /// Records the configuration and its error.
    fn note(&mut self, q: &[f64; MAX_LINKS]) {
        let error = self.task.deviation(q).error();
        self.iterates.push(Iterate { restart: self.stats.restarts, error, configuration: *q });
    }

    /// Moves the run to `q`: saves a solution, and gives up a start without progress.
    fn arrive(&mut self, q: &[f64; MAX_LINKS]) {
        self.note(q);
        let error = self.error();
        if error <= self.stopping.tolerance {
            self.is_over = true;
            return self.find(q);
        }
        if let Strategy::Iterative(method) = &self.strategy {
            let (patience, progress) = method.patience();
            self.mark = if error < progress * self.mark.0 { (error, 0) } else { (self.mark.0, self.mark.1 + 1) };
            self.is_over = self.mark.1 >= patience;
        }
    }

    /// Saves a solution unless it is known; separately if it is in collision and only free ones are wanted.
    fn find(&mut self, q: &[f64; MAX_LINKS]) {
        let configuration = q[..self.dimension()].to_vec();
        let mut known = self.solutions.iter().chain(self.rejected.iter().map(|one| &one.configuration));
        let joints = &self.task.joints;
        let apart = |i: usize, a: f64, b: f64| match joints.joint(i) {
            Joint::Revolute { .. } => angular_distance(a, b),
            Joint::Prismatic { .. } => joints.turn(i, a, b).abs(),
        };
        let is_same = |known: &Vec<f64>| known.iter().enumerate().all(|(i, &at)| apart(i, at, q[i]) <= self.separation);
        if known.any(is_same) {
            return;
        }
        if let Some(validity) = &self.validity {
            self.stats.configuration_checks += 1;
            let contacts = validity.contacts(q);
            if !contacts.is_empty() {
                return self.rejected.push(Rejected { configuration, contacts });
            }
        }
        self.solutions.push(configuration);
        if self.solutions.len() as u64 >= self.wanted {
            self.end();
        }
    }

    fn end(&mut self) {
        if self.status == Status::Running {
            self.status = if self.solutions.is_empty() { Status::Exhausted } else { Status::Solved };
        }
    }

    /// The number of joints.
    pub fn dimension(&self) -> usize {
        self.task.joints.count
    }

    /// The last iterate; entries past the last joint are 0.
    pub fn configuration(&self) -> [f64; MAX_LINKS] {
        self.iterates.last().map_or([0.0; MAX_LINKS], |iterate| iterate.configuration)
    }

    /// The error of the last iterate.
    pub fn error(&self) -> f64 {
        self.iterates.last().map_or(f64::INFINITY, |iterate| iterate.error)
    }

    /// The manipulability of the last iterate, in square metres: see [`manipulability`].
    pub fn manipulability(&self) -> f64 {
        manipulability(&self.arm, &self.configuration()[..self.dimension()])
    }

    /// Every configuration so far: the start, and one after each iteration except one that ended the run.
    pub fn iterates(&self) -> &[Iterate] {
        &self.iterates
    }

    /// The distinct solutions in the order in which they were found.
    pub fn solutions(&self) -> &[Vec<f64>] {
        &self.solutions
    }

    /// Distinct configurations that reach the target in collision, if only free ones are wanted.
    pub fn rejected(&self) -> &[Rejected] {
        &self.rejected
    }

    /// The largest error of a solution: the parameter, but at least 1e-12 of the reach and the base's coordinates.
    pub fn tolerance(&self) -> f64 {
        self.stopping.tolerance
    }

    /// The work so far.
    pub fn stats(&self) -> SolverStats {
        self.stats
    }

    /// The outcome so far. O(4^links) at worst if nothing has been found: see [`nearest_reachable`](super::nearest_reachable).
    pub fn explain(&self) -> Verdict {
        if !self.solutions.is_empty() {
            return Verdict::Reached;
        }
        if let Some(first) = self.rejected.first() {
            return Verdict::InCollision { contacts: first.contacts.clone() };
        }
        if self.task.joints.has_prismatic() {
            return Verdict::open(self.status);
        }
        Verdict::of(&self.task, nearest(&self.arm, &self.task), self.stopping.tolerance, self.status)
    }

    /// 64-bit FNV-1a over every iterate, solution and rejected configuration, each kind in the order in which it was found.
    pub fn fingerprint(&self) -> u64 {
        let mut hash = Fingerprint::default();
        let count = self.dimension();
        for iterate in &self.iterates {
            hash.integer(u64::from(iterate.restart));
            hash.numbers(&[iterate.error]);
            hash.numbers(&iterate.configuration[..count]);
        }
        hash.integer(self.solutions.len() as u64);
        self.solutions.iter().for_each(|q| hash.numbers(q));
        hash.integer(self.rejected.len() as u64);
        self.rejected.iter().for_each(|one| hash.numbers(&one.configuration));
        hash.value()
    }

    /// The result as a document.
    pub fn result(&self) -> SolverResult {
        SolverResult {
            scenario: self.scenario.clone(),
            method: self.method,
            target: self.target.point.into(),
            orientation: self.target.orientation,
            seed: self.seed,
            status: self.status,
            solutions: self.solutions.clone(),
            rejected: self.rejected.clone(),
            verdict: self.explain(),
            tolerance: self.tolerance(),
            stats: self.stats,
            fingerprint: self.fingerprint(),
        }
    }
}
