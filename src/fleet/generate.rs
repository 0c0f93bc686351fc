//! Fleets generated from a seed: the same options give the same document on every platform.

use super::document::{Fleet, FleetRobot};
use crate::error::Error;
use crate::generators::{Generator, SEEDS, generators};
use crate::geometry::{Aabb, Disc, Point, Polygon};
use crate::options::out_of_range;
use crate::random::{Random, Stream};
use crate::robot::{DiscRobot, RigidBody, Weights};
use crate::scenario::{Obstacle, Robot, World};
use std::f64::consts::{PI, TAU};

/// The most draws of starts and goals.
const DRAWS: u32 = 100_000;

crate::choice! {
    /// The shape of the robots.
    pub enum FleetShape {
        /// Discs.
        Disc,
        /// Rectangles twice as long as wide, whose corners lie on the circle of the disc.
        Rectangle,
    }
}

crate::choice! {
    /// Where robots of a hall go.
    pub enum HallGoals {
        /// Anywhere.
        Random,
        /// From one side to the other.
        Opposite,
    }
}

crate::options! {
    /// The robots, all alike.
    pub struct FleetRobots for &[];
    /// The shape of the robots: discs, or rectangles that fit into them.
    shape: FleetShape = FleetShape::Disc, "Shape";
    /// The radius of the robots.
    radius: f64 = 0.3, in 0.05..=0.5, "Radius", unit "m";
    /// The speed of the robots.
    speed: f64 = 1.0, in 0.01..=100.0, "Speed", unit "m/s";
}

crate::options! {
    /// Two robots in a corridor with a bay, each to the place of the other.
    pub struct SwapOptions for &[];
    /// The length of the corridor.
    length: f64 = 8.0, in 4.0..=100.0, "Length", unit "m";
    /// The width of the corridor and of its bay, in diameters of the robots: too narrow for two unless it is more than 2.
    width: f64 = 1.4, in 1.01..=4.0, "Width", unit "diameters";
    /// How the robots are.
    robots: FleetRobots;
    /// The seed: 0 (default) to 2^53 - 1.
    seed: u64 = 0, in SEEDS;
}

crate::options! {
    /// Two rooms and a corridor between them that lets one robot pass, used in both directions.
    pub struct CorridorOptions for &[];
    /// Number of robots; every other one goes from right to left.
    count: usize = 6, in 2.0..=16.0, "Robots";
    /// The length of the corridor.
    length: f64 = 3.0, in 1.0..=20.0, "Length", unit "m";
    /// How the robots are.
    robots: FleetRobots;
    /// The seed: 0 (default) to 2^53 - 1.
    seed: u64 = 0, in SEEDS;
}

crate::options! {
    /// Two streets that cross; robots come from all four sides and go straight on.
    pub struct CrossroadsOptions for &[];
    /// Number of robots.
    count: usize = 8, in 1.0..=16.0, "Robots";
    /// How the robots are.
    robots: FleetRobots;
    /// The seed: 0 (default) to 2^53 - 1.
    seed: u64 = 0, in SEEDS;
}

crate::options! {
    /// Robots on a circle, each to the other side of it, or to the place of the next one.
    pub struct RingOptions for &[];
    /// Number of robots.
    count: usize = 8, in 2.0..=40.0, "Robots";
    /// The radius of a pillar in the middle; 0 for none.
    pillar: f64 = 0.0, in 0.0..=5.0, "Pillar", unit "m";
    /// Whether each goes to the place of the next robot, in place of the other side.
    exchange: bool = false, "Exchange places";
    /// How the robots are.
    robots: FleetRobots;
    /// The seed: 0 (default) to 2^53 - 1.
    seed: u64 = 0, in SEEDS;
}

