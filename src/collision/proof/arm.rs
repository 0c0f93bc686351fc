//! A moving arm, for the driver of the proof: every joint turns at a constant rate.
//!
//! **Bounds.** The outer end of link i is the sum of L_j e_j over the links j up to it, e_j the unit vector along link j.
//! With w_j the absolute rate of link j, its acceleration is minus the sum of L_j w_j^2 e_j, and W = sum of L_j |w_j|^3
//! bounds its third derivative (see `moving_point.rs`). Its bound of first order is the sum of L_j |w_j|, about half of
//! the textbook's sum of reaches.
//!
//! **Slack.** S is the largest coordinate plus the reach; the slack is 1e-12 S. A test passes only if its terms sum to no more
//! than about 2 S. As W has no cancelling terms and the L_j sum to at most S, then h |v| < 3 S and h^2 |a| / 2 < 3 S, so that each of
//! the roughly 30 roundings costs less than 8 S times 2^-53: below 3e-14 S in all. Unit vectors are products of those of
//! `rotation.rs`: the absolute angle at the start, off by 1.4e-14 at most; half the turn by 2.8e-14; a quarter, an eighth and
//! so on by half as much each, 2.8e-14 together; and a product a level, at most 50, by 3 times 2^-53 each: 9e-14 in all, and
//! so much times S. Links that turn by more than 12.8 radians are not squared up but reduced level by level, each off by
//! 1.4e-14, until they are small: of eight circles one level, with the widest limits nine, 1.3e-13 more. Absolute angles and
//! rates are sums of up to eight joints: of circles up to 26 radians; with limits up to 50, sums up to 800 and differences up to
//! 100, rounded to 5e-13 in all at worst. If limits are wider, up to twice that, the slack is doubled.

use super::driver::{Interval, Moving};
use super::moving_point::{MovingPoint, dot, left_of};
use super::pair::{Direction, Part, nearest_point};
use super::rotation::{UnitVectors, unit};
use crate::collision::obstacles::Face;
use crate::geometry::{Aabb, Point, Vector};
use crate::robot::{Arm, MAX_LINKS};

/// Turns over this many halvings are found together, by squaring the smallest.
const SQUARED: usize = 4;

/// The fastest rate, in radians over the motion, whose thirty-second is small enough to be squared up.
const FASTEST_SQUARED: f64 = 12.8;

/// Where a link turns by more radians than this over half an interval, its bound of first order and its reach may be the
/// better ones.
const FAST: f64 = 1.5;

/// An arm of up to `N` links, and its motion.
pub(in crate::collision) struct MovingArm<const N: usize> {
    base: Point,
    lengths: Vec<f64>,
    eta: f64,
    /// The radius and the slack.
    margin: f64,
    /// The configuration last begun from, and its unit vectors: roadmaps try many motions from one.
    from: [f64; N],
    from_along: UnitVectors<N>,
    /// Of every link: its absolute rate, in radians over the whole motion, its bound of first order, and W of its outer end.
    rates: [f64; N],
    travel: [f64; N],
    third: [f64; N],
    /// The largest absolute rate of all links.
    fastest: f64,
    /// The turn of every link over a quarter of the motion, an eighth, and so on.
    turns: [UnitVectors<N>; SQUARED],
    finer_turns: Vec<UnitVectors<N>>,
    /// The joints in the middle of the interval under test.
    joints: [MovingPoint; MAX_LINKS + 1],
}

impl<const N: usize> MovingArm<N> {
    /// The arm, with this slack.
    pub fn new(arm: &Arm, eta: f64) -> Self {
        Self {
            base: arm.base(),
            lengths: arm.links().to_vec(),
            eta,
            margin: arm.radius() + eta,
            from: [f64::NAN; N],
            from_along: UnitVectors::ZERO,
            rates: [0.0; N],
            travel: [0.0; N],
            third: [0.0; N],
            fastest: 0.0,
            turns: [UnitVectors::ZERO; SQUARED],
            finer_turns: Vec::new(),
            joints: [MovingPoint::default(); MAX_LINKS + 1],
        }
    }

    /// Begins a motion in which joint i turns by `delta[i]` radians; entries past the arm's links are 0. Returns the unit
    /// vectors along the links in its middle.
    #[inline(always)]
    pub fn begin(&mut self, from: &[f64; N], delta: &[f64; N]) -> UnitVectors<N> {
        self.finer_turns.clear();
        if self.from != *from {
            self.from = *from;
            let mut angle = 0.0;
            for i in 0..N {
                angle += self.from[i];
                self.from_along.set(i, unit(angle));
            }
        }
        let (mut rate, mut travel, mut third, mut fastest) = (0.0, 0.0, 0.0, 0.0);
        for (i, &length) in self.lengths.iter().enumerate().take(N) {
            rate += delta[i];
            let spin = f64::abs(rate);
            let speed = length * spin;
            travel += speed;
            third += speed * rate * rate;
            if spin > fastest {
                fastest = spin;
            }
            (self.rates[i], self.travel[i], self.third[i]) = (rate, travel, third);
        }
        self.fastest = fastest;
        let mut turns = UnitVectors::new(&self.rates, 1.0 / 32.0, fastest);
        for level in (0..SQUARED).rev() {
            self.turns[level] = turns;
            turns = turns.doubled();
        }
        if fastest > FASTEST_SQUARED {
            turns = UnitVectors::new(&self.rates, 0.5, fastest);
            let mut part = 0.25;
            for level in &mut self.turns {
                *level = UnitVectors::new(&self.rates, part, fastest);
                part *= 0.5;
            }
        }
        self.from_along.rotate_both_ways(&turns)[1]
    }

