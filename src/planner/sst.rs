//! SST: a sparse tree of controlled motions: of vertices near each other only the cheapest may grow.
//!
//! Li, Littlefield and Bekris 2016, "Asymptotically optimal sampling-based kinodynamic planning". Witnesses are scattered over
//! the space as the tree reaches it, no two nearer than the pruning radius; each represents the cheapest vertex near it. A vertex
//! that is no longer the cheapest does not grow, and is removed with its edge once it has no children. Cost is the length of the
//! path as results report it, in metres driven; what is near is decided by the metric of the space.
//!
//! As in SST* of the same paper, the radii shrink from one stage of iterations to the next, longer one. Here they do so
//! if they are not given, and only while there is no path: a radius as wide as a passage prunes every vertex that leads
//! through it.

use super::driven_tree::{Blocked, ByControls, Drive, DrivenTree, Durations, MOST_STEPS, ROOT, dynamics, up_to_goal};
use super::groups::{Aim, GoalBias, Termination};
use super::growth::Growth;
use super::info::{END_NEAR, Grows, Mark, NONE_FOUND, PlannerInfo, PlannerKind, line};
use super::removable_index::RemovableIndex;
use super::{Planner, Status};
use crate::error::Error;
use crate::graph::{EventKind, VertexId};
use crate::nearest::{Index, Nearest, Neighbour, Query};
use crate::options::CAR;
use crate::problem::{Motion, Problem};
use crate::random::{Random, Stream};
use crate::space::Space;

/// The default selection radius, as a fraction of the space's extent.
const DEFAULT_SELECTION: f64 = 0.06;
/// The default pruning radius, as a fraction of the space's extent.
const DEFAULT_PRUNING: f64 = 0.03;
/// How many iterations without a path the first stage has, and how many more each has than the one before it.
const STAGE: f64 = 5000.0;
const LONGER: f64 = 1.5;
/// By what factor radii that are not given shrink from one stage to the next.
const SHRINKING: f64 = 0.7;

crate::options! {
    /// Options of SST.
    pub struct SstOptions for CAR;
    /// The cheapest vertex within this distance of a sample grows: large radii shorten paths, small ones explore.
    selection_radius: Option<f64>, in 0.0..=1e7, "Selection radius", unit "distance in the metric",
        else "0.06 times the largest distance in the space, falling while there is no path";
    /// Of the vertices within about this distance of each other, only the cheapest grows: large radii prune more.
    pruning_radius: Option<f64>, in 0.0..=1e7, "Pruning radius", unit "distance in the metric",
        else "0.03 times the largest distance in the space, falling while there is no path";
    /// Longest time a control is held: short motions follow bends, long ones cross open space quickly.
    duration_steps: Option<u32>, in 1.0..=MOST_STEPS, "Longest duration", unit "steps of integration",
        else "as many as the fastest straight motion of 0.3 times the largest distance takes";
    /// Shortest time a control is held: durations are drawn between this and the longest.
    shortest_steps: u32 = 1, in 1.0..=MOST_STEPS, "Shortest duration", unit "steps of integration";
    /// A blocked motion ends after its last free step (cut), or is rejected as a whole (refused).
    blocked: Blocked = Blocked::Cut, "Blocked motion";
    /// When the tree grows towards the goal.
    reaching: GoalBias;
    /// When it stops: by default with its first path.
    termination: Termination = Termination { improve_iterations: 0, ..Default::default() };
    /// Options of all planners by controls.
    driving: ByControls;
}

impl PlannerKind for SstOptions {
    const INFO: PlannerInfo = PlannerInfo {
        id: "sst",
        title: "SST",
        summary: "Kinodynamic and sparse: of vertices near each other only the cheapest grows; it can go on to shorter paths.",
        guarantee: "Asymptotically near-optimal if random controls have clearance: as near the shortest as its radii allow.",
        grows: Grows::Tree,
        presets: &[],
        pseudocode: &[
            line(0, "T ← {start}; repeat:", &[]),
            line(1, "q ← a random configuration, or the goal", &[Mark::Growing, Mark::Improving]),
            NONE_FOUND,
            line(1, "near ← the cheapest of T about q", &[Mark::Edge, Mark::Refused, Mark::Discarded]),
            line(1, "drive a random control for a random duration", &[Mark::Edge, Mark::Refused, Mark::Discarded]),
            line(1, "if that is not free: reject it", &[Mark::Refused]),
            line(1, "if the end costs least about it: add it", &[Mark::Vertex, Mark::Edge]),
            line(2, "deactivate the vertex that was cheapest there", &[Mark::Vertex]),
            line(2, "remove it from T once it has no children", &[Mark::Removed]),
            line(2, "within the goal region: solved", &[Mark::Solved]),
            line(1, "else: discard it", &[Mark::Discarded]),
            END_NEAR,
        ],
    };

