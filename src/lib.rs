//! Motion planning that a person can watch.
//!
//! A planning problem is a configuration space, a collision checker, a start and a goal. Planners extend a graph step by step
//! until it contains a path. By default every edge is proven free; edges can be sampled instead, for comparison. Lengths are
//! metres, angles radians, counter-clockwise, y up. Scenario, planner, parameters and seed decide every bit of a result, on every
//! platform.
//!
//! An arm of two links between two discs, planned for and verified:
//!
//! ```
//! use planarium::geometry::{Aabb, Point};
//! use planarium::path::verify;
//! use planarium::robot::Arm;
//! use planarium::run::{self, PrmOptions, Status};
//! use planarium::scenario::{Obstacle, Query, Scenario, World};
//!
//! let bounds = Aabb::of(Point::new(-2.0, -2.0), Point::new(2.0, 2.0));
//! let obstacles = [Obstacle::disc(Point::new(1.0, 1.0), 0.2), Obstacle::disc(Point::new(-1.0, 0.4), 0.2)];
//! let arm = Arm::new(Point::new(0.0, 0.0), vec![0.9, 0.7], 0.03, None)?;
//! let query = Query::new("over", [0.0, 0.3], [2.4, -0.5]);
//! let scenario = Scenario::new("two discs", World::new(Some(bounds), obstacles), arm, [query])?;
//!
//! let mut run = run::start(&scenario, PrmOptions { samples: Some(400), ..PrmOptions::default() })?;
//! while run.step(100) == Status::Running {}
//! assert_eq!(run.status(), Status::Solved);
//! assert!(verify(&scenario, &run.result())?.is_valid());
//! # Ok::<(), planarium::Error>(())
//! ```
//!
//! Generators take options as a `serde_json::Value`: add `serde_json` to your dependencies for them. The feature `parallel`
//! builds roadmaps in several threads, the feature `schema` makes JSON Schemas.
//!
//! # Where to start
//! - [`scenario::Scenario::new`] makes a scenario of values, [`scenario::Scenario::parse`] reads a document, [`worlds::generate`]
//!   makes one from a seed;
//! - [`PlanningWorld`] prepares a scenario once: space, collision world and broad phase;
//! - [`run::start`] starts a planner with typed [`run::Options`] and returns a [`run::Run`]; [`run::planners`] lists the planners
//!   and their options, and [`run::Request`] reads options by name;
//! - [`run::start_problem`] starts one for a custom robot: a space, and a function that decides what is free;
//!   [`space::Space`] and [`problem::Validity`] are the traits below it;
//! - [`run::start_with`] runs a custom planner ([`planner::Planner`]) for the robots of scenarios, [`run::start_on`] in any
//!   space;
//! - [`run::storage`] saves a roadmap, [`run::resume`] continues with it, [`run::inspect`] answers a viewer's questions,
//!   [`run::neighbours`] indexes configurations;
//! - [`problem::Stepped`] steps what is not a `Run` (fleets, inverse kinematics, certificates, trainings): import it for `step`;
//! - [`path::verify()`] checks a finished path by an independent method;
//! - [`fleet::FleetPlanner`] plans for several robots at once, and [`fleet::verify`] checks its plans;
//! - [`ik::Solver`] finds joint angles that bring an arm's tip to a target;
//! - [`timing::time`] says when a robot is where on a path, within limits of speed and acceleration;
//! - [`optimum::optimum()`] finds the shortest path of a query where that is known, [`optimum::widest()`] how wide a disc may be;
//! - [`route_graph::route_graph()`] makes a sparse graph of proven edges, as the route server of Nav2 reads it;
//! - [`certificate::Subdivision`] proves that there is no path, or that there is one, where configurations have two coordinates;
//! - [`experiment::Experiment`] runs many trials and summarises them;
//! - [`navigation::Training`] trains a policy that drives by what it senses, and [`navigation::start`] plans with edges that it
//!   drives reliably;
//! - [`driving::Drive`] drives a car by keys, [`trajectories::Trajectories`] adds trajectories that do not cross.
//!
//! Natively, worlds, problems and runs are [`Send`]: a run that begins in one thread may end in another.
//!
//! # Modules, from the ground up
//! [`error`], `json`, [`options`], [`random`], `fingerprint`, [`statistics`], [`geometry`]; [`space`] (with steering), [`robot`],
//! [`scenario`], `generators`; [`problem`]; `collision` (with the proof of a motion), [`world`]; [`graph`], [`nearest`],
//! [`sampling`], `shortening`, [`path`]; [`planner`]; [`run`]; and beside each other on it [`certificate`], [`driving`],
//! [`experiment`], [`fleet`], [`ik`], [`navigation`], [`optimum`], [`route_graph`], [`timing`] and [`trajectories`]. On top
//! stand the bindings to JavaScript and the command line. A module uses only modules below it: a planner sees a space and the
//! traits [`problem::Validity`] and [`problem::Dynamics`], never a robot, a scenario or a shape. The core reads no clock,
//! prints nothing, and has no global state: a test enforces this. It calls no code of its caller but the function that decides
//! what is free, and custom planners. Modules hidden from this page are public for the tests, the benches and the command line
//! only; they may change at any time.
#![deny(missing_docs)]
#![deny(unsafe_code)]
#![deny(clippy::unwrap_used)]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(all(target_arch = "wasm32", feature = "bindings"))]
#[allow(missing_docs, unsafe_code)]
pub mod bindings;
pub mod catalogue;
pub mod certificate;
pub mod driving;
pub mod experiment;
#[doc(hidden)]
pub mod fingerprint;
pub mod fleet;
pub mod geometry;
pub mod ik;
pub mod navigation;
pub mod optimum;
pub mod path;
pub mod problem;
pub mod robot;
pub mod route_graph;
pub mod run;
pub mod scenario;
pub mod space;
pub mod statistics;
pub mod timing;
pub mod trajectories;

#[doc(hidden)]
pub mod collision;
pub mod error;
#[doc(hidden)]
pub mod generators;
pub mod graph;
#[doc(hidden)]
pub mod json;
pub mod nearest;
pub mod options;
pub mod planner;
pub mod random;
pub mod sampling;
#[doc(hidden)]
pub mod shortening;
pub mod world;
pub mod worlds;

pub use error::{Code, Error};
pub use world::PlanningWorld;

/// The examples of the README and the documentation are run as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
#[doc = include_str!("../docs/start.md")]
#[doc = include_str!("../docs/planners.md")]
#[doc = include_str!("../docs/proof.md")]
#[doc = include_str!("../docs/in-rust.md")]
#[doc = include_str!("../docs/timing.md")]
pub struct Examples;
