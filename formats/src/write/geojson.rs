//! A path as GeoJSON: a line, and points with what a line cannot say.

use super::PathRows;
use planarium::scenario::Scenario;
use serde::Serialize;

#[derive(Serialize)]
struct Collection<'a> {
    r#type: &'static str,
    scenario: &'a str,
    query: &'a str,
    features: Vec<Feature>,
}

#[derive(Serialize)]
struct Feature {
    r#type: &'static str,
    properties: Properties,
    geometry: Geometry,
}

#[derive(Serialize)]
struct Properties {
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<&'static str>,
    /// The heading in radians, counter-clockwise from the direction of x.
    #[serde(skip_serializing_if = "Option::is_none")]
    theta: Option<f64>,
    /// The time in seconds.
    #[serde(skip_serializing_if = "Option::is_none")]
    t_s: Option<f64>,
}

#[derive(Serialize)]
#[serde(tag = "type", content = "coordinates")]
enum Geometry {
    LineString(Vec<[f64; 2]>),
    Point([f64; 2]),
}

impl Feature {
    fn new(properties: Properties, geometry: Geometry) -> Self {
        Self { r#type: "Feature", properties, geometry }
    }
}

/// The line, the start and the goal; of robots that turn and of timed paths, all rows between these as well. One row is a line of
/// two equal positions, since a line has two at least. Coordinates are those of the map.
pub fn write(scenario: &Scenario, rows: &PathRows) -> String {
    let PathRows { query, configurations, timing } = rows;
    let places: Vec<[f64; 2]> = configurations.iter().map(|q| scenario.frame().to_units([q[0], q[1]])).collect();
    let mut line = places.clone();
    if let [only] = places[..] {
        line.push(only);
    }
    let path = Properties { name: Some("path"), theta: None, t_s: None };
    let mut features = vec![Feature::new(path, Geometry::LineString(line))];
    let last = places.len() - 1;
    let point = |i: usize, name: Option<&'static str>| {
        let (theta, t_s) = (configurations[i].get(2).copied(), timing.as_ref().map(|timing| timing.times[i]));
        Feature::new(Properties { name, theta, t_s }, Geometry::Point(places[i]))
    };
    features.push(point(0, Some("start")));
    if configurations[0].len() == 3 || timing.is_some() {
        features.extend((1..last).map(|i| point(i, None)));
    }
    features.push(point(last, Some("goal")));
    let document = Collection { r#type: "FeatureCollection", scenario: scenario.name(), query, features };
    planarium::json::to_string(&document) + "\n"
}
