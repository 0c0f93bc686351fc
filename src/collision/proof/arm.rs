//! A moving arm, for the driver of the proof: every joint turns or slides at a constant rate.
//!
//! **Bounds.** The outer end of link i is the sum of L_j e_j over the links j up to it, e_j the unit vector along link j.
//! With w_j the absolute rate of link j, its acceleration is minus the sum of L_j w_j^2 e_j, and W = sum of L_j |w_j|^3
//! bounds its third derivative (see `moving_point.rs`). Its bound of first order is the sum of L_j |w_j|, about half of
//! the textbook's sum of reaches.
//!
//! **Prismatic joints.** A link that grows at the constant rate d_j has the length L_j = l_j + t d_j, t in [0, 1] along the
//! motion. With J the rotation by a right angle, the derivatives of L_j e_j are
//!
//! d_j e_j + L_j w_j J e_j,   2 d_j w_j J e_j - L_j w_j^2 e_j,   -3 d_j w_j^2 e_j - L_j w_j^3 J e_j,
//!
//! so the bound of first order is the sum of M_j |w_j| + |d_j|, and W that of M_j |w_j|^3 + 3 |d_j| w_j^2, M_j the greater of
//! the link's lengths at both ends of the motion. A point at a fixed fraction of a link remains a fixed convex combination of its
//! ends.
//!
//! **Slack.** S is the largest coordinate plus the reach; the slack is 1e-12 S. A test passes only if its terms sum to no more
//! than about 2 S. As W has no cancelling terms and the L_j sum to at most S, then h |v| < 3 S and h^2 |a| / 2 < 3 S, so that
//! each of the roughly 30 roundings costs less than 8 S times 2^-53: below 3e-14 S in all. Links that grow add some 10 roundings,
//! less than S / 4 to the first, and by the inequality of Cauchy and Schwarz less than S to the second.
//!
//! Unit vectors are products of `rotation.rs`'s: the absolute angle at the start, off by 1.4e-14 at most; half the turn by
//! 2.8e-14; a quarter, an eighth and so on by half as much each, 2.8e-14 together; and a product a level, at most 50, by 3 times
//! 2^-53 each: 9e-14 in all, and so much times S. Links that turn by more than 12.8 radians are not squared up but reduced level
//! by level, each off by 1.4e-14, until they are small: of eight circles one level, with the widest limits nine, 1.3e-13 more.
//! Absolute angles and rates are sums of up to eight joints: of circles up to 26 radians; with limits up to 50, sums up to 800
//! and differences up to 100, rounded to 5e-13 in all at worst, fixed angles like limits. If limits are wider, up to twice that,
//! the slack is doubled.

use super::driver::{Interval, Moving};
use super::moving_point::{Halves, MovingPoint, Plane, around};
use super::pair::{Direction, Part, nearest_point};
use super::rotation::{SMALL, doubled, series, unit};
use crate::collision::obstacles::Face;
use crate::geometry::{Aabb, Point, Vector};
use crate::robot::{Arm, Joint, MAX_LINKS};
use crate::space::Lanes;

/// Turns over this many halvings are found together, by squaring the smallest.
const SQUARED: usize = 4;

/// The fastest rate, in radians over the motion, whose thirty-second is small enough to be squared up.
const FASTEST_SQUARED: f64 = 12.8;

/// Where a link turns by more radians than this over half an interval, its bound of first order and its reach may be the
/// better ones.
const FAST: f64 = 1.5;

/// The unit vectors of `N` angles, by columns.
#[derive(Debug, Clone, Copy)]
pub(in crate::collision) struct UnitVectors<const N: usize> {
    x: [f64; N],
    y: [f64; N],
}

impl<const N: usize> UnitVectors<N> {
    /// Of no angle: all point along x.
    const ZERO: Self = Self { x: [1.0; N], y: [0.0; N] };

    /// Of angles given two at a time; of no more than the first `count`, rounded up.
    #[inline(always)]
    fn new(count: usize, of: impl Fn(usize) -> Plane<Halves>) -> Self {
        let mut units = Self::ZERO;
        let mut i = 0;
        while i < count {
            let e = of(i);
            let end = if N.is_multiple_of(2) { i + 2 } else { N.min(i + 2) };
            units.x[i..end].copy_from_slice(&e.x.to_array()[..end - i]);
            units.y[i..end].copy_from_slice(&e.y.to_array()[..end - i]);
            i += 2;
        }
        units
    }

    /// That of angle i, for both halves.
    #[inline(always)]
    fn of_both(&self, i: usize) -> Plane<Halves> {
        Plane { x: Halves::splat(self.x[i]), y: Halves::splat(self.y[i]) }
    }

