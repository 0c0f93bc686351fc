//! The page of an SVG file: where it is in metres, and how long a unit is.

use super::lengths::{fit, in_metres, in_units, length, view_box, wrong};
use super::tree::Element;
use crate::error::{Code, FormatError};
use crate::outline::Affine;
use planarium::geometry::{Aabb, Point};
use svgtypes::{Length, LengthUnit, ViewBox};

/// A page that is smaller than this, in metres, is a drawing on paper.
const SMALL: f64 = 2.0;

pub struct Page {
    /// From the units of the drawing to metres, y up.
    pub map: Affine,
    pub area: Option<Aabb>,
    /// Its size in units, of which lengths may be a part; no numbers if it is unknown.
    pub size: [f64; 2],
    /// Metres per pixel of the page.
    pub pixel: f64,
    /// How long a unit is, and why.
    pub note: String,
}

impl Page {
    pub fn of(root: &Element, scale: Option<f64>) -> Result<Self, FormatError> {
        if root.get("transform").is_some() {
            let sentence = "a transform of the root element is not read";
            return Err(FormatError::new(Code::UnsupportedFeature, sentence));
        }
        let view = view_box(root.get("viewBox"))?;
        let side = |name: &str| -> Result<Option<Length>, FormatError> {
            let Some(value) = root.get(name).filter(|value| value.trim() != "auto") else { return Ok(None) };
            let side = length(name, value)?;
            if side.number <= 0.0 {
                return Err(wrong(name, value, "a page has an area"));
            }
            Ok(Some(side).filter(|side| side.unit != LengthUnit::Percent))
        };
        let sides = [side("width")?, side("height")?];
        let metres = sides.map(|side| side.and_then(in_metres));
        let pixels = with_ratio(sides.map(|side| side.map(|side| in_units(side, 0.0))), view);
        let aspect = root.get("preserveAspectRatio");
        match (view, scale) {
            (Some(view), None) if metres.iter().any(Option::is_some) => {
                let [w, h] = with_ratio(metres, Some(view));
                let map = fit(view, w, h, aspect)?;
                let unit = map.columns[0][0];
                let mut note = format!("a unit of the drawing is {unit} m, by the size of its page, {w} x {h} m");
                if w.max(h) < SMALL {
                    note += "; with a scale of 1, it is 1 m";
                }
                Ok(Self::new(map, Some([w, h]), [view.w, view.h], w / pixels[0], note))
            }
            (Some(view), _) => {
                let unit = scale.unwrap_or(1.0);
                let is_free = aspect.is_some_and(|value| value.contains("none"));
                let h = if is_free { view.w * pixels[1] / pixels[0] } else { view.h };
                let (w, h) = (unit * view.w, unit * h);
                let map = fit(view, w, h, aspect)?;
                let pixel = w / pixels[0].min(view.w * pixels[1] / view.h);
                Ok(Self::new(map, Some([w, h]), [view.w, view.h], pixel, given(scale, unit)))
            }
            (None, _) => {
                let is_paper = scale.is_none() && metres.iter().any(Option::is_some);
                let unit = if is_paper { 0.0254 / 96.0 } else { scale.unwrap_or(1.0) };
                let note = if is_paper {
                    format!("a unit of the drawing is a pixel, {unit} m; with a scale of 1, it is 1 m")
                } else {
                    given(scale, unit)
                };
                let size = pixels.map(|side| unit * side);
                let area = size.iter().all(|side| side.is_finite()).then_some(size);
                Ok(Self::new(Affine::scale([unit, unit, 1.0]), area, pixels, unit, note))
            }
        }
    }

    /// A page whose map has y down.
    fn new(map: Affine, area: Option<[f64; 2]>, size: [f64; 2], pixel: f64, note: String) -> Self {
        let height = area.map_or(0.0, |area| area[1]);
        let map = Affine::plane([1.0, 0.0, 0.0, -1.0, 0.0, height]) * map;
        let area = area.map(|[w, h]| Aabb::of(Point::origin(), Point::new(w, h)));
        Self { map, area, size, pixel, note }
    }
}

/// Why a unit has its length.
fn given(scale: Option<f64>, unit: f64) -> String {
    match scale {
        Some(_) => format!("a unit of the drawing is {unit} m, as given"),
        None => format!("a unit of the drawing is {unit} m: it has no lengths of paper, and no scale is given"),
    }
}

/// Two sides, where one that is missing follows from the view box.
fn with_ratio(sides: [Option<f64>; 2], view: Option<ViewBox>) -> [f64; 2] {
    let size = view.map_or([f64::NAN; 2], |view| [view.w, view.h]);
    match sides {
        [Some(w), Some(h)] => [w, h],
        [Some(w), None] => [w, w * size[1] / size[0]],
        [None, Some(h)] => [h * size[0] / size[1], h],
        [None, None] => size,
    }
}
