//! A planning problem: a space, its collision checker, a start, a goal, and for cars the dynamics; and what a run on it
//! reports.

mod clearance;
mod dynamics;
mod nearest_free;
mod report;
mod sampled;
mod stepped;
mod validity;

pub use clearance::{ClearanceValidity, Evaluate};
pub use dynamics::{Control, Dynamics, Motion};
pub(crate) use nearest_free::naming_nearest;
pub use nearest_free::nearest_free;
pub use report::{Phase, Reason, Stats, Status};
pub use sampled::{Sampled, Samples};
pub use stepped::Stepped;
pub use validity::{Contact, Touched, Validity};

use crate::error::{Code, Error};
use crate::space::Space;
#[cfg(feature = "parallel")]
use std::num::NonZeroUsize;

/// [`Send`], except in WebAssembly, where functions of JavaScript never leave their thread: what moves to another thread with its
/// run.
#[cfg(not(target_arch = "wasm32"))]
pub trait MaybeSend: Send {}
#[cfg(not(target_arch = "wasm32"))]
impl<T: Send + ?Sized> MaybeSend for T {}

/// [`Send`], except in WebAssembly, where functions of JavaScript never leave their thread: what moves to another thread with its
/// run.
#[cfg(target_arch = "wasm32")]
pub trait MaybeSend {}
#[cfg(target_arch = "wasm32")]
impl<T: ?Sized> MaybeSend for T {}

/// What threads may share: [`Sync`] natively, and in WebAssembly everything.
#[cfg(not(target_arch = "wasm32"))]
pub trait MaybeSync: Sync {}
#[cfg(not(target_arch = "wasm32"))]
impl<T: Sync + ?Sized> MaybeSync for T {}

/// What threads may share: [`Sync`] natively, and in WebAssembly everything.
#[cfg(target_arch = "wasm32")]
pub trait MaybeSync {}
#[cfg(target_arch = "wasm32")]
impl<T: ?Sized> MaybeSync for T {}

/// A lower bound on the distance between two states in the metric of the space.
pub type Estimate<S> = Box<dyn Fn(&S, &S) -> f64 + Send>;

/// Makes a collision checker, each time another one of the same world, for other threads.
#[cfg(feature = "parallel")]
pub type Checkers<S> = Box<dyn Fn() -> Box<dyn Validity<S>> + Send + Sync>;

/// The states that are as good as the goal.
pub struct GoalRegion<S> {
    /// Whether the region contains a state; it contains the goal.
    pub contains: Box<dyn Fn(&S) -> bool + Send>,
    /// The largest distance of any of them from the goal, in the metric of the space.
    pub reach: f64,
}

/// A planning problem whose start and goal are free.
pub struct Problem<S: Space> {
    space: S,
    validity: Box<dyn Validity<S::State>>,
    start: S::State,
    /// At least one.
    goals: Vec<S::State>,
    /// A lower bound on distances from the position of the end effector; `None` if the robot has none.
    pub end_effector: Option<Estimate<S::State>>,
    /// The states that are as good as the goal; `None` if only the goals themselves are.
    pub goal_region: Option<GoalRegion<S::State>>,
    /// Whether RRT, too, ends in the goal region; other planners without controls reach the goal itself.
    pub ends_in_region: bool,
    /// The dynamics; `None` if the system is not moved by controls.
    pub dynamics: Option<Box<dyn Dynamics<S::State>>>,
    /// Whether planners record events, for viewers; the rest of a run is the same without. `true` at first.
    pub records_events: bool,
    /// Collision checkers for other threads, which give the same results with the same counts of work as [`Problem::validity`];
    /// `None` if planners are to use one thread.
    #[cfg(feature = "parallel")]
    pub checkers: Option<Checkers<S::State>>,
    /// How many threads planners may use; 1 at first.
    #[cfg(feature = "parallel")]
    pub threads: NonZeroUsize,
}

