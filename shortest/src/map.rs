//! A prepared map and its queries.

use crate::fault::{Fault, Subject};
use crate::parts::{MAX_POSITIONS, Part, obstacles};
use crate::plane::{MAX_DISTORTION, Plane, corners};
use planarium::error::Code;
use planarium::geometry::{Aabb, Point};
use planarium::optimum::{Shortest, ShortestPaths};
use planarium::robot::DiscRobot;
use planarium::scenario::{Obstacle, World};
use std::sync::{Arc, Mutex, PoisonError};

/// The largest number of a map in metres.
const LARGEST: f64 = 1e8;

/// How much farther each wider area reaches than the one before.
const WIDER: f64 = 8.0;

/// How a map is prepared.
#[derive(Debug, Clone, Copy, Default)]
pub struct Settings {
    /// The distance from all parts that paths keep, in metres, from 0 to 1e6.
    pub distance: f64,
    /// The lowest and the highest numbers of the area that paths stay in, at the distance from its border too; without it the
    /// area has no end.
    pub bounds: Option<[[f64; 2]; 2]>,
    /// Whether numbers are x and y in metres, from -1e8 to 1e8, not longitude and latitude.
    pub planar: bool,
    /// Whether it is prepared for many queries, as [`ShortestPaths::for_many_queries`] does it.
    pub many_queries: bool,
}

/// A map that is prepared for shortest paths.
pub struct Map {
    world: World,
    robot: DiscRobot,
    bounds: Option<Aabb>,
    /// `None` until a query has positions, if nothing else has.
    plane: Option<Plane>,
    /// The lowest and the highest latitude of the parts.
    latitudes: Option<[f64; 2]>,
    planar: bool,
    many_queries: bool,
    /// The smallest area, and the last other one that a query needed.
    near: Option<Arc<ShortestPaths>>,
    wide: Mutex<Option<(i32, Arc<ShortestPaths>)>>,
}

/// A shortest path.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Found {
    /// The length in metres. Of degrees, that of the line on the ellipsoid WGS 84. Arcs count as arcs.
    pub length: f64,
    /// The most that the plane in which the path is the shortest distorts distances, as a part of them, over the latitudes of the
    /// map and of both ends; 0 of metres.
    pub distortion: f64,
    /// The positions from the start to the goal; arcs are chords of at most 0.05 radians.
    pub path: Vec<[f64; 2]>,
}

impl Map {
    /// Prepares a map: O(n log n) for n positions, as a rule.
    ///
    /// # Errors
    /// `not-finite` and `out-of-range` for numbers, the distance, bounds without an inside, and a map of degrees that no plane fits
    /// but for [`MAX_DISTORTION`]; `too-large` for more than [`MAX_POSITIONS`]; `degenerate-polygon` for an outline or a hole that
    /// crosses itself or has no area, and for a hole that is not in its outline; `degenerate-wall` for a line without two
    /// different positions.
    pub fn new(parts: &[Part<'_>], settings: &Settings) -> Result<Self, Fault> {
        let &Settings { distance, bounds, planar, many_queries } = settings;
        let robot = DiscRobot::new(distance).map_err(|error| {
            let sentence = format!("the distance must be from 0 to 1e6 m, not {distance}");
            Fault::new(error.code(), Subject::Distance, sentence)
        })?;
        if parts.iter().map(|part| part.positions.len()).sum::<usize>() > MAX_POSITIONS {
            let sentence = format!("a map has at most {MAX_POSITIONS} positions");
            return Err(Fault::new(Code::TooLarge, Subject::Map, sentence));
        }
        for (number, part) in parts.iter().enumerate() {
            part.positions.iter().try_for_each(|&at| check(at, planar, Subject::Part(number)))?;
        }
        for corner in bounds.into_iter().flatten() {
            check(corner, planar, Subject::Bounds)?;
        }
        if bounds.is_some_and(|[low, high]| low[0] >= high[0] || low[1] >= high[1]) {
            let sentence = "the first corner of the bounds must be below and to the left of the second";
            return Err(Fault::new(Code::OutOfRange, Subject::Bounds, sentence));
        }
        let positions = parts.iter().flat_map(|part| part.positions).copied();
        let extent = corners(positions.chain(bounds.into_iter().flatten()));
        let plane = if planar { Some(Plane::METRES) } else { extent.map(Plane::at_middle) };
        let latitudes = extent.map(|[low, high]| [low[1], high[1]]);
        if let (Some(plane), Some(latitudes)) = (plane, latitudes) {
            distortion(&plane, latitudes, Subject::Map)?;
        }
        let obstacles = match plane {
            Some(plane) => obstacles(parts, |at| plane.point(at))?,
            None => Vec::new(),
        };
        let bounds = plane.and_then(|plane| bounds.map(|[low, high]| Aabb::of(plane.point(low), plane.point(high))));
        let world = World::new(None, obstacles);
        let (near, wide) = (None, Mutex::new(None));
        let mut map = Self { world, robot, bounds, plane, latitudes, planar, many_queries, near, wide };
        if let Some(area) = bounds.or_else(|| map.area(0)) {
            map.near = map.prepared(area, many_queries).map(Arc::new);
        }
        Ok(map)
    }

    /// The number of tangents that are known beforehand, as [`ShortestPaths::tangents`] has it. Of a map without bounds, they are
    /// known for ends that are no farther from the obstacles than these reach.
    pub fn tangents(&self) -> Option<usize> {
        match &self.near {
            Some(paths) => paths.tangents(),
            None => self.many_queries.then_some(0),
        }
    }

    /// The shortest path between two positions; `None` if there is none.
    ///
    /// # Errors
    /// `not-finite` and `out-of-range` for numbers, also where the plane of the map would distort distances too much;
    /// `start-in-collision` and `goal-in-collision` for positions in an area, nearer to a part than the distance, or out of bounds.
    pub fn query(&self, start: [f64; 2], goal: [f64; 2]) -> Result<Option<Found>, Fault> {
        let ends = [(start, Subject::Start), (goal, Subject::Goal)];
        ends.iter().try_for_each(|&(at, subject)| check(at, self.planar, subject))?;
        let plane = self.plane.unwrap_or_else(|| Plane::at_middle([start, goal]));
        let mut latitudes = self.latitudes.unwrap_or([start[1]; 2]);
        let mut most = 0.0;
        for (at, subject) in ends {
            latitudes = [latitudes[0].min(at[1]), latitudes[1].max(at[1])];
            most = distortion(&plane, latitudes, subject)?;
        }
        let points = [start, goal].map(|at| plane.point(at));
        let found = match self.reaching(points) {
            None => Some(((points[1] - points[0]).norm(), points.to_vec())),
            Some(paths) => self
                .shortest(&paths, points)?
                .map(|Shortest { length, path, .. }| (length, path.into_iter().map(Point::from).collect())),
        };
        Ok(found.map(|(length, points)| {
            let excess: f64 = points.windows(2).map(|pair| plane.excess(pair[0], pair[1])).sum();
            let mut path: Vec<[f64; 2]> = points.iter().map(|&point| plane.position(point)).collect();
            // The way back from the plane rounds; a start that is the goal is listed once.
            path.truncate(path.len().max(2) - 1);
            path[0] = start;
            path.push(goal);
            Found { length: length + excess, distortion: most, path }
        }))
    }
}

impl Map {
    /// The shortest path in an area that holds it.
    fn shortest(&self, paths: &ShortestPaths, [start, goal]: [Point; 2]) -> Result<Option<Shortest>, Fault> {
        paths.query(start.into(), goal.into()).map_err(|error| {
            let is_start = error.code() == Code::StartInCollision;
            let (what, subject) = if is_start { ("start", Subject::Start) } else { ("goal", Subject::Goal) };
            let beyond = if self.bounds.is_some() { ", or out of bounds" } else { "" };
            let near = match self.robot.radius() {
                0.0 => String::new(),
                distance => format!(", nearer to one than {distance} m"),
            };
            Fault::new(error.code(), subject, format!("the {what} is in an obstacle{near}{beyond}"))
        })
    }

