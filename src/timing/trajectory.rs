//! A timed path: where the robot is at every time.

use super::curve::Curve;
use super::limits::Limits;
use super::profile::Knot;
use crate::error::{Code, Error, within};
use serde::Serialize;

/// The most states of a sampled trajectory.
const MOST_SAMPLES: f64 = 1e8;

/// A sampled trajectory ends with its end, not with a state sooner before it than this share of the step.
const TOGETHER: f64 = 1e-9;

/// A piece of the path with its knots: the fraction u, its rate in 1/s, and its second derivative in 1/s^2, which is constant
/// from a knot to the next.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Piece {
    #[serde(flatten)]
    pub(super) curve: Curve,
    pub(super) knots: Vec<Knot>,
}

impl Piece {
    /// The piece as a function of u.
    pub fn curve(&self) -> &Curve {
        &self.curve
    }

    /// The knots: u, its rate per second, and its second derivative per second squared from there on. The first has u = 0, the
    /// last u = 1 and a second derivative of 0.
    pub fn knots(&self) -> &[[f64; 3]] {
        &self.knots
    }
}

/// The time from a knot to the next.
pub(super) fn lasting(from: &Knot, to: &Knot) -> f64 {
    2.0 * (to[0] - from[0]) / (from[1] + to[1])
}

/// A path with its timing, from rest to rest: within limits at every time, which is proven when it is made and when it is read.
///
/// Coordinates are continuous: an angle is not wrapped, and may end some whole turns away from the last waypoint.
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    pub(super) scenario: String,
    pub(super) query: String,
    pub(super) limits: Limits,
    pub(super) start: Vec<f64>,
    pub(super) pieces: Vec<Piece>,
    /// When a phase begins, its piece and its first knot.
    phases: Vec<(f64, usize, usize)>,
    duration: f64,
}

/// The robot at a time.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct State {
    /// The time since the start, in seconds.
    pub time: f64,
    /// The configuration, in metres and radians; angles are not wrapped.
    pub configuration: Vec<f64>,
    /// The rates of the coordinates, per second.
    pub velocity: Vec<f64>,
    /// Their second derivatives, per second squared. Where they jump, those after the jump.
    pub acceleration: Vec<f64>,
}

impl State {
    /// The state on a curve at u, with its rate and its second derivative there.
    pub(super) fn along(curve: &Curve, u: f64, rate: f64, rise: f64, time: f64) -> Self {
        let [configuration, slope, second] = curve.jet(u);
        let velocity = slope.iter().map(|slope| slope * rate).collect();
        let acceleration =
            slope.iter().zip(second).map(|(slope, second)| slope * rise + second * rate * rate).collect();
        Self { time, configuration, velocity, acceleration }
    }
}

impl Trajectory {
    /// From parts whose knots go forward.
    pub(super) fn new([scenario, query]: [&str; 2], limits: Limits, start: Vec<f64>, pieces: Vec<Piece>) -> Self {
        let (mut phases, mut duration) = (Vec::new(), 0.0);
        for (i, piece) in pieces.iter().enumerate() {
            for (k, knots) in piece.knots.windows(2).enumerate() {
                phases.push((duration, i, k));
                duration += lasting(&knots[0], &knots[1]);
            }
        }
        Self { scenario: scenario.to_owned(), query: query.to_owned(), limits, start, pieces, phases, duration }
    }

    /// The name of the scenario.
    pub fn scenario(&self) -> &str {
        &self.scenario
    }

    /// The name of the query.
    pub fn query(&self) -> &str {
        &self.query
    }

    /// The limits that it keeps.
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// The pieces of the path; none if the start is the goal.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The number of rests on the way; start and end do not count. O(pieces).
    pub fn rests(&self) -> usize {
        self.pieces.iter().filter(|piece| piece.knots[0][1] == 0.0).count().saturating_sub(1)
    }

    /// The duration, in seconds.
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// The number of coordinates of a configuration: those of the robot, and of a disc with differential limits the heading.
    pub fn dimension(&self) -> usize {
        self.start.len()
    }

