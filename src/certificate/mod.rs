//! Certificates that there is no path, or that there is one, where configurations have two coordinates: an arm of two links, a
//! disc.
//!
//! The square of configurations is divided into cells, as a quadtree, which wraps where a joint does. Bounds on the clearance
//! over a cell (`bounds.rs`) tell whether it exceeds a given one everywhere in the cell (free), nowhere (blocked), or neither
//! (mixed). Here the clearance is the distance of the robot from the nearest obstacle, in metres, negative infinity outside the
//! bounds of the world, which may be touched.
//!
//! All clearances are rounded: they are meant up to a slack of 2e-12 times the largest coordinate plus the reach, which
//! certificates name. Contact with an obstacle is collision, and cells may become smaller than the slack: a contact at one point
//! is decided.
//!
//! - If the cells that are not blocked, joined where they touch, even in a corner, do not connect start and goal, **no path keeps
//!   more than the clearance**.
//! - If free cells alone connect them, a path does.
//! - Otherwise a channel of free and mixed cells connects them, and its mixed cells are divided. Once the number of cells is
//!   spent, nothing is decided about that clearance, but the bounds of all cells still prove that **no path keeps more than**
//!   some greater one.
//!
//! A certificate (`document.rs`) has the cells that separate start and goal, each with a point of the robot and the obstacle that
//! it stays near; or the channel of free cells. [`verify()`] checks it by other code.
//!
//! Sources: Brooks and Lozano-Pérez 1985, "A subdivision algorithm in configuration space for findpath with rotation" (cells and
//! channels); Zhu and Latombe 1991, "New heuristic algorithms for efficient hierarchical path planning" (channels of mixed cells
//! are refined); Wang, Chiang and Yap 2015, "On soft predicates in subdivision motion planning" (a cell is decided by clearance
//! at its centre, a path by the resolution); Li and Dantam 2023, "Scaling infeasibility proofs via concurrent, codimension-one,
//! locally-updated Coxeter triangulation" (a proof is a closed wall of configurations in collision).

mod bounds;
mod cell;
mod document;
mod subdivision;
mod verify;
mod wall;

pub use cell::Cell;
pub use document::{Blocked, Certificate, Format, Verdict};
pub use subdivision::{DEFAULT_CELLS, Kind, MAX_CELLS, Options, Subdivision};
pub use verify::verify;
