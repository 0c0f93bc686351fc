//! Many random trajectories, added one by one: each that crosses none of the earlier ones is accepted.
//!
//! An iteration draws one trajectory, finds the earlier ones that may be near it, and tests it against them in the order of
//! their indices. It is accepted if it is proven apart from all; else the first that it crosses is recorded with it.

use super::crossing::{Tally, meeting, slack};
use super::grid::Grid;
use super::options::{IndexKind, TrajectoryOptions};
use super::particle::Particle;
use super::track::Track;
use crate::error::Error;
use crate::fingerprint::Fingerprint;
use crate::geometry::Point;
use crate::json;
use crate::problem::{Status, Stepped};
use crate::random::{Random, Stream, check_seed};
use serde::Serialize;

/// Trajectories that do not cross, as a value that is stepped. The accepted and the refused ones are append-only.
#[derive(Debug, Clone)]
pub struct Trajectories {
    options: TrajectoryOptions,
    seed: u64,
    random: Random,
    grid: Grid,
    scale: f64,
    accepted: Vec<Track>,
    refused: Vec<Refused>,
    tries: Vec<u32>,
    /// Refused since the last that was accepted.
    failures: u32,
    near: Vec<u32>,
    tally: Tally,
    fingerprint: Fingerprint,
}

/// An iteration is one of a trajectory.
impl Stepped for Trajectories {
    fn iterate(&mut self) {
        self.tally.iterations += 1;
        self.try_next();
    }

    /// `Solved` once the requested number is accepted, `Exhausted` if the iterations are spent before.
    fn status(&self) -> Status {
        if self.accepted.len() >= self.options.count {
            Status::Solved
        } else if self.tally.iterations >= self.options.max_iterations {
            Status::Exhausted
        } else {
            Status::Running
        }
    }

    fn iterations(&self) -> u64 {
        self.tally.iterations
    }
}

impl Trajectories {
    /// Starts with a seed from 0 to 2^53 - 1.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range`, with the pointer of the option or `/seed`.
    pub fn new(options: &TrajectoryOptions, seed: u64) -> Result<Self, Error> {
        options.check_all()?;
        check_seed(seed)?;
        let scale = options.half_side + options.fastest * options.duration;
        let grid = Grid::new(options.half_side, options.count, 2.0 * slack(scale));
        Ok(Self {
            random: Random::new(seed, Stream::Particles),
            grid,
            scale,
            options: *options,
            seed,
            accepted: Vec::new(),
            refused: Vec::new(),
            tries: Vec::new(),
            failures: 0,
            near: Vec::new(),
            tally: Tally::default(),
            fingerprint: Fingerprint::default(),
        })
    }

    fn try_next(&mut self) {
        let track = Track::new(self.draw(), self.scale);
        match self.first_crossed(&track) {
            None => {
                self.fingerprint.integer(0);
                self.fingerprint.numbers(&track.particle.numbers());
                if self.options.index == IndexKind::Grid {
                    self.grid.insert(&track);
                }
                self.accepted.push(track);
                self.tries.push(self.failures + 1);
                self.failures = 0;
            }
            Some((other, point)) => {
                let refused = Refused { particle: track.particle, other, point };
                self.fingerprint.integer(1);
                self.fingerprint.numbers(&refused.numbers());
                self.refused.push(refused);
                self.failures += 1;
            }
        }
    }

    /// A random trajectory. Every number is drawn even if its range is a point, so that changing one range does not affect the
    /// others.
    fn draw(&mut self) -> Particle {
        let random = &mut self.random;
        let mut between = |low: f64, high: f64| low + random.uniform() * (high - low) + 0.0;
        let TrajectoryOptions { model, half_side, spread, slowest, fastest, duration, .. } = self.options;
        let TrajectoryOptions { least_turn_rate, greatest_turn_rate, .. } = self.options;
        let (x, y) = (between(-half_side, half_side), between(-half_side, half_side));
        let theta = between(-spread, spread);
        let speed = between(slowest, fastest);
        let turn_rate = between(least_turn_rate, greatest_turn_rate);
        Particle { model, start: Point::new(x, y), theta, speed, turn_rate, duration }
    }

    /// The first of the accepted trajectories that this one crosses, and a common point.
    fn first_crossed(&mut self, track: &Track) -> Option<(u32, Point)> {
        let Self { grid, accepted, near, tally, .. } = self;
        if self.options.index == IndexKind::Grid {
            grid.near(track, near);
            near.sort_unstable();
        } else {
            near.clear();
            near.extend(0..accepted.len() as u32);
        }
        let eta = slack(self.scale);
        near.iter().find_map(|&i| Some((i, meeting(track, &accepted[i as usize], eta, tally)?)))
    }

    /// The accepted trajectories, in the order in which they were accepted.
    pub fn accepted(&self) -> impl ExactSizeIterator<Item = &Particle> {
        self.accepted.iter().map(|track| &track.particle)
    }

    /// The refused trajectories, in the order in which they were tried.
    pub fn refused(&self) -> &[Refused] {
        &self.refused
    }

    /// For every accepted trajectory: how many were tried for it, itself included.
    pub fn tries(&self) -> &[u32] {
        &self.tries
    }

    /// The work so far.
    pub fn tally(&self) -> Tally {
        self.tally
    }

    /// 64-bit FNV-1a over everything tried, in order: 0 and the six numbers of an accepted trajectory, 1 and the nine of a
    /// refused one. It does not depend on the index.
    pub fn fingerprint(&self) -> u64 {
        self.fingerprint.value()
    }

    /// The counts as a document.
    pub fn result(&self) -> TrajectoriesResult {
        TrajectoriesResult {
            model: self.options.model.into(),
            seed: self.seed,
            status: self.status(),
            accepted: self.accepted.len(),
            refused: self.refused.len(),
            tally: self.tally,
            fingerprint: self.fingerprint(),
        }
    }
}

/// The result of a run, as it is written in JSON.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct TrajectoriesResult {
    /// The rule of motion: `arc` or `spiral`.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "ParticleModel"))]
    pub model: &'static str,
    /// The seed.
    pub seed: u64,
    /// The status at the end.
    pub status: Status,
    /// How many trajectories are accepted.
    pub accepted: usize,
    /// How many are refused.
    pub refused: usize,
    /// The work done.
    #[serde(flatten)]
    pub tally: Tally,
    /// A hash over everything tried: [`Trajectories::fingerprint`].
    #[serde(with = "json::hex")]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "string"))]
    pub fingerprint: u64,
}

/// A trajectory that crosses an earlier one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refused {
    /// The trajectory.
    pub particle: Particle,
    /// The first of the accepted trajectories that it crosses, by its index.
    pub other: u32,
    /// A point where it crosses it, or comes too close.
    pub point: Point,
}

impl Refused {
    /// Nine numbers: x, y, theta, v, w, duration, the index of the other, and the point.
    pub fn numbers(&self) -> [f64; 9] {
        let [x, y, theta, v, w, duration] = self.particle.numbers();
        [x, y, theta, v, w, duration, f64::from(self.other), self.point.x, self.point.y]
    }
}
