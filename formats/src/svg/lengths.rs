//! Lengths, transforms and view boxes.

use crate::error::{Code, FormatError, quoted};
use crate::outline::Affine;
use std::str::FromStr;
use svgtypes::{Align, AspectRatio, Length, LengthUnit, TransformListParser, TransformListToken, ViewBox};

/// Pixels per inch.
const PIXELS: f64 = 96.0;

/// An error about the value of an attribute.
pub fn wrong(name: &str, value: &str, why: impl std::fmt::Display) -> FormatError {
    FormatError::new(Code::InvalidFile, format!("{name} is {}: {why}", quoted(value.as_bytes())))
}

pub fn length(name: &str, value: &str) -> Result<Length, FormatError> {
    Length::from_str(value).map_err(|error| wrong(name, value, error))
}

/// A length in units of the file, a percentage of `whole`. Fonts have 16 pixels.
pub fn in_units(length: Length, whole: f64) -> f64 {
    let factor = match length.unit {
        LengthUnit::None | LengthUnit::Px => 1.0,
        LengthUnit::Em => 16.0,
        LengthUnit::Ex => 8.0,
        LengthUnit::In => PIXELS,
        LengthUnit::Cm => PIXELS / 2.54,
        LengthUnit::Mm => PIXELS / 25.4,
        LengthUnit::Pt => PIXELS / 72.0,
        LengthUnit::Pc => PIXELS / 6.0,
        LengthUnit::Percent => whole / 100.0,
    };
    length.number * factor
}

/// A length in metres, if it has a unit that exists outside of screens.
pub fn in_metres(length: Length) -> Option<f64> {
    Some(match length.unit {
        LengthUnit::In => length.number * 0.0254,
        LengthUnit::Cm => length.number / 100.0,
        LengthUnit::Mm => length.number / 1000.0,
        LengthUnit::Pt => length.number * 0.0254 / 72.0,
        LengthUnit::Pc => length.number * 0.0254 / 6.0,
        _ => return None,
    })
}

pub fn transform(value: &str) -> Result<Affine, FormatError> {
    let mut map = Affine::IDENTITY;
    for token in TransformListParser::from(value) {
        let skew = |angle: f64| libm::tan(angle.to_radians());
        map = map
            * match token.map_err(|error| wrong("transform", value, error))? {
                TransformListToken::Matrix { a, b, c, d, e, f } => Affine::plane([a, b, c, d, e, f]),
                TransformListToken::Translate { tx, ty } => Affine::translation([tx, ty, 0.0]),
                TransformListToken::Scale { sx, sy } => Affine::scale([sx, sy, 1.0]),
                TransformListToken::Rotate { angle } => Affine::rotation(angle),
                TransformListToken::SkewX { angle } => Affine::plane([1.0, 0.0, skew(angle), 1.0, 0.0, 0.0]),
                TransformListToken::SkewY { angle } => Affine::plane([1.0, skew(angle), 0.0, 1.0, 0.0, 0.0]),
            };
    }
    Ok(map)
}

/// A view box with an area; `None` if there is none, or an empty one, which shows nothing.
pub fn view_box(value: Option<&str>) -> Result<Option<ViewBox>, FormatError> {
    let Some(value) = value else { return Ok(None) };
    ViewBox::from_str(value).map(Some).map_err(|error| wrong("viewBox", value, error))
}

/// The map from a view box into a viewport of a width and a height.
pub fn fit(view: ViewBox, width: f64, height: f64, aspect: Option<&str>) -> Result<Affine, FormatError> {
    let aspect = match aspect {
        Some(value) => AspectRatio::from_str(value).map_err(|error| wrong("preserveAspectRatio", value, error))?,
        None => AspectRatio::default(),
    };
    let [x, y] = [width / view.w, height / view.h];
    let [x, y] = match aspect.align {
        Align::None => [x, y],
        _ if aspect.slice => [x.max(y); 2],
        _ => [x.min(y); 2],
    };
    let free = [width - view.w * x, height - view.h * y];
    let part = match aspect.align {
        Align::None | Align::XMinYMin => [0.0, 0.0],
        Align::XMidYMin => [0.5, 0.0],
        Align::XMaxYMin => [1.0, 0.0],
        Align::XMinYMid => [0.0, 0.5],
        Align::XMidYMid => [0.5, 0.5],
        Align::XMaxYMid => [1.0, 0.5],
        Align::XMinYMax => [0.0, 1.0],
        Align::XMidYMax => [0.5, 1.0],
        Align::XMaxYMax => [1.0, 1.0],
    };
    let origin = [part[0] * free[0] - view.x * x, part[1] * free[1] - view.y * y];
    Ok(Affine::plane([x, 0.0, 0.0, y, origin[0], origin[1]]))
}
