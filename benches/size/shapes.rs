//! The worlds that are measured.

use planarium::geometry::{Aabb, Point, Polygon};
use planarium::random::{Random, Stream};
use planarium::robot::RigidBody;
use planarium::scenario::{Obstacle, Query, Robot, Scenario, World};
use std::f64::consts::TAU;

/// About so many rectangles, one in each square metre, that leave the lines between square metres free.
pub fn map(count: usize) -> World {
    scattered(count, |random, x, y| {
        let mut span = |low: f64| {
            let width = 0.2 + 0.5 * random.uniform();
            let at = low + 0.15 + (0.7 - width) * random.uniform();
            [at, at + width]
        };
        let ([left, right], [bottom, top]) = (span(x), span(y));
        rectangle([left, bottom], [right, top])
    })
}

/// The same with discs.
pub fn discs(count: usize) -> World {
    scattered(count, |random, x, y| {
        let radius = 0.1 + 0.25 * random.uniform();
        let mut place = |low: f64| low + 0.15 + radius + (0.7 - 2.0 * radius) * random.uniform();
        Obstacle::disc(Point::new(place(x), place(y)), radius)
    })
}

/// Discs anywhere in a square, one for each square metre: some overlap.
pub fn piled_discs(count: usize) -> World {
    let side = (count as f64).sqrt();
    let mut random = Random::new(1, Stream::Scenario);
    let mut disc = || {
        let [x, y, size] = std::array::from_fn(|_| random.uniform());
        Obstacle::disc(Point::new(side * x, side * y), 0.05 + 0.4 * size)
    };
    let obstacles: Vec<Obstacle> = (0..count).map(|_| disc()).collect();
    World::new(Some(Aabb { min: Point::new(-0.5, -0.5), max: Point::new(side + 0.5, side + 0.5) }), obstacles)
}

/// An obstacle in each square metre of a square.
fn scattered(count: usize, mut obstacle: impl FnMut(&mut Random, f64, f64) -> Obstacle) -> World {
    let side = (count as f64).sqrt().ceil() as usize;
    let mut random = Random::new(1, Stream::Scenario);
    let obstacles: Vec<Obstacle> =
        (0..count).map(|i| obstacle(&mut random, (i % side) as f64, (i / side) as f64)).collect();
    let end = side as f64 + 0.5;
    World::new(Some(Aabb { min: Point::new(-0.5, -0.5), max: Point::new(end, end) }), obstacles)
}

fn rectangle([left, bottom]: [f64; 2], [right, top]: [f64; 2]) -> Obstacle {
    let corners = [[left, bottom], [right, bottom], [right, top], [left, top]].map(Point::from);
    Obstacle::polygon(&corners).expect("a rectangle")
}

/// A kind of polygon of many corners.
#[derive(Clone, Copy)]
pub enum Kind {
    /// Upright teeth: few edges are beside each other.
    Comb,
    /// Teeth to the side: half of all edges cross one vertical line.
    LyingComb,
    /// Alternating radii.
    Star,
    /// A band wound around the origin.
    Spiral,
    /// A round border with noise, as an outline of a scan has.
    Coast,
    /// A regular polygon: convex.
    Round,
}

impl Kind {
    pub const ALL: [Kind; 6] = [Kind::Comb, Kind::LyingComb, Kind::Star, Kind::Spiral, Kind::Coast, Kind::Round];

