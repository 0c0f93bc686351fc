//! Clutter and discs: convex polygons or discs scattered over a box of 2 m by 2 m, for a robot that crosses it or an arm
//! whose base is in its middle.
//!
//! The corners of a polygon lie on a circle, evenly spaced but for a random shift of up to a fifth of their spacing. By default
//! nearly all worlds have a path: an arm reaches much of the box, so it has fewer obstacles, and smaller polygons. A path need
//! not exist, except for a disc among discs that are apart by at least twice its radius: grown by that radius they are still
//! apart, and too small to cut off a corner of the box.

use super::free::{are_apart, is_clear_of, polygon};
use super::robots::{RobotChoice, SIDE, check_given};
use super::{Generator, SEEDS, in_box, scatter};
use crate::error::Error;
use crate::geometry::{Disc, Point};
use crate::options::{Value, out_of_range};
use crate::random::{Random, Stream};
use crate::robot::Part;
use crate::scenario::{Obstacle, Scenario};
use std::f64::consts::TAU;

crate::choice! {
    /// The placement of discs.
    pub enum Placement {
        /// Farther from each other than the gap.
        Apart,
        /// Anywhere.
        Overlapping,
    }
}

crate::options! {
    /// What clutter to make.
    pub struct ClutterOptions for &[];
    /// The kind of robot.
    robot: RobotChoice = RobotChoice::Disc, "Robot";
    /// Number of links; arms only.
    links: usize = 2, in 1.0..=8.0, "Links";
    /// Number of outer links that slide out of the link before, fewer than `links`; arms only.
    sliding: usize = 0, in 0.0..=7.0, "Sliding links";
    /// The radius of the disc, or half the width of the arm's links; not for a body or a car.
    radius: f64 = 0.03, in 0.0..=0.1, "Radius of the robot", unit "m";
    /// Number of polygons.
    count: Option<usize>, in 0.0..=60.0, "Obstacles", else "14; for an arm twice the number of links less 2, at least 1";
    /// The radius of the smallest circle that a polygon may fill, at most `largest`.
    smallest: f64 = 0.08, in 0.02..=0.5, "Smallest", unit "m";
    /// The radius of the largest such circle.
    largest: Option<f64>, in 0.02..=0.5, "Largest", unit "m", else "0.2 m; 0.12 m for an arm";
    /// Polygons are farther than this from each other, and from the robot at its start and its goal.
    gap: f64 = 0.05, in 0.0..=0.2, "Gap", unit "m";
    /// The seed: 0 (default) to 2^53 - 1.
    seed: u64 = 0, in SEEDS;
}

crate::options! {
    /// Which discs to scatter.
    pub struct DiscsOptions for &[];
    /// The kind of robot.
    robot: RobotChoice = RobotChoice::Disc, "Robot";
    /// Number of links; arms only.
    links: usize = 2, in 1.0..=8.0, "Links";
    /// Number of outer links that slide out of the link before, fewer than `links`; arms only.
    sliding: usize = 0, in 0.0..=7.0, "Sliding links";
    /// The radius of the disc, or half the width of the arm's links; not for a body or a car.
    radius: f64 = 0.03, in 0.0..=0.1, "Radius of the robot", unit "m";
    /// Number of discs.
    count: Option<usize>, in 0.0..=200.0, "Obstacles", else "24; for an arm twice the number of links less 2, at least 1";
    /// The smallest radius of a disc, at most `largest`.
    smallest: f64 = 0.05, in 0.01..=0.5, "Smallest", unit "m";
    /// The largest radius of a disc.
    largest: f64 = 0.18, in 0.01..=0.5, "Largest", unit "m";
    /// Discs are farther than this from the robot at its start and its goal and, if they are apart, from each other.
    gap: f64 = 0.07, in 0.0..=0.2, "Gap", unit "m";
    /// Whether discs are disjoint or may overlap.
    placement: Placement = Placement::Apart, "Placement";
    /// The seed: 0 (default) to 2^53 - 1.
    seed: u64 = 0, in SEEDS;
}

impl Generator for ClutterOptions {
    type Made = Scenario;

