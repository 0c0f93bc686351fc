//! Motion along a circular arc.

/// Where a body is after it has moved for `time` seconds from (x, y, theta) with constant speed along its own x axis, in
/// metres a second, and constant turn rate, in radians a second: exact but for rounding, straight motion and turning in
/// place included. Negative speeds and times go backwards. The angle is not wrapped.
///
/// The place is a chord of the arc away: with s = speed x time and a = turn rate x time, s sin(a / 2) / (a / 2) metres in
/// direction theta + a / 2. Nothing cancels where the turn is small.
pub fn arc_pose(from: [f64; 3], speed: f64, turn_rate: f64, time: f64) -> [f64; 3] {
    let [x, y, theta] = from;
    let turn = turn_rate * time;
    let half = 0.5 * turn;
    let shortening = if half == 0.0 { 1.0 } else { libm::sin(half) / half };
    let chord = speed * time * shortening;
    let (sin, cos) = libm::sincos(theta + half);
    [x + chord * cos, y + chord * sin, theta + turn]
}
