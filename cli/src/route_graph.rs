//! `planarium route-graph`: a sparse graph of proven edges, for the route server of Nav2.

use crate::arguments::{Answer, seed};
use crate::files;
use crate::kind::Kind;
use crate::output::Destination;
use crate::world::{self, WorldOptions};
use clap::Args;
use planarium::options::{Options, Value};
use planarium::route_graph::{self, RouteGraph, RouteGraphOptions};
use planarium_formats::{RouteWriteOptions, write_route_graph};

#[derive(Args)]
#[command(after_help = "\
For a disc, and for a rigid body that turns on the spot at nodes and drives forward along edges. Every edge is proven free in both
directions. Between any two nodes the way over the graph is at most --detour times that over a dense roadmap of --samples free places,
each of which sees a node by a straight way of at most --leg metres.
Prints GeoJSON: points with \"id\" and \"frame\", then lines with \"id\", \"startid\", \"endid\", the length as \"cost\", and with --speed-limit
\"abs_speed_limit\" in \"metadata\". Positions are metres in the coordinates of the map. What the graph is proven for is in \"route_graph\".
Exit codes: 0 there is a graph; 1 no free place was found; 2 the input is wrong.

Examples:
  planarium route-graph warehouse.yaml --radius 0.3 --out graph.geojson
  planarium route-graph depot.yaml --footprint 0.9x0.62 --detour 1.2 --speed-limit 0.8 --out graph.geojson")]
pub struct Arguments {
    /// The scenario, a JSON file, or a map (see `planarium import`); - reads it from standard input
    file: String,

    /// How many times as long as over the dense roadmap ways over the graph may be [default: 1.5]
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true, value_parser = value)]
    detour: Option<Value>,

    /// The number of free places of the dense roadmap [default: 2000]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = value)]
    samples: Option<Value>,

    /// How far from a node the places that it covers may be, in metres [default: a tenth of the world's longer side]
    #[arg(long, value_name = "M", allow_negative_numbers = true, value_parser = value)]
    leg: Option<Value>,

    /// The seed: together with the scenario and all options it decides every bit of the graph; "random" draws one, which is
    /// printed with the graph
    #[arg(long, value_name = "N|random", default_value_t = 0, allow_negative_numbers = true, value_parser = seed)]
    seed: u64,

    /// The speed limit of every edge, in metres per second [default: none]
    #[arg(long, value_name = "M/S", allow_negative_numbers = true)]
    speed_limit: Option<f64>,

    /// The frame that the nodes are in [default: map]
    #[arg(long, value_name = "NAME")]
    frame_id: Option<String>,

    #[command(flatten)]
    destination: Destination,

    #[command(flatten)]
    world: WorldOptions,
}

/// Prints the graph; true if it has a node.
pub fn route_graph(arguments: &Arguments) -> Answer {
    let (outputs, out) = arguments.destination.beside([&*arguments.file], Kind::ROUTE_GRAPH)?;
    let scenario = world::document_or_map(&arguments.file, None, &arguments.world, &outputs)?.scenario()?;
    let Arguments { detour, samples, leg, seed, speed_limit, frame_id, .. } = arguments;
    let given = [("detour", detour), ("samples", samples), ("longest_leg", leg)];
    let given = given.into_iter().filter_map(|(name, value)| Some((name.to_owned(), value.clone()?)));
    let options = RouteGraphOptions { seed: *seed, ..RouteGraphOptions::read(&given.collect::<Vec<_>>())? };
    let graph = route_graph::route_graph(&scenario, &options)?;
    if graph.nodes.is_empty() {
        files::say("no free place was found: nothing is written");
        return Ok(false);
    }
    let options = RouteWriteOptions { frame_id: frame_id.clone(), speed_limit: *speed_limit };
    let bytes = write_route_graph(&scenario, &graph, &options)?;
    files::say(&message(&graph));
    out.write_bytes(&bytes)?;
    Ok(true)
}

/// The text of an option as its value.
#[allow(clippy::unnecessary_wraps, reason = "clap asks for a result")]
fn value(text: &str) -> Result<Value, String> {
    Ok(Value::from_text(text))
}

/// The graph for people.
fn message(graph: &RouteGraph) -> String {
    let RouteGraph { nodes, edges, parts, covered, largest_detour, options, .. } = graph;
    let parts = if *parts == 1 { String::new() } else { format!(" in {parts} parts that are not joined") };
    let leg = options.longest_leg.unwrap_or_default();
    let edges = if edges.is_empty() {
        "no edge, without which Nav2 refuses it".to_owned()
    } else {
        format!("{} connections, two edges each", edges.len())
    };
    format!(
        "route graph: {} nodes, {edges}{parts}; ways at most {largest_detour:.3} times those over the roadmap; {:.2} % of free places \
         see a node within {leg} m",
        nodes.len(),
        100.0 * covered,
    )
}
