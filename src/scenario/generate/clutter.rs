//! Clutter: convex polygons scattered over a box of 2 m by 2 m, apart from each other, for a disc that crosses it or an arm
//! that stands in its middle.
//!
//! The corners of a polygon lie on a circle, evenly spaced but for a random shift of up to a fifth of their spacing. A path
//! need not exist.

use super::free::{are_apart, is_clear_of};
use super::{check_seed, integer, no_place, out_of_range, seed};
use crate::error::{Code, Error};
use crate::geometry::{Aabb, Point, Polygon};
use crate::random::{Random, Stream};
use crate::robot::{Arm, DiscRobot, MAX_LINKS};
use crate::scenario::reader::{Fields, Reader, quoted};
use crate::scenario::{Node, Obstacle, Query, Robot, Scenario, World};
use std::f64::consts::TAU;

/// After so many draws the generator gives up.
const DRAWS: u32 = 10_000;

/// The side of the box, in metres.
const SIDE: f64 = 2.0;

/// How far the arm reaches from the middle of the box, in metres; with the largest radius it stays inside.
const REACH: f64 = 0.8;

/// The most polygons.
const MAX_COUNT: usize = 60;

/// The range of the robot's radius, in metres.
const RADII: [f64; 2] = [0.0, 0.1];

/// The range of the circles that polygons lie in: their radii in metres.
const SIZES: [f64; 2] = [0.02, 0.5];

/// The range of the gap, in metres.
const GAPS: [f64; 2] = [0.0, 0.2];

/// The robot in the clutter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ClutterRobot {
    /// A disc that crosses the box from corner to corner.
    Disc,
    /// An arm of so many equal links, 1 to 8, in the middle of the box.
    Arm(usize),
}

/// What clutter to make. As a document: `robot` ("disc" or "arm"), `links` (arms only, default 2), and the rest by name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClutterOptions {
    /// The robot (default: a disc).
    pub robot: ClutterRobot,
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
        Self { robot: ClutterRobot::Disc, count: 14, radius: 0.03, smallest: 0.08, largest: 0.2, gap: 0.05, seed: 0 }
    }
}

impl ClutterOptions {
    /// Reads the options by their names; all may be left out.
    pub(super) fn from_node(options: &Node) -> Result<Self, Error> {
        let root = Reader::root(options);
        let fields = root.object()?;
        fields.only(&["robot", "links", "count", "radius", "smallest", "largest", "gap", "seed"])?;
        let default = Self::default();
        let number =
            |name: &'static str, default: f64| fields.optional(name).map_or(Ok(default), |field| field.number());
        let made = Self {
            robot: read_robot(&fields)?,
            count: integer(&fields, "count", "the number of polygons", [0, MAX_COUNT as u64], default.count as u64)?
                as usize,
            radius: number("radius", default.radius)?,
            smallest: number("smallest", default.smallest)?,
            largest: number("largest", default.largest)?,
            gap: number("gap", default.gap)?,
            seed: seed(&fields)?,
        };
        made.check()?;
        Ok(made)
    }

    fn check(&self) -> Result<(), Error> {
        if let ClutterRobot::Arm(links) = self.robot
            && !(1..=MAX_LINKS).contains(&links)
        {
            return Err(out_of_range("links", "the number of links", 1, MAX_LINKS, links));
        }
        if self.count > MAX_COUNT {
            return Err(out_of_range("count", "the number of polygons", 0, MAX_COUNT, self.count));
        }
        let lengths = [
            ("radius", "the radius of the robot", self.radius, RADII),
            ("smallest", "the size of the smallest polygon", self.smallest, [SIZES[0], self.largest.min(SIZES[1])]),
            ("largest", "the size of the largest polygon", self.largest, SIZES),
            ("gap", "the gap between polygons", self.gap, GAPS),
        ];
        for (option, what, value, [low, high]) in lengths {
            if !value.is_finite() {
                let sentence = format!("{what} must be a finite number, not {value}");
                return Err(Error::new(Code::NotFinite, format!("/{option}"), sentence));
            }
            if !(low..=high).contains(&value) {
                return Err(out_of_range(option, what, low, high, value));
            }
        }
        check_seed(self.seed)
    }
}

