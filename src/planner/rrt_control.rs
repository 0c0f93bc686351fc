//! Kinodynamic RRT: a tree of controlled motions.
//!
//! LaValle and Kuffner 2001, "Randomized kinodynamic planning"; LaValle 2006, "Planning Algorithms", section 14.4.3. No control
//! leads exactly to a given state, so several are tried, and the one that ends closest becomes an edge; the goal is a region.

use super::driven_tree::{
    Blocked, ByControls, Drive, DrivenTree, Durations, MOST_STEPS, ROOT, dynamics, straight_reach, up_to_goal,
};
use super::groups::{Aim, GoalBias, Overgrowth};
use super::growth::Growth;
use super::info::{END_NEAR, Grows, Mark, NONE_FOUND, PlannerInfo, PlannerKind, Preset, line};
use super::removable_index::RemovableIndex;
use super::{Planner, Reason, Status};
use crate::error::Error;
use crate::graph::{EventKind, VertexId};
use crate::nearest::{Nearest, Query};
use crate::options::{CAR, out_of_range};
use crate::problem::{Control, Problem};
use crate::random::{Random, Stream};
use crate::space::Space;

/// The most of the nearest vertices that are checked for a free motion to the sample.
const MOST_VISIBLE: usize = 32;

crate::choice! {
    /// Which vertex is extended.
    pub enum Origin {
        /// The nearest to the sample.
        Nearest,
        /// Of the 32 nearest, the nearest that sees the sample: the straight motion to it is free.
        NearestVisible,
    }
}

crate::choice! {
    /// Which controls are tried.
    pub enum Controls {
        /// Random ones; the one that ends closest to the sample is kept.
        Random,
        /// The six of Reeds and Shepp; all that are free are kept.
        ReedsShepp,
    }
}

crate::options! {
    /// Options of the kinodynamic RRT.
    pub struct RrtControlOptions for CAR;
    /// Random controls, of which the best is kept, or full speed ahead and back, straight, left and right, all kept.
    controls: Controls = Controls::Random, "Controls";
    /// Number of random controls tried per extension: more aim better, but a greedy tree gets stuck.
    blossom: u32 = 1, in 1.0..=100.0, "Controls tried";
    /// Longest time a control is held: short motions follow bends, long ones cross open space quickly.
    duration_steps: Option<u32>, in 1.0..=MOST_STEPS, "Longest duration", unit "steps of integration",
        else "as many as the fastest straight motion of 0.3 times the largest distance takes";
    /// Shortest time a control is held: durations are drawn between this and the longest.
    shortest_steps: Option<u32>, in 1.0..=MOST_STEPS, "Shortest duration", unit "steps of integration",
        else "as many as duration_steps: all motions last equally long";
    /// Near the goal durations shrink in proportion to the distance, but not below this many steps.
    near_goal_steps: Option<u32>, in 1.0..=MOST_STEPS, "Shortest near goal", unit "steps of integration",
        else "none: durations are the same everywhere";
    /// A blocked motion ends after its last free step (cut), or is rejected as a whole (refused).
    blocked: Blocked = Blocked::Cut, "Blocked motion";
    /// Extends the vertex nearest to the sample, or the nearest from which the straight motion to it is free.
    nearest: Origin = Origin::Nearest, "Extended vertex";
    /// Extends each vertex only once; when all were extended, the planner gives up.
    once: bool = false, "Extend only once";
    /// When the tree grows towards the goal.
    reaching: GoalBias;
    /// Growth past the goal.
    overgrowth: Overgrowth;
    /// The longest duration in the last quarter of the iterations: short motions hit a small goal region better.
    late_duration_steps: Option<u32>, in 1.0..=MOST_STEPS, "Late duration", unit "steps of integration",
        else "as before";
    /// Grows towards the goal every n-th iteration in the last quarter of them.
    late_goal_every: Option<u32>, in 1.0..=1e6, "Late goal", else "as before";
    /// Options of all planners by controls.
    driving: ByControls;
}