    fn check_given(given: &[(String, Value)]) -> Result<(), Error> {
        check_given(given)
    }

    fn make(&self) -> Result<Scenario, Error> {
        let Self { robot, links, sliding, radius, count, smallest, largest, gap, seed } = *self;
        // Never less than a smallest one that is given.
        let largest = largest.unwrap_or(if robot == RobotChoice::Arm { smallest.max(0.12) } else { 0.2 });
        let (count, placement) = (Some(count_for(count, robot, links, 14)), Placement::Apart);
        let options = DiscsOptions { robot, links, sliding, radius, count, smallest, largest, gap, placement, seed };
        scattered(&options, "clutter", "convex polygons", draw_polygon)
    }
}

impl Generator for DiscsOptions {
    type Made = Scenario;

    fn check_given(given: &[(String, Value)]) -> Result<(), Error> {
        check_given(given)
    }

    fn make(&self) -> Result<Scenario, Error> {
        scattered(self, "discs", "discs", |random, smallest, largest| {
            Obstacle::Disc(draw_disc(random, smallest, largest))
        })
    }
}

/// The scenario of obstacles that `draw` makes from the smallest and the largest radius; `what` is their name in the title.
fn scattered(
    options: &DiscsOptions,
    id: &str,
    what: &str,
    draw: fn(&mut Random, f64, f64) -> Obstacle,
) -> Result<Scenario, Error> {
    let DiscsOptions { robot: choice, links, sliding, radius, count, smallest, largest, gap, placement, seed } =
        *options;
    if smallest > largest {
        let sentence = format!("smallest must be at most largest, {largest}, not {smallest}");
        return Err(out_of_range("smallest", sentence));
    }
    let count = count_for(count, choice, links, 24);
    let (robot, query) = choice.across(links, sliding, radius)?;
    let keep_clear: Vec<Part> = query.ends().flat_map(|q| robot.footprint(q)).collect();
    let mut random = Random::new(seed, Stream::Scenario);
    let placed = scatter("count", count, |placed: &[Obstacle]| {
        let drawn = draw(&mut random, smallest, largest);
        let is_apart = || placement == Placement::Overlapping || placed.iter().all(|p| are_apart(p, &drawn, gap));
        (is_clear_of(&drawn, &keep_clear, gap) && is_apart()).then_some(drawn)
    })?;
    let [_, word, title] = choice.words(links, sliding);
    let name = format!("{id}-{word}-{count}-{seed}");
    let title = format!("{title} among {count} {what}, seed {seed}");
    Ok(in_box(name, title, SIDE, placed, robot, query))
}

/// The number of obstacles: as given, else `usual`, and for an arm as many as leave nearly always a path.
fn count_for(given: Option<usize>, robot: RobotChoice, links: usize, usual: usize) -> usize {
    given.unwrap_or(if robot == RobotChoice::Arm { (2 * links).saturating_sub(2).max(1) } else { usual })
}

/// A convex polygon of 3 to 7 corners somewhere in the box.
fn draw_polygon(random: &mut Random, smallest: f64, largest: f64) -> Obstacle {
    let Disc { center, radius } = draw_disc(random, smallest, largest);
    let corners = 3 + random.below(5);
    let turn = TAU * random.uniform();
    let corner = |i: u64| {
        let shift = 0.4 * (random.uniform() - 0.5);
        let (sin, cos) = libm::sincos(turn + TAU * (i as f64 + shift) / corners as f64);
        Point::new(center.x + radius * cos, center.y + radius * sin)
    };
    let corners: Vec<Point> = (0..corners).map(corner).collect();
    // Points in order on a circle, none closer than a tenth of a turn, bound a convex polygon.
    Obstacle::Polygon(polygon(&corners))
}

/// A disc somewhere in the box.
fn draw_disc(random: &mut Random, smallest: f64, largest: f64) -> Disc {
    let radius = smallest + random.uniform() * (largest - smallest);
    let mut coordinate = || radius + random.uniform() * (SIDE - 2.0 * radius);
    let (x, y) = (coordinate(), coordinate());
    Disc { center: Point::new(x, y), radius }
}
