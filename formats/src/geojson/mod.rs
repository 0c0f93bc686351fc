//! GeoJSON (RFC 7946): features whose areas, lines and points are obstacles. The old member `crs` is read as well.
//!
//! A property that most features have, such as `type`, gives the layers. Doors are left out, as they open; so are floors
//! and rooms where other layers are there. With a choice of layers or features, or a walkable area, nothing else is.

pub mod document;

use self::document::{Coordinates, Crs, Head, OTHER_FORMAT, Object};
use crate::draft::Draft;
use crate::error::{Code, FormatError, Place, quoted};
use crate::options::{Filter, Options};
use crate::plane::{self, Said};
use crate::report::Format;
use crate::text::is_object;
use crate::vector::{Drawing, FillRule, Form};
use planarium::geometry::Point;
use planarium::scenario::MAX_VERTICES;

/// The properties that may give the layers; the first that half of the features have does.
const LAYERS: [&str; 8] = ["layer", "Layer", "type", "class", "category", "kind", "indoor", "feature_type"];

/// Layers of doors.
const DOORS: [&str; 8] = ["door", "doors", "doorway", "doorways", "opening", "openings", "gate", "entrance"];

/// Layers of what robots stand on.
const FLOORS: [&str; 28] = [
    "area",
    "areas",
    "bathroom",
    "building outline",
    "corridor",
    "corridors",
    "floor",
    "floors",
    "footprint",
    "geofence",
    "hall",
    "hallway",
    "level",
    "levels",
    "office",
    "outline",
    "room",
    "rooms",
    "section",
    "space",
    "spaces",
    "toilet",
    "unit",
    "units",
    "venue",
    "walkable",
    "zone",
    "zones",
];

/// The types of geometries.
const GEOMETRIES: [&str; 7] =
    ["Point", "MultiPoint", "LineString", "MultiLineString", "Polygon", "MultiPolygon", "GeometryCollection"];

/// Whether a document is GeoJSON: by its type, or, if it is no JSON, by the name of a collection at its beginning.
pub fn is_geojson(bytes: &[u8]) -> bool {
    if !is_object(bytes) {
        return false;
    }
    match serde_json::from_slice::<Head>(bytes) {
        Ok(head) => head
            .kind
            .is_some_and(|kind| kind == "FeatureCollection" || kind == "Feature" || GEOMETRIES.contains(&&*kind)),
        Err(error) if error.to_string().starts_with(OTHER_FORMAT) => false,
        Err(_) => bytes[..bytes.len().min(4096)].windows(19).any(|window| window == b"\"FeatureCollection\""),
    }
}

/// Parses a document.
pub fn parsed(bytes: &[u8]) -> Result<Object, FormatError> {
    serde_json::from_slice(bytes).map_err(|error| FormatError::of_json(&error, "GeoJSON"))
}

/// Reads a document.
pub fn draft(name: &str, bytes: &[u8], options: &Options) -> Result<Draft, FormatError> {
    let root = parsed(bytes)?;
    let said = match root.crs.as_ref().and_then(Crs::name) {
        None => Said::Nothing { usually_degrees: true },
        Some(name) if Crs::is_degrees(name) => Said::Degrees,
        Some(name) => Said::Other(quoted(name.as_bytes())),
    };
    let features: Vec<&Object> = match root.kind.as_deref() {
        Some("FeatureCollection") => root.features.iter().flatten().collect(),
        _ => vec![&root],
    };
    let mut reader = Reader { layer_key: layer_key(&features), ..Reader::default() };
    for (i, feature) in features.iter().enumerate() {
        reader.feature(feature, options).map_err(|error| error.at(Place::Element(format!("feature {i}"))))?;
    }
    let mut drawing = reader.drawing;
    drawing.may_be_walkable = true;
    let is_chosen = options.layers.is_some() || !options.filters.is_empty() || options.walkable == Some(true);
    if reader.layer_key.is_some() && !is_chosen {
        omit_layers(&mut drawing);
    }
    let mut draft = plane::draft(drawing, Format::GeoJson, name, &said, options)?;
    let notes = &mut draft.report.notes;
    match reader.layer_key {
        Some(key) => notes.push(format!("the property {} gives the layers", quoted(key.as_bytes()))),
        None => notes.push("layers are the kinds of shapes".to_owned()),
    }
    for (count, what) in [
        (reader.open_rings, "rings are not closed in the file; they were closed"),
        (reader.heights, "positions have a height, which is left out"),
    ] {
        if count > 0 {
            notes.push(format!("{count} {what}"));
        }
    }
    Ok(draft)
}

/// The property that gives the layers.
fn layer_key(features: &[&Object]) -> Option<&'static str> {
    let has = |key: &str| features.iter().filter(|feature| feature.property(key).is_some()).count();
    LAYERS.into_iter().find(|key| 2 * has(key) > features.len())
}

