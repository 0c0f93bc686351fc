//! The subdivision of the square of configurations, cell by cell.

use super::Verdict;
use super::bounds::{Bounds, Clearances};
use super::cell::{Cell, DEEPEST};
use crate::error::{Code, Error, Number};
use crate::problem::{Problem, Status, Stepped};
use crate::space::{MotionSpace, Space};
use crate::world::{Configurations, PlanningWorld};
use std::collections::VecDeque;

/// The most cells that a subdivision may have.
pub const MAX_CELLS: usize = 1_000_000;

/// The number of cells by default.
pub const DEFAULT_CELLS: usize = 50_000;

/// The query and the clearance that a subdivision decides about.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The name of the query; by default the first of the scenario.
    pub query: Option<String>,
    /// The clearance that paths have to exceed, in metres, at least 0; 0 by default.
    pub clearance: f64,
    /// The number of cells after which the subdivision ends, 1 to [`MAX_CELLS`]; [`DEFAULT_CELLS`] by default.
    pub cells: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self { query: None, clearance: 0.0, cells: DEFAULT_CELLS }
    }
}

/// What is known about the clearance over a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Not enough.
    Mixed,
    /// It is greater than that of the question everywhere, and the robot within the bounds of the world.
    Free,
    /// It is nowhere greater, or the robot outside the bounds of the world.
    Blocked,
}

/// A cell of the quadtree.
pub(super) struct Node {
    pub cell: Cell,
    kind: Kind,
    /// The clearance is nowhere greater, in metres.
    pub most: f64,
    /// The index of the first of its quarters, which follow each other; 0 if it is not divided.
    quarters: u32,
    /// The cells that it touches, of those that are not divided.
    pub touching: Vec<u32>,
}

/// A subdivision in progress. It is deterministic, however its steps are divided.
pub struct Subdivision {
    pub(super) scenario: String,
    pub(super) query: String,
    pub(super) clearance: f64,
    pub(super) clearances: Clearances,
    most_cells: usize,
    /// All cells, divided ones too, in the order of their creation: quarters come after the whole.
    pub(super) nodes: Vec<Node>,
    /// Start and goal, and the cells that contain them.
    ends: [[f64; 2]; 2],
    pub(super) end_cells: [u32; 2],
    /// The mixed cells of the last channels that are still to be divided, the next one last.
    channel: Vec<u32>,
    verdict: Option<Verdict>,
    divisions: u64,
}

impl Subdivision {
    /// Starts with the whole square of configurations.
    ///
    /// # Errors
    /// `unsupported` for a robot without two coordinates, and for a query with a target; `unknown-query`; `out-of-range` and
    /// `not-finite` for the clearance, `out-of-range` for the number of cells; `start-in-collision`, `goal-in-collision`.
    pub fn new(scenario: impl Into<PlanningWorld>, options: &Options) -> Result<Self, Error> {
        let world = scenario.into();
        let clearances = Clearances::new(&world)?;
        let (_, query) = world.scenario().find_query(options.query.as_deref())?;
        let Some(goal) = query.configuration() else {
            let sentence = "certificates are for a query with one goal, not for one with a target";
            return Err(Error::new(Code::Unsupported, "/query", sentence));
        };
        let &Options { clearance, cells, .. } = options;
        if clearance.is_nan() || !(0.0..f64::INFINITY).contains(&clearance) {
            let code = if clearance.is_finite() { Code::OutOfRange } else { Code::NotFinite };
            let sentence = format!("a clearance is a finite number, at least 0, not {}", Number(clearance));
            return Err(Error::new(code, "/clearance", sentence));
        }
        if !(1..=MAX_CELLS).contains(&cells) {
            let sentence = format!("a subdivision has 1 to {MAX_CELLS} cells, not {cells}");
            return Err(Error::new(Code::OutOfRange, "/cells", sentence));
        }
        let space = MotionSpace::new(Configurations::of(&world).space().clone());
        let [start, goal] = [&query.start[..], goal].map(|q| space.state(q));
        // The tolerance is that of motions; it does not matter for start and goal.
        let validity = world.checker(&space, 1.0).validity();
        Problem::new(space, validity, start, goal)?;
        let mut subdivision = Self {
            scenario: world.scenario().name().to_owned(),
            query: query.name.clone(),
            clearance,
            clearances,
            most_cells: cells,
            nodes: Vec::new(),
            ends: [start, goal].map(|q| [q[0], q[1]]),
            end_cells: [0; 2],
            channel: Vec::new(),
            verdict: None,
            divisions: 0,
        };
        subdivision.add(Cell::WHOLE);
        Ok(subdivision)
    }

    /// The verdict; `None` before the end.
    pub fn verdict(&self) -> Option<Verdict> {
        self.verdict
    }

    /// The number of cells, divided ones too.
    pub fn cell_count(&self) -> usize {
        self.nodes.len()
    }

    /// The cells from number `from` on, in the order of their creation: the centre, half the side along each coordinate, and what
    /// is known about the cell. Those of a quarter replace those of the whole.
    pub fn cells_since(&self, from: usize) -> impl ExactSizeIterator<Item = ([[f64; 2]; 2], Kind)> {
        let nodes = self.nodes.get(from..).unwrap_or_default();
        nodes.iter().map(|node| (self.clearances.square.place(&node.cell), node.kind))
    }

