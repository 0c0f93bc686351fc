//! Graphs of runs as viewers see them.

use planarium::graph::EventKind;
use planarium::run::{EVENT_HEAD, Run};

/// The vertices, one row each.
pub fn rows(run: &dyn Run) -> Vec<Vec<f64>> {
    run.vertex_rows(0).chunks(run.dimension()).map(<[f64]>::to_vec).collect()
}

/// The edges by the numbers of their vertices.
pub fn edges(run: &dyn Run) -> Vec<[usize; 2]> {
    run.edge_rows(0).chunks(2).map(|edge| [edge[0] as usize, edge[1] as usize]).collect()
}

/// The events of a kind, one row each.
pub fn events(run: &dyn Run, kind: EventKind) -> Vec<Vec<f64>> {
    let rows = run.event_rows(0);
    let is_meant = |event: &&[f64]| event[0] == f64::from(kind as u8);
    rows.chunks(EVENT_HEAD + run.dimension()).filter(is_meant).map(<[f64]>::to_vec).collect()
}

/// The pairs of vertices whose motions were tried: edges, and those that were refused.
pub fn tried(run: &dyn Run) -> Vec<[usize; 2]> {
    let refused = events(run, EventKind::EdgeRefused);
    edges(run).into_iter().chain(refused.iter().map(|event| [event[2] as usize, event[3] as usize])).collect()
}
