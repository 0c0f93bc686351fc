//! Several robots that share a floor: a fleet, its planners, and the verifier of their plans.
//!
//! A [`Fleet`] is a world with discs and bodies, each with a start and a goal. Every robot is in the floor forever: it stands at
//! its start before it leaves, and at its goal after it arrives. A plan has a [`Trajectory`] for every robot. Two robots are in
//! conflict at a time if they touch; a plan is proven free of conflict at every time, not only at samples.
//!
//! ```
//! use planarium::fleet::{CrossroadsOptions, FleetOptions, FleetPlanner, Generator, verify};
//! use planarium::problem::{Status, Stepped};
//!
//! let fleet = CrossroadsOptions { count: 4, ..CrossroadsOptions::default() }.generate()?;
//! let mut planner = FleetPlanner::new(&fleet, &FleetOptions { seed: 1, ..FleetOptions::default() })?;
//! assert_eq!(planner.step(u64::MAX), Status::Solved);
//! assert!(verify(&fleet, &planner.result())?.is_valid());
//! # Ok::<(), planarium::Error>(())
//! ```
//!
//! # Files
//! - `document.rs`: the fleet and its document; `generate.rs`: fleets by seed;
//! - `motion.rs`: whether two robots in motion are apart; `trajectory.rs`: where a robot is at every time;
//! - `options.rs`: the planners and their options; `run.rs`: a planner that is stepped; `result.rs`: the document that it ends
//!   with;
//! - `prioritized.rs`, with the search of one robot (`safe_intervals.rs`) on the roadmap of its kind (`roadmap.rs`) among the
//!   motions of the others (`traffic.rs`), and orders in which each has a way (`sequence.rs`);
//! - `pbs.rs`: searches that take turns (`turns.rs`), those of `prioritized.rs`, `priority_tree.rs`, `composite.rs` and
//!   `moves.rs`: `joint.rs` and `walks.rs`, both by `joint_move.rs`; a plan is refined (`refinement.rs`);
//! - `composite.rs`: two or three robots planned for as one;
//! - `verify.rs`: the independent verifier; `advancement.rs`: when two robots touch along their trajectories.

mod advancement;
mod composite;
mod document;
mod generate;
mod joint;
mod joint_move;
mod motion;
mod moves;
mod options;
mod pbs;
mod prioritized;
mod priority_tree;
mod refinement;
mod result;
mod roadmap;
mod run;
mod safe_intervals;
mod sequence;
mod traffic;
mod trajectory;
mod turns;
mod verify;
mod walks;

pub use crate::generators::Generator;
pub use advancement::Conflict;
pub use composite::CompositeOptions;
#[cfg(feature = "schema")]
pub use document::schema;
pub use document::{Fleet, FleetRobot, MAX_ROBOTS};
pub use generate::{
    CorridorOptions, CrossroadsOptions, FleetRobots, FleetShape, HallGoals, HallOptions, RingOptions, SwapOptions,
    fleet_generators, generate, generate_with,
};
pub use motion::Pose;
pub use options::{FleetOptions, FleetPlannerOptions, fleet_planners};
pub use pbs::PbsOptions;
pub use prioritized::PrioritizedOptions;
pub use result::{Blocked, BlockedNames, FleetReason, FleetResult, FleetStats, RobotTrajectory};
pub use run::FleetPlanner;
pub use trajectory::Trajectory;
pub use verify::{Claim, Fault, Verification, conflicts, straight, trajectories, verify};

/// The `format` of a fleet.
pub const FORMAT: &str = "planarium-fleet-1";
