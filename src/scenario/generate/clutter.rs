//! Clutter: convex polygons scattered over a box of 2 m by 2 m, apart from each other, for a robot that crosses it or an arm
//! that stands in its middle.
//!
//! The corners of a polygon lie on a circle, evenly spaced but for a random shift of up to a fifth of their spacing. A path
//! need not exist.

use super::free::{are_apart, is_clear_of, polygon};
use super::no_place;
use super::robots::{RobotChoice, SIDE, parts_at_ends};
use super::{Generator, SEEDS};
use crate::error::Error;
use crate::geometry::{Aabb, Point, Polygon};
use crate::options::{Options, out_of_range};
use crate::random::{Random, Stream};
use crate::scenario::{Obstacle, Scenario, World};
use std::f64::consts::TAU;

/// After so many draws the generator gives up.
const DRAWS: u32 = 10_000;

crate::options! {
    /// What clutter to make.
    pub struct ClutterOptions for &[];
    /// What moves.
    robot: RobotChoice = RobotChoice::Disc, "Robot";
    /// How many links the arm has; for an arm only.
    links: usize = 2, in 1.0..=8.0, "Links";
    /// The radius of the disc, or half the width of the arm's links; not for a body or a car.
    radius: f64 = 0.03, in 0.0..=0.1, "Radius of the robot", unit "m";
    /// How many polygons.
    count: usize = 14, in 0.0..=60.0, "Obstacles";
    /// The radius of the smallest circle that a polygon may fill, at most `largest`.
    smallest: f64 = 0.08, in 0.02..=0.5, "Smallest", unit "m";
    /// The radius of the largest such circle.
    largest: f64 = 0.2, in 0.02..=0.5, "Largest", unit "m";
    /// Polygons are farther than this from each other, and from the robot at its start and its goal.
    gap: f64 = 0.05, in 0.0..=0.2, "Gap", unit "m";
    /// The seed: 0 (default) to 2^53 - 1.
    seed: u64 = 0, in SEEDS;
}

impl Generator for ClutterOptions {
    const ID: &'static str = "clutter";
    const TITLE: &'static str = "Clutter";
    const SUMMARY: &'static str =
        "Convex polygons scattered over a box, for a robot that crosses it or an arm in its middle.";

    fn generate(&self) -> Result<Scenario, Error> {
        clutter(self)
    }
}

impl ClutterOptions {
    fn check_all(&self) -> Result<(), Error> {
        let Self { smallest, largest, .. } = *self;
        self.check()?;
        if smallest > largest {
            return Err(out_of_range(
                "smallest",
                format!("smallest must be at most largest, {largest}, not {smallest}"),
            ));
        }
        Ok(())
    }
}

/// Makes clutter, with one query, "across".
///
/// # Errors
/// `out-of-range` or `not-finite` with the pointer of the option; `out-of-range` at `/count` where the polygons find no place
/// within 10,000 draws.
pub fn clutter(options: &ClutterOptions) -> Result<Scenario, Error> {
    options.check_all()?;
    let (robot, query) = options.robot.across(options.links, options.radius)?;
    let keep_clear = parts_at_ends(&robot, &query);
    let mut random = Random::new(options.seed, Stream::Scenario);
    let mut placed: Vec<Polygon> = Vec::with_capacity(options.count);
    for _ in 0..DRAWS {
        if placed.len() == options.count {
            break;
        }
        let drawn = draw(&mut random, options);
        if is_clear_of(&drawn, &keep_clear, options.gap) && placed.iter().all(|p| are_apart(p, &drawn, options.gap)) {
            placed.push(drawn);
        }
    }
    if placed.len() < options.count {
        return Err(no_place("count", placed.len(), options.count, DRAWS));
    }
    let (count, seed) = (options.count, options.seed);
    let bounds = Some(Aabb { min: Point::origin(), max: Point::new(SIDE, SIDE) });
    Ok(Scenario {
        name: format!("clutter-{}-{count}-{seed}", options.robot.id(options.links)),
        title: Some(format!("{} among {count} convex polygons, seed {seed}", options.robot.title(options.links))),
        world: World { bounds, obstacles: placed.into_iter().map(Obstacle::Polygon).collect() },
        robot,
        queries: vec![query],
    })
}

/// A convex polygon of 3 to 7 corners somewhere in the box.
fn draw(random: &mut Random, options: &ClutterOptions) -> Polygon {
    let size = options.smallest + random.uniform() * (options.largest - options.smallest);
    let place = |u: f64| size + u * (SIDE - 2.0 * size);
    let center = (place(random.uniform()), place(random.uniform()));
    let corners = 3 + random.below(5);
    let turn = TAU * random.uniform();
    let corner = |i: u64| {
        let shift = 0.4 * (random.uniform() - 0.5);
        let (sin, cos) = libm::sincos(turn + TAU * (i as f64 + shift) / corners as f64);
        Point::new(center.0 + size * cos, center.1 + size * sin)
    };
    let corners: Vec<Point> = (0..corners).map(corner).collect();
    // Points in order on a circle, none closer than a tenth of a turn, bound a convex polygon.
    polygon(&corners)
}