    /// Those of angles i and i + 1.
    #[inline(always)]
    fn two(&self, i: usize) -> Plane<Halves> {
        Plane { x: two(&self.x, i), y: two(&self.y, i) }
    }
}

/// Numbers i and i + 1; the last twice if there is no other.
#[inline(always)]
fn two<const N: usize>(numbers: &[f64; N], i: usize) -> Halves {
    Halves::new([numbers[i], numbers[if N.is_multiple_of(2) { i + 1 } else { (i + 1).min(N - 1) }]])
}

/// The prismatic joints of an arm, and how its links grow on a motion.
struct Slides<const N: usize> {
    joints: [Joint; N],
    /// The lengths of the links at the coordinate 0; at the start of the motion; and what they grow over all of it.
    given: [f64; N],
    lengths: [f64; N],
    growth: [f64; N],
}

/// An arm of up to `N` links, and its motion.
pub(in crate::collision) struct MovingArm<const N: usize> {
    base: Point,
    links: usize,
    /// Of every link the length; of one that grows, the greatest on the motion.
    lengths: [f64; N],
    eta: f64,
    /// The radius and the slack.
    margin: f64,
    /// The configuration last begun from, and its unit vectors: roadmaps try many motions from one.
    from: [f64; N],
    from_along: UnitVectors<N>,
    /// `None` if no joint is prismatic.
    slides: Option<Box<Slides<N>>>,
    /// Of every link: its absolute rate, in radians over the whole motion, its bound of first order, and W of its outer end.
    rates: [f64; N],
    travel: [f64; N],
    third: [f64; N],
    /// The largest absolute rate of all links.
    fastest: f64,
    /// The turn of every link over a quarter of the motion, an eighth, and so on.
    turns: [UnitVectors<N>; SQUARED],
    finer_turns: Vec<UnitVectors<N>>,
    /// In the middles of both halves of the interval under test: the joints, and the unit vectors along the links. Half the
    /// length of a half.
    joints: [MovingPoint; MAX_LINKS + 1],
    along: [Plane<Halves>; N],
    half: f64,
}

impl<const N: usize> MovingArm<N> {
    /// The arm, with this slack.
    pub fn new(arm: &Arm, eta: f64) -> Self {
        let mut lengths = [0.0; N];
        lengths[..arm.links().len()].copy_from_slice(arm.links());
        let slides = arm.has_prismatic_joint().then(|| {
            let mut joints = [Joint::CIRCLE; N];
            joints[..arm.links().len()].copy_from_slice(arm.joint_types());
            Box::new(Slides { joints, given: lengths, lengths, growth: [0.0; N] })
        });
        Self {
            base: arm.base(),
            links: arm.links().len(),
            lengths,
            eta,
            margin: arm.kept_radius() + eta,
            from: [f64::NAN; N],
            from_along: UnitVectors::ZERO,
            slides,
            rates: [0.0; N],
            travel: [0.0; N],
            third: [0.0; N],
            fastest: 0.0,
            turns: [UnitVectors::ZERO; SQUARED],
            finer_turns: Vec::new(),
            joints: [MovingPoint::at_rest(Plane::splat(arm.base().coords)); MAX_LINKS + 1],
            along: [Plane::ZERO; N],
            half: 0.0,
        }
    }

    /// Gives the links another radius.
    pub fn set_radius(&mut self, radius: f64) {
        self.margin = radius + self.eta;
    }

    /// Begins a motion in which joint i turns by `delta[i]` radians, or slides by as many metres; entries past the arm's links
    /// are 0. Returns the unit vectors along the links in its middle.
    #[inline(always)]
    pub fn begin(&mut self, from: &[f64; N], delta: &[f64; N]) -> UnitVectors<N> {
        self.finer_turns.clear();
        if self.from != *from {
            self.from = *from;
            self.from_along = self.directions(from);
        }
        if self.slides.is_some() {
            self.begin_sliding(from, delta);
        } else {
            let (mut rate, mut travel, mut third, mut fastest) = (0.0, 0.0, 0.0, 0.0);
            for (i, &turn) in delta.iter().enumerate().take(self.links) {
                rate += turn;
                let spin = f64::abs(rate);
                let speed = self.lengths[i] * spin;
                travel += speed;
                third += speed * rate * rate;
                fastest = spin.greater(fastest);
                (self.rates[i], self.travel[i], self.third[i]) = (rate, travel, third);
            }
            self.fastest = fastest;
        }
        let half_turn = if self.fastest <= FASTEST_SQUARED {
            let mut turns = self.turned(1.0 / 32.0);
            for level in (0..SQUARED).rev() {
                self.turns[level] = turns;
                turns = UnitVectors::new(self.links, |i| doubled(turns.two(i)));
            }
            turns
        } else {
            let mut part = 0.25;
            for level in 0..SQUARED {
                self.turns[level] = self.turned(part);
                part *= 0.5;
            }
            self.turned(0.5)
        };
        UnitVectors::new(self.links, |i| self.from_along.two(i).rotated(half_turn.two(i)))
    }

