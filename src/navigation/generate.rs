//! Navigation tasks generated from a seed: the same options give the same document on every platform.

use super::document::{GOAL_TOLERANCE, Navigation, NavigationQuery};
use super::episode;
use super::navigator::{ARRIVAL, CargoNavigator, CargoNoise, DriveNavigator, Navigator, Noise, TIME_STEP};
use super::sensor::Sensor;
use crate::error::Error;
use crate::generators::{Generator, SEEDS, generators};
use crate::geometry::{Aabb, Point, Polygon, distance_point_polygon, distance_polygon_polygon};
use crate::options::out_of_range;
use crate::random::{Random, Stream};
use crate::robot::{Cargo, CargoLimits, DifferentialDrive, Footprint, Round};
use crate::scenario::{Obstacle, World};
use std::f64::consts::TAU;

/// The most draws of obstacles.
const DRAWS: u32 = 20_000;

/// The thickness of walls, in metres.
const WALL: f64 = 0.2;

/// The widest door in a wall of 3 m, in metres.
const WIDEST_DOOR: f64 = 1.8;

crate::choice! {
    /// The shape of the robot.
    pub enum DriveShape {
        /// A disc.
        Disc,
        /// A rectangle whose corners lie on the circle of the disc, one and a half times as long as wide.
        Rectangle,
        /// A disc that carries a load on a rope, in any direction.
        Cargo,
    }
}

crate::options! {
    /// The robot: a differential drive, or a carrier of cargo, with a range sensor.
    pub struct DriveOptions for &[];
    /// The shape of the robot: a disc, a rectangle that fits into it, or a disc with a load on a rope.
    shape: DriveShape = DriveShape::Disc, "Shape";
    /// The radius of the robot.
    radius: f64 = 0.25, in 0.05..=0.5, "Radius", unit "m";
    /// By what all noise of sensing and driving is multiplied; 0 for none.
    noise: f64 = 1.0, in 0.0..=5.0, "Noise", unit "of the default";
}

crate::options! {
    /// A floor with furniture and pieces of walls, on which policies are trained.
    pub struct FurnishedOptions for &[];
    /// The length of a side of the floor.
    side: f64 = 12.0, in 4.0..=100.0, "Side", unit "m";
    /// Number of pieces of furniture, convex polygons.
    furniture: usize = 16, in 0.0..=500.0, "Furniture";
    /// Number of pieces of walls, 1 m to 3 m long.
    walls: usize = 3, in 0.0..=200.0, "Walls";
    /// Number of doors, each in a wall of its own, 3 m to 5 m long.
    doors: usize = 2, in 0.0..=200.0, "Doors";
    /// The width of the doors.
    door: f64 = 1.1, in 0.5..=3.0, "Door", unit "m";
    /// Pieces are farther than this from each other.
    gap: f64 = 0.9, in 0.0..=5.0, "Gap", unit "m";
    /// The robot.
    drive: DriveOptions;
    /// The seed: 0 (default) to 2^53 - 1.
    seed: u64 = 0, in SEEDS;
}

crate::options! {
    /// An office: rooms on a grid, doors between them so that every room is reached, and furniture.
    pub struct RoomsOptions for &[];
    /// Number of rooms side by side.
    columns: usize = 4, in 1.0..=10.0, "Columns";
    /// Number of rows of rooms.
    rows: usize = 3, in 1.0..=10.0, "Rows";
    /// The length of a side of a room.
    room: f64 = 5.0, in 3.0..=20.0, "Room", unit "m";
    /// The width of the doors.
    door: f64 = 1.1, in 0.5..=3.0, "Door", unit "m";
    /// The share of the remaining walls that also get a door; 0 makes the rooms a tree.
    loops: f64 = 0.2, in 0.0..=1.0, "Loops";
    /// Number of pieces of furniture in each room.
    furniture: usize = 2, in 0.0..=8.0, "Furniture";
    /// The robot.
    drive: DriveOptions;
    /// The seed: 0 (default) to 2^53 - 1.
    seed: u64 = 0, in SEEDS;
}

generators! {
    Navigation, navigation_generators:
    RoomsOptions => "rooms", "Rooms", "An office of rooms with doors and furniture, for a robot with a range sensor.";
    FurnishedOptions => "furnished", "Furnished", "A floor with furniture and pieces of walls, for a robot with a range sensor.";
}

impl DriveOptions {
    /// The robot.
    fn robot(&self) -> Result<Navigator, Error> {
        let shape = match self.shape {
            DriveShape::Disc => Footprint::Disc(Round { radius: self.radius }),
            DriveShape::Rectangle => {
                let half = 0.999 * self.radius / f64::sqrt(1.5 * 1.5 + 1.0);
                Footprint::Polygon(rectangle([-1.5 * half, -half], [1.5 * half, half]))
            }
            DriveShape::Cargo => return self.cargo().map(Navigator::Cargo),
        };
        let Noise { range, position, heading, speed, turn_rate } = Noise::default();
        let [range, position, heading, speed, turn_rate] =
            [range, position, heading, speed, turn_rate].map(|deviation| self.noise * deviation);
        let drive = DifferentialDrive::new(shape, [0.0, 1.0], [-1.5, 1.5], TIME_STEP)?;
        let noise = Noise { range, position, heading, speed, turn_rate };
        Ok(Navigator::DifferentialDrive(DriveNavigator { drive, sensor: Sensor::default(), noise }))
    }

