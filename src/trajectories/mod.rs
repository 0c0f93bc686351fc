//! Trajectories of particles, and many of them of which no two cross.
//!
//! A particle moves with constant speed and constant turn rate from a start; its trajectory is the closed set of its positions
//! over its whole duration, regardless of time. Two trajectories that share a point cross, contact included; those reported
//! apart are proven apart, by more than the slack 1e-12 S, S the largest coordinate plus the travel (see [`crossing()`]).

mod crossing;
mod grid;
mod halving;
mod options;
mod particle;
mod run;
mod track;

pub use crossing::{Tally, crossing};
pub use halving::{Halving, halve};
pub use options::{IndexKind, TrajectoryOptions};
pub use particle::{MOST_TURNING, Model, Particle, ParticleOptions, particle_points};
pub use run::{Refused, Trajectories, TrajectoriesResult};
