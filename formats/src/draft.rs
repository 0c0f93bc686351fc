//! A world as a reader has found it, in the coordinates of the file, and the scenario made of it.

use crate::error::{Code, FormatError, Place};
use crate::grid::Grid;
use crate::options::{Options, RobotChoice};
use crate::report::{Format, Obstacles, PlaneRead, QueryRead, Report};
use crate::vector::Frame;
use planarium::geometry::{Aabb, Point, Polygon};
use planarium::robot::{Car, DiscRobot, RigidBody, Weights};
use planarium::scenario::{
    self, GoalTolerance, MAX_OBSTACLES, MapFrame, MapPlane, Obstacle, Query, Robot, Scenario, World,
};

/// Where a coordinate is larger than this, in metres, all are moved: a scenario allows 1e6, and digits get lost.
pub const FAR: f64 = 1e5;

/// How far an obstacle without area is grown to have one, in metres.
const THICKNESS: f64 = 1e-6;

/// In worlds smaller than this, in metres along the longer side, a radian counts for as much less in the metric of a body or a
/// car as they are smaller: else turns alone would decide which placements are near, and steps of a tree would be turns.
const METRIC: f64 = 10.0;

/// The step of integration of cars, in seconds.
const INTEGRATION_STEP: f64 = 0.01;

/// The speed of cars that are options, forward and backward, in metres per second.
const SPEED: f64 = 1.0;

/// What a reader has found.
pub struct Draft {
    pub name: String,
    pub polygons: Vec<Vec<Point>>,
    pub discs: Vec<(Point, f64)>,
    /// Obstacles of drawings, which have been moved already.
    pub made: Vec<Obstacle>,
    /// Where ends of queries are degrees, the way to metres.
    pub plane: Option<Frame>,
    pub bounds: Aabb,
    /// What the reader has subtracted from all but the queries, so that cells far from the origin keep their digits.
    pub moved: Point,
    pub queries: Vec<DraftQuery>,
    /// The robot of the format, and the words for it.
    pub robot: Option<(Robot, &'static str)>,
    pub grid: Option<Grid>,
    /// The cells of the grid that are obstacles.
    pub blocked: Vec<bool>,
    pub report: Report,
}

/// A query: places, and headings where the format has them.
pub struct DraftQuery {
    pub read: QueryRead,
    pub start: [f64; 2],
    pub goal: [f64; 2],
    pub headings: Option<[f64; 2]>,
    pub tolerance: Option<GoalTolerance>,
}

impl DraftQuery {
    pub fn new(name: impl Into<String>, start: [f64; 2], goal: [f64; 2]) -> Self {
        let read = QueryRead { name: name.into(), bucket: None, length: None, blocked: false };
        Self { read, start, goal, headings: None, tolerance: None }
    }
}

impl Draft {
    /// Nothing yet; the bounds have to be set.
    pub fn new(format: Format, file: &str) -> Self {
        Self {
            name: stem(file).to_owned(),
            polygons: Vec::new(),
            discs: Vec::new(),
            made: Vec::new(),
            plane: None,
            bounds: Aabb::of(Point::origin(), Point::origin()),
            moved: Point::origin(),
            queries: Vec::new(),
            robot: None,
            grid: None,
            blocked: Vec::new(),
            report: Report::new(format),
        }
    }

    /// The scenario, the report and the picture.
    pub fn finish(mut self, options: &Options) -> Result<crate::World, FormatError> {
        check_finite(self.bounds)?;
        self.add_given_query(options)?;
        let (robot, mut words) = self.robot(options)?;
        let robot = robot.with_margin(options.margin).map_err(|error| invalid_option(&error))?;
        if robot.margin() > 0.0 {
            words = format!("{words}; a margin of {} m", robot.margin());
        }
        self.report.robot = words;
        let offset = self.recentre();
        self.report.offset = [offset.x, offset.y];
        self.mark_blocked();
        let Aabb { min, max } = self.bounds;
        self.report.bounds = [[min.x, min.y], [max.x, max.y]];
        let obstacles = self.obstacles()?;
        let queries = self.queries(&robot);
        let world = World::new(Some(self.bounds), obstacles);
        let invalid = |error: planarium::Error| {
            FormatError::new(Code::InvalidScenario, error.message()).at(Place::Element(error.pointer().to_owned()))
        };
        let frame = frame(&self.report).map_err(invalid)?;
        let scenario = Scenario::new(self.name, world, robot, queries).map_err(invalid)?.in_frame(frame);
        Ok(crate::World { scenario, report: self.report, grid: self.grid })
    }

