//! The shortest segments between two obstacles, or an obstacle and the bounds, that may close a curve.
//!
//! Two borders are nearest to each other at a tip of one of them, or cross. From each tip its nearest point on every other core
//! is sought, but where a point of a third core, or of the bounds, lies in the open disc about the segment whose diameter it is:
//! two segments by way of that point are shorter and as good (the rule of Gabriel's graph). A point that is found so excludes
//! a half-plane of all farther ones. What rounding might have decided is not excluded.

use super::features::{Features, Vertex, nearest_on};
use super::parity::{Parities, Way};
use crate::error::{Code, Error};
use crate::geometry::{Aabb, Point, Segment, Vector, intersects_segment_segment, orientation};

/// Links that are stored at most, and contacts: they take a quarter of a gigabyte.
const MOST: usize = 4_000_000;

/// Points that exclude others from one tip, at most.
const MOST_EXCLUDING: usize = 24;

/// A segment between two borders.
#[derive(Debug, Clone, Copy)]
pub(super) struct Link {
    /// Its length, in metres.
    pub gap: f64,
    pub ends: [Point; 2],
    /// Vertices of the two borders; one past the last vertex stands for the bounds.
    pub places: [u32; 2],
    /// Whether the way from one of these to the other along it crosses that from start to goal an odd number of times.
    pub is_odd: bool,
}

/// All links, and what contacts have connected.
pub(super) struct Links<'a> {
    features: &'a Features,
    bounds: Aabb,
    way: Way,
    /// Gaps of at most this count as contact, in metres.
    contact: f64,
    /// Longer links are of no use, in metres.
    most: f64,
    pub parities: Parities,
    pub found: Vec<Link>,
    contacts: usize,
    /// Whether contacts alone close a curve between start and goal.
    pub is_closed: bool,
}

impl<'a> Links<'a> {
    /// All links up to a length. O(n log n) for n vertices in usual worlds.
    ///
    /// # Errors
    /// `too-large` for more than 4,000,000 links or contacts.
    pub fn new(features: &'a Features, bounds: Aabb, way: Way, contact: f64, most: f64) -> Result<Self, Error> {
        let parities = Parities::new(features.vertices.len() + 1);
        let (found, contacts, is_closed) = (Vec::new(), 0, false);
        let mut links = Self { features, bounds, way, contact, most, parities, found, contacts, is_closed };
        for core in 0..features.cores.len() {
            let Segment { a, b } = features.segment(core);
            links.is_closed |= !links.parities.join(features.cores[core], way.is_crossed(a, b));
        }
        for place in 0..features.vertices.len() as u32 {
            links.leave(place);
        }
        for core in 0..features.cores.len() {
            links.cross(core)?;
        }
        for place in 0..features.vertices.len() as u32 {
            links.reach(place)?;
        }
        Ok(links)
    }

    /// The place of the bounds.
    fn outside(&self) -> u32 {
        self.features.vertices.len() as u32
    }

    fn vertex(&self, place: u32) -> &'a Vertex {
        &self.features.vertices[place as usize]
    }

    /// Connects two places that are in contact.
    fn touch(&mut self, places: [u32; 2], is_odd: bool) {
        self.contacts += 1;
        self.is_closed |= !self.parities.join(places, is_odd);
    }

    fn add(&mut self, link: Link) {
        if link.gap <= self.contact {
            self.touch(link.places, link.is_odd);
        } else if link.gap <= self.most {
            self.found.push(link);
        }
    }

    /// Whether there are too many.
    fn checked(&self) -> Result<(), Error> {
        if self.contacts.max(self.found.len()) <= MOST {
            return Ok(());
        }
        let sentence = format!("the obstacles have more than {MOST} contacts, or gaps between neighbours");
        Err(Error::new(Code::TooLarge, "", sentence))
    }

    /// The way from a vertex straight over a side of the bounds: the distance of the side, negative outside, its nearest point,
    /// and the parity of the way to a point beyond it. From there all ways outside cross nothing.
    fn over_sides(&self, at: Point) -> [(f64, Point, bool); 4] {
        let (Aabb { min, max }, far) = (self.bounds, self.bounds.longer_side());
        let to = |distance: f64, foot: Point, beyond: Point| (distance, foot, self.way.is_crossed(at, beyond));
        let point = Point::new;
        [
            to(at.x - min.x, point(min.x, at.y), point(at.x.min(min.x) - far, at.y)),
            to(max.x - at.x, point(max.x, at.y), point(at.x.max(max.x) + far, at.y)),
            to(at.y - min.y, point(at.x, min.y), point(at.x, at.y.min(min.y) - far)),
            to(max.y - at.y, point(at.x, max.y), point(at.x, at.y.max(max.y) + far)),
        ]
    }

    /// Connects a vertex that touches the bounds, or lies outside them, with these.
    fn leave(&mut self, place: u32) {
        let vertex = self.vertex(place);
        for (distance, _, is_odd) in self.over_sides(vertex.at) {
            if distance - vertex.radius <= self.contact {
                self.touch([place, self.outside()], is_odd);
            }
        }
    }

    /// Connects a core with those that cross or touch it, as if none had a radius. Exact.
    fn cross(&mut self, core: usize) -> Result<(), Error> {
        let (features, s) = (self.features, self.features.segment(core));
        let [a, b] = features.cores[core];
        if a == b {
            return Ok(());
        }
        features.near(&s.aabb(), |other| {
            let [c, d] = features.cores[other];
            if other <= core || [c, d].iter().any(|end| [a, b].contains(end)) {
                return;
            }
            let t = features.segment(other);
            if intersects_segment_segment(&s, &t) {
                let x = common_point(&s, &t);
                let is_odd = self.way.is_crossed(s.a, x) ^ self.way.is_crossed(x, t.a);
                self.touch([a, c], is_odd);
            }
        });
        self.checked()
    }

    /// Adds the links of a tip.
    fn reach(&mut self, place: u32) -> Result<(), Error> {
        let (features, vertex) = (self.features, self.vertex(place));
        let around = Aabb { min: vertex.at, max: vertex.at }.grown(vertex.radius);
        if !vertex.is_tip || !around.intersects(&self.bounds) {
            return Ok(());
        }
        let beside = vertex.beside.map(|other| other.map(|other| self.vertex(other).at - vertex.at));
        let mut tip = Tip { links: self, place, vertex, beside, excluding: Vec::new() };
        tip.reach_bounds();
        features.visit(&mut tip, Tip::bound, Tip::visit);
        self.checked()
    }
}