    /// # Panics
    /// If the problem has no dynamics.
    fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error> {
        let space = problem.space();
        let mut sst = Sst {
            options: *self,
            selection_radius: self.selection_radius.unwrap_or(DEFAULT_SELECTION * space.extent()),
            pruning_radius: self.pruning_radius.unwrap_or(DEFAULT_PRUNING * space.extent()),
            stage: Stage { end: STAGE, length: STAGE },
            durations: Durations::new(problem, self.duration_steps, Some(self.shortest_steps))?,
            aim: Aim::new(self.reaching, &self.driving.sampling, space, seed),
            controls: Random::new(seed, Stream::Controls),
            tree: DrivenTree::new(problem),
            costs: vec![0.0],
            children: vec![0],
            is_removed: vec![false],
            active: RemovableIndex::default(),
            witnesses: Index::default(),
            representatives: vec![Some(ROOT)],
            best: None,
            found: Vec::new(),
        };
        sst.active.insert(space, ROOT, problem.start());
        sst.witnesses.insert(space, ROOT, problem.start());
        Ok(Box::new(sst))
    }
}

/// The planner. An iteration takes one sample, or the goal, and tries one random control for a random duration.
struct Sst<S: Space> {
    options: SstOptions,
    /// The cheapest vertex within this distance of a sample is extended; the nearest vertex if there is none.
    selection_radius: f64,
    /// A new witness is farther than this from every other.
    pruning_radius: f64,
    stage: Stage,
    durations: Durations,
    aim: Aim<S>,
    /// Draws controls and durations.
    controls: Random,
    tree: DrivenTree<S>,
    /// The length of the path to each vertex.
    costs: Vec<f64>,
    /// The number of children of each vertex.
    children: Vec<u32>,
    is_removed: Vec<bool>,
    /// The vertices that may grow: the representatives of the witnesses.
    active: RemovableIndex,
    /// States of vertices that no witness was near.
    witnesses: Index,
    /// The representative of each vertex that is a witness.
    representatives: Vec<Option<VertexId>>,
    /// The end of the cheapest path to the goal region so far.
    best: Option<VertexId>,
    found: Vec<Neighbour>,
}

/// Iterations without a path, with the same radii.
struct Stage {
    /// Its last iteration.
    end: f64,
    length: f64,
}

impl<S: Space> Sst<S> {
    /// Begins the next stage if one has ended without a path.
    fn shrink(&mut self, iteration: u32) {
        if self.best.is_some() || f64::from(iteration) <= self.stage.end {
            return;
        }
        self.stage.length *= LONGER;
        self.stage.end += self.stage.length;
        if self.options.selection_radius.is_none() {
            self.selection_radius *= SHRINKING;
        }
        if self.options.pruning_radius.is_none() {
            self.pruning_radius *= SHRINKING;
        }
    }

    /// The length of the path to a vertex.
    fn length(&self, vertex: VertexId) -> f64 {
        self.costs[vertex.index()]
    }

    /// The vertex to extend: the cheapest that is near, ties by number.
    fn origin(&mut self, problem: &Problem<S>, target: &S::State) -> VertexId {
        self.tree.growth.counters.nearest_queries += 1;
        let query = Query::to(problem.space(), self.tree.growth.graph.states(), target);
        self.active.within(query, self.selection_radius, &mut self.found);
        self.tree.growth.looked += self.found.len() as u64;
        let near = self.found.iter().map(|neighbour| neighbour.vertex);
        let cheapest = near.min_by(|&a, &b| self.length(a).total_cmp(&self.length(b)).then(a.cmp(&b)));
        cheapest.unwrap_or_else(|| self.active.nearest(query).expect("every witness has a representative").vertex)
    }

    /// The witness of a state: the nearest; `None` if that is too far.
    fn witness(&mut self, problem: &Problem<S>, state: &S::State) -> Option<VertexId> {
        self.tree.growth.counters.nearest_queries += 1;
        let query = Query::to(problem.space(), self.tree.growth.graph.states(), state);
        let nearest = self.witnesses.nearest(query).expect("the start is a witness");
        (nearest.distance <= self.pruning_radius).then_some(nearest.vertex)
    }

    /// Adds the end of a motion to the tree.
    fn grow(
        &mut self,
        problem: &Problem<S>,
        iteration: u32,
        origin: VertexId,
        drive: Drive<S::State>,
        cost: f64,
    ) -> VertexId {
        let vertex = self.tree.grow(problem, iteration, origin, drive);
        self.costs.push(cost);
        self.children.push(0);
        self.is_removed.push(false);
        self.representatives.push(None);
        self.children[origin.index()] += 1;
        vertex
    }

