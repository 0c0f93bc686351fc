//! A run: iterations of a method from one start after another, until enough solutions are found or the budget is spent.

use super::closed_form::closed_form;
use super::damped_least_squares::DampedLeastSquares;
use super::gradient_descent::GradientDescent;
use super::kinematics::manipulability;
use super::method::Method;
use super::methods::{MethodId, Settings};
use super::nearest::nearest;
use super::newton::Newton;
use super::options::{SolverOptions, arm_of};
use super::solutions::{Rejected, are_same};
use super::target::{Target, configuration};
use super::task::Task;
use super::verdict::Verdict;
use crate::error::Error;
use crate::graph::Fingerprint;
use crate::problem::{Status, Validity};
use crate::random::{Random, Stream};
use crate::robot::{Arm, MAX_LINKS};
use crate::space::MotionSpace;
use crate::world::PlanningWorld;

/// Any tolerance serves: only configurations are checked, no motions.
const TOLERANCE: f64 = 1e-4;

/// Solutions nearer to each other than this, in radians, are one; and those of an arm with joints to spare.
const SEPARATION: [f64; 2] = [1e-3, 0.5];

/// One iterate of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Iterate {
    /// How many starts were drawn before: 0 for the start that was given. For the closed form, the number of the solution.
    pub restart: u32,
    /// The distance of the tip from the target in metres, or of its orientation in radians, whichever is larger.
    pub error: f64,
    /// The configuration; entries past the last joint are 0.
    pub configuration: [f64; MAX_LINKS],
}

/// Where the next iterate comes from.
enum Strategy {
    /// From one configuration to the next.
    Iterative { method: Box<dyn Method>, random: Random },
    /// Through the solutions that are known already; the first not yet looked at.
    Listed { solutions: Vec<[f64; MAX_LINKS]>, next: usize },
}

/// A search for configurations of an arm that bring its tip to a target: a value that is stepped. In any slices it gives the same
/// result; all that it finds is kept, in the order in which it was found.
pub struct Solver {
    arm: Arm,
    task: Task,
    target: Target,
    scenario: String,
    method: &'static str,
    seed: u64,
    strategy: Strategy,
    validity: Option<Box<dyn Validity<[f64; MAX_LINKS]>>>,
    tolerance: f64,
    separation: f64,
    max_iterations: u64,
    max_restarts: u64,
    wanted: u64,
    status: Status,
    iterations: u64,
    restarts: u32,
    configuration_checks: u64,
    /// Whether the next iteration draws a new start.
    is_over: bool,
    /// The smallest error that counted as progress, and how many updates ago.
    mark: (f64, u32),
    iterates: Vec<Iterate>,
    solutions: Vec<[f64; MAX_LINKS]>,
    rejected: Vec<Rejected>,
}

