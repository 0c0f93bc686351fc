//! Rings that cross themselves or each other: what they fill, by the crate i_overlay.
//!
//! It computes on a grid of whole numbers, and moves corners and crossings to it. Grid coordinates are multiples of a power
//! of two with at most 50 bits, which 64-bit numbers have exactly, so nothing else is rounded.

use super::FillRule;
use super::rings::Region;
use crate::draft::largest;
use i_overlay::core::fill_rule;
use i_overlay::core::overlay::{IntOverlayOptions, Overlay, ShapeType};
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::i_float::int::point::IntPoint;
use planarium::geometry::{Aabb, Point};

/// The bits of a grid coordinate.
const BITS: i32 = 50;

/// How far, in units of the grid, an edge may move: by half a unit when it is rounded, and where crossings are rounded by
/// about one more in each of a few rounds.
const MOVED: f64 = 1024.0;

/// The regions that rings fill, or what they leave of a frame; and how far their borders may be from where the rings have
/// them. Coordinates are at most 1e9.
pub fn mended(rings: &[Vec<Point>], rule: FillRule, frame: Option<Aabb>) -> (Vec<Region>, f64) {
    let corners = frame.iter().flat_map(|frame| [frame.min, frame.max]);
    let points = rings.iter().flatten().copied().chain(corners);
    let unit = unit(largest(points));
    let options = IntOverlayOptions { ogc: true, ..IntOverlayOptions::default() };
    let mut overlay: Overlay<i64> = Overlay::new_custom(rings.iter().map(Vec::len).sum(), options, Default::default());
    let on_grid = |p: Point| IntPoint::new((p.x / unit).round() as i64, (p.y / unit).round() as i64);
    let shape_type = if frame.is_some() { ShapeType::Clip } else { ShapeType::Subject };
    for ring in rings {
        overlay.add_path_iter(ring.iter().copied().map(on_grid), shape_type);
    }
    let mut operation = OverlayRule::Subject;
    if let Some(Aabb { min, max }) = frame {
        let outline = [min, Point::new(max.x, min.y), max, Point::new(min.x, max.y)];
        overlay.add_path_iter(outline.into_iter().map(on_grid), ShapeType::Subject);
        operation = OverlayRule::Difference;
    }
    let rule = match rule {
        FillRule::NonZero => fill_rule::FillRule::NonZero,
        FillRule::EvenOdd => fill_rule::FillRule::EvenOdd,
    };
    let shapes = overlay.overlay(operation, rule);
    let point = |p: IntPoint<i64>| Point::new(p.x as f64 * unit, p.y as f64 * unit);
    let ring = |contour: Vec<IntPoint<i64>>| contour.into_iter().map(point).collect();
    let regions = shapes.into_iter().filter_map(|shape| {
        let mut rings = shape.into_iter().map(ring);
        Some(Region { outline: rings.next()?, holes: rings.collect() })
    });
    (regions.collect(), MOVED * unit)
}

/// The power of two that is 2^50 times smaller than one above the largest coordinate.
fn unit(largest: f64) -> f64 {
    let exponent = ((largest.to_bits() >> 52) & 0x7ff) as i32 - 1022;
    f64::from_bits(((exponent.max(-200) - BITS + 1023) as u64) << 52)
}
