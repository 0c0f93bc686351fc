//! A carrier that moves in the plane, seen from above, with a load on a rope: the spherical pendulum under a pivot that
//! accelerates. Faust et al. 2018, "PRM-RL: Long-range robotic navigation tasks by combining reinforcement learning and
//! sampling-based planning" (cargo delivery with a limit of the load's displacement).
//!
//! Let r be the load relative to the carrier, |r| = L, and a the carrier's acceleration, which is horizontal. In the carrier's
//! frame the load has the acceleration r'' = f - l r - c r', where f = -a - g e_z is gravity and inertia, c the damping, and l r
//! the pull of the rope per mass. As |r| is constant, r . r'' = -|r'|^2, so l = (f . r + |r'|^2) / L^2. The mass of the load does
//! not matter: the carrier follows its command whatever pulls at it. No angle occurs, so no trigonometry is needed.
//!
//! The rope pulls as long as f . r > 0. At a displacement d that holds for every acceleration up to A if A d < g sqrt(L^2 - d^2).
//! A carrier whose limit of swing breaks that is refused: up to its limit, the rope is never slack.

use super::Part;
use super::range::{LARGEST, check_positive, check_range};
use crate::error::{Code, Error, Number, within};
use crate::geometry::Point;
use serde::Serialize;

/// Standard gravity, in metres per second squared.
pub const GRAVITY: f64 = 9.80665;

/// The shortest rope, in metres.
const SHORTEST_ROPE: f64 = 0.1;

/// The greatest damping, per second.
const MOST_DAMPING: f64 = 10.0;

/// The longest step of integration, as a part of sqrt(L / |f|): some 125 steps in a period. A step of the method of Runge and
/// Kutta then loses less than 1e-9 of the energy.
const PART: f64 = 0.05;

/// The longest step of integration, as a part of the time in which damping takes a rate to 1 / e of it.
const DAMPED_PART: f64 = 0.1;

/// The least limit of swing in metres, and the least speed in metres per second.
const LEAST: f64 = 1e-6;

/// The numbers that a [`Cargo`] is made from.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CargoLimits {
    /// The radius of the carrier, in metres, greater than 0.
    pub radius: f64,
    /// The radius of the load, in metres, at least 0.
    pub load_radius: f64,
    /// The length of the rope, from the carrier to the middle of the load, in metres, 0.1 to 1e6.
    pub rope: f64,
    /// The greatest horizontal displacement of the load from the carrier, in metres, at least 1e-6.
    pub swing_limit: f64,
    /// The damping of the swing, per second, 0 to 10: small swings decay with exp(-damping t / 2).
    pub damping: f64,
    /// The greatest speed of the carrier, in metres per second, at least 1e-6.
    pub speed: f64,
    /// The greatest acceleration of the carrier, in metres per second squared, greater than 0.
    pub acceleration: f64,
    /// How long a control is constant, in seconds, 0.001 to 1.
    pub time_step: f64,
}

/// Where carrier and load are, and how they move; x and y of each.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CargoState {
    /// The position of the carrier, in metres.
    pub position: [f64; 2],
    /// Its velocity, in metres per second.
    pub velocity: [f64; 2],
    /// The horizontal displacement of the load from the carrier, in metres.
    pub swing: [f64; 2],
    /// The rate of the displacement, in metres per second.
    pub swing_rate: [f64; 2],
}

impl CargoState {
    /// At rest at a position, with the load straight below.
    pub fn at_rest(position: [f64; 2]) -> Self {
        Self { position, velocity: [0.0; 2], swing: [0.0; 2], swing_rate: [0.0; 2] }
    }
}

/// A carrier with a load on a rope. A control is an acceleration of the carrier (x and y, metres per second squared), constant
/// during a time step. The load moves as an exact spherical pendulum, integrated in fixed steps by the method of Runge and Kutta
/// of order 4.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Cargo {
    #[serde(flatten)]
    limits: CargoLimits,
    /// The steps of integration in a time step.
    #[serde(skip)]
    parts: u32,
}

