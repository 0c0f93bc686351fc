//! The shortest path of a disc, or of a point, among polygons, walls and discs: exact.
//!
//! The centre of a disc moves as a point among obstacles that are larger by its radius (Lozano-Perez and Wesley 1979, "An
//! algorithm for planning collision-free paths among polyhedral obstacles"). Their corners are arcs, so a shortest path consists
//! of lines tangent to two circles and of arcs between them (Chew 1985, "Planning the shortest path for a disc in O(n^2 log n)
//! time"; Liu and Arimoto 1992, "Path planning using a tangent graph for mobile robots among polygonal and curved obstacles").
//! The graph has two vertices for each end of a tangent, one for either direction in which its circle is passed, and is searched
//! by Dijkstra's algorithm.
//!
//! Rounding is that of `grown.rs`. O(n^2) tangents for n corners and discs, a query of the box tree each.

use super::circles::{Circle, Path, Tangent, Turn, along_arc, at, tangent, turn_left};
use super::grown::Grown;
use crate::error::{Code, Error};
use crate::geometry::{Disc, Point, Segment, sort_numbers};
use crate::graph::search::{BestFirst, Expansion, View, Walker};
use crate::graph::{Adjacency, VertexId};

/// Convex corners, points of walls and discs at most: every two of them are compared, which takes seconds.
const MOST: usize = 4000;

/// Free tangents at most: they and what is made of them take a quarter of a gigabyte.
const MOST_TANGENTS: usize = 2_000_000;

/// The largest turn of one chord of an arc in the path, in radians.
const CHORD: f64 = 0.05;

/// An end of a tangent on its circle.
struct End {
    circle: usize,
    angle: f64,
    point: Point,
}

/// The tangents and arcs that are free.
struct TangentGraph {
    circles: Vec<Circle>,
    /// How much larger than the true ones the radii are.
    larger: f64,
    ends: Vec<End>,
    edges: Vec<[VertexId; 2]>,
}

/// The circles of radius 0: start and goal, which one vertex each belongs to.
const START: usize = 0;
const GOAL: usize = 1;

impl TangentGraph {
    fn new(grown: &Grown, start: Point, goal: Point) -> Result<Self, Error> {
        let mut circles = vec![Circle::point(start), Circle::point(goal)];
        circles.extend(grown.circles());
        let count = circles.len() - 2;
        if count > MOST {
            let sentence = format!(
                "the obstacles have {count} convex corners, points of walls and discs; at most {MOST} are compared"
            );
            return Err(Error::new(Code::TooLarge, "", sentence));
        }
        let mut graph = Self { circles, larger: grown.larger, ends: Vec::new(), edges: Vec::new() };
        graph.add_tangents(grown)?;
        graph.add_arcs(grown);
        Ok(graph)
    }

