//! What a run copies into its result, and how it is begun again.

use super::Run;
use super::storage::RoadmapDocument;
use crate::collision::KeepAway;
use crate::error::Error;
use crate::path::{LengthMeasure, Wanted};
use crate::planner::{
    ByControls, EdgeCheck, EdgeOptions, IntegrationKind, Limits, Overgrowth, PlannerOptions, Roadmap, Termination,
};
use crate::problem::{Validity, nearest_free};
use crate::space::Space;
use crate::world::PlanningWorld;

/// The names and numbers that a run copies into its result.
#[derive(Debug, Clone, Default)]
pub(super) struct RunInfo {
    pub scenario: String,
    pub query: String,
    pub planner: &'static str,
    pub seed: u64,
    pub limits: Limits,
    /// Whether the planner ends by itself, with a number of samples that was given.
    pub is_finite: bool,
    /// The vertices that a tree is to have.
    pub vertices: Option<u32>,
    pub wanted: Wanted,
    /// When a planner that goes on to shorter paths is to end; `None` for others.
    pub termination: Option<Termination>,
    pub edge_check: EdgeCheck,
    /// What lengths measure; `None` if that is not known.
    pub measure: Option<LengthMeasure>,
    /// How the path keeps away from obstacles; `None` if only lengths count.
    pub keep_away: Option<KeepAway>,
    /// The margin of the robot, in metres; 0 if it has none.
    pub margin: f64,
    /// The start, if it was moved out of a collision, and the goals that were.
    pub moved_start: Option<Vec<f64>>,
    pub moved_goals: Vec<Vec<f64>>,
    /// Whether motions are rolled out under a learned policy.
    pub is_learned: bool,
    /// Whether motions are those of controls.
    pub is_driven: bool,
    /// Whether motions are integrated by Euler steps.
    pub is_euler: bool,
}

impl RunInfo {
    /// What a run copies from the options of its planner.
    pub fn of(planner: &PlannerOptions, seed: u64) -> Self {
        let edges = planner.group::<EdgeOptions>().map_or_else(Self::default, Self::of_edges);
        let driving = planner.group::<ByControls>();
        Self {
            planner: planner.id(),
            seed,
            limits: planner.group::<Limits>().copied().unwrap_or_default(),
            is_finite: planner.needed().is_some(),
            vertices: planner.group::<Overgrowth>().and_then(|growth| growth.vertices),
            termination: planner.group::<Termination>().copied(),
            is_driven: driving.is_some(),
            is_euler: driving.is_some_and(|by| by.integration == IntegrationKind::Euler),
            ..edges
        }
    }

    /// What it copies from the options of edges.
    pub fn of_edges(&EdgeOptions { improving, edge_check, limits, .. }: &EdgeOptions) -> Self {
        let wanted = Wanted {
            reduce: improving.reduce,
            shortcuts: improving.shortcut,
            partial_shortcuts: improving.partial_shortcut,
            blend: improving.blend,
        };
        Self { wanted, edge_check, limits, ..Self::default() }
    }

    /// Moves a start and goals in collision to the nearest free states that are found, at most so far, and notes which were.
    /// Those without one stay as they are, to be refused.
    pub fn move_ends<S: Space>(
        &mut self,
        space: &S,
        validity: &dyn Validity<S::State>,
        start: &mut S::State,
        goals: &mut [S::State],
        most: f64,
    ) {
        let nearest = |state: &S::State| {
            let is_free = |q: &S::State| validity.is_free(q);
            if is_free(state) { None } else { nearest_free(space, &is_free, state, most).map(|(moved, _)| moved) }
        };
        if let Some(moved) = nearest(start) {
            *start = moved;
            self.moved_start = Some(space.coordinates(start).to_vec());
        }
        for goal in goals {
            if let Some(moved) = nearest(goal) {
                *goal = moved;
                self.moved_goals.push(space.coordinates(goal).to_vec());
            }
        }
    }
}

/// Makes the document of a roadmap without its vertices, its edges and how they were chosen. Most runs are never asked for it,
/// and it takes time in proportion to the world.
pub(super) type EmptyRoadmap = Box<dyn Fn() -> RoadmapDocument + Send>;

/// Begins a run in another world with a roadmap of this one.
pub(super) type Reopen<S> = Box<dyn Fn(&PlanningWorld, &Roadmap<S>) -> Result<Box<dyn Run>, Error> + Send>;
