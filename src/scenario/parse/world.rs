//! Bounds and obstacles.

use super::{LARGEST, MAX_OBSTACLES, MAX_VERTICES};
use crate::decimal::Decimal;
use crate::error::{Code, Error, quoted};
use crate::geometry::{Aabb, Disc, Point, Polygon, PolygonFault};
use crate::scenario::reader::Reader;
use crate::scenario::{Obstacle, World};

/// Reads `world`.
pub(super) fn read(world: &Reader) -> Result<World, Error> {
    let fields = world.object()?;
    fields.only(&["bounds", "obstacles"])?;
    let bounds = fields.optional("bounds").map(|bounds| read_bounds(&bounds)).transpose()?;
    let obstacles = read_obstacles(&fields.required("obstacles")?)?;
    Ok(World { bounds, obstacles })
}

fn read_bounds(bounds: &Reader) -> Result<Aabb, Error> {
    let fields = bounds.object()?;
    fields.only(&["min", "max"])?;
    let (min, max) = (read_point(&fields.required("min")?)?, read_point(&fields.required("max")?)?);
    for (axis, low, high) in [("x", min.x, max.x), ("y", min.y, max.y)] {
        if low >= high {
            let [low, high] = [low, high].map(Decimal);
            let sentence = format!("in {axis} the bounds run from {low} to {high}; min must be less than max");
            return Err(bounds.error(Code::OutOfRange, sentence));
        }
    }
    Ok(Aabb { min, max })
}

/// Reads a point whose coordinates are finite and at most 1e6.
pub(super) fn read_point(point: &Reader) -> Result<Point, Error> {
    let [x, y] = point.tuple("a point")?;
    Ok(Point::new(read_coordinate(&x)?, read_coordinate(&y)?))
}

fn read_coordinate(coordinate: &Reader) -> Result<f64, Error> {
    coordinate.number_within("a coordinate", -LARGEST, LARGEST)
}

fn read_obstacles(obstacles: &Reader) -> Result<Vec<Obstacle>, Error> {
    let items = obstacles.items()?;
    if items.len() > MAX_OBSTACLES {
        let sentence = format!("there are {} obstacles; at most {MAX_OBSTACLES} are allowed", items.len());
        return Err(obstacles.error(Code::TooLarge, sentence));
    }
    let mut vertices_left = MAX_VERTICES;
    items.map(|item| read_obstacle(&item, &mut vertices_left)).collect()
}

fn read_obstacle(obstacle: &Reader, vertices_left: &mut usize) -> Result<Obstacle, Error> {
    let fields = obstacle.object()?;
    let kind = fields.required("type")?;
    match kind.string()? {
        "disc" => {
            fields.only(&["type", "center", "radius"])?;
            let center = read_point(&fields.required("center")?)?;
            let radius = fields.required("radius")?;
            Ok(Obstacle::Disc(Disc { center, radius: read_positive(&radius)? }))
        }
        "polygon" => {
            fields.only(&["type", "vertices"])?;
            Ok(Obstacle::Polygon(read_polygon(&fields.required("vertices")?, vertices_left)?))
        }
        other => {
            let sentence = format!("there is no obstacle of type {}; there are disc and polygon", quoted(other));
            Err(kind.error(Code::UnknownType, sentence))
        }
    }
}

fn read_positive(radius: &Reader) -> Result<f64, Error> {
    let value = radius.number_within("a radius", 0.0, LARGEST)?;
    if value == 0.0 {
        return Err(radius.error(Code::OutOfRange, "the radius of an obstacle must be greater than 0"));
    }
    Ok(value)
}

/// Reads the corners of a simple polygon, which count against those that are left.
pub(super) fn read_polygon(vertices: &Reader, vertices_left: &mut usize) -> Result<Polygon, Error> {
    let items = vertices.items()?;
    *vertices_left = vertices_left.checked_sub(items.len()).ok_or_else(|| {
        vertices.error(Code::TooLarge, format!("with this one, the polygons have more than {MAX_VERTICES} vertices"))
    })?;
    let points = items.map(|item| read_point(&item)).collect::<Result<Vec<Point>, Error>>()?;
    Polygon::new(&points).map_err(|fault| {
        let sentence = match fault {
            PolygonFault::TooFewVertices => {
                format!("a polygon has at least three distinct vertices; of these {} too few differ", points.len())
            }
            PolygonFault::ZeroArea => format!("the {} vertices lie on one line", points.len()),
            PolygonFault::SelfCrossing(i, j) => {
                format!("the edges from vertex {i} and from vertex {j} touch or cross: the polygon is not simple")
            }
        };
        vertices.error(Code::DegeneratePolygon, sentence)
    })
}
