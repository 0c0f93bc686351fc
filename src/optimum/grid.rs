//! A short path in a plane of two coordinates, as a reference where the shortest path is not known: the shortest on a grid over the
//! circles or intervals, whose motions to all eight neighbours are proven free, and then made shorter by reductions and shortcuts until
//! they change no more.

use crate::graph::search::{BestFirst, Expansion, View, Walker};
use crate::graph::{Adjacency, VertexId};
use crate::path::{Improvement, Wanted, length};
use crate::problem::Problem;
use crate::space::{MotionSpace, Space};

/// Lines of the grid across each coordinate, besides those of start and goal.
const LINES: usize = 360;

/// One round of improvement, and the gain below which it is the last.
const ROUND: Wanted = Wanted { reduce: true, shortcuts: 500, partial_shortcuts: 500, blend: 0.0 };
const GAIN: f64 = 1e-6;

/// Rounds at most.
const ROUNDS: u64 = 20;

/// The grid: all states whose first two coordinates are lines, with the others of the start.
struct Grid<const N: usize> {
    lines: [Vec<f64>; 2],
    wraps: [bool; 2],
    rest: [f64; N],
}

impl<const N: usize> Grid<N> {
    fn new(space: &MotionSpace<N>, start: &[f64; N], goal: &[f64; N]) -> Self {
        let wraps = [0, 1].map(|i| space.product().is_circle(i));
        let lines = [0, 1].map(|i| {
            let [low, high] = space.product().range(i);
            // The ends of a circle are one line.
            let lines = usize::from(wraps[i])..=LINES;
            let mut lines: Vec<f64> = lines.map(|line| low + (high - low) * (line as f64 / LINES as f64)).collect();
            lines.extend([start[i], goal[i]]);
            lines.sort_unstable_by(f64::total_cmp);
            lines.dedup();
            lines
        });
        Self { lines, wraps, rest: *start }
    }

    fn len(&self) -> usize {
        self.lines[0].len() * self.lines[1].len()
    }

    fn vertex(&self, [across, up]: [usize; 2]) -> VertexId {
        VertexId((up * self.lines[0].len() + across) as u32)
    }

    fn state(&self, vertex: VertexId) -> [f64; N] {
        let (up, across) = (vertex.index() / self.lines[0].len(), vertex.index() % self.lines[0].len());
        let mut state = self.rest;
        (state[0], state[1]) = (self.lines[0][across], self.lines[1][up]);
        state
    }

    /// The vertex of a state that lies on two lines.
    fn at(&self, state: &[f64; N]) -> VertexId {
        let line = |i: usize| self.lines[i].partition_point(|line| *line < state[i]);
        self.vertex([line(0), line(1)])
    }

    /// The next line after one, if there is one.
    fn next(&self, axis: usize, line: usize) -> Option<usize> {
        let count = self.lines[axis].len();
        if line + 1 < count { Some(line + 1) } else { self.wraps[axis].then_some(0) }
    }

    /// All pairs of neighbours.
    fn edges(&self) -> Vec<[VertexId; 2]> {
        let mut edges = Vec::with_capacity(4 * self.len());
        for up in 0..self.lines[1].len() {
            for across in 0..self.lines[0].len() {
                let here = self.vertex([across, up]);
                let (right, above) = (self.next(0, across), self.next(1, up));
                edges.extend(right.map(|right| [here, self.vertex([right, up])]));
                edges.extend(above.map(|above| [here, self.vertex([across, above])]));
                if let (Some(right), Some(above)) = (right, above) {
                    edges.push([here, self.vertex([right, above])]);
                    edges.push([self.vertex([right, up]), self.vertex([across, above])]);
                }
            }
        }
        edges
    }
}

/// The distance between neighbouring lines of the grid across a coordinate.
pub(super) fn resolution<const N: usize>(space: &MotionSpace<N>, coordinate: usize) -> f64 {
    let [low, high] = space.product().range(coordinate);
    (high - low) / LINES as f64
}

/// A short proven path from the start of the problem to its goal, which differ in their first two coordinates alone; `None` if the grid has
/// none. O(grid log grid), and four proofs a vertex at most.
pub(super) fn reference<const N: usize>(problem: &Problem<MotionSpace<N>>) -> Option<Vec<[f64; N]>> {
    let (space, validity) = (problem.space(), problem.validity());
    let (start, goal) = (*problem.start(), *problem.goal());
    let grid = Grid::new(space, &start, &goal);
    let adjacency = Adjacency::new(grid.len(), &grid.edges(), &[], false);
    let cost = |a: VertexId, b: VertexId| {
        // In one direction, so that both have the same answer.
        let (a, b) = (grid.state(a.min(b)), grid.state(a.max(b)));
        if validity.is_motion_free(&a, &b) { space.distance(&a, &b) } else { f64::INFINITY }
    };
    let heuristic = |vertex| space.distance(&grid.state(vertex), &goal);
    let view = View { adjacency: &adjacency, cost: &cost, heuristic: &heuristic };
    let end = grid.at(&goal);
    let mut search = BestFirst::new(grid.len(), grid.at(&start), end..VertexId(end.0 + 1));
    while let Expansion::Vertex(_) = search.step(&view) {}
    let mut path: Vec<[f64; N]> = search.path().into_iter().map(|vertex| grid.state(vertex)).collect();
    if path.is_empty() {
        return None;
    }
    for round in 0..ROUNDS {
        let before = length(space, &path);
        let mut improvement = Improvement::<MotionSpace<N>>::new(path, ROUND, round);
        while !improvement.is_done() {
            improvement.attempt(problem);
        }
        path = improvement.path().to_vec();
        if length(space, &path) > (1.0 - GAIN) * before {
            break;
        }
    }
    Some(path)
}
