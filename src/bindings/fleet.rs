//! Fleets for JavaScript: several robots that share a floor.

use super::arguments::{cursor, document_tree, fields, not_negative, records, row, size, text};
use super::clock::{Timed, stepped};
use super::digits;
use super::records::{object, record};
use super::types::{
    FleetGeneratorName, FleetInput, FleetOptions, GenerateFleetOptions, JsFleetConflicts, JsFleetDocument,
    JsFleetResult, JsNumber, Rows, Status,
};
use crate::Error;
use crate::error::Code;
use crate::fleet::{self, Blocked, FleetResult, Pose, Trajectory, Verification};
use crate::problem::Stepped;
use crate::robot::Part;
use std::cell::RefCell;
use tsify::Ts;
use wasm_bindgen::prelude::*;

/// A checked fleet: a world, and discs and bodies in it that share its floor, each with a start and a goal. `Fleet.parse` and
/// `Fleet.generate` make it.
#[wasm_bindgen]
pub struct Fleet(fleet::Fleet);

/// An index below a count.
fn index(value: &JsValue, name: &str, count: usize) -> Result<usize, Error> {
    let index = size(value, name)?;
    if index >= count {
        let sentence = format!("there are {count}, and none is number {index}");
        return Err(Error::new(Code::OutOfRange, format!("/{name}"), sentence));
    }
    Ok(index)
}

/// Rows of a time and a pose.
fn rows_of(trajectory: &Trajectory) -> Vec<f64> {
    let rows = trajectory.times().iter().zip(trajectory.poses());
    rows.flat_map(|(time, [x, y, theta])| [*time, *x, *y, *theta]).collect()
}

/// Poses one after another.
fn flat(poses: impl IntoIterator<Item = Pose>) -> Vec<f64> {
    poses.into_iter().flatten().collect()
}

#[wasm_bindgen]
impl Fleet {
    /// Reads the document of a fleet: JSON text, or the document as an object.
    /// @throws {PlanariumError} with a JSON pointer: `invalid-json`, `unknown-field`, `out-of-range`, `unsupported`,
    /// `start-in-collision`, `goal-in-collision`, ...
    pub fn parse(input: &FleetInput) -> Result<Fleet, Error> {
        fleet::Fleet::read(&document_tree(input, "a fleet")?).map(Self)
    }

    /// Generates a fleet from a seed; the same generator, options and seed give the same fleet. `fleetGenerators()` lists the
    /// generators and their options.
    /// @throws {PlanariumError} `unknown-generator`, `unknown-field`, `out-of-range`, `wrong-type`, `not-finite`
    pub fn generate(kind: &FleetGeneratorName, options: Option<GenerateFleetOptions>) -> Result<Fleet, Error> {
        fleet::generate_with(&text(kind, "kind")?, &fields(options)?.parameters()).map(Self)
    }

    /// Starts a planner; `fleetPlanners()` lists them and their options.
    /// @throws {PlanariumError} `unknown-planner`, `unknown-parameter`, `out-of-range`, `wrong-type`, `not-finite`, `unsupported`
    pub fn planner(&self, options: Option<FleetOptions>) -> Result<FleetPlanner, Error> {
        let mut fields = fields(options)?;
        let options = fleet::FleetOptions {
            planner: None,
            seed: fields.take("seed")?.unwrap_or(0),
            order: fields.take("order")?,
        };
        let planner: Option<String> = fields.take("algorithm")?;
        let options = options.with(planner.as_deref(), &fields.parameters())?;
        let planner = fleet::FleetPlanner::new(&self.0, &options)?;
        Ok(FleetPlanner(RefCell::new(Timed::new(planner))))
    }

    /// The parts of a robot at a pose (x, y, theta; theta of a disc is ignored), to draw.
    /// @throws {PlanariumError} `out-of-range`, `wrong-type`, `not-finite`, `wrong-dimension`
    pub fn footprint(&self, robot: &JsNumber, pose: &Rows) -> Result<Vec<Ts<Part>>, Error> {
        let member = &self.0.robots()[index(robot, "robot", self.0.robots().len())?];
        let pose = row(pose, 3, "pose")?;
        Ok(member.footprint(&pose[..member.start.len()]).iter().map(record).collect())
    }

    /// Verifies the result of a planner by other code than the planners': conflicts of robots, and faults of single ones.
    /// @throws {PlanariumError} `invalid-result` if it is not the solved result of this fleet; `wrong-type`, `missing-field`, ...
    pub fn verify(&self, result: &JsFleetResult) -> Result<Ts<Verification>, Error> {
        let result: FleetResult = records(result, "result")?;
        Ok(record(&fleet::verify(&self.0, &result)?))
    }

    /// The conflicts if every robot drove straight to its goal at once, in the order of their times.
    #[wasm_bindgen(js_name = straightConflicts)]
    pub fn straight_conflicts(&self) -> JsFleetConflicts {
        object(&fleet::conflicts(&self.0, &fleet::straight(&self.0))).unchecked_into()
    }
}

members! { Fleet(self): wasm_bindgen(getter);
    /// The name.
    name: String = self.0.name().to_owned();
    /// The title for people; the name if there is none.
    title: String = self.0.title().to_owned();
    /// The number of robots.
    robotCount: usize = self.0.robots().len();
}

