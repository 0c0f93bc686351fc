//! Longitude and latitude in a plane, and back.
//!
//! East and north are scaled, each by what a degree measures in the middle of the file on the ellipsoid WGS 84
//! (equirectangular projection): straight lines stay straight, corners stay exact, and the way back is a division.

use crate::draft::Draft;
use crate::error::{Code, FormatError};
use crate::options::{Coordinates, Options};
use crate::report::Format;
use crate::vector::{Drawing, Frame};
use planarium::geometry::{Aabb, Point, metres_per_degree};

/// The widest file whose coordinates are taken for degrees though it does not say so.
const LIKELY: f64 = 1.0;

/// What a file says of its coordinates.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Said {
    /// Nothing; longitude and latitude are the rule where the flag says so.
    Nothing { usually_degrees: bool },
    /// Degrees.
    Degrees,
    /// A reference system by name, whose coordinates are taken for metres.
    Other(String),
}

/// The draft of a drawing whose coordinates are degrees or x and y.
///
/// # Errors
/// Those of [`Drawing::into_draft`]; `invalid-number` for degrees that are none, `invalid-option` for a scale of degrees
pub fn draft(
    drawing: Drawing,
    format: Format,
    file: &str,
    said: &Said,
    options: &Options,
) -> Result<Draft, FormatError> {
    let Some(extent) = drawing.extent() else {
        return drawing.into_draft(format, file, Frame::of_scale(1.0), options);
    };
    let Aabb { min, max } = extent;
    let fits = min.x >= -180.0 && max.x <= 180.0 && min.y >= -90.0 && max.y <= 90.0;
    let is_narrow = (max.x - min.x).max(max.y - min.y) <= LIKELY;
    let (are_degrees, why) = match (options.coordinates, said) {
        (Coordinates::Degrees, _) => (true, "as chosen".to_owned()),
        (Coordinates::Metres, _) => (false, "as chosen".to_owned()),
        (_, Said::Degrees) => (true, "as the file says".to_owned()),
        (_, Said::Other(name)) => (false, format!("as those of {name}")),
        (_, Said::Nothing { usually_degrees: false }) => (false, "as the format has no other".to_owned()),
        _ if fits && is_narrow => (true, format!("as they are within {LIKELY} degree; choose metres if not")),
        _ if fits => (false, format!("as they are more than {LIKELY} degree apart; choose degrees if not")),
        _ => (false, "as they cannot be degrees".to_owned()),
    };
    if !are_degrees {
        let scale = options.scale.unwrap_or(1.0);
        let mut draft = drawing.into_draft(format, file, Frame::of_scale(scale), options)?;
        draft.report.notes.push(format!("coordinates are x and y of {scale} m, {why}"));
        return Ok(draft);
    }
    if options.scale.is_some() {
        return Err(FormatError::new(Code::InvalidOption, "degrees have their scale; choose metres if they are none"));
    }
    if !fits {
        let sentence = format!(
            "longitudes from {} to {} and latitudes from {} to {} are no degrees on the earth",
            min.x, max.x, min.y, max.y
        );
        return Err(FormatError::new(Code::InvalidNumber, sentence));
    }
    let origin = Point::new((min.x + max.x) / 2.0, (min.y + max.y) / 2.0);
    let scale = metres_per_degree(origin.y);
    let frame = Frame { origin, scale };
    let mut draft = drawing.into_draft(format, file, frame, options)?;
    draft.plane = Some(frame);
    if let Some(plane) = &mut draft.report.plane {
        plane.error = Some(error(extent, scale));
    }
    draft.report.notes.push(format!("coordinates are longitude and latitude, {why}; start and goal are, too"));
    Ok(draft)
}

/// The most that a distance in the plane differs from that on the ellipsoid: the scales are farthest off at the lowest and
/// the highest latitude.
fn error(Aabb { min, max }: Aabb, scale: [f64; 2]) -> f64 {
    let off = |latitude| {
        let [east, north] = metres_per_degree(latitude);
        (east - scale[0]).abs() * (max.x - min.x) + (north - scale[1]).abs() * (max.y - min.y)
    };
    off(min.y).max(off(max.y))
}
