//! Collision checking as planners see it: the one trait between planning and collision.

use super::MaybeSend;
use crate::error::Error;
use serde::{Deserialize, Serialize};

/// Whether configurations and motions are free. Planners know obstacles through this trait alone. An implementation needs
/// [`contacts`](Validity::contacts) and [`is_motion_free`](Validity::is_motion_free).
pub trait Validity<S>: MaybeSend {
    /// Every pair of a part of the robot and something that it touches; empty if the configuration is free.
    fn contacts(&self, state: &S) -> Vec<Contact>;

    /// Whether the motion from `a` to `b` is proven free, both ends included. Checks the middle first, where collisions are
    /// found early. False means that it is in collision, or too near to one to be proven.
    fn is_motion_free(&self, a: &S, b: &S) -> bool;

    /// What a free motion from `a` to `b` costs besides its length, 0 or more, in the unit of the space's distance. Lazy roadmaps
    /// ask for it once, right after the motion has been checked; others go by lengths alone. The default is 0.
    fn surcharge(&self, a: &S, b: &S) -> f64 {
        let _ = (a, b);
        0.0
    }

    /// What the nearness of obstacles adds to the cost of a free motion from `a` to `b`, 0 or more, in the unit of the space's
    /// distance: planners minimise the sum of both. The same in both directions if the space is symmetric. The default is 0.
    fn nearness_cost(&self, a: &S, b: &S) -> f64 {
        let _ = (a, b);
        0.0
    }

    /// Whether the configuration is within bounds and touches no obstacle.
    fn is_free(&self, state: &S) -> bool {
        self.contacts(state).is_empty()
    }

    /// Whether all of these configurations are free. The default tests one after another, up to the first that is not.
    fn are_free(&self, states: &[S]) -> bool {
        states.iter().all(|state| self.is_free(state))
    }

    /// The name of a part of the robot in a sentence, such as `the disc` or `link 2`. The default is `part 0` and so on.
    fn part_name(&self, part: usize) -> String {
        format!("part {part}")
    }

    /// Why the configuration is in collision, for a sentence; `None` if it is free. The default names all contacts.
    fn collision(&self, state: &S) -> Option<String> {
        let contacts = self.contacts(state);
        (!contacts.is_empty()).then(|| Contact::sentence(&contacts, &|part| self.part_name(part)))
    }

    /// The error that ended the checks, of a checker whose evaluation can fail; from then on it refuses everything, and a run
    /// ends with that error. The default is `None`.
    fn failure(&self) -> Option<Error> {
        None
    }

    /// The start, as a fraction of the motion from `a` to `b`, of the first interval that cannot be proven free; all
    /// before it is proven. `None` if the whole motion is proven. The default is 0 for a motion that is refused.
    fn first_hit(&self, a: &S, b: &S) -> Option<f64> {
        if self.is_motion_free(a, b) { None } else { Some(0.0) }
    }

    /// Whether the parabola with these control points is proven free: the quadratic Bezier curve from the first to the third,
    /// which leaves towards the second and comes from there. No coordinate turns by half a turn along it. The default is false:
    /// corners of a path stay as they are.
    fn is_blend_free(&self, blend: &[S; 3]) -> bool {
        let _ = blend;
        false
    }

    /// How many times the clearance of a part has been evaluated so far: a measure of work that is the same on every machine.
    /// The default is 0.
    fn clearance_evaluations(&self) -> u64 {
        0
    }

    /// About how long an evaluation takes, in nanoseconds on one core: its part in the work that limits count. The default is
    /// that of a distance between two simple shapes.
    fn evaluation_nanoseconds(&self) -> u64 {
        20
    }

    /// How many motions have been refused so far because the budget of their proof was spent. The default is 0.
    fn unproven_motions(&self) -> u64 {
        0
    }
}

/// A part of the robot and what it touches; in JSON a `part` and an `obstacle`, an index or `bounds`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "Touching"))]
pub struct Contact {
    /// The part, from 0: the link of an arm from its base outwards, 0 for a robot of one part.
    pub part: usize,
    /// What it touches.
    #[serde(rename = "obstacle")]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "number | \"bounds\""))]
    pub with: Touched,
}

/// An obstacle or the bounds, touched by a part of the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Touched {
    /// The bounds of the world: the part is not wholly inside.
    Bounds,
    /// The obstacle with this index, from 0.
    #[serde(untagged)]
    Obstacle(usize),
}

impl Contact {
    /// Contacts in words, with parts by these names: `link 1 touches obstacle 0, link 2 leaves the bounds`.
    pub fn sentence(contacts: &[Self], name: &dyn Fn(usize) -> String) -> String {
        let words = contacts.iter().map(|contact| format!("{} {}", name(contact.part), contact.with));
        words.collect::<Vec<_>>().join(", ")
    }
}

/// The contact with the index of its part, as in JSON: `part 0 touches obstacle 1`.
impl std::fmt::Display for Contact {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "part {} {}", self.part, self.with)
    }
}

/// What the part does: `touches obstacle 1`, `leaves the bounds`.
impl std::fmt::Display for Touched {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Obstacle(i) => write!(f, "touches obstacle {i}"),
            Self::Bounds => write!(f, "leaves the bounds"),
        }
    }
}