/// Leaves out doors, and floors if something else is there.
fn omit_layers(drawing: &mut Drawing) {
    let is_in = |list: &[&str], name: &str| list.contains(&&*name.to_lowercase().replace(['_', '-'], " "));
    let mut is_more = false;
    for layer in drawing.layers_mut() {
        if is_in(&DOORS, &layer.name) {
            layer.omitted = Some("doors are open");
        }
        is_more |= layer.omitted.is_none() && !is_in(&FLOORS, &layer.name);
    }
    for layer in drawing.layers_mut().filter(|layer| is_more && is_in(&FLOORS, &layer.name)) {
        layer.omitted = Some("floors are no obstacles");
    }
}

impl Object {
    /// Whether the filters keep a feature.
    fn is_kept(&self, filters: &[Filter]) -> bool {
        let holds = |filter: &Filter| self.property(&filter.key) == Some(&filter.value);
        filters.iter().all(|filter| match filter.keep {
            true => filters.iter().any(|other| other.keep && other.key == filter.key && holds(other)),
            false => !holds(filter),
        })
    }
}

#[derive(Default)]
struct Reader {
    drawing: Drawing,
    layer_key: Option<&'static str>,
    points: usize,
    open_rings: usize,
    heights: usize,
}

impl Reader {
    fn feature(&mut self, feature: &Object, options: &Options) -> Result<(), FormatError> {
        let geometry = match feature.kind.as_deref() {
            Some("Feature") => feature.geometry.as_deref(),
            _ => Some(feature),
        };
        if !feature.is_kept(&options.filters) {
            self.drawing.drop("features that the filters leave out", 1);
            return Ok(());
        }
        let Some(geometry) = geometry else {
            self.drawing.drop("features without geometry", 1);
            return Ok(());
        };
        let layer = self.layer_key.map(|key| feature.property(key).unwrap_or("other").to_owned());
        self.geometry(geometry, layer.as_deref())
    }

    /// The depth is bounded by the parser of JSON.
    fn geometry(&mut self, geometry: &Object, layer: Option<&str>) -> Result<(), FormatError> {
        let kind = geometry.kind.as_deref().unwrap_or_default();
        if kind == "GeometryCollection" {
            return geometry.geometries.iter().flatten().try_for_each(|part| self.geometry(part, layer));
        }
        if !GEOMETRIES.contains(&kind) {
            self.drawing.drop(&format!("geometries of the unknown type {}", quoted(kind.as_bytes())), 1);
            return Ok(());
        }
        let Some(coordinates) = &geometry.coordinates else {
            self.drawing.drop("geometries without coordinates", 1);
            return Ok(());
        };
        if matches!(coordinates, Coordinates::List(list) if list.is_empty()) {
            self.drawing.drop("geometries without coordinates", 1);
            return Ok(());
        }
        let id = |drawing: &mut Drawing, kind: &str| drawing.layer(layer.unwrap_or(kind));
        match kind {
            "Point" => {
                let place = self.position(coordinates)?;
                let id = id(&mut self.drawing, "points");
                self.drawing.push(id, Form::Spot(place));
            }
            "MultiPoint" => {
                for place in self.positions(coordinates)? {
                    let id = id(&mut self.drawing, "points");
                    self.drawing.push(id, Form::Spot(place));
                }
            }
            "LineString" | "MultiLineString" => {
                let one = std::slice::from_ref(coordinates);
                for line in if kind == "LineString" { one } else { coordinates.list()? } {
                    let points = self.positions(line)?;
                    let id = id(&mut self.drawing, "lines");
                    self.drawing.push(id, Form::Line { points, closed: false, width: None });
                }
            }
            _ => {
                let one = std::slice::from_ref(coordinates);
                for polygon in if kind == "Polygon" { one } else { coordinates.list()? } {
                    let rings = polygon.list()?.iter().map(|ring| self.ring(ring)).collect::<Result<_, _>>()?;
                    let id = id(&mut self.drawing, "areas");
                    self.drawing.push(id, Form::Area { rings, rule: FillRule::EvenOdd });
                }
            }
        }
        Ok(())
    }

    fn ring(&mut self, ring: &Coordinates) -> Result<Vec<Point>, FormatError> {
        let points = self.positions(ring)?;
        self.open_rings += usize::from(points.first() != points.last());
        Ok(points)
    }

    fn positions(&mut self, coordinates: &Coordinates) -> Result<Vec<Point>, FormatError> {
        coordinates.list()?.iter().map(|position| self.position(position)).collect()
    }

    fn position(&mut self, coordinates: &Coordinates) -> Result<Point, FormatError> {
        let &Coordinates::Position { point, is_flat } = coordinates else {
            return Err(FormatError::new(Code::InvalidFile, "there is a list of positions in place of a position"));
        };
        self.heights += usize::from(!is_flat);
        self.points += 1;
        if self.points > MAX_VERTICES {
            let sentence = format!("there are more than {MAX_VERTICES} positions, the most of a scenario");
            return Err(FormatError::new(Code::WorldTooLarge, sentence));
        }
        Ok(point)
    }
}
