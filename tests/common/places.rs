//! What is free, by simple code of its own: obstacles and parts of robots as segments with a radius, and samples along motions.

use super::bodies::{p, round, star, world};
use planarium::collision::BodyMotion;
use planarium::geometry::{Aabb, Point};
use planarium::random::Random;
use planarium::robot::Part;
use planarium::scenario::{Obstacle, World};

/// Borders as chains of segments with a radius, filled or not.
pub struct Place {
    pub chains: Vec<Vec<Point>>,
    pub radius: f64,
    pub is_filled: bool,
}

impl Place {
    pub fn of(obstacle: &Obstacle) -> Self {
        let closed = |corners: &[Point]| [corners, &corners[..1]].concat();
        match obstacle {
            Obstacle::Disc(disc) => Self::line(vec![disc.center, disc.center], disc.radius),
            Obstacle::Polygon(one) => Self { chains: vec![closed(one.vertices())], radius: 0.0, is_filled: true },
            Obstacle::PolygonWithHoles(one) => {
                let chains = one.rings().map(|ring| closed(ring.vertices())).collect();
                Self { chains, radius: 0.0, is_filled: true }
            }
            Obstacle::Wall(wall) if wall.is_closed() => Self::line(closed(wall.points()), wall.width() / 2.0),
            Obstacle::Wall(wall) => Self::line(wall.points().to_vec(), wall.width() / 2.0),
        }
    }

    pub fn part(part: &Part) -> Self {
        match part {
            Part::Capsule { a, b, radius } => Self::line(vec![*a, *b], *radius),
            Part::Disc { center, radius } => Self::line(vec![*center, *center], *radius),
            Part::Polygon { vertices } => {
                Self { chains: vec![[&vertices[..], &vertices[..1]].concat()], radius: 0.0, is_filled: true }
            }
        }
    }

    fn line(points: Vec<Point>, radius: f64) -> Self {
        Self { chains: vec![points], radius, is_filled: false }
    }

    fn segments(&self) -> impl Iterator<Item = [Point; 2]> {
        self.chains.iter().flat_map(|chain| chain.windows(2).map(|pair| [pair[0], pair[1]]))
    }

    /// By the crossings of a ray, rounded.
    fn holds(&self, q: Point) -> bool {
        let crosses =
            |[a, b]: &[Point; 2]| (a.y > q.y) != (b.y > q.y) && q.x < a.x + (q.y - a.y) / (b.y - a.y) * (b.x - a.x);
        self.is_filled && self.segments().filter(crosses).count() % 2 == 1
    }

    /// The distance between the two, 0 or less if they overlap.
    pub fn gap(&self, other: &Self) -> f64 {
        let is_in = |one: &Self, other: &Self| other.chains.iter().any(|chain| one.holds(chain[0]));
        if is_in(self, other) || is_in(other, self) {
            return -self.radius - other.radius;
        }
        let pairs = self.segments().flat_map(|s| other.segments().map(move |t| segment_gap(s, t)));
        pairs.fold(f64::INFINITY, f64::min) - self.radius - other.radius
    }
}

pub fn point_gap(q: Point, [a, b]: [Point; 2]) -> f64 {
    let (along, to) = (b - a, q - a);
    let t = if along.norm() > 0.0 { (to.dot(&along) / along.norm_squared()).clamp(0.0, 1.0) } else { 0.0 };
    (to - along * t).norm()
}

fn segment_gap([a, b]: [Point; 2], [c, d]: [Point; 2]) -> f64 {
    let side = |p: Point, q: Point, r: Point| (q - p).perp(&(r - p));
    if side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0 {
        return 0.0;
    }
    point_gap(a, [c, d]).min(point_gap(b, [c, d])).min(point_gap(c, [a, b])).min(point_gap(d, [a, b]))
}

/// The least distance of parts from the obstacles and the bounds.
pub fn room(parts: &[Part], places: &[Place], bounds: &Aabb) -> f64 {
    let parts: Vec<Place> = parts.iter().map(Place::part).collect();
    let depth =
        |part: &Place| part.segments().flatten().map(|q| bounds.depth(q) - part.radius).fold(f64::INFINITY, f64::min);
    let gaps = parts.iter().flat_map(|part| places.iter().map(|place| part.gap(place)));
    gaps.chain(parts.iter().map(depth)).fold(f64::INFINITY, f64::min)
}