    fn add_tangents(&mut self, grown: &Grown) -> Result<(), Error> {
        for a in 0..self.circles.len() {
            if self.ends.len() > 2 * MOST_TANGENTS {
                let sentence = format!("the obstacles have more than {MOST_TANGENTS} free tangents");
                return Err(Error::new(Code::TooLarge, "", sentence));
            }
            for b in a + 1..self.circles.len() {
                let pair = [&self.circles[a], &self.circles[b]];
                let turns = |circle: usize| &Turn::BOTH[..if circle <= GOAL { 1 } else { 2 }];
                for from in turns(a) {
                    for to in turns(b) {
                        let found = tangent(pair, [*from, *to]).filter(|found| grown.is_free(&found.segment));
                        if let Some(Tangent { segment, angles }) = found {
                            let first = self.ends.len();
                            self.ends.push(End { circle: a, angle: angles[0], point: segment.a });
                            self.ends.push(End { circle: b, angle: angles[1], point: segment.b });
                            let there = [self.vertex(first, *from), self.vertex(first + 1, *to)];
                            let back = [self.vertex(first + 1, to.reversed()), self.vertex(first, from.reversed())];
                            self.edges.extend([there, back]);
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// The arcs between neighbouring ends of tangents: a piece between two neighbouring angles at which it may become free or
    /// blocked is free if its middle is.
    fn add_arcs(&mut self, grown: &Grown) {
        let mut on_circle: Vec<Vec<usize>> = vec![Vec::new(); self.circles.len()];
        self.ends.iter().enumerate().for_each(|(end, at)| on_circle[at.circle].push(end));
        for (circle, ends) in on_circle.iter().enumerate().skip(GOAL + 1).filter(|(_, ends)| ends.len() > 1) {
            let circle = self.circles[circle];
            let mut stops: Vec<(f64, Option<usize>)> =
                ends.iter().map(|&end| (self.ends[end].angle, Some(end))).collect();
            stops.extend(grown.crossings(&circle.disc).into_iter().map(|angle| (angle, None)));
            let mut order: Vec<u32> = (0..stops.len() as u32).collect();
            let by_angle = |i: usize, j: usize| stops[i].0.total_cmp(&stops[j].0).then(stops[i].1.cmp(&stops[j].1));
            sort_numbers(&mut order, &|i, j| by_angle(i, j).then(i.cmp(&j)));
            let mut stops: Vec<_> = order.into_iter().map(|i| stops[i as usize]).collect();
            let first = stops.iter().position(|(_, end)| end.is_some()).expect("there are ends");
            stops.rotate_left(first);
            stops.push(stops[0]);
            let (mut last, mut is_free) = (stops[0].1, true);
            for pair in stops.windows(2) {
                let (from, to) = (pair[0].0, pair[1].0);
                let middle = circle.at(from + 0.5 * turn_left(from, to));
                is_free = is_free && grown.is_free(&Segment::new(middle, middle));
                if let Some(end) = pair[1].1 {
                    if let Some(before) = last.filter(|_| is_free) {
                        self.edges.push([self.vertex(before, Turn::Left), self.vertex(end, Turn::Left)]);
                        self.edges.push([self.vertex(end, Turn::Right), self.vertex(before, Turn::Right)]);
                    }
                    (last, is_free) = (Some(end), true);
                }
            }
        }
    }

    /// The vertex for passing the circle at the end of a tangent with a turn.
    fn vertex(&self, end: usize, turn: Turn) -> VertexId {
        let circle = self.ends[end].circle;
        VertexId(if circle <= GOAL { circle } else { 2 + 2 * end + usize::from(turn == Turn::Right) } as u32)
    }

    /// The end of a tangent and the turn that belong to a vertex; `None` of start and goal.
    fn place(&self, vertex: VertexId) -> Option<(&End, Turn)> {
        let number = vertex.index().checked_sub(2)?;
        Some((&self.ends[number / 2], Turn::BOTH[number % 2]))
    }

    fn point(&self, vertex: VertexId) -> Point {
        self.place(vertex).map_or_else(|| self.circles[vertex.index()].disc.center, |(end, _)| end.point)
    }

    /// The circle of the arc that joins two vertices, at its true radius, with the angles from one to the other; `None` if a
    /// tangent joins them.
    fn arc(&self, from: VertexId, to: VertexId) -> Option<(Disc, [f64; 2], Turn)> {
        let ((a, turn), (b, _)) = (self.place(from)?, self.place(to)?);
        let Disc { center, radius } = self.circles[a.circle].disc;
        (a.circle == b.circle).then_some((Disc { center, radius: radius - self.larger }, [a.angle, b.angle], turn))
    }

    fn cost(&self, from: VertexId, to: VertexId) -> f64 {
        match self.arc(from, to) {
            Some((circle, [a, b], Turn::Left)) => circle.radius * turn_left(a, b),
            Some((circle, [a, b], Turn::Right)) => circle.radius * turn_left(b, a),
            None => (self.point(to) - self.point(from)).norm(),
        }
    }

    /// The vertices of the shortest path from the start to the goal; empty if there is none.
    fn search(&self) -> Vec<VertexId> {
        let vertices = 2 + 2 * self.ends.len();
        let adjacency = Adjacency::new(vertices, &self.edges, &[], true);
        let view = View { adjacency: &adjacency, cost: &|a, b| self.cost(a, b), heuristic: &|_| 0.0 };
        let [start, goal] = [START, GOAL].map(|i| VertexId(i as u32));
        let mut search = BestFirst::new(vertices, start, goal..VertexId(goal.0 + 1));
        while let Expansion::Vertex(_) = search.step(&view) {}
        search.path()
    }

    /// The points of a path, arcs as chords of their true circles.
    fn points(&self, path: &[VertexId]) -> Vec<Point> {
        let mut points = vec![self.point(path[0])];
        for pair in path.windows(2) {
            match self.arc(pair[0], pair[1]) {
                Some((circle, [from, to], turn)) => {
                    points.pop();
                    points.extend(along_arc(from, to, turn, CHORD).map(|angle| at(&circle, angle)));
                }
                None => points.push(self.point(pair[1])),
            }
        }
        points.dedup();
        points
    }
}

/// The shortest path between two free positions: its length and its points, where arcs are replaced by chords of at most 0.05
/// radians. `None` if there is no path. O(n^2 log n) for n convex corners and discs.
///
/// # Errors
/// `too-large` for more than 4000 of them, or more than 2,000,000 free tangents.
pub(super) fn shortest(grown: &Grown, [start, goal]: [Point; 2]) -> Result<Option<Path>, Error> {
    if start == goal {
        return Ok(Some((0.0, vec![start])));
    }
    let graph = TangentGraph::new(grown, start, goal)?;
    let path = graph.search();
    if path.is_empty() {
        return Ok(None);
    }
    let length = path.windows(2).map(|pair| graph.cost(pair[0], pair[1])).sum();
    Ok(Some((length, graph.points(&path))))
}
