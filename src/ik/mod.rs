//! Inverse kinematics of planar arms: joint angles that bring the tip to a target.
//!
//! A target is a point, or a point and an orientation of the last link. [`Solver`] is a run that is stepped like a planner and
//! finds one or several configurations; [`follow`] moves an arm after a moving target; [`nearest_reachable`] computes exactly how
//! near an arm can come to a target. A target counts as out of reach only if that distance is not zero.

mod closed_form;
mod follow;
mod gradient_descent;
mod iterative;
mod joints;
mod kinematics;
mod methods;
mod nearest;
mod result;
mod run;
mod task;

pub use crate::robot::Target;
pub use follow::{Followed, follow};
pub use kinematics::{jacobian, manipulability, orientation, singular_values, tip_speed};
pub use methods::{
    ClosedFormOptions, Finding, IterativeOptions, MethodId, MethodOptions, SolverOptions, Starting, Stopping, arm_of,
    methods,
};
pub use nearest::{Nearest, nearest_reachable};
pub use result::{Reason, Rejected, SolverResult, SolverStats, Verdict};
pub use run::{Iterate, Solver};
