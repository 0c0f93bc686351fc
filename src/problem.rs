//! A planning problem: a space, what is free in it, a start and a goal.

use crate::error::{Code, Error};
use crate::space::Space;
use crate::validity::{Contact, Validity};

/// A planning problem whose start and goal are free.
#[derive(Debug, Clone)]
pub struct Problem<S: Space, V> {
    space: S,
    validity: V,
    start: S::State,
    goal: S::State,
}

impl<S: Space, V: Validity<S::State>> Problem<S, V> {
    /// The problem of moving from `start` to `goal`.
    ///
    /// # Errors
    /// `start-in-collision` or `goal-in-collision`, naming every part that touches something and what it touches.
    pub fn new(space: S, validity: V, start: S::State, goal: S::State) -> Result<Self, Error> {
        for (state, what, code) in [(&start, "start", Code::StartInCollision), (&goal, "goal", Code::GoalInCollision)] {
            let contacts = validity.contacts(state);
            if !contacts.is_empty() {
                let q = space.coordinates(state);
                let sentence = format!("the {what} {q:?} is in collision: {}", enumerate(&contacts));
                return Err(Error::new(code, format!("/{what}"), sentence));
            }
        }
        Ok(Self { space, validity, start, goal })
    }

    /// The configuration space.
    pub fn space(&self) -> &S {
        &self.space
    }

    /// What is free.
    pub fn validity(&self) -> &V {
        &self.validity
    }

    /// Where the motion starts.
    pub fn start(&self) -> &S::State {
        &self.start
    }

    /// Where the motion is to end.
    pub fn goal(&self) -> &S::State {
        &self.goal
    }
}

/// The contacts as a list in words.
fn enumerate(contacts: &[Contact]) -> String {
    contacts.iter().map(Contact::to_string).collect::<Vec<_>>().join(", ")
}
