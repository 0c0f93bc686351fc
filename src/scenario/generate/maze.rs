//! The maze: a disc, a rigid body or a car goes from the lower left corner of a square maze to the upper right one.
//!
//! The passages of a perfect maze are a spanning tree of its cells, here one drawn with equal chances from all of them by
//! loop-erased random walks (Wilson 1996, "Generating random spanning trees more quickly than the cover time"); then a share
//! of the remaining walls is removed, which makes loops. Walls in a row make one rectangle. Every maze has a path, since the
//! disc fits through its corridors, and body and car turn in them.

use super::free::{SOME, polygon};
use super::robots::check_given;
use super::{Generator, RobotChoice, SEEDS, in_box, query};
use crate::error::Error;
use crate::geometry::{Point, Polygon};
use crate::options::{Choice, Value, out_of_range};
use crate::random::{Random, Stream};
use crate::robot::DiscRobot;
use crate::scenario::{GoalTolerance, Obstacle, Query, Robot, Scenario};
use std::f64::consts::PI;

/// The side of a cell, from the middle of one wall to the middle of the next, in metres.
const CELL: f64 = 0.25;

/// The least play that the disc has in a corridor, in metres.
const PLAY: f64 = 0.02;

/// Half the length of a body or a car, in metres.
const HALF_LENGTH: f64 = 0.03;

/// The goal region of a car: about the middle of the last cell, in any direction, in metres.
const REGION: f64 = 0.1;

crate::choice! {
    /// The robot of a maze.
    pub enum MazeRobot {
        /// A disc.
        Disc,
        /// A rectangle of 6 cm by 3 cm that translates and turns.
        #[strum(serialize = "rigid_body")]
        RigidBody,
        /// The same rectangle on wheels.
        Car,
    }
}

crate::choice! {
    /// The difficulty of a maze.
    pub enum Difficulty {
        /// 6 by 6 cells, one in five of the inner walls opened.
        Easy,
        /// 9 by 9 cells, one in ten of the inner walls opened.
        Medium,
        /// 12 by 12 cells, a perfect maze: one path from each cell to each other.
        Hard,
    }
}

crate::options! {
    /// Which maze to build.
    pub struct MazeOptions for &[];
    /// easy: 6 by 6 cells, one wall of five opened; medium: 9 by 9, one of ten; hard: 12 by 12, none, so that one path
    /// leads to the goal.
    difficulty: Difficulty = Difficulty::Easy, "Difficulty";
    /// A disc, or a rigid body or a car of 6 cm by 3 cm; the car may arrive in any direction.
    robot: MazeRobot = MazeRobot::Disc, "Robot";
    /// The radius of the disc.
    radius: f64 = 0.03, in 0.0..=0.1, "Radius of the robot", unit "m";
    /// The thickness of the walls; corridors have the rest of 0.25 m.
    thickness: f64 = 0.03, in 0.005..=0.1, "Thickness", unit "m";
    /// The seed: 0 (default) to 2^53 - 1.
    seed: u64 = 0, in SEEDS;
}

impl Generator for MazeOptions {
    type Made = Scenario;

    fn check_given(given: &[(String, Value)]) -> Result<(), Error> {
        check_given(given)
    }

    fn make(&self) -> Result<Scenario, Error> {
        let Self { difficulty, robot, radius, thickness, seed } = *self;
        let corridor = CELL - thickness;
        if corridor - 2.0 * radius < PLAY - SOME {
            let sentence =
                format!("a disc of radius {radius} with {PLAY} of play does not fit a corridor {corridor} wide");
            return Err(out_of_range("radius", sentence));
        }
        // The cells per side, and the percentage of the walls that are opened.
        let (cells, opened) = match difficulty {
            Difficulty::Easy => (6, 20),
            Difficulty::Medium => (9, 10),
            Difficulty::Hard => (12, 0),
        };
        let mut random = Random::new(seed, Stream::Scenario);
        let mut walls = Walls::of_perfect_maze(cells, &mut random);
        walls.open(opened, &mut random);
        let (side, word) = (CELL * cells as f64, difficulty.word());
        let (first, last) = (CELL / 2.0, side - CELL / 2.0);
        let choice = match robot {
            MazeRobot::Disc => RobotChoice::Disc,
            MazeRobot::RigidBody => RobotChoice::RigidBody,
            MazeRobot::Car => RobotChoice::Car,
        };
        let [_, short, long] = choice.words(0, 0);
        let short = if robot == MazeRobot::Disc { String::new() } else { format!("{short}-") };
        let name = format!("maze-{short}{word}-{seed}");
        let title = format!("{long} in a maze of {cells} by {cells} cells, {word}, seed {seed}");
        let walls = walls.rectangles(thickness).into_iter().map(Obstacle::Polygon);
        if robot == MazeRobot::Disc {
            let robot = Robot::Disc(DiscRobot::new(radius)?);
            return Ok(in_box(name, title, side, walls, robot, query("through", vec![first, first], vec![last, last])));
        }
        let goal_tolerance = (robot == MazeRobot::Car).then_some(GoalTolerance { translation: REGION, rotation: PI });
        let query = Query { goal_tolerance, ..query("through", vec![first, first, 0.0], vec![last, last, 0.0]) };
        Ok(in_box(name, title, side, walls, choice.rectangle(HALF_LENGTH)?, query))
    }
}