    /// The query of the options comes first.
    fn add_given_query(&mut self, options: &Options) -> Result<(), FormatError> {
        let invalid = |sentence: String| Err(FormatError::new(Code::InvalidOption, sentence));
        let (start, goal) = match (&options.start, &options.goal) {
            (None, None) => return Ok(()),
            (Some(start), Some(goal)) => (start, goal),
            _ => return invalid("a query needs both a start and a goal".to_owned()),
        };
        let is_disc = match &options.robot {
            RobotChoice::Disc { .. } => true,
            RobotChoice::Format => self.robot.is_none(),
            RobotChoice::Footprint { .. } | RobotChoice::Car { .. } => false,
        };
        for (what, place) in [("start", start), ("goal", goal)] {
            let most = if is_disc { 2 } else { 3 };
            if !(2..=most).contains(&place.len()) {
                let form = if is_disc { "x and y" } else { "x, y and maybe theta" };
                return invalid(format!("a {what} of this robot is {form}, not {} numbers", place.len()));
            }
            if let Some(number) = place.iter().find(|number| !number.is_finite()) {
                return invalid(format!("the {what} has the number {number}"));
            }
        }
        let mut name = "given".to_owned();
        while self.queries.iter().any(|query| query.read.name == name) {
            name.push('\'');
        }
        let metres = |place: &[f64]| {
            let given = Point::new(place[0], place[1]);
            let p = self.plane.map_or(given, |plane| plane.to_metres(given));
            [p.x, p.y]
        };
        let mut query = DraftQuery::new(name, metres(start), metres(goal));
        let heading = |place: &[f64]| place.get(2).copied().unwrap_or(0.0);
        query.headings = Some([heading(start), heading(goal)]);
        self.queries.insert(0, query);
        Ok(())
    }

    /// Notes which queries begin or end in a cell that is an obstacle.
    fn mark_blocked(&mut self) {
        let Some(grid) = &self.grid else { return };
        for query in &mut self.queries {
            let is_blocked = |[x, y]: [f64; 2]| grid.index_at(Point::new(x, y)).is_none_or(|i| self.blocked[i]);
            query.read.blocked = is_blocked(query.start) || is_blocked(query.goal);
        }
    }

    /// The robot and the words for it.
    fn robot(&self, options: &Options) -> Result<(Robot, String), FormatError> {
        let invalid = |error: planarium::Error| invalid_option(&error);
        let polygon = |corners: &[[f64; 2]]| -> Result<Polygon, FormatError> {
            let corners: Vec<Point> = corners.iter().map(|&[x, y]| Point::new(x, y)).collect();
            scenario::polygon(&corners).map_err(invalid)
        };
        Ok(match &options.robot {
            RobotChoice::Format => match &self.robot {
                Some((robot, words)) => (robot.clone(), (*words).to_owned()),
                None => {
                    (DiscRobot::new(0.0).map_err(invalid)?.into(), "a point; choose another with an option".to_owned())
                }
            },
            &RobotChoice::Disc { radius } => {
                (DiscRobot::new(radius).map_err(invalid)?.into(), format!("a disc of radius {radius} m"))
            }
            RobotChoice::Footprint { corners } => {
                let body = RigidBody::new(polygon(corners)?, self.weights().map_err(invalid)?);
                (body.into(), format!("a footprint of {} corners that turns", corners.len()))
            }
            &RobotChoice::Car { length, width, wheelbase, steering } => {
                if wheelbase >= length || wheelbase.is_nan() || length.is_nan() {
                    let sentence = format!("a car of {length} m cannot have a wheelbase of {wheelbase} m");
                    return Err(FormatError::new(Code::InvalidOption, sentence));
                }
                let rear = (wheelbase - length) / 2.0;
                let [front, side] = [rear + length, width / 2.0];
                let shape = polygon(&[[rear, -side], [front, -side], [front, side], [rear, side]])?;
                let limits = [[-SPEED, SPEED], [-steering, steering]];
                let weights = self.weights().map_err(invalid)?;
                let car = Car::new(shape, wheelbase, limits[0], limits[1], INTEGRATION_STEP, weights);
                let words =
                    format!("a car of {length} x {width} m, wheelbase {wheelbase} m, steering up to {steering} rad");
                (car.map_err(invalid)?.into(), words)
            }
        })
    }