impl<S: Space> Problem<S> {
    /// The problem of moving from `start` to `goal`.
    ///
    /// # Errors
    /// `start-in-collision` or `goal-in-collision`, naming every part that touches something and what it touches, and the nearest
    /// free state that [`nearest_free`] finds; the error of a checker that has failed.
    pub fn new(
        space: S,
        validity: Box<dyn Validity<S::State>>,
        start: S::State,
        goal: S::State,
    ) -> Result<Self, Error> {
        let goals = vec![goal];
        let problem = Self {
            space,
            validity,
            start,
            goals,
            end_effector: None,
            goal_region: None,
            ends_in_region: false,
            dynamics: None,
            records_events: true,
            #[cfg(feature = "parallel")]
            checkers: None,
            #[cfg(feature = "parallel")]
            threads: NonZeroUsize::MIN,
        };
        problem.check_ends(&start, &goal)?;
        Ok(problem)
    }

    /// Adds goals, which must be free; any one is to be reached.
    pub fn add_goals(&mut self, goals: &[S::State]) {
        self.goals.extend_from_slice(goals);
    }

    /// Returns an error if the start or the goal is in collision.
    ///
    /// # Errors
    /// As [`Problem::new`]; the pointer is `/start` or `/goal`.
    pub fn check_ends(&self, start: &S::State, goal: &S::State) -> Result<(), Error> {
        self.refuse_collision(start, "start", Code::StartInCollision)?;
        self.refuse_collision(goal, "goal", Code::GoalInCollision)
    }

    fn refuse_collision(&self, state: &S::State, what: &str, code: Code) -> Result<(), Error> {
        let collision = self.validity.collision(state);
        if let Some(error) = self.validity.failure() {
            return Err(error);
        }
        let Some(why) = collision else { return Ok(()) };
        let q = self.space.coordinates(state);
        let error = Error::new(code, format!("/{what}"), format!("the {what} {q:?} is in collision: {why}"));
        let error = naming_nearest(error, &self.space, &|q| self.validity.is_free(q), state);
        self.validity.failure().map_or(Err(error), Err)
    }

    /// The configuration space.
    pub fn space(&self) -> &S {
        &self.space
    }

    /// The collision checker.
    pub fn validity(&self) -> &dyn Validity<S::State> {
        &*self.validity
    }

    /// The start.
    pub fn start(&self) -> &S::State {
        &self.start
    }

    /// The goal; the first if there are several.
    pub fn goal(&self) -> &S::State {
        &self.goals[0]
    }

    /// All goals, at least one.
    pub fn goals(&self) -> &[S::State] {
        &self.goals
    }

    /// One goal after another, in turn.
    pub fn goal_in_turn(&self, turn: usize) -> &S::State {
        &self.goals[turn % self.goals.len()]
    }

    /// The distance to the nearest goal, in the metric of the space.
    pub fn distance_to_goal(&self, state: &S::State) -> f64 {
        self.goals.iter().map(|goal| self.space.distance(state, goal)).fold(f64::INFINITY, f64::min)
    }

    /// What a free motion costs: its length in the metric of the space, and [what the nearness of obstacles
    /// adds](Validity::nearness_cost). Never less than the distance.
    pub fn cost(&self, a: &S::State, b: &S::State) -> f64 {
        self.space.distance(a, b) + self.validity.nearness_cost(a, b)
    }

    /// The sum of the costs of the motions from state to state.
    pub fn path_cost(&self, path: &[S::State]) -> f64 {
        // The sum of nothing is -0.
        path.windows(2).map(|pair| self.cost(&pair[0], &pair[1])).sum::<f64>() + 0.0
    }

    /// The distances from the start to a state and from there to the nearest goal: no path through the state is shorter than
    /// their sum.
    pub fn distances_through(&self, state: &S::State) -> [f64; 2] {
        [self.space.distance(&self.start, state), self.distance_to_goal(state)]
    }

    /// Whether the state is as good as the goal: within the region about it, or one of the goals if there is no region.
    pub fn is_goal(&self, state: &S::State) -> bool {
        match &self.goal_region {
            Some(region) => (region.contains)(state),
            None => self.goals.contains(state),
        }
    }

    /// The largest distance from the goal, in the metric of the space, at which [`Problem::is_goal`] may hold.
    pub fn goal_reach(&self) -> f64 {
        self.goal_region.as_ref().map_or(0.0, |region| region.reach)
    }
}
