//! Route graphs as GeoJSON: read back as the documentation of Nav2's route server describes its graphs, in the coordinates of
//! the map.

use crate::documents::needed;
use planarium::geometry::{Aabb, Point};
use planarium::problem::Validity;
use planarium::robot::{DiscRobot, RigidBody, Weights};
use planarium::route_graph::{RouteGraph, RouteGraphOptions, route_graph};
use planarium::scenario::{MapFrame, MapPlane, Obstacle, Robot, Scenario, World, polygon};
use planarium_formats::{Code, File, Options, RobotChoice, RouteWriteOptions, read, write_route_graph};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;

fn floor(robot: Robot, frame: MapFrame) -> Scenario {
    let bounds = Aabb::of(Point::origin(), Point::new(6.0, 4.0));
    let obstacles = [Obstacle::disc(Point::new(3.0, 2.0), 0.8)];
    Scenario::new("floor <1>", World::new(Some(bounds), obstacles), robot, []).expect("a floor").in_frame(frame)
}

fn disc() -> Robot {
    DiscRobot::new(0.2).expect("a disc").into()
}

fn body() -> Robot {
    let corners = [[-0.2, -0.1], [0.3, -0.1], [0.3, 0.1], [-0.2, 0.1]].map(|[x, y]| Point::new(x, y));
    RigidBody::new(polygon(&corners).expect("a shape"), Weights::default()).into()
}

fn made(world: &Scenario) -> RouteGraph {
    let options = RouteGraphOptions { samples: 200, ..RouteGraphOptions::default() };
    route_graph(world, &options).unwrap_or_else(|error| panic!("{error}"))
}

/// A graph as the route server holds it: places by id, edges by id with their ends, cost and metadata.
#[derive(Default)]
struct Loaded {
    nodes: BTreeMap<u32, [f64; 2]>,
    frames: Vec<String>,
    edges: BTreeMap<u32, (u32, u32, f64, Value)>,
}

/// Reads a graph by the rules of the documentation: features with points are nodes, those with lines are edges; nodes and edges
/// have an `id`, unique among both; edges have a `startid` and an `endid` of nodes; coordinates are x and y. Numbers that the
/// server takes for fractions have a point, as it keeps whole ones as integers.
fn load(bytes: &[u8]) -> Loaded {
    let document: Value = serde_json::from_slice(bytes).expect("JSON");
    assert_eq!(document["type"], "FeatureCollection");
    let mut loaded = Loaded::default();
    let id = |value: &Value| u32::try_from(value.as_u64().expect("an unsigned number")).expect("32 bits");
    let xy = |value: &Value| [0, 1].map(|i| value[i].as_f64().expect("a coordinate"));
    for feature in document["features"].as_array().expect("features") {
        assert_eq!(feature["type"], "Feature");
        let (properties, geometry) = (&feature["properties"], &feature["geometry"]);
        let own = id(&properties["id"]);
        assert!(!loaded.nodes.contains_key(&own) && !loaded.edges.contains_key(&own), "the id {own} is there twice");
        match geometry["type"].as_str() {
            Some("Point") => {
                assert!(loaded.edges.is_empty(), "nodes come before edges");
                loaded.frames.push(properties["frame"].as_str().expect("a frame").to_owned());
                loaded.nodes.insert(own, xy(&geometry["coordinates"]));
            }
            Some("MultiLineString") => {
                let [start, end] = ["startid", "endid"].map(|name| id(&properties[name]));
                let lines = geometry["coordinates"].as_array().expect("lines");
                assert_eq!((lines.len(), lines[0].as_array().map(Vec::len)), (1, Some(2)));
                assert_eq!([0, 1].map(|i| xy(&lines[0][i])), [start, end].map(|node| loaded.nodes[&node]));
                assert!(properties["cost"].is_f64() && properties["overridable"] == true, "{properties}");
                let cost = properties["cost"].as_f64().expect("a cost");
                loaded.edges.insert(own, (start, end, cost, properties["metadata"].clone()));
            }
            other => panic!("{other:?} is neither a node nor an edge"),
        }
    }
    assert!(!loaded.nodes.is_empty() && !loaded.edges.is_empty(), "the server refuses such a graph");
    loaded
}

