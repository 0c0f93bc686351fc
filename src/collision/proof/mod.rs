//! The proof that a motion of an arm or of a body is free.
//!
//! ```text
//! first_unproven(motion):
//!     intervals = [the whole motion, with all pairs of a part of the robot and an obstacle near it]
//!     while an interval is left:
//!         take one: the longest, or the front one if the first hit is wanted
//!         budget spent?                           the motion is refused as not proven, and counted
//!         place the robot in the middles of both halves of the interval
//!         for every pair open on the interval, for both halves at once:
//!             apart on the whole half?            drop the pair there for good
//!             touching in its middle?             the motion is refused, unless it is wanted where the first hit is
//!             bound on travel < tolerance?        the motion is refused
//!         add the halves on which pairs are left open
//!     the motion is free
//! ```
//!
//! Both halves of an interval are tested at once, each in a lane of vectors: this costs little more than testing one, and most
//! free motions are proven by their first two halves.
//!
//! In the middle of a half the positions of the parts are known, and a bound on how far each can travel to either
//! end. A part that is farther from an obstacle than it can travel is apart from it on the whole interval: Schwarzer,
//! Saha and Latombe 2005, "Adaptive dynamic collision checking for single and multiple articulated robots in complex
//! environments"; LaValle 2006, "Planning Algorithms", section 5.3.4. Instead of distances, the proof looks for a
//! separating direction: one along which a third-order bound on motion keeps the part away from the obstacle. So a link that
//! slides along a wall needs few intervals.
//!
//! - [`driver`]: the algorithm above, its order, tolerance and budget.
//! - [`arm`], [`body`]: the robots, one implementation each of [`driver::Moving`]; [`motion_bound`] is a body's motion.
//! - [`moving_point`]: the bound of third order on one point, in lanes.
//! - [`pair`]: whether a convex part and a convex obstacle are apart on both halves of an interval.
//! - [`rotation`]: unit vectors of angles, fast and with a known error.
//! - [`oracle`]: the same proof by distances and bounds of first order, as simple as possible, for the tests.

pub(super) mod arm;
pub(super) mod body;
pub(super) mod driver;
mod motion_bound;
mod moving_point;
pub(super) mod oracle;
mod pair;
mod rotation;

pub(super) use arm::MovingArm;
pub(super) use body::MovingBody;
pub(super) use driver::{Order, Prover, Scene};