    /// The rates and bounds of a motion of an arm with a prismatic joint.
    #[cold]
    fn begin_sliding(&mut self, from: &[f64; N], delta: &[f64; N]) {
        let slides = self.slides.as_mut().expect("the arm has a prismatic joint");
        let (mut rate, mut travel, mut third, mut fastest) = (0.0, 0.0, 0.0, 0.0);
        for i in 0..self.links {
            let joint = slides.joints[i];
            let growth = joint.extension(delta[i]);
            rate += if joint.is_prismatic() { 0.0 } else { delta[i] };
            let length = slides.given[i] + joint.extension(from[i]);
            (slides.lengths[i], slides.growth[i]) = (length, growth);
            self.lengths[i] = length.max(length + growth);
            let spin = f64::abs(rate);
            travel += self.lengths[i] * spin + growth.abs();
            third += (self.lengths[i] * spin + 3.0 * growth.abs()) * rate * rate;
            fastest = spin.max(fastest);
            (self.rates[i], self.travel[i], self.third[i]) = (rate, travel, third);
        }
        self.fastest = fastest;
    }

    /// Places the joints of an arm with a prismatic joint on the halves of an interval, half the length of a half being `h`; the
    /// unit vectors along the links are known.
    #[cold]
    fn place_sliding(&mut self, middle: f64, h: f64, parts: usize) {
        let Some(slides) = &self.slides else { return };
        let (times, sixth) = (Halves::new([middle - h, middle + h]), h * h * h / 6.0);
        let (mut position, mut velocity, mut acceleration) = (self.joints[0].position, Plane::ZERO, Plane::ZERO);
        for i in 0..parts {
            let (along, growth) = (self.along[i], Halves::splat(h * slides.growth[i]));
            let length = Halves::splat(slides.lengths[i]) + Halves::splat(slides.growth[i]) * times;
            let (link, rate) = (along * length, Halves::splat(h * self.rates[i]));
            let swing = link * rate;
            position = position + link;
            velocity = velocity + swing.left() + along * growth;
            let quarter = Halves::splat(0.25) * rate;
            acceleration = acceleration + swing * quarter - along.left() * (growth * (quarter + quarter));
            let remainder = sixth * self.third[i];
            self.joints[i + 1] = MovingPoint { position, velocity, acceleration, remainder };
        }
    }

    /// The turn of every link over a part of the motion.
    #[inline(always)]
    fn turned(&self, part: f64) -> UnitVectors<N> {
        let factor = Halves::splat(part);
        if self.fastest * part <= SMALL {
            UnitVectors::new(self.links, |i| series(two(&self.rates, i) * factor))
        } else {
            UnitVectors::new(self.links, |i| unit(two(&self.rates, i) * factor))
        }
    }

    /// The unit vectors along the links.
    #[inline(always)]
    fn directions(&self, q: &[f64; N]) -> UnitVectors<N> {
        let (mut angles, mut angle) = ([0.0; N], 0.0);
        for i in 0..self.links {
            angle += self.slides.as_ref().map_or(q[i], |slides| slides.joints[i].angle(q[i]));
            angles[i] = angle;
        }
        UnitVectors::new(self.links, |i| unit(two(&angles, i)))
    }

    /// Places the arm at rest.
    #[inline(always)]
    pub fn rest(&mut self, q: &[f64; N]) {
        if self.slides.is_some() {
            self.begin_sliding(q, &[0.0; N]);
        }
        let along = self.directions(q);
        (self.half, self.fastest) = (0.0, 0.0);
        for i in 0..self.links {
            self.along[i] = along.of_both(i);
            let link = self.along[i] * Halves::splat(self.lengths[i]);
            self.joints[i + 1] = MovingPoint::at_rest(self.joints[i].position + link);
        }
    }

    /// The part of a link's box within reach of where its ends are, and of the base.
    #[cold]
    fn restricted(&self, swept: Aabb, part: usize) -> Aabb {
        let around =
            |center: Point, by: f64| Aabb { min: center - Vector::new(by, by), max: center + Vector::new(by, by) };
        let reached = |joint: usize, half: usize| {
            let Some(link) = joint.checked_sub(1) else { return around(self.base, 0.0) };
            let travel = around(self.joints[joint].place(half), self.travel[link] * self.half);
            let reach = around(self.base, self.lengths[..joint].iter().sum::<f64>() + self.eta);
            Aabb { min: travel.min.sup(&reach.min), max: travel.max.inf(&reach.max) }
        };
        let ends = [(part, 0), (part, 1), (part + 1, 0), (part + 1, 1)].map(|(joint, half)| reached(joint, half));
        let reached = ends[0].union(&ends[1]).union(&ends[2]).union(&ends[3]);
        Aabb { min: swept.min.sup(&reached.min), max: swept.max.inf(&reached.max) }
    }
}

