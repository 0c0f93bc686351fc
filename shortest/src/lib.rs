//! Shortest paths among the areas, lines and points of a map, which are kept at a distance.
//!
//! A [`Map`] is prepared once, for any number of queries. Its numbers are those of GeoJSON: longitude and latitude in degrees
//! (RFC 7946), or x and y of a plane in metres. Within the plane the paths are exact, as [`ShortestPaths`] says;
//! [`plane`](Plane) says what degrees make of that.
//!
//! # Example
//! Around a block of houses in Berlin:
//!
//! ```
//! use planarium_shortest::{Kind, Map, Part, Settings};
//!
//! let ring = [[13.40, 52.50], [13.41, 52.50], [13.41, 52.51], [13.40, 52.51]];
//! let map = Map::new(&[Part { kind: Kind::Outline, positions: &ring }], &Settings { distance: 5.0, ..Settings::default() })?;
//! let found = map.query([13.395, 52.504], [13.415, 52.504])?.expect("a path");
//! assert_eq!(found.length.round(), 1808.0);
//! # Ok::<(), planarium_shortest::Fault>(())
//! ```
#![deny(missing_docs)]
#![deny(unsafe_code)]
#![deny(clippy::unwrap_used)]

#[cfg(all(target_arch = "wasm32", feature = "bindings"))]
#[allow(unsafe_code)]
mod bindings;
mod fault;
mod map;
mod parts;
mod plane;

pub use fault::{Fault, Subject};
pub use map::{Found, Map, Settings};
pub use parts::{Kind, MAX_POSITIONS, Part};
pub use plane::{MAX_DISTORTION, Plane};

#[allow(unused_imports, reason = "named in the documentation")]
use planarium::optimum::ShortestPaths;
