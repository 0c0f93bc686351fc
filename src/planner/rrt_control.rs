//! RRT by controls: a tree that is driven into the space.
//!
//! LaValle and Kuffner 2001, "Randomized kinodynamic planning"; LaValle 2006, "Planning Algorithms", section 14.4.3. Nothing
//! leads exactly to a state that was wished for, so a few controls are tried, a blossom, and the one that comes closest is
//! kept; and the goal is a region.

use super::active::Active;
use super::driven_tree::{Blocked, Drive, DrivenTree, Durations, GoalTest, ROOT, dynamics, up_to_goal};
use super::{Counters, GoalBias, Phase, Planner, Status};
use crate::control::{Control, Motion};
use crate::graph::{EventKind, Graph, VertexId};
use crate::problem::Problem;
use crate::random::Random;
use crate::sampling::{Known, Sampler};
use crate::space::Space;

/// How many of the nearest vertices are asked whether they see the sample.
const MOST_LOOKS: usize = 32;

/// Which vertex is grown from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// The nearest to the sample.
    Nearest,
    /// Of the 32 nearest, the nearest that sees the sample: the straight motion to it is free.
    NearestVisible,
}

/// Which controls are tried.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Blossom {
    /// So many random ones, at least 1; the one that comes closest to the sample is kept.
    Random(u32),
    /// The six of Reeds and Shepp; all that are free are kept.
    ReedsShepp,
}

/// What is different from some iteration on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Late {
    /// The first iteration of which it holds.
    pub from: u32,
    /// How long controls are held.
    pub durations: Durations,
    /// When the tree reaches for the goal.
    pub bias: GoalBias,
}

/// How a tree is driven.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RrtControlOptions {
    /// Which vertex is grown from.
    pub origin: Origin,
    /// Whether a vertex is grown from only once.
    pub once: bool,
    /// Which controls are tried.
    pub blossom: Blossom,
    /// How long they are held.
    pub durations: Durations,
    /// Where there is such a number: from a vertex that is nearer to the goal than the fastest straight motion of the longest
    /// duration goes, durations are shorter in proportion, but of so many steps at least.
    pub near_goal: Option<u32>,
    /// What becomes of motions that are not free to their end.
    pub blocked: Blocked,
    /// When the tree reaches for the goal.
    pub bias: GoalBias,
    /// What is different later.
    pub late: Option<Late>,
    /// Where the goal is looked for.
    pub goal_test: GoalTest,
}

/// The planner. An iteration takes one sample, or the goal, and tries one blossom: as many motions as it has controls, and
/// up to 32 more to see the sample where that is asked for.
pub struct RrtControl<S: Space> {
    options: RrtControlOptions,
    sampler: Box<dyn Sampler<S>>,
    /// Decides when it reaches for the goal.
    bias: Random,
    /// Draws controls and durations.
    controls: Random,
    tree: DrivenTree<S>,
    /// The vertices that may be grown from.
    open: Active<S>,
    /// The vertex in the goal region, once there is one.
    arrived: Option<VertexId>,
}

impl<S: Space> RrtControl<S> {
    /// A planner at its beginning; `bias` decides when it reaches for the goal, `controls` what it tries.
    ///
    /// # Panics
    /// Where the problem has no dynamics, once it is stepped.
    pub fn new(
        problem: &Problem<S>,
        options: RrtControlOptions,
        sampler: Box<dyn Sampler<S>>,
        [bias, controls]: [Random; 2],
    ) -> Self {
        let (tree, mut open) = (DrivenTree::new(problem), Active::new());
        open.insert(problem.space(), &tree.graph, ROOT);
        Self { options, sampler, bias, controls, tree, open, arrived: None }
    }

    fn arrive(&mut self, iteration: u32, vertex: VertexId, state: S::State) -> Status {
        self.tree.tell(EventKind::SolutionFound, iteration, Some(vertex), state);
        self.arrived = Some(vertex);
        Status::Solved
    }

    /// Durations and goal bias of an iteration.
    fn rules(&self, iteration: u32) -> (Durations, GoalBias) {
        match self.options.late {
            Some(late) if iteration >= late.from => (late.durations, late.bias),
            _ => (self.options.durations, self.options.bias),
        }
    }

    /// Where to grow this time; `None` where the sampler has nothing.
    fn target(&mut self, problem: &Problem<S>, iteration: u32) -> Option<S::State> {
        if self.rules(iteration).1.is_due(iteration, &mut self.bias) {
            return Some(*problem.goal());
        }
        let sample = self.sampler.draw(problem, &mut self.tree.counters.configuration_checks);
        if sample.known == Known::Useless {
            self.tree.tell(EventKind::SampleRejected, iteration, None, sample.state);
            return None;
        }
        Some(sample.state)
    }