/// The inner walls of a square maze. Cells are numbered row by row from the lower left corner.
struct Walls {
    cells: usize,
    /// For each cell, whether there is a wall to its right and one above it; never at the border, which is the bounds.
    closed: Vec<[bool; 2]>,
}

impl Walls {
    /// The walls of a perfect maze: from every cell that is not connected yet a random walk leads to one that is, and the
    /// walk without its loops becomes passages. O(cells) steps per walk on average, in practice fewer.
    fn of_perfect_maze(cells: usize, random: &mut Random) -> Self {
        let count = cells * cells;
        let closed = (0..count).map(|cell| [cell % cells + 1 < cells, cell / cells + 1 < cells]).collect();
        let mut walls = Self { cells, closed };
        let mut connected = vec![false; count];
        connected[random.below(count as u64) as usize] = true;
        // The neighbour to which the walk last left each cell: following these omits the loops.
        let mut exit = vec![0; count];
        for first in 0..count {
            let mut cell = first;
            while !connected[cell] {
                exit[cell] = walls.neighbour(cell, random);
                cell = exit[cell];
            }
            cell = first;
            while !connected[cell] {
                connected[cell] = true;
                let (low, high) = (cell.min(exit[cell]), cell.max(exit[cell]));
                walls.closed[low][usize::from(high != low + 1)] = false;
                cell = exit[cell];
            }
        }
        walls
    }

    /// One of the two to four cells beside a cell.
    fn neighbour(&self, cell: usize, random: &mut Random) -> usize {
        let (n, column, row) = (self.cells, cell % self.cells, cell / self.cells);
        let beside = [
            (column > 0).then(|| cell - 1),
            (column + 1 < n).then(|| cell + 1),
            (row > 0).then(|| cell - n),
            (row + 1 < n).then(|| cell + n),
        ];
        let there = || beside.iter().flatten();
        let chosen = random.below(there().count() as u64) as usize;
        *there().nth(chosen).expect("a number below the count")
    }

    /// Removes this percentage of the walls.
    fn open(&mut self, percentage: usize, random: &mut Random) {
        let both = |cell: usize| [(cell, 0), (cell, 1)];
        let mut left: Vec<(usize, usize)> = (0..self.closed.len()).flat_map(both).collect();
        left.retain(|&(cell, side)| self.closed[cell][side]);
        for _ in 0..left.len() * percentage / 100 {
            let (cell, side) = left.swap_remove(random.below(left.len() as u64) as usize);
            self.closed[cell][side] = false;
        }
    }

    /// The walls as rectangles, one for each run of walls in a line: first the vertical ones from left to right, then the
    /// horizontal ones from below.
    fn rectangles(&self, thickness: f64) -> Vec<Polygon> {
        let (n, half) = (self.cells, thickness / 2.0);
        let side = CELL * n as f64;
        let mut rectangles = Vec::new();
        for vertical in [true, false] {
            for line in 0..n - 1 {
                let is_closed = |i: usize| {
                    let cell = if vertical { i * n + line } else { line * n + i };
                    i < n && self.closed[cell][usize::from(!vertical)]
                };
                let across = CELL * (line + 1) as f64;
                let mut from = 0;
                for i in 0..=n {
                    if is_closed(i) {
                        continue;
                    }
                    if from < i {
                        // A run reaches half a thickness into its joints, but not out of the bounds.
                        let (low, high) = (CELL * from as f64 - half, CELL * i as f64 + half);
                        let (low, high) = (low.max(0.0), high.min(side));
                        let wall =
                            [(across - half, low), (across + half, low), (across + half, high), (across - half, high)];
                        let corner = |(u, v)| if vertical { Point::new(u, v) } else { Point::new(v, u) };
                        rectangles.push(polygon(&wall.map(corner)));
                    }
                    from = i + 1;
                }
            }
        }
        rectangles
    }
}