#[test]
fn the_graph_is_read_as_nav2_documents_it() {
    for (robot, kind) in [(disc(), "disc"), (body(), "rigid_body")] {
        let plane = MapPlane { origin: [13.4, 52.5], scale: [67_000.0, 111_000.0], degrees: true };
        for frame in [
            MapFrame::default(),
            MapFrame::new([4.5e6, -1024.0], None).expect("a frame"),
            MapFrame::new([0.0; 2], Some(plane)).expect("a frame"),
        ] {
            let world = floor(robot.clone(), frame);
            let graph = made(&world);
            let options = RouteWriteOptions { frame_id: Some("level_1".to_owned()), speed_limit: Some(1.0) };
            for options in [options, RouteWriteOptions::default()] {
                let bytes = write_route_graph(&world, &graph, &options).unwrap_or_else(|error| panic!("{error}"));
                let loaded = load(&bytes);
                assert_eq!((loaded.nodes.len(), loaded.edges.len()), (graph.nodes.len(), 2 * graph.edges.len()));
                let frame_id = options.frame_id.as_deref().unwrap_or("map");
                assert!(loaded.frames.iter().all(|frame| frame == frame_id));
                // Metres of the map.
                for (place, node) in loaded.nodes.values().zip(&graph.nodes) {
                    let [x, y] = world.frame().from_metres(*place);
                    assert!((x - node[0]).abs() < 1e-8 && (y - node[1]).abs() < 1e-8);
                }
                for (start, end, cost, metadata) in loaded.edges.values() {
                    let back =
                        loaded.edges.values().find(|edge| (edge.0, edge.1) == (*end, *start)).expect("an edge back");
                    assert_eq!(back.2, *cost);
                    let [[x, y], [to_x, to_y]] = [start, end].map(|node| loaded.nodes[node]);
                    assert!(((to_x - x).hypot(to_y - y) - cost).abs() < 1e-8);
                    match options.speed_limit {
                        Some(limit) => {
                            assert!(metadata["abs_speed_limit"].is_f64() && metadata["abs_speed_limit"] == limit)
                        }
                        None => assert!(metadata.is_null()),
                    }
                }
                let document: Value = serde_json::from_slice(&bytes).expect("JSON");
                let about = &document["route_graph"];
                assert_eq!(about["robot"]["type"], kind);
                assert_eq!((&about["detour"], &about["seed"], &about["parts"]), (&1.5.into(), &0.into(), &1.into()));
                assert_eq!(about["world"].as_str().map(str::len), Some(16));
                assert!(
                    about["proven"].as_str().is_some_and(|text| text.starts_with("every edge, in both directions"))
                );
            }
        }
    }
}

#[test]
fn what_cannot_be_written_is_refused() {
    let world = floor(disc(), MapFrame::default());
    let graph = made(&world);
    let refused = |world: &Scenario, graph: &RouteGraph, options: RouteWriteOptions, code: Code| {
        let error = write_route_graph(world, graph, &options).expect_err("it is refused");
        assert_eq!(error.code(), code, "{error}");
    };
    for limit in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let options = RouteWriteOptions { speed_limit: Some(limit), ..RouteWriteOptions::default() };
        refused(&world, &graph, options, Code::InvalidOption);
    }
    let nameless = RouteWriteOptions { frame_id: Some(String::new()), ..RouteWriteOptions::default() };
    refused(&world, &graph, nameless, Code::InvalidOption);
    refused(&floor(body(), MapFrame::default()), &graph, RouteWriteOptions::default(), Code::InvalidOption);
    let mut empty = graph;
    (empty.nodes, empty.edges) = (Vec::new(), Vec::new());
    refused(&world, &empty, RouteWriteOptions::default(), Code::Truncated);
}

/// The warehouse of Nav2's demonstrations with the disc of its robot.
#[test]
fn a_warehouse_has_a_graph_of_few_nodes() {
    let Some(folder) = needed("PLANARIUM_WORLDS") else { return };
    let files = ["warehouse.yaml", "warehouse.pgm"];
    let bytes =
        files.map(|name| std::fs::read(Path::new(&folder).join("ros").join(name)).expect("a file of the folder"));
    let files: Vec<File> = files.iter().zip(&bytes).map(|(name, bytes)| File { name, bytes }).collect();
    let options = Options { robot: RobotChoice::Disc { radius: 0.3 }, ..Options::default() };
    let world = read(&files, &options).unwrap_or_else(|error| panic!("{error}")).scenario;
    let graph = route_graph(&world, &RouteGraphOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    assert!(graph.nodes.len() <= 200 && graph.covered > 0.98, "{} nodes, {}", graph.nodes.len(), graph.covered);
    let loaded = load(&write_route_graph(&world, &graph, &RouteWriteOptions::default()).expect("nodes"));
    // Samples, from the coordinates that are in the file.
    let checker = planarium::collision::DiscValidity::new(&DiscRobot::new(0.3).expect("a disc"), world.world());
    for (start, end, _, _) in loaded.edges.values() {
        let [a, b] = [start, end].map(|node| world.frame().from_metres(loaded.nodes[node]));
        for i in 0..=200 {
            let t = f64::from(i) / 200.0;
            let at = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
            assert!(checker.contacts(&at).is_empty(), "{at:?}");
        }
    }
}
