//! Navigation by a learned policy, and PRM-RL: roadmaps whose edges a policy drives reliably.
//!
//! A [`Navigation`] task is a floor, a robot with a range sensor and noise, and queries: a differential drive, or a carrier with
//! a load on a rope, which must not swing too far. A [`Policy`] maps what the
//! robot senses to a control; [`Training`] finds one by an evolution strategy. It drives to goals that are near. For those that
//! are far, [`start`] builds a roadmap whose edges are rolled out under the policy, with noise (Faust et al. 2018; Francis et al.
//! 2020), and an [`Executor`] drives along its path. Every arc that is driven is proven free; that a policy reaches its goal is
//! never proven: results say `rollouts`.
//!
//! ```
//! use planarium::navigation::{Policy, RolloutOptions, generate, navigate};
//! use planarium::run::{LazyPrmOptions, Options};
//!
//! let task = generate("rooms", &serde_json::json!({ "columns": 2, "rows": 1, "seed": 3 }))?;
//! let policy = Policy::parse(include_str!("../../www/prm-rl/policy.json"))?;
//! let options = Options::new(LazyPrmOptions { samples: Some(400), ..LazyPrmOptions::default() });
//! let result = navigate(&task, &policy, &RolloutOptions::default(), &options, 10)?;
//! assert!(result.reached.count > 5);
//! assert_eq!(result.plan.edge_check.as_deref(), Some("rollouts"));
//! assert_eq!(result.rollouts.len() + 1, result.plan.path.len());
//! # Ok::<(), planarium::Error>(())
//! ```
//!
//! # Files
//! - `document.rs`: the task; `navigator.rs`: its robot; `generate.rs`: tasks by seed; `episode.rs`: short tasks on a floor;
//! - `floor.rs`: which arcs are free, and what rays meet; `rollout.rs`: a robot that drives to a goal under a controller;
//! - `policy.rs`: the perceptron and its document; `training.rs`: the evolution strategy;
//! - `roadmap.rs`: PRM-RL; `execution.rs`: a path that is driven; `result.rs`: both as a document;
//! - `comparison.rs`: PRM-RL beside the policy alone and straight edges.

mod comparison;
mod document;
mod episode;
mod execution;
mod floor;
mod generate;
mod navigator;
mod outcome;
mod policy;
mod result;
mod roadmap;
mod rollout;
mod sensor;
mod training;

pub use crate::generators::Generator;
pub use comparison::{Comparison, ComparisonOptions, Execution, Method, MethodOverall, MethodSummary, overall};
#[cfg(feature = "schema")]
pub use document::schema;
pub use document::{Navigation, NavigationQuery};
pub use execution::Executor;
pub use generate::{
    DriveOptions, DriveShape, FurnishedOptions, RoomsOptions, generate, generate_with, navigation_generators,
};
pub use navigator::{CargoNavigator, CargoNoise, DriveNavigator, Navigator, Noise};
pub use outcome::Outcome;
pub use policy::{MAX_HIDDEN, POLICY_FORMAT, Policy};
pub use result::{NavigationResult, navigate};
pub use roadmap::{EdgeRollouts, RolloutOptions, edge_rollouts, read_options, start};
pub use rollout::Drive;
pub use sensor::{MAX_RAYS, Sensor};
#[cfg(feature = "parallel")]
pub use training::train;
pub use training::{FRESH_FLOORS, Generation, Training, TrainingOptions, assess};

/// The `format` of a navigation task.
pub const FORMAT: &str = "planarium-navigation-1";
