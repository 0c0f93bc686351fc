//! Hatches, as areas.

use super::pairs::{Entity, Pair};
use super::shapes::{Corner, Drawn, Kind, extruded, polyline, sweep};
use super::spline;
use crate::error::{Code, FormatError};
use crate::outline::{Affine, Curve, P3, Path, Piece, arc};
use crate::vector::FillRule;

/// The groups of a hatch, one after the other.
struct Cursor<'e, 'a> {
    entity: &'e Entity<'a>,
    rest: &'e [Pair<'a>],
    height: f64,
}

impl<'a> Cursor<'_, 'a> {
    /// The next group, which has to have this code.
    fn take(&mut self, code: i32) -> Result<Pair<'a>, FormatError> {
        match self.rest.split_first() {
            Some((pair, rest)) if pair.code == code => {
                self.rest = rest;
                Ok(*pair)
            }
            Some((pair, _)) => Err(FormatError::at_line(
                Code::InvalidFile,
                pair.line,
                format!("HATCH: group {code} is expected, not {}", pair.code),
            )),
            None => Err(self.entity.wrong(Code::InvalidFile, format!("group {code} is missing"))),
        }
    }

    /// The next group if it has this code.
    fn take_if(&mut self, code: i32) -> Option<Pair<'a>> {
        let (pair, rest) = self.rest.split_first().filter(|(pair, _)| pair.code == code)?;
        self.rest = rest;
        Some(*pair)
    }

    fn number(&mut self, code: i32) -> Result<f64, FormatError> {
        self.take(code)?.number()
    }

    fn point(&mut self, code: i32) -> Result<P3, FormatError> {
        Ok([self.number(code)?, self.number(code + 10)?, self.height])
    }

    /// A count that the groups that are left may have.
    fn count(&mut self, code: i32) -> Result<usize, FormatError> {
        let pair = self.take(code)?;
        let count = usize::try_from(pair.integer()?).ok().filter(|count| *count <= self.rest.len());
        count.ok_or_else(|| {
            FormatError::at_line(Code::Truncated, pair.line, "HATCH: it has fewer groups than it announces")
        })
    }

    fn flag(&mut self, code: i32) -> Result<bool, FormatError> {
        Ok(self.take(code)?.integer()? != 0)
    }
}

/// The area of a hatch: what an odd number of its loops is around.
pub fn drawn(entity: &Entity<'_>) -> Result<Vec<Drawn>, FormatError> {
    let Some(start) = entity.pairs.iter().position(|pair| pair.code == 91) else { return Ok(Vec::new()) };
    let mut cursor = Cursor { entity, rest: &entity.pairs[start..], height: entity.number(30, 0.0)? };
    let mut paths = Vec::new();
    for _ in 0..cursor.count(91)? {
        let kind = cursor.take(92)?.integer()?;
        paths.extend(if kind & 2 == 2 { corners(&mut cursor)? } else { edges(&mut cursor)? });
        // The objects that it was made from.
        if let Some(count) = cursor.take_if(97) {
            for _ in 0..count.integer()? {
                cursor.take(330)?;
            }
        }
    }
    let map = extruded(entity)?;
    let draw =
        |paths: Vec<Path>, fill: FillRule| Drawn { paths, circle: None, map, width: 0.0, kind: Kind::Area(fill) };
    // Style 2 fills what is around islands and the islands.
    Ok(match entity.integer(75, 0)? {
        2 => paths.into_iter().map(|path| draw(vec![path], FillRule::NonZero)).collect(),
        _ => vec![draw(paths, FillRule::EvenOdd)],
    })
}

fn corners(cursor: &mut Cursor<'_, '_>) -> Result<Vec<Path>, FormatError> {
    let has_bulges = cursor.flag(72)?;
    cursor.take(73)?;
    let count = cursor.count(93)?;
    let mut corners = Vec::with_capacity(count);
    for _ in 0..count {
        let at = cursor.point(10)?;
        let bulge = if has_bulges { cursor.take_if(42) } else { None };
        corners.push(Corner { at, bulge: bulge.map_or(Ok(0.0), |pair| pair.number())?, widths: [0.0; 2] });
    }
    Ok(polyline(&corners, true, Affine::IDENTITY).into_iter().flat_map(|drawn| drawn.paths).collect())
}

