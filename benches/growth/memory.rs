//! Memory of a roadmap, part by part: the bytes held at the end, and the most held while it grew.

use super::time::forest;
use planarium::graph::{Adjacency, Event, EventKind, Graph, VertexId};
use planarium::nearest::{Index, Nearest};
use planarium::random::{Random, Stream};
use planarium::run::{Options, Status, Value, start};
use planarium::space::{Coordinate, Metric, ProductSpace, Space};
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// The system's allocator, counted: bytes held now, and the most since the last measurement.
pub struct Counting;

static HELD: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);

fn take(bytes: usize) {
    let held = HELD.fetch_add(bytes, Relaxed) + bytes;
    MOST.fetch_max(held, Relaxed);
}

fn give(bytes: usize) {
    HELD.fetch_sub(bytes, Relaxed);
}

// SAFETY: every call is the system allocator's own; the counters touch no memory that is allocated.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        take(layout.size());
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        give(layout.size());
        unsafe { System.dealloc(at, layout) }
    }

    unsafe fn realloc(&self, at: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // Old and new may exist side by side while one is copied.
        take(size);
        let moved = unsafe { System.realloc(at, layout, size) };
        give(layout.size());
        moved
    }
}

/// The bytes that a piece of work holds at its end, and the most that it held.
fn measure<T>(work: impl FnOnce() -> T) -> (T, usize, usize) {
    let before = HELD.load(Relaxed);
    MOST.store(before, Relaxed);
    let made = work();
    (made, HELD.load(Relaxed) - before, MOST.load(Relaxed) - before)
}

type Arm = ProductSpace<4>;

/// Prints the memory of a vertex and of an edge.
pub fn print(is_quick: bool) {
    let n = if is_quick { 20_000 } else { 1_000_000 };
    let space = Arm::new(&[Coordinate::Circle; 4], Metric::Sum);
    let mut random = Random::new(1, Stream::Samples);
    let states: Vec<[f64; 4]> = (0..n).map(|_| space.sample(&mut random)).collect();
    println!("\nMemory, 4R, {n} vertices, bytes each.\n");
    println!("| what | held | at most while growing |\n|---|---|---|");
    let row = |what: &str, count: usize, held: usize, most: usize| {
        println!("| {what} | {:.1} | {:.1} |", held as f64 / count as f64, most as f64 / count as f64);
        held as f64 / count as f64
    };

    let (mut graph, held, most) = measure(|| {
        let mut graph = Graph::<Arm>::default();
        for (i, &state) in states.iter().enumerate() {
            graph.add_vertex(i as u32, state);
        }
        graph
    });
    let in_graph = row("vertex in the graph: state 32, birth 4", n, held, most);
    let (index, held, most) = measure(|| {
        let mut index = Index::<Arm>::new();
        for (i, &state) in states.iter().enumerate() {
            index.insert(&space, VertexId(i as u32), state);
        }
        index
    });
    let in_index = row(
        "vertex in the index: a second copy of the state 32, number 4, spare capacity in leaves, boxes",
        n,
        held,
        most,
    );
    // A clone allocates no more than it needs: no spare capacity of lists that double.
    let (tight, held, most) = measure(|| (graph.clone(), index.clone()));
    row("vertex in both, as a clone: without spare capacity", n, held, most);
    drop((tight, index));

    let edges = 4 * n;
    let end = |i: usize, step: usize| VertexId(((i * step + 1) % n) as u32);
    let ((), held, most) = measure(|| (0..edges).for_each(|i| graph.add_edge(i as u32, end(i, 7), end(i, 11))));
    let an_edge = row("edge in the graph: two ends 8, birth 4", edges, held, most);
    let (adjacency, held, most) = measure(|| Adjacency::new(n, graph.edges()));
    row("edge during a search: two ends 8, and the rows' starts", edges, held, most);
    drop(adjacency);
    let ((), held, most) = measure(|| {
        for (i, &state) in states.iter().enumerate() {
            let (vertex, other) = (Some(VertexId(i as u32)), Some(VertexId(0)));
            graph.add_event(Event { kind: EventKind::EdgeRefused, iteration: i as u32, vertex, other, state });
        }
    });
    row("event, such as an edge refused: kind, birth, two vertices, a state", n, held, most);
    drop(graph);

    let state = size_of::<[f64; 4]>() as f64;
    let verdict = |value: f64, aim: f64| if value <= aim { "reached" } else { "MISSED" };
    let a_vertex = in_graph + in_index;
    println!(
        "\nGraph and index: {a_vertex:.1} bytes a vertex; aim: the state, {state}, + 32: {}.",
        verdict(a_vertex, state + 32.0)
    );
    println!("Graph: {an_edge:.1} bytes an edge; aim: 16: {}.", verdict(an_edge, 16.0));
    println!(
        "Lists double when they are full, so up to half of the memory may be spare; {n} vertices fill theirs to {:.0} %.",
        filled(n)
    );
    whole_run(n);
}

/// How full a list of that many is if its capacity doubles when it is full, in percent.
fn filled(n: usize) -> f64 {
    100.0 * n as f64 / n.next_power_of_two() as f64
}

/// A whole run, with everything that it stores: events, the edges tried, the search.
fn whole_run(n: usize) {
    let world = forest(4);
    let parameters = [("samples", n as f64), ("k", 10.0), ("max_iterations", 4e9)];
    let parameters = parameters.map(|(name, value)| (name.to_owned(), Value::Number(value))).to_vec();
    let options = Options { planner: Some("prm".to_owned()), query: None, seed: 1, parameters };
    let (run, held, most) = measure(|| {
        let mut run = start(&world, &options).expect("start and goal are free");
        while run.step(u64::MAX) == Status::Running {}
        run
    });
    let megabytes = |bytes: usize| bytes as f64 / 1e6;
    println!(
        "\nA whole k-PRM, 4R forest, k = 10: {} vertices, {} edges, {} events: {:.0} MB held, {:.0} MB at most, {:.0} bytes a vertex.",
        run.vertex_count(),
        run.edge_count(),
        run.event_count(),
        megabytes(held),
        megabytes(most),
        held as f64 / n as f64
    );
}
