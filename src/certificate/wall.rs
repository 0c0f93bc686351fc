//! What a subdivision proves: the least clearance that no path exceeds, and the cells that separate start and goal.

use super::Verdict;
use super::document::{Blocked, Certificate};
use super::subdivision::Subdivision;
use crate::geometry::sort_numbers;
use crate::graph::UnionFind;

impl Subdivision {
    /// No path keeps more than this clearance, in metres, as far as the cells prove by now; `None` if they prove nothing, as
    /// where they have a channel of cells without an obstacle nearby. O(cells log cells).
    ///
    /// Cells are joined in the order of their bounds, the greatest first, until start and goal are connected (the widest path of
    /// Pollack 1960, "The maximum capacity through a network", by Kruskal's algorithm).
    pub fn greatest_clearance(&self) -> Option<f64> {
        let [start, goal] = self.end_cells.map(|cell| cell as usize);
        let mut order: Vec<u32> = (0..self.cell_count() as u32).collect();
        sort_numbers(&mut order, &|i, j| self.nodes[j].most.total_cmp(&self.nodes[i].most).then(i.cmp(&j)));
        let mut sets = UnionFind::default();
        (0..self.cell_count()).for_each(|_| sets.add());
        let mut is_joined = vec![false; self.cell_count()];
        for i in order.into_iter().map(|i| i as usize) {
            is_joined[i] = true;
            for &other in &self.nodes[i].touching {
                if is_joined[other as usize] {
                    sets.join(i, other as usize);
                }
            }
            if sets.find(start) == sets.find(goal) {
                let most = self.nodes[i].most.min(self.nodes[start].most).min(self.nodes[goal].most);
                return (most < f64::INFINITY).then(|| most.max(0.0));
            }
        }
        None
    }

    /// What is proven by now. `Unknown` as long as there is no verdict. O(cells log cells).
    pub fn certificate(&self) -> Certificate {
        let verdict = self.verdict().unwrap_or(Verdict::Unknown);
        let clearance_at_most = match verdict {
            Verdict::Infeasible => Some(self.clearance),
            Verdict::Unknown => self.greatest_clearance(),
            Verdict::Connected => None,
        };
        let channel = match verdict {
            Verdict::Connected => self.channel(),
            Verdict::Infeasible | Verdict::Unknown => Vec::new(),
        };
        Certificate {
            format: super::document::Format::One,
            scenario: self.scenario.clone(),
            query: self.query.clone(),
            clearance: self.clearance,
            verdict,
            clearance_at_most,
            slack: 2.0 * self.clearances.eta,
            cells: self.cell_count() as u64,
            wall: clearance_at_most
                .map_or(Vec::new(), |most| self.wall(most).into_iter().map(|cell| self.blocked(cell, most)).collect()),
            channel: channel.into_iter().map(|cell| self.nodes[cell as usize].cell).collect(),
        }
    }

    /// Free cells from that of the start to that of the goal, each touching the next.
    fn channel(&self) -> Vec<u32> {
        let [start, goal] = self.end_cells;
        let (_, before) = self.counts(start);
        let mut channel: Vec<u32> =
            std::iter::successors(Some(goal), |&cell| (cell != start).then(|| before[cell as usize])).collect();
        channel.reverse();
        channel
    }

    /// Cells in which the clearance is nowhere greater than `most`, and which every path from start to goal meets.
    fn wall(&self, most: f64) -> Vec<u32> {
        let mut is_open: Vec<bool> = self.nodes.iter().map(|node| node.most > most).collect();
        let [start, goal] = self.end_cells;
        // The cells that close in what can be reached from the start; of these, those that can be reached from the goal.
        let mut wall = Vec::new();
        for end in [start, goal] {
            wall = self.around(end, &is_open);
            is_open.fill(true);
            wall.iter().for_each(|&cell| is_open[cell as usize] = false);
        }
        sort_numbers(&mut wall, &|i, j| i.cmp(&j));
        wall
    }

    /// The cells that are not open and touch one that can be reached from a cell through open ones; itself if it is not open.
    fn around(&self, end: u32, is_open: &[bool]) -> Vec<u32> {
        let mut is_met = vec![false; self.cell_count()];
        is_met[end as usize] = true;
        let (mut met, mut next) = (vec![end], 0);
        while let Some(&at) = met.get(next) {
            next += 1;
            if is_open[at as usize] {
                for &other in &self.nodes[at as usize].touching {
                    if !std::mem::replace(&mut is_met[other as usize], true) {
                        met.push(other);
                    }
                }
            }
        }
        met.retain(|&cell| !is_open[cell as usize]);
        met
    }

    /// A cell of the wall and why the clearance is nowhere greater there.
    fn blocked(&self, cell: u32, most: f64) -> Blocked {
        let cell = self.nodes[cell as usize].cell;
        let witness =
            self.clearances.over(&cell, most).witness.expect("a cell whose clearance is bounded has a witness");
        Blocked { cell, part: witness.part, along: witness.along, with: witness.with }
    }
}