crate::options! {
    /// Robots in an open hall.
    pub struct HallOptions for &[];
    /// Number of robots.
    count: usize = 20, in 1.0..=1000.0, "Robots";
    /// The length of a side of the hall.
    side: Option<f64>, in 2.0..=200.0, "Side", unit "m", else "2 m times the root of the number of robots, 5 m at least";
    /// Where robots go: anywhere, or from one side to the other.
    goals: HallGoals = HallGoals::Random, "Goals";
    /// How the robots are.
    robots: FleetRobots;
    /// The seed: 0 (default) to 2^53 - 1.
    seed: u64 = 0, in SEEDS;
}

generators! {
    Fleet, fleet_generators:
    SwapOptions => "swap", "Swap", "Two robots in a corridor with a bay, each to the place of the other.";
    CorridorOptions => "corridor", "Corridor", "Two rooms and a corridor between them that lets one robot pass.";
    CrossroadsOptions => "crossroads", "Crossroads", "Two streets that cross; robots come from four sides and go straight on.";
    RingOptions => "ring", "Ring", "Robots on a circle, each to the other side of it or to the place of the next.";
    HallOptions => "hall", "Hall", "Robots in an open hall, from anywhere to anywhere or from side to side.";
}

impl FleetRobots {
    fn robot(&self) -> Result<Robot, Error> {
        if self.shape == FleetShape::Disc {
            return DiscRobot::new(self.radius).map(Robot::Disc);
        }
        // Twice as long as wide, on the circle.
        let half = 0.999 * self.radius / f64::sqrt(5.0);
        let shape = rectangle([-2.0 * half, -half], [2.0 * half, half]);
        Ok(Robot::RigidBody(RigidBody::new(shape, Weights::default())))
    }

    /// The fleet of such robots from places to places, each x, y and a heading.
    fn fleet(
        &self,
        (name, title): (String, String),
        [width, height]: [f64; 2],
        obstacles: Vec<Obstacle>,
        ways: &[[[f64; 3]; 2]],
    ) -> Result<Fleet, Error> {
        let robot = self.robot()?;
        let dimension = robot.dimension();
        let member = |(i, [start, goal]): (usize, &[[f64; 3]; 2])| FleetRobot {
            name: format!("{}", i + 1),
            robot: robot.clone(),
            speed: self.speed,
            start: start[..dimension].to_vec(),
            goal: goal[..dimension].to_vec(),
        };
        let bounds = Some(Aabb { min: Point::origin(), max: Point::new(width, height) });
        let world = World { bounds, obstacles: obstacles.into() };
        Fleet::of(name, Some(title), world, ways.iter().enumerate().map(member).collect())
    }

    /// The plural of the robots, for titles.
    fn word(&self) -> &'static str {
        if self.shape == FleetShape::Disc { "discs" } else { "bodies" }
    }
}

impl Generator for SwapOptions {
    type Made = Fleet;

    /// The seed places the bay along the corridor.
    fn make(&self) -> Result<Fleet, Error> {
        let Self { length, width, robots, seed } = *self;
        let mut random = Random::new(seed, Stream::Scenario);
        let wide = 2.0 * robots.radius * width;
        let room = length - 6.0 * wide;
        if room < 0.0 {
            let sentence = format!("the corridor must be at least {} long for this width, not {length}", 6.0 * wide);
            return Err(out_of_range("length", sentence));
        }
        let bay = length / 2.0 + room * (0.5 * random.uniform() - 0.25) - wide / 2.0;
        let walls = [([0.0, wide], [bay, 2.0 * wide]), ([bay + wide, wide], [length, 2.0 * wide])];
        let walls = walls.map(|(low, high)| Obstacle::Polygon(rectangle(low, high))).to_vec();
        let [left, right] = [wide, length - wide].map(|x| [x, wide / 2.0]);
        let ways = [[left, right, [0.0; 2]], [right, left, [PI; 2]]]
            .map(|[from, to, [heading, _]]| [[from[0], from[1], heading], [to[0], to[1], heading]]);
        let title = format!("Two {} that change places in a corridor with a bay, seed {seed}", robots.word());
        robots.fleet((format!("swap-{seed}"), title), [length, 2.0 * wide], walls, &ways)
    }
}

