//! Safe interval path planning: the earliest arrival of one robot at its goal, along its roadmap, among others whose trajectories
//! are known.
//!
//! Phillips and Likhachev 2011, "SIPP: safe interval path planning for dynamic environments". A safe interval of a vertex is a
//! longest time during which a robot may stand there. A node of the search is a vertex with one of its safe intervals; of all
//! ways to reach it the earliest is kept, since who is there early may wait. Time is continuous: from a node the robot leaves at
//! the earliest time at which its motion along an edge is proven free of conflict with every motion of the others, and its stand
//! until then as well.

use super::motion::{Motion, Pose};
use super::traffic::{Pause, Proofs, Scene, Traffic};
use super::trajectory::Trajectory;
use crate::graph::Ordered;
use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};

/// How often the time of departure is halved in search of the earliest one: of two discs, and if one is a body, whose distances
/// cost more the closer they pass.
const HALVINGS: [u32; 2] = [30, 10];

/// The most motions of others that one departure waits for.
const MOST_WAITS: u32 = 256;

/// A vertex in one of its safe intervals, with the earliest arrival so far.
#[derive(Debug, Clone, Copy)]
struct Node {
    vertex: u32,
    until: f64,
    /// When the robot arrives, and when it has left the parent.
    time: f64,
    departure: f64,
    parent: u32,
}

/// No parent.
const ROOT: u32 = u32::MAX;

/// The result of one expansion.
pub(super) enum Expansion {
    /// The search goes on.
    Vertex,
    /// So does the expansion of the same vertex: it takes more than one iteration.
    Part,
    /// The robot can reach its goal, and stay there.
    Found(Trajectory),
    /// It cannot. The robots that are in the way of every way on, in order; `None` if there is no way on its roadmap even
    /// without the others.
    Nothing(Option<Vec<usize>>),
}

/// A node whose expansion has begun, and how far it has come.
#[derive(Debug, Clone, Copy)]
struct Begun {
    number: u32,
    /// Whether it is known that the robot cannot end here.
    is_no_end: bool,
    /// How many of the neighbours are done, and of the next one how many safe intervals.
    neighbours: usize,
    intervals: usize,
}

/// A safe interval of a vertex, and its node if it has one.
type SafeInterval = ([f64; 2], Option<u32>);

/// The search of one robot.
pub(super) struct Search {
    start: u32,
    goal: u32,
    /// Of every vertex the time to the goal without others.
    heuristic: Vec<f64>,
    nodes: Vec<Node>,
    /// Of every vertex that was looked at, its safe intervals.
    intervals: Vec<Option<Vec<SafeInterval>>>,
    /// Estimated arrival at the goal and node.
    open: BinaryHeap<Reverse<(Ordered, u32)>>,
    traffic: Traffic,
    /// Vertices, and the robots that were in the way to them.
    refused: BTreeSet<(u32, usize)>,
    /// Whether the start has been reached, if it can be.
    has_started: bool,
    begun: Option<Begun>,
    proofs: Proofs,
}

impl Search {
    /// The search of the scene's robot; `distances` has the length of the way from every vertex to its goal.
    pub fn new(scene: &Scene, distances: &[f64]) -> Self {
        let [start, goal] = scene.roadmap.ends(scene.robot);
        let heuristic: Vec<f64> = distances.iter().map(|distance| distance / scene.speed).collect();
        Self {
            start,
            goal,
            intervals: vec![None; heuristic.len()],
            heuristic,
            nodes: Vec::new(),
            open: BinaryHeap::new(),
            traffic: Traffic::new(scene),
            refused: BTreeSet::new(),
            has_started: false,
            begun: None,
            proofs: Proofs::default(),
        }
    }

    /// The safe intervals of a vertex.
    fn intervals(&mut self, scene: &Scene, vertex: u32) -> Result<&mut Vec<SafeInterval>, Pause> {
        let known = &mut self.intervals[vertex as usize];
        if known.is_none() {
            let safe = self.traffic.safe_intervals(scene, scene.roadmap.pose(vertex), &mut self.proofs)?;
            self.proofs.complete();
            *known = Some(safe.into_iter().map(|interval| (interval, None)).collect());
        }
        Ok(known.get_or_insert_default())
    }

