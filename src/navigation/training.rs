//! A policy trained by an evolution strategy: random changes of its weights are tried in pairs of opposite signs, and the weights
//! move along those that drive better (Salimans et al. 2017, "Evolution strategies as a scalable alternative to reinforcement
//! learning").
//!
//! Each generation draws new short tasks, the same for all candidates, on floors of its own generator. The return of a candidate
//! is the mean over the tasks: near 1 for a goal that is reached, less the longer it takes; else up to 0.5 for the part of the
//! distance that is covered, and 0.25 less for a collision or a load that swings too far. Returns become ranks, and the weights
//! follow them by Adam (Kingma and Ba 2015).
//!
//! An iteration is one candidate. [`Training::returns_of`] depends on nothing but the generation, so that several threads or
//! workers can share the candidates of a generation, and give their returns to [`Training::advance`].

use super::document::Navigation;
use super::episode;
use super::generate::FurnishedOptions;
use super::outcome::Outcome;
use super::policy::{MAX_HIDDEN, Perceptron, Policy, Sizes};
use super::rollout::{Controller, Drive, Simulation, State, generator};
use crate::error::{Code, Error, within};
use crate::fingerprint::Fingerprint;
use crate::generators::Generator;
use crate::options::Options;
use crate::problem::{Status, Stepped};
use crate::random::{Random, Stream, check_seed};
use crate::statistics::{Share, share};

crate::options! {
    /// Options of the training of a policy.
    pub struct TrainingOptions for &[];
    /// Number of hidden units of the perceptron.
    hidden: usize = 16, in 1.0..=MAX_HIDDEN as f64, "Hidden units";
    /// Number of pairs of candidates in a generation.
    pairs: usize = 32, in 2.0..=1000.0, "Pairs";
    /// Number of tasks that every candidate of a generation is tried on.
    tasks: usize = 40, in 1.0..=1000.0, "Tasks";
    /// Number of generations after which the training ends.
    generations: u64 = 400, in 1.0..=100_000.0, "Generations";
    /// Standard deviation of the changes of the weights.
    deviation: f64 = 0.1, in 1e-4..=10.0, "Deviation";
    /// Step size of the weights.
    rate: f64 = 0.05, in 1e-6..=10.0, "Rate";
    /// Number of generated floors.
    floors: usize = 60, in 1.0..=1000.0, "Floors";
    /// The largest distance of a goal.
    distance: f64 = 5.0, in 1.0..=50.0, "Distance", unit "m";
    /// What a drive that takes all its time returns less than one that takes none: the less, the more careful the policy.
    haste: f64 = 0.3, in 0.0..=1.0, "Haste";
}

/// The decay of the means of Adam.
const DECAY: [f64; 2] = [0.9, 0.99];

/// What is left of the step size at the last generation.
const LAST_RATE: f64 = 0.1;

/// Floors of a training begin at its seed, modulo this, times this: trainings of different seeds below this share none.
const FLOORS_PER_SEED: u64 = 1_000_000;

/// Seeds of floors stay below this; those of [`assess`] begin here.
const FLOOR_SEEDS: u64 = 1 << 52;

/// One generation, once it is over.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Generation {
    /// The mean return of its candidates.
    pub mean: f64,
    /// The return of the best of them.
    pub best: f64,
    /// The share of tasks that its candidates have solved.
    pub reached: f64,
}

/// The training of a policy: a value that is stepped. How its iterations are divided into steps does not change its result.
pub struct Training {
    options: TrainingOptions,
    seed: u64,
    simulations: Vec<Simulation>,
    sizes: Sizes,
    weights: Vec<f64>,
    moments: [Vec<f64>; 2],
    generation: u64,
    /// The changes of the weights that this generation tries, one per pair, and its tasks.
    changes: Vec<Vec<f64>>,
    tasks: Vec<Task>,
    /// Of this generation, so far.
    returns: Vec<[f64; 2]>,
    history: Vec<Generation>,
    fingerprint: Fingerprint,
}

/// A task: on a floor, from a configuration to a position.
#[derive(Clone, Copy)]
struct Task {
    floor: usize,
    from: [f64; 3],
    goal: [f64; 2],
    number: u64,
}

/// An iteration is one of a candidate.
impl Stepped for Training {
    fn iterate(&mut self) {
        let candidate = self.returns.len();
        let returned = self.return_of(candidate);
        self.returns.push(returned);
        if self.returns.len() == self.candidates() {
            self.end_generation();
        }
    }