    /// Makes the vertex the representative of the witness, or of itself as a new one; the former one becomes inactive.
    fn replace(&mut self, problem: &Problem<S>, iteration: u32, witness: Option<VertexId>, vertex: VertexId) {
        let (space, states) = (problem.space(), self.tree.growth.graph.states());
        self.active.insert(space, vertex, &states[vertex.index()]);
        if witness.is_none() {
            self.witnesses.insert(space, vertex, &states[vertex.index()]);
        }
        if let Some(beaten) = self.representatives[witness.unwrap_or(vertex).index()].replace(vertex) {
            self.active.remove(space, states, beaten);
            self.prune(iteration, beaten);
        }
    }

    /// Removes the vertex from the tree if it is a leaf that is inactive, then its parent likewise, and so on. The end
    /// of the best path stays.
    fn prune(&mut self, iteration: u32, vertex: VertexId) {
        let mut leaf = Some(vertex);
        while let Some(vertex) = leaf {
            let stays = self.children[vertex.index()] > 0 || self.active.contains(vertex) || self.best == Some(vertex);
            let Some(parent) = self.tree.tree.parent(vertex).filter(|_| !stays) else { return };
            self.is_removed[vertex.index()] = true;
            self.children[parent.index()] -= 1;
            let state = self.tree.growth.state(vertex);
            self.tree.growth.add_event(EventKind::VertexRemoved, iteration, Some(vertex), None, state);
            leaf = Some(parent);
        }
    }

    /// Makes the vertex the end of the best path.
    fn arrive(&mut self, iteration: u32, vertex: VertexId, state: S::State) {
        self.tree.growth.add_event(EventKind::SolutionFound, iteration, Some(vertex), None, state);
        if let Some(earlier) = self.best.replace(vertex) {
            self.prune(iteration, earlier);
        }
    }

    /// Tries one motion from the vertex.
    fn try_drive(&mut self, problem: &Problem<S>, iteration: u32, origin: VertexId) {
        let dynamics = dynamics(problem);
        let from = self.tree.growth.state(origin);
        let control = dynamics.sample(&mut self.controls);
        let steps = self.durations.sample(&mut self.controls);
        let wanted = Drive { control, steps, end: dynamics.drive(&from, control, steps) };
        let Some(drive) = self.tree.free_part(problem, &from, wanted, self.options.blocked) else {
            let kind = EventKind::EdgeRefused;
            return self.tree.growth.add_event(kind, iteration, Some(origin), None, wanted.end);
        };
        let (drive, is_there) = up_to_goal(problem, &from, drive, self.options.driving.goal_test);
        let duration = f64::from(drive.steps) * dynamics.step();
        let cost = self.length(origin) + dynamics.length(Motion { control, duration });
        // A path that already costs as much as the best one cannot become better.
        let is_cheap = self.best.is_none_or(|best| cost < self.length(best));
        if is_cheap {
            let witness = self.witness(problem, &drive.end);
            let representative = witness.and_then(|witness| self.representatives[witness.index()]);
            if representative.is_none_or(|vertex| cost < self.length(vertex)) {
                let vertex = self.grow(problem, iteration, origin, drive, cost);
                if is_there {
                    self.arrive(iteration, vertex, drive.end);
                }
                return self.replace(problem, iteration, witness, vertex);
            }
            if is_there {
                // The end of a path, though something else near it costs less.
                let vertex = self.grow(problem, iteration, origin, drive, cost);
                return self.arrive(iteration, vertex, drive.end);
            }
        }
        self.tree.growth.reject(EventKind::SampleDiscarded, iteration, drive.end);
    }
}

impl<S: Space> Planner<S> for Sst<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        if self.best.is_none() && problem.is_goal(problem.start()) {
            // No path is shorter.
            self.arrive(iteration, ROOT, *problem.start());
            return Status::Solved;
        }
        self.shrink(iteration);
        if let Some(target) = self.aim.next(problem, iteration, &mut self.tree.growth) {
            let origin = self.origin(problem, &target);
            self.try_drive(problem, iteration, origin);
        }
        Status::Running
    }

    fn cost(&self) -> f64 {
        self.best.map_or(f64::INFINITY, |best| self.length(best))
    }

    fn growth(&self) -> &Growth<S> {
        &self.tree.growth
    }

    fn growth_mut(&mut self) -> &mut Growth<S> {
        &mut self.tree.growth
    }

    fn path(&self) -> Vec<VertexId> {
        self.best.map(|best| self.tree.tree.from_root(best)).unwrap_or_default()
    }

    fn approximate_path(&self) -> Vec<VertexId> {
        self.tree.tree.from_root(self.tree.closest(|vertex| !self.is_removed[vertex.index()]))
    }
}
