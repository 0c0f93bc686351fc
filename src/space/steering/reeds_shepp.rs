//! The shortest curve of a car that drives forwards and in reverse.
//!
//! Reeds and Shepp 1990, "Optimal paths for a car that goes both forwards and backwards": it is one of 48 words of up to
//! five segments. With C an arc, S a straight line and | a change of gear they are the words CSC; C|C|C, C|CC and CC|C;
//! CCu|CuC and C|CuCu|C with two arcs alike; C|CqSC and CSCq|C with a quarter of a turn, and C|CqSCq|C.
//!
//! Here gears are not distinguished: a word consists of left, right and straight, and its signed lengths solve for the
//! goal whatever their signs. Of angles that differ by a whole turn the shorter is driven, which is never longer than the
//! word that the paper has; so a few equations cover all its words, and any other words that they cover lead to the goal too.
//!
//! # The equations
//! Points are complex numbers, e(h) the heading h, n(h) = e(h - pi/2) the vector from a left circle's centre to a car on it. From
//! the centre of the circle left of the start to that left (right) of the goal the vector is, for arcs t, u, v and a line s,
//! - LSL: s e(t); LSR: (s - 2i) e(t);
//! - LRL: 2 n(t) - 2 n(t - u) = 4 sin(u/2) e(t - u/2);
//! - LRLR with arcs t, u, -u: 2 (2 cos u - 1) n(t - u), and with t, u, u: 2 (2 - e(-u)) n(t);
//! - LRSL, the right arc a quarter q = +-pi/2, then at heading h = t - q: (s +- 2 + 2i) e(h); LRSR: (s +- 2) e(h);
//! - LSRL, the right arc q: (s +- 2 - 2i) e(t); LSLR, the left arc after the line q: (s +- 2) e(t);
//! - LRSLR, both quarters q, at heading h: (s +- 4 + 2i) e(h).

use super::goal::{Goal, Shortest, Unit, short_words, shorter};
use super::{Curve, Pose, Turn};
use std::cmp::Ordering;
use std::f64::consts::PI;

/// A quarter of a turn.
const QUARTER: f64 = 0.5 * PI;

/// The shortest curve from one pose to another for a car that turns no tighter than `radius` metres, greater than 0, and may
/// reverse anywhere. The curve back is the same, reversed, to the bit. O(1).
pub fn reeds_shepp(from: Pose, to: Pose, radius: f64) -> Curve {
    within(from, to, radius, f64::INFINITY).expect("some word leads to every pose")
}

/// The same if it is no longer than `most` metres; else `None`, or a curve that is longer than `most` too.
pub(super) fn within(from: Pose, to: Pose, radius: f64, most: f64) -> Option<Curve> {
    let order = from.x.total_cmp(&to.x).then(from.y.total_cmp(&to.y)).then(from.heading.total_cmp(&to.heading));
    if order == Ordering::Greater {
        Some(find(to, from, radius, most)?.reversed())
    } else {
        find(from, to, radius, most)
    }
}

fn find(from: Pose, to: Pose, radius: f64, most: f64) -> Option<Curve> {
    let goal = Goal::new(from, to, radius);
    let found = Shortest::find(&goal, radius, most, |sides, shortest| {
        short_words(sides, |goal, word| offer(goal, shortest, word));
        for family in [straight, arcs, equal_arcs, quarters] {
            sides.iter().for_each(|goal| family(goal, shortest));
        }
    });
    if found.is_some() || most < f64::INFINITY {
        return found;
    }
    // Rounding drops none of the words that always exist unless numbers overflow.
    let (angle, line) = (goal.left.angle(), goal.left.length);
    let word = [(Turn::Left, angle), (Turn::Straight, line), (Turn::Left, shorter(goal.heading - angle))];
    Some(Curve::new(1.0, &word).scaled(radius))
}