impl Generator for CorridorOptions {
    type Made = Fleet;

    /// The seed draws starts and goals in the rooms.
    fn make(&self) -> Result<Fleet, Error> {
        let Self { count, length, robots, seed } = *self;
        let mut random = Random::new(seed, Stream::Scenario);
        let room = 5.0;
        let (wide, all) = (2.8 * robots.radius, 2.0 * room + length);
        let walls =
            [([room, 0.0], [room + length, (room - wide) / 2.0]), ([room, (room + wide) / 2.0], [room + length, room])];
        let walls = walls.map(|(low, high)| Obstacle::Polygon(rectangle(low, high))).to_vec();
        // The mouths of the corridor stay free.
        let mouths =
            [room, room + length].map(|x| Disc { center: Point::new(x, room / 2.0), radius: 3.0 * robots.radius });
        let ways = drawn(&mut random, count, robots.radius, &mouths, |random, robot, is_goal| {
            let is_left = (robot % 2 == 0) != is_goal;
            let low = if is_left { 0.0 } else { all - room };
            ([low, 0.0], [low + room, room], heading(random))
        })?;
        let title = format!("{count} {} through a corridor in both directions, seed {seed}", robots.word());
        robots.fleet((format!("corridor-{count}-{seed}"), title), [all, room], walls, &ways)
    }
}

impl Generator for CrossroadsOptions {
    type Made = Fleet;

    /// The seed draws in which order the four sides are filled.
    fn make(&self) -> Result<Fleet, Error> {
        let Self { count, robots, seed } = *self;
        let mut random = Random::new(seed, Stream::Scenario);
        let (lane, gap) = (2.6 * robots.radius, 2.4 * robots.radius);
        let street = 2.0 * lane;
        // The robots that wait one behind the other.
        let depth = count.div_ceil(4);
        let block = gap * (depth as f64 + 1.0) + 2.0 * robots.radius;
        let side = 2.0 * block + street;
        let corners = [[0.0, 0.0], [side - block, 0.0], [0.0, side - block], [side - block, side - block]];
        let blocks = corners.map(|[x, y]| Obstacle::Polygon(rectangle([x, y], [x + block, y + block]))).to_vec();
        let first = random.below(4) as usize;
        let way = |robot: usize| {
            let (from, place) = ((first + robot) % 4, robot / 4);
            let out = block + lane - (gap * (place as f64 + 0.5) + robots.radius);
            // Before turning: from the left to the right, on the right-hand lane.
            let turn = from as f64 * PI / 2.0;
            let (sin, cos) = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][from];
            [-out, out].map(|x| {
                let y = -lane / 2.0;
                [side / 2.0 + cos * x - sin * y, side / 2.0 + sin * x + cos * y, turn]
            })
        };
        let ways: Vec<_> = (0..count).map(way).collect();
        let title = format!("{count} {} at a crossroads, seed {seed}", robots.word());
        robots.fleet((format!("crossroads-{count}-{seed}"), title), [side; 2], blocks, &ways)
    }
}

impl Generator for RingOptions {
    type Made = Fleet;