members! { Fleet(self): wasm_bindgen;
    /// The normalised document; `JSON.stringify(fleet)` writes it.
    toJSON: JsFleetDocument = object(&self.0).unchecked_into();
}

/// A planner of a fleet, which is stepped; `fleet.planner` makes it. How its iterations are divided into steps does not change
/// the result.
#[wasm_bindgen]
pub struct FleetPlanner(RefCell<Timed<fleet::FleetPlanner>>);

stepped!(FleetPlanner);

members! { FleetPlanner(self): wasm_bindgen(getter);
    /// `solved` once every robot has a trajectory; `exhausted` if there is no plan, for the `reason` of the result.
    status: Status = self.0.borrow().run.status().into();
    /// The number of iterations so far.
    iterations: f64 = self.0.borrow().run.iterations() as f64;
    /// The number of robots that have a trajectory; of `pbs` none, or all.
    planned: usize = self.0.borrow().run.planned();
    /// The number of roadmaps: equal robots share one; of the composite every robot has its own.
    roadmapCount: usize = self.0.borrow().run.roadmap_count();
    /// When the last robot arrives, in seconds; 0 unless solved.
    makespan: f64 = self.0.borrow().run.makespan();
    /// The sum of the arrivals of all robots, in seconds; 0 unless solved.
    sumOfCosts: f64 = self.0.borrow().run.sum_of_costs();
    /// 16 hexadecimal digits over all roadmaps or trees and all trajectories.
    fingerprint: String = digits(self.0.borrow().run.fingerprint());
}

members! { FleetPlanner(self): wasm_bindgen;
    /// The robots in the order in which they plan, by their indices; without priorities, that of the document. A copy.
    order: Vec<u32> = self.0.borrow().run.order().into_iter().map(|robot| robot as u32).collect();
    /// The robot that found no way last, followed by those in its way, by their indices; empty if none is known. A copy.
    blocked: Vec<u32> = {
        let of = |blocked: Blocked| std::iter::once(&blocked.robot).chain(&blocked.by).map(|robot| *robot as u32).collect();
        self.0.borrow().run.blocked().map_or_else(Vec::new, of)
    };
    /// The result document, the one that the command line prints.
    result: Ts<FleetResult> = record(&self.0.borrow().run.result());
}

#[wasm_bindgen]
impl FleetPlanner {
    /// The trajectory of a robot in rows of t, x, y, theta: linear between rows, angles the short way round; the robot stands at
    /// the last forever. Empty before it has planned. A copy.
    /// @throws {PlanariumError} `out-of-range`, `wrong-type`, `not-finite`
    pub fn trajectory(&self, robot: &JsNumber) -> Result<Vec<f64>, Error> {
        let run = &self.0.borrow().run;
        let robot = index(robot, "robot", run.fleet().robots().len())?;
        Ok(run.trajectory(robot).map_or_else(Vec::new, rows_of))
    }

    /// The poses of all robots at a time in seconds, in rows of x, y, theta; of a robot that has not planned, its start.
    /// @throws {PlanariumError} `out-of-range`, `wrong-type`, `not-finite`
    #[wasm_bindgen(js_name = posesAt)]
    pub fn poses_at(&self, time: &JsNumber) -> Result<Vec<f64>, Error> {
        let (time, run) = (not_negative(time, "time")?, &self.0.borrow().run);
        let start = |robot: usize| {
            let start = &run.fleet().robots()[robot].start;
            [start[0], start[1], start.get(2).copied().unwrap_or(0.0)]
        };
        let robots = 0..run.fleet().robots().len();
        Ok(flat(robots.map(|robot| run.trajectory(robot).map_or_else(|| start(robot), |found| found.at(time)))))
    }

    /// The number of the roadmap that a robot plans on.
    /// @throws {PlanariumError} `out-of-range`, `wrong-type`, `not-finite`
    #[wasm_bindgen(js_name = roadmapOf)]
    pub fn roadmap_of(&self, robot: &JsNumber) -> Result<usize, Error> {
        let run = &self.0.borrow().run;
        Ok(run.roadmap_of(index(robot, "robot", run.fleet().robots().len())?))
    }

    /// The vertices of a roadmap from row `row` on, in rows of x, y, theta. A copy.
    /// @throws {PlanariumError} `out-of-range`, `wrong-type`, `not-finite`
    #[wasm_bindgen(js_name = verticesSince)]
    pub fn vertices_since(&self, roadmap: &JsNumber, row: &JsNumber) -> Result<Vec<f64>, Error> {
        let run = &self.0.borrow().run;
        let roadmap = index(roadmap, "roadmap", run.roadmap_count())?;
        let first = cursor(row, run.roadmap_size(roadmap).0)?;
        Ok(flat(run.vertices_since(roadmap, first)))
    }

    /// The edges of a roadmap from row `row` on, two vertex numbers each. A copy.
    /// @throws {PlanariumError} `out-of-range`, `wrong-type`, `not-finite`
    #[wasm_bindgen(js_name = edgesSince)]
    pub fn edges_since(&self, roadmap: &JsNumber, row: &JsNumber) -> Result<Vec<u32>, Error> {
        let run = &self.0.borrow().run;
        let roadmap = index(roadmap, "roadmap", run.roadmap_count())?;
        let first = cursor(row, run.roadmap_size(roadmap).1)?;
        Ok(run.edges_since(roadmap, first).into_iter().flatten().collect())
    }
}
