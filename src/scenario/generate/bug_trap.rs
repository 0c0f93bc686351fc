//! The bug trap: a round pocket whose mouth is turned inwards, so that a tree that grows towards samples hardly leaves it
//! (LaValle 2006, "Planning Algorithms", chapter 5). For a disc, from inside to outside or the reverse.
//!
//! A path exists exactly if the mouth is wider than the disc (by more than 1e-9 m, to be safe from rounding); if it is not,
//! the title says so.

use super::free::polygon;
use super::robots::SIDE;
use super::{Generator, SEEDS, in_box, query};
use crate::error::Error;
use crate::geometry::{Point, Vector};
use crate::random::{Random, Stream};
use crate::robot::DiscRobot;
use crate::scenario::{Obstacle, Robot, Scenario};
use std::f64::consts::TAU;

/// The thickness of the trap's wall, in metres.
const THICKNESS: f64 = 0.06;

/// The end of the round part of the wall, as an angle from the axis of the mouth, and the number of its pieces.
const OPENING: f64 = 0.6;
const PIECES: usize = 32;

crate::choice! {
    /// The start of the disc.
    pub enum BugTrapStart {
        /// In the trap; the goal is outside.
        Inside,
        /// Outside; the goal is in the trap.
        Outside,
    }
}

crate::choice! {
    /// The directions that the mouth may have.
    pub enum Turn {
        /// Anywhere.
        Any,
        /// To the right, up, to the left or down.
        Quarter,
    }
}

crate::options! {
    /// Which trap to set.
    pub struct BugTrapOptions for &[];
    /// The radius of the disc.
    radius: f64 = 0.03, in 0.0..=0.1, "Radius of the robot", unit "m";
    /// The width of the mouth; the disc passes if it is more than twice its radius.
    mouth: f64 = 0.12, in 0.01..=0.4, "Width of the mouth", unit "m";
    /// Whether the path leads out of the trap or into it.
    start: BugTrapStart = BugTrapStart::Inside, "Start";
    /// Whether the mouth faces any direction or along an axis.
    turn: Turn = Turn::Any, "Turn";
    /// The seed: 0 (default) to 2^53 - 1.
    seed: u64 = 0, in SEEDS;
}

impl Generator for BugTrapOptions {
    type Made = Scenario;

    /// In a box of 2 m by 2 m, with the query "out" or "in". The seed decides the position, the size (a radius of 0.55 to
    /// 0.62 m) and the direction of the trap, and the start and the goal: one in it, one in a corner of the box.
    fn make(&self) -> Result<Scenario, Error> {
        let Self { radius, mouth, start, turn, seed } = *self;
        let mut random = Random::new(seed, Stream::Scenario);
        let size = 0.55 + 0.07 * random.uniform();
        let mut near_middle = || SIDE / 2.0 + 0.1 * (random.uniform() - 0.5);
        let center = Point::new(near_middle(), near_middle());
        let (sin, cos) = match turn {
            Turn::Any => libm::sincos(TAU * random.uniform()),
            Turn::Quarter => [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][random.below(4) as usize],
        };
        let place = |p: Point| Point::new(center.x + cos * p.x - sin * p.y, center.y + sin * p.x + cos * p.y);
        let corners: Vec<Point> = outline(size, mouth).into_iter().map(place).collect();

        let inside = place(Point::new(size * (0.1 * random.uniform() - 0.5), size * 0.4 * (random.uniform() - 0.5)));
        let mut corner = || if random.below(2) == 0 { 0.2 } else { SIDE - 0.2 };
        let (inside, outside) = (vec![inside.x, inside.y], vec![corner(), corner()]);
        let (id, word, start, goal) = match start {
            BugTrapStart::Inside => ("out", "out of", inside, outside),
            BugTrapStart::Outside => ("in", "into", outside, inside),
        };
        let narrow = if mouth <= 2.0 * radius { ", too narrow for it: no path" } else { "" };
        let name = format!("bug-trap-{id}-{seed}");
        let title =
            format!("Disc of radius {radius} m {word} a bug trap with a mouth of {mouth} m{narrow}, seed {seed}");
        let trap = Obstacle::Polygon(polygon(&corners));
        Ok(in_box(name, title, SIDE, [trap], Robot::Disc(DiscRobot::new(radius)?), query(id, start, goal)))
    }
}

/// The trap around the origin with its mouth to the right: the wall follows a line from one lip through the throat, around
/// the pocket and back to the other lip.
fn outline(size: f64, mouth: f64) -> Vec<Point> {
    let (lip, throat) = (0.05 * size, 0.5 * size);
    let (round, aside) = (size - THICKNESS / 2.0, (mouth + THICKNESS) / 2.0);
    let mut line = vec![Point::new(lip, aside), Point::new(throat, aside)];
    for i in 0..=PIECES {
        let (sin, cos) = libm::sincos(OPENING + (TAU - 2.0 * OPENING) * i as f64 / PIECES as f64);
        line.push(Point::new(round * cos, round * sin));
    }
    line.extend([Point::new(throat, -aside), Point::new(lip, -aside)]);
    thicken(&line, THICKNESS / 2.0)
}

/// The outline of everything within `half` metres of a line, with mitred bends and square ends: one side of it to the end,
/// then the other side back.
fn thicken(line: &[Point], half: f64) -> Vec<Point> {
    let left_of = |i: usize| {
        let along = line[i + 1] - line[i];
        Vector::new(-along.y, along.x) / (along.x * along.x + along.y * along.y).sqrt()
    };
    let last = line.len() - 1;
    let offset = |i: usize| {
        let (before, after) = (left_of(i.max(1) - 1), left_of(i.min(last - 1)));
        // The mitre m has m . before = m . after = half.
        let sum = before + after;
        sum * (2.0 * half / (sum.x * sum.x + sum.y * sum.y))
    };
    let left = (0..=last).map(|i| line[i] + offset(i));
    let right = (0..=last).rev().map(|i| line[i] - offset(i));
    left.chain(right).collect()
}
