//! The paths and the stroke of an element.

use super::lengths::{in_units, length, wrong};
use super::path;
use super::style::Style;
use super::tree::Element;
use crate::error::FormatError;
use crate::outline::{Affine, P3, Path, Piece, Shape, Stroke};
use planarium::geometry::Aabb;

/// An attribute that is a length, in units: percentages are of the width (axis 0), the height (1) or both (2).
pub fn attribute(element: &Element, name: &str, viewport: [f64; 2], axis: usize) -> Result<Option<f64>, FormatError> {
    let Some(value) = element.get(name).filter(|value| value.trim() != "auto") else { return Ok(None) };
    units(name, value, viewport, axis).map(Some)
}

fn units(name: &str, value: &str, viewport: [f64; 2], axis: usize) -> Result<f64, FormatError> {
    let [w, h] = viewport;
    let whole = match axis {
        0 => w,
        1 => h,
        _ => ((w * w + h * h) / 2.0).sqrt(),
    };
    let units = in_units(length(name, value)?, whole);
    if units.is_nan() {
        return Err(wrong(name, value, "the page has no size of which this is a part"));
    }
    Ok(units)
}

/// The stroke of a style; pixels of the page have this length in metres.
pub fn stroke(style: &Style, viewport: [f64; 2], map: &Affine, pixel: f64) -> Result<Option<Stroke>, FormatError> {
    let mut width = units("stroke-width", &style.stroke_width, viewport, 2)?;
    if width <= 0.0 {
        return Ok(None);
    }
    let mut least = 0.0;
    if style.keeps_width {
        let [_, stretch] = map.stretch();
        least = width * pixel;
        width = if stretch > 0.0 { least / stretch } else { 0.0 };
    }
    let miter = style.is_mitred.then_some(style.miter_limit);
    Ok(Some(Stroke { width, least, cap: style.cap, miter }))
}

/// The paths of an element; of a circle, center and radius as well.
#[allow(clippy::type_complexity)]
pub fn paths(element: &Element, viewport: [f64; 2]) -> Result<(Vec<Path>, Option<(P3, f64)>), FormatError> {
    let get = |name: &str, axis: usize| Ok(attribute(element, name, viewport, axis)?.unwrap_or(0.0));
    let only = |path: Path| Ok((vec![path], None));
    match &*element.name {
        "rect" => {
            let size = [get("width", 0)?, get("height", 1)?];
            if size.iter().any(|side| *side <= 0.0) {
                return Ok((Vec::new(), None));
            }
            let [rx, ry] = radii(element, viewport)?;
            let radii = [rx.min(size[0] / 2.0), ry.min(size[1] / 2.0)];
            only(path::rectangle([get("x", 0)?, get("y", 1)?], size, radii))
        }
        "circle" | "ellipse" => {
            let center = [get("cx", 0)?, get("cy", 1)?];
            let is_circle = &*element.name == "circle";
            let radii = if is_circle { [get("r", 2)?; 2] } else { radii(element, viewport)? };
            if radii.iter().any(|radius| *radius <= 0.0) {
                return Ok((Vec::new(), None));
            }
            let is_round = radii[0] == radii[1];
            let circle = is_round.then_some(([center[0], center[1], 0.0], radii[0]));
            Ok((vec![path::ellipse(center, radii)], circle))
        }
        "line" => {
            let ends = [[get("x1", 0)?, get("y1", 1)?], [get("x2", 0)?, get("y2", 1)?]];
            Ok((Path::along(ends.map(|[x, y]| [x, y, 0.0]), false).into_iter().collect(), None))
        }
        "path" => Ok((path::data(element.get("d").unwrap_or(""))?, None)),
        name => {
            let points = path::points(element.get("points").unwrap_or(""), name == "polygon")?;
            Ok((points.into_iter().collect(), None))
        }
    }
}

/// Two radii; one that is missing is as large as the other.
fn radii(element: &Element, viewport: [f64; 2]) -> Result<[f64; 2], FormatError> {
    let rx = attribute(element, "rx", viewport, 0)?.filter(|radius| *radius >= 0.0);
    let ry = attribute(element, "ry", viewport, 1)?.filter(|radius| *radius >= 0.0);
    Ok([rx.or(ry).unwrap_or(0.0), ry.or(rx).unwrap_or(0.0)])
}

/// Whether a shape is a filled rectangle around the page.
pub fn covers(shape: &Shape, page: Aabb) -> bool {
    let [path] = &shape.paths[..] else { return false };
    let mut corners = vec![path.start];
    for piece in &path.pieces {
        let Piece::Line(to) = piece else { return false };
        corners.push(*to);
    }
    corners.dedup();
    if corners.len() > 4 && corners.first() == corners.last() {
        corners.pop();
    }
    if corners.len() != 4 || shape.fill.is_none() {
        return false;
    }
    let corners: Vec<P3> = corners.into_iter().map(|p| shape.map.apply(p)).collect();
    // A page is covered to a millionth of its size.
    let slack = 1e-6 * (page.max.x - page.min.x).max(page.max.y - page.min.y);
    let is_outside = |corner: &P3| {
        let beyond = |value: f64, low: f64, high: f64| value <= low + slack || value >= high - slack;
        beyond(corner[0], page.min.x, page.max.x) && beyond(corner[1], page.min.y, page.max.y)
    };
    let is_axis_aligned = (0..4).all(|i| {
        let [a, b] = [corners[i], corners[(i + 1) % 4]];
        (a[0] - b[0]).abs() <= slack || (a[1] - b[1]).abs() <= slack
    });
    let spans = |axis: usize, size: f64| {
        let values = corners.iter().map(|corner| corner[axis]);
        values.clone().fold(f64::NEG_INFINITY, f64::max) - values.fold(f64::INFINITY, f64::min) >= size - 2.0 * slack
    };
    corners.iter().all(is_outside)
        && is_axis_aligned
        && spans(0, page.max.x - page.min.x)
        && spans(1, page.max.y - page.min.y)
}
