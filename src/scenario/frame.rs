//! The way between the coordinates of a map and those of the scenario that was read from it.

use super::document;
use crate::error::Error;
use crate::json;
use serde::Serialize;

/// The way between the coordinates of a map, in which people have their paths, and those of its scenario, from which the import
/// may have subtracted an offset. Nothing of planning depends on it. The default changes nothing: a scenario that comes from no
/// map has its own coordinates.
///
/// ```
/// use planarium::scenario::{MapFrame, MapPlane};
///
/// // 68 km per degree of longitude and 111 km per degree of latitude, about a place in Berlin.
/// let plane = MapPlane { origin: [13.4, 52.5], scale: [68e3, 111e3], degrees: true };
/// let frame = MapFrame::new([0.0; 2], Some(plane))?;
/// assert_eq!(frame.to_units([6800.0, 0.0]), [13.5, 52.5]);
/// # Ok::<(), planarium::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct MapFrame {
    offset: [f64; 2],
    #[serde(skip_serializing_if = "Option::is_none")]
    plane: Option<MapPlane>,
}

/// The plane of a map whose coordinates are not metres: metres are its coordinates less `origin`, times `scale`, for each axis.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct MapPlane {
    /// What is subtracted from coordinates of the map.
    pub origin: [f64; 2],
    /// Metres per unit of the map.
    pub scale: [f64; 2],
    /// Whether the coordinates are longitude and latitude, in degrees.
    pub degrees: bool,
}

impl MapFrame {
    /// The frame of a map from which `offset` was subtracted, in metres, after the way through the plane if there is one.
    ///
    /// # Errors
    /// `not-finite`, `out-of-range` (pointers `/offset/0`, `/plane/scale/1` and the like): offset and origin lie within -1e18
    /// and 1e18, scales within 1e-12 and 1e12.
    pub fn new(offset: [f64; 2], plane: Option<MapPlane>) -> Result<Self, Error> {
        json::read::<document::MapFrame>(&json::finite_tree(&Self { offset, plane })?).map(Self::of)
    }

    /// What was subtracted from every coordinate in metres.
    pub fn offset(&self) -> [f64; 2] {
        self.offset
    }

    /// Of a map whose coordinates are not metres, the way to them.
    pub fn plane(&self) -> Option<&MapPlane> {
        self.plane.as_ref()
    }

    /// Whether coordinates of the map are longitude and latitude.
    pub fn has_degrees(&self) -> bool {
        self.plane.is_some_and(|plane| plane.degrees)
    }

    /// Whether the scenario has the coordinates of the map: places are the same in both.
    pub fn is_identity(&self) -> bool {
        *self == Self::default()
    }

    /// The largest gap between neighbouring numbers at the offset, in metres: coordinates of the map are not told apart better.
    pub fn resolution(&self) -> f64 {
        self.offset.iter().fold(0.0, |most: f64, x| most.max(x.abs().next_up() - x.abs()))
    }

    /// A place in metres, as the map has them, in the scenario.
    pub fn from_metres(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x - self.offset[0], y - self.offset[1]]
    }

    /// A place of the scenario in metres, as the map has them.
    pub fn to_metres(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x + self.offset[0], y + self.offset[1]]
    }

    /// A place in units of the map, such as longitude and latitude, in the scenario.
    pub fn from_units(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        self.from_metres(match self.plane {
            Some(MapPlane { origin, scale, .. }) => [(x - origin[0]) * scale[0], (y - origin[1]) * scale[1]],
            None => [x, y],
        })
    }

    /// A place of the scenario in units of the map, such as longitude and latitude.
    pub fn to_units(&self, place: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.to_metres(place);
        match self.plane {
            Some(MapPlane { origin, scale, .. }) => [x / scale[0] + origin[0], y / scale[1] + origin[1]],
            None => [x, y],
        }
    }
}

impl MapFrame {
    /// That of a document.
    pub(super) fn of(document::MapFrame { offset, plane }: document::MapFrame) -> Self {
        let plane = plane.map(|document::MapPlane { origin, scale, degrees }| MapPlane {
            origin: origin.map(|number| number.0),
            scale: scale.map(|number| number.0),
            degrees,
        });
        Self { offset: offset.map(|number| number.0), plane }
    }
}