    /// The seed turns the ring.
    fn make(&self) -> Result<Fleet, Error> {
        let Self { count, pillar, exchange, robots, seed } = *self;
        let mut random = Random::new(seed, Stream::Scenario);
        // Starts and goals alternate along the circle.
        let around = (2.6 * robots.radius * 2.0 * count as f64 / TAU).max(pillar + 4.0 * robots.radius).max(2.0);
        let side = 2.0 * (around + 4.0 * robots.radius);
        let (spacing, turn) = (TAU / count as f64, TAU * random.uniform());
        let place = |angle: f64, heading: f64| {
            let (sin, cos) = libm::sincos(angle);
            [side / 2.0 + around * cos, side / 2.0 + around * sin, crate::geometry::wrap(heading)]
        };
        let way = |robot: usize| {
            let angle = turn + spacing * robot as f64;
            // Half a turn on, between two starts.
            let half = if count % 2 == 0 { spacing / 2.0 } else { 0.0 };
            if exchange {
                let next = (robot + 1) % count;
                return [angle, turn + spacing * next as f64].map(|at| place(at, at + PI));
            }
            [place(angle, angle + PI), place(angle + PI + half, angle + PI)]
        };
        let ways: Vec<_> = (0..count).map(way).collect();
        let center = Point::new(side / 2.0, side / 2.0);
        let pillars = (pillar > 0.0).then_some(Obstacle::Disc(Disc { center, radius: pillar })).into_iter().collect();
        let what = if exchange { "that exchange places on" } else { "across" };
        let title = format!("{count} {} {what} a ring, seed {seed}", robots.word());
        robots.fleet((format!("ring-{count}-{seed}"), title), [side; 2], pillars, &ways)
    }
}

impl Generator for HallOptions {
    type Made = Fleet;

    /// The seed draws starts and goals.
    fn make(&self) -> Result<Fleet, Error> {
        let Self { count, side, goals, robots, seed } = *self;
        let mut random = Random::new(seed, Stream::Scenario);
        let side = side.unwrap_or((2.0 * (count as f64).sqrt()).max(5.0));
        let third = side / 3.0;
        let ways = drawn(&mut random, count, robots.radius, &[], |random, robot, is_goal| {
            let (low, high) = match goals {
                HallGoals::Random => (0.0, side),
                HallGoals::Opposite if (robot % 2 == 0) != is_goal => (0.0, third),
                HallGoals::Opposite => (side - third, side),
            };
            ([low, 0.0], [high, side], heading(random))
        })?;
        let title = format!("{count} {} in an open hall, seed {seed}", robots.word());
        robots.fleet((format!("hall-{count}-{seed}"), title), [side; 2], Vec::new(), &ways)
    }
}

/// Draws starts and goals that are apart from each other by a fifth of the radius at least, and clear of some discs. `place`
/// gives the box of the start or the goal of a robot, and its heading.
fn drawn(
    random: &mut Random,
    count: usize,
    radius: f64,
    clear: &[Disc],
    place: impl Fn(&mut Random, usize, bool) -> ([f64; 2], [f64; 2], f64),
) -> Result<Vec<[[f64; 3]; 2]>, Error> {
    let mut placed: Vec<[f64; 3]> = Vec::with_capacity(2 * count);
    let mut draws = 0;
    while placed.len() < 2 * count {
        draws += 1;
        if draws > DRAWS {
            let sentence = format!("only {} of {count} robots could be placed in {DRAWS} draws", placed.len() / 2);
            return Err(out_of_range("count", sentence));
        }
        let (low, high, heading) = place(random, placed.len() / 2, placed.len() % 2 == 1);
        let margin = 1.1 * radius;
        let mut coordinate = |i: usize| low[i] + margin + random.uniform() * (high[i] - low[i] - 2.0 * margin);
        let at = [coordinate(0), coordinate(1), heading];
        let is_far = |x: f64, y: f64, least: f64| (at[0] - x) * (at[0] - x) + (at[1] - y) * (at[1] - y) > least * least;
        let is_apart = placed.iter().all(|other| is_far(other[0], other[1], 2.2 * radius));
        if is_apart && clear.iter().all(|disc| is_far(disc.center.x, disc.center.y, disc.radius + radius)) {
            placed.push(at);
        }
    }
    Ok(placed.chunks(2).map(|ends| [ends[0], ends[1]]).collect())
}

/// A heading drawn uniformly.
fn heading(random: &mut Random) -> f64 {
    PI * (1.0 - 2.0 * random.uniform())
}

/// A rectangle.
fn rectangle(low: [f64; 2], high: [f64; 2]) -> Polygon {
    let corners = [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]];
    Polygon::new(&corners.map(|[x, y]| Point::new(x, y))).expect("a rectangle with sides longer than 0")
}
