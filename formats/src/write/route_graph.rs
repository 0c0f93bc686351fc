//! A route graph as GeoJSON, as the route server of Nav2 reads it.

use crate::error::{Code, FormatError};
use planarium::route_graph::RouteGraph;
use planarium::run::storage::fingerprint;
use planarium::scenario::{Robot, Scenario};
use serde::Serialize;

/// How a route graph is written.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RouteWriteOptions {
    /// The name of the frame that the nodes are in; `map` by default.
    pub frame_id: Option<String>,
    /// The speed limit of every edge, in metres per second, greater than 0; none by default.
    pub speed_limit: Option<f64>,
}

#[derive(Serialize)]
struct Collection<'a> {
    r#type: &'static str,
    name: &'a str,
    crs: Crs,
    route_graph: About<'a>,
    features: Vec<Feature<'a>>,
}

/// The system of Nav2's own graphs: without one, readers such as QGIS take metres for degrees.
#[derive(Serialize)]
struct Crs {
    r#type: &'static str,
    properties: Named,
}

#[derive(Serialize)]
struct Named {
    name: &'static str,
}

/// What the graph is proven for, and how it was made.
#[derive(Serialize)]
struct About<'a> {
    generator: &'static str,
    scenario: &'a str,
    world: String,
    robot: AboutRobot,
    proven: String,
    samples: u32,
    detour: f64,
    longest_leg: Option<f64>,
    seed: u64,
    parts: u32,
    covered: f64,
    largest_detour: f64,
}

#[derive(Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
enum AboutRobot {
    Disc { radius: f64, margin: f64 },
    RigidBody { footprint: Vec<[f64; 2]>, margin: f64 },
}

#[derive(Serialize)]
struct Feature<'a> {
    r#type: &'static str,
    properties: Properties<'a>,
    geometry: Geometry,
}

#[derive(Serialize)]
#[serde(untagged)]
enum Properties<'a> {
    Node {
        id: u32,
        frame: &'a str,
    },
    Edge {
        id: u32,
        startid: u32,
        endid: u32,
        cost: f64,
        overridable: bool,
        #[serde(skip_serializing_if = "Option::is_none")]
        metadata: Option<Metadata>,
    },
}

#[derive(Serialize)]
struct Metadata {
    abs_speed_limit: f64,
}

#[derive(Serialize)]
#[serde(tag = "type", content = "coordinates")]
enum Geometry {
    Point([f64; 2]),
    MultiLineString([[[f64; 2]; 2]; 1]),
}

