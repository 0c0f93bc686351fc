//! Bodies, worlds and motions of many kinds, by seed.

use parry2d_f64::math::Vector;
use parry2d_f64::shape::Polyline;
use planarium::collision::BodyMotion;
use planarium::geometry::{
    Aabb, Disc, Point, Polygon, Segment, distance_point_polygon, distance_point_segment, distance_polygon_polygon,
    distance_segment_polygon, intersects_polygon_polygon,
};
use planarium::random::Random;
use planarium::robot::Part;
use planarium::scenario::{Obstacle, World};
use std::f64::consts::{PI, TAU};

pub fn p(x: f64, y: f64) -> Point {
    Point::new(x, y)
}

pub fn polygon(corners: &[[f64; 2]]) -> Polygon {
    Polygon::new(&corners.iter().map(|&[x, y]| p(x, y)).collect::<Vec<_>>()).expect("a simple polygon")
}

pub fn rectangle(low: [f64; 2], high: [f64; 2]) -> Polygon {
    polygon(&[low, [high[0], low[1]], high, [low[0], high[1]]])
}

pub fn world(low: [f64; 2], high: [f64; 2], obstacles: Vec<Obstacle>) -> World {
    let bounds = Aabb { min: p(low[0], low[1]), max: p(high[0], high[1]) };
    World { bounds: Some(bounds), obstacles: obstacles.into() }
}

pub fn straight(from: [f64; 3], to: [f64; 3]) -> BodyMotion {
    BodyMotion::Straight { from, delta: [0, 1, 2].map(|i| to[i] - from[i]) }
}

pub fn arc(from: [f64; 3], speed: f64, turn_rate: f64, duration: f64) -> BodyMotion {
    BodyMotion::Arc { from, speed, turn_rate, duration }
}

/// Corners on a circle.
pub fn round(center: Point, radius: f64, corners: usize, turn: f64) -> Vec<Point> {
    (0..corners)
        .map(|i| {
            let (sin, cos) = libm::sincos(turn + TAU * i as f64 / corners as f64);
            p(center.x + radius * cos, center.y + radius * sin)
        })
        .collect()
}

/// Corners with dents between them.
pub fn star(center: Point, size: f64, corners: usize, turn: f64) -> Vec<Point> {
    let (points, dents) =
        (round(center, size, corners, turn), round(center, 0.3 * size, corners, turn + PI / corners as f64));
    points.into_iter().zip(dents).flat_map(|(point, dent)| [point, dent]).collect()
}

/// A polygon with corners all round a centre, most often concave.
pub fn random_star(random: &mut Random, side: f64) -> Polygon {
    let center = p(side * (random.uniform() - 0.5), side * (random.uniform() - 0.5));
    let corners = 3 + random.below(20);
    let corner = |i| {
        let (sin, cos) = libm::sincos(TAU * (i as f64 + 0.9 * random.uniform()) / corners as f64);
        let radius = side * (0.02 + 0.4 * random.uniform());
        p(center.x + radius * cos, center.y + radius * sin)
    };
    let corners: Vec<Point> = (0..corners).map(corner).collect();
    Polygon::new(&corners).expect("corners in order round a centre")
}

/// The border of a polygon, as parry knows it.
pub fn border(polygon: &Polygon) -> Polyline {
    let n = polygon.vertices().len() as u32;
    let corners = polygon.vertices().iter().map(|v| Vector::new(v.x, v.y)).collect();
    Polyline::new(corners, Some((0..n).map(|i| [i, (i + 1) % n]).collect()))
}

/// Corners given along two axes through the centre, turned.
pub fn drawn(center: Point, turn: f64, corners: &[[f64; 2]]) -> Vec<Point> {
    let (sin, cos) = libm::sincos(turn);
    corners.iter().map(|&[u, v]| p(center.x + u * cos - v * sin, center.y + u * sin + v * cos)).collect()
}

