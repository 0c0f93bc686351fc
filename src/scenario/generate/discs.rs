//! Discs: round obstacles scattered over a box of 2 m by 2 m, for a robot that crosses it or an arm that stands in its middle.
//!
//! A path exists where a disc moves among discs that stand apart by at least twice its radius (grown by that radius they
//! stay apart, and none is large enough to close a corner off); in general it need not.

use super::free::{SOME, is_disc_clear_of};
use super::no_place;
use super::options::{GeneratorInfo, Given, OptionInfo, OptionKind, refused};
use super::robots::{LINKS, RADIUS, ROBOT, RobotChoice, SIDE, parts_at_ends};
use crate::decimal::Decimal;
use crate::error::Error;
use crate::geometry::{Aabb, Disc, Point};
use crate::random::{Random, Stream};
use crate::scenario::reader::Reader;
use crate::scenario::{Node, Obstacle, Scenario, World};

/// After so many draws the generator gives up.
const DRAWS: u32 = 10_000;

/// The row of the generator.
pub(super) const INFO: GeneratorInfo = GeneratorInfo {
    id: "discs",
    title: "Discs",
    summary: "Discs scattered over a box, for a robot that crosses it or an arm in its middle.",
    options: &[
        ROBOT,
        LINKS,
        RADIUS,
        OptionInfo {
            name: "count",
            title: "Obstacles",
            kind: OptionKind::Integer { min: 0.0, max: 200.0, default: 24.0 },
            unit: "",
            meaning: "How many discs.",
        },
        OptionInfo {
            name: "smallest",
            title: "Smallest",
            kind: OptionKind::Number { min: 0.01, max: 0.5, default: 0.05 },
            unit: "m",
            meaning: "The least radius of a disc, at most `largest`.",
        },
        OptionInfo {
            name: "largest",
            title: "Largest",
            kind: OptionKind::Number { min: 0.01, max: 0.5, default: 0.18 },
            unit: "m",
            meaning: "The greatest radius of a disc.",
        },
        OptionInfo {
            name: "gap",
            title: "Gap",
            kind: OptionKind::Number { min: 0.0, max: 0.2, default: 0.07 },
            unit: "m",
            meaning: "Discs are farther than this from the robot at its start and its goal and, where they stand apart, from each other.",
        },
        OptionInfo {
            name: "placement",
            title: "Placement",
            kind: OptionKind::Choice(&["apart", "overlapping"]),
            unit: "",
            meaning: "Whether discs stand apart or may overlap.",
        },
    ],
};

/// How discs lie to each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Placement {
    /// Farther from each other than the gap.
    Apart,
    /// Anyhow.
    Overlapping,
}

/// Which discs to scatter. As a document: `robot` ("disc", "arm", "rigid_body" or "car"), `links` (arms only, default 2), `placement` ("apart" or
/// "overlapping"), and the rest by name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DiscsOptions {
    /// The robot (default: a disc); an arm has 1 to 8 links.
    pub robot: RobotChoice,
    /// The robot's radius in metres: 0 to 0.1 (default 0.03).
    pub radius: f64,
    /// How many discs: 0 to 200 (default 24).
    pub count: usize,
    /// The least radius of a disc, in metres: 0.01 to `largest` (default 0.05).
    pub smallest: f64,
    /// The greatest radius of a disc, in metres: `smallest` to 0.5 (default 0.18).
    pub largest: f64,
    /// Discs are farther than this from the robot at its start and its goal and, where they stand apart, from each other, in
    /// metres: 0 to 0.2 (default 0.07).
    pub gap: f64,
    /// Whether discs may overlap (default: they stand apart).
    pub placement: Placement,
    /// The seed: 0 (default) to 2^53 - 1.
    pub seed: u64,
}

impl Default for DiscsOptions {
    fn default() -> Self {
        Self {
            robot: RobotChoice::Disc,
            radius: 0.03,
            count: 24,
            smallest: 0.05,
            largest: 0.18,
            gap: 0.07,
            placement: Placement::Apart,
            seed: 0,
        }
    }
}

impl DiscsOptions {
    /// Reads the options by their names; all may be left out.
    pub(super) fn from_node(options: &Node) -> Result<Self, Error> {
        let root = Reader::root(options);
        let given = Given::read(&INFO, &root)?;
        Ok(Self {
            robot: RobotChoice::read(&given)?,
            radius: given.number("radius")?,
            count: given.integer("count")?,
            smallest: given.number("smallest")?,
            largest: given.number("largest")?,
            gap: given.number("gap")?,
            placement: [Placement::Apart, Placement::Overlapping][given.choice("placement")?],
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

/// Scatters discs, with one query, "across".
///
/// # Errors
/// `out-of-range` or `not-finite` with the pointer of the option; `out-of-range` at `/count` where the discs find no place
/// within 10,000 draws.
pub fn discs(options: &DiscsOptions) -> Result<Scenario, Error> {
    options.check()?;
    let DiscsOptions { robot: choice, count, gap, seed, .. } = *options;
    let (robot, query) = choice.across(options.radius)?;
    let keep_clear = parts_at_ends(&robot, &query);
    let mut random = Random::new(seed, Stream::Scenario);
    let mut placed: Vec<Disc> = Vec::with_capacity(count);
    for _ in 0..DRAWS {
        if placed.len() == count {
            break;
        }
        let disc = draw(&mut random, options);
        let is_apart =
            |other: &Disc| nalgebra::distance(&disc.center, &other.center) - disc.radius - other.radius > gap + SOME;
        if is_disc_clear_of(&disc, &keep_clear, gap)
            && (options.placement == Placement::Overlapping || placed.iter().all(is_apart))
        {
            placed.push(disc);
        }
    }
    if placed.len() < count {
        return Err(no_place("count", placed.len(), count, DRAWS));
    }
    let bounds = Some(Aabb { min: Point::origin(), max: Point::new(SIDE, SIDE) });
    Ok(Scenario {
        name: format!("discs-{}-{count}-{seed}", choice.id()),
        title: Some(format!("{} among {count} discs, seed {seed}", choice.title())),
        world: World { bounds, obstacles: placed.into_iter().map(Obstacle::Disc).collect() },
        robot,
        queries: vec![query],
    })
}

/// A disc somewhere in the box.
fn draw(random: &mut Random, options: &DiscsOptions) -> Disc {
    let radius = options.smallest + random.uniform() * (options.largest - options.smallest);
    let mut place = || radius + random.uniform() * (SIDE - 2.0 * radius);
    let (x, y) = (place(), place());
    Disc { center: Point::new(x, y), radius }
}