pub const SIDE: f64 = 10.0;

/// An obstacle with a hole or two, or a wall, closed or open, wide, thin or without width.
fn random_obstacle(random: &mut Random) -> Obstacle {
    let center = p(SIDE * random.uniform(), SIDE * random.uniform());
    let (size, turn) = (0.5 + 2.0 * random.uniform(), 6.0 * random.uniform());
    match random.below(4) {
        0 => {
            let outline = star(center, size, 5, turn);
            Obstacle::polygon_with_holes(&outline, &[star(center, 0.8 * size, 5, turn)]).expect("a frame")
        }
        1 => {
            let corners = 3 + random.below(20) as usize;
            let at = |x: f64| p(center.x + x * size, center.y);
            let hole = |x: f64| round(at(x), 0.3 * size, 3 + corners % 4, turn);
            let outline = round(center, size, corners.max(8), turn);
            Obstacle::polygon_with_holes(&outline, &[hole(-0.4), hole(0.4)]).expect("two holes")
        }
        _ => {
            let width = [0.0, 1e-6, 0.05, 0.3][random.below(4) as usize];
            let most = if random.below(5) == 0 { 40 } else { 5 };
            let points: Vec<Point> = (0..2 + random.below(most))
                .map(|_| {
                    p(
                        center.x + 2.0 * size * (random.uniform() - 0.5),
                        center.y + 2.0 * size * (random.uniform() - 0.5),
                    )
                })
                .collect();
            Obstacle::wall(&points, width, random.below(2) == 0).expect("a wall")
        }
    }
}

pub fn random_world(random: &mut Random) -> (World, Vec<Place>) {
    let obstacles: Vec<Obstacle> = (0..3).map(|_| random_obstacle(random)).collect();
    let places = obstacles.iter().map(Place::of).collect();
    (world([0.0, 0.0], [SIDE, SIDE], obstacles), places)
}

/// What is said of motions, accepted and refused: both kinds were met.
#[derive(Default)]
pub struct Tally([u32; 2]);

/// How many samples a motion is looked at.
const SAMPLES: u32 = 96;

impl Tally {
    /// Checks a verdict about a motion: `at` are the parts of the robot along it, no point of which travels farther than `travel`,
    /// and `is_free` the verdict about the robot at rest there.
    pub fn judge(
        &mut self,
        is_motion_free: bool,
        travel: f64,
        (places, bounds): (&[Place], &Aabb),
        at: impl Fn(f64) -> Vec<Part>,
        is_free: impl Fn(f64) -> bool,
    ) {
        let mut least = f64::INFINITY;
        for k in 0..=SAMPLES {
            let t = f64::from(k) / f64::from(SAMPLES);
            let here = room(&at(t), places, bounds);
            least = least.min(here);
            if here.abs() > 1e-9 && k % 16 == 0 {
                assert_eq!(is_free(t), here > 0.0, "{here:e} to spare at {t}");
            }
        }
        if is_motion_free {
            assert!(least > -1e-9, "an accepted motion overlaps by {least:e}");
        } else {
            let missed = 0.5 * travel / f64::from(SAMPLES) + 2.5e-3;
            assert!(least < missed, "a refused motion has {least} to spare");
        }
        self.0[usize::from(is_motion_free)] += 1;
    }

    pub fn both(&self) {
        assert!(self.0.iter().all(|&count| count > 10), "refused and accepted: {:?}", self.0);
    }
}

/// The length of the origin's path and the turn.
pub fn extent(motion: &BodyMotion) -> (f64, f64) {
    match *motion {
        BodyMotion::Straight { delta: [x, y, turn], .. } => (libm::hypot(x, y), turn.abs()),
        BodyMotion::Arc { speed, turn_rate, duration, .. } => ((speed * duration).abs(), (turn_rate * duration).abs()),
    }
}
