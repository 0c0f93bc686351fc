//! The forest: an arm of unit links among equal triangles on a grid, as in a course report.
//!
//! Each of the 4 R triangles has the corners (x, y), (x + 0.5, y), (x + 0.25, y + 0.5) with x and y on the half-unit grid in
//! [-R, R), R the number of links. The report drew with repetition and dropped triangles with a corner on the base; here
//! cells are distinct, and a triangle that touches the base, the start or the goal is drawn again. A path need not exist.

use super::free::{is_clear_of, polygon};
use super::{Generator, SEEDS, query, scatter};
use crate::error::Error;
use crate::geometry::Point;
use crate::random::{Random, Stream};
use crate::robot::Arm;
use crate::scenario::{Obstacle, Parts, Robot, Scenario, World};

crate::options! {
    /// What forest to grow.
    pub struct ForestOptions for &[];
    /// Number of links of the arm, each of length 1; there are four triangles per link. Of forests for two or three links
    /// every third has no path, of others hardly any.
    links: usize = 4, in 1.0..=8.0, "Links";
    /// The seed: 0 (default) to 2^53 - 1.
    seed: u64 = 0, in SEEDS;
}

impl Generator for ForestOptions {
    type Made = Scenario;

    fn make(&self) -> Result<Scenario, Error> {
        let Self { links, seed } = *self;
        let arm = Arm::new(Point::origin(), vec![1.0; links], 0.0, None)?;
        let (start, goal) = ends(links);
        let keep_clear = [arm.footprint(&start), arm.footprint(&goal)].concat();
        let (count, side) = (4 * links, 4 * links as u64);
        let mut random = Random::new(seed, Stream::Scenario);
        let placed = scatter("seed", count, |placed: &[((u64, u64), Obstacle)]| {
            let cell = (random.below(side), random.below(side));
            let triangle = triangle(cell, links);
            let is_new = placed.iter().all(|(other, _)| *other != cell);
            (is_new && is_clear_of(&triangle, &keep_clear, 0.0)).then_some((cell, triangle))
        })?;
        let obstacles = placed.into_iter().map(|(_, triangle)| triangle).collect();
        Ok(Parts::new(
            format!("forest-{links}r-{seed}"),
            Some(format!("{links}R arm in a forest of {count} triangles, seed {seed}")),
            World { bounds: None, obstacles },
            Robot::Arm(arm),
            vec![query("report", start, goal)],
        )
        .into())
    }
}

/// The triangle in a cell of the grid, counted from its lower left corner (-links, -links).
fn triangle((column, row): (u64, u64), links: usize) -> Obstacle {
    let at = |cell: u64| 0.5 * cell as f64 - links as f64;
    let (x, y) = (at(column), at(row));
    let corners = [Point::new(x, y), Point::new(x + 0.5, y), Point::new(x + 0.25, y + 0.5)];
    Obstacle::Polygon(polygon(&corners))
}

/// Start and goal: those of the report for 2, 3 and 4 links; otherwise from a gentle curl to a zigzag on the other side.
fn ends(links: usize) -> (Vec<f64>, Vec<f64>) {
    match links {
        2 => (vec![0.5, 5.0], vec![2.0, 1.0]),
        3 => (vec![1.0, 0.5, 5.0], vec![4.0, 1.0, 1.0]),
        4 => (vec![0.1, 0.2, 0.3, 0.4], vec![5.0, 1.0, 5.0, 0.5]),
        _ => {
            let goal = (0..links).map(|i| [3.0, 1.0, 5.5, 0.5][i % 4]).collect();
            (vec![0.2; links], goal)
        }
    }
}