fn edges(cursor: &mut Cursor<'_, '_>) -> Result<Vec<Path>, FormatError> {
    let mut path: Option<Path> = None;
    for _ in 0..cursor.count(93)? {
        let kind = cursor.take(72)?;
        let curves = match kind.integer()? {
            1 => vec![Curve::bezier(&[cursor.point(10)?, cursor.point(11)?])],
            2 => {
                let (center, radius) = (cursor.point(10)?, cursor.number(40)?);
                let [from, sweep] = angles(cursor)?;
                arc(center, [radius, 0.0, 0.0], [0.0, radius, 0.0], from, sweep)
            }
            3 => {
                let (center, [x, y, _], ratio) = (cursor.point(10)?, cursor.point(11)?, cursor.number(40)?);
                let [from, sweep] = angles(cursor)?;
                arc(center, [x, y, 0.0], [-y * ratio, x * ratio, 0.0], from, sweep)
            }
            4 => spline_edge(cursor)?,
            other => {
                let sentence = format!("HATCH: an edge of kind {other} is not known");
                return Err(FormatError::at_line(Code::InvalidFile, kind.line, sentence));
            }
        };
        for curve in curves {
            let start = curve.0[0].0;
            let path = path.get_or_insert_with(|| Path { start, pieces: Vec::new(), closed: true });
            if path.end() != start {
                path.pieces.push(Piece::Line(start));
            }
            path.pieces.push(Piece::Curve(curve));
        }
    }
    Ok(path.into_iter().collect())
}

/// Where an arc begins and how far it goes, in radians; those that go clockwise have negative angles in the file.
fn angles(cursor: &mut Cursor<'_, '_>) -> Result<[f64; 2], FormatError> {
    let [from, to] = [cursor.number(50)?, cursor.number(51)?];
    let sign = if cursor.flag(73)? { 1.0 } else { -1.0 };
    Ok([sign * from.to_radians(), sign * sweep(from, to).to_radians()])
}

fn spline_edge(cursor: &mut Cursor<'_, '_>) -> Result<Vec<Curve>, FormatError> {
    let degree = cursor.count(94)?;
    let is_rational = cursor.flag(73)?;
    cursor.take(74)?;
    let (knots, points) = (cursor.count(95)?, cursor.count(96)?);
    let knots = (0..knots).map(|_| cursor.number(40)).collect::<Result<Vec<f64>, _>>()?;
    // Weights follow their points, or all follow all.
    let (mut controls, mut weights) = (Vec::with_capacity(points), Vec::new());
    for _ in 0..points {
        controls.push((cursor.point(10)?, 1.0));
        weights.extend(cursor.take_if(42).filter(|_| is_rational));
    }
    while weights.len() < points
        && is_rational
        && let Some(weight) = cursor.take_if(42)
    {
        weights.push(weight);
    }
    for (control, weight) in controls.iter_mut().zip(&weights) {
        control.1 = weight.number()?;
    }
    // Points that it goes through, and its tangents; files before R2010 have no count of them, so that the same group may begin
    // the objects that the loop was made from.
    let ahead = cursor.rest.get(1).map(|pair| pair.code);
    if matches!(ahead, Some(11 | 12 | 13 | 72 | 97))
        && let Some(count) = cursor.take_if(97)
    {
        for _ in 0..count.integer()? {
            cursor.point(11)?;
        }
        for code in [12, 13] {
            if cursor.take_if(code).is_some() {
                cursor.take(code + 10)?;
            }
        }
    }
    spline::pieces(degree, &knots, &controls)
        .ok_or_else(|| cursor.entity.wrong(Code::InvalidFile, "the spline of an edge is none"))
}
