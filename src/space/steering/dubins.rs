//! The shortest curve of a car that only drives forwards.
//!
//! Dubins 1957, "On curves of minimal length with a constraint on average curvature, and with prescribed initial and
//! terminal positions and tangents": it is one of six words, an arc, then a straight line or an arc of the opposite
//! direction, then an arc.

use super::goal::{Goal, Shortest, forwards, short_words};
use super::{Curve, Pose, Turn};
use std::f64::consts::{PI, TAU};

/// The shortest curve from one pose to another for a car that turns no tighter than `radius` metres, greater than 0, and only
/// drives forwards. Words in the order LSL, LSR, LRL, and the same with left for right. O(1).
pub fn dubins(from: Pose, to: Pose, radius: f64) -> Curve {
    let goal = Goal::new(from, to, radius);
    let sides = [goal, goal.mirrored()];
    let found = Shortest::find(radius, |shortest| {
        short_words(&sides, |side, word| offer(shortest, side, &word));
        for side in &sides {
            words(side).iter().for_each(|word| offer(shortest, side, word));
        }
    });
    // Rounding drops none of the words that always exist unless numbers overflow.
    found.unwrap_or_else(|| {
        let [(_, first), (_, line), (_, last)] = words(&goal)[0];
        let word = [(Turn::Left, forwards(first)), (Turn::Straight, line), (Turn::Left, forwards(last))];
        Curve::new(1.0, &word).scaled(radius)
    })
}

/// The words that begin to the left, with unwrapped angles. If one does not exist, its lengths are not numbers.
fn words(goal: &Goal) -> [[(Turn, f64); 3]; 3] {
    use Turn::{Left, Right, Straight};
    let (left, right) = (&goal.left, &goal.right);
    let inner = right.inner();
    let turn = right.angle + libm::atan2(2.0, inner);
    // The middle arc is more than half a turn.
    let half = libm::asin(0.25 * left.length);
    let (first, middle) = (left.angle + PI - half, TAU - 2.0 * half);
    [
        [(Left, left.angle), (Straight, left.length), (Left, goal.heading - left.angle)],
        [(Left, turn), (Straight, inner), (Right, turn - goal.heading)],
        [(Left, first), (Right, middle), (Left, goal.heading - first + middle)],
    ]
}

/// Offers a word if it can be driven forwards.
fn offer(shortest: &mut Shortest, goal: &Goal, word: &[(Turn, f64)]) {
    let is_forwards = |&(turn, length): &(Turn, f64)| turn != Turn::Straight || length >= -goal.slack;
    if word.iter().all(is_forwards) {
        let mut segments = [(Turn::Straight, 0.0); 3];
        for (segment, &(turn, length)) in segments.iter_mut().zip(word) {
            *segment = (turn, if turn == Turn::Straight { length.max(0.0) } else { forwards(length) });
        }
        shortest.offer(goal, &segments);
    }
}
