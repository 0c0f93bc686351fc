//! The proof by separating lines: per pair of a link and an obstacle, with directional bounds on travel of third order.
//!
//! **The bound.** Let p, v and -a be place, velocity and acceleration of a joint in the middle of a stretch of half-length
//! h, where a is the sum of L_j w_j^2 e_j over the links before it (e_j the unit vector along link j, w_j its absolute
//! rate). Its third derivative is at most W = sum of L_j |w_j|^3, so for every unit direction n, by Taylor's theorem,
//! n.p(t) >= n.p - h |n.v| - h^2/2 max(n.a, 0) - h^3/6 W on the whole stretch. Every point of a link is a fixed mix of its
//! two ends, so what holds for both ends holds for the link.
//!
//! **The answers.** Where that bound, less the radius, exceeds the obstacle's support in direction n by more than the slack,
//! the two are apart on the whole stretch and the pair is dropped for good. Where they touch in the middle, the motion is
//! refused. Otherwise the stretch is halved with the pairs still open. A stretch whose first-order bound is below the
//! tolerance is judged by the distance itself, so that everything the proof by distances accepts is accepted here.
//!
//! **The slack.** A test passes only where its terms sum to no more than about 2 S, S the largest coordinate plus the reach.
//! As W has no cancelling terms, L_j summing to at most S gives h |v| < 3 S and h^2 |a| / 2 < 3 S then, so that each of
//! the roughly 30 roundings costs less than 8 S times 2^-53: below 3e-14 S in all. Unit vectors are rotated once a level,
//! at most 50 times, each within 3 times 2^-53: 2e-14 S. Absolute angles are sums of up to eight joints: of circles up to
//! 26 radians, with limits up to 800, rounded to 4e-13 at worst. The slack is 1e-12 S.

use super::{Motion, Setting};
use crate::collision::Tolerance;
use crate::collision::obstacles::{Face, Solid};
use crate::geometry::{Aabb, Point, Segment, Vector};
use crate::robot::MAX_LINKS;

/// From this half-length on, directions that fail are followed by a look at the distance.
const DISTANCE_FROM: f64 = 0.125;

/// How many stretches may be open before the proof goes on depth-first.
const WIDEST: usize = 1024;

/// A link and an obstacle not yet known to be apart.
#[derive(Debug, Clone, Copy)]
struct Pair {
    link: u32,
    obstacle: u32,
}

/// In place of an obstacle's index: the bounds of the world.
const BOUNDS: u32 = u32::MAX;

/// A stretch of the motion: its middle and half its length (fractions of the motion), how often the motion was halved to
/// get it, which pairs are open on it, and the unit vectors along the links in its middle.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    middle: f64,
    half: f64,
    level: usize,
    pairs: (usize, usize),
    along: [Vector; MAX_LINKS],
}

/// What is known about a pair on a stretch.
#[derive(Clone, Copy, PartialEq)]
enum Answer {
    /// Apart on the whole stretch.
    Apart,
    /// Neither apart on the whole stretch nor touching in the middle.
    Open,
    /// Touching in the middle.
    Touching,
}

/// What one look at the middle of a stretch says.
enum Look {
    /// Every pair is apart on the whole stretch.
    Free,
    /// The pairs at the end of the list from this index on are still open.
    Open(usize),
    /// A pair touches in the middle, or is too near for the tolerance.
    Refused,
}

/// In which order stretches are looked at.
#[derive(Clone, Copy, PartialEq)]
enum Order {
    /// Any hit refuses the motion: level by level, the longest stretches first.
    MiddleFirst,
    /// The first hit is wanted: halve towards the front until the bound is below the tolerance.
    FrontFirst,
}

/// Lists that proofs use again and again, and the count of pairs evaluated.
#[derive(Debug, Clone, Default)]
pub(in crate::collision) struct Work {
    pairs: Vec<Pair>,
    stretches: Vec<Stretch>,
    /// Cosine and sine of every link's turn over a quarter of a stretch, level by level.
    turns: Vec<[Vector; MAX_LINKS]>,
    pub evaluations: u64,
}

