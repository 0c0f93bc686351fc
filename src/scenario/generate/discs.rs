//! Discs: round obstacles scattered over a box of 2 m by 2 m, for a robot that crosses it or an arm that stands in its middle.
//!
//! A path exists where a disc moves among discs that stand apart by at least twice its radius (grown by that radius they
//! stay apart, and none is large enough to close a corner off); in general it need not.

use super::free::{SOME, is_disc_clear_of};
use super::no_place;
use super::robots::{RobotChoice, SIDE, parts_at_ends};
use super::{Generator, SEEDS};
use crate::error::Error;
use crate::geometry::{Aabb, Disc, Point};
use crate::options::{Options, out_of_range};
use crate::random::{Random, Stream};
use crate::scenario::{Obstacle, Scenario, World};

/// After so many draws the generator gives up.
const DRAWS: u32 = 10_000;

crate::choice! {
    /// How discs lie to each other.
    pub enum Placement {
        /// Farther from each other than the gap.
        Apart,
        /// Anyhow.
        Overlapping,
    }
}

crate::options! {
    /// Which discs to scatter.
    pub struct DiscsOptions for &[];
    /// What moves.
    robot: RobotChoice = RobotChoice::Disc, "Robot";
    /// How many links the arm has; for an arm only.
    links: usize = 2, in 1.0..=8.0, "Links";
    /// The radius of the disc, or half the width of the arm's links; not for a body or a car.
    radius: f64 = 0.03, in 0.0..=0.1, "Radius of the robot", unit "m";
    /// How many discs.
    count: usize = 24, in 0.0..=200.0, "Obstacles";
    /// The least radius of a disc, at most `largest`.
    smallest: f64 = 0.05, in 0.01..=0.5, "Smallest", unit "m";
    /// The greatest radius of a disc.
    largest: f64 = 0.18, in 0.01..=0.5, "Largest", unit "m";
    /// Discs are farther than this from the robot at its start and its goal and, where they stand apart, from each other.
    gap: f64 = 0.07, in 0.0..=0.2, "Gap", unit "m";
    /// Whether discs stand apart or may overlap.
    placement: Placement = Placement::Apart, "Placement";
    /// The seed: 0 (default) to 2^53 - 1.
    seed: u64 = 0, in SEEDS;
}

impl Generator for DiscsOptions {
    const ID: &'static str = "discs";
    const TITLE: &'static str = "Discs";
    const SUMMARY: &'static str = "Discs scattered over a box, for a robot that crosses it or an arm in its middle.";

    fn generate(&self) -> Result<Scenario, Error> {
        discs(self)
    }
}

impl DiscsOptions {
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

/// Scatters discs, with one query, "across".
///
/// # Errors
/// `out-of-range` or `not-finite` with the pointer of the option; `out-of-range` at `/count` where the discs find no place
/// within 10,000 draws.
pub fn discs(options: &DiscsOptions) -> Result<Scenario, Error> {
    options.check_all()?;
    let DiscsOptions { robot: choice, links, count, gap, seed, .. } = *options;
    let (robot, query) = choice.across(links, options.radius)?;
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
        name: format!("discs-{}-{count}-{seed}", choice.id(links)),
        title: Some(format!("{} among {count} discs, seed {seed}", choice.title(links))),
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
