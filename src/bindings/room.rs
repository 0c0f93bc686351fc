//! How much room there is, for JavaScript: the widest disc, the safest path, and route graphs.

use super::arguments::{fields, text};
use super::digits;
use super::records::record;
use super::scenario::Scenario;
use super::types::{JsRouteGraphOptions, JsText};
use crate::Error;
use crate::optimum::{self, Safest, Widest};
use crate::options::Options;
use crate::route_graph::{self, RouteGraphOptions};
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Options of `scenario.routeGraph`. */
export interface RouteGraphOptions {
  /** The number of free places of the dense roadmap that the graph is measured by, 1 to 20,000; 2000 by default. */
  samples?: number;
  /** How many times as long as the way over the dense roadmap the way over the graph may be, 1 to 100; 1.5 by default. */
  detour?: number;
  /**
   * How far from a node the places that it covers may be, in a straight line, in metres; a tenth of the world's longer side by
   * default.
   */
  longestLeg?: number;
  /** A whole number from 0 (default) to 2^53 - 1. */
  seed?: number;
}
"#;

/// An edge of a route graph: a straight way that is proven free in both directions.
#[derive(Serialize, Tsify)]
pub struct RouteEdge {
    /// The numbers of its ends, from 0, the first less than the second.
    #[tsify(type = "[number, number]")]
    nodes: [u32; 2],
    /// Its length, in metres.
    length: f64,
}

/// A sparse graph of proven edges over the free places of a robot.
#[derive(Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct RouteGraph {
    /// The name of the scenario.
    scenario: String,
    /// What it is proven for: a fingerprint of world and robot, 16 hexadecimal digits.
    fingerprint: String,
    /// The places of the nodes, in metres. The robot can turn on the spot at each.
    #[tsify(type = "Point[]")]
    nodes: Vec<[f64; 2]>,
    /// The edges, ordered by their nodes.
    edges: Vec<RouteEdge>,
    /// How many parts it has that are not joined; those of the dense roadmap.
    parts: u32,
    /// The share of free places, from 0 to 1, from which a straight way no longer than `longestLeg` leads to a node.
    covered: f64,
    /// The largest factor by which the way between two nodes is longer over the graph than over the dense roadmap.
    largest_detour: f64,
    /// The number of vertices of the dense roadmap.
    samples: u32,
    /// The detour that was allowed.
    detour: f64,
    /// How far from a node the places that it covers are, at most, in metres.
    longest_leg: f64,
    /// The seed.
    seed: u64,
    /// The radius of the disc that is free at every node, in metres, with the margin: of a disc, or the reach of a footprint.
    turning_radius: f64,
}

impl From<route_graph::RouteGraph> for RouteGraph {
    fn from(graph: route_graph::RouteGraph) -> Self {
        let edge = |edge: &route_graph::RouteEdge| RouteEdge { nodes: edge.nodes, length: edge.length };
        let RouteGraphOptions { detour, longest_leg, seed, .. } = graph.options;
        Self {
            scenario: graph.scenario,
            fingerprint: digits(graph.fingerprint),
            nodes: graph.nodes,
            edges: graph.edges.iter().map(edge).collect(),
            parts: graph.parts,
            covered: graph.covered,
            largest_detour: graph.largest_detour,
            samples: graph.samples,
            detour,
            longest_leg: longest_leg.expect("a graph has a longest leg"),
            seed,
            turning_radius: graph.turning_radius,
        }
    }
}

/// The name of a query.
fn query(name: Option<JsText>) -> Result<Option<String>, Error> {
    name.map(|name| text(&name, "query")).transpose()
}

#[wasm_bindgen]
impl Scenario {
    /// How wide a disc may be to pass from the start to the goal of a query, the first one by default, exact; and the bottleneck.
    /// Radius and margin of the scenario's own disc do not matter.
    /// @throws {PlanariumError} `unsupported` for any robot but a disc, and for a query with a target; `unknown-query`,
    /// `wrong-type`, `start-in-collision`, `goal-in-collision`; `too-large` for more than 4,000,000 contacts or gaps between
    /// neighbours
    pub fn widest(&self, query: Option<JsText>) -> Result<Ts<Widest>, Error> {
        optimum::widest(&self.world, self::query(query)?.as_deref()).map(|widest| record(&widest))
    }

    /// The safest path of a query, the first one by default: no path of a disc's centre keeps farther from all obstacles and from
    /// the bounds, and this is the shortest that keeps as far. Radius and margin of the scenario's own disc do not matter.
    /// @throws {PlanariumError} those of `widest`
    pub fn safest(&self, query: Option<JsText>) -> Result<Ts<Safest>, Error> {
        optimum::safest(&self.world, self::query(query)?.as_deref()).map(|safest| record(&safest))
    }

    /// A sparse graph of proven edges over the free places of a disc, or of a rigid body that turns on the spot at nodes and
    /// drives forward along edges. Between any two nodes the way over it is at most `detour` times as long as that over a dense
    /// roadmap. Queries do not count. Without a free place it has no nodes. It takes a second for a map of 2000 corners: make it
    /// in a worker.
    /// @throws {PlanariumError} `unsupported` for an arm or a car; `out-of-range`, `not-finite`, `wrong-type`,
    /// `unknown-parameter`; `too-large` for more than 2000 nodes
    #[wasm_bindgen(js_name = routeGraph)]
    pub fn route_graph(&self, options: Option<JsRouteGraphOptions>) -> Result<Ts<RouteGraph>, Error> {
        let options = RouteGraphOptions::read(&fields(options)?.parameters())?;
        route_graph::route_graph(&self.world, &options).map(|graph| record(&graph.into()))
    }
}
