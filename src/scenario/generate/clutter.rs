//! Clutter: convex polygons scattered over a box of 2 m by 2 m, apart from each other, for a robot that crosses it or an arm
//! that stands in its middle.
//!
//! The corners of a polygon lie on a circle, evenly spaced but for a random shift of up to a fifth of their spacing. A path
//! need not exist.

use super::free::{are_apart, is_clear_of, polygon};
use super::no_place;
use super::options::{GeneratorInfo, Given, OptionInfo, OptionKind, refused};
use super::robots::{LINKS, RADIUS, ROBOT, RobotChoice, SIDE, parts_at_ends};
use crate::decimal::Decimal;
use crate::error::Error;
use crate::geometry::{Aabb, Point, Polygon};
use crate::random::{Random, Stream};
use crate::scenario::reader::Reader;
use crate::scenario::{Node, Obstacle, Scenario, World};
use std::f64::consts::TAU;

/// After so many draws the generator gives up.
const DRAWS: u32 = 10_000;

/// The row of the generator.
pub(super) const INFO: GeneratorInfo = GeneratorInfo {
    id: "clutter",
    title: "Clutter",
    summary: "Convex polygons scattered over a box, for a robot that crosses it or an arm in its middle.",
    options: &[
        ROBOT,
        LINKS,
        RADIUS,
        OptionInfo {
            name: "count",
            title: "Obstacles",
            kind: OptionKind::Integer { min: 0.0, max: 60.0, default: 14.0 },
            unit: "",
            meaning: "How many polygons.",
        },
        OptionInfo {
            name: "smallest",
            title: "Smallest",
            kind: OptionKind::Number { min: 0.02, max: 0.5, default: 0.08 },
            unit: "m",
            meaning: "The radius of the smallest circle that a polygon may fill, at most `largest`.",
        },
        OptionInfo {
            name: "largest",
            title: "Largest",
            kind: OptionKind::Number { min: 0.02, max: 0.5, default: 0.2 },
            unit: "m",
            meaning: "The radius of the largest such circle.",
        },
        OptionInfo {
            name: "gap",
            title: "Gap",
            kind: OptionKind::Number { min: 0.0, max: 0.2, default: 0.05 },
            unit: "m",
            meaning: "Polygons are farther than this from each other, and from the robot at its start and its goal.",
        },
    ],
};

/// What clutter to make. As a document: `robot` ("disc", "arm", "rigid_body" or "car"), `links` (arms only, default 2), and the rest by name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClutterOptions {
    /// The robot (default: a disc); an arm has 1 to 8 links.
    pub robot: RobotChoice,
    /// How many polygons: 0 to 60 (default 14).
    pub count: usize,
    /// The robot's radius in metres: 0 to 0.1 (default 0.03).
    pub radius: f64,
    /// The radius of the smallest circle that a polygon may fill, in metres: 0.02 to `largest` (default 0.08).
    pub smallest: f64,
    /// The radius of the largest such circle, in metres: `smallest` to 0.5 (default 0.2).
    pub largest: f64,
    /// Polygons are farther than this from each other, and from the robot at its start and its goal, in metres: 0 to 0.2
    /// (default 0.05).
    pub gap: f64,
    /// The seed: 0 (default) to 2^53 - 1.
    pub seed: u64,
}

impl Default for ClutterOptions {
    fn default() -> Self {
        Self { robot: RobotChoice::Disc, count: 14, radius: 0.03, smallest: 0.08, largest: 0.2, gap: 0.05, seed: 0 }
    }
}

impl ClutterOptions {
    /// Reads the options by their names; all may be left out.
    pub(super) fn from_node(options: &Node) -> Result<Self, Error> {
        let root = Reader::root(options);
        let given = Given::read(&INFO, &root)?;
        Ok(Self {
            robot: RobotChoice::read(&given)?,
            count: given.integer("count")?,
            radius: given.number("radius")?,
            smallest: given.number("smallest")?,
            largest: given.number("largest")?,
            gap: given.number("gap")?,
            seed: given.seed()?,
        })
    }

    fn check(&self) -> Result<(), Error> {
        let Self { radius, count, smallest, largest, gap, .. } = *self;
        let mut values = vec![("radius", radius), ("count", count as f64), ("gap", gap)];
        values.extend([("smallest", smallest), ("largest", largest)]);
        values.extend(self.robot.links());
        INFO.check(self.seed, &values)?;
        if smallest > largest {
            let [smallest, largest] = [smallest, largest].map(Decimal);
            return Err(refused("smallest", format!("smallest must be at most largest, {largest}, not {smallest}")));
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
    options.check()?;
    let (robot, query) = options.robot.across(options.radius)?;
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
        name: format!("clutter-{}-{count}-{seed}", options.robot.id()),
        title: Some(format!("{} among {count} convex polygons, seed {seed}", options.robot.title())),
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