    /// The metric of a robot that turns.
    fn weights(&self) -> Result<Weights, planarium::Error> {
        let Weights { translation, rotation } = Weights::default();
        Weights::new(translation, rotation * (self.bounds.longer_side() / METRIC).clamp(1e-9, 1.0))
    }

    /// Moves everything if a coordinate is far from the origin, by whole metres, so that the difference is exact.
    /// Returns what was subtracted.
    fn recentre(&mut self) -> Point {
        let moved = self.moved;
        self.shift_queries(moved);
        let corners = [self.bounds.min, self.bounds.max];
        if largest(corners) <= FAR || moved != Point::origin() {
            return moved;
        }
        let offset = middle(corners[0], corners[1]);
        let shift = |p: &mut Point| *p = Point::new(p.x - offset.x, p.y - offset.y);
        self.polygons.iter_mut().flatten().for_each(shift);
        self.discs.iter_mut().map(|(center, _)| center).for_each(shift);
        shift(&mut self.bounds.min);
        shift(&mut self.bounds.max);
        if let Some(grid) = &mut self.grid {
            shift(&mut grid.frame.origin);
        }
        self.shift_queries(offset);
        Point::new(moved.x + offset.x, moved.y + offset.y)
    }

    fn shift_queries(&mut self, offset: Point) {
        for place in self.queries.iter_mut().flat_map(|query| [&mut query.start, &mut query.goal]) {
            *place = [place[0] - offset.x, place[1] - offset.y];
        }
    }

    /// The obstacles; those without area are grown to have one, since they separate as well.
    fn obstacles(&mut self) -> Result<Vec<Obstacle>, FormatError> {
        let count = self.polygons.len() + self.discs.len() + self.made.len();
        if count > MAX_OBSTACLES {
            let sentence = format!("there are {count} obstacles; a scenario has at most {MAX_OBSTACLES}");
            return Err(FormatError::new(Code::WorldTooLarge, sentence));
        }
        let mut obstacles = Vec::with_capacity(count);
        let mut flat = 0;
        for (i, corners) in self.polygons.iter().enumerate() {
            let corners = if is_flat(corners) {
                flat += 1;
                &thickened(corners)
            } else {
                corners
            };
            let polygon = scenario::polygon(corners).map_err(|error| {
                FormatError::new(Code::InvalidFile, error.message()).at(Place::Element(format!("obstacle {i}")))
            })?;
            obstacles.push(polygon.into());
        }
        obstacles.append(&mut self.made);
        let points = self.discs.iter().filter(|(_, radius)| *radius == 0.0).count();
        obstacles.extend(self.discs.iter().map(|&(center, radius)| Obstacle::disc(center, radius.max(THICKNESS))));
        if flat + points > 0 {
            self.report.grown = self.report.grown.max(2.0 * THICKNESS);
            let sentence = format!("{} obstacles without area are grown by {THICKNESS:e} m to have one", flat + points);
            self.report.notes.push(sentence);
        }
        self.report.obstacles = Obstacles::of(&obstacles);
        Ok(obstacles)
    }

    /// Adds a wall along points, not all of which are the same; a disc if they are.
    pub fn add_wall(&mut self, points: &[Point], width: f64, closed: bool) -> Result<(), FormatError> {
        match points {
            [] => {}
            [center, rest @ ..] if rest.iter().all(|p| p == center) => self.discs.push((*center, width / 2.0)),
            _ => {
                let wall = Obstacle::wall(points, width, closed)
                    .map_err(|error| FormatError::new(Code::InvalidNumber, error.message()))?;
                self.made.push(wall);
            }
        }
        Ok(())
    }