    /// Places the arm at rest; returns the unit vectors along its links.
    #[inline(always)]
    pub fn rest(&mut self, q: &[f64]) -> UnitVectors<N> {
        let mut along = UnitVectors::ZERO;
        let mut angle = 0.0;
        self.joints[0] = MovingPoint::at_rest(self.base);
        for (i, &length) in self.lengths.iter().enumerate().take(N) {
            angle += q[i];
            along.set(i, unit(angle));
            self.joints[i + 1] = MovingPoint::at_rest(self.joints[i].place() + along.at(i) * length);
        }
        self.fastest = 0.0;
        along
    }

    /// A box that holds joint `k` on the whole interval.
    #[inline(always)]
    fn joint_box(&self, k: usize, half: f64) -> Aabb {
        let swept = self.joints[k].swept_box();
        if k > 0 && self.fastest * half > FAST { self.restricted(swept, k, half) } else { swept }
    }

    /// The part of a joint's box within its bound of first order, and within its reach from the base.
    #[cold]
    fn restricted(&self, swept: Aabb, joint: usize, half: f64) -> Aabb {
        let travel = self.travel[joint - 1] * half;
        let reach = self.lengths[..joint].iter().sum::<f64>() + self.eta;
        let within = |swept: Aabb, center: Point, by: f64| Aabb {
            min: swept.min.sup(&(center - Vector::new(by, by))),
            max: swept.max.inf(&(center + Vector::new(by, by))),
        };
        within(within(swept, self.joints[joint].place(), travel), self.base, reach)
    }
}

impl<const N: usize> Moving for MovingArm<N> {
    /// The unit vectors along the links.
    type State = UnitVectors<N>;
    type Part<'a> = Link<'a>;

    #[inline(always)]
    fn parts(&self) -> usize {
        self.lengths.len()
    }

    #[inline(always)]
    fn place(&mut self, interval: &Interval<UnitVectors<N>>, parts: usize) {
        let h = interval.half;
        let sixth = h * h * h / 6.0;
        let mut joint = MovingPoint::at_rest(self.base);
        self.joints[0] = joint;
        for (i, &length) in self.lengths[..parts].iter().enumerate() {
            let along = interval.state.at(i) * length;
            let turn = h * self.rates[i];
            let swing = along * turn;
            joint = MovingPoint {
                position: joint.position + along,
                velocity: joint.velocity + left_of(swing),
                acceleration: joint.acceleration + swing * (0.25 * turn),
                remainder: sixth * self.third[i],
            };
            self.joints[i + 1] = joint;
        }
    }

    #[inline(always)]
    fn halves(&mut self, interval: &Interval<UnitVectors<N>>) -> [UnitVectors<N>; 2] {
        let turns = match interval.level.checked_sub(SQUARED) {
            None => &self.turns[interval.level],
            Some(finer) => {
                if finer == self.finer_turns.len() {
                    self.finer_turns.push(UnitVectors::new(&self.rates, interval.half / 2.0, self.fastest));
                }
                &self.finer_turns[finer]
            }
        };
        interval.state.rotate_both_ways(turns)
    }

    #[inline(always)]
    fn part(&self, part: usize, state: &UnitVectors<N>) -> Link<'_> {
        let ends = self.joints[part..part + 2].try_into().expect("a link has two ends");
        Link { ends, along: state.at(part) }
    }

    #[inline(always)]
    fn swept_box(&self, part: usize, half: f64) -> Aabb {
        let (a, b) = (self.joint_box(part, half), self.joint_box(part + 1, half));
        let lesser = |axis: usize| if a.min[axis] < b.min[axis] { a.min[axis] } else { b.min[axis] };
        let greater = |axis: usize| if a.max[axis] > b.max[axis] { a.max[axis] } else { b.max[axis] };
        let (min, max) = ([lesser(0), lesser(1)], [greater(0), greater(1)]);
        Aabb { min: min.into(), max: max.into() }.grown(self.margin)
    }

    fn depth(&self, part: usize, bounds: &Aabb) -> f64 {
        let [a, b] = [part, part + 1].map(|k| bounds.depth(self.joints[k].place()));
        a.min(b) - (self.margin - self.eta)
    }

    #[inline(always)]
    fn travel(&self, part: usize) -> f64 {
        self.travel[part]
    }

    #[inline(always)]
    fn margin(&self) -> f64 {
        self.margin
    }
}

/// A link: both its ends and the unit vector along it.
pub(in crate::collision) struct Link<'a> {
    ends: &'a [MovingPoint; 2],
    along: Vector,
}

impl Part for Link<'_> {
    #[inline(always)]
    fn corners(&self) -> impl Iterator<Item = MovingPoint> + Clone {
        self.ends.iter().copied()
    }

    #[inline(always)]
    fn directions(&self) -> usize {
        1
    }

    #[inline(always)]
    fn sides(&self) -> usize {
        1
    }

    /// The normal of the link, on the side of the polygon: the only one that can separate them.
    #[inline(always)]
    fn direction(&self, _: usize, faces: &[Face]) -> Direction {
        let left = left_of(self.along);
        let line = dot(left, self.ends[0].position);
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for face in faces {
            let side = dot(left, face.corner.coords);
            low = if side < low { side } else { low };
            high = if side > high { side } else { high };
        }
        let (n, support, ahead) =
            if low - line > line - high { (-left, -low, low - line) } else { (left, high, line - high) };
        Direction { n, support, ahead }
    }

    #[inline(always)]
    fn offset_from(&self, p: Point) -> Vector {
        let [a, b] = self.ends;
        nearest_point(p, a.place(), b.place()) - p
    }
}