/// A rectangle, half its length and half its width.
fn bar(u: f64, v: f64) -> [[f64; 2]; 4] {
    [[-u, -v], [u, -v], [u, v], [-u, v]]
}

/// A U that is open upwards, walls of the given thickness.
pub fn u_shape(size: f64, thickness: f64) -> [[f64; 2]; 8] {
    let (a, t) = (size, thickness);
    [[-a, -a], [a, -a], [a, a], [a - t, a], [a - t, t - a], [t - a, t - a], [t - a, a], [-a, a]]
}

/// An obstacle of a random kind and size: convex, a wall down to a millionth thick, a disc, a concave star, a U.
pub fn random_obstacle(random: &mut Random, center: Point, scale: f64) -> Obstacle {
    let (size, turn) = (scale * (0.03 + 0.2 * random.uniform()), 6.0 * random.uniform());
    let corners = match random.below(6) {
        0 => round(center, size, 3, turn),
        1 => round(center, size, 4 + random.below(6) as usize, turn),
        2 => {
            let (u, v) = (3.0 * size, scale * libm::pow(10.0, -1.5 - 4.5 * random.uniform()) / 2.0);
            drawn(center, turn, &bar(u, v))
        }
        3 => return Obstacle::Disc(Disc { center, radius: size }),
        4 => star(center, size, 3 + random.below(4) as usize, turn),
        _ => drawn(center, turn, &u_shape(2.0 * size, size * (0.001 + 0.3 * random.uniform()))),
    };
    Obstacle::Polygon(Polygon::new(&corners).expect("a simple polygon"))
}

/// A body of a random kind, its frame in its middle, at its end or far off.
pub fn random_body(random: &mut Random, scale: f64) -> Polygon {
    let size = scale * [0.02, 0.1, 0.2][random.below(3) as usize] * (0.5 + random.uniform());
    let off = [0.0, 1.0, 3.0][random.below(3) as usize] * size;
    let (center, turn) = (p(off * random.uniform(), off * random.uniform()), 6.0 * random.uniform());
    let corners = match random.below(6) {
        0 => drawn(center, 0.0, &bar(size, 0.5 * size)),
        1 => drawn(center, turn, &bar(size, 0.01 * size)),
        2 => round(center, size, 3 + random.below(6) as usize, turn),
        3 => drawn(
            center,
            turn,
            &[[0.0, 0.0], [size, 0.0], [size, 0.2 * size], [0.2 * size, 0.2 * size], [0.2 * size, size], [0.0, size]],
        ),
        4 => star(center, size, 3 + random.below(3) as usize, turn),
        _ => drawn(center, turn, &u_shape(size, 0.2 * size)),
    };
    Polygon::new(&corners).expect("a simple polygon")
}

/// A body in any unit of length among up to sixty obstacles.
pub fn random_world(random: &mut Random) -> (Polygon, World, f64) {
    let scale = [1.0, 1.0, 1e-3, 1e3, 1e5][random.below(5) as usize];
    let body = random_body(random, scale);
    let count = [0, 2, 8, 20, 60][random.below(5) as usize];
    let obstacles = (0..count)
        .map(|_| {
            let center = p(scale * 2.0 * random.uniform(), scale * 2.0 * random.uniform());
            random_obstacle(random, center, scale * if count > 10 { 0.5 } else { 1.0 })
        })
        .collect();
    (body, world([0.0, 0.0], [2.0 * scale, 2.0 * scale], obstacles), scale)
}

pub fn random_placement(random: &mut Random, scale: f64) -> [f64; 3] {
    let theta = if random.below(2) == 0 { TAU * random.uniform() - PI } else { TAU * random.uniform() };
    [2.0 * scale * random.uniform(), 2.0 * scale * random.uniform(), theta]
}