    /// Reaches a vertex in its safe interval of this number, if that is earlier than before.
    fn reach(&mut self, (vertex, number, [_, until]): (u32, usize, [f64; 2]), time: f64, departure: f64, parent: u32) {
        let estimate = time + self.heuristic[vertex as usize];
        if estimate == f64::INFINITY {
            return;
        }
        let reached = Node { vertex, until, time, departure, parent };
        let known = self.intervals[vertex as usize].as_mut().expect("an interval of known ones is reached");
        let node = match known[number].1 {
            Some(node) if self.nodes[node as usize].time <= time => return,
            Some(node) => {
                self.nodes[node as usize] = reached;
                node
            }
            None => {
                self.nodes.push(reached);
                let node = self.nodes.len() as u32 - 1;
                known[number].1 = Some(node);
                node
            }
        };
        self.open.push(Reverse((Ordered::new(estimate), node)));
    }

    /// Expands one node, or a part of it.
    pub fn step(&mut self, scene: &Scene, checks: &mut u64) -> Expansion {
        self.proofs.begin();
        let expansion = self.expand(scene).unwrap_or(Expansion::Part);
        *checks += std::mem::take(&mut self.proofs.checks);
        expansion
    }

    fn expand(&mut self, scene: &Scene) -> Result<Expansion, Pause> {
        if !self.has_started {
            let start = self.start;
            let first = self.intervals(scene, start)?.first().map(|(interval, _)| *interval);
            if let Some(interval) = first.filter(|[begin, _]| *begin == 0.0) {
                self.reach((start, 0, interval), 0.0, 0.0, ROOT);
            }
            self.has_started = true;
        }
        let mut begun = match self.begun {
            Some(begun) => begun,
            None => match self.next() {
                Some(number) => Begun { number, is_no_end: false, neighbours: 0, intervals: 0 },
                None => return Ok(Expansion::Nothing(self.in_the_way(scene)?)),
            },
        };
        self.begun = Some(begun);
        let number = begun.number;
        let node = self.nodes[number as usize];
        let at = scene.roadmap.pose(node.vertex);
        if node.vertex == self.goal && node.until == f64::INFINITY && !begun.is_no_end {
            let stand = Motion::standing([node.time, f64::INFINITY], at);
            match self.traffic.first_in_conflict(scene, &stand, &mut self.proofs)? {
                None => return Ok(Expansion::Found(self.trajectory(scene, number))),
                Some((other, _)) => self.refused.insert((self.goal, other)),
            };
            begun.is_no_end = true;
            self.completed(begun);
        }
        for &(next, way) in &scene.roadmap.neighbours(node.vertex)[begun.neighbours..] {
            let duration = way / scene.speed;
            let count = self.intervals(scene, next)?.len();
            for i in begun.intervals..count {
                let (interval, known) = self.intervals(scene, next)?[i];
                let earliest = node.time.max(interval[0] - duration);
                let latest = node.until.min(interval[1] - duration);
                let is_known = |known: u32| self.nodes[known as usize].time <= earliest + duration;
                if earliest > latest || known.is_some_and(is_known) {
                    continue;
                }
                let leave = Leave { at, to: scene.roadmap.pose(next), arrived: node.time, duration };
                match leave.first_time(scene, &self.traffic, [earliest, latest], &mut self.proofs)? {
                    Ok(departure) => self.reach((next, i, interval), departure + duration, departure, number),
                    Err(other) => {
                        self.refused.insert((next, other));
                    }
                }
                begun.intervals = i + 1;
                self.completed(begun);
            }
            // Without safe intervals, others stand there forever.
            if count == 0 {
                let stand = Motion::standing([0.0, f64::INFINITY], scene.roadmap.pose(next));
                if let Some((other, _)) = self.traffic.first_in_conflict(scene, &stand, &mut self.proofs)? {
                    self.refused.insert((next, other));
                }
            }
            (begun.neighbours, begun.intervals) = (begun.neighbours + 1, 0);
            self.completed(begun);
        }
        self.begun = None;
        Ok(Expansion::Vertex)
    }

    /// A part of an expansion is complete, which has now come that far.
    fn completed(&mut self, begun: Begun) {
        self.begun = Some(begun);
        self.proofs.complete();
    }

