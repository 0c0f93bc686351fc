//! A planning problem: a space, its collision checker, a start, a goal, and for cars the dynamics; and what a run on it
//! reports.

mod dynamics;
mod report;
mod validity;

pub use dynamics::{Control, Dynamics, Motion};
pub use report::{Phase, Stats, Status};
pub use validity::{Contact, Touched, Validity};

use crate::error::{Code, Error};
use crate::space::Space;

/// A lower bound on the distance between two states in the metric of the space.
pub type Estimate<S> = Box<dyn Fn(&S, &S) -> f64>;

/// The states that are as good as the goal.
pub struct GoalRegion<S> {
    /// Whether the region contains a state; it contains the goal.
    pub contains: Box<dyn Fn(&S) -> bool>,
    /// The largest distance of any of them from the goal, in the metric of the space.
    pub reach: f64,
}

/// A planning problem whose start and goal are free.
pub struct Problem<S: Space> {
    space: S,
    validity: Box<dyn Validity<S::State>>,
    start: S::State,
    goal: S::State,
    /// Other states that are as good as the goal.
    other_goals: Vec<S::State>,
    end_effector: Option<Estimate<S::State>>,
    goal_region: Option<GoalRegion<S::State>>,
    dynamics: Option<Box<dyn Dynamics<S::State>>>,
}

impl<S: Space> Problem<S> {
    /// The problem of moving from `start` to `goal`.
    ///
    /// # Errors
    /// `start-in-collision` or `goal-in-collision`, naming every part that touches something and what it touches.
    pub fn new(
        space: S,
        validity: Box<dyn Validity<S::State>>,
        start: S::State,
        goal: S::State,
    ) -> Result<Self, Error> {
        let problem = Self {
            space,
            validity,
            start,
            goal,
            other_goals: Vec::new(),
            end_effector: None,
            goal_region: None,
            dynamics: None,
        };
        problem.check_ends(&start, &goal)?;
        Ok(problem)
    }

    /// The same with a lower bound on distances from the position of the end effector.
    #[must_use]
    pub fn with_end_effector(self, estimate: Estimate<S::State>) -> Self {
        Self { end_effector: Some(estimate), ..self }
    }

    /// The same with more goals, which must be free; any one is to be reached.
    #[must_use]
    pub fn with_other_goals(self, other_goals: Vec<S::State>) -> Self {
        Self { other_goals, ..self }
    }

    /// The same with a region about the goal.
    #[must_use]
    pub fn with_goal_region(self, region: GoalRegion<S::State>) -> Self {
        Self { goal_region: Some(region), ..self }
    }

    /// The same for a system that is moved by controls.
    #[must_use]
    pub fn with_dynamics(self, dynamics: Box<dyn Dynamics<S::State>>) -> Self {
        Self { dynamics: Some(dynamics), ..self }
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
        let contacts = self.validity.contacts(state);
        if contacts.is_empty() {
            return Ok(());
        }
        let q = self.space.coordinates(state);
        let sentence = format!("the {what} {q:?} is in collision: {}", enumerate(&contacts));
        Err(Error::new(code, format!("/{what}"), sentence))
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
        &self.goal
    }

    /// All goals, at least one.
    pub fn goals(&self) -> impl ExactSizeIterator<Item = &S::State> {
        (0..self.other_goals.len() + 1).map(|i| if i == 0 { &self.goal } else { &self.other_goals[i - 1] })
    }

    /// One goal after another, in turn.
    pub fn goal_in_turn(&self, turn: usize) -> &S::State {
        match turn % (self.other_goals.len() + 1) {
            0 => &self.goal,
            i => &self.other_goals[i - 1],
        }
    }

    /// The distance to the nearest goal, in the metric of the space.
    pub fn distance_to_goal(&self, state: &S::State) -> f64 {
        self.goals().map(|goal| self.space.distance(state, goal)).fold(f64::INFINITY, f64::min)
    }

    /// Whether the state is as good as the goal: within the region about it, or one of the goals if there is no region.
    pub fn is_goal(&self, state: &S::State) -> bool {
        match &self.goal_region {
            Some(region) => (region.contains)(state),
            None => self.goals().any(|goal| goal == state),
        }
    }

    /// The largest distance from the goal, in the metric of the space, at which [`Problem::is_goal`] may hold.
    pub fn goal_reach(&self) -> f64 {
        self.goal_region.as_ref().map_or(0.0, |region| region.reach)
    }

    /// The dynamics; `None` if the system is not moved by controls.
    pub fn dynamics(&self) -> Option<&dyn Dynamics<S::State>> {
        self.dynamics.as_deref()
    }

    /// The lower bound on distances from the end effector; `None` if the robot has none.
    pub fn end_effector(&self) -> Option<&Estimate<S::State>> {
        self.end_effector.as_ref()
    }
}

/// The contacts as a list in words.
fn enumerate(contacts: &[Contact]) -> String {
    contacts.iter().map(Contact::to_string).collect::<Vec<_>>().join(", ")
}