impl<const N: usize> Moving for MovingArm<N> {
    /// The unit vectors along the links.
    type State = UnitVectors<N>;
    type Part<'a> = Link<'a>;

    #[inline(always)]
    fn parts(&self) -> usize {
        self.links
    }

    #[inline(always)]
    fn place(&mut self, interval: &Interval, state: &UnitVectors<N>, parts: usize) {
        let h = 0.5 * interval.half;
        let turns = match interval.level.checked_sub(SQUARED) {
            None => &self.turns[interval.level],
            Some(finer) => {
                if finer == self.finer_turns.len() {
                    self.finer_turns.push(self.turned(h));
                }
                &self.finer_turns[finer]
            }
        };
        self.half = h;
        if self.slides.is_some() {
            for i in 0..parts {
                let turn = Plane { x: Halves::splat(turns.x[i]), y: Halves::new([-turns.y[i], turns.y[i]]) };
                self.along[i] = state.of_both(i).rotated(turn);
            }
            return self.place_sliding(interval.middle, h, parts);
        }
        let sixth = h * h * h / 6.0;
        // The base does not move.
        let (mut position, mut velocity, mut acceleration) = (self.joints[0].position, Plane::ZERO, Plane::ZERO);
        for i in 0..parts {
            // The front half is behind the middle of the interval, the other before it.
            let turn = Plane { x: Halves::splat(turns.x[i]), y: Halves::new([-turns.y[i], turns.y[i]]) };
            self.along[i] = state.of_both(i).rotated(turn);
            let link = self.along[i] * Halves::splat(self.lengths[i]);
            let rate = h * self.rates[i];
            let swing = link * Halves::splat(rate);
            position = position + link;
            velocity = velocity + swing.left();
            acceleration = acceleration + swing * Halves::splat(0.25 * rate);
            let remainder = sixth * self.third[i];
            self.joints[i + 1] = MovingPoint { position, velocity, acceleration, remainder };
        }
    }

    #[inline(always)]
    fn state(&self, half: usize) -> UnitVectors<N> {
        let mut units = UnitVectors::ZERO;
        for (i, along) in self.along.iter().enumerate().take(self.links) {
            (units.x[i], units.y[i]) = (along.x.to_array()[half], along.y.to_array()[half]);
        }
        units
    }

    #[inline(always)]
    fn part(&self, part: usize) -> Link<'_> {
        let ends = self.joints[part..part + 2].try_into().expect("a link has two ends");
        Link { ends, along: self.along[part] }
    }

    #[inline(always)]
    fn swept_box(&self, part: usize) -> Aabb {
        let swept = around(self.part(part).swept_boxes());
        let swept = if self.fastest * self.half > FAST { self.restricted(swept, part) } else { swept };
        swept.grown(self.margin)
    }

    fn depth(&self, part: usize, half: usize, bounds: &Aabb) -> f64 {
        let [a, b] = [part, part + 1].map(|joint| bounds.depth(self.joints[joint].place(half)));
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
    along: Plane<Halves>,
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
        let left = self.along.left();
        let line = left.dot(self.ends[0].position);
        let (mut low, mut high) = (Halves::splat(f64::INFINITY), Halves::splat(f64::NEG_INFINITY));
        for face in faces {
            let side = left.dot(Plane::splat(face.corner.coords));
            (low, high) = (low.lesser(side), high.greater(side));
        }
        let (before, behind) = (low - line, line - high);
        let is_before = before.simd_gt(behind);
        let sign = is_before.bitselect(Halves::splat(-1.0), Halves::splat(1.0));
        Direction { n: left * sign, support: is_before.bitselect(low, high) * sign, ahead: before.greater(behind) }
    }

    #[inline(always)]
    fn offsets_from(&self, p: Point) -> Plane<Halves> {
        let [a, b] = self.ends;
        let (link, to) = (b.position - a.position, Plane::splat(p.coords) - a.position);
        // How far along the link, from its start.
        let length = self.along.dot(link);
        let at = self.along.dot(to).greater(Halves::splat(0.0)).lesser(length);
        self.along * at - to
    }

    #[inline(always)]
    fn offset_from(&self, half: usize, p: Point) -> Vector {
        let [a, b] = self.ends;
        nearest_point(p, a.place(half), b.place(half)) - p
    }
}