/// A point that two segments share, which are known to; an end of one if that is one.
fn common_point(s: &Segment, t: &Segment) -> Point {
    let is_on = |p: Point, s: &Segment| orientation(s.a, s.b, p) == 0.0 && s.aabb().contains(p);
    let end = [(s.a, t), (s.b, t), (t.a, s), (t.b, s)].into_iter().find(|(p, other)| is_on(*p, other));
    end.map_or_else(
        || {
            let (u, v, w) = (s.b - s.a, t.b - t.a, t.a - s.a);
            let along = (w.perp(&v) / u.perp(&v)).clamp(0.0, 1.0);
            // Nearly parallel segments have no quotient to speak of.
            if along.is_finite() { s.a + u * along } else { nearest_on(s, t.a) }
        },
        |(p, _)| p,
    )
}

/// The search from one tip. Vectors are relative to it.
struct Tip<'l, 'a> {
    links: &'l mut Links<'a>,
    place: u32,
    vertex: &'a Vertex,
    /// To its neighbours on its border.
    beside: [Option<Vector>; 2],
    /// Points of obstacles and bounds, beyond the radius of the tip.
    excluding: Vec<Vector>,
}

impl Tip<'_, '_> {
    /// Whether all points of a box, relative to the tip, are excluded; their distances from the tip are in a range. In doubt not.
    ///
    /// A point x at a distance d, and the point on the same ray at the radius r of the tip, are excluded by f if the angle at f
    /// is obtuse: (f - r x / d) . (f - x) < 0, or f . x > d (f . f + r d) / (r + d). The right side grows with d.
    fn is_excluded(&self, low: Vector, high: Vector, [nearest, farthest]: [f64; 2]) -> bool {
        let least =
            |f: &Vector| f.x * if f.x > 0.0 { low.x } else { high.x } + f.y * if f.y > 0.0 { low.y } else { high.y };
        // Half of the contact is a slack that exceeds the rounding of all points.
        let slack = |f: &Vector| 0.5 * self.links.contact * (f.norm() + farthest);
        if self.beside.iter().flatten().any(|e| least(e) > slack(e)) {
            return true;
        }
        let r = self.vertex.radius;
        let most = |f: &Vector| farthest * (f.norm_squared() + r * farthest) / (r + farthest);
        nearest > r && self.excluding.iter().any(|f| least(f) > most(f) + slack(f))
    }

    /// The distance of a box; `None` if it is too far, or excluded.
    fn bound(&self, aabb: &Aabb) -> Option<f64> {
        let at = Aabb { min: self.vertex.at, max: self.vertex.at };
        let nearest = libm::sqrt(at.gap_squared(aabb));
        let (low, high) = (aabb.min - self.vertex.at, aabb.max - self.vertex.at);
        let farthest = Vector::new(low.x.abs().max(high.x.abs()), low.y.abs().max(high.y.abs())).norm();
        let is_far = nearest - self.vertex.radius > self.links.most;
        (!is_far && !self.is_excluded(low, high, [nearest, farthest])).then_some(nearest)
    }

    fn exclude_by(&mut self, f: Vector) {
        if self.excluding.len() < MOST_EXCLUDING {
            self.excluding.push(f);
        }
    }

    /// The links to the sides of the bounds.
    fn reach_bounds(&mut self) {
        let radius = self.vertex.radius;
        for (distance, foot, is_odd) in self.links.over_sides(self.vertex.at) {
            let (gap, x) = (distance - radius, foot - self.vertex.at);
            if gap > self.links.contact && !self.is_excluded(x, x, [distance; 2]) {
                let ends = [self.vertex.at + x * (radius / distance), foot];
                self.links.add(Link { gap, ends, places: [self.place, self.links.outside()], is_odd });
                self.exclude_by(x);
            }
        }
    }

    /// The link to a core.
    fn visit(&mut self, core: usize) {
        let (features, way, at) = (self.links.features, self.links.way, self.vertex.at);
        let [a, b] = features.cores[core];
        if [a, b].contains(&self.place) {
            return;
        }
        let (segment, [near, far]) = (features.segment(core), [self.vertex.radius, features.radius(core)]);
        let y = nearest_on(&segment, at);
        let away = y - at;
        let distance = away.norm();
        let gap = distance - near - far;
        if gap > self.links.most {
            return;
        }
        let is_odd = way.is_crossed(at, y) ^ way.is_crossed(y, segment.a);
        let link = Link { gap, ends: [at, y], places: [self.place, a], is_odd };
        if gap <= self.links.contact {
            return self.links.add(link);
        }
        let x = if far > 0.0 { away * (1.0 - far / distance) } else { away };
        // The same corner, as the end of another edge, is known.
        if self.excluding.contains(&x) || self.is_excluded(x, x, [distance - far; 2]) {
            return;
        }
        let ends = [at + away * (near / distance), if far > 0.0 { at + x } else { y }];
        self.links.add(Link { ends, ..link });
        self.exclude_by(x);
    }
}