impl PlannerKind for RrtControlOptions {
    const INFO: PlannerInfo = PlannerInfo {
        id: "rrt-control",
        title: "Kinodynamic RRT",
        summary: "From the vertex nearest to a sample, tries several controls and keeps the one that ends closest to the sample.",
        guarantee: "None: a tree that always keeps the best of several controls may get stuck.",
        grows: Grows::Tree,
        presets: &[
            Preset {
                id: "blossom-1",
                title: "1 control per extension",
                settings: "blossom=1 duration_steps=250 goal_bias=0.05 goal_test=ends max_iterations=10000",
            },
            Preset {
                id: "blossom-3",
                title: "3 controls per extension",
                settings: "blossom=3 duration_steps=250 goal_bias=0.05 goal_test=ends max_iterations=10000",
            },
            Preset {
                id: "blossom-5",
                title: "5 controls per extension",
                settings: "blossom=5 duration_steps=250 goal_bias=0.05 goal_test=ends max_iterations=10000",
            },
            Preset {
                id: "schedule",
                title: "Shorter motions at the end",
                settings: "blossom=30 duration_steps=200 late_duration_steps=100 goal_every=10 late_goal_every=5 blocked=refused goal_test=ends max_iterations=4000",
            },
            Preset {
                id: "six-controls",
                title: "Six controls",
                settings: "controls=reeds-shepp nearest=nearest-visible once=true duration_steps=100 near_goal_steps=10 goal_test=ends max_iterations=2000",
            },
            Preset {
                id: "thousand-vertices",
                title: "Last free step, 1000 vertices",
                settings: "duration_steps=250 goal_bias=0.05 vertices=1000",
            },
        ],
        pseudocode: &[
            line(0, "T ← {start}; repeat:", &[]),
            line(1, "q ← a random configuration, or the goal", &[Mark::Growing]),
            NONE_FOUND,
            line(1, "near ← the vertex of T nearest to q", &[Mark::Edge, Mark::Refused]),
            line(1, "if no vertex sees q: try again", &[Mark::Discarded]),
            line(1, "for b controls u, for a while each:", &[Mark::Edge, Mark::Refused]),
            line(2, "drive u from near, up to an obstacle", &[Mark::Edge, Mark::Refused]),
            line(1, "add the end nearest to q, with its u, to T", &[Mark::Vertex, Mark::Edge]),
            line(2, "within the goal region: solved", &[Mark::Solved]),
            line(1, "if none is free: reject them", &[Mark::Refused]),
            END_NEAR,
        ],
    };

    /// # Panics
    /// If the problem has no dynamics.
    fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error> {
        let (tree, mut open) = (DrivenTree::new(problem), RemovableIndex::default());
        open.insert(problem.space(), ROOT, problem.start());
        let early = Durations::new(problem, self.duration_steps, self.shortest_steps)?;
        Ok(Box::new(RrtControl {
            options: *self,
            aim: Aim::new(self.reaching, &self.driving.sampling, problem.space(), seed),
            controls: Random::new(seed, Stream::Controls),
            early,
            late: late(self, early)?,
            tree,
            open,
            arrived: None,
        }))
    }
}

/// The planner. An iteration takes one sample, or the goal, and tries several controls, a motion each, and
/// up to 32 more to find a vertex that sees the sample.
struct RrtControl<S: Space> {
    options: RrtControlOptions,
    aim: Aim<S>,
    /// Draws controls and durations.
    controls: Random,
    /// How long controls are held.
    early: Durations,
    /// See [`late`].
    late: Option<(u32, Durations, GoalBias)>,
    tree: DrivenTree<S>,
    /// The vertices that may be extended.
    open: RemovableIndex,
    /// The vertex in the goal region, once there is one.
    arrived: Option<VertexId>,
}

impl<S: Space> RrtControl<S> {
    /// Notes the first vertex in the goal region.
    fn arrive(&mut self, iteration: u32, vertex: VertexId, state: S::State) {
        if self.arrived.is_none() {
            self.tree.growth.add_event(EventKind::SolutionFound, iteration, Some(vertex), None, state);
            self.arrived = Some(vertex);
        }
    }

    /// Whether the tree goes on growing, and what it is if not.
    fn status(&self) -> Status {
        self.options.overgrowth.status(self.arrived.is_some(), self.tree.growth.graph.states().len())
    }

    /// The vertex to extend; `None` if none sees the target.
    fn origin(&mut self, problem: &Problem<S>, target: &S::State) -> Option<VertexId> {
        self.tree.growth.counters.nearest_queries += 1;
        let query = Query::to(problem.space(), self.tree.growth.graph.states(), target);
        if self.options.nearest == Origin::Nearest {
            return Some(self.open.nearest(query)?.vertex);
        }
        let mut near = Vec::new();
        self.open.k_nearest(query, MOST_VISIBLE, &mut near);
        near.into_iter().map(|neighbour| neighbour.vertex).find(|&vertex| {
            let state = self.tree.growth.state(vertex);
            self.tree.growth.is_motion_free(problem, &state, target)
        })
    }

    /// How long controls are held from this state.
    fn durations(&self, problem: &Problem<S>, from: &S::State, iteration: u32) -> Durations {
        let durations = self.late.filter(|late| iteration >= late.0).map_or(self.early, |late| late.1);
        let Some(least) = self.options.near_goal_steps else { return durations };
        let reach = straight_reach(problem, f64::from(durations.longest) * dynamics(problem).step());
        let part = problem.space().distance(from, problem.goal()) / reach;
        let shrunk = |steps: u32| match part {
            part if part < 1.0 => ((part * f64::from(steps)) as u32).max(least).min(steps),
            _ => steps,
        };
        Durations { shortest: shrunk(durations.shortest), longest: shrunk(durations.longest) }
    }

