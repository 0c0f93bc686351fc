//! The obstacles of a world: discs, polygons with and without holes, and walls; how they are read and checked.

use super::{LARGEST, MAX_VERTICES, document};
use crate::error::{Code, Error, within};
use crate::geometry::{
    Aabb, Disc, HoleFault, MIN_MAGNITUDE, Placed, Point, Polygon, PolygonFault, PolygonWithHoles, Segment, Wall,
    WallFault, distance_point_segment, intersects_segment_polygon,
};
use serde::Serialize;

/// A closed obstacle, filled but for the holes of a polygon.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Obstacle {
    /// A disc of positive radius.
    Disc(Disc),
    /// A simple polygon, convex or concave.
    Polygon(Polygon),
    /// A polygon with at least one hole.
    PolygonWithHoles(PolygonWithHoles),
    /// A chain of segments with a width.
    Wall(Wall),
}

impl From<Polygon> for Obstacle {
    fn from(polygon: Polygon) -> Self {
        Self::Polygon(polygon)
    }
}

impl From<Wall> for Obstacle {
    fn from(wall: Wall) -> Self {
        Self::Wall(wall)
    }
}

impl Obstacle {
    /// A disc: centre and radius in metres.
    pub fn disc(center: Point, radius: f64) -> Self {
        Self::Disc(Disc { center, radius })
    }

    /// The smallest box around the obstacle.
    pub fn aabb(&self) -> Aabb {
        match self {
            Obstacle::Disc(disc) => disc.aabb(),
            Obstacle::Polygon(polygon) => *polygon.aabb(),
            Obstacle::PolygonWithHoles(polygon) => *polygon.aabb(),
            Obstacle::Wall(wall) => wall.aabb(),
        }
    }

    /// How many points its document lists: corners of all rings, or points of a wall; none of a disc.
    pub fn points(&self) -> usize {
        match self {
            Obstacle::Disc(_) => 0,
            Obstacle::Polygon(polygon) => polygon.vertices().len(),
            Obstacle::PolygonWithHoles(polygon) => polygon.rings().map(|ring| ring.vertices().len()).sum(),
            Obstacle::Wall(wall) => wall.points().len(),
        }
    }

    /// How far the obstacle reaches beyond its edges, in metres: half the width of a wall.
    pub(crate) fn edge_radius(&self) -> f64 {
        if let Obstacle::Wall(wall) = self { wall.radius() } else { 0.0 }
    }

    /// Calls `visit` with every edge of a polygon, of its holes, or of a wall whose box meets the given one, until it returns
    /// true; returns whether it did.
    pub(crate) fn any_edge_near(&self, near: &Aabb, mut visit: impl FnMut(&Segment) -> bool) -> bool {
        match self {
            Obstacle::Disc(_) => false,
            Obstacle::Polygon(polygon) => polygon.any_edge_near(near, |_, edge| visit(edge)),
            Obstacle::PolygonWithHoles(polygon) => polygon.any_edge_near(near, visit),
            Obstacle::Wall(wall) => wall.any_segment_near(near, visit),
        }
    }

    /// Whether the closed segment shares a point with the obstacle, decided exactly; `None` if the border is round: of a disc,
    /// and of a wall with a width.
    pub fn meets_segment(&self, segment: &Segment) -> Option<bool> {
        match self {
            Obstacle::Polygon(polygon) => Some(intersects_segment_polygon(segment, polygon)),
            Obstacle::PolygonWithHoles(polygon) => Some(polygon.intersects_segment(segment)),
            Obstacle::Wall(wall) if wall.width() == 0.0 => Some(wall.line_meets_segment(segment)),
            Obstacle::Disc(_) | Obstacle::Wall(_) => None,
        }
    }

    /// The distance from the segment to the obstacle, in metres; 0 or less if they share a point.
    pub fn distance_to_segment(&self, segment: &Segment) -> f64 {
        self.distance_to_segment_within(segment, f64::INFINITY)
    }

    /// The same; if it is `most` or more, that distance or infinity.
    pub fn distance_to_segment_within(&self, segment: &Segment, most: f64) -> f64 {
        match self {
            Obstacle::Disc(disc) => distance_point_segment(disc.center, segment) - disc.radius,
            Obstacle::Polygon(polygon) => Placed::resting(polygon).distance_to_segment(segment, most, &mut 0),
            Obstacle::PolygonWithHoles(polygon) => polygon.distance_to_segment(segment, most),
            Obstacle::Wall(wall) => wall.distance_to_segment(segment, most),
        }
    }

