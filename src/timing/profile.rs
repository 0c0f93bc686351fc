//! The fastest profile of a path: how fast u grows along every piece of it.
//!
//! Backward from every stop, the greatest x = (du/dt)^2 at each knot from which the rest can be driven; then forward, the
//! greatest second derivative of u that keeps below. On pieces whose derivative is constant three phases are the exact solution.
//! Along a blend x is linear between knots, as in TOPP-RA, and each interval is within its limits everywhere (see `interval`).
//! The knots are closer where the derivative is small and so turns fast: about the place that divides the blend as its two legs.
//!
//! Bobrow, Dubowsky and Gibson 1985, "Time-optimal control of robotic manipulators along specified paths"; Kunz and Stilman
//! 2012, "Time-optimal trajectory generation for path following with bounded acceleration and velocity"; Pham and Pham 2018, "A
//! new approach to time-optimal path parameterization based on reachability analysis".

use super::interval::Interval;
use super::limits::{Bound, dot};

/// The length of an interval of a blend as a share of the distance from the place where its derivative is least, and the shorter
/// leg; the most intervals; and the least share of the legs that the shorter one counts for.
const INTERVAL: f64 = 0.01;
const MOST_INTERVALS: f64 = 1024.0;
const SHORTEST_LEG: f64 = 1e-9;

/// How much greater than at the other end of an interval the ceiling may be at one: more than that acceleration alone allows.
const STEEPEST: f64 = 4.0;

/// The shortest interval.
const SHORTEST: f64 = 1e-12;

/// The greatest second derivative of u as a multiple of the square of the greatest rate. A greater one would reach that rate
/// within a fraction of u that has too few digits; at most 1.25e-7 of the time of a piece are lost by it.
const QUICKEST: f64 = 4e6;

/// How much a limit is made smaller, so that no rounding exceeds it.
const SHRUNK: f64 = 1.0 - 1e-12;

/// A knot: u, du/dt, and d²u/dt² from there to the next one.
pub(super) type Knot = [f64; 3];

/// A piece of a path with its limits.
#[derive(Debug)]
pub(super) struct Span {
    pub limit: Limit,
    /// The lengths of the derivative by u at both ends.
    pub ends: [f64; 2],
    /// Whether the robot rests where it begins.
    pub is_stop: bool,
}

/// What limits u on a piece.
#[derive(Debug)]
pub(super) enum Limit {
    /// The greatest first and second derivative by time, the same everywhere.
    Constant([f64; 2]),
    /// Those of a blend.
    Blend(Vec<Bound>),
}

/// What the backward pass leaves: the greatest x at each knot.
enum Pass {
    Constant { speed: f64, acceleration: f64, most: [f64; 2] },
    Blend { at: Vec<f64>, intervals: Vec<Interval>, most: Vec<f64> },
}

/// The knots of every piece. O(pieces x intervals).
pub(super) fn profile(spans: &[Span]) -> Vec<Vec<Knot>> {
    let mut passes = Vec::with_capacity(spans.len());
    // The square of the speed along the path, where a piece ends.
    let mut beyond = 0.0;
    for span in spans.iter().rev() {
        let pass = span.backward(beyond / square(span.ends[1]));
        beyond = if span.is_stop { 0.0 } else { pass.entry() * square(span.ends[0]) };
        passes.push(pass);
    }
    let mut before = 0.0;
    let forward = |(span, pass): (&Span, Pass)| {
        let entry = if span.is_stop { 0.0 } else { (before / square(span.ends[0])).min(pass.entry()) };
        let (knots, exit) = pass.forward(entry);
        before = exit * square(span.ends[1]);
        knots
    };
    spans.iter().zip(passes.into_iter().rev()).map(forward).collect()
}

fn square(x: f64) -> f64 {
    x * x
}

impl Span {
    /// The greatest x at each knot, at most `exit` at the last.
    fn backward(&self, exit: f64) -> Pass {
        match &self.limit {
            Limit::Constant([speed, acceleration]) => {
                let speed = square(speed * SHRUNK);
                let acceleration = (acceleration * SHRUNK).min(QUICKEST * speed);
                let end = exit.min(speed);
                Pass::Constant { speed, acceleration, most: [speed.min(end + 2.0 * acceleration), end] }
            }
            Limit::Blend(bounds) => {
                let bounds: Vec<Bound> = bounds.iter().map(shrunk).collect();
                let at = fractions(self.ends);
                let mut most = ceilings(&bounds, &at);
                let last = at.len() - 1;
                most[last] = most[last].min(exit);
                let intervals: Vec<_> =
                    at.windows(2).map(|ends| Interval::new(&bounds, ends[0], ends[1] - ends[0])).collect();
                for i in (0..last).rev() {
                    most[i] = intervals[i].greatest(most[i], most[i + 1]);
                }
                Pass::Blend { at, intervals, most }
            }
        }
    }
}