    /// The motions from the vertex that become edges.
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
        if self.options.controls == Controls::ReedsShepp {
            let drives = dynamics.extremes().into_iter().map(|control| held(control, random));
            return drives.filter_map(|drive| self.tree.free_part(problem, from, drive, blocked)).collect();
        }
        let measured = |drive: Drive<S::State>| (problem.space().distance(&drive.end, target), drive);
        let drives = (0..self.options.blossom).map(|_| {
            let control = dynamics.sample(random);
            measured(held(control, random))
        });
        if blocked == Blocked::Cut {
            let cut = drives.filter_map(|(_, drive)| self.tree.free_part(problem, from, drive, blocked)).map(measured);
            let cut: Vec<_> = cut.collect();
            return closest(&cut).map(|i| cut[i].1).into_iter().collect();
        }
        // Motions that end farther away need not be proven.
        let mut drives: Vec<_> = drives.collect();
        while let Some(i) = closest(&drives) {
            if let Some(drive) = self.tree.free_part(problem, from, drives.remove(i).1, blocked) {
                return vec![drive];
            }
        }
        Vec::new()
    }
}

/// The iteration at which the last quarter begins, and the durations and the goal bias from then on; `None` if they stay the
/// same.
fn late(options: &RrtControlOptions, early: Durations) -> Result<Option<(u32, Durations, GoalBias)>, Error> {
    let RrtControlOptions { late_duration_steps: longest, late_goal_every: every, reaching, .. } = *options;
    if longest.is_none() && every.is_none() {
        return Ok(None);
    }
    let longest_given = longest.is_some();
    let longest = longest.unwrap_or(early.longest);
    let durations =
        Durations { shortest: early.shortest.min(longest), longest }.with_shortest(options.shortest_steps)?;
    let reaching = GoalBias { goal_every: every.or(reaching.goal_every), ..reaching };
    let Some(most) = options.driving.limits.max_iterations else {
        let name = if longest_given { "late_duration_steps" } else { "late_goal_every" };
        let sentence = format!("{name} is for the last quarter of max_iterations, which must be given with it");
        return Err(out_of_range(name, sentence));
    };
    Ok(Some((most - most / 4 + 1, durations, reaching)))
}

/// The index of the closest, the first of them.
fn closest<T>(measured: &[(f64, T)]) -> Option<usize> {
    (0..measured.len()).min_by(|&a, &b| measured[a].0.total_cmp(&measured[b].0).then(a.cmp(&b)))
}

impl<S: Space> Planner<S> for RrtControl<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        if problem.is_goal(problem.start()) {
            self.arrive(iteration, ROOT, *problem.start());
            if self.status() == Status::Solved {
                return Status::Solved;
            }
        }
        if self.open.len() == 0 {
            return if self.arrived.is_some() { Status::Solved } else { Status::Exhausted };
        }
        if let Some((from, _, reaching)) = self.late
            && iteration == from
        {
            self.aim.reaching = reaching;
        }
        let Some(target) = self.aim.next(problem, iteration, &mut self.tree.growth) else { return Status::Running };
        let Some(origin) = self.origin(problem, &target) else {
            self.tree.growth.reject(EventKind::SampleDiscarded, iteration, target);
            return Status::Running;
        };
        if self.options.once {
            self.open.remove(problem.space(), self.tree.growth.graph.states(), origin);
        }
        let from = self.tree.growth.state(origin);
        let drives = self.blossom(problem, &from, &target, iteration);
        if drives.is_empty() {
            self.tree.growth.add_event(EventKind::EdgeRefused, iteration, Some(origin), None, target);
        }
        for drive in drives {
            let (drive, is_there) = up_to_goal(problem, &from, drive, self.options.driving.goal_test);
            let vertex = self.tree.grow(problem, iteration, origin, drive);
            if is_there {
                self.arrive(iteration, vertex, drive.end);
            }
            if self.status() != Status::Running {
                return self.status();
            }
            self.open.insert(problem.space(), vertex, &drive.end);
        }
        Status::Running
    }

    fn growth(&self) -> &Growth<S> {
        &self.tree.growth
    }

    fn growth_mut(&mut self) -> &mut Growth<S> {
        &mut self.tree.growth
    }

    fn reason(&self) -> Reason {
        if self.open.len() == 0 { Reason::NothingToExtend } else { Reason::VertexLimit }
    }

    fn path(&self) -> Vec<VertexId> {
        self.arrived.map(|vertex| self.tree.tree.from_root(vertex)).unwrap_or_default()
    }

    fn approximate_path(&self) -> Vec<VertexId> {
        self.tree.tree.from_root(self.tree.closest(|_| true))
    }
}