impl Cargo {
    /// A carrier with a load.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range`, with the pointer of the number (`/rope`, ...): one outside its range; at `/swing_limit`
    /// also a limit at which the greatest acceleration can make the rope slack.
    pub fn new(limits: CargoLimits) -> Result<Self, Error> {
        let CargoLimits { radius, load_radius, rope, swing_limit, damping, speed, acceleration, time_step } = limits;
        check_positive("/radius", "the radius of the carrier", radius, LARGEST)?;
        check_range("/load_radius", "the radius of the load", load_radius, 0.0)?;
        check_range("/rope", "the length of the rope", rope, SHORTEST_ROPE)?;
        check_range("/swing_limit", "the limit of swing", swing_limit, LEAST)?;
        within("/damping", "the damping", damping, 0.0..=MOST_DAMPING)?;
        check_range("/speed", "the greatest speed", speed, LEAST)?;
        check_positive("/acceleration", "the greatest acceleration", acceleration, LARGEST)?;
        within("/time_step", "the time step", time_step, super::differential_drive::STEPS)?;
        // Where the rope can become slack: A d = g sqrt(L^2 - d^2).
        let slack = rope * GRAVITY / (GRAVITY * GRAVITY + acceleration * acceleration).sqrt();
        if swing_limit >= slack {
            let [limit, slack] = [swing_limit, slack].map(Number);
            let sentence =
                format!("the limit of swing must be less than {slack}, where the rope can become slack, not {limit}");
            return Err(Error::new(Code::OutOfRange, "/swing_limit", sentence));
        }
        let force = (acceleration * acceleration + GRAVITY * GRAVITY).sqrt();
        let longest = (PART * (rope / force).sqrt()).min(DAMPED_PART / damping);
        let parts = (time_step / longest).ceil() as u32;
        Ok(Self { limits, parts })
    }

    /// The numbers that it was made from.
    pub fn limits(&self) -> &CargoLimits {
        &self.limits
    }

    /// Whether the load is displaced by no more than the limit of swing.
    pub fn is_within_limit(&self, state: &CargoState) -> bool {
        length(state.swing) <= self.limits.swing_limit
    }

    /// The acceleration that is driven if one is commanded: within the greatest, and such that the speed after the time step is
    /// within the greatest, too, if it was before.
    pub fn clamped(&self, velocity: [f64; 2], acceleration: [f64; 2]) -> [f64; 2] {
        let CargoLimits { speed, acceleration: most, time_step, .. } = self.limits;
        let wanted = shortened(acceleration, most);
        let after = [0, 1].map(|i| velocity[i] + wanted[i] * time_step);
        if length(after) <= speed {
            return wanted;
        }
        // The nearest point of a disc is no farther from a point within it: the acceleration only becomes less.
        let after = shortened(after, speed);
        [0, 1].map(|i| (after[i] - velocity[i]) / time_step)
    }

    /// The state after one time step under a commanded acceleration, which is clamped. `visit` sees the state after each step of
    /// integration. Once the load is displaced beyond the limit of swing, the time step ends there; a state beyond the limit
    /// stays as it is. O(time step / sqrt(rope / g)).
    pub fn drive(&self, from: &CargoState, acceleration: [f64; 2], mut visit: impl FnMut(&CargoState)) -> CargoState {
        let acceleration = self.clamped(from.velocity, acceleration);
        let part = self.limits.time_step / f64::from(self.parts);
        let mut state = *from;
        for i in 1..=self.parts {
            if !self.is_within_limit(&state) {
                return state;
            }
            let [swing, swing_rate] = self.swung(&state, acceleration, part);
            // The carrier from its start: its way is exact, whatever the steps of the load.
            let t = f64::from(i) * part;
            let velocity = [0, 1].map(|k| from.velocity[k] + t * acceleration[k]);
            let position = [0, 1].map(|k| from.position[k] + t * (from.velocity[k] + 0.5 * t * acceleration[k]));
            state = CargoState { position, velocity, swing, swing_rate };
            visit(&state);
        }
        state
    }

    /// The amplitude with which the load swings, in metres: of small swings, without damping, while the carrier does not
    /// accelerate.
    pub fn amplitude(&self, state: &CargoState) -> f64 {
        let ([x, y], [u, w]) = (state.swing, state.swing_rate);
        (x * x + y * y + (u * u + w * w) * self.limits.rope / GRAVITY).sqrt()
    }