/// Whether the motion is proven free, ends included.
pub(in crate::collision) fn is_free(setting: &Setting, motion: &Motion, work: &mut Work) -> bool {
    let mut proof = Proof::new(setting, motion, work);
    let root = proof.root();
    proof.work.stretches.push(root);
    let mut next = 0;
    while next < proof.work.stretches.len() {
        let stretch = if proof.work.stretches.len() - next > WIDEST {
            // Too many stretches are open to keep them all: from here on, the last one first. Lists behind its own belong to
            // stretches already done.
            let last = proof.work.stretches.pop().expect("some are left");
            proof.work.pairs.truncate(last.pairs.1);
            last
        } else {
            next += 1;
            proof.work.stretches[next - 1]
        };
        match proof.look(&stretch, Order::MiddleFirst) {
            Look::Free => {}
            Look::Refused => return false,
            Look::Open(first) => {
                let halves = proof.halves(&stretch, first);
                proof.work.stretches.extend(halves);
            }
        }
    }
    true
}

/// Where the first stretch begins that cannot be proven free, as a fraction of the motion; `None` where all is proven.
pub(in crate::collision) fn first_hit(setting: &Setting, motion: &Motion, work: &mut Work) -> Option<f64> {
    let mut proof = Proof::new(setting, motion, work);
    let root = proof.root();
    proof.work.stretches.push(root);
    while let Some(stretch) = proof.work.stretches.pop() {
        // Lists behind this one's belong to stretches already done.
        proof.work.pairs.truncate(stretch.pairs.1);
        match proof.look(&stretch, Order::FrontFirst) {
            Look::Free => {}
            Look::Refused => return Some(stretch.middle - stretch.half),
            Look::Open(first) => {
                let [front, back] = proof.halves(&stretch, first);
                proof.work.stretches.extend([back, front]);
            }
        }
    }
    None
}

/// One proof at work.
struct Proof<'a> {
    setting: Setting<'a>,
    motion: Motion<'a>,
    work: &'a mut Work,
    /// The absolute rate of every link, in radians over the whole motion.
    rates: [f64; MAX_LINKS],
    /// The bound on every link's travel over the whole motion, of first order.
    travel: [f64; MAX_LINKS],
    /// The bound W on every joint's third derivative.
    third: [f64; MAX_LINKS + 1],
}

/// Place, velocity and centripetal sum of every joint in the middle of a stretch, and the factors of its half-length.
struct Middle {
    place: [Point; MAX_LINKS + 1],
    velocity: [Vector; MAX_LINKS + 1],
    centripetal: [Vector; MAX_LINKS + 1],
    /// What the third derivative can add, a joint.
    third: [f64; MAX_LINKS + 1],
    /// h.
    first: f64,
    /// h^2 / 4: max(x, 0) is (x + |x|) / 2.
    second: f64,
}

impl Middle {
    /// How far joint `k` can fall behind its middle in the unit direction `n`.
    #[inline(always)]
    fn fall(&self, n: Vector, k: usize) -> f64 {
        let bend = n.dot(&self.centripetal[k]);
        self.first * n.dot(&self.velocity[k]).abs() + self.second * (bend + bend.abs()) + self.third[k]
    }

    /// Whether link `i`, whose ends are ahead by `ahead` in direction `n`, stays ahead by more than `margin`.
    #[inline(always)]
    fn stays_ahead(&self, n: Vector, i: usize, ahead: [f64; 2], margin: f64) -> bool {
        ahead[0] - self.fall(n, i) > margin && ahead[1] - self.fall(n, i + 1) > margin
    }