    /// Adds a cell, with bounds on its clearance.
    fn add(&mut self, cell: Cell) {
        let Bounds { least, most, .. } = self.clearances.over(&cell, self.clearance);
        // What is nearer than the slack touches.
        let most = most - self.clearances.eta;
        let kind = if most <= self.clearance {
            Kind::Blocked
        } else if least > self.clearance + self.clearances.eta {
            Kind::Free
        } else {
            Kind::Mixed
        };
        self.nodes.push(Node { cell, kind, most, quarters: 0, touching: Vec::new() });
    }

    /// Replaces a cell by its quarters.
    fn divide(&mut self, number: u32) {
        self.divisions += 1;
        let quarters = self.nodes.len() as u32..self.nodes.len() as u32 + 4;
        let cell = self.nodes[number as usize].cell;
        cell.quarters().into_iter().for_each(|quarter| self.add(quarter));
        self.nodes[number as usize].quarters = quarters.start;
        let touching = std::mem::take(&mut self.nodes[number as usize].touching);
        for quarter in quarters.clone() {
            let siblings = quarters.clone().filter(|&other| other != quarter);
            self.nodes[quarter as usize].touching.extend(siblings);
        }
        for other in touching {
            self.nodes[other as usize].touching.retain(|&cell| cell != number);
            for quarter in quarters.clone() {
                let wraps = self.clearances.square.wraps;
                if self.nodes[quarter as usize].cell.touches(&self.nodes[other as usize].cell, wraps) {
                    self.nodes[other as usize].touching.push(quarter);
                    self.nodes[quarter as usize].touching.push(other);
                }
            }
        }
        for (end, at) in self.ends.iter().zip(&mut self.end_cells) {
            if *at == number {
                *at = quarters.start + self.clearances.square.quarter(&cell, end) as u32;
            }
        }
    }

    /// Finds the channels with the fewest mixed cells: all of these are divided next; once those are the smallest cells, those
    /// of all other channels. If there is no channel, or one without mixed cells, that is the verdict.
    fn search(&mut self) {
        if self.verdict.is_some() {
            return;
        }
        let [start, goal] = self.end_cells;
        let (from_start, _) = self.counts(start);
        let fewest = from_start[goal as usize];
        if fewest == u32::MAX || fewest == 0 {
            self.verdict = Some(if fewest == 0 { Verdict::Connected } else { Verdict::Infeasible });
            return;
        }
        let (from_goal, _) = self.counts(goal);
        // The cell itself counts in both directions.
        let length = |i: usize| u64::from(from_start[i]) + u64::from(from_goal[i]);
        let is_divisible = |node: &Node| node.kind == Kind::Mixed && node.cell.depth < DEEPEST;
        let divisible = |most: u64| -> Vec<u32> {
            let all = (0..self.cell_count()).rev();
            all.filter(|&i| is_divisible(&self.nodes[i]) && length(i) <= most).map(|i| i as u32).collect()
        };
        let mut channel = divisible(u64::from(fewest) + 1);
        if channel.is_empty() {
            // The smallest cells are left there. Others still make the proven clearance smaller.
            channel = divisible(u64::from(u32::MAX) - 1);
        }
        if channel.is_empty() {
            self.verdict = Some(Verdict::Unknown);
        }
        self.channel = channel;
    }

    /// For each cell the fewest mixed cells from one to it, both counted, on a way through cells that touch, none of them
    /// blocked; and the cell before it on that way. The greatest number if there is no way. Breadth-first, free cells before
    /// mixed ones.
    pub(super) fn counts(&self, from: u32) -> (Vec<u32>, Vec<u32>) {
        let cost = |cell: u32| match self.nodes[cell as usize].kind {
            Kind::Free => Some(0),
            Kind::Mixed => Some(1),
            Kind::Blocked => None,
        };
        let mut counts = vec![u32::MAX; self.cell_count()];
        let mut before = vec![from; self.cell_count()];
        let Some(first) = cost(from) else { return (counts, before) };
        counts[from as usize] = first;
        let mut open = VecDeque::from([from]);
        while let Some(at) = open.pop_front() {
            for &next in &self.nodes[at as usize].touching {
                let Some(more) = cost(next) else { continue };
                let count = counts[at as usize] + more;
                if count < counts[next as usize] {
                    (counts[next as usize], before[next as usize]) = (count, at);
                    if more == 0 { open.push_front(next) } else { open.push_back(next) }
                }
            }
        }
        (counts, before)
    }
}

/// An iteration divides a cell, in O(log obstacles + obstacles nearby). Whenever all cells of the last channels are divided, new
/// ones are searched for, in O(cells); the search that ends the subdivision is not counted as an iteration.
impl Stepped for Subdivision {
    fn iterate(&mut self) {
        if self.channel.is_empty() {
            self.search();
        }
        let Some(next) = self.channel.pop() else { return };
        if self.nodes.len() + 4 > self.most_cells {
            self.verdict = Some(Verdict::Unknown);
            self.channel.clear();
            return;
        }
        self.divide(next);
    }

    /// `Solved` once there is a verdict, `Exhausted` if it is `Unknown`.
    fn status(&self) -> Status {
        match self.verdict {
            None => Status::Running,
            Some(Verdict::Unknown) => Status::Exhausted,
            Some(_) => Status::Solved,
        }
    }

    /// The number of cells that have been divided.
    fn iterations(&self) -> u64 {
        self.divisions
    }
}
