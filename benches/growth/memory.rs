//! Memory of a roadmap, part by part: the bytes held at the end, and the most held while it grew.

use super::counting::measure;
use super::time::{forest, roadmap};
use planarium::graph::{Adjacency, Event, EventKind, Graph, VertexId};
use planarium::nearest::{Index, Nearest};
use planarium::random::{Random, Stream};
use planarium::space::{Coordinate, Metric, ProductSpace, Space};

/// Prints the row of a piece of work, in bytes per item; returns its result and the bytes per item that it holds.
fn row<T>(what: &str, count: usize, work: impl FnOnce() -> T) -> (T, f64) {
    let (made, held, most) = measure(work);
    let [held, most] = [held, most].map(|bytes| bytes as f64 / count as f64);
    println!("| {what} | {held:.1} | {most:.1} |");
    (made, held)
}

type Arm = ProductSpace<4>;

/// Prints the memory of a vertex and of an edge.
pub fn print(is_quick: bool) {
    let n = if is_quick { 20_000 } else { 1_000_000 };
    let space = Arm::new(&[Coordinate::Circle; 4], Metric::Sum);
    let mut random = Random::new(1, Stream::Samples);
    let states: Vec<[f64; 4]> = (0..n).map(|_| space.sample(&mut random)).collect();
    println!("\nMemory, 4R, {n} vertices, bytes per item.\n");
    println!("| what | held | at most while growing |\n|---|---|---|");
    let (mut graph, in_graph) = row("vertex in the graph: state 32, birth 4", n, || {
        let mut graph = Graph::<Arm>::default();
        states.iter().enumerate().for_each(|(i, &state)| _ = graph.add_vertex(i as u32, state));
        graph
    });
    let what = "vertex in the index: the state in single precision 16, number 4, spare capacity in leaves, boxes";
    let (index, in_index) = row(what, n, || {
        let mut index = Index::default();
        states.iter().enumerate().for_each(|(i, state)| index.insert(&space, VertexId(i as u32), state));
        index
    });
    // A clone allocates no more than it needs: no spare capacity of lists that double.
    row("vertex in both, as a clone: without spare capacity", n, || (graph.clone(), index.clone()));
    drop(index);

    let edges = 4 * n;
    let end = |i: usize, step: usize| VertexId(((i * step + 1) % n) as u32);
    let (_, an_edge) = row("edge in the graph: two ends 8, birth 4", edges, || {
        (0..edges).for_each(|i| graph.add_edge(i as u32, end(i, 7), end(i, 11)));
    });
    row("edge during a search: two ends 8, and the rows' starts", edges, || {
        Adjacency::new(n, graph.edges(), &[], false)
    });
    row("event, such as an edge refused: kind, birth, two vertices, a state", n, || {
        for (i, &state) in states.iter().enumerate() {
            let (vertex, other) = (Some(VertexId(i as u32)), Some(VertexId(0)));
            graph.add_event(Event { kind: EventKind::EdgeRefused, iteration: i as u32, vertex, other, state });
        }
    });
    drop(graph);

    let state = size_of::<[f64; 4]>() as f64;
    let verdict = |value: f64, aim: f64| if value <= aim { "reached" } else { "MISSED" };
    let a_vertex = in_graph + in_index;
    println!(
        "\nGraph and index: {a_vertex:.1} bytes per vertex; aim: the state, {state}, + 32: {}.",
        verdict(a_vertex, state + 32.0)
    );
    println!("Graph: {an_edge:.1} bytes per edge; aim: 16: {}.", verdict(an_edge, 16.0));
    println!(
        "Long lists grow by a sixteenth when they are full: up to that share of the memory may be spare, and half of it is on average."
    );
    whole_run(n);
}

/// A whole run, with everything that it stores: events, the edges tried, the search.
fn whole_run(n: usize) {
    let world = forest(4);
    let (run, held, most) = measure(|| roadmap(&world, 1, n as u64, 10));
    let megabytes = |bytes: usize| bytes as f64 / 1e6;
    println!(
        "\nA whole k-PRM, 4R forest, k = 10: {} vertices, {} edges, {} events: {:.0} MB held, {:.0} MB at most, {:.0} bytes per vertex.",
        run.vertex_count(),
        run.edge_count(),
        run.event_count(),
        megabytes(held),
        megabytes(most),
        held as f64 / n as f64
    );
}
