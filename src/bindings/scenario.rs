//! A scenario in JavaScript's hands.

use super::convert::{count, fields, index_options, options, reach_options, record, throw};
use super::drive::told;
use super::reach::{followed, near, target};
use super::{RawDrive, RawNeighbours, RawPlanner, RawReach};
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

/// A checked scenario and answers about it.
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
    pub fn parse(text: &str) -> Result<RawScenario, JsValue> {
        Scenario::parse(text).map(Self::new).map_err(throw)
    }

    /// Generates a scenario by the generator's id, with options.
    pub fn generate(kind: &str, options: JsValue) -> Result<RawScenario, JsValue> {
        let generated = fields(options).and_then(|options| crate::scenario::generate::generate(kind, &options.into()));
        generated.map(Self::new).map_err(throw)
    }

    /// The name.
    pub fn name(&self) -> String {
        self.world.scenario().name().to_owned()
    }

    /// The title for people.
    pub fn title(&self) -> String {
        self.world.scenario().title().to_owned()
    }

    /// The type of the robot, as in documents.
    pub fn robot(&self) -> String {
        self.world.scenario().robot().kind().to_owned()
    }

    /// Numbers a configuration.
    pub fn dimension(&self) -> usize {
        self.inspector.dimension()
    }

    /// The scenario as a document, normalised.
    pub fn document(&self) -> JsValue {
        record(self.world.scenario())
    }

    /// The box worth drawing: min x, min y, max x, max y.
    pub fn extent(&self) -> Vec<f64> {
        let extent = self.inspector.extent();
        vec![extent.min.x, extent.min.y, extent.max.x, extent.max.y]
    }

    /// For every coordinate 1 where it wraps, else 0.
    pub fn circles(&self) -> Vec<u8> {
        self.inspector.circles().into_iter().map(u8::from).collect()
    }

    /// Each touching pair at `q`: the part, and the number of the obstacle or -1 for the bounds.
    pub fn check(&self, q: &[f64]) -> Result<Vec<i32>, JsValue> {
        let contacts = self.inspector.check(q).map_err(throw)?;
        let touched = |with| if let Touched::Obstacle(i) = with { i as i32 } else { -1 };
        Ok(contacts.iter().flat_map(|contact| [contact.part as i32, touched(contact.with)]).collect())
    }

    /// What of the robot at `q` is nearest to which obstacle: distance, part, obstacle and both points; empty where there is none.
    pub fn clearance(&self, q: &[f64]) -> Result<Vec<f64>, JsValue> {
        let told = |near: Clearance| {
            let [a, b] = near.points;
            vec![near.distance, near.part as f64, near.obstacle as f64, a.x, a.y, b.x, b.y]
        };
        Ok(self.inspector.clearance(q).map_err(throw)?.map_or_else(Vec::new, told))
    }

    /// The parts of the robot at `q`: both ends and the radius of every link of an arm, centre and radius of a disc, the
    /// corners of a body or a car.
    pub fn footprint(&self, q: &[f64]) -> Result<Vec<f64>, JsValue> {
        let mut numbers = Vec::new();
        for part in self.inspector.footprint(q).map_err(throw)? {
            match part {
                Part::Capsule { a, b, radius } => numbers.extend([a.x, a.y, b.x, b.y, radius]),
                Part::Disc { center, radius } => numbers.extend([center.x, center.y, radius]),
                Part::Polygon { vertices } => numbers.extend(vertices.iter().flat_map(|corner| [corner.x, corner.y])),
            }
        }
        Ok(numbers)
    }

    /// The tip of the arm or the centre of the disc at `q`: x, y.
    pub fn end_effector(&self, q: &[f64]) -> Result<Vec<f64>, JsValue> {
        self.inspector.end_effector(q).map(|tip| vec![tip.x, tip.y]).map_err(throw)
    }

    /// The same for rows of configurations: rows of x, y.
    pub fn end_effectors(&self, rows: &[f64]) -> Result<Vec<f64>, JsValue> {
        let mut tips = Vec::with_capacity(rows.len() / self.dimension() * 2);
        for row in rows.chunks(self.dimension()) {
            let tip = self.inspector.end_effector(row).map_err(throw)?;
            tips.extend([tip.x, tip.y]);
        }
        Ok(tips)
    }

    /// The configuration a fraction `t` along the motion from `a` to `b`.
    pub fn interpolate(&self, a: &[f64], b: &[f64], t: f64) -> Result<Vec<f64>, JsValue> {
        self.inspector.interpolate(a, b, t).map_err(throw)
    }

    /// The distance from `a` to `b` in the default metric.
    pub fn distance(&self, a: &[f64], b: &[f64]) -> Result<f64, JsValue> {
        self.inspector.distance(a, b).map_err(throw)
    }

    /// Where the motion from `a` to `b` first cannot be proven free; undefined where all of it is proven.
    pub fn first_hit(&self, a: &[f64], b: &[f64]) -> Result<Option<f64>, JsValue> {
        self.inspector.first_hit(a, b).map_err(throw)
    }

    /// The configuration space of an arm of two links, one byte a cell, 1 for collision.
    pub fn cspace(&self, width: f64, height: f64) -> Result<Vec<u8>, JsValue> {
        let [width, height] = [count(width, "width"), count(height, "height")].map(|cells| cells.map_err(throw));
        let (width, height) = (width?, height?);
        // A width beyond what this machine can count is beyond the limit too.
        let cells = |count: u64| usize::try_from(count).unwrap_or(usize::MAX);
        self.inspector.configuration_space(cells(width), cells(height)).map_err(throw)
    }

    /// The angles that it shows: low and high of the first joint, then of the second.
    pub fn cspace_range(&self) -> Result<Vec<f64>, JsValue> {
        self.inspector.configuration_space_range().map(|range| range.concat()).map_err(throw)
    }

    /// Begins a run; `wanted` holds `algorithm`, `query`, `seed` and the planner's parameters.
    pub fn planner(&self, wanted: JsValue) -> Result<RawPlanner, JsValue> {
        let run = options(wanted).and_then(|wanted| run::start(&self.world, &wanted));
        run.map(RawPlanner::new).map_err(throw)
    }

    /// Begins a run that goes on with a roadmap, in its JSON or its binary form; the same options, but that the planner is
    /// the one that built it.
    pub fn resume(&self, roadmap: &[u8], wanted: JsValue) -> Result<RawPlanner, JsValue> {
        let run = RoadmapDocument::read(roadmap).and_then(|document| {
            let wanted = options(wanted)?;
            run::resume(&self.world, &wanted, &document)
        });
        run.map(RawPlanner::new).map_err(throw)
    }

    /// Configurations drawn uniformly, all or only free ones: `dimension` numbers each.
    pub fn sample_configurations(&self, n: f64, seed: f64, is_free: bool) -> Result<Vec<f64>, JsValue> {
        let [n, seed] = [count(n, "n"), count(seed, "seed")].map(|number| number.map_err(throw));
        self.inspector.samples(n?, seed?, is_free).map_err(throw)
    }

    /// An empty index of configurations; `wanted` holds `index` and the parameters of that.
    pub fn neighbours(&self, wanted: JsValue) -> Result<RawNeighbours, JsValue> {
        let index = index_options(wanted)
            .and_then(|(id, parameters)| neighbours::index(&self.world, id.as_deref(), &parameters));
        index.map(RawNeighbours::new).map_err(throw)
    }

    /// Begins a drive from `q`, or where it is empty from the start of the first query.
    pub fn drive(&self, q: &[f64]) -> Result<RawDrive, JsValue> {
        let start = (!q.is_empty()).then_some(q);
        Drive::new(&self.world, start).map(RawDrive::new).map_err(throw)
    }

    /// One control held for a while: what blocks it (as in the state of a drive), for how long it is free, and then the poses.
    pub fn rollout(&self, q: &[f64], v: f64, phi: f64, duration: f64) -> Result<Vec<f64>, JsValue> {
        let motion = Motion { control: Control { speed: v, steering: phi }, duration };
        let rollout = driving::rollout(&self.world, q, motion).map_err(throw)?;
        let mut numbers = vec![told(rollout.blocked), rollout.seconds];
        numbers.extend(rollout.poses.concat());
        Ok(numbers)
    }

    /// Begins a run of inverse kinematics; `wanted` holds `target`, `orientation`, `method`, `start`, `seed` and the
    /// method's parameters.
    pub fn reach(&self, wanted: JsValue) -> Result<RawReach, JsValue> {
        let reach = reach_options(wanted).and_then(|wanted| Solver::new(&self.world, &wanted));
        reach.map(RawReach::new).map_err(throw)
    }

    /// Where the arm goes from `q` when its tip follows a point: see `followed`.
    pub fn follow(&self, q: &[f64], point: &[f64], orientation: Option<f64>) -> Result<Vec<f64>, JsValue> {
        let arm = arm_of(self.world.scenario()).and_then(|arm| follow(arm, q, target(point, orientation)));
        arm.map(|arm| followed(&arm, self.dimension())).map_err(throw)
    }

    /// How near the arm can come to a point: see `near`.
    pub fn nearest_reachable(&self, point: &[f64], orientation: Option<f64>) -> Result<Vec<f64>, JsValue> {
        let nearest = arm_of(self.world.scenario()).and_then(|arm| nearest_reachable(arm, target(point, orientation)));
        nearest.map(|nearest| near(&nearest, self.dimension())).map_err(throw)
    }
}
