//! The paths of entities.

use super::hatch;
use super::pairs::Entity;
use super::spline;
use crate::error::{Code, FormatError};
use crate::outline::{Affine, P3, Path, Piece, arc, bulge};
use crate::vector::FillRule;
use std::f64::consts::TAU;

/// What an entity draws, in its own coordinates.
pub struct Drawn {
    pub paths: Vec<Path>,
    /// Center and radius of a circle.
    pub circle: Option<(P3, f64)>,
    /// From its own coordinates to those of the block or the drawing.
    pub map: Affine,
    /// Of lines, their width.
    pub width: f64,
    pub kind: Kind,
}

/// Whether an entity is a line or an area.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A line, which may be closed.
    Line,
    /// An area whatever the options say.
    Area(FillRule),
}

impl Drawn {
    fn line(path: Path, map: Affine) -> Vec<Self> {
        vec![Self { paths: vec![path], circle: None, map, width: 0.0, kind: Kind::Line }]
    }
}

/// A corner of a polyline, with the bulge and the widths of the edge that begins there.
#[derive(Debug, Clone, Copy, Default)]
pub struct Corner {
    pub at: P3,
    pub bulge: f64,
    pub widths: [f64; 2],
}

/// What an entity draws; `None` if its kind is not read.
pub fn drawn(entity: &Entity<'_>) -> Result<Option<Vec<Drawn>>, FormatError> {
    Ok(Some(match entity.kind {
        b"LINE" => {
            let ends = [entity.point(10)?, entity.point(11)?];
            Drawn::line(Path { start: ends[0], pieces: vec![Piece::Line(ends[1])], closed: false }, Affine::IDENTITY)
        }
        b"LWPOLYLINE" => light_polyline(entity)?,
        b"CIRCLE" | b"ARC" => round(entity)?,
        b"ELLIPSE" => ellipse(entity)?,
        b"SPLINE" => return spline_of(entity),
        b"SOLID" | b"TRACE" | b"3DFACE" => {
            let is_face = entity.kind == b"3DFACE";
            let order = if is_face { [10, 11, 12, 13] } else { [10, 11, 13, 12] };
            let mut corners = Vec::with_capacity(4);
            for code in order {
                // The fourth corner may be absent.
                if entity.get(code).is_some() {
                    corners.push(entity.point(code)?);
                }
            }
            let map = if is_face { Affine::IDENTITY } else { extruded(entity)? };
            let paths = Path::along(corners, true).into_iter().collect();
            vec![Drawn { paths, circle: None, map, width: 0.0, kind: Kind::Area(FillRule::NonZero) }]
        }
        b"HATCH" => hatch::drawn(entity)?,
        _ => return Ok(None),
    }))
}

/// The coordinates of an entity by its extrusion (DXF reference, Arbitrary Axis Algorithm).
pub fn extruded(entity: &Entity<'_>) -> Result<Affine, FormatError> {
    if entity.get(210).is_none() && entity.get(220).is_none() && entity.get(230).is_none() {
        return Ok(Affine::IDENTITY);
    }
    let normal = normal(entity)?;
    if normal == [0.0, 0.0, 1.0] {
        return Ok(Affine::IDENTITY);
    }
    let near = 1.0 / 64.0;
    let other = if normal[0].abs() < near && normal[1].abs() < near { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] };
    let x = unit(cross(other, normal));
    Ok(Affine { columns: [x, cross(normal, x), normal], origin: [0.0; 3] })
}

fn normal(entity: &Entity<'_>) -> Result<P3, FormatError> {
    let normal = [entity.number(210, 0.0)?, entity.number(220, 0.0)?, entity.number(230, 1.0)?];
    let unit = unit(normal);
    if unit.iter().all(|x| x.is_finite()) {
        return Ok(unit);
    }
    Err(entity.wrong(Code::InvalidNumber, format!("{normal:?} is no direction of extrusion")))
}

fn unit([x, y, z]: P3) -> P3 {
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}

