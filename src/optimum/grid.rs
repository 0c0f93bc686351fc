//! A short path in a plane of two coordinates, as a reference where the shortest path is not known: the shortest on a grid over
//! the circles or intervals, whose motions to all eight neighbours are proven free. It is made shorter by shortcuts, and by grids
//! of ever closer lines around its corners: where the metric is a sum, a shortest path keeps to the lines through the points that
//! it touches.

use crate::geometry::sort_stably;
use crate::graph::search::{BestFirst, Expansion, View, Walker};
use crate::graph::{Adjacency, VertexId};
use crate::path::{Improvement, Wanted, length};
use crate::problem::Problem;
use crate::space::{MotionSpace, Space};

/// Lines of the grid across each coordinate, besides the lines of start and goal.
const LINES: usize = 360;

/// Grids around the corners of the path, each with lines closer by this factor than those before, and this number on either side.
const REFINEMENTS: u64 = 5;
const CLOSER: f64 = 4.0;
const BESIDE: i32 = 4;

/// The improvement of each path: vertices that shortcuts leave, but the path does not need, are removed at the end.
const IMPROVEMENT: [Wanted; 2] = [
    Wanted { reduce: true, shortcuts: 400, partial_shortcuts: 400, blend: 0.0 },
    Wanted { reduce: true, shortcuts: 0, partial_shortcuts: 0, blend: 0.0 },
];

/// The grid: all states whose first two coordinates are lines, with the others of the start.
struct Grid<const N: usize> {
    lines: [Vec<f64>; 2],
    wraps: [bool; 2],
    rest: [f64; N],
}

impl<const N: usize> Grid<N> {
    /// The grid of evenly spaced lines.
    fn everywhere(problem: &Problem<MotionSpace<N>>) -> Self {
        Self::new(problem, |i| {
            let [low, high] = problem.space().product().range(i);
            // The ends of a circle are one line.
            let lines = usize::from(problem.space().product().is_circle(i))..=LINES;
            lines.map(|line| low + (high - low) * (line as f64 / LINES as f64)).collect()
        })
    }

    /// The grid of lines on both sides of the vertices of a path.
    fn around(problem: &Problem<MotionSpace<N>>, path: &[[f64; N]], spacing: [f64; 2]) -> Self {
        Self::new(problem, |i| {
            let [low, high] = problem.space().product().range(i);
            let beside = |state: &[f64; N], line: i32| {
                let mut moved = *state;
                moved[i] += f64::from(line) * spacing[i];
                problem.space().state(&moved)[i]
            };
            let lines = path.iter().flat_map(|state| (-BESIDE..=BESIDE).map(move |line| beside(state, line)));
            let mut lines: Vec<f64> = lines.filter(|line| (low..=high).contains(line)).collect();
            sort_stably(&mut lines, f64::total_cmp);
            lines.dedup_by(|next, line| *next - *line < 0.5 * spacing[i]);
            lines
        })
    }

    /// The grid of these lines and those of start and goal.
    fn new(problem: &Problem<MotionSpace<N>>, lines: impl Fn(usize) -> Vec<f64>) -> Self {
        let (start, goal) = (*problem.start(), *problem.goal());
        let lines = [0, 1].map(|i| {
            let mut lines = lines(i);
            lines.extend([start[i], goal[i]]);
            sort_stably(&mut lines, f64::total_cmp);
            lines.dedup();
            lines
        });
        Self { lines, wraps: [0, 1].map(|i| problem.space().product().is_circle(i)), rest: start }
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

/// The shortest path from start to goal on the grid; empty if there is none. O(grid log grid), and eight proofs a vertex at most.
fn search<const N: usize>(problem: &Problem<MotionSpace<N>>, grid: &Grid<N>) -> Vec<[f64; N]> {
    let (space, validity) = (problem.space(), problem.validity());
    let adjacency = Adjacency::new(grid.len(), &grid.edges(), &[], false);
    let cost = |a: VertexId, b: VertexId| {
        // In one direction, so that both have the same answer.
        let (a, b) = (grid.state(a.min(b)), grid.state(a.max(b)));
        if validity.is_motion_free(&a, &b) { space.distance(&a, &b) } else { f64::INFINITY }
    };
    let heuristic = |vertex| space.distance(&grid.state(vertex), problem.goal());
    let view = View { adjacency: &adjacency, cost: &cost, heuristic: &heuristic };
    let [start, goal] = [problem.start(), problem.goal()].map(|state| grid.at(state));
    let mut search = BestFirst::new(grid.len(), start, goal..VertexId(goal.0 + 1));
    while let Expansion::Vertex(_) = search.step(&view) {}
    search.path().into_iter().map(|vertex| grid.state(vertex)).collect()
}

/// A short proven path from the start of the problem to its goal, which differ in their first two coordinates alone; `None` if
/// the grid has none.
pub(super) fn reference<const N: usize>(problem: &Problem<MotionSpace<N>>) -> Option<Vec<[f64; N]>> {
    let space = problem.space();
    let improved = |path: Vec<[f64; N]>, seed| {
        IMPROVEMENT.into_iter().fold(path, |path, wanted| {
            let mut improvement = Improvement::<MotionSpace<N>>::new(path, wanted, seed);
            while !improvement.is_done() {
                improvement.attempt(problem);
            }
            improvement.path().to_vec()
        })
    };
    let path = search(problem, &Grid::everywhere(problem));
    if path.is_empty() {
        return None;
    }
    let (mut path, mut spacing) = (improved(path, 0), [0, 1].map(|i| resolution(space, i)));
    for round in 1..=REFINEMENTS {
        // A path along the curved border of an obstacle may have many corners: no grid is larger than the first.
        if path.len() * (2 * BESIDE as usize + 1) > LINES {
            break;
        }
        spacing = spacing.map(|distance| distance / CLOSER);
        let finer = search(problem, &Grid::around(problem, &path, spacing));
        if !finer.is_empty() && length(space, &finer) < length(space, &path) {
            path = finer;
        }
        path = improved(path, round);
    }
    Some(path)
}