    /// The queries for a robot: headings are dropped where it has none, and 0 where the file has none.
    fn queries(&mut self, robot: &Robot) -> Vec<Query> {
        let turns = robot.dimension() == 3;
        let with = self.queries.iter().filter(|query| query.headings.is_some()).count();
        let without = self.queries.len() - with;
        if turns && without > 0 {
            self.report.notes.push(format!("{without} queries have no headings in the file; they are 0"));
        }
        let is_of_file = |query: &&DraftQuery| query.headings.is_some() && query.tolerance.is_some();
        let dropped = self.queries.iter().filter(is_of_file).count();
        if !turns && dropped > 0 {
            self.report.notes.push(format!("the headings of {dropped} queries are dropped: the robot does not turn"));
        }
        let tolerance = match robot {
            // A car driven by controls ends in a region.
            Robot::Car(car) => Some(GoalTolerance { translation: car.wheelbase() / 10.0, rotation: 0.1 }),
            _ => None,
        };
        let query = |query: DraftQuery| {
            self.report.queries.push(query.read.clone());
            let [from, to] = query.headings.unwrap_or_default();
            let place = |[x, y]: [f64; 2], heading: f64| if turns { vec![x, y, heading] } else { vec![x, y] };
            let mut made = Query::new(query.read.name, place(query.start, from), place(query.goal, to));
            made.goal_tolerance = tolerance.map(|default| query.tolerance.unwrap_or(default));
            made
        };
        std::mem::take(&mut self.queries).into_iter().map(query).collect()
    }
}

/// Refuses bounds that are not finite.
pub fn check_finite(Aabb { min, max }: Aabb) -> Result<(), FormatError> {
    if [min.x, min.y, max.x, max.y].iter().all(|number| number.is_finite()) {
        return Ok(());
    }
    Err(FormatError::new(Code::InvalidNumber, "the coordinates are too large for 64-bit numbers"))
}

/// The largest coordinate, without its sign; 0 without points.
pub fn largest(points: impl IntoIterator<Item = Point>) -> f64 {
    points.into_iter().flat_map(|p| [p.x.abs(), p.y.abs()]).fold(0.0, f64::max)
}

/// The middle of two corners, in whole metres.
pub fn middle(min: Point, max: Point) -> Point {
    Point::new((min.x / 2.0 + max.x / 2.0).round(), (min.y / 2.0 + max.y / 2.0).round())
}

/// Whether all corners lie on one line.
fn is_flat(corners: &[Point]) -> bool {
    let Some((&first, rest)) = corners.split_first() else { return true };
    let Some(&other) = rest.iter().find(|&&p| p != first) else { return true };
    corners.iter().all(|&p| planarium::geometry::orientation(first, other, p) == 0.0)
}

/// A rectangle around corners that lie on one line.
fn thickened(corners: &[Point]) -> Vec<Point> {
    let first = corners.first().copied().unwrap_or(Point::origin());
    let far = |from: Point| {
        let apart = |p: &Point| (p.x - from.x).hypot(p.y - from.y);
        corners.iter().copied().max_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap_or(from)
    };
    let a = far(first);
    let b = far(a);
    let length = (b.x - a.x).hypot(b.y - a.y);
    let [x, y] = if length > 0.0 { [(b.x - a.x) / length, (b.y - a.y) / length] } else { [1.0, 0.0] };
    let corner = |p: Point, along: f64, across: f64| {
        Point::new(p.x + THICKNESS * (along * x - across * y), p.y + THICKNESS * (along * y + across * x))
    };
    vec![corner(a, -1.0, 1.0), corner(a, -1.0, -1.0), corner(b, 1.0, -1.0), corner(b, 1.0, 1.0)]
}

/// The name of a file without folders and extension.
pub fn stem(file: &str) -> &str {
    let base = base(file);
    match base.rfind('.') {
        Some(dot) if dot > 0 => &base[..dot],
        _ if base.is_empty() || base == "-" => "world",
        _ => base,
    }
}

/// The name of a file without folders.
pub fn base(file: &str) -> &str {
    file.rsplit(['/', '\\']).next().unwrap_or(file)
}

/// An option that the core refuses.
fn invalid_option(error: &planarium::Error) -> FormatError {
    FormatError::new(Code::InvalidOption, error.message())
}

/// The frame of the map. People have paths in the units of GeoJSON and WKT; of other files they have them in metres.
fn frame(report: &Report) -> Result<MapFrame, planarium::Error> {
    let plane = report.plane.as_ref().filter(|_| matches!(report.format, Format::GeoJson | Format::Wkt));
    let plane = plane.map(|&PlaneRead { origin, scale, error }| MapPlane { origin, scale, degrees: error.is_some() });
    MapFrame::new(report.offset, plane)
}