    /// The open node of the least estimate.
    fn next(&mut self) -> Option<u32> {
        // Entries that an earlier arrival has made stale are skipped.
        while let Some(Reverse((estimate, number))) = self.open.pop() {
            let node = self.nodes[number as usize];
            if node.time + self.heuristic[node.vertex as usize] == estimate.value() {
                return Some(number);
            }
        }
        None
    }

    /// Who is in the way to the vertices that were not reached, or over the goal later, or at the start already; `None` if the
    /// roadmap has no way.
    fn in_the_way(&mut self, scene: &Scene) -> Result<Option<Vec<usize>>, Pause> {
        if self.heuristic[self.start as usize] == f64::INFINITY {
            return Ok(None);
        }
        if self.nodes.is_empty() {
            let at = scene.roadmap.pose(self.start);
            return Ok(Some(self.traffic.in_conflict(scene, at, &mut self.proofs)?.into_iter().collect()));
        }
        let reached: BTreeSet<u32> = self.nodes.iter().map(|node| node.vertex).collect();
        let is_reached = |vertex: u32| reached.contains(&vertex);
        let mut others: BTreeSet<usize> =
            self.refused.iter().filter(|(vertex, _)| !is_reached(*vertex)).map(|(_, other)| *other).collect();
        if is_reached(self.goal) || others.is_empty() {
            let goal = scene.roadmap.pose(self.goal);
            others.append(&mut self.traffic.in_conflict(scene, goal, &mut self.proofs)?);
        }
        if others.is_empty() {
            others.extend(self.refused.iter().map(|(_, other)| *other));
        }
        Ok(Some(others.into_iter().collect()))
    }

    /// The trajectory to a node: along the edges, with the stands before them.
    fn trajectory(&self, scene: &Scene, last: u32) -> Trajectory {
        let mut nodes = vec![last];
        while let parent = self.nodes[nodes[nodes.len() - 1] as usize].parent
            && parent != ROOT
        {
            nodes.push(parent);
        }
        let mut trajectory = Trajectory::standing(scene.roadmap.pose(self.start));
        for pair in nodes.windows(2).rev() {
            let [to, from] = [pair[0], pair[1]].map(|node| self.nodes[node as usize]);
            if to.departure > from.time {
                trajectory.add(to.departure, scene.roadmap.pose(from.vertex));
            }
            trajectory.add(to.time, scene.roadmap.pose(to.vertex));
        }
        trajectory
    }
}

/// A robot that is to leave a pose for another.
struct Leave {
    at: Pose,
    to: Pose,
    /// When it has arrived at the first pose.
    arrived: f64,
    duration: f64,
}

impl Leave {
    fn motion(&self, departure: f64) -> Motion {
        Motion::new([departure, departure + self.duration], self.at, self.to)
    }

    /// The earliest departure between two times with which stand and motion are proven free of conflict; if there is none, the
    /// robot that is in the way.
    fn first_time(
        &self,
        scene: &Scene,
        traffic: &Traffic,
        [earliest, latest]: [f64; 2],
        proofs: &mut Proofs,
    ) -> Result<Result<f64, usize>, Pause> {
        let (mut departure, mut in_the_way) = (earliest, None);
        for _ in 0..MOST_WAITS {
            let Some((other, motion)) = traffic.first_in_conflict(scene, &self.motion(departure), proofs)? else {
                let stand = Motion::standing([self.arrived, departure], self.at);
                return Ok(match traffic.first_in_conflict(scene, &stand, proofs)? {
                    Some((other, _)) if departure > self.arrived => Err(other),
                    _ => Ok(departure),
                });
            };
            in_the_way = Some(other);
            let mut is_past =
                |departure: f64| proofs.is_apart(&scene.pair(other, [&motion, &self.motion(departure)]), true);
            // Departures that conflict with one motion of a disc are an interval, so all after the first that does not are free
            // of it.
            let (mut early, mut late) = (departure, latest.min(motion.end.next_up()));
            if late <= early || late == f64::INFINITY || !is_past(late)? {
                return Ok(Err(other));
            }
            let has_body = [other, scene.robot].iter().any(|&robot| scene.footprints[robot].is_body());
            for _ in 0..HALVINGS[usize::from(has_body)] {
                let middle = 0.5 * (early + late);
                if is_past(middle)? {
                    late = middle;
                } else {
                    early = middle;
                }
            }
            departure = late;
        }
        Ok(Err(in_the_way.unwrap_or(scene.robot)))
    }
}
