//! Whether two trajectories share a point, for any motion with bounded acceleration: by halving both until their chords decide.
//!
//! Over an interval of h seconds with an acceleration of at most A, a trajectory departs from its chord, driven at constant
//! speed, by at most A h^2 / 8. Two intervals whose chords are farther apart than both departures and the slack are apart. Else
//! the interval that departs more is halved, which divides its departure by four. Pairs whose departures together are below the
//! slack and that are still not proven apart count as crossing. So apart is proven, and the only trajectories refused without a
//! crossing are within two slacks of each other, or exceed the budget.
//!
//! Most crossings are found earlier: if the ends of each chord lie on different sides of the other's line, farther from it than
//! the other departs, each interval leads through the strip about the other chord from side to side. In the parallelogram that
//! the strips have in common the two then connect opposite sides, and so they cross.

use super::particle::Particle;
use crate::geometry::{Point, Segment, distance_point_segment, distance_segment_segment};

/// A crossing is refined until its position is known to this number of slacks.
const NEAR: f64 = 1e6;

/// The result of halving.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Halving {
    /// A point of the first trajectory where the second comes too close; `None` if the two are proven apart.
    pub meeting: Option<Point>,
    /// Pairs of intervals examined.
    pub pairs: u64,
}

/// An interval of time, with the chord of the trajectory over it and a bound on the departure from the chord.
#[derive(Clone, Copy)]
struct Interval {
    from: f64,
    to: f64,
    chord: Segment,
    departure: f64,
}

impl Interval {
    fn new(particle: &Particle, from: f64, to: f64, chord: Segment) -> Self {
        let length = to - from;
        Self { from, to, chord, departure: particle.acceleration(to) * length * length / 8.0 }
    }

    fn whole(particle: &Particle) -> Self {
        let chord = Segment::new(particle.start, particle.position(particle.duration));
        let mut whole = Self::new(particle, 0.0, particle.duration, chord);
        if particle.is_straight() {
            whole.departure = 0.0;
        }
        whole
    }

    fn halves(&self, particle: &Particle) -> [Self; 2] {
        let time = 0.5 * (self.from + self.to);
        let middle = particle.position(time);
        let first = Self::new(particle, self.from, time, Segment::new(self.chord.a, middle));
        [first, Self::new(particle, time, self.to, Segment::new(middle, self.chord.b))]
    }
}

/// Whether the trajectories come within `eta` metres of each other, `eta` greater than 0; gives up after `budget` pairs of
/// intervals, which counts as crossing. Earlier intervals are examined first.
pub fn halve(a: &Particle, b: &Particle, eta: f64, budget: u64) -> Halving {
    let mut open = vec![(Interval::whole(a), Interval::whole(b))];
    let mut pairs = 0;
    while let Some((s, t)) = open.pop() {
        pairs += 1;
        let departures = s.departure + t.departure;
        if distance_segment_segment(&s.chord, &t.chord) > departures + eta {
            continue;
        }
        let is_found = departures <= NEAR * eta && is_crossed(&s, &t) && is_crossed(&t, &s);
        if is_found || departures <= eta || pairs >= budget {
            return Halving { meeting: Some(nearest_point(&s.chord, &t.chord)), pairs };
        }
        if s.departure >= t.departure {
            let [first, second] = s.halves(a);
            open.extend([(second, t), (first, t)]);
        } else {
            let [first, second] = t.halves(b);
            open.extend([(s, second), (s, first)]);
        }
    }
    Halving { meeting: None, pairs }
}

/// Whether the first interval leads from one side of the strip about the second's chord to the other.
fn is_crossed(s: &Interval, t: &Interval) -> bool {
    let along = t.chord.b - t.chord.a;
    let (from, to) = (along.perp(&(s.chord.a - t.chord.a)), along.perp(&(s.chord.b - t.chord.a)));
    // Twice the departure: far more than rounding.
    let strip = 2.0 * t.departure * along.norm();
    (from > strip && to < -strip) || (from < -strip && to > strip)
}

/// The point where the first segment crosses the second, or the end of one that is nearest to the other.
pub(super) fn nearest_point(s: &Segment, t: &Segment) -> Point {
    let (u, v) = (s.b - s.a, t.b - t.a);
    let across = u.perp(&v);
    let (along_s, along_t) = ((t.a - s.a).perp(&v) / across, (t.a - s.a).perp(&u) / across);
    // Not numbers if the segments are parallel.
    if (0.0..=1.0).contains(&along_s) && (0.0..=1.0).contains(&along_t) {
        return s.a + u * along_s;
    }
    let ends = [(s.a, t), (s.b, t), (t.a, s), (t.b, s)];
    let gap = |&(p, other): &(Point, &Segment)| distance_point_segment(p, other);
    ends.into_iter()
        .reduce(|nearest, end| if gap(&end) < gap(&nearest) { end } else { nearest })
        .map_or(s.a, |end| end.0)
}