    /// `Running` until all generations are over, then `Solved`.
    fn status(&self) -> Status {
        if self.generation < self.options.generations { Status::Running } else { Status::Solved }
    }

    fn iterations(&self) -> u64 {
        self.generation * self.candidates() as u64 + self.returns.len() as u64
    }
}

impl Training {
    /// Begins, for the robot of a task and its goal tolerance, with a seed, 0 to 2^53 - 1. The floors are those of the generator
    /// `furnished`.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range`, with the pointer of the option; `out-of-range` at `/robot/shape` if the floors have no
    /// room for the robot.
    pub fn new(task: &Navigation, options: &TrainingOptions, seed: u64) -> Result<Self, Error> {
        options.check()?;
        check_seed(seed)?;
        let floors = options.floors as u64;
        let first = (seed % FLOORS_PER_SEED) * FLOORS_PER_SEED;
        let simulations: Vec<Simulation> = (0..floors).map(|i| floor(task, first + i)).collect::<Result<_, _>>()?;
        let sizes = Sizes::new(task.robot(), options.hidden);
        let weights = sizes.random(&mut Random::new(seed, Stream::Weights));
        let count = weights.len();
        let mut training = Self {
            options: *options,
            seed,
            simulations,
            sizes,
            weights,
            moments: [vec![0.0; count], vec![0.0; count]],
            generation: 0,
            changes: Vec::new(),
            tasks: Vec::new(),
            returns: Vec::new(),
            history: Vec::new(),
            fingerprint: Fingerprint::default(),
        };
        training.prepare();
        if training.tasks.len() < options.tasks {
            return Err(no_room());
        }
        Ok(training)
    }

    /// Draws the changes and the tasks of a generation.
    fn prepare(&mut self) {
        let mut random = generator(self.seed, Stream::Weights, &[self.generation]);
        let count = self.weights.len();
        self.changes = (0..self.options.pairs).map(|_| (0..count).map(|_| random.normal()).collect()).collect();
        self.tasks = self.draw_tasks(self.options.tasks, &[self.generation]);
        self.returns.clear();
    }

    /// Tasks that depend on the seed and these numbers alone.
    fn draw_tasks(&self, count: usize, numbers: &[u64]) -> Vec<Task> {
        let mut random = generator(self.seed, Stream::Tasks, numbers);
        let draw = |number| {
            let floor = random.below(self.simulations.len() as u64) as usize;
            let (from, goal) = episode::draw(&self.simulations[floor].floor, self.options.distance, &mut random)?;
            Some(Task { floor, from, goal, number })
        };
        (0..count as u64).filter_map(draw).collect()
    }

    /// The number of candidates of a generation.
    pub fn candidates(&self) -> usize {
        2 * self.options.pairs
    }

    /// The number of generations that are over.
    pub fn generation(&self) -> u64 {
        self.generation
    }

    /// The number of generations after which the training ends.
    pub fn generations(&self) -> u64 {
        self.options.generations
    }

    /// The generations that are over.
    pub fn history(&self) -> &[Generation] {
        &self.history
    }

    /// The returns of candidates of this generation, from number `first` on, and the share of tasks that each has solved. The
    /// training is unchanged: several threads or workers may evaluate different candidates.
    pub fn returns_of(&self, candidates: std::ops::Range<usize>) -> Vec<[f64; 2]> {
        candidates.map(|candidate| self.return_of(candidate)).collect()
    }

    /// Ends this generation with the returns of all of its candidates, as [`Training::returns_of`] gives them.
    ///
    /// # Errors
    /// `out-of-range` (pointer `/returns`) if there are fewer or more, or one is beyond 1000; `not-finite`. Once the training is
    /// over nothing changes.
    pub fn advance(&mut self, returns: &[[f64; 2]]) -> Result<Status, Error> {
        let count = self.candidates();
        within("/returns", "the number of returns", returns.len() as f64, count as f64..=count as f64)?;
        for (i, returned) in returns.iter().enumerate() {
            for value in returned {
                within(format!("/returns/{i}"), "a return", *value, -1e3..=1e3)?;
            }
        }
        if self.status() == Status::Running {
            self.returns = returns.to_vec();
            self.end_generation();
        }
        Ok(self.status())
    }

    /// The tasks of the floors that the policy is trained on; they have no queries.
    pub fn floors(&self) -> impl ExactSizeIterator<Item = &Navigation> {
        self.simulations.iter().map(Simulation::task)
    }

