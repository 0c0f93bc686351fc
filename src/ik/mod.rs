//! Inverse kinematics of planar arms: which joint angles bring the tip to a target. One file a method.
//!
//! A target is a point, or a point and an orientation of the last link. [`Solver`] is a run that is stepped like a planner and
//! finds one or several configurations; [`follow`] has an arm follow a hand; [`nearest_reachable`] tells, exactly, how near an arm
//! can come to a target, and a target counts as out of reach on that ground alone.

mod closed_form;
mod damped_least_squares;
mod follow;
mod gradient_descent;
mod joints;
mod kinematics;
mod method;
mod methods;
mod nearest;
mod newton;
mod options;
mod report;
mod run;
mod singular;
mod solutions;
mod target;
mod task;
mod verdict;

pub use follow::{Followed, follow};
pub use kinematics::{jacobian, manipulability, orientation, singular_values};
pub use methods::{
    ClosedFormOptions, Finding, GradientDescentOptions, IterativeOptions, MOST_ITERATIONS, MethodId, MethodInfo,
    Starting, methods,
};
pub use nearest::{Nearest, nearest_reachable};
pub use options::{SolverOptions, arm_of};
pub use report::{NearestDocument, RejectedDocument, SolverResult, SolverStats, Touching, VerdictDocument};
pub use run::{Iterate, Solver};
pub use solutions::Rejected;
pub use target::Target;
pub use verdict::{Reason, Verdict};