impl Solver {
    /// A run for the scenario's arm. The start is its first iterate, and may be a solution already.
    ///
    /// # Errors
    /// `unsupported` where the robot is no arm, the arm has one link and an orientation is wanted, or it has no closed form
    /// (pointer `/method`); `out-of-range` for an unknown method or a seed beyond 2^53 - 1; of the target (pointers
    /// `/target/0`, `/target/1`, `/orientation`), of the start (below `/start`) and of parameters (`/name`): `not-finite`,
    /// `out-of-range`, `wrong-dimension`, `wrong-type`, `unknown-parameter`.
    pub fn new(scenario: impl Into<PlanningWorld>, options: &SolverOptions) -> Result<Self, Error> {
        let world = scenario.into();
        let scenario = world.scenario();
        let arm = arm_of(scenario)?;
        let id = MethodId::of(options.method.as_deref())?;
        options.check_seed()?;
        let target = options.target.checked(arm)?;
        let Settings { tolerance, max_iterations, restarts, finding } = id.read(&options.parameters)?;
        let task = Task::new(arm, &target);
        let query = scenario.queries().first().map(|query| query.start.as_slice());
        let start = match (&options.start, query) {
            (Some(start), _) => configuration(arm, start, "/start")?,
            (None, Some(start)) => configuration(arm, start, "/start")?,
            (None, None) => task.joints.rest(),
        };
        let iterative =
            |method: Box<dyn Method>| Strategy::Iterative { method, random: Random::new(options.seed, Stream::Starts) };
        let tolerance = tolerance.max(task.finest);
        let strategy = match id {
            MethodId::ClosedForm => Strategy::Listed { solutions: closed_form(&task, &start, tolerance)?, next: 0 },
            MethodId::Newton => iterative(Box::new(Newton)),
            MethodId::GradientDescent => iterative(Box::<GradientDescent>::default()),
            MethodId::DampedLeastSquares => iterative(Box::new(DampedLeastSquares::new())),
        };
        let needed = if target.orientation.is_some() { 3 } else { 2 };
        let separation = SEPARATION[usize::from(arm.links().len() > needed)];
        let space = || MotionSpace::new(world.default_space());
        let validity = finding.free_only.then(|| world.checker(&space(), TOLERANCE).validity());
        let mut reach = Self {
            arm: arm.clone(),
            target,
            scenario: scenario.name().to_owned(),
            method: id.as_str(),
            seed: options.seed,
            strategy,
            validity,
            tolerance,
            separation: finding.separation.unwrap_or(separation),
            max_iterations,
            max_restarts: restarts,
            wanted: finding.solutions,
            status: Status::Running,
            iterations: 0,
            restarts: 0,
            configuration_checks: 0,
            is_over: false,
            mark: (f64::INFINITY, 0),
            iterates: Vec::new(),
            solutions: Vec::new(),
            rejected: Vec::new(),
            task,
        };
        match &reach.strategy {
            Strategy::Iterative { .. } => reach.arrive(&start),
            Strategy::Listed { .. } => reach.note(&start),
        }
        Ok(reach)
    }

    /// Does at most `n` iterations, none once the run has ended.
    pub fn step(&mut self, n: u64) -> Status {
        for _ in 0..n {
            if self.status != Status::Running {
                break;
            }
            if self.iterations >= self.max_iterations {
                self.end();
                break;
            }
            self.iterations += 1;
            self.iterate();
        }
        if self.iterations >= self.max_iterations {
            self.end();
        }
        self.status
    }

    fn iterate(&mut self) {
        let q = self.configuration();
        let next = match &mut self.strategy {
            Strategy::Listed { solutions, next } => {
                let Some(&solution) = solutions.get(*next) else {
                    return self.end();
                };
                *next += 1;
                self.restarts = *next as u32 - 1;
                return self.arrive(&solution);
            }
            Strategy::Iterative { .. } if self.is_over => None,
            Strategy::Iterative { method, .. } => method.update(&self.task, &q),
        };
        match next {
            Some(next) => self.arrive(&next),
            None => self.restart(),
        }
    }

    /// Draws a new start, where there may be one more.
    fn restart(&mut self) {
        if u64::from(self.restarts) >= self.max_restarts {
            return self.end();
        }
        if let Strategy::Iterative { method, random } = &mut self.strategy {
            self.restarts += 1;
            (self.mark, self.is_over) = ((f64::INFINITY, 0), false);
            method.begin();
            let q = self.task.joints.draw(random);
            self.arrive(&q);
        }
    }

    /// Keeps the configuration, and its error.
    fn note(&mut self, q: &[f64; MAX_LINKS]) {
        let error = self.task.deviation(q).error();
        self.iterates.push(Iterate { restart: self.restarts, error, configuration: *q });
    }

    /// The run is at `q`: is it a solution, and does its start still lead anywhere?
    fn arrive(&mut self, q: &[f64; MAX_LINKS]) {
        self.note(q);
        let error = self.error();
        if error <= self.tolerance {
            self.is_over = true;
            return self.find(q);
        }
        if let Strategy::Iterative { method, .. } = &self.strategy {
            self.mark =
                if error < method.progress() * self.mark.0 { (error, 0) } else { (self.mark.0, self.mark.1 + 1) };
            self.is_over = self.mark.1 >= method.patience();
        }
    }

