//! Route graphs: few nodes and proven straight edges, over which a robot gets everywhere without large detours.
//!
//! A dense roadmap of free places is made (`dense.rs`); guards among them see all others (`cover.rs`); a spanner joins the
//! guards so that no way between them is much longer than that over the roadmap (`spanner.rs`); and nodes that are not needed
//! are removed (`prune.rs`).
//!
//! **What is proven.** At every node the robot can turn on the spot: a disc is free there, and so is the disc that contains a
//! footprint at every heading, about its reference point. Along every edge it is free in both directions: a disc as it is; a
//! footprint as it drives forward, with the heading of the edge, unless the disc that it turns in is free all along
//! (`ground.rs`).
//!
//! **What is kept.** For any two nodes the way over the graph is at most `detour` times the way over the dense roadmap, and there
//! is one if the roadmap has one. Let ways between nodes over the roadmap be longer than shortest paths by a part e at most. Then
//! for any two places p and q that see nodes by straight ways, the legs, whichever nodes these are,
//!
//! ```text
//! way over the graph from p to q  <=  detour (1 + e) (shortest path from p to q + legs) + legs
//! ```
//!
//! since the shortest path between the nodes is no longer than that by way of p and q. How large e is is not proven; it
//! vanishes as `samples` grow. Every sample of the roadmap sees a node within a leg; which share of all free places does is
//! measured on others (`covered`).
//!
//! Not proven is that the roadmap has joined all that can be joined: a passage that no straight way between samples leads
//! through leaves two parts of the graph.
//!
//! ```
//! use planarium::route_graph::{RouteGraphOptions, route_graph};
//! use planarium::scenario::Scenario;
//!
//! let scenario = Scenario::parse(
//!     r#"{ "format": "planarium-scenario-1", "name": "post",
//!          "world": { "bounds": { "min": [0, 0], "max": [4, 4] },
//!                     "obstacles": [ { "type": "disc", "center": [2, 2], "radius": 0.5 } ] },
//!          "robot": { "type": "disc", "radius": 0.2 }, "queries": [] }"#,
//! )?;
//! let graph = route_graph(&scenario, &RouteGraphOptions { samples: 300, ..RouteGraphOptions::default() })?;
//! assert!(graph.parts == 1 && graph.covered > 0.95);
//! assert!(graph.nodes.len() < 60 && graph.largest_detour < 1.5 + 1e-9);
//! # Ok::<(), planarium::Error>(())
//! ```

mod cover;
mod dense;
mod ground;
mod prune;
mod spanner;

use self::cover::{Cover, guards, nearest_seen};
use self::dense::{Dense, shortest_ways};
use self::ground::{Ground, State};
use self::prune::prune;
use self::spanner::Spanner;
use crate::error::Error;
use crate::geometry::sort_stably;
use crate::graph::UnionFind;
use crate::options::Options as _;
use crate::random::{MAX_SEED, Random, Stream};
use crate::run::storage::fingerprint;
use crate::space::Space;
use crate::world::PlanningWorld;

/// The most nodes of a route graph.
pub const MAX_NODES: usize = 2000;

/// The longest leg if none is given, as a fraction of the world's longer side.
const LEG: f64 = 0.1;

/// The most places that are drawn for each free one on which the covered share is measured.
const DRAWS: u32 = 1000;

crate::options! {
    /// Options of a route graph.
    pub struct RouteGraphOptions for &["disc", "rigid_body"];
    /// Number of free places of the dense roadmap that the graph is measured by; more find narrower passages and shorter ways.
    samples: u32 = 2000, in 1.0..=20_000.0, "Samples";
    /// How many times as long as the way over the dense roadmap the way over the graph may be; less needs more nodes and edges.
    detour: f64 = 1.5, in 1.0..=100.0, "Detour";
    /// How far from a node the places that it covers may be, in a straight line; less needs more nodes.
    longest_leg: Option<f64>, in 1e-9..=1e7, "Longest leg", unit "m", else "a tenth of the world's longer side";
    /// The seed: with the scenario and the other options it decides every bit of the graph.
    seed: u64 = 0, in 0.0..=MAX_SEED as f64, "Seed";
}

/// An edge of a route graph: a straight way that is proven free in both directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RouteEdge {
    /// The numbers of its ends, from 0, the first less than the second.
    pub nodes: [u32; 2],
    /// Its length in metres.
    pub length: f64,
}