    /// How far the load is, at most, from the straight line between its positions before and after the step of integration that
    /// begins with a state, in metres.
    ///
    /// A curve of duration t whose acceleration is at most b is within b t^2 / 8 of its chord. The load accelerates with
    /// -l r - c r', seen from above; the rope does no work in the carrier's frame, so that |r'| grows by at most |f| t.
    pub fn bend(&self, from: &CargoState) -> f64 {
        let CargoLimits { rope, damping, acceleration, time_step, .. } = self.limits;
        let step = time_step / f64::from(self.parts);
        let [_, rate] = self.pendulum(from);
        let force = (acceleration * acceleration + GRAVITY * GRAVITY).sqrt();
        let fastest = dot(rate, rate).sqrt() + force * step;
        let most = force + fastest * fastest / rope + damping * fastest;
        most * step * step / 8.0
    }

    /// How far the carrier is, at most, from the straight line between its positions before and after a time step, in metres.
    pub fn carrier_bend(&self) -> f64 {
        let CargoLimits { acceleration, time_step, .. } = self.limits;
        acceleration * time_step * time_step / 8.0
    }

    /// The load relative to the carrier, and its rate, in space.
    fn pendulum(&self, state: &CargoState) -> Pendulum {
        let ([x, y], [u, w]) = (state.swing, state.swing_rate);
        // Within the limit of swing the load is well below the carrier.
        let down = -(self.limits.rope * self.limits.rope - x * x - y * y).sqrt();
        [[x, y, down], [u, w, -(x * u + y * w) / down]]
    }

    /// The displacement of the load and its rate after one step of integration.
    fn swung(&self, state: &CargoState, acceleration: [f64; 2], step: f64) -> [[f64; 2]; 2] {
        let CargoLimits { rope, damping, .. } = self.limits;
        let force = [-acceleration[0], -acceleration[1], -GRAVITY];
        let slope = |[r, v]: Pendulum| {
            let pull = (dot(force, r) + dot(v, v)) / (rope * rope);
            [v, [0, 1, 2].map(|k| force[k] - pull * r[k] - damping * v[k])]
        };
        let add = |from: Pendulum, slope: Pendulum, t: f64| {
            [0, 1].map(|i: usize| [0, 1, 2].map(|k: usize| from[i][k] + t * slope[i][k]))
        };
        let from = self.pendulum(state);
        let first = slope(from);
        let second = slope(add(from, first, 0.5 * step));
        let third = slope(add(from, second, 0.5 * step));
        let fourth = slope(add(from, third, step));
        let mean =
            [0, 1].map(|i| [0, 1, 2].map(|k| (first[i][k] + 2.0 * (second[i][k] + third[i][k]) + fourth[i][k]) / 6.0));
        let [r, v] = add(from, mean, step);
        if r[2] >= 0.0 {
            // Beyond the horizontal, and so beyond any limit of swing.
            let [x, y] = [r[0], r[1]];
            return [shortened([x / LEAST, y / LEAST], rope), [v[0], v[1]]];
        }
        // Back to the length of the rope, and no rate along it.
        let scale = rope / dot(r, r).sqrt();
        let along = dot(r, v) / dot(r, r);
        [[scale * r[0], scale * r[1]], [v[0] - along * r[0], v[1] - along * r[1]]]
    }

    /// The carrier and the load in a state, seen from above.
    pub fn footprint(&self, state: &CargoState) -> [Part; 2] {
        let CargoLimits { radius, load_radius, .. } = self.limits;
        let [x, y] = state.position;
        let load = Point::new(x + state.swing[0], y + state.swing[1]);
        [Part::Disc { center: Point::new(x, y), radius }, Part::Disc { center: load, radius: load_radius }]
    }
}

/// The load relative to the carrier, and its rate.
type Pendulum = [[f64; 3]; 2];

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// The nearest vector whose length is at most this.
fn shortened(vector: [f64; 2], most: f64) -> [f64; 2] {
    let length = length(vector);
    if length <= most { vector } else { vector.map(|x| x * (most / length)) }
}