    /// The paths in an area that holds all from one point to another: the smallest of a row of them, so that it is that of the
    /// points alone. `None` if there is nothing to go around.
    fn reaching(&self, points: [Point; 2]) -> Option<Arc<ShortestPaths>> {
        let near = self.near.as_ref()?;
        let room = 2.0 * self.robot.radius();
        let holds = |area: &Aabb| points.iter().all(|&point| area.depth(point) > room);
        let level = match self.bounds {
            Some(_) => 0,
            None => (0..).find(|&level| self.area(level).is_none_or(|area| holds(&area))).unwrap_or(0),
        };
        if level == 0 {
            return Some(Arc::clone(near));
        }
        let mut wide = self.wide.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, paths)) = wide.as_ref().filter(|(known, _)| *known == level) {
            return Some(Arc::clone(paths));
        }
        let paths = Arc::new(self.prepared(self.area(level)?, false)?);
        *wide = Some((level, Arc::clone(&paths)));
        Some(paths)
    }

    /// An area around all obstacles, the wider the higher its level; `None` without obstacles.
    fn area(&self, level: i32) -> Option<Aabb> {
        let around = self.world.obstacles.iter().map(Obstacle::aabb).reduce(|a, b| a.union(&b))?;
        let radius = self.robot.radius();
        let beside = around.longer_side() / 4.0 + radius;
        let beside = if beside > 0.0 { beside } else { 1.0 };
        Some(around.grown(2.0 * radius + beside * WIDER.powi(level)))
    }

    /// The world, prepared for paths in an area.
    fn prepared(&self, area: Aabb, many_queries: bool) -> Option<ShortestPaths> {
        let world = World { bounds: Some(area), ..self.world.clone() };
        let paths = ShortestPaths::among(&world, &self.robot).ok()?;
        Some(if many_queries { paths.for_many_queries() } else { paths })
    }
}

/// Refuses numbers that are no position.
///
/// # Errors
/// `not-finite`, `out-of-range`.
fn check([x, y]: [f64; 2], planar: bool, subject: Subject) -> Result<(), Fault> {
    let refused = |code, why: &str| Err(Fault::new(code, subject, format!("the position [{x}, {y}] {why}")));
    if !x.is_finite() || !y.is_finite() {
        return refused(Code::NotFinite, "is not finite");
    }
    match planar {
        true if x.abs().max(y.abs()) > LARGEST => {
            refused(Code::OutOfRange, "is farther than 1e8 m from the origin along an axis")
        }
        false if x.abs() > 180.0 || y.abs() > 90.0 => {
            refused(Code::OutOfRange, "is no longitude from -180 to 180 and latitude from -90 to 90")
        }
        _ => Ok(()),
    }
}

/// The most that a plane distorts distances between two latitudes, as a part of them.
///
/// # Errors
/// `out-of-range` for more than [`MAX_DISTORTION`].
fn distortion(plane: &Plane, latitudes: [f64; 2], subject: Subject) -> Result<f64, Fault> {
    let most = plane.distortion(latitudes);
    if most <= MAX_DISTORTION {
        return Ok(most);
    }
    let [low, high] = latitudes;
    let sentence = format!(
        "between the latitudes {low} and {high} a plane distorts distances by more than a tenth; project them yourself"
    );
    Err(Fault::new(Code::OutOfRange, subject, sentence))
}