/// A route graph.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct RouteGraph {
    /// The name of the scenario.
    pub scenario: String,
    /// What it is proven for: [`fingerprint`] of world and robot.
    pub fingerprint: u64,
    /// The options, with the longest leg.
    pub options: RouteGraphOptions,
    /// The radius of the disc that is free at every node, with the margin, in metres: that of a disc, or the reach of a
    /// footprint.
    pub turning_radius: f64,
    /// The places of the nodes, x and y in metres, in the coordinates of the scenario.
    pub nodes: Vec<[f64; 2]>,
    /// The edges, ordered by their nodes.
    pub edges: Vec<RouteEdge>,
    /// How many parts it has that are not joined; those of the dense roadmap.
    pub parts: u32,
    /// How many vertices the dense roadmap has: free samples and connectors.
    pub samples: u32,
    /// The share of further free places, as many as `options.samples`, from which a straight way no longer than a leg leads to a
    /// node; 0 if there is no free place.
    pub covered: f64,
    /// The largest factor, over all pairs of nodes, by which the way over the graph is longer than over the dense roadmap; at
    /// most `options.detour` but for rounding, and 1 without pairs.
    pub largest_detour: f64,
}

/// The route graph of the scenario's world and robot; its queries do not count. Without a free place it has no nodes.
///
/// O(n log n) nearest neighbours and proofs for n samples, O(n) proofs for each node, a search of the roadmap for each node, and
/// O(nodes^2) for each edge.
///
/// # Errors
/// `unsupported` (pointer `/robot/type`) for an arm or a car; `out-of-range` or `not-finite` with the pointer of an option;
/// `too-large` for more than [`MAX_NODES`] nodes.
pub fn route_graph(scenario: impl Into<PlanningWorld>, options: &RouteGraphOptions) -> Result<RouteGraph, Error> {
    options.check()?;
    let world = scenario.into();
    let ground = Ground::new(&world)?;
    let leg = options.longest_leg.unwrap_or(LEG * ground.bounds().longer_side());
    let options = RouteGraphOptions { longest_leg: Some(leg), ..*options };
    let dense = Dense::build(&ground, &options);
    let mut spanner = Spanner::new(&ground, &dense, options.detour, &guards(&ground, &dense, leg))?;
    let mut cover = Cover::new(&ground, &dense, &spanner.nodes, leg);
    let left = prune(&mut spanner, &mut cover);
    let states: Vec<State> = left.iter().map(|node| dense.states()[spanner.nodes[*node as usize] as usize]).collect();
    let edges = edges(&spanner, &left);
    Ok(RouteGraph {
        scenario: world.scenario().name().to_owned(),
        fingerprint: fingerprint(world.scenario()),
        options,
        turning_radius: ground.radius(),
        parts: parts(states.len(), &edges),
        nodes: states.iter().map(|state| [state[0], state[1]]).collect(),
        edges,
        samples: dense.states().len() as u32,
        covered: covered(&ground, &states, &options, leg),
        largest_detour: largest_detour(&spanner, &left),
    })
}

/// The edges between the nodes that are left, by their new numbers.
fn edges(spanner: &Spanner, left: &[u32]) -> Vec<RouteEdge> {
    let mut edges = Vec::new();
    for (a, &node) in left.iter().enumerate() {
        let mut ends: Vec<(usize, f64)> = Vec::new();
        for &(other, length) in &spanner.neighbours[node as usize] {
            // The nodes that are left keep their order.
            if let Ok(b) = left.binary_search(&other)
                && a < b
            {
                ends.push((b, length));
            }
        }
        sort_stably(&mut ends, |a, b| a.0.cmp(&b.0));
        edges.extend(ends.into_iter().map(|(b, length)| RouteEdge { nodes: [a as u32, b as u32], length }));
    }
    edges
}

/// How many parts a graph has.
fn parts(nodes: usize, edges: &[RouteEdge]) -> u32 {
    let mut sets = UnionFind::default();
    (0..nodes).for_each(|_| sets.add());
    let joined = edges.iter().filter(|edge| sets.join(edge.nodes[0] as usize, edge.nodes[1] as usize)).count();
    (nodes - joined) as u32
}

/// The largest factor by which the way between two nodes is longer than over the dense roadmap.
fn largest_detour(spanner: &Spanner, left: &[u32]) -> f64 {
    let mut largest: f64 = 1.0;
    for &a in left {
        let ways = shortest_ways(&spanner.neighbours, a, None).lengths;
        for &b in left {
            let distance = spanner.distances[a as usize][b as usize];
            if distance > 0.0 && distance < f64::INFINITY {
                largest = largest.max(ways[b as usize] / distance);
            }
        }
    }
    largest
}

/// The share of random free places that see a node.
fn covered(ground: &Ground, nodes: &[State], options: &RouteGraphOptions, leg: f64) -> f64 {
    let mut random = Random::new(options.seed, Stream::Probes);
    let (mut free, mut seen) = (0u32, 0u32);
    for _ in 0..u64::from(options.samples) * u64::from(DRAWS) {
        if free == options.samples {
            break;
        }
        let place = ground.space.sample(&mut random);
        if ground.is_place_free(&place) {
            free += 1;
            seen += u32::from(nearest_seen(ground, nodes, &place, leg).is_some());
        }
    }
    if free == 0 { 0.0 } else { f64::from(seen) / f64::from(free) }
}
