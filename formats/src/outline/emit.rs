//! Shapes with curves become areas, lines and discs of a drawing, which contain them.

use super::affine::{Affine, P3};
use super::curve::flatten;
use super::grow::{Flat, grown};
use super::joints::{square_ends, tips};
use super::{Cap, Path, Piece, Stroke};
use crate::error::{Code, FormatError};
use crate::options::{Options, TOLERANCE};
use crate::vector::{Drawing, FillRule, Form, LayerId};
use planarium::geometry::Point;
use planarium::scenario::MAX_VERTICES;

/// The most points that all shapes may have.
const MAX_POINTS: usize = 4_000_000;

/// The largest coordinate in metres.
const MAX_COORDINATE: f64 = 1e12;

/// The bound of the error of curves is at most this part of the drawing, where the options have none.
const PART: f64 = 1e-3;

/// How round a disc must be: by how much one radius may be larger than the other.
const ROUND: f64 = 1e-9;

/// A shape of a file.
#[derive(Debug, Clone)]
pub struct Shape {
    pub layer: LayerId,
    pub paths: Vec<Path>,
    /// The center and the radius, if it is a circle: it is a disc then, if it is filled.
    pub circle: Option<(P3, f64)>,
    /// From the coordinates of its paths to metres.
    pub map: Affine,
    pub fill: Option<FillRule>,
    pub stroke: Option<Stroke>,
}

/// Adds shapes to a drawing. Without a tolerance in the options, it is as coarse as it must be for a scenario, up to a
/// part of the drawing.
pub fn add_shapes(drawing: &mut Drawing, shapes: &[Shape], options: &Options) -> Result<(), FormatError> {
    let most = match options.tolerance {
        Some(tolerance) => tolerance,
        None => coarsest(shapes)?,
    };
    let mut tolerance = options.tolerance.unwrap_or(TOLERANCE.min(most));
    loop {
        let walkable = options.walkable == Some(true);
        let mut emitter = Emitter { forms: Vec::new(), vertices: 0, flattened: 0.0, tolerance, walkable, points: 0 };
        let added = shapes.iter().try_for_each(|shape| {
            emitter.add(shape)?;
            let is_too_fine = emitter.vertices > MAX_VERTICES && emitter.flattened > 0.0;
            if is_too_fine && tolerance < most { Err(too_many()) } else { Ok(()) }
        });
        let is_too_large = added.as_ref().is_err_and(|error| error.code() == Code::WorldTooLarge);
        if is_too_large && tolerance < most {
            tolerance = (4.0 * tolerance).min(most);
            continue;
        }
        added?;
        drawing.flattened = drawing.flattened.max(emitter.flattened);
        emitter.forms.into_iter().for_each(|(layer, form)| drawing.push(layer, form));
        return Ok(());
    }
}

/// The coarsest tolerance that is taken by itself.
fn coarsest(shapes: &[Shape]) -> Result<f64, FormatError> {
    let mut range = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    let mut include = |map: &Affine, p: P3| -> Result<(), FormatError> {
        let p = seen(map, p)?;
        for (range, value) in range.iter_mut().zip([p.x, p.y]) {
            *range = [range[0].min(value), range[1].max(value)];
        }
        Ok(())
    };
    for shape in shapes {
        for path in &shape.paths {
            include(&shape.map, path.start)?;
            for piece in &path.pieces {
                match piece {
                    Piece::Line(to) => include(&shape.map, *to)?,
                    Piece::Curve(curve) => curve.0.iter().try_for_each(|control| include(&shape.map, control.0))?,
                }
            }
        }
    }
    let size = range.iter().map(|[low, high]| high - low).fold(0.0, f64::max);
    Ok(if size > 0.0 { PART * size } else { TOLERANCE })
}

/// Where a point is seen.
fn seen(map: &Affine, p: P3) -> Result<Point, FormatError> {
    let [x, y, _] = map.apply(p);
    if x.abs() <= MAX_COORDINATE && y.abs() <= MAX_COORDINATE {
        return Ok(Point::new(x, y));
    }
    let sentence = format!("a coordinate is {x} m, {y} m; at most {MAX_COORDINATE:e} m are read");
    Err(FormatError::new(Code::InvalidNumber, sentence))
}

struct Emitter {
    forms: Vec<(LayerId, Form)>,
    /// The points of all forms.
    vertices: usize,
    /// The farthest that a curve was grown.
    flattened: f64,
    tolerance: f64,
    /// Whether areas are free, and must not be larger than in the file.
    walkable: bool,
    points: usize,
}

impl Emitter {
    fn push(&mut self, layer: LayerId, form: Form) {
        self.vertices += form.points().count();
        self.forms.push((layer, form));
    }