    /// The vertex to grow from; `None` where none sees the target.
    fn origin(&mut self, problem: &Problem<S>, target: &S::State) -> Option<VertexId> {
        self.tree.counters.nearest_queries += 1;
        let space = problem.space();
        if self.options.origin == Origin::Nearest {
            return Some(self.open.nearest(space, target)?.vertex);
        }
        let mut near = Vec::new();
        self.open.k_nearest(space, target, MOST_LOOKS, &mut near);
        near.into_iter().map(|neighbour| neighbour.vertex).find(|&vertex| {
            self.tree.counters.motion_checks += 1;
            problem.validity().is_motion_free(self.tree.graph.state(vertex), target)
        })
    }

    /// How long controls are held from here.
    fn durations(&self, problem: &Problem<S>, from: &S::State, iteration: u32) -> Durations {
        let (durations, _) = self.rules(iteration);
        let Some(least) = self.options.near_goal else { return durations };
        let dynamics = dynamics(problem);
        let duration = f64::from(durations.longest) * dynamics.step();
        let straight =
            |control: Control| dynamics.length(Motion { control: Control { steering: 0.0, ..control }, duration });
        let reach = dynamics.extremes().into_iter().map(straight).fold(0.0, f64::max);
        let part = problem.space().distance(from, problem.goal()) / reach;
        let shrunk = |steps: u32| match part {
            part if part < 1.0 => ((part * f64::from(steps)) as u32).max(least).min(steps),
            _ => steps,
        };
        Durations { shortest: shrunk(durations.shortest), longest: shrunk(durations.longest) }
    }

    /// The drives from the vertex that are kept.
    fn blossom(
        &mut self,
        problem: &Problem<S>,
        from: &S::State,
        target: &S::State,
        iteration: u32,
    ) -> Vec<Drive<S::State>> {
        let (durations, blocked) = (self.durations(problem, from, iteration), self.options.blocked);
        let (dynamics, random) = (dynamics(problem), &mut self.controls);
        let held = |control: Control, random: &mut Random| {
            let steps = durations.sample(random);
            Drive { control, steps, end: dynamics.drive(from, control, steps) }
        };
        let Blossom::Random(count) = self.options.blossom else {
            let drives = dynamics.extremes().into_iter().map(|control| held(control, random));
            return drives.filter_map(|drive| self.tree.prove(problem, from, drive, blocked)).collect();
        };
        let measured = |drive: Drive<S::State>| (problem.space().distance(&drive.end, target), drive);
        let drives = (0..count).map(|_| {
            let control = dynamics.sample(random);
            measured(held(control, random))
        });
        if blocked == Blocked::Cut {
            let cut = drives.filter_map(|(_, drive)| self.tree.prove(problem, from, drive, blocked)).map(measured);
            let cut: Vec<_> = cut.collect();
            return closest(&cut).map(|i| cut[i].1).into_iter().collect();
        }
        // What ends farther away need not be proven.
        let mut drives: Vec<_> = drives.collect();
        while let Some(i) = closest(&drives) {
            if let Some(drive) = self.tree.prove(problem, from, drives.remove(i).1, blocked) {
                return vec![drive];
            }
        }
        Vec::new()
    }
}

/// Which is the closest, the first of them.
fn closest<T>(measured: &[(f64, T)]) -> Option<usize> {
    (0..measured.len()).min_by(|&a, &b| measured[a].0.total_cmp(&measured[b].0).then(a.cmp(&b)))
}

impl<S: Space> Planner<S> for RrtControl<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        if self.arrived.is_none() && problem.is_goal(problem.start()) {
            return self.arrive(iteration, ROOT, *problem.start());
        }
        if self.arrived.is_some() {
            return Status::Solved;
        }
        if self.open.is_empty() {
            return Status::Exhausted;
        }
        let Some(target) = self.target(problem, iteration) else { return Status::Running };
        let Some(origin) = self.origin(problem, &target) else {
            self.tree.tell(EventKind::SampleDiscarded, iteration, None, target);
            return Status::Running;
        };
        if self.options.once {
            self.open.remove(problem.space(), &self.tree.graph, origin);
        }
        let from = *self.tree.graph.state(origin);
        let drives = self.blossom(problem, &from, &target, iteration);
        if drives.is_empty() {
            self.tree.tell(EventKind::EdgeRefused, iteration, Some(origin), target);
        }
        for drive in drives {
            let (drive, is_there) = up_to_goal(problem, &from, drive, self.options.goal_test);
            let vertex = self.tree.grow(problem, iteration, origin, drive);
            if is_there {
                return self.arrive(iteration, vertex, drive.end);
            }
            self.open.insert(problem.space(), &self.tree.graph, vertex);
        }
        Status::Running
    }

    fn phase(&self) -> Phase {
        if self.arrived.is_some() { Phase::Done } else { Phase::Growing }
    }

    fn graph(&self) -> &Graph<S> {
        &self.tree.graph
    }

    fn path(&self) -> Vec<VertexId> {
        self.arrived.map(|vertex| self.tree.way(vertex)).unwrap_or_default()
    }

    fn approximate_path(&self) -> Vec<VertexId> {
        self.tree.way(self.tree.closest(|_| true))
    }

    fn counters(&self) -> Counters {
        self.tree.counters
    }
}