    pub fn name(self) -> &'static str {
        match self {
            Kind::Comb => "upright teeth",
            Kind::LyingComb => "teeth to the side",
            Kind::Star => "a star",
            Kind::Spiral => "a spiral",
            Kind::Coast => "a coast",
            Kind::Round => "round",
        }
    }

    /// The corners of a polygon within 100 m.
    pub fn corners(self, count: usize) -> Vec<Point> {
        let mut random = Random::new(1, Stream::Scenario);
        let around = |i: usize, radius: f64| {
            let (sin, cos) = (TAU * i as f64 / count as f64).sin_cos();
            Point::new(50.0 + radius * cos, 50.0 + radius * sin)
        };
        match self {
            Kind::Comb | Kind::LyingComb => {
                let teeth = |i: usize| {
                    let x = 100.0 * i as f64 / (count - 2) as f64;
                    let y = if i.is_multiple_of(2) { 10.0 } else { 40.0 + 60.0 * random.uniform() };
                    Point::new(x, y)
                };
                let mut corners: Vec<Point> = (0..count - 2).map(teeth).collect();
                corners.extend([Point::new(100.0, 0.0), Point::new(0.0, 0.0)]);
                if matches!(self, Kind::LyingComb) {
                    corners.iter_mut().for_each(|p| *p = Point::new(p.y, p.x));
                }
                corners
            }
            Kind::Star => (0..count).map(|i| around(i, if i.is_multiple_of(2) { 20.0 } else { 50.0 })).collect(),
            Kind::Spiral => {
                // Out on one side of the band and back on the other.
                let half = count / 2;
                let turns = (half as f64 / 40.0).sqrt().max(1.0);
                let at = |i: usize, aside: f64| {
                    let part = (i as f64 / half as f64).sqrt();
                    let (sin, cos) = (TAU * turns * part).sin_cos();
                    let radius = 49.0 / (turns + 1.0) * (turns * part + 0.6 + aside);
                    Point::new(50.0 + radius * cos, 50.0 + radius * sin)
                };
                let out = (0..half).map(|i| at(i, 0.0));
                out.chain((0..half).rev().map(|i| at(i, 0.4))).collect()
            }
            Kind::Coast => {
                let mut height = vec![0.0; count];
                // Sums of noise at every scale.
                let mut step = count.next_power_of_two() / 2;
                let mut size = 8.0;
                while step > 0 {
                    let knots: Vec<f64> = (0..=count.div_ceil(step)).map(|_| size * (random.uniform() - 0.5)).collect();
                    for (i, height) in height.iter_mut().enumerate() {
                        let part = (i % step) as f64 / step as f64;
                        *height += knots[i / step] * (1.0 - part) + knots[i / step + 1] * part;
                    }
                    (step, size) = (step / 2, size * 0.6);
                }
                (0..count).map(|i| around(i, 35.0 + height[i])).collect()
            }
            Kind::Round => (0..count).map(|i| around(i, 50.0)).collect(),
        }
    }
}

/// Obstacles with bounds around them.
pub fn around(obstacles: impl IntoIterator<Item = Obstacle>) -> World {
    World::new(Some(Aabb { min: Point::new(-60.0, -60.0), max: Point::new(160.0, 160.0) }), obstacles)
}

/// A region with a jagged side as rectangles of a metre, as one polygon with every corner, and as the rectangles' rows.
pub fn regions() -> Vec<(&'static str, World)> {
    // Half of the cells of the last column are missing.
    let width = |row: usize| if row.is_multiple_of(2) { 100 } else { 99 };
    let cells = (0..100).flat_map(|row| {
        (0..width(row)).map(move |column| {
            let [x, y] = [column, row].map(|i| i as f64);
            rectangle([x, y], [x + 1.0, y + 1.0])
        })
    });
    let rows = (0..100).map(|row| rectangle([0.0, row as f64], [width(row) as f64, row as f64 + 1.0]));
    let mut outline = vec![Point::new(0.0, 0.0)];
    for row in 0..100 {
        let x = width(row) as f64;
        outline.extend([Point::new(x, row as f64), Point::new(x, row as f64 + 1.0)]);
    }
    outline.push(Point::new(0.0, 100.0));
    let one = Obstacle::Polygon(Polygon::new(&outline).expect("a simple polygon"));
    vec![("9,950 squares", around(cells)), ("100 rows", around(rows)), ("one polygon of 202 corners", around([one]))]
}

/// The scenario of a robot that goes around a region.
pub fn past(world: &World, robot: impl Into<Robot>) -> Scenario {
    let robot = robot.into();
    let turns = matches!(robot, Robot::RigidBody(RigidBody { .. }));
    let place = |x: f64, y: f64| if turns { vec![x, y, 0.0] } else { vec![x, y] };
    Scenario::new("region", world.clone(), robot, [Query::new("past", place(-20.0, 50.0), place(120.0, 50.0))])
        .expect("a scenario")
}