/// Offers a word that begins to the left, or to the right in the mirror; angles by the shorter way. Words that do not exist
/// have lengths that are not numbers.
fn offer<'a, const K: usize>(goal: &'a Goal, shortest: &mut Shortest<'a>, mut word: [(Turn, f64); K]) {
    for (turn, length) in &mut word {
        if *turn != Turn::Straight {
            *length = shorter(*length);
        }
    }
    shortest.offer(goal, &word);
}

/// CSC.
fn straight<'a>(goal: &'a Goal, shortest: &mut Shortest<'a>) {
    use Turn::{Left, Right, Straight};
    let Goal { heading, facing, left, right, .. } = goal;
    let (t, v) = (left.direction, facing.minus(left.direction));
    if shortest.wants(left.length + t.least() + v.least()) {
        let t = left.angle();
        offer(goal, shortest, [(Left, t), (Straight, left.length), (Left, heading - t)]);
    }
    if shortest.wants(left.length + t.opposite().least() + v.opposite().least()) {
        let t = left.angle() + PI;
        offer(goal, shortest, [(Left, t), (Straight, -left.length), (Left, heading - t)]);
    }
    let inner = right.inner();
    for s in [inner, -inner] {
        let t = right.direction.plus(Unit { cos: s, sin: 2.0 }.scaled(1.0 / right.length));
        if inner >= 0.0 && shortest.wants(inner + t.least() + t.minus(*facing).least()) {
            let t = right.angle() + libm::atan2(2.0, s);
            offer(goal, shortest, [(Left, t), (Straight, s), (Right, t - heading)]);
        }
    }
}

/// C|C|C, C|CC and CC|C.
fn arcs<'a>(goal: &'a Goal, shortest: &mut Shortest<'a>) {
    use Turn::{Left, Right};
    let Goal { heading, facing, left, .. } = goal;
    if left.length > 4.0 {
        return;
    }
    let sin = 0.25 * left.length;
    let half = Unit { cos: (1.0 - sin * sin).sqrt(), sin };
    let (t, v, u) = (left.direction.plus(half), facing.minus(left.direction).plus(half), 2.0 * half.least());
    if shortest.wants(u + t.least() + v.least()) {
        let half = libm::asin(sin);
        let (t, u) = (left.angle() + half, 2.0 * half);
        offer(goal, shortest, [(Left, t), (Right, u), (Left, heading - t + u)]);
    }
    let (t, v) = (left.direction.minus(half).opposite(), facing.minus(left.direction).minus(half).opposite());
    if shortest.wants(u + t.least() + v.least()) {
        let half = libm::asin(sin);
        let (t, u) = (left.angle() + PI - half, -2.0 * half);
        offer(goal, shortest, [(Left, t), (Right, u), (Left, heading - t + u)]);
    }
}

/// CCu|CuC and C|CuCu|C.
fn equal_arcs<'a>(goal: &'a Goal, shortest: &mut Shortest<'a>) {
    use Turn::{Left, Right};
    let Goal { heading, facing, right, .. } = goal;
    if right.length > 6.0 {
        return;
    }
    let across = right.direction.next_quarter();
    for (cos, quarter) in [(0.25 * (2.0 + right.length), QUARTER), (0.25 * (2.0 - right.length), -QUARTER)] {
        let u = Unit { cos, sin: (1.0 - cos * cos).sqrt() };
        let both = 2.0 * u.least();
        // No angle has a cosine above 1.
        if cos <= 1.0 && shortest.wants(both) {
            let middle = if quarter > 0.0 { across } else { across.opposite() };
            let (more, less) = (middle.plus(u), middle.minus(u));
            for (sign, t, rest) in [(1.0, more, less), (-1.0, less, more)] {
                if shortest.wants(both + t.least() + rest.minus(*facing).least()) {
                    let u = sign * libm::acos(cos);
                    let t = right.angle() + quarter + u;
                    offer(goal, shortest, [(Left, t), (Right, u), (Left, -u), (Right, t - 2.0 * u - heading)]);
                }
            }
        }
    }
    let cos = 1.25 - 0.0625 * right.length * right.length;
    let u = Unit { cos, sin: (1.0 - cos * cos).sqrt() };
    let both = 2.0 * u.least();
    if cos <= 1.0 && shortest.wants(both) {
        let aside = Unit { cos: 2.0 - cos, sin: u.sin }.scaled(2.0 / right.length);
        for (sign, t) in [(1.0, across.minus(aside)), (-1.0, across.plus(aside))] {
            if shortest.wants(both + t.least() + t.minus(*facing).least()) {
                let u = libm::acos(cos);
                let aside = libm::atan2(libm::sin(u), 2.0 - cos);
                let (u, aside) = (sign * u, sign * aside);
                let t = right.angle() + QUARTER - aside;
                offer(goal, shortest, [(Left, t), (Right, u), (Left, u), (Right, t - heading)]);
            }
        }
    }
}