fn cross([a, b, c]: P3, [x, y, z]: P3) -> P3 {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn light_polyline(entity: &Entity<'_>) -> Result<Vec<Drawn>, FormatError> {
    let height = entity.number(38, 0.0)?;
    let constant = entity.number(43, 0.0)?;
    let mut corners: Vec<Corner> = Vec::new();
    for pair in &entity.pairs {
        if pair.code == 10 {
            corners.push(Corner { at: [pair.number()?, 0.0, height], bulge: 0.0, widths: [constant; 2] });
            continue;
        }
        let Some(corner) = corners.last_mut() else { continue };
        match pair.code {
            20 => corner.at[1] = pair.number()?,
            40 => corner.widths[0] = pair.number()?,
            41 => corner.widths[1] = pair.number()?,
            42 => corner.bulge = pair.number()?,
            _ => {}
        }
    }
    let closed = entity.integer(70, 0)? & 1 == 1;
    Ok(polyline(&corners, closed, extruded(entity)?))
}

/// A polyline. One of several widths becomes a line for each edge, as wide as the edge is at most.
pub fn polyline(corners: &[Corner], closed: bool, map: Affine) -> Vec<Drawn> {
    let Some((first, rest)) = corners.split_first() else { return Vec::new() };
    let edges = corners.iter().zip(rest.iter().chain(closed.then_some(first)));
    let width = |corner: &Corner| corner.widths[0].max(corner.widths[1]).max(0.0);
    let draw = |path: Path, width: f64| Drawn { paths: vec![path], circle: None, map, width, kind: Kind::Line };
    let pieces = |from: &Corner, to: &Corner| -> Vec<Piece> {
        if from.bulge == 0.0 || from.at == to.at {
            vec![Piece::Line(to.at)]
        } else {
            bulge(from.at, to.at, from.bulge).into_iter().map(Piece::Curve).collect()
        }
    };
    let widths: Vec<f64> = edges.clone().map(|(from, _)| width(from)).collect();
    if widths.windows(2).all(|pair| pair[0] == pair[1]) {
        let pieces = edges.flat_map(|(from, to)| pieces(from, to)).collect();
        return vec![draw(Path { start: first.at, pieces, closed }, widths.first().copied().unwrap_or(0.0))];
    }
    let edge = |(from, to): (&Corner, &Corner)| {
        draw(Path { start: from.at, pieces: pieces(from, to), closed: false }, width(from))
    };
    edges.map(edge).collect()
}

/// How far an arc goes from one angle to another, in degrees: once around if they are the same.
pub fn sweep(from: f64, to: f64) -> f64 {
    let degrees = (to - from).rem_euclid(360.0);
    if degrees == 0.0 { 360.0 } else { degrees }
}

fn round(entity: &Entity<'_>) -> Result<Vec<Drawn>, FormatError> {
    let (center, radius) = (entity.point(10)?, entity.number(40, 0.0)?);
    let map = extruded(entity)?;
    if radius <= 0.0 {
        return Err(entity.wrong(Code::InvalidNumber, format!("the radius is {radius}")));
    }
    let is_arc = entity.kind == b"ARC";
    let (from, sweep) = if is_arc {
        let [from, to] = [entity.number(50, 0.0)?, entity.number(51, 360.0)?];
        (from.to_radians(), sweep(from, to).to_radians())
    } else {
        (0.0, TAU)
    };
    let curves = arc(center, [radius, 0.0, 0.0], [0.0, radius, 0.0], from, sweep);
    let mut drawn = Drawn::line(of_curves(curves, !is_arc), map);
    if !is_arc {
        drawn[0].circle = Some((center, radius));
    }
    Ok(drawn)
}

fn ellipse(entity: &Entity<'_>) -> Result<Vec<Drawn>, FormatError> {
    let (center, major, ratio) = (entity.point(10)?, entity.point(11)?, entity.number(40, 1.0)?);
    let minor = cross(normal(entity)?, major).map(|x| x * ratio);
    let [from, to] = [entity.number(41, 0.0)?, entity.number(42, TAU)?];
    let sweep = (to - from).rem_euclid(TAU);
    let is_whole = !(1e-9..=TAU - 1e-9).contains(&sweep);
    let curves = if is_whole { arc(center, major, minor, 0.0, TAU) } else { arc(center, major, minor, from, sweep) };
    Ok(Drawn::line(of_curves(curves, is_whole), Affine::IDENTITY))
}

fn spline_of(entity: &Entity<'_>) -> Result<Option<Vec<Drawn>>, FormatError> {
    let points = entity.points(10)?;
    if points.is_empty() {
        // It has points to go through only, and how it does so is not defined.
        return Ok(None);
    }
    let numbers = |code: i32| entity.pairs.iter().filter(move |pair| pair.code == code).map(|pair| pair.number());
    let knots: Vec<f64> = numbers(40).collect::<Result<_, _>>()?;
    let weights: Vec<f64> = numbers(41).collect::<Result<_, _>>()?;
    let weighted: Vec<(P3, f64)> =
        points.iter().enumerate().map(|(i, &p)| (p, weights.get(i).copied().unwrap_or(1.0))).collect();
    let degree = usize::try_from(entity.integer(71, 3)?).unwrap_or(0);
    let curves = spline::pieces(degree, &knots, &weighted).filter(|curves| !curves.is_empty()).ok_or_else(|| {
        let sentence = format!(
            "a spline of degree {degree} with {} control points and {} knots is none (degrees from 1 to {}, knots in \
             order, positive weights)",
            points.len(),
            knots.len(),
            spline::MAX_DEGREE
        );
        entity.wrong(Code::InvalidFile, sentence)
    })?;
    let closed = entity.integer(70, 0)? & 1 == 1;
    Ok(Some(Drawn::line(of_curves(curves, closed), Affine::IDENTITY)))
}

fn of_curves(curves: Vec<crate::outline::Curve>, closed: bool) -> Path {
    let start = curves.first().and_then(|curve| curve.0.first()).map_or([0.0; 3], |control| control.0);
    Path { start, pieces: curves.into_iter().map(Piece::Curve).collect(), closed }
}