    /// A carrier whose load swings beyond its limit if the greatest acceleration begins at once: the displacement overshoots to
    /// twice that at rest, 2 L a / g.
    fn cargo(&self) -> Result<CargoNavigator, Error> {
        let (speed, swing_limit) = (1.0, 0.3);
        let cargo = Cargo::new(CargoLimits {
            radius: self.radius,
            load_radius: 0.6 * self.radius,
            rope: 1.0,
            swing_limit,
            damping: 0.1,
            speed,
            acceleration: 2.0,
            time_step: TIME_STEP,
        })?;
        let CargoNoise { range, position, velocity, swing, acceleration } = CargoNoise::default();
        let [range, position, velocity, swing, acceleration] =
            [range, position, velocity, swing, acceleration].map(|deviation| self.noise * deviation);
        let noise = CargoNoise { range, position, velocity, swing, acceleration };
        let [arrival_speed, arrival_swing] = [speed, swing_limit].map(|most| ARRIVAL * most);
        Ok(CargoNavigator { cargo, arrival_speed, arrival_swing, sensor: Sensor::around(), noise })
    }

    /// Refuses doors that the robot does not fit through, or wider than the wall allows.
    fn check_door(&self, door: f64, widest: f64) -> Result<(), Error> {
        let narrowest = 2.0 * self.radius;
        if door > narrowest && door <= widest {
            return Ok(());
        }
        let sentence =
            format!("a door must be wider than the robot, {narrowest} m, and at most {widest} m wide here, not {door}");
        Err(out_of_range("door", sentence))
    }

    /// The task on a floor, with one query: from a random configuration to a position as far away as any of a few random ones.
    fn task(
        &self,
        (name, title): (String, String),
        [width, height]: [f64; 2],
        obstacles: Vec<Obstacle>,
        random: &mut Random,
    ) -> Result<Navigation, Error> {
        let bounds = Some(Aabb { min: Point::origin(), max: Point::new(width, height) });
        let world = World { bounds, obstacles: obstacles.into() };
        let task = Navigation::new(name, Some(title), world, self.robot()?, GOAL_TOLERANCE, Vec::new())?;
        let floor = task.floor();
        let Some(start) = episode::configuration(&floor, random) else {
            return Err(out_of_range("radius", "there is no room for a robot of this radius".to_owned()));
        };
        let far = |goal: &[f64; 2]| (goal[0] - start[0]).abs() + (goal[1] - start[1]).abs();
        let goals = (0..8).filter_map(|_| episode::configuration(&floor, random)).map(|[x, y, _]| [x, y]);
        let goal = goals.max_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or([start[0], start[1]]);
        task.with_queries(vec![NavigationQuery { name: "across".to_owned(), start, goal }])
    }
}

impl Generator for FurnishedOptions {
    type Made = Navigation;

    fn make(&self) -> Result<Navigation, Error> {
        let Self { side, furniture, walls, doors, door, gap, drive, seed } = *self;
        drive.check_door(door, WIDEST_DOOR)?;
        let mut random = Random::new(seed, Stream::Scenario);
        let mut placed: Vec<Polygon> = Vec::new();
        // Stretches of a wall, along x or along y.
        let wall = |random: &mut Random, length: f64, stretches: &[[f64; 2]]| {
            let is_upright = random.uniform() < 0.5;
            let (along, across) = (random.uniform() * (side - length), random.uniform() * (side - WALL));
            let turned = |along: f64, across: f64| if is_upright { [across, along] } else { [along, across] };
            let stretch =
                |[from, to]: &[f64; 2]| rectangle(turned(along + from, across), turned(along + to, across + WALL));
            stretches.iter().map(stretch).collect::<Vec<_>>()
        };
        scatter("doors", doors, gap, &mut placed, || {
            let length = 3.0 + 2.0 * random.uniform().min(side / 2.0 - 2.0);
            let at = 0.5 + random.uniform() * (length - 1.0 - door);
            Some(wall(&mut random, length, &[[0.0, at], [at + door, length]]))
        })?;
        scatter("walls", walls, gap, &mut placed, || {
            let length = 1.0 + 2.0 * random.uniform();
            Some(wall(&mut random, length, &[[0.0, length]]))
        })?;
        scatter("furniture", furniture, gap, &mut placed, || Some(vec![piece(&mut random, [0.0, 0.0], [side, side])]))?;
        let title = format!("A furnished floor of {side} m, seed {seed}");
        let obstacles = placed.into_iter().map(Obstacle::Polygon).collect();
        drive.task((format!("furnished-{seed}"), title), [side, side], obstacles, &mut random)
    }
}

impl Generator for RoomsOptions {
    type Made = Navigation;