    fn add(&mut self, shape: &Shape) -> Result<(), FormatError> {
        let [most, least] = shape.map.stretch();
        let width = shape.stroke.map_or(0.0, |stroke| (stroke.width * most).max(stroke.least));
        if let (Some((center, radius)), Some(_)) = (shape.circle, shape.fill)
            && most - least <= ROUND * most
            && !self.walkable
        {
            let center = seen(&shape.map, center)?;
            self.push(shape.layer, Form::Disc { center, radius: radius * most + width / 2.0 });
            return Ok(());
        }
        let mut flats = Vec::with_capacity(shape.paths.len());
        for path in &shape.paths {
            let flat = self.flatten(path, &shape.map)?;
            self.flattened = self.flattened.max(flat.error);
            if let Some(stroke) = &shape.stroke {
                self.add_line(shape, path, stroke, width, &flat)?;
            }
            flats.push(flat);
        }
        if let Some(rule) = shape.fill {
            self.add_area(shape, flats, rule);
        }
        Ok(())
    }

    /// An area: the chords of its curves where a stroke lies on them, else polygons around them.
    fn add_area(&mut self, shape: &Shape, flats: Vec<Flat>, rule: FillRule) {
        let has_curves = shape.stroke.is_none() && flats.iter().any(|flat| flat.error > 0.0);
        if has_curves
            && !self.walkable
            && let Some(rings) = grown(&flats, rule)
        {
            self.push(shape.layer, Form::Area { rings, rule });
            return;
        }
        if has_curves {
            // Between a chord and its curve there is nothing farther than the error from the chord.
            for flat in flats.iter().filter(|flat| flat.error > 0.0) {
                let (points, width) = (flat.points.clone(), Some(2.0 * flat.error));
                self.push(shape.layer, Form::Line { points, closed: true, width });
            }
        }
        let rings = flats.into_iter().map(|flat| flat.points).collect();
        self.push(shape.layer, Form::Area { rings, rule });
    }

    fn add_line(
        &mut self,
        shape: &Shape,
        path: &Path,
        stroke: &Stroke,
        width: f64,
        flat: &Flat,
    ) -> Result<(), FormatError> {
        let map = |p: P3| seen(&shape.map, p);
        let mut beyond: f64 = 0.0;
        for tip in tips(path, stroke) {
            let [corner, before, tip, after] = tip.map(map);
            let (corner, tip) = (corner?, tip?);
            let excess = libm::hypot(tip.x - corner.x, tip.y - corner.y) - width / 2.0;
            if excess > self.tolerance {
                self.push(shape.layer, area(vec![vec![corner, before?, tip, after?]]));
            } else {
                beyond = beyond.max(excess);
            }
        }
        let mut points = flat.points.clone();
        if let Some([start, end]) = square_ends(path, stroke) {
            points.insert(0, map(start)?);
            points.push(map(end)?);
        }
        self.flattened = self.flattened.max(beyond);
        let grown = width + 2.0 * flat.error.max(beyond);
        points.dedup();
        if path.closed && points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        if let [center] = points[..] {
            let reach = if stroke.cap == Cap::Square { std::f64::consts::SQRT_2 } else { 1.0 };
            self.push(shape.layer, Form::Disc { center, radius: reach * grown / 2.0 });
        } else {
            let closed = path.closed && points.len() > 2;
            self.push(shape.layer, Form::Line { points, closed, width: Some(grown) });
        }
        Ok(())
    }

    fn flatten(&mut self, path: &Path, map: &Affine) -> Result<Flat, FormatError> {
        let mut flat = Flat { points: vec![seen(map, path.start)?], ..Flat::default() };
        let mut count = self.points;
        for piece in &path.pieces {
            let curve = match piece {
                Piece::Line(to) => {
                    count += 1;
                    flat.points.push(seen(map, *to)?);
                    flat.inner.push(Vec::new());
                    continue;
                }
                Piece::Curve(curve) => curve,
            };
            for (p, _) in &curve.0 {
                seen(map, *p)?;
            }
            let error = flatten(&curve.seen(map), self.tolerance, |end, inner| {
                count += 1 + inner.len();
                if count > MAX_POINTS {
                    return Err(too_many());
                }
                flat.points.push(end);
                flat.inner.push(inner.to_vec());
                Ok(())
            })?;
            flat.error = flat.error.max(error);
        }
        self.points = count;
        if count > MAX_POINTS {
            return Err(too_many());
        }
        Ok(flat)
    }
}

fn area(rings: Vec<Vec<Point>>) -> Form {
    Form::Area { rings, rule: FillRule::NonZero }
}

fn too_many() -> FormatError {
    let sentence =
        format!("the shapes have more than {MAX_POINTS} points, with curves as lines; a larger tolerance helps");
    FormatError::new(Code::WorldTooLarge, sentence)
}
