//! What a planner may ask of the world: the one trait between planning and collision.

/// Whether configurations and motions are free. Planners know obstacles through this trait alone.
pub trait Validity<S> {
    /// Whether the configuration is within bounds and touches no obstacle.
    fn is_free(&self, state: &S) -> bool;

    /// Whether the motion from `a` to `b` is proven free, both ends included. Looks at the middle first, where collisions
    /// are found early. "No" means that it is in collision, or too near to one to be proven.
    fn is_motion_free(&self, a: &S, b: &S) -> bool;

    /// Where, as a fraction of the motion from `a` to `b`, the first stretch begins that cannot be proven free; all before
    /// it is proven. `None` where the whole motion is proven.
    fn first_hit(&self, a: &S, b: &S) -> Option<f64>;

    /// Every pair of a part of the robot and a thing that it touches; empty where the configuration is free.
    fn contacts(&self, state: &S) -> Vec<Contact>;

    /// How many times the clearance of a part has been evaluated so far: the measure of work that is the same everywhere.
    fn clearance_evaluations(&self) -> u64;
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