    /// A box that holds link `i` on the whole stretch.
    #[inline(always)]
    fn swept_box(&self, i: usize, travel: f64) -> Aabb {
        let side = |axis: usize, k: usize| {
            let (p, v, a) = (self.place[k][axis], self.velocity[k][axis], self.centripetal[k][axis]);
            let (shift, bend) = (self.first * v.abs() + self.third[k], self.second * a.abs());
            // Falling below costs the part of a that points up, rising above the part that points down.
            let low = p - (shift + bend + self.second * a);
            let high = p + (shift + bend - self.second * a);
            (if low > p - travel { low } else { p - travel }, if high < p + travel { high } else { p + travel })
        };
        let [x, y] = [0, 1].map(|axis| {
            let (one, other) = (side(axis, i), side(axis, i + 1));
            (if one.0 < other.0 { one.0 } else { other.0 }, if one.1 > other.1 { one.1 } else { other.1 })
        });
        Aabb { min: Point::new(x.0, y.0), max: Point::new(x.1, y.1) }
    }
}

impl<'a> Proof<'a> {
    fn new(setting: &Setting<'a>, motion: &Motion<'a>, work: &'a mut Work) -> Self {
        work.pairs.clear();
        work.stretches.clear();
        work.turns.clear();
        let (mut rates, mut third) = ([0.0; MAX_LINKS], [0.0; MAX_LINKS + 1]);
        let mut rate = 0.0;
        for (i, &length) in setting.arm.links().iter().enumerate() {
            rate += motion.delta[i];
            rates[i] = rate;
            third[i + 1] = third[i] + length * f64::abs(rate) * rate * rate;
        }
        Self { setting: *setting, motion: *motion, work, rates, travel: setting.arm.travel(motion.delta), third }
    }

    /// The whole motion.
    fn root(&self) -> Stretch {
        let mut along = [Vector::zeros(); MAX_LINKS];
        let mut angle = 0.0;
        for (i, along) in along.iter_mut().enumerate().take(self.links()) {
            angle += self.motion.from[i] + 0.5 * self.motion.delta[i];
            let (sin, cos) = libm::sincos(angle);
            *along = Vector::new(cos, sin);
        }
        Stretch { middle: 0.5, half: 0.5, level: 0, pairs: (0, 0), along }
    }

    fn links(&self) -> usize {
        self.setting.arm.links().len()
    }

    /// The two halves of a stretch, with the pairs from `first` on open: front, then back.
    fn halves(&mut self, stretch: &Stretch, first: usize) -> [Stretch; 2] {
        let half = stretch.half / 2.0;
        if self.work.turns.len() == stretch.level {
            let mut turns = [Vector::zeros(); MAX_LINKS];
            for (turn, rate) in turns.iter_mut().zip(self.rates).take(self.links()) {
                let (sin, cos) = libm::sincos(rate * half);
                *turn = Vector::new(cos, sin);
            }
            self.work.turns.push(turns);
        }
        let turns = &self.work.turns[stretch.level];
        let pairs = (first, self.work.pairs.len());
        let child = Stretch { half, level: stretch.level + 1, pairs, ..*stretch };
        let (mut front, mut back) = (child, child);
        front.middle -= half;
        back.middle += half;
        for (i, (e, r)) in stretch.along.iter().zip(turns).enumerate().take(self.links()) {
            let (xx, yy, xy, yx) = (e.x * r.x, e.y * r.y, e.x * r.y, e.y * r.x);
            front.along[i] = Vector::new(xx + yy, yx - xy);
            back.along[i] = Vector::new(xx - yy, yx + xy);
        }
        [front, back]
    }

