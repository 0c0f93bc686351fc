//! The path of a course report that is read from overwritten parents, to show how often it misses the start.
//!
//! While the roadmap is built, each edge makes its earlier end the parent of its later one; the start is the first of all and the
//! goals are the last. A vertex with several edges keeps the last of them. The path leads from a goal from parent to parent, and
//! ends at the start only if all of these choices happen to lead there.

use super::{Expansion, Goals, View, Walker};
use crate::graph::VertexId;

/// A walk from the last goal that has a parent towards the start: costs and heuristic are ignored. O(v + e).
#[derive(Debug, Clone)]
pub struct Parents {
    start: VertexId,
    parents: Vec<Option<VertexId>>,
    /// From a goal to where the walk is.
    walked: Vec<VertexId>,
    is_there: bool,
}

impl Parents {
    /// The walk over a roadmap of `vertices` vertices, whose edges are given in the order in which they were added.
    pub fn new<'a>(
        vertices: usize,
        edges: impl Iterator<Item = &'a [VertexId; 2]>,
        start: VertexId,
        goals: Goals,
    ) -> Self {
        // The start comes before all, the goals after all.
        let order =
            |v: VertexId| if v == start { 0 } else { u64::from(v.0) + if goals.contains(&v) { 1 << 32 } else { 1 } };
        let mut parents = vec![None; vertices];
        for &[a, b] in edges {
            let [parent, child] = if order(a) < order(b) { [a, b] } else { [b, a] };
            parents[child.index()] = Some(parent);
        }
        let has_parent = |goal: &VertexId| parents[goal.index()].is_some();
        let from = (goals.start.0..goals.end.0).map(VertexId).rfind(has_parent).unwrap_or(goals.start);
        Self { start, parents, walked: vec![from], is_there: false }
    }
}

impl Walker for Parents {
    fn step(&mut self, _: &View) -> Expansion {
        // An earlier vertex is the parent of a later one, so the walk ends.
        let at = self.walked[self.walked.len() - 1];
        if at == self.start {
            self.is_there = true;
            return Expansion::Goal;
        }
        match self.parents[at.index()] {
            Some(parent) => {
                self.walked.push(parent);
                Expansion::Vertex(at)
            }
            None => Expansion::Nothing,
        }
    }

    fn path(&self) -> Vec<VertexId> {
        if self.is_there { self.walked.iter().rev().copied().collect() } else { Vec::new() }
    }

    fn is_exhaustive(&self) -> bool {
        false
    }
}
