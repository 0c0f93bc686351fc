//! A scenario for JavaScript.

use super::convert::{count, fields, options, reach_options, record, size, split};
use super::drive::obstruction;
use super::reach::{followed, near, target};
use super::{RawDrive, RawNeighbours, RawPlanner, RawReach};
use crate::Error;
use crate::driving::{self, Drive};
use crate::ik::{Solver, arm_of, follow, nearest_reachable};
use crate::problem::{Control, Motion, Touched};
use crate::robot::Part;
use crate::run;
use crate::run::inspect::{Clearance, Inspector};
use crate::run::neighbours;
use crate::run::storage::RoadmapDocument;
use crate::scenario::Scenario;
use crate::world::PlanningWorld;
use wasm_bindgen::prelude::*;

/// A checked scenario and queries about it.
#[wasm_bindgen]
pub struct RawScenario {
    world: PlanningWorld,
    inspector: Inspector,
}

impl RawScenario {
    fn new(scenario: Scenario) -> Self {
        let world = PlanningWorld::new(scenario);
        let inspector = Inspector::new(&world);
        Self { world, inspector }
    }
}

#[wasm_bindgen]
impl RawScenario {
    /// Reads a scenario from JSON text.
    pub fn parse(text: &str) -> Result<RawScenario, Error> {
        Scenario::parse(text).map(Self::new)
    }

    /// Generates a scenario by the generator's id, with options.
    pub fn generate(kind: &str, options: JsValue) -> Result<RawScenario, Error> {
        crate::scenario::generate::generate(kind, &fields(options)?.into()).map(Self::new)
    }

    /// Each touching pair at `q`: the part, and the index of the obstacle or -1 for the bounds.
    pub fn check(&self, q: &[f64]) -> Result<Vec<i32>, Error> {
        let contacts = self.inspector.check(q)?;
        let touched = |with| if let Touched::Obstacle(i) = with { i as i32 } else { -1 };
        Ok(contacts.iter().flat_map(|contact| [contact.part as i32, touched(contact.with)]).collect())
    }

    /// The nearest pair of a part of the robot at `q` and an obstacle: distance, part, obstacle and both points; empty without one.
    pub fn clearance(&self, q: &[f64]) -> Result<Vec<f64>, Error> {
        let numbers = |near: Clearance| {
            let [a, b] = near.points;
            vec![near.distance, near.part as f64, near.obstacle as f64, a.x, a.y, b.x, b.y]
        };
        Ok(self.inspector.clearance(q)?.map_or_else(Vec::new, numbers))
    }

    /// The parts of the robot at `q`: both ends and the radius of every link of an arm, centre and radius of a disc, the
    /// corners of a body or a car.
    pub fn footprint(&self, q: &[f64]) -> Result<Vec<f64>, Error> {
        let mut numbers = Vec::new();
        for part in self.inspector.footprint(q)? {
            match part {
                Part::Capsule { a, b, radius } => numbers.extend([a.x, a.y, b.x, b.y, radius]),
                Part::Disc { center, radius } => numbers.extend([center.x, center.y, radius]),
                Part::Polygon { vertices } => numbers.extend(vertices.iter().flat_map(|corner| [corner.x, corner.y])),
            }
        }
        Ok(numbers)
    }

    /// The tip of the arm or the centre of the disc at `q`: x, y.
    pub fn end_effector(&self, q: &[f64]) -> Result<Vec<f64>, Error> {
        self.inspector.end_effector(q).map(|tip| vec![tip.x, tip.y])
    }

    /// The same for rows of configurations: rows of x, y.
    pub fn end_effectors(&self, rows: &[f64]) -> Result<Vec<f64>, Error> {
        let mut tips = Vec::with_capacity(rows.len() / self.dimension() * 2);
        for row in rows.chunks(self.dimension()) {
            let tip = self.inspector.end_effector(row)?;
            tips.extend([tip.x, tip.y]);
        }
        Ok(tips)
    }

    /// The configuration a fraction `t` along the motion from `a` to `b`.
    pub fn interpolate(&self, a: &[f64], b: &[f64], t: f64) -> Result<Vec<f64>, Error> {
        self.inspector.interpolate(a, b, t)
    }

    /// The distance from `a` to `b` in the default metric.
    pub fn distance(&self, a: &[f64], b: &[f64]) -> Result<f64, Error> {
        self.inspector.distance(a, b)
    }

