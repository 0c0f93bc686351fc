//! Motion planning that a person can watch.
//!
//! A planning problem is a configuration space, a way to tell what is free in it, a start and a goal. Planners grow a graph
//! towards the answer one step at a time, and every edge they add is proven free, not sampled. Lengths are metres, angles
//! radians, counter-clockwise, y up. Scenario, planner, parameters and seed decide every bit of a result, on every platform.
//!
//! # The way in
//! - [`scenario::Scenario::parse`] reads a document, [`scenario::generate`] makes one by seed;
//! - [`world::PlanningWorld`] prepares it once for all that follows;
//! - [`run::start`] begins a run behind one face, [`run::Run`]; [`run::planners`] lists planners and their options, [`catalogue`] all there is to choose from;
//! - [`kept::RoadmapDocument`] keeps a built roadmap, [`run::resume`] goes on asking it;
//! - [`inspect::Inspector`] answers what a viewer asks;
//! - [`neighbours::index`] finds the nearest of many configurations;
//! - [`drive::Drive`] puts a car under a driver's hand, [`drive::rollout`] tells where one control leads;
//! - [`reach::Reach`] finds joint angles that bring an arm's tip to a target, [`reach::follow`] has it follow a hand;
//! - [`fleet::Trajectories`] adds trajectories that do not cross, one by one;
//! - [`path::verify()`] judges a finished path by an independent route.
//!
//! # The house, and the rule of its arrows
//! From the ground up: [`error`], [`json`], [`options`], [`stats`], [`status`], [`phase`],
//! [`random`], [`geometry`], [`validity`]; on them [`control`], [`steering`], [`space`] and [`robot`]; on those [`scenario`],
//! [`collision`], [`world`], [`problem`] and [`result`]; then [`graph`], [`nearest`], [`sampling`], [`kept`], [`path`], [`drive`],
//! [`reach`] and [`fleet`]; then [`planner`]; then [`run`] and [`inspect`]; on that [`neighbours`]; and last [`catalogue`], the bindings and
//! the command line. A room names only rooms below
//! it: a planner sees a space and the traits [`validity::Validity`] and [`control::Dynamics`], never a robot, a scenario or a
//! shape. The core reads no clock, prints nothing, keeps no global and calls nothing back. A test holds this against the code.
#![deny(missing_docs)]
#![deny(unsafe_code)]

#[cfg(target_arch = "wasm32")]
#[allow(missing_docs, unsafe_code)]
pub mod bindings;
pub mod catalogue;
pub mod collision;
pub mod control;
pub mod drive;
pub mod error;
pub mod fleet;
pub mod geometry;
pub mod graph;
pub mod inspect;
pub mod json;
pub mod kept;
pub mod nearest;
pub mod neighbours;
pub mod options;
pub mod path;
pub mod phase;
pub mod planner;
pub mod problem;
pub mod random;
pub mod reach;
pub mod result;
pub mod robot;
pub mod run;
pub mod sampling;
pub mod scenario;
pub mod space;
pub mod stats;
pub mod status;
pub mod steering;
pub mod validity;
pub mod world;

pub use error::Error;

/// The examples of the README are run as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct ReadmeExamples;