    /// The distance from the polygon to the obstacle, in metres; 0 or less if they share a point.
    pub fn distance_to_polygon(&self, other: &Polygon) -> f64 {
        self.distance_to_polygon_within(other, f64::INFINITY)
    }

    /// The same; if it is `most` or more, that distance or infinity.
    pub fn distance_to_polygon_within(&self, other: &Polygon, most: f64) -> f64 {
        let other = Placed::resting(other);
        match self {
            Obstacle::Disc(disc) => other.distance_to_point(disc.center, most + disc.radius, &mut 0) - disc.radius,
            Obstacle::Polygon(polygon) => other.distance(&Placed::resting(polygon), most, &mut 0),
            Obstacle::PolygonWithHoles(polygon) => polygon.distance_to_polygon(&other, most),
            Obstacle::Wall(wall) => wall.distance_to_polygon(&other, most),
        }
    }
}

impl Obstacle {
    /// A simple polygon with these corners, in metres, in either direction, closed or open.
    ///
    /// # Errors
    /// Those of [`polygon`].
    pub fn polygon(corners: &[Point]) -> Result<Self, Error> {
        self::polygon(corners).map(Obstacle::Polygon)
    }

    /// A simple polygon with these corners and without the insides of these holes, each likewise in either direction, closed
    /// or open. Rings may touch in single points.
    ///
    /// # Errors
    /// Those of [`polygon`], at a hole with the pointer `/holes/i`; `degenerate-polygon` if a hole is not within the outline,
    /// is within another one, or crosses a ring or shares more than single points with it.
    ///
    /// # Example
    /// A room, 2 by 2 metres, whose door is a gap in the wall on its right:
    ///
    /// ```
    /// use planarium::geometry::{Point, Segment};
    /// use planarium::scenario::Obstacle;
    ///
    /// let ring = |low: f64, high: f64| [[low, low], [high, low], [high, high], [low, high]].map(|[x, y]| Point::new(x, y));
    /// let frame = Obstacle::polygon_with_holes(&ring(0.0, 3.0), &[ring(0.5, 2.5).to_vec()])?;
    /// let center = Point::new(1.5, 1.5);
    /// assert_eq!(frame.distance_to_segment(&Segment::new(center, center)), 1.0);
    ///
    /// let room = [[2.0, 1.2], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0], [2.0, 0.0], [2.0, 0.8]].map(|[x, y]| Point::new(x, y));
    /// let wall = Obstacle::wall(&room, 0.1, false)?;
    /// let door = Point::new(2.0, 1.0);
    /// assert!((wall.distance_to_segment(&Segment::new(door, door)) - 0.15).abs() < 1e-15);
    /// # Ok::<(), planarium::Error>(())
    /// ```
    pub fn polygon_with_holes(corners: &[Point], holes: &[Vec<Point>]) -> Result<Self, Error> {
        let hole =
            |(i, hole): (usize, &Vec<Point>)| self::polygon(hole).map_err(|error| error.at(format!("/holes/{i}")));
        with_holes(self::polygon(corners)?, holes.iter().enumerate().map(hole).collect::<Result<_, _>>()?)
    }

    /// All within half the width of the segments that join the points, in metres; of a closed wall the last point is joined to
    /// the first, and what it encloses is free. It may cross itself; the width may be 0.
    ///
    /// # Errors
    /// `degenerate-wall`, pointer `/points`, unless two points differ and coordinates are 0 or at least 1e-140 in magnitude;
    /// `out-of-range` or `not-finite`, pointer `/width`, unless the width is from 0 to 1e6.
    pub fn wall(points: &[Point], width: f64, closed: bool) -> Result<Self, Error> {
        let width = within("/width", "a width", width, 0.0..=LARGEST)?;
        Wall::new(points, width + 0.0, closed).map(Obstacle::Wall).map_err(|fault| {
            let sentence = match fault {
                WallFault::Magnitude(i) => {
                    format!("point {i} has a coordinate that is neither 0 nor at least {MIN_MAGNITUDE:e} in magnitude")
                }
                WallFault::TooFewPoints => {
                    format!("a wall has at least two distinct points; of these {} none differ", points.len())
                }
            };
            Error::new(Code::DegenerateWall, "/points", sentence)
        })
    }
}