    fn make(&self) -> Result<Navigation, Error> {
        let Self { columns, rows, room, door, loops, furniture, drive, seed } = *self;
        drive.check_door(door, room - 3.0 * WALL)?;
        let mut random = Random::new(seed, Stream::Scenario);
        let count = columns * rows;
        // Walls between neighbours: the room on the left or below, and whether the other is on the right.
        let mut walls: Vec<(usize, bool)> = Vec::new();
        for i in 0..count {
            walls.extend((i % columns + 1 < columns).then_some((i, true)));
            walls.extend((i / columns + 1 < rows).then_some((i, false)));
        }
        for i in (1..walls.len()).rev() {
            walls.swap(i, random.below(i as u64 + 1) as usize);
        }
        // A random spanning tree of the rooms (Kruskal), and some doors more.
        let mut part: Vec<usize> = (0..count).collect();
        let mut obstacles: Vec<Polygon> = Vec::new();
        let mut doors: Vec<Point> = Vec::new();
        for (i, is_right) in walls {
            let j = if is_right { i + 1 } else { i + columns };
            let (a, b) = (part[i], part[j]);
            let has_door = a != b || random.uniform() < loops;
            part.iter_mut().filter(|part| **part == b).for_each(|part| *part = a);
            let (x, y) = ((i % columns) as f64 * room, (i / columns) as f64 * room);
            let at = 0.5 * door + WALL + random.uniform() * (room - door - 2.0 * WALL);
            // Along the wall, from its lower or left end.
            let wall = |from: f64, to: f64| {
                let (low, high) = ([from, room - 0.5 * WALL], [to, room + 0.5 * WALL]);
                let turned = |[along, across]: [f64; 2]| {
                    if is_right { [x + across, y + along] } else { [x + along, y + across] }
                };
                rectangle(turned(low), turned(high))
            };
            if has_door {
                obstacles.extend([wall(0.0, at - 0.5 * door), wall(at + 0.5 * door, room)]);
                doors.push(if is_right { Point::new(x + room, y + at) } else { Point::new(x + at, y + room) });
            } else {
                obstacles.push(wall(0.0, room));
            }
        }
        for i in 0..count {
            let low = [(i % columns) as f64 * room + 0.5 * WALL, (i / columns) as f64 * room + 0.5 * WALL];
            let high = low.map(|x| x + room - WALL);
            let mut pieces: Vec<Polygon> = Vec::new();
            let clear = 0.5 * door + 2.0 * drive.radius + 0.4;
            scatter("furniture", furniture, 0.9, &mut pieces, || {
                let piece = piece(&mut random, low, high);
                let is_clear = doors.iter().all(|door| distance_point_polygon(*door, &piece) > clear);
                is_clear.then(|| vec![piece])
            })?;
            obstacles.extend(pieces);
        }
        let title = format!("An office of {columns} by {rows} rooms, seed {seed}");
        let obstacles = obstacles.into_iter().map(Obstacle::Polygon).collect();
        let size = [columns, rows].map(|n| n as f64 * room);
        drive.task((format!("rooms-{columns}-{rows}-{seed}"), title), size, obstacles, &mut random)
    }
}

/// Adds `count` groups of polygons that are farther than `gap` from those before; `draw` returns `None` if the one that it draws
/// does not fit. If too few fit, the error names the option.
fn scatter(
    option: &str,
    count: usize,
    gap: f64,
    placed: &mut Vec<Polygon>,
    mut draw: impl FnMut() -> Option<Vec<Polygon>>,
) -> Result<(), Error> {
    let mut left = count;
    for _ in 0..DRAWS {
        if left == 0 {
            return Ok(());
        }
        let Some(drawn) = draw() else { continue };
        let is_apart = |new: &Polygon| placed.iter().all(|old| distance_polygon_polygon(old, new) > gap);
        if drawn.iter().all(is_apart) {
            placed.extend(drawn);
            left -= 1;
        }
    }
    let sentence = format!("only {} of {count} could be placed in {DRAWS} draws", count - left);
    Err(out_of_range(option, sentence))
}

/// A convex polygon of 3 to 6 corners in a box: a table, a shelf, a plant.
fn piece(random: &mut Random, low: [f64; 2], high: [f64; 2]) -> Polygon {
    let radius = 0.25 + 0.4 * random.uniform();
    let mut coordinate = |i: usize| low[i] + radius + random.uniform() * (high[i] - low[i] - 2.0 * radius);
    let (x, y) = (coordinate(0), coordinate(1));
    let corners = 3 + random.below(4);
    let turn = TAU * random.uniform();
    let corner = |i: u64| {
        let (sin, cos) = libm::sincos(turn + TAU * (i as f64 + 0.4 * (random.uniform() - 0.5)) / corners as f64);
        Point::new(x + radius * cos, y + radius * sin)
    };
    let corners: Vec<Point> = (0..corners).map(corner).collect();
    Polygon::new(&corners).expect("points in order on a circle bound a convex polygon")
}

/// A rectangle.
fn rectangle(low: [f64; 2], high: [f64; 2]) -> Polygon {
    let corners = [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]];
    Polygon::new(&corners.map(|[x, y]| Point::new(x, y))).expect("a rectangle with sides longer than 0")
}
