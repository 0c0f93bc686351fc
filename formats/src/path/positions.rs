//! Paths of GeoJSON: one line, perhaps with its first and last position as points; or points one after another with their heading
//! in the property `theta`, in radians, or `theta_deg`.

use super::{PathFormat, Places, Rows};
use crate::error::{Code, FormatError, Place};
use crate::geojson::document::{Coordinates, Object};
use crate::geojson::parsed;
use crate::report::Dropped;
use planarium::scenario::MapFrame;

/// Reads a document.
///
/// # Errors
/// `truncated`, `invalid-file`, `invalid-number`; `contradiction` if there are several lines
pub fn rows(bytes: &[u8], frame: &MapFrame) -> Result<Rows, FormatError> {
    let root = parsed(bytes)?;
    let features: Vec<&Object> = match root.kind.as_deref() {
        Some("FeatureCollection") => root.features.iter().flatten().collect(),
        _ => vec![&root],
    };
    let mut found = Found::default();
    for (i, feature) in features.into_iter().enumerate() {
        found.feature(feature).map_err(|error| error.at(Place::Element(format!("feature {i}"))))?;
    }
    let (places, headings) = match (&found.lines[..], found.points.is_empty()) {
        // Points repeat a line, with headings.
        ([line], false) if line.len() == found.points.len() => (found.points, found.headings),
        ([line], true) => (line.clone(), Vec::new()),
        // Points mark its ends.
        ([line], false) if line.len() > 1 && found.points == [line[0], line[line.len() - 1]] => {
            (line.clone(), Vec::new())
        }
        ([], false) => (found.points, found.headings),
        ([], true) => return Err(FormatError::new(Code::Truncated, "there is neither a line nor a point")),
        (lines, _) => {
            let sentence =
                format!("there are {} lines and {} points: which is the path?", lines.len(), found.points.len());
            return Err(FormatError::new(Code::Contradiction, sentence));
        }
    };
    let units = if frame.has_degrees() { ["lon", "lat"] } else { ["x", "y"] };
    let mut names = units.map(str::to_owned).to_vec();
    let in_degrees = headings.iter().all(|heading| matches!(heading, Some((_, true))));
    let are_headings = !headings.is_empty()
        && headings.iter().all(|heading| heading.is_some_and(|(_, degrees)| degrees == in_degrees));
    if are_headings {
        names.push(if in_degrees { "theta [deg]" } else { "theta [rad]" }.to_owned());
    }
    let width = names.len();
    let mut numbers = Vec::with_capacity(width * places.len());
    for (i, place) in places.iter().enumerate() {
        numbers.extend(place);
        if are_headings {
            numbers.push(headings[i].map_or(f64::NAN, |(theta, _)| theta));
        }
    }
    let dropped = [("heights", found.heights), ("features of other kinds", found.others)];
    Ok(Rows {
        format: PathFormat::GeoJson,
        names: Some(names),
        width,
        numbers,
        places: Places::Elements("position"),
        dropped: Dropped::counted(dropped),
        notes: Vec::new(),
    })
}

#[derive(Default)]
struct Found {
    lines: Vec<Vec<[f64; 2]>>,
    points: Vec<[f64; 2]>,
    /// Of each point, the heading, and whether it is in degrees.
    headings: Vec<Option<(f64, bool)>>,
    heights: usize,
    others: usize,
}

impl Found {
    fn feature(&mut self, feature: &Object) -> Result<(), FormatError> {
        let geometry = match feature.kind.as_deref() {
            Some("Feature") => feature.geometry.as_deref(),
            _ => Some(feature),
        };
        let Some((kind, coordinates)) =
            geometry.and_then(|geometry| Some((geometry.kind.as_deref()?, geometry.coordinates.as_ref()?)))
        else {
            self.others += 1;
            return Ok(());
        };
        let heading = || {
            let number = |key: &str| feature.property(key).and_then(|text| text.parse().ok());
            number("theta").map(|theta| (theta, false)).or_else(|| Some((number("theta_deg")?, true)))
        };
        match kind {
            "Point" => {
                let place = self.position(coordinates)?;
                self.points.push(place);
                self.headings.push(heading());
            }
            "MultiPoint" => {
                let places = self.positions(coordinates)?;
                self.headings.resize(self.headings.len() + places.len(), None);
                self.points.extend(places);
            }
            "LineString" => {
                let line = self.positions(coordinates)?;
                self.lines.push(line);
            }
            "MultiLineString" => {
                for line in coordinates.list()? {
                    let line = self.positions(line)?;
                    self.lines.push(line);
                }
            }
            _ => self.others += 1,
        }
        Ok(())
    }

    fn positions(&mut self, coordinates: &Coordinates) -> Result<Vec<[f64; 2]>, FormatError> {
        coordinates.list()?.iter().map(|position| self.position(position)).collect()
    }

    fn position(&mut self, coordinates: &Coordinates) -> Result<[f64; 2], FormatError> {
        let &Coordinates::Position { point, is_flat } = coordinates else {
            return Err(FormatError::new(Code::InvalidFile, "there is a list of positions in place of a position"));
        };
        self.heights += usize::from(!is_flat);
        Ok([point.x, point.y])
    }
}