    /// The mean return of a candidate over the tasks, and the share that it solves.
    fn return_of(&self, candidate: usize) -> [f64; 2] {
        let sign = if candidate.is_multiple_of(2) { self.options.deviation } else { -self.options.deviation };
        let change = &self.changes[candidate / 2];
        let weights: Vec<f64> =
            self.weights.iter().zip(change).map(|(weight, change)| weight + sign * change).collect();
        let controller = Controller::Policy(Perceptron::new(self.sizes, &weights));
        let mut sums = [0.0; 2];
        for task in &self.tasks {
            let [returned, reached] = self.try_task(&controller, task, |_| {}).0;
            sums[0] += returned;
            sums[1] += reached;
        }
        sums.map(|sum| sum / self.tasks.len().max(1) as f64)
    }

    /// Drives one task: its return, whether it is solved, and how it ended.
    fn try_task(&self, controller: &Controller, task: &Task, mut visit: impl FnMut(State)) -> ([f64; 2], Outcome) {
        let Task { floor, from, goal, number } = *task;
        let simulation = &self.simulations[floor];
        let distance = ((goal[0] - from[0]) * (goal[0] - from[0]) + (goal[1] - from[1]) * (goal[1] - from[1])).sqrt();
        let patience = simulation.patience(distance);
        let mut random = generator(self.seed, Stream::Rollouts, &[self.generation, number]);
        let from = simulation.arriving(from, &mut random);
        visit(from);
        let progress = simulation.drive(controller, from, goal, patience, &mut random, visit);
        let covered = 0.5 * (1.0 - progress.left / distance).max(-1.0);
        let returned = match progress.outcome {
            Outcome::Reached => 1.0 - self.options.haste * f64::from(progress.steps) / f64::from(patience),
            Outcome::Timeout => covered,
            Outcome::Collision | Outcome::Swing => covered - 0.25,
        };
        let reached = if progress.outcome == Outcome::Reached { 1.0 } else { 0.0 };
        ([returned, reached], progress.outcome)
    }

    /// Moves the weights by the ranks of the returns, and prepares the next generation.
    fn end_generation(&mut self) {
        let count = self.returns.len();
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|&a, &b| self.returns[a][0].total_cmp(&self.returns[b][0]).then(a.cmp(&b)));
        // Centred ranks, from -1/2 to 1/2.
        let mut ranks = vec![0.0; count];
        for (rank, &candidate) in order.iter().enumerate() {
            ranks[candidate] = rank as f64 / (count - 1) as f64 - 0.5;
        }
        let mean = |i: usize| self.returns.iter().map(|returned| returned[i]).sum::<f64>() / count as f64;
        let best = self.returns[order[count - 1]][0];
        self.history.push(Generation { mean: mean(0), best, reached: mean(1) });

        let t = (self.generation + 1) as f64;
        let passed = self.generation as f64 / self.options.generations as f64;
        let rate = self.options.rate * (1.0 + (LAST_RATE - 1.0) * passed);
        let [first, second] = DECAY;
        let scale = 1.0 / (count as f64 * self.options.deviation);
        let corrections = [1.0 - libm::pow(first, t), 1.0 - libm::pow(second, t)];
        for (i, weight) in self.weights.iter_mut().enumerate() {
            let sum: f64 = self
                .changes
                .iter()
                .enumerate()
                .map(|(pair, change)| (ranks[2 * pair] - ranks[2 * pair + 1]) * change[i])
                .sum();
            let slope = scale * sum;
            let [mean, square] = &mut self.moments;
            mean[i] = first * mean[i] + (1.0 - first) * slope;
            square[i] = second * square[i] + (1.0 - second) * slope * slope;
            *weight += rate * (mean[i] / corrections[0]) / ((square[i] / corrections[1]).sqrt() + 1e-8);
        }
        self.fingerprint.integer(self.generation);
        self.fingerprint.numbers(&self.weights);
        self.generation += 1;
        self.returns.clear();
        if self.status() == Status::Running {
            self.prepare();
        }
    }

    /// The policy so far.
    pub fn policy(&self) -> Policy {
        let name = format!("seed {}, {} generations", self.seed, self.generation);
        let robot = self.simulations[0].task().robot();
        Policy::new(name, robot, self.options.hidden, self.seed, self.generation, &self.weights)
    }

    /// The drives of the policy so far on some tasks, the same in every generation, to be drawn: the number of the floor, the
    /// position to reach, and the drive.
    pub fn demonstrations(&self, count: usize) -> Vec<(usize, [f64; 2], Drive)> {
        let controller = Controller::Policy(Perceptron::new(self.sizes, &self.weights));
        let tasks = self.draw_tasks(count, &[u64::MAX]);
        let shown = tasks.iter().map(|task| {
            let mut states = Vec::new();
            let (_, outcome) = self.try_task(&controller, task, |state| states.push(state));
            (task.floor, task.goal, Drive::new(self.simulations[task.floor].task().robot(), outcome, &states))
        });
        shown.collect()
    }

    /// 64-bit FNV-1a over the weights after every generation.
    pub fn fingerprint(&self) -> u64 {
        self.fingerprint.value()
    }
}

