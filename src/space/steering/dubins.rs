//! The shortest curve of a car that only drives forwards.
//!
//! Dubins 1957, "On curves of minimal length with a constraint on average curvature, and with prescribed initial and
//! terminal positions and tangents": it is one of six words, an arc, then a straight line or an arc of the opposite
//! direction, then an arc.

use super::goal::{Goal, Shortest, Unit, forwards, short_words};
use super::{Curve, Pose, Turn};
use std::f64::consts::{PI, TAU};

/// The shortest curve from one pose to another for a car that turns no tighter than `radius` metres, greater than 0, and only
/// drives forwards. Words in the order LSL, LSR, LRL, and the same with left for right. O(1).
pub fn dubins(from: Pose, to: Pose, radius: f64) -> Curve {
    within(from, to, radius, f64::INFINITY).expect("some word leads to every pose")
}

/// The same if it is no longer than `most` metres; else `None`, or a curve that is longer than `most` too.
pub(super) fn within(from: Pose, to: Pose, radius: f64, most: f64) -> Option<Curve> {
    let goal = Goal::new(from, to, radius);
    if goal.is_behind(most / radius) {
        return None;
    }
    let found = Shortest::find(&goal, radius, most, |sides, shortest| {
        short_words(sides, |side, word| offer(shortest, side, &word));
        sides.iter().for_each(|side| words(side, shortest));
    });
    if found.is_some() || most < f64::INFINITY {
        return found;
    }
    // Rounding drops none of the words that always exist unless numbers overflow.
    let (angle, line) = (goal.left.angle(), goal.left.length);
    let word = [(Turn::Left, forwards(angle)), (Turn::Straight, line), (Turn::Left, forwards(goal.heading - angle))];
    Some(Curve::new(1.0, &word).scaled(radius))
}

/// Offers the words that begin to the left, with unwrapped angles. If one does not exist, its lengths are not numbers.
fn words<'a>(goal: &'a Goal, shortest: &mut Shortest<'a>) {
    use Turn::{Left, Right, Straight};
    let Goal { heading, facing, left, right, .. } = goal;
    let t = left.direction;
    if shortest.wants(left.length + t.least_forwards() + facing.minus(t).least_forwards()) {
        let t = left.angle();
        offer(shortest, goal, &[(Left, t), (Straight, left.length), (Left, heading - t)]);
    }
    let inner = right.inner();
    let t = right.direction.plus(Unit { cos: inner, sin: 2.0 }.scaled(1.0 / right.length));
    if inner >= 0.0 && shortest.wants(inner + t.least_forwards() + t.minus(*facing).least_forwards()) {
        let t = right.angle() + libm::atan2(2.0, inner);
        offer(shortest, goal, &[(Left, t), (Straight, inner), (Right, t - heading)]);
    }
    // The middle arc is more than half a turn.
    let sin = 0.25 * left.length;
    if sin > 1.0 || !shortest.wants(PI) {
        return;
    }
    let half = Unit { cos: (1.0 - sin * sin).sqrt(), sin };
    let (t, v) = (left.direction.minus(half).opposite(), facing.minus(left.direction).minus(half).opposite());
    // Half of the middle arc is at least a quarter, PI - half.
    let middle = 2.0 * half.opposite().least().max(0.5 * PI);
    if shortest.wants(middle + t.least_forwards() + v.least_forwards()) {
        let half = libm::asin(sin);
        let (t, u) = (left.angle() + PI - half, TAU - 2.0 * half);
        offer(shortest, goal, &[(Left, t), (Right, u), (Left, heading - t + u)]);
    }
}

/// Offers a word if it can be driven forwards.
fn offer<'a>(shortest: &mut Shortest<'a>, goal: &'a Goal, word: &[(Turn, f64)]) {
    let is_forwards = |&(turn, length): &(Turn, f64)| turn != Turn::Straight || length >= -goal.slack;
    if word.iter().all(is_forwards) {
        let mut segments = [(Turn::Straight, 0.0); 3];
        for (segment, &(turn, length)) in segments.iter_mut().zip(word) {
            *segment = (turn, if turn == Turn::Straight { length.max(0.0) } else { forwards(length) });
        }
        shortest.offer(goal, &segments);
    }
}