/// Writes a route graph as GeoJSON for the route server of Nav2 (`GeoJsonGraphFileLoader` of `nav2_route`): the nodes as points
/// with their `id` and `frame`, then two edges for each connection as lines, one in each direction, with `id`, `startid`,
/// `endid`, its length in metres as `cost`, which the scorers of the server override, and in `metadata` the `abs_speed_limit`
/// in metres per second. Ids begin at 1 and are unique among nodes and edges. Positions are metres in the coordinates of the
/// map that the scenario was read from: see [`Scenario::frame`]. The property `route_graph` of the collection, which the server
/// does not read, says what the graph is proven for and how it was made.
///
/// # Errors
/// `truncated` for a graph without nodes; `invalid-option` for a graph of another world or robot, for a speed limit that is not a
/// finite number greater than 0, and for an empty name of the frame.
///
/// # Complexity
/// Linear in nodes, edges, and the size of the scenario.
///
/// ```
/// use planarium::geometry::{Aabb, Point};
/// use planarium::robot::DiscRobot;
/// use planarium::route_graph::{RouteGraphOptions, route_graph};
/// use planarium::scenario::{Scenario, World};
/// use planarium_formats::{RouteWriteOptions, write_route_graph};
///
/// let bounds = Aabb::of(Point::origin(), Point::new(4.0, 2.0));
/// let scenario = Scenario::new("floor", World::new(Some(bounds), []), DiscRobot::new(0.2)?, [])?;
/// let graph = route_graph(&scenario, &RouteGraphOptions { samples: 50, ..RouteGraphOptions::default() })?;
/// let options = RouteWriteOptions { speed_limit: Some(0.8), ..RouteWriteOptions::default() };
/// let bytes = write_route_graph(&scenario, &graph, &options).expect("nodes");
/// assert!(bytes.starts_with(br#"{"type":"FeatureCollection","name":"floor","#));
/// # Ok::<(), planarium::Error>(())
/// ```
pub fn write_route_graph(
    scenario: &Scenario,
    graph: &RouteGraph,
    options: &RouteWriteOptions,
) -> Result<Vec<u8>, FormatError> {
    let invalid = |sentence: String| Err(FormatError::new(Code::InvalidOption, sentence));
    if graph.nodes.is_empty() {
        return Err(FormatError::new(Code::Truncated, "the route graph has no node"));
    }
    if graph.fingerprint != fingerprint(scenario) {
        return invalid("the route graph is of another world or robot".to_owned());
    }
    if let Some(limit) = options.speed_limit.filter(|limit| !(limit.is_finite() && *limit > 0.0)) {
        return invalid(format!("a speed limit is a finite number of metres per second above 0, not {limit}"));
    }
    let frame = match options.frame_id.as_deref() {
        Some("") => return invalid("the name of the frame is empty".to_owned()),
        id => id.unwrap_or("map"),
    };
    let collection = Collection {
        r#type: "FeatureCollection",
        name: scenario.name(),
        crs: Crs { r#type: "name", properties: Named { name: "urn:ogc:def:crs:EPSG::3857" } },
        route_graph: about(scenario, graph)?,
        features: features(scenario, graph, frame, options.speed_limit),
    };
    // The server keeps whole numbers of metadata as integers, where it expects fractions: 1 is written as 1.0.
    let text = serde_json::to_string(&collection).expect("names, numbers and lists have a form in JSON");
    Ok((text + "\n").into_bytes())
}

/// The nodes, then the edges.
fn features<'a>(scenario: &Scenario, graph: &RouteGraph, frame: &'a str, speed_limit: Option<f64>) -> Vec<Feature<'a>> {
    let places: Vec<[f64; 2]> = graph.nodes.iter().map(|&place| scenario.frame().to_metres(place)).collect();
    let feature = |properties, geometry| Feature { r#type: "Feature", properties, geometry };
    let nodes =
        (1u32..).zip(&places).map(|(id, &place)| feature(Properties::Node { id, frame }, Geometry::Point(place)));
    let directed = graph.edges.iter().flat_map(|edge| {
        let [a, b] = edge.nodes;
        [[a, b], [b, a]].map(|ends| (ends, edge.length))
    });
    let edges = (1 + places.len() as u32..).zip(directed).map(|(id, ([a, b], cost))| {
        let metadata = speed_limit.map(|abs_speed_limit| Metadata { abs_speed_limit });
        let line = [[places[a as usize], places[b as usize]]];
        let properties = Properties::Edge { id, startid: a + 1, endid: b + 1, cost, overridable: true, metadata };
        feature(properties, Geometry::MultiLineString(line))
    });
    nodes.chain(edges).collect()
}

/// What the graph is proven for, and how it was made.
fn about<'a>(scenario: &'a Scenario, graph: &RouteGraph) -> Result<About<'a>, FormatError> {
    let (robot, proven) = match scenario.robot() {
        Robot::Disc(disc) => (
            AboutRobot::Disc { radius: disc.radius(), margin: disc.margin() },
            "every edge, in both directions, for the disc with its margin".to_owned(),
        ),
        Robot::RigidBody(body) => (
            AboutRobot::RigidBody {
                footprint: body.shape.vertices().iter().map(|corner| [corner.x, corner.y]).collect(),
                margin: body.margin(),
            },
            format!(
                "every edge, in both directions, for the footprint with its margin that drives forward, or for the disc that it \
                 turns in; at every node turns on the spot, within a disc of radius {} m",
                graph.turning_radius
            ),
        ),
        other => {
            let sentence = format!("the robot {} has no route graph", other.kind());
            return Err(FormatError::new(Code::InvalidOption, sentence));
        }
    };
    Ok(About {
        generator: concat!("planarium ", env!("CARGO_PKG_VERSION")),
        scenario: scenario.name(),
        world: format!("{:016x}", graph.fingerprint),
        robot,
        proven,
        samples: graph.samples,
        detour: graph.options.detour,
        longest_leg: graph.options.longest_leg,
        seed: graph.options.seed,
        parts: graph.parts,
        covered: graph.covered,
        largest_detour: graph.largest_detour,
    })
}
