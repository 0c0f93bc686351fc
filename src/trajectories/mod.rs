//! Many robots at once. Here: trajectories of particles, and many of them of which no two cross.
//!
//! A particle moves with constant speed and constant turn rate from a start; its trajectory is the closed set of its places
//! over its whole duration, whenever it is there. Two trajectories that share a point cross, contact included; those called
//! apart are proven apart, by more than the slack 1e-12 S, S the largest coordinate plus the travel (see [`crossing`]).

mod arc;
mod grid;
mod halving;
mod meeting;
mod options;
mod particle;
mod points;
mod refused;
mod run;
mod tally;
mod track;

pub use halving::{Halving, halve};
pub use meeting::crossing;
pub use options::{IndexKind, TrajectoryOptions};
pub use particle::{MOST_TURNING, Model, Particle};
pub use points::{ParticleOptions, particle_points};
pub use refused::Refused;
pub use run::{Trajectories, TrajectoriesResult};
pub use tally::Tally;
