//! Many trajectories for JavaScript.

use super::arguments::{fields, rows};
use super::clock::{Timed, stepped};
use super::digits;
use super::records::record;
use super::types::{ParticleOptions, Rows, Status, TrajectoryOptions};
use crate::Error;
use crate::options::Options;
use crate::problem::Stepped;
use crate::trajectories;
use std::cell::RefCell;
use tsify::Ts;
use wasm_bindgen::prelude::*;

/// Random trajectories of particles, added one by one: one that crosses none of the earlier ones is accepted, the others are
/// refused. Contact is crossing, and those accepted are proven apart. Each `step` tries some trajectories; how they are divided
/// into steps does not change the result. Both lists are only ever appended to, and read by cursors.
#[wasm_bindgen]
pub struct Trajectories(RefCell<Timed<trajectories::Trajectories>>);

#[wasm_bindgen]
impl Trajectories {
    /// Starts a run; `trajectoryOptions()` lists the options.
    /// @throws {PlanariumError} `unknown-parameter`, `wrong-type`, `not-finite` or `out-of-range`, with the pointer of the option
    #[wasm_bindgen(constructor)]
    pub fn new(options: Option<TrajectoryOptions>) -> Result<Trajectories, Error> {
        let mut fields = fields(options)?;
        let seed = fields.take("seed")?.unwrap_or(0);
        let run = trajectories::Trajectories::new(&Options::read(&fields.parameters())?, seed)?;
        Ok(Self(RefCell::new(Timed::new(run))))
    }
}

stepped!(Trajectories);

members! { Trajectories(self): wasm_bindgen(getter);
    /// `solved` once `count` are accepted, `exhausted` once `maxIterations` are tried before.
    status: Status = self.0.borrow().run.status().into();
    /// The number of trajectories tried so far.
    iterations: f64 = self.0.borrow().run.tally().iterations as f64;
    /// The number of accepted trajectories.
    acceptedCount: usize = self.0.borrow().run.accepted().len();
    /// The number of refused trajectories.
    refusedCount: usize = self.0.borrow().run.refused().len();
    /// 16 hexadecimal digits over everything tried, in order; `index` does not change it.
    fingerprint: String = digits(self.0.borrow().run.fingerprint());
}

members! { Trajectories(self): wasm_bindgen;
    /// For every accepted trajectory, how many were tried for it, itself included. A copy.
    tries: Vec<u32> = self.0.borrow().run.tries().to_vec();
    /// The result document, the one that the command line prints, without its seconds.
    result: Ts<trajectories::TrajectoriesResult> = record(&self.0.borrow().run.result());
}

tables! { Trajectories(self, row)
    /// The accepted trajectories from row `row` (0 to `acceptedCount`) on, in rows of x, y, theta, v, w, duration. A copy.
    acceptedSince: Vec<f64> = self.acceptedCount() => {
        self.0.borrow().run.accepted().skip(row).flat_map(|particle| particle.numbers()).collect()
    };
    /// The refused trajectories from row `row` (0 to `refusedCount`) on, in rows of x, y, theta, v, w, duration, the number of
    /// the first accepted one that it crosses, and x and y of a common point. A copy.
    refusedSince: Vec<f64> = self.refusedCount() => {
        self.0.borrow().run.refused()[row..].iter().flat_map(|refused| refused.numbers()).collect()
    };
}

/// The positions of one particle at `times`, in seconds from 0 to a million: x and y each. It moves on a circular arc, or on the
/// spiral x + v t cos(theta + w t), y + v t sin(theta + w t).
/// @throws {PlanariumError} `unknown-parameter`, `wrong-type`, `not-finite` or `out-of-range`, with the pointer of the field
#[wasm_bindgen(js_name = particlePoints)]
pub fn particle_points(particle: ParticleOptions, times: &Rows) -> Result<Vec<f64>, Error> {
    trajectories::particle_points(&fields(Some(particle))?.parameters(), &rows(times, 1, "times")?)
}
