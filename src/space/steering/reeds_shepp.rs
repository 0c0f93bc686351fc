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
//! Points are complex numbers, e(h) the heading h, n(h) = e(h - pi/2) the vector from a left circle's centre to a car on it. From the
//! centre of the circle left of the start to that left (right) of the goal the vector is, for arcs t, u, v and a line s,
//! - LSL: s e(t); LSR: (s - 2i) e(t);
//! - LRL: 2 n(t) - 2 n(t - u) = 4 sin(u/2) e(t - u/2);
//! - LRLR with arcs t, u, -u: 2 (2 cos u - 1) n(t - u), and with t, u, u: 2 (2 - e(-u)) n(t);
//! - LRSL, the right arc a quarter q = +-pi/2, then at heading h = t - q: (s +- 2 + 2i) e(h); LRSR: (s +- 2) e(h);
//! - LSRL, the right arc q: (s +- 2 - 2i) e(t); LSLR, the left arc after the line q: (s +- 2) e(t);
//! - LRSLR, both quarters q, at heading h: (s +- 4 + 2i) e(h).

use super::goal::{Goal, Shortest, short_words, shorter};
use super::{Curve, Pose, Turn};
use std::cmp::Ordering;
use std::f64::consts::PI;

/// A quarter of a turn.
const QUARTER: f64 = 0.5 * PI;

/// The shortest curve from one pose to another for a car that turns no tighter than `radius` metres, greater than 0, and may
/// reverse anywhere. The curve back is the same, reversed, to the bit. O(1).
pub fn reeds_shepp(from: Pose, to: Pose, radius: f64) -> Curve {
    let order = from.x.total_cmp(&to.x).then(from.y.total_cmp(&to.y)).then(from.heading.total_cmp(&to.heading));
    if order == Ordering::Greater { find(to, from, radius).reversed() } else { find(from, to, radius) }
}

fn find(from: Pose, to: Pose, radius: f64) -> Curve {
    let goal = Goal::new(from, to, radius);
    let sides = [goal, goal.mirrored()];
    let found = Shortest::find(radius, |shortest| {
        short_words(&sides, |goal, word| offer(goal, shortest, word));
        for family in [straight, arcs, equal_arcs, quarters] {
            sides.iter().for_each(|goal| family(goal, shortest));
        }
    });
    // Rounding drops none of the words that always exist unless numbers overflow.
    found.unwrap_or_else(|| {
        let left = &goal.left;
        let word = [left.angle, left.length, shorter(goal.heading - left.angle)];
        Curve::new(1.0, &[(Turn::Left, word[0]), (Turn::Straight, word[1]), (Turn::Left, word[2])]).scaled(radius)
    })
}

/// Offers a word that begins to the left, or to the right in the mirror; angles by the shorter way. Words that do not exist
/// have lengths that are not numbers.
fn offer<const K: usize>(goal: &Goal, shortest: &mut Shortest, mut word: [(Turn, f64); K]) {
    for (turn, length) in &mut word {
        if *turn != Turn::Straight {
            *length = shorter(*length);
        }
    }
    shortest.offer(goal, &word);
}

/// CSC.
fn straight(goal: &Goal, shortest: &mut Shortest) {
    use Turn::{Left, Right, Straight};
    let heading = goal.heading;
    let left = &goal.left;
    for (t, s) in [(left.angle, left.length), (left.angle + PI, -left.length)] {
        offer(goal, shortest, [(Left, t), (Straight, s), (Left, heading - t)]);
    }
    let right = &goal.right;
    let inner = right.inner();
    for s in [inner, -inner] {
        let t = right.angle + libm::atan2(2.0, s);
        offer(goal, shortest, [(Left, t), (Straight, s), (Right, t - heading)]);
    }
}

/// C|C|C, C|CC and CC|C.
fn arcs(goal: &Goal, shortest: &mut Shortest) {
    use Turn::{Left, Right};
    let left = &goal.left;
    if left.length > 4.0 {
        return;
    }
    let half = libm::asin(0.25 * left.length);
    for (t, u) in [(left.angle + half, 2.0 * half), (left.angle + PI - half, -2.0 * half)] {
        offer(goal, shortest, [(Left, t), (Right, u), (Left, goal.heading - t + u)]);
    }
}

/// CCu|CuC and C|CuCu|C.
fn equal_arcs(goal: &Goal, shortest: &mut Shortest) {
    use Turn::{Left, Right};
    let heading = goal.heading;
    let right = &goal.right;
    if right.length > 6.0 {
        return;
    }
    for (cos, middle) in
        [(0.25 * (2.0 + right.length), right.angle + QUARTER), (0.25 * (2.0 - right.length), right.angle - QUARTER)]
    {
        let u = libm::acos(cos);
        for u in [u, -u] {
            let t = middle + u;
            offer(goal, shortest, [(Left, t), (Right, u), (Left, -u), (Right, t - 2.0 * u - heading)]);
        }
    }
    let cos = 1.25 - 0.0625 * right.length * right.length;
    let u = libm::acos(cos);
    let aside = libm::atan2(libm::sin(u), 2.0 - cos);
    for (u, aside) in [(u, aside), (-u, -aside)] {
        let t = right.angle + QUARTER - aside;
        offer(goal, shortest, [(Left, t), (Right, u), (Left, u), (Right, t - heading)]);
    }
}

/// C|CqSC, CSCq|C and C|CqSCq|C. A line that goes against the quarter before it is never part of a shortest curve.
fn quarters(goal: &Goal, shortest: &mut Shortest) {
    use Turn::{Left, Right, Straight};
    let heading = goal.heading;
    let (left, right) = (&goal.left, &goal.right);
    for sign in [1.0, -1.0] {
        let q = sign * QUARTER;
        let inner = left.inner();
        if inner >= 2.0 {
            let (s, aside) = (sign * (inner - 2.0), libm::atan2(2.0, sign * inner));
            let h = left.angle - aside;
            offer(goal, shortest, [(Left, h + q), (Right, q), (Straight, s), (Left, heading - h)]);
            let t = left.angle + aside;
            offer(goal, shortest, [(Left, t), (Straight, s), (Right, q), (Left, heading - t + q)]);
        }
        if right.length >= 2.0 {
            let s = sign * (right.length - 2.0);
            let h = if sign > 0.0 { right.angle } else { right.angle + PI };
            offer(goal, shortest, [(Left, h + q), (Right, q), (Straight, s), (Right, h - heading)]);
            offer(goal, shortest, [(Left, h), (Straight, s), (Left, q), (Right, h + q - heading)]);
        }
        let inner = right.inner();
        if inner >= 4.0 {
            let h = right.angle - libm::atan2(2.0, sign * inner);
            let s = sign * (inner - 4.0);
            offer(goal, shortest, [(Left, h + q), (Right, q), (Straight, s), (Left, q), (Right, h + q - heading)]);
        }
    }
}