    /// Joints in the middle of the stretch.
    fn middle(&self, stretch: &Stretch) -> Middle {
        let h = stretch.half;
        let base = self.setting.arm.base();
        let mut middle = Middle {
            place: [base; MAX_LINKS + 1],
            velocity: [Vector::zeros(); MAX_LINKS + 1],
            centripetal: [Vector::zeros(); MAX_LINKS + 1],
            third: [0.0; MAX_LINKS + 1],
            first: h,
            second: h * h / 4.0,
        };
        let sixth = h * h * h / 6.0;
        for (i, &length) in self.setting.arm.links().iter().enumerate() {
            let reach = stretch.along[i] * length;
            let swing = reach * self.rates[i];
            middle.place[i + 1] = middle.place[i] + reach;
            middle.velocity[i + 1] = middle.velocity[i] + Vector::new(-swing.y, swing.x);
            middle.centripetal[i + 1] = middle.centripetal[i] + swing * self.rates[i];
            middle.third[i + 1] = sixth * self.third[i + 1];
        }
        middle
    }

    /// Looks at the middle of the stretch; pairs still open are listed again at the end of the list.
    fn look(&mut self, stretch: &Stretch, order: Order) -> Look {
        let first = self.work.pairs.len();
        let middle = self.middle(stretch);
        let refused = if stretch.level == 0 {
            (0..self.links()).any(|link| self.look_at_all(stretch, &middle, link, order))
        } else {
            self.look_at_open(stretch, &middle, order)
        };
        match (refused, self.work.pairs.len() == first) {
            (true, _) => Look::Refused,
            (false, true) => Look::Free,
            (false, false) => Look::Open(first),
        }
    }

    /// Looks at a link and everything near its swept box; answers whether the stretch is refused.
    fn look_at_all(&mut self, stretch: &Stretch, middle: &Middle, link: usize, order: Order) -> bool {
        let margin = self.setting.arm.radius() + self.setting.tolerance.eta;
        let swept = middle.swept_box(link, self.travel[link] * stretch.half).grown(margin);
        let obstacles = self.setting.obstacles;
        let mut refused = false;
        obstacles.candidates(&swept, |obstacle| {
            let pair = Pair { link: link as u32, obstacle: obstacle as u32 };
            refused = refused || self.keep(stretch, middle, pair, &swept, order);
        });
        refused
            || (self.setting.bounds.is_some()
                && self.keep(stretch, middle, Pair { link: link as u32, obstacle: BOUNDS }, &swept, order))
    }

    /// Looks at the pairs still open; answers whether the stretch is refused.
    fn look_at_open(&mut self, stretch: &Stretch, middle: &Middle, order: Order) -> bool {
        let margin = self.setting.arm.radius() + self.setting.tolerance.eta;
        let (mut link, mut swept) = (u32::MAX, Aabb { min: Point::origin(), max: Point::origin() });
        for at in stretch.pairs.0..stretch.pairs.1 {
            let pair = self.work.pairs[at];
            if pair.link != link {
                link = pair.link;
                swept = middle.swept_box(link as usize, self.travel[link as usize] * stretch.half).grown(margin);
            }
            if pair.obstacle != BOUNDS && !self.setting.obstacles.aabb(pair.obstacle as usize).intersects(&swept) {
                continue;
            }
            if self.keep(stretch, middle, pair, &swept, order) {
                return true;
            }
        }
        false
    }

    /// Evaluates a pair and lists it again where it is still open; answers whether it refuses the stretch.
    fn keep(&mut self, stretch: &Stretch, middle: &Middle, pair: Pair, swept: &Aabb, order: Order) -> bool {
        let link = pair.link as usize;
        let bound = self.travel[link] * stretch.half;
        let answer = if pair.obstacle == BOUNDS {
            self.within_bounds(middle, link, bound, swept)
        } else {
            self.work.evaluations += 1;
            self.separate(stretch, middle, link, pair.obstacle as usize, bound)
        };
        if answer == Answer::Apart {
            return false;
        }
        let Tolerance { tau, bounds_tau, .. } = self.setting.tolerance;
        let finest = if pair.obstacle == BOUNDS { bounds_tau } else { tau };
        if bound < finest || (answer == Answer::Touching && order == Order::MiddleFirst) {
            return true;
        }
        self.work.pairs.push(pair);
        false
    }

