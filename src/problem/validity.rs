//! Collision checking as planners see it: the one trait between planning and collision.

/// Whether configurations and motions are free. Planners know obstacles through this trait alone. An implementation of one's own
/// needs [`contacts`](Validity::contacts) and [`is_motion_free`](Validity::is_motion_free).
pub trait Validity<S> {
    /// Every pair of a part of the robot and a thing that it touches; empty where the configuration is free.
    fn contacts(&self, state: &S) -> Vec<Contact>;

    /// Whether the motion from `a` to `b` is proven free, both ends included. Checks the middle first, where collisions are
    /// found early. False means that it is in collision, or too near to one to be proven.
    fn is_motion_free(&self, a: &S, b: &S) -> bool;

    /// Whether the configuration is within bounds and touches no obstacle.
    fn is_free(&self, state: &S) -> bool {
        self.contacts(state).is_empty()
    }

    /// Where, as a fraction of the motion from `a` to `b`, the first interval begins that cannot be proven free; all before
    /// it is proven. `None` where the whole motion is proven. The default knows no part of a motion that is refused.
    fn first_hit(&self, a: &S, b: &S) -> Option<f64> {
        if self.is_motion_free(a, b) { None } else { Some(0.0) }
    }

    /// How many times the clearance of a part has been evaluated so far: the measure of work that is the same on every
    /// machine. The default counts nothing.
    fn clearance_evaluations(&self) -> u64 {
        0
    }

    /// How many motions have been refused so far because the proof had spent its budget of evaluations. The default counts none.
    fn unproven_motions(&self) -> u64 {
        0
    }
}

/// A part of the robot and what it touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Contact {
    /// The part, from 0: the link of an arm from its base outwards, 0 for a robot of one part.
    pub part: usize,
    /// What it touches.
    pub with: Touched,
}

/// What a part of the robot touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Touched {
    /// The obstacle with this index, from 0.
    Obstacle(usize),
    /// The bounds of the world: the part is not wholly inside.
    Bounds,
}

impl std::fmt::Display for Contact {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.with {
            Touched::Obstacle(i) => write!(f, "part {} touches obstacle {i}", self.part),
            Touched::Bounds => write!(f, "part {} leaves the bounds", self.part),
        }
    }
}