    /// The robot at a time in seconds: before 0 as at 0, after the duration as at the end. O(log of the number of knots).
    ///
    /// # Example
    /// ```
    /// use planarium::geometry::{Aabb, Point};
    /// use planarium::robot::DiscRobot;
    /// use planarium::run::{self, RrtConnectOptions, Status};
    /// use planarium::scenario::{Query, Scenario, World};
    /// use planarium::timing::{self, Limits, PlaneLimits};
    ///
    /// let bounds = Aabb::of(Point::new(0.0, 0.0), Point::new(4.0, 2.0));
    /// let query = Query::new("across", [1.0, 1.0], [3.0, 1.0]);
    /// let scenario = Scenario::new("floor", World::new(Some(bounds), []), DiscRobot::new(0.1)?, [query])?;
    /// let mut run = run::start(&scenario, RrtConnectOptions::default())?;
    /// while run.step(100) == Status::Running {}
    ///
    /// let limits = PlaneLimits { speed: 1.0, acceleration: 1.0, turn_rate: None, turn_acceleration: None };
    /// let trajectory = timing::time(&scenario, &run.result(), &Limits::Plane(limits))?;
    /// let middle = trajectory.state(0.5 * trajectory.duration());
    /// assert!((middle.configuration[0] - 2.0).abs() < 1e-9 && middle.velocity[0] <= 1.0);
    /// assert!(timing::verify(&scenario, &run.result(), &trajectory)?.is_valid());
    /// # Ok::<(), planarium::Error>(())
    /// ```
    pub fn state(&self, time: f64) -> State {
        let time = time.max(0.0).min(self.duration);
        let i = self.phases.partition_point(|(begin, ..)| *begin <= time);
        let Some(&(begin, piece, knot)) = i.checked_sub(1).and_then(|i| self.phases.get(i)) else {
            let zero = vec![0.0; self.dimension()];
            return State { time, configuration: self.start.clone(), velocity: zero.clone(), acceleration: zero };
        };
        let Piece { curve, knots } = &self.pieces[piece];
        let (from, to) = (&knots[knot], &knots[knot + 1]);
        let (spent, rise) = (time - begin, from[2]);
        let [u, rate] = if spent < lasting(from, to) && time < self.duration {
            let u = from[0] + spent * (from[1] + 0.5 * rise * spent);
            [u.min(to[0]), (from[1] + rise * spent).max(0.0)]
        } else {
            [to[0], to[1]]
        };
        State::along(curve, u, rate, rise, time)
    }

    /// The parts between knots, in order: when each begins, its piece, and its knots.
    pub(super) fn spans(&self) -> impl Iterator<Item = (f64, &Piece, [Knot; 2])> {
        self.phases.iter().map(|&(begin, piece, knot)| {
            let piece = &self.pieces[piece];
            (begin, piece, [piece.knots[knot], piece.knots[knot + 1]])
        })
    }

    /// The configuration at a time, as [`Trajectory::state`] has it.
    pub fn configuration(&self, time: f64) -> Vec<f64> {
        self.state(time).configuration
    }

    /// The rates of the coordinates at a time.
    pub fn velocity(&self, time: f64) -> Vec<f64> {
        self.state(time).velocity
    }

    /// The second derivatives of the coordinates at a time.
    pub fn acceleration(&self, time: f64) -> Vec<f64> {
        self.state(time).acceleration
    }

    /// The states at 0, `step`, 2 `step` and so on, in seconds, and at last at the duration exactly.
    ///
    /// # Errors
    /// `out-of-range` or `not-finite` (pointer `/step`) unless the step is greater than 0 and there are at most 10^8 states.
    pub fn sampled(&self, step: f64) -> Result<impl ExactSizeIterator<Item = State> + '_, Error> {
        let least = (self.duration / MOST_SAMPLES).max(f64::MIN_POSITIVE);
        within("/step", "the step in seconds", step, least..=f64::MAX)?;
        // However long the step is, the start is there, and so is the end.
        let fewest = if self.duration > 0.0 { 1.0 } else { 0.0 };
        let count = libm::ceil(self.duration / step - TOGETHER).max(fewest) as u32;
        Ok((0..count + 1).map(move |i| self.state(if i == count { self.duration } else { f64::from(i) * step })))
    }

    /// The document as one line of JSON.
    pub fn to_json(&self) -> String {
        crate::json::to_string(self)
    }

    /// An error about the document.
    pub(super) fn invalid(pointer: impl Into<String>, sentence: impl Into<String>) -> Error {
        Error::new(Code::InvalidResult, pointer, sentence)
    }
}