    /// Takes a solution, unless it is known, or in collision where that is not wanted.
    fn find(&mut self, q: &[f64; MAX_LINKS]) {
        let separation = self.separation;
        let is_known = |known: &[f64; MAX_LINKS]| are_same(known, q, separation);
        if self.solutions.iter().any(is_known) || self.rejected.iter().any(|one| is_known(&one.configuration)) {
            return;
        }
        if let Some(validity) = &self.validity {
            self.configuration_checks += 1;
            let contacts = validity.contacts(q);
            if !contacts.is_empty() {
                return self.rejected.push(Rejected { configuration: *q, contacts });
            }
        }
        self.solutions.push(*q);
        if self.solutions.len() as u64 >= self.wanted {
            self.end();
        }
    }

    fn end(&mut self) {
        if self.status == Status::Running {
            self.status = if self.solutions.is_empty() { Status::Exhausted } else { Status::Solved };
        }
    }

    /// Where the run stands. It is solved once as many solutions are found as are wanted, or any when the budget is spent.
    pub fn status(&self) -> Status {
        self.status
    }

    /// How many joints a configuration has.
    pub fn dimension(&self) -> usize {
        self.task.joints.count
    }

    /// Where the run is: its last iterate.
    pub fn configuration(&self) -> [f64; MAX_LINKS] {
        self.iterates.last().map_or([0.0; MAX_LINKS], |iterate| iterate.configuration)
    }

    /// The error there.
    pub fn error(&self) -> f64 {
        self.iterates.last().map_or(f64::INFINITY, |iterate| iterate.error)
    }

    /// The manipulability there, in square metres: see [`manipulability`].
    pub fn manipulability(&self) -> f64 {
        manipulability(&self.arm, &self.configuration()[..self.dimension()])
    }

    /// Every configuration so far: the start, one after each iteration but one that ended the run.
    pub fn iterates(&self) -> &[Iterate] {
        &self.iterates
    }

    /// The distinct solutions in the order in which they were found.
    pub fn solutions(&self) -> &[[f64; MAX_LINKS]] {
        &self.solutions
    }

    /// Distinct configurations that reach the target in collision, where only free ones are wanted.
    pub fn rejected(&self) -> &[Rejected] {
        &self.rejected
    }

    /// How large the error of a solution may be: the parameter, but at least 1e-12 of the reach and the base's coordinates.
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// The name of the scenario.
    pub fn scenario(&self) -> &str {
        &self.scenario
    }

    /// The id of the method.
    pub fn method(&self) -> &'static str {
        self.method
    }

    /// The target, its orientation in (-pi, pi].
    pub fn target(&self) -> Target {
        self.target
    }

    /// The seed.
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// Solutions tested for collision so far.
    pub fn configuration_checks(&self) -> u64 {
        self.configuration_checks
    }

    /// Iterations made so far.
    pub fn iterations(&self) -> u64 {
        self.iterations
    }

    /// Starts drawn so far.
    pub fn restarts(&self) -> u32 {
        self.restarts
    }

    /// What has come of the run. O(4^links) at worst where nothing has been found: see [`nearest_reachable`](super::nearest_reachable).
    pub fn explain(&self) -> Verdict {
        if !self.solutions.is_empty() {
            return Verdict::Reached;
        }
        if let Some(first) = self.rejected.first() {
            return Verdict::InCollision { contacts: first.contacts.clone() };
        }
        Verdict::of(&self.task, nearest(&self.arm, &self.task), self.tolerance, self.status)
    }

    /// 64-bit FNV-1a over every iterate, solution and rejected configuration, each kind in the order in which it was made.
    pub fn fingerprint(&self) -> u64 {
        let mut hash = Fingerprint::default();
        let count = self.dimension();
        for iterate in &self.iterates {
            hash.integer(u64::from(iterate.restart));
            hash.numbers(&[iterate.error]);
            hash.numbers(&iterate.configuration[..count]);
        }
        hash.integer(self.solutions.len() as u64);
        self.solutions.iter().for_each(|q| hash.numbers(&q[..count]));
        hash.integer(self.rejected.len() as u64);
        self.rejected.iter().for_each(|one| hash.numbers(&one.configuration[..count]));
        hash.value()
    }
}