/// An obstacle; its vertices are subtracted from the remaining ones.
pub(super) fn checked_obstacle(obstacle: document::Obstacle, vertices_left: &mut usize) -> Result<Obstacle, Error> {
    match obstacle {
        document::Obstacle::Disc(disc) => {
            Ok(Obstacle::Disc(Disc { center: point(disc.center), radius: disc.radius.0 }))
        }
        document::Obstacle::Polygon(polygon) => {
            let outline = checked_ring(&polygon.vertices, "/vertices", vertices_left)?;
            let hole =
                |(i, hole): (usize, &Vec<document::Point>)| checked_ring(hole, &format!("/holes/{i}"), vertices_left);
            let holes = polygon.holes.iter().enumerate().map(hole).collect::<Result<_, _>>()?;
            with_holes(outline, holes)
        }
        document::Obstacle::Wall(wall) => {
            count_vertices(wall.points.len(), "/points", vertices_left)?;
            let points: Vec<Point> = wall.points.iter().copied().map(point).collect();
            Obstacle::wall(&points, wall.width.0, wall.closed)
        }
    }
}

pub(super) fn point(document::Point(x, y): document::Point) -> Point {
    Point::new(x.0, y.0)
}

/// A simple polygon; its vertices are subtracted from the remaining ones.
pub(crate) fn checked_polygon(polygon: &document::Polygon, vertices_left: &mut usize) -> Result<Polygon, Error> {
    checked_ring(&polygon.vertices, "/vertices", vertices_left)
}

/// The polygon that a ring bounds; its vertices are subtracted from the remaining ones.
fn checked_ring(ring: &[document::Point], pointer: &str, vertices_left: &mut usize) -> Result<Polygon, Error> {
    count_vertices(ring.len(), pointer, vertices_left)?;
    let points: Vec<Point> = ring.iter().copied().map(point).collect();
    self::polygon(&points).map_err(|error| error.at(pointer))
}

/// Subtracts vertices from the remaining ones.
fn count_vertices(count: usize, pointer: &str, vertices_left: &mut usize) -> Result<(), Error> {
    *vertices_left = vertices_left.checked_sub(count).ok_or_else(|| {
        let sentence = format!("with this one, the polygons, holes and walls have more than {MAX_VERTICES} vertices");
        Error::new(Code::TooLarge, pointer, sentence)
    })?;
    Ok(())
}

/// A polygon, with holes if there are any.
fn with_holes(outline: Polygon, holes: Vec<Polygon>) -> Result<Obstacle, Error> {
    if holes.is_empty() {
        return Ok(Obstacle::Polygon(outline));
    }
    PolygonWithHoles::new(outline, holes).map(Obstacle::PolygonWithHoles).map_err(|fault| {
        let (ring, sentence) = match fault {
            HoleFault::Crossing(0, j) => {
                (j, "the hole and the outline cross, or share more than single points".to_owned())
            }
            HoleFault::Crossing(i, j) => {
                (j, format!("the hole and hole {} cross, or share more than single points", i - 1))
            }
            HoleFault::Outside(i) => (i, "the hole lies outside the outline".to_owned()),
            HoleFault::Nested(i, j) => (i, format!("the hole lies within hole {}", j - 1)),
        };
        Error::new(Code::DegeneratePolygon, format!("/holes/{}", ring - 1), sentence)
    })
}

/// A simple polygon with these corners, in metres, in either direction, closed or open.
///
/// # Errors
/// `degenerate-polygon`, pointer `/vertices`.
///
/// # Complexity
/// O(n log n) predicates for n corners.
pub fn polygon(corners: &[Point]) -> Result<Polygon, Error> {
    Polygon::new(corners).map_err(|fault| {
        let sentence = match fault {
            PolygonFault::Magnitude(i) => {
                format!("vertex {i} has a coordinate that is neither 0 nor at least {MIN_MAGNITUDE:e} in magnitude")
            }
            PolygonFault::TooFewVertices => {
                format!("a polygon has at least three distinct vertices; too few of these {} differ", corners.len())
            }
            PolygonFault::ZeroArea => format!("the {} vertices lie on one line", corners.len()),
            PolygonFault::SelfCrossing(i, j) => {
                format!("the edges from vertex {i} and from vertex {j} touch or cross: the polygon is not simple")
            }
        };
        Error::new(Code::DegeneratePolygon, "/vertices", sentence)
    })
}