    /// Whether the link stays within the bounds of the world, contact allowed.
    fn within_bounds(&self, middle: &Middle, link: usize, bound: f64, swept: &Aabb) -> Answer {
        let bounds = self.setting.bounds.expect("a pair with the bounds exists only where there are bounds");
        let (eta, radius) = (self.setting.tolerance.eta, self.setting.arm.radius());
        // The swept box already holds the radius and one slack; contact may exceed the bounds by one.
        let roomy = bounds.grown(2.0 * eta);
        let depth = bounds.depth(middle.place[link]).min(bounds.depth(middle.place[link + 1])) - radius;
        if (roomy.contains(swept.min) && roomy.contains(swept.max)) || depth - bound >= -eta {
            Answer::Apart
        } else if depth < -eta {
            Answer::Touching
        } else {
            Answer::Open
        }
    }

    /// Whether link and obstacle are apart on the whole stretch.
    fn separate(&self, stretch: &Stretch, middle: &Middle, link: usize, obstacle: usize, bound: f64) -> Answer {
        let margin = self.setting.arm.radius() + self.setting.tolerance.eta;
        let is_touching = match self.setting.obstacles.solid(obstacle) {
            Solid::Convex(faces) => match separate_from_polygon(faces, stretch.along[link], middle, link, margin) {
                Answer::Apart => return Answer::Apart,
                answer => answer == Answer::Touching,
            },
            Solid::Disc(disc) => {
                let (a, b) = (middle.place[link], middle.place[link + 1]);
                let to = nearest_point(disc.center, a, b) - disc.center;
                let distance = to.norm();
                if distance > 0.0 {
                    let n = to / distance;
                    let ahead = [a, b].map(|end| n.dot(&(end - disc.center)) - disc.radius);
                    if middle.stays_ahead(n, link, ahead, margin) {
                        return Answer::Apart;
                    }
                }
                true
            }
            Solid::Concave => true,
        };
        if !is_touching && stretch.half > DISTANCE_FROM && bound >= self.setting.tolerance.tau {
            return Answer::Open;
        }
        let axis = Segment::new(middle.place[link], middle.place[link + 1]);
        let clearance = self.setting.obstacles.distance(obstacle, &axis) - self.setting.arm.radius();
        if clearance - bound > self.setting.tolerance.eta {
            Answer::Apart
        } else if clearance <= self.setting.tolerance.eta {
            Answer::Touching
        } else {
            Answer::Open
        }
    }
}

/// Tries the outward normals of the polygon's faces and the normal of the link as directions. `Touching` here means only
/// that none of them separates the two in the middle.
#[inline]
fn separate_from_polygon(faces: &[Face], along: Vector, middle: &Middle, link: usize, margin: f64) -> Answer {
    let (a, b) = (middle.place[link], middle.place[link + 1]);
    let mut is_touching = true;
    for face in faces {
        let n = face.normal;
        let ahead = [n.dot(&a.coords) - face.support, n.dot(&b.coords) - face.support];
        if ahead[0] > margin && ahead[1] > margin {
            is_touching = false;
            if middle.stays_ahead(n, link, ahead, margin) {
                return Answer::Apart;
            }
        }
    }
    let across = Vector::new(-along.y, along.x);
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for face in faces {
        let side = across.dot(&(face.corner - a));
        if side < low {
            low = side;
        }
        if side > high {
            high = side;
        }
    }
    let (n, ahead) = if low > 0.0 { (-across, low) } else { (across, -high) };
    if ahead > margin {
        is_touching = false;
        if middle.stays_ahead(n, link, [ahead, ahead], margin) {
            return Answer::Apart;
        }
    }
    if is_touching { Answer::Touching } else { Answer::Open }
}

/// The point of the segment from `a` to `b` nearest to `p`.
fn nearest_point(p: Point, a: Point, b: Point) -> Point {
    let along = b - a;
    let t = (p - a).dot(&along) / along.norm_squared();
    if t >= 1.0 {
        b
    } else if t > 0.0 {
        a + along * t
    } else {
        a
    }
}