/// C|CqSC, CSCq|C and C|CqSCq|C. A line that goes against the quarter before it is never part of a shortest curve.
fn quarters<'a>(goal: &'a Goal, shortest: &mut Shortest<'a>) {
    use Turn::{Left, Right, Straight};
    let Goal { heading, facing, left, right, .. } = goal;
    for sign in [1.0, -1.0] {
        let q = sign * QUARTER;
        // An angle and a quarter of that sign more.
        let turned = |unit: Unit| unit.next_quarter().scaled(sign);
        let inner = left.inner();
        if inner >= 2.0 && shortest.wants(inner - 2.0 + QUARTER) {
            let s = sign * (inner - 2.0);
            let aside = Unit { cos: sign * inner, sin: 2.0 }.scaled(1.0 / left.length);
            let (h, t) = (left.direction.minus(aside), left.direction.plus(aside));
            if shortest.wants(inner - 2.0 + QUARTER + turned(h).least() + facing.minus(h).least()) {
                let h = left.angle() - libm::atan2(2.0, sign * inner);
                offer(goal, shortest, [(Left, h + q), (Right, q), (Straight, s), (Left, heading - h)]);
            }
            if shortest.wants(inner - 2.0 + QUARTER + t.least() + turned(facing.minus(t)).least()) {
                let t = left.angle() + libm::atan2(2.0, sign * inner);
                offer(goal, shortest, [(Left, t), (Straight, s), (Right, q), (Left, heading - t + q)]);
            }
        }
        if right.length >= 2.0 && shortest.wants(right.length - 2.0 + QUARTER) {
            let s = sign * (right.length - 2.0);
            let unit = right.direction.scaled(sign);
            let (h, rest) = (if sign > 0.0 { 0.0 } else { PI }, right.length - 2.0 + QUARTER);
            if shortest.wants(rest + turned(unit).least() + unit.minus(*facing).least()) {
                let h = right.angle() + h;
                offer(goal, shortest, [(Left, h + q), (Right, q), (Straight, s), (Right, h - heading)]);
            }
            if shortest.wants(rest + unit.least() + turned(unit.minus(*facing)).least()) {
                let h = right.angle() + h;
                offer(goal, shortest, [(Left, h), (Straight, s), (Left, q), (Right, h + q - heading)]);
            }
        }
        let inner = right.inner();
        if inner >= 4.0 && shortest.wants(inner - 4.0 + PI) {
            let h = right.direction.minus(Unit { cos: sign * inner, sin: 2.0 }.scaled(1.0 / right.length));
            if shortest.wants(inner - 4.0 + PI + turned(h).least() + turned(h.minus(*facing)).least()) {
                let h = right.angle() - libm::atan2(2.0, sign * inner);
                let s = sign * (inner - 4.0);
                offer(goal, shortest, [(Left, h + q), (Right, q), (Straight, s), (Left, q), (Right, h + q - heading)]);
            }
        }
    }
}