fn read_robot(fields: &Fields) -> Result<ClutterRobot, Error> {
    let links = fields.optional("links");
    let Some(robot) = fields.optional("robot") else {
        return refuse_links(links);
    };
    match robot.string()? {
        "disc" => refuse_links(links),
        "arm" => {
            let links = integer(fields, "links", "the number of links", [1, MAX_LINKS as u64], 2)?;
            Ok(ClutterRobot::Arm(links as usize))
        }
        other => {
            let sentence = format!("clutter has no robot {}; there are disc and arm", quoted(other));
            Err(robot.error(Code::UnknownType, sentence))
        }
    }
}

fn refuse_links(links: Option<Reader>) -> Result<ClutterRobot, Error> {
    match links {
        Some(links) => Err(links.error(Code::UnknownField, "a disc has no links; say \"robot\": \"arm\" for an arm")),
        None => Ok(ClutterRobot::Disc),
    }
}

/// Makes clutter, with one query, "across".
///
/// # Errors
/// `out-of-range` or `not-finite` with the pointer of the option; `out-of-range` at `/count` where the polygons find no place
/// within 10,000 draws.
pub fn clutter(options: &ClutterOptions) -> Result<Scenario, Error> {
    options.check()?;
    let (robot, query) = robot_and_query(options)?;
    let keep_clear = [&query.start, &query.goal].map(|q| match &robot {
        Robot::Arm(arm) => arm.footprint(q),
        Robot::Disc(disc) => disc.footprint(q),
    });
    let keep_clear = keep_clear.concat();
    let mut random = Random::new(options.seed, Stream::Scenario);
    let mut placed: Vec<Polygon> = Vec::with_capacity(options.count);
    for _ in 0..DRAWS {
        if placed.len() == options.count {
            break;
        }
        let polygon = draw(&mut random, options);
        if is_clear_of(&polygon, &keep_clear, options.gap) && placed.iter().all(|p| are_apart(p, &polygon, options.gap))
        {
            placed.push(polygon);
        }
    }
    if placed.len() < options.count {
        return Err(no_place("count", placed.len(), options.count, DRAWS));
    }
    let (kind, who) = match options.robot {
        ClutterRobot::Disc => ("disc".to_owned(), "Disc".to_owned()),
        ClutterRobot::Arm(links) => (format!("{links}r"), format!("{links}R arm")),
    };
    let (count, seed) = (options.count, options.seed);
    let bounds = Some(Aabb { min: Point::origin(), max: Point::new(SIDE, SIDE) });
    Ok(Scenario {
        name: format!("clutter-{kind}-{count}-{seed}"),
        title: Some(format!("{who} among {count} convex polygons, seed {seed}")),
        world: World { bounds, obstacles: placed.into_iter().map(Obstacle::Polygon).collect() },
        robot,
        queries: vec![query],
    })
}

/// The robot, and from where to where it shall go: a disc between opposite corners, an arm from one side to the other.
fn robot_and_query(options: &ClutterOptions) -> Result<(Robot, Query), Error> {
    let (robot, start, goal) = match options.robot {
        ClutterRobot::Disc => {
            (Robot::Disc(DiscRobot::new(options.radius)?), vec![0.2, 0.2], vec![SIDE - 0.2, SIDE - 0.2])
        }
        ClutterRobot::Arm(links) => {
            let base = Point::new(SIDE / 2.0, SIDE / 2.0);
            let arm = Arm::new(base, vec![REACH / links as f64; links], options.radius, None)?;
            let bent = |first: f64, rest: f64| (0..links).map(|i| if i == 0 { first } else { rest }).collect();
            (Robot::Arm(arm), bent(0.5, 0.3), bent(-2.6, -0.3))
        }
    };
    Ok((robot, Query { name: "across".to_owned(), start, goal }))
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
    Polygon::new(&corners)
        .expect("points in order on a circle, none closer than a tenth of a turn, bound a convex polygon")
}