/// A motion of any kind from the placement: straight, straight without a turn, an arc of any radius, forward or back, several
/// turns of one, turning in place.
pub fn random_motion(random: &mut Random, from: [f64; 3], scale: f64) -> BodyMotion {
    let mut draw = |size: f64| size * (2.0 * random.uniform() - 1.0);
    let length = scale * draw(1.0) * draw(1.0);
    let (x, y, turn, seconds) = (draw(1.0), draw(1.0), draw(3.1), 0.1 + draw(1.0).abs());
    match random.below(6) {
        0 => BodyMotion::Straight { from, delta: [length * x, length * y, turn] },
        1 => BodyMotion::Straight { from, delta: [length * x, length * y, 0.1 * turn] },
        2 => BodyMotion::Straight { from, delta: [length * x, length * y, 0.0] },
        3 => arc(from, length / seconds, turn / seconds, seconds),
        4 => arc(from, 0.5 * length, 20.0 * turn, 30.0 * seconds),
        _ => arc(from, 0.0, turn * x, seconds),
    }
}

/// The corners of the body at `q`.
pub fn placed(body: &Polygon, q: &[f64; 3]) -> Vec<Point> {
    let (sin, cos) = libm::sincos(q[2]);
    let corner = |v: &Point| p(q[0] + cos * v.x - sin * v.y, q[1] + sin * v.x + cos * v.y);
    body.vertices().iter().map(corner).collect()
}

/// Whether the body touches an obstacle at `q`, by exact tests.
pub fn touches(body: &Polygon, world: &World, q: &[f64; 3]) -> bool {
    let Ok(placed) = Polygon::new(&placed(body, q)) else { return false };
    world.obstacles.iter().any(|obstacle| match obstacle {
        Obstacle::Polygon(polygon) => intersects_polygon_polygon(&placed, polygon),
        Obstacle::Disc(disc) => distance_point_polygon(disc.center, &placed) <= disc.radius,
        Obstacle::PolygonWithHoles(_) | Obstacle::Wall(_) => obstacle.distance_to_polygon(&placed) <= 0.0,
    })
}

/// The distance from the nearest part to the nearest obstacle.
pub fn clearance(parts: &[Part], world: &World) -> f64 {
    let pairs = parts.iter().flat_map(|part| world.obstacles.iter().map(move |obstacle| part_distance(part, obstacle)));
    pairs.fold(f64::INFINITY, f64::min)
}

/// The distance from a part to an obstacle by the crate's own functions.
pub fn part_distance(part: &Part, obstacle: &Obstacle) -> f64 {
    match (part, obstacle) {
        (Part::Capsule { a, b, radius }, Obstacle::PolygonWithHoles(_) | Obstacle::Wall(_)) => {
            obstacle.distance_to_segment(&Segment::new(*a, *b)) - radius
        }
        (Part::Disc { center, radius }, Obstacle::PolygonWithHoles(_) | Obstacle::Wall(_)) => {
            obstacle.distance_to_segment(&Segment::new(*center, *center)) - radius
        }
        (Part::Capsule { a, b, radius }, Obstacle::Polygon(polygon)) => {
            distance_segment_polygon(&Segment::new(*a, *b), polygon) - radius
        }
        (Part::Capsule { a, b, radius }, Obstacle::Disc(disc)) => {
            distance_point_segment(disc.center, &Segment::new(*a, *b)) - radius - disc.radius
        }
        (Part::Disc { center, radius }, Obstacle::Polygon(polygon)) => {
            distance_point_polygon(*center, polygon) - radius
        }
        (Part::Disc { center, radius }, Obstacle::Disc(disc)) => (center - disc.center).norm() - radius - disc.radius,
        (Part::Polygon { vertices }, obstacle) => {
            let body = Polygon::new(vertices).expect("a placed polygon");
            match obstacle {
                Obstacle::Polygon(polygon) => distance_polygon_polygon(&body, polygon),
                Obstacle::Disc(disc) => distance_point_polygon(disc.center, &body) - disc.radius,
                Obstacle::PolygonWithHoles(_) | Obstacle::Wall(_) => obstacle.distance_to_polygon(&body),
            }
        }
    }
}