    /// The fraction at which the motion from `a` to `b` first cannot be proven free; undefined if all of it is proven.
    pub fn first_hit(&self, a: &[f64], b: &[f64]) -> Result<Option<f64>, Error> {
        self.inspector.first_hit(a, b)
    }

    /// The configuration space of an arm of two links, one byte per cell, 1 for collision.
    pub fn cspace(&self, width: f64, height: f64) -> Result<Vec<u8>, Error> {
        self.inspector.configuration_space(size(width, "width")?, size(height, "height")?)
    }

    /// The angles that it covers: low and high of the first joint, then of the second.
    pub fn cspace_range(&self) -> Result<Vec<f64>, Error> {
        self.inspector.configuration_space_range().map(|range| range.concat())
    }

    /// Starts a run; `wanted` holds `algorithm`, `query`, `seed` and the planner's parameters.
    pub fn planner(&self, wanted: JsValue) -> Result<RawPlanner, Error> {
        run::start(&self.world, &options(wanted)?).map(RawPlanner::new)
    }

    /// Starts a run that continues with a roadmap, in its JSON or its binary form; the same options, except that the planner is
    /// the one that built it.
    pub fn resume(&self, roadmap: &[u8], wanted: JsValue) -> Result<RawPlanner, Error> {
        let document = RoadmapDocument::read(roadmap)?;
        run::resume(&self.world, &options(wanted)?, &document).map(RawPlanner::new)
    }

    /// Configurations drawn uniformly, all or only free ones: `dimension` numbers each.
    pub fn sample_configurations(&self, n: f64, seed: f64, is_free: bool) -> Result<Vec<f64>, Error> {
        self.inspector.samples(count(n, "n")?, count(seed, "seed")?, is_free)
    }

    /// An empty index of configurations; `wanted` holds `index` and the parameters of that.
    pub fn neighbours(&self, wanted: JsValue) -> Result<RawNeighbours, Error> {
        let (id, parameters) = split::<String>(wanted, "index")?;
        neighbours::index(&self.world, id.as_deref(), &parameters).map(RawNeighbours)
    }

    /// Starts a drive from `q`, or if it is empty from the start of the first query.
    pub fn drive(&self, q: &[f64]) -> Result<RawDrive, Error> {
        Drive::new(&self.world, (!q.is_empty()).then_some(q)).map(RawDrive)
    }

    /// A control held for a duration: the obstruction (as in the state of a drive), the seconds that are free, and then the poses.
    pub fn rollout(&self, q: &[f64], v: f64, phi: f64, duration: f64) -> Result<Vec<f64>, Error> {
        let motion = Motion { control: Control { speed: v, steering: phi }, duration };
        let rollout = driving::rollout(&self.world, q, motion)?;
        Ok([&[obstruction(rollout.blocked), rollout.seconds], &rollout.poses.concat()[..]].concat())
    }

    /// Starts a run of inverse kinematics; `wanted` holds `target`, `orientation`, `method`, `start`, `seed` and the
    /// method's parameters.
    pub fn reach(&self, wanted: JsValue) -> Result<RawReach, Error> {
        Solver::new(&self.world, &reach_options(wanted)?).map(RawReach)
    }

    /// The arm after its tip has followed a point from `q`: see `followed`.
    pub fn follow(&self, q: &[f64], point: &[f64], orientation: Option<f64>) -> Result<Vec<f64>, Error> {
        follow(arm_of(self.world.scenario())?, q, target(point, orientation)).map(followed)
    }

    /// How near the arm can come to a point: see `near`.
    pub fn nearest_reachable(&self, point: &[f64], orientation: Option<f64>) -> Result<Vec<f64>, Error> {
        nearest_reachable(arm_of(self.world.scenario())?, target(point, orientation)).map(near)
    }
}

getters! { RawScenario(self)
    name: String = self.world.scenario().name().to_owned();
    /// The title for people.
    title: String = self.world.scenario().title().to_owned();
    /// The type of the robot, as in documents.
    robot: String = self.world.scenario().robot().kind().to_owned();
    /// Numbers per configuration.
    dimension: usize = self.inspector.dimension();
    /// The scenario as a document, normalised.
    document: JsValue = record(self.world.scenario());
    /// The box to draw: min x, min y, max x, max y.
    extent: Vec<f64> = {
        let extent = self.inspector.extent();
        vec![extent.min.x, extent.min.y, extent.max.x, extent.max.y]
    };
    /// For every coordinate 1 if it wraps, else 0.
    circles: Vec<u8> = self.inspector.circles().into_iter().map(u8::from).collect();
}
