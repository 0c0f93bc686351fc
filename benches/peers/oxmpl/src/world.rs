//! A world for planar arms, read from the flat text that the benchmark writes, and its collision checker: the same tests in the
//! same order as in the C++ peer.

use std::error::Error;

/// Smallest and largest x, smallest and largest y.
type Extent = [[f64; 2]; 2];

struct Convex {
    extent: Extent,
    /// a, b, c of each edge: a x + b y + c is positive on its left, which is inside.
    edges: Vec<[f64; 3]>,
}

/// An arm, its start and goal, and the obstacles.
#[derive(Default)]
pub struct World {
    base: [f64; 2],
    radius: f64,
    /// The lengths of the links.
    pub links: Vec<f64>,
    /// The angles at the start.
    pub start: Vec<f64>,
    /// The angles at the goal.
    pub goal: Vec<f64>,
    /// Left, bottom, right, top.
    bounds: Option<[f64; 4]>,
    polygons: Vec<Convex>,
    /// x, y, radius.
    discs: Vec<[f64; 3]>,
}

impl World {
    /// Reads a world: one item per line, a word and its numbers.
    pub fn read(file: &str) -> Result<Self, Box<dyn Error>> {
        let mut world = Self::default();
        for line in std::fs::read_to_string(file)?.lines() {
            let (kind, numbers) = line.split_once(' ').ok_or("a line is a word and its numbers")?;
            let numbers = numbers.split(' ').map(str::parse).collect::<Result<Vec<f64>, _>>()?;
            match kind {
                "base" => world.base = [numbers[0], numbers[1]],
                "radius" => world.radius = numbers[0],
                "links" => world.links = numbers,
                "start" => world.start = numbers,
                "goal" => world.goal = numbers,
                "bounds" => world.bounds = Some(std::array::from_fn(|i| numbers[i])),
                "polygon" => world.polygons.push(Convex::new(&numbers)),
                "disc" => world.discs.push(std::array::from_fn(|i| numbers[i])),
                other => return Err(format!("unknown item in {file}: {other}").into()),
            }
        }
        if !world.polygons.is_empty() && world.radius > 0.0 {
            return Err("thick links among polygons are not supported".into());
        }
        Ok(world)
    }

    /// Whether the arm at these angles, each relative to the link before, touches no obstacle and stays within the bounds.
    pub fn is_free(&self, angles: &[f64]) -> bool {
        let (mut at, mut direction) = (self.base, 0.0);
        for (length, angle) in self.links.iter().zip(angles) {
            direction += angle;
            let (sin, cos) = direction.sin_cos();
            let next = [at[0] + length * cos, at[1] + length * sin];
            if !self.is_inside(next) || !self.is_link_free(at, next) {
                return false;
            }
            at = next;
        }
        true
    }

    fn is_inside(&self, [x, y]: [f64; 2]) -> bool {
        let r = self.radius;
        self.bounds
            .is_none_or(|[left, bottom, right, top]| x - r >= left && x + r <= right && y - r >= bottom && y + r <= top)
    }

    fn is_link_free(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        let extent = [0, 1].map(|i| [a[i].min(b[i]), a[i].max(b[i])]);
        let is_near = |other: &Extent| (0..2).all(|i| extent[i][0] <= other[i][1] && extent[i][1] >= other[i][0]);
        let hits_polygon = |polygon: &Convex| is_near(&polygon.extent) && polygon.meets(a, b);
        let hits_disc = |&[x, y, radius]: &[f64; 3]| {
            let reach = radius + self.radius;
            is_near(&[[x - reach, x + reach], [y - reach, y + reach]])
                && squared_distance([x, y], a, b) <= reach * reach
        };
        !self.polygons.iter().any(hits_polygon) && !self.discs.iter().any(hits_disc)
    }
}

impl Convex {
    fn new(corners: &[f64]) -> Self {
        let corner = |i: usize| [corners[2 * i], corners[2 * i + 1]];
        let count = corners.len() / 2;
        let mut polygon = Self { extent: corner(0).map(|x| [x, x]), edges: Vec::new() };
        for i in 0..count {
            let ([x, y], next) = (corner(i), corner((i + 1) % count));
            let along = [next[0] - x, next[1] - y];
            polygon.edges.push([-along[1], along[0], along[1] * x - along[0] * y]);
            for (extent, value) in polygon.extent.iter_mut().zip([x, y]) {
                *extent = [extent[0].min(value), extent[1].max(value)];
            }
        }
        polygon
    }

    /// Whether a segment meets the polygon: it is clipped at each edge in turn, and must not become empty.
    fn meets(&self, p: [f64; 2], q: [f64; 2]) -> bool {
        let (mut from, mut to) = (0.0f64, 1.0f64);
        for [a, b, c] in &self.edges {
            let [first, last] = [p, q].map(|[x, y]| a * x + b * y + c);
            if first < 0.0 {
                if last < 0.0 {
                    return false;
                }
                from = from.max(first / (first - last));
            } else if last < 0.0 {
                to = to.min(first / (first - last));
            }
        }
        from <= to
    }
}

fn squared_distance(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let along = [b[0] - a[0], b[1] - a[1]];
    let t = ((p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1]) / (along[0] * along[0] + along[1] * along[1]);
    let t = t.clamp(0.0, 1.0);
    let gap = [a[0] + t * along[0] - p[0], a[1] + t * along[1] - p[1]];
    gap[0] * gap[0] + gap[1] * gap[1]
}
