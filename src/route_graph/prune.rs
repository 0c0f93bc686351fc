//! Nodes that a route graph does not need are removed: what they see is seen by others, and without them no way is too long.

use super::cover::Cover;
use super::dense::shortest_ways;
use super::spanner::Spanner;
use crate::geometry::sort_stably;

/// What a way through a node may differ from the way that it is part of, relative to it.
const SAME: f64 = 1e-9;

/// The nodes that are left, in their order. Neighbours of a removed node are joined by straight edges that are proven free, where
/// the way between them would be too long. Nodes with few edges are tried first. In passes until none is removed; a trial takes
/// O(nodes e log nodes) for e edges, and most end with the first ways.
pub(super) fn prune(spanner: &mut Spanner, cover: &mut Cover) -> Vec<u32> {
    let count = spanner.nodes.len();
    let mut is_left = vec![true; count];
    loop {
        let mut order: Vec<u32> = (0..count as u32).filter(|&node| is_left[node as usize]).collect();
        let degree = |node: &u32| spanner.neighbours[*node as usize].len();
        sort_stably(&mut order, |a, b| degree(a).cmp(&degree(b)));
        let mut removed = false;
        for node in order {
            if cover.is_needless(node as usize) && try_without(spanner, &mut is_left, node) {
                cover.remove(node as usize);
                removed = true;
            }
        }
        if !removed {
            return (0..count as u32).filter(|&node| is_left[node as usize]).collect();
        }
    }
}

/// Removes a node if every way that led through it has another that is short enough; else nothing changes.
fn try_without(spanner: &mut Spanner, is_left: &mut [bool], node: u32) -> bool {
    let before = spanner.neighbours.clone();
    let edges = std::mem::take(&mut spanner.neighbours[node as usize]);
    for &(neighbour, _) in &edges {
        spanner.neighbours[neighbour as usize].retain(|(other, _)| *other != node);
    }
    is_left[node as usize] = false;
    let added = join(spanner, is_left, &edges);
    let rows = added.as_ref().and_then(|_| rows_without(spanner, is_left, node, &edges));
    let (Some(added), Some(rows)) = (added, rows) else {
        spanner.neighbours = before;
        is_left[node as usize] = true;
        return false;
    };
    for (from, row) in rows {
        spanner.ways[from as usize] = row;
    }
    for [a, b] in added {
        let length = spanner.straight(a, b);
        let (a, b) = (a as usize, b as usize);
        spanner.distances[a][b] = spanner.distances[a][b].min(length);
        spanner.distances[b][a] = spanner.distances[a][b];
        spanner.shorten(a, b, length);
    }
    true
}

/// Joins the neighbours of a node that was removed where the way between two of them is too long; the edges that were added.
/// `None` if two of them cannot be joined.
fn join(spanner: &mut Spanner, is_left: &[bool], edges: &[(u32, f64)]) -> Option<Vec<[u32; 2]>> {
    let mut added = Vec::new();
    for (i, &(a, _)) in edges.iter().enumerate() {
        let mut ways = shortest_ways(&spanner.neighbours, a, None).lengths;
        for &(b, _) in &edges[i + 1..] {
            debug_assert!(is_left[a as usize] && is_left[b as usize], "edges lead to nodes that are left");
            if ways[b as usize] <= spanner.longest(spanner.distances[a as usize][b as usize]) {
                continue;
            }
            if !spanner.is_free(a, b) {
                return None;
            }
            let length = spanner.straight(a, b);
            spanner.neighbours[a as usize].push((b, length));
            spanner.neighbours[b as usize].push((a, length));
            added.push([a, b]);
            ways = shortest_ways(&spanner.neighbours, a, None).lengths;
        }
    }
    Some(added)
}

/// The lengths of the ways from all nodes that had one through a removed node; `None` if one is too long now.
fn rows_without(spanner: &Spanner, is_left: &[bool], node: u32, edges: &[(u32, f64)]) -> Option<Vec<(u32, Vec<f64>)>> {
    let through = &spanner.ways[node as usize];
    let led_through = |from: usize| {
        let pairs = spanner.ways[from].iter().zip(through).zip(is_left);
        pairs.filter(|(_, left)| **left).any(|((way, rest), _)| {
            *way < f64::INFINITY && spanner.ways[from][node as usize] + rest <= way * (1.0 + SAME)
        })
    };
    // The neighbours first: where a way is too long, one of theirs mostly is.
    let first = edges.iter().map(|(neighbour, _)| *neighbour);
    let others = (0..is_left.len() as u32).filter(|other| !edges.iter().any(|(neighbour, _)| neighbour == other));
    let mut rows = Vec::new();
    for from in first.chain(others).filter(|&from| is_left[from as usize]) {
        if !led_through(from as usize) {
            continue;
        }
        let row = shortest_ways(&spanner.neighbours, from, None).lengths;
        let distances = &spanner.distances[from as usize];
        let is_short = |(to, way): (usize, &f64)| !is_left[to] || *way <= spanner.longest(distances[to]);
        if !row.iter().enumerate().all(is_short) {
            return None;
        }
        rows.push((from, row));
    }
    Some(rows)
}