/// The share of random goals within `distance` metres that a policy reaches, with noise, on fresh floors of the kind that it is
/// trained on but which no training has: `trials` tasks on [`FRESH_FLOORS`] floors, drawn from a seed.
///
/// # Errors
/// `unsupported` for a policy of another robot (pointer `/policy/robot`), or that senses in another way (`/policy/sensor`);
/// `out-of-range` for a seed beyond 2^53 - 1, and at `/robot/shape` if the floors have no room for the robot.
pub fn assess(task: &Navigation, policy: &Policy, distance: f64, trials: u64, seed: u64) -> Result<Share, Error> {
    check_seed(seed)?;
    let floors = (0..FRESH_FLOORS).map(|i| floor(task, FLOOR_SEEDS + i)).collect::<Result<Vec<_>, _>>()?;
    let controller = Controller::new(Some(policy), task.robot())?;
    let mut random = Random::new(seed, Stream::Tasks);
    let mut sample = Vec::new();
    for trial in 0..trials {
        let simulation = &floors[(trial % FRESH_FLOORS) as usize];
        let Some((from, goal)) = episode::draw(&simulation.floor, distance, &mut random) else { continue };
        let (x, y) = (goal[0] - from[0], goal[1] - from[1]);
        let patience = simulation.patience((x * x + y * y).sqrt());
        let mut noise = generator(seed, Stream::Rollouts, &[trial]);
        let from = simulation.arriving(from, &mut noise);
        let progress = simulation.drive(&controller, from, goal, patience, &mut noise, |_| {});
        sample.push(f64::from(progress.outcome == Outcome::Reached));
    }
    if sample.is_empty() && trials > 0 {
        return Err(no_room());
    }
    Ok(share(&sample))
}

fn no_room() -> Error {
    let sentence = "the floors on which policies are trained have no room for this robot";
    Error::new(Code::OutOfRange, "/robot/shape", sentence)
}

/// The number of floors that [`assess`] tries.
pub const FRESH_FLOORS: u64 = 50;

/// The floor of this seed for the robot of a task.
fn floor(task: &Navigation, seed: u64) -> Result<Simulation, Error> {
    let generated = FurnishedOptions { seed, ..FurnishedOptions::default() }.generate()?;
    Ok(Simulation::new(&generated.for_robot_of(task)))
}

/// Trains a policy on several threads: each has a training of its own, evaluates a part of each generation, and gets the returns
/// of all. The result is that of [`Training::step`], to the bit. `watch` is called after every generation; the training ends once
/// it returns `false`.
///
/// # Errors
/// Those of [`Training::new`]; `unsupported` if the threads cannot be started.
#[cfg(feature = "parallel")]
pub fn train(
    task: &Navigation,
    options: &TrainingOptions,
    seed: u64,
    threads: std::num::NonZeroUsize,
    mut watch: impl FnMut(&Training) -> bool,
) -> Result<Training, Error> {
    use rayon::prelude::*;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.get()).build().map_err(|error| {
        Error::new(Code::Unsupported, "/threads", format!("the threads cannot be started: {error}"))
    })?;
    let first = Training::new(task, options, seed)?;
    // No more than there are candidates.
    let others = threads.get().min(first.candidates()) - 1;
    let mut team = std::iter::once(Ok(first))
        .chain((0..others).map(|_| Training::new(task, options, seed)))
        .collect::<Result<Vec<_>, _>>()?;
    let (count, members) = (team[0].candidates(), team.len());
    while team[0].status() == Status::Running {
        let part = |i: usize| i * count / members;
        let returns = pool.install(|| {
            let parts = team.par_iter_mut().enumerate().map(|(i, member)| member.returns_of(part(i)..part(i + 1)));
            parts.collect::<Vec<_>>().concat()
        });
        pool.install(|| team.par_iter_mut().try_for_each(|member| member.advance(&returns).map(|_| ())))?;
        if !watch(&team[0]) {
            break;
        }
    }
    Ok(team.swap_remove(0))
}