/// The fractions of the knots of a blend, whose legs are half as long as its derivative at the ends.
fn fractions([before, after]: [f64; 2]) -> Vec<f64> {
    let legs = before + after;
    let (middle, width) = (before / legs, (before.min(after) / legs).max(SHORTEST_LEG));
    // Equal steps of the logarithm of width + |u - middle|.
    let [from, to] = [middle, 1.0 - middle].map(|length| libm::log1p(length / width));
    let count = libm::ceil((from + to) / INTERVAL).min(MOST_INTERVALS);
    let at = |i: u32| {
        let step = f64::from(i) / count * (from + to) - from;
        middle + f64::copysign(width * libm::expm1(step.abs()), step)
    };
    let mut fractions = vec![0.0];
    for i in 1..count as u32 {
        let u = at(i);
        if u - fractions[fractions.len() - 1] > SHORTEST && 1.0 - u > SHORTEST {
            fractions.push(u);
        }
    }
    fractions.push(1.0);
    fractions
}

fn shrunk(bound: &Bound) -> Bound {
    Bound { speed: bound.speed * SHRUNK, acceleration: bound.acceleration * SHRUNK, ..*bound }
}

/// What the limits of speed allow at the knots of a blend, such that between two knots a linear x exceeds none of them.
fn ceilings(bounds: &[Bound], at: &[f64]) -> Vec<f64> {
    let of = |bound: &Bound, u: f64| square(bound.speed) / dot(bound.at(u), bound.at(u));
    let alone: Vec<f64> =
        at.iter().map(|&u| bounds.iter().map(|bound| of(bound, u)).fold(f64::INFINITY, f64::min)).collect();
    let mut ceilings = vec![f64::INFINITY; at.len()];
    for i in 0..at.len() - 1 {
        let [from, to] = [alone[i].min(STEEPEST * alone[i + 1]), alone[i + 1].min(STEEPEST * alone[i])];
        let share = |bound: &Bound| bound.speed_share([[at[i], from], [at[i + 1], to]]);
        let over = bounds.iter().map(share).fold(1.0, f64::max);
        ceilings[i] = ceilings[i].min(from / over);
        ceilings[i + 1] = ceilings[i + 1].min(to / over);
    }
    ceilings
}

impl Pass {
    /// The greatest x at its beginning.
    fn entry(&self) -> f64 {
        match self {
            Self::Constant { most, .. } => most[0],
            Self::Blend { most, .. } => most[0],
        }
    }

    /// The knots of the fastest profile from x at the beginning, and x at the end.
    fn forward(&self, entry: f64) -> (Vec<Knot>, f64) {
        match self {
            Self::Constant { speed, acceleration, most } => {
                let exit = most[1].min(entry + 2.0 * acceleration);
                (three_phases(*speed, *acceleration, [entry, exit]), exit)
            }
            Self::Blend { at, intervals, most } => {
                let (mut knots, mut x) = (Vec::with_capacity(at.len()), entry);
                for (i, interval) in intervals.iter().enumerate() {
                    let (next, twice) = (most[i + 1], 2.0 * (at[i + 1] - at[i]));
                    // In proportion to the greatest is within all conditions as well, as these are convex.
                    let rise = interval.fastest(x, next).unwrap_or_else(|| (x / most[i] * next - x) / twice);
                    knots.push([at[i], x.sqrt(), rise]);
                    x = (x + twice * rise).clamp(0.0, next);
                }
                knots.push([1.0, x.sqrt(), 0.0]);
                (knots, x)
            }
        }
    }
}

/// Faster, at constant speed, and slower; phases that are too short to matter are left out.
fn three_phases(speed: f64, acceleration: f64, [entry, exit]: [f64; 2]) -> Vec<Knot> {
    let twice = 2.0 * acceleration;
    let peak = (0.5 * (entry + exit + twice)).min(speed).max(entry).max(exit);
    // Where it is reached, and left.
    let reached = ((peak - entry) / twice).clamp(0.0, 1.0);
    let left = (1.0 - (peak - exit) / twice).clamp(reached, 1.0);
    let knots = [[0.0, entry.sqrt(), acceleration], [reached, peak.sqrt(), 0.0], [left, peak.sqrt(), -acceleration]];
    let ends = [reached, left, 1.0];
    let mut kept: Vec<Knot> =
        knots.into_iter().zip(ends).filter(|(knot, end)| end > &knot[0]).map(|(knot, _)| knot).collect();
    kept.push([1.0, exit.sqrt(), 0.0]);
    kept
}
