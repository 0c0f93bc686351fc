//! A scenario for JavaScript.

use super::arguments::{choice, count, document, fields, finite, row, rows, text, text_or_bytes};
use super::records::{Check, QueryCheck, Rollout, object, record, with_configuration};
use super::types::{
    Booleans, CertifyOptions, CspaceOptions, GenerateOptions, GeneratorName, JsBox, JsConfiguration, JsDocument,
    JsNumber, JsPair, JsPoint, JsText, JsWay, NeighboursOptions, OptimumOptions, PlannerOptions, ResumeOptions,
    RoadmapFile, RobotType, RolloutOptions, Rows, SampleOptions, ScenarioInput, ShortestPathsOptions, TwoRanges,
};
use super::{drive, neighbours, planner, shortest_paths, subdivision};
use crate::Error;
use crate::certificate;
use crate::driving;
use crate::geometry::Point;
use crate::ik::{self, Target, arm_of};
use crate::optimum::{self, Optimum};
use crate::options::Options;
use crate::problem::{Control, Motion};
use crate::robot::Part;
use crate::run;
use crate::run::inspect::{Clearance, Inspector};
use crate::run::storage::RoadmapDocument;
use crate::scenario;
use crate::world::PlanningWorld;
use crate::worlds;
use tsify::Ts;
use wasm_bindgen::prelude::*;

/// A checked scenario: a world, a robot in it, and queries; `Scenario.parse` and `Scenario.generate` make it. It answers
/// questions about configurations and motions, and starts planners. Lengths are in metres, angles in radians, counter-clockwise,
/// y up.
#[wasm_bindgen]
pub struct Scenario {
    pub(super) world: PlanningWorld,
    inspector: Inspector,
}

impl Scenario {
    fn new(scenario: scenario::Scenario) -> Self {
        let world = PlanningWorld::new(scenario);
        let inspector = Inspector::new(&world);
        Self { world, inspector }
    }

    pub(super) fn scenario(&self) -> &scenario::Scenario {
        self.world.scenario()
    }

    fn configuration(&self, q: &JsConfiguration, name: &str) -> Result<Vec<f64>, Error> {
        row(q, self.dimension(), name)
    }
}

/// A target from its point and orientation.
fn target(point: &JsPoint, orientation: Option<JsNumber>) -> Result<Target, Error> {
    let point = row(point, 2, "target")?;
    let orientation = orientation.map(|angle| finite(&angle, "orientation")).transpose()?;
    Ok(Target { point: Point::new(point[0], point[1]), orientation })
}

#[wasm_bindgen]
impl Scenario {
    /// Reads a scenario document: JSON text, or the document as an object.
    /// @throws {PlanariumError} with a JSON pointer: `invalid-json`, `unknown-field`, `missing-field`, `wrong-type`,
    /// `out-of-range`, `degenerate-polygon`, `base-in-collision`, ...
    pub fn parse(input: &ScenarioInput) -> Result<Scenario, Error> {
        document(input).map(Self::new)
    }

    /// Generates a scenario from a seed; the same generator, options and seed give the same scenario. `generators()` lists the
    /// generators and their options.
    /// With `ensure` worlds are drawn until one is known to have a path, or none; that takes up to a few seconds.
    /// @throws {PlanariumError} `unknown-generator`, `unknown-field`, `out-of-range`, `wrong-type`, `unknown-type`, `not-finite`;
    /// `unsupported`, `gave-up` of `ensure`
    pub fn generate(kind: &GeneratorName, options: Option<GenerateOptions>) -> Result<Scenario, Error> {
        worlds::generate(&text(kind, "kind")?, &fields(options)?.object()).map(Self::new)
    }

    /// Whether a configuration is free, and every pair that touches if it is not.
    /// @throws {PlanariumError} `wrong-dimension`, `wrong-type`, `not-finite`, `out-of-range`
    pub fn check(&self, q: &JsConfiguration) -> Result<Ts<Check>, Error> {
        let contacts = self.inspector.check(&self.configuration(q, "q")?)?;
        Ok(record(&Check::from(contacts)))
    }

    /// Checks start and goal of a query, the first one by default, before a planner is started: `planner` refuses a query whose
    /// start or goal is in collision.
    /// @throws {PlanariumError} `unknown-query`
    #[wasm_bindgen(js_name = checkQuery)]
    pub fn check_query(&self, name: Option<JsText>) -> Result<Ts<QueryCheck>, Error> {
        let name = name.map(|name| text(&name, "query")).transpose()?;
        let (_, query) = self.scenario().find_query(name.as_deref())?;
        let check = |q: &[f64]| self.inspector.check(q).map(Check::from);
        let goal = query.configuration().map(check).transpose()?;
        Ok(record(&QueryCheck::new(query.name.clone(), check(&query.start)?, goal)))
    }

    /// The part of the robot and the obstacle that are nearest to each other, for viewers; null if the robot touches something,
    /// or if there are no obstacles. The margin of the robot counts as a part of it; the bounds do not count.
    #[wasm_bindgen(unchecked_return_type = "Clearance | null")]
    pub fn clearance(&self, q: &JsConfiguration) -> Result<JsValue, Error> {
        let clearance: Option<Clearance> = self.inspector.clearance(&self.configuration(q, "q")?)?;
        Ok(clearance.map_or(JsValue::NULL, |clearance| object(&clearance)))
    }

    /// The parts of the robot at a configuration, to draw.
    pub fn footprint(&self, q: &JsConfiguration) -> Result<Vec<Ts<Part>>, Error> {
        let parts = self.inspector.footprint(&self.configuration(q, "q")?)?;
        Ok(parts.iter().map(record).collect())
    }

    /// The point of the workspace that represents a configuration: the tip of an arm, the centre of a disc, (x, y) of a body or a
    /// car.
    #[wasm_bindgen(js_name = endEffector)]
    pub fn end_effector(&self, q: &JsConfiguration) -> Result<JsPair, Error> {
        let tip = self.inspector.end_effector(&self.configuration(q, "q")?)?;
        Ok(js_sys::Array::of2(&tip.x.into(), &tip.y.into()).unchecked_into())
    }

    /// The same for rows of `dimension` numbers, in rows of x, y.
    #[wasm_bindgen(js_name = endEffectors)]
    pub fn end_effectors(&self, vertices: &Rows) -> Result<Vec<f64>, Error> {
        let vertices = rows(vertices, self.dimension(), "vertices")?;
        let mut tips = Vec::with_capacity(vertices.len() / self.dimension() * 2);
        for row in vertices.chunks(self.dimension()) {
            let tip = self.inspector.end_effector(row)?;
            tips.extend([tip.x, tip.y]);
        }
        Ok(tips)
    }

    /// The configuration at the fraction `t`, from 0 to 1, of the straight motion from `a` to `b`; circles the short way round.
    /// The way `sign-of-difference` is a faulty one of a course report: as far as the short way, but in the direction of the
    /// plain difference of the angles as they are given. If that is more than half a turn, the motion ends elsewhere than in `b`.
    /// @throws {PlanariumError} `out-of-range`, `not-finite`, `wrong-dimension`, `wrong-type`
    pub fn interpolate(
        &self,
        a: &JsConfiguration,
        b: &JsConfiguration,
        t: &JsNumber,
        way: Option<JsWay>,
    ) -> Result<Vec<f64>, Error> {
        let way = way.map_or(Ok(0), |way| choice(&way, "way", &["short", "sign-of-difference"]))?;
        let [a, b] = [self.configuration(a, "a")?, self.configuration(b, "b")?];
        let interpolate = [Inspector::interpolate, Inspector::interpolate_by_sign][way];
        interpolate(&self.inspector, &a, &b, finite(t, "t")?)
    }

    /// The distance from `a` to `b` in the default metric of the scenario.
    pub fn distance(&self, a: &JsConfiguration, b: &JsConfiguration) -> Result<f64, Error> {
        self.inspector.distance(&self.configuration(a, "a")?, &self.configuration(b, "b")?)
    }

    /// The fraction of the straight motion from `a` to `b` at which the first interval begins that could not be proven free; null
    /// if all of it is proven. For the curves of a car see `rollout`.
    #[wasm_bindgen(js_name = firstHit, unchecked_return_type = "number | null")]
    pub fn first_hit(&self, a: &JsConfiguration, b: &JsConfiguration) -> Result<JsValue, Error> {
        let hit = self.inspector.first_hit(&self.configuration(a, "a")?, &self.configuration(b, "b")?)?;
        Ok(hit.map_or(JsValue::NULL, JsValue::from))
    }

    /// A picture of the configuration space of an arm of two joints: one byte per cell, 1 for collision, checked at the centre of
    /// the cell; row by row from the lowest angles.
    /// @throws {PlanariumError} `unsupported` for any other robot; `out-of-range` for more than 4096 cells per side
    pub fn cspace(&self, size: &CspaceOptions) -> Result<Vec<u8>, Error> {
        let mut fields = fields(Some(size.clone()))?;
        let [width, height] = ["width", "height"].map(|name| fields.required::<u64>(name, "a number of cells"));
        let cells = |count: u64| usize::try_from(count).unwrap_or(usize::MAX);
        self.inspector.configuration_space(cells(width?), cells(height?))
    }

    /// The angles that the picture of `cspace` spans: -pi to pi for a circle, else the limits of the joint.
    /// @throws {PlanariumError} `unsupported` for any robot but an arm of two joints
    #[wasm_bindgen(js_name = cspaceRange)]
    pub fn cspace_range(&self) -> Result<TwoRanges, Error> {
        self.inspector.configuration_space_range().map(|range| object(&range).unchecked_into())
    }

    /// Starts a planner on one of the queries. The planner outlives the scenario.
    /// @throws {PlanariumError} `unknown-planner`, `unknown-query`, `unknown-parameter`, `out-of-range`, `wrong-type`;
    /// `start-in-collision`, `goal-in-collision` (the message names what touches what); `unsupported` if the planner is not for
    /// the robot, or the car cannot follow the curves of `steering`; `missing-field` if a car driven by controls has no
    /// `goal_tolerance`
    pub fn planner(&self, options: Option<PlannerOptions>) -> Result<planner::Planner, Error> {
        let options = fields(options)?.request()?.for_robot(self.scenario().robot())?;
        run::start(&self.world, &options).map(planner::Planner::new)
    }

    /// Continues with a roadmap from `planner.roadmap("json")` or `planner.roadmap("binary")`, of this world and robot: all of it
    /// is proven again, start and goal of the query are connected to it, and it is searched. It does not grow. Options are those
    /// of the search and of the path, `clearanceWeight` among them; `algorithm` is the planner that built it, and may be omitted.
    /// @throws {PlanariumError} `other-scenario` if it belongs to another world or robot; `invalid-roadmap` if it is damaged or
    /// not free; `out-of-range` and `unsupported` for options that contradict it; and those of `planner`
    pub fn resume(&self, roadmap: &RoadmapFile, options: Option<ResumeOptions>) -> Result<planner::Planner, Error> {
        let document = RoadmapDocument::read(&text_or_bytes(roadmap, "roadmap")?)?;
        let options = fields(options)?.request()?.for_roadmap(self.world.scenario(), &document)?;
        run::resume(&self.world, &options, &document).map(planner::Planner::new)
    }

    /// The shortest path of a query, to compare paths with: exact for a disc and a point; for an arm of two joints, and a body
    /// whose query keeps its angle, a reference, which is the length of a proven path on a fine grid.
    /// @throws {PlanariumError} `unsupported` for other robots and for a query with a target; `unknown-query`,
    /// `unknown-parameter`, `out-of-range`, `wrong-type`, `start-in-collision`, `goal-in-collision`
    pub fn optimum(&self, options: Option<OptimumOptions>) -> Result<Ts<Optimum>, Error> {
        let mut fields = fields(options)?;
        let query: Option<String> = fields.take("query")?;
        let metric = Options::read(&fields.parameters())?;
        optimum::optimum(&self.world, query.as_deref(), metric).map(|optimum| record(&optimum))
    }

    /// The world of a disc or a point, prepared for the shortest paths between any two positions. It outlives the scenario.
    /// @throws {PlanariumError} `unsupported` for another robot; `unknown-field`, `wrong-type`
    #[wasm_bindgen(js_name = shortestPaths)]
    pub fn shortest_paths(
        &self,
        options: Option<ShortestPathsOptions>,
    ) -> Result<shortest_paths::ShortestPaths, Error> {
        let mut fields = fields(options)?;
        let many_queries = fields.take("many_queries")?.unwrap_or(false);
        fields.finish("many_queries")?;
        let paths = optimum::ShortestPaths::new(&self.world)?;
        Ok(shortest_paths::ShortestPaths(if many_queries { paths.for_many_queries() } else { paths }))
    }

    /// Starts a subdivision of the configurations of an arm of two links, or of a disc, that decides whether a path of a query
    /// keeps more than a clearance. It outlives the scenario.
    /// @throws {PlanariumError} `unsupported` for another robot, and for a query with a target; `unknown-query`, `out-of-range`,
    /// `not-finite`, `wrong-type`, `unknown-field`; `start-in-collision`, `goal-in-collision`
    pub fn certify(&self, options: Option<CertifyOptions>) -> Result<subdivision::Subdivision, Error> {
        let mut fields = fields(options)?;
        let defaults = certificate::Options::default();
        let options = certificate::Options {
            query: fields.take("query")?,
            clearance: fields.take("clearance")?.unwrap_or(defaults.clearance),
            cells: fields.take("cells")?.unwrap_or(defaults.cells),
        };
        fields.finish("query, clearance, cells")?;
        certificate::Subdivision::new(&self.world, &options).map(subdivision::Subdivision::new)
    }

    /// Makes an empty index of configurations of the robot; `neighbourIndexes()` lists the indexes and their options. It outlives
    /// the scenario.
    /// @throws {PlanariumError} `out-of-range`, `unknown-parameter`, `wrong-type`, `not-finite`
    pub fn neighbours(&self, options: Option<NeighboursOptions>) -> Result<neighbours::Neighbours, Error> {
        let mut fields = fields(options)?;
        let index: Option<String> = fields.take("index")?;
        let options = run::neighbours::IndexOptions::read(index.as_deref(), &fields.parameters())?;
        run::neighbours::index(&self.world, &options).map(neighbours::Neighbours)
    }

    /// Draws `n` configurations uniformly, at most 1,000,000, in rows of `dimension` numbers: those that a planner of this seed
    /// draws with its uniform sampler.
    /// @throws {PlanariumError} `out-of-range`, `not-finite`, `wrong-type`; `unsupported` if 100,000 draws in a row are in
    /// collision
    #[wasm_bindgen(js_name = sampleConfigurations)]
    pub fn sample_configurations(&self, n: &JsNumber, options: Option<SampleOptions>) -> Result<Vec<f64>, Error> {
        let n = count(n, "n")?;
        let mut fields = fields(options)?;
        let (seed, is_free) = (fields.take("seed")?.unwrap_or(0), fields.take("free")?.unwrap_or(false));
        fields.finish("seed, free")?;
        self.inspector.samples(n, seed, is_free)
    }

    /// Starts a drive of the scenario's car from `q`, by default from the start of the first query. The drive outlives the
    /// scenario.
    /// @throws {PlanariumError} `unsupported` for any robot but a car, `start-in-collision`, `unknown-query` if there is neither
    pub fn drive(&self, q: Option<JsConfiguration>) -> Result<drive::Drive, Error> {
        let start = q.map(|q| self.configuration(&q, "q")).transpose()?;
        driving::Drive::new(&self.world, start.as_deref()).map(drive::Drive)
    }

    /// The motion of the car from `q` under one control: speed `v` (metres per second) and steering angle `phi` (radians, to the
    /// left if positive) within the car's limits, for a `duration` (seconds, at most a million steps), as far as it is proven
    /// free. With the integration `euler` the poses follow Euler's steps, each checked and nothing proven.
    /// @throws {PlanariumError} `unsupported` for any robot but a car; `out-of-range`, `not-finite`, `unknown-field`
    pub fn rollout(
        &self,
        q: &JsConfiguration,
        v: &JsNumber,
        phi: &JsNumber,
        duration: &JsNumber,
        options: Option<RolloutOptions>,
    ) -> Result<Ts<Rollout>, Error> {
        let control = Control { speed: finite(v, "v")?, steering: finite(phi, "phi")? };
        let motion = Motion { control, duration: finite(duration, "duration")? };
        let mut fields = fields(options)?;
        let options = driving::RolloutOptions {
            integration: fields.take("integration")?.unwrap_or_default(),
            step: fields.take("dt")?,
        };
        fields.finish("integration, dt")?;
        let rollout = driving::rollout(&self.world, &self.configuration(q, "q")?, motion, options)?;
        Ok(record(&Rollout::from(rollout)))
    }

    /// The arm after its tip has followed a target from `q`: smoothly, within its limits, as near as it gets from there; with an
    /// `orientation`, the wanted absolute angle of the last link, in radians. For dragging: call it with the last configuration
    /// whenever the target moves.
    /// @throws {PlanariumError} `unsupported` for any robot but an arm, `out-of-range` for a `q` outside the limits
    pub fn follow(
        &self,
        q: &JsConfiguration,
        target: &JsPoint,
        orientation: Option<JsNumber>,
    ) -> Result<Ts<ik::Followed>, Error> {
        let arm = arm_of(self.scenario())?;
        let followed = ik::follow(arm, &self.configuration(q, "q")?, self::target(target, orientation)?)?;
        Ok(with_configuration(&followed, &followed.configuration))
    }

    /// The point nearest to a target that the arm's tip can reach, exactly, within the limits; with an `orientation`, the nearest
    /// in that orientation.
    /// @throws {PlanariumError} `unsupported` for any robot but an arm whose links all turn
    #[wasm_bindgen(js_name = nearestReachable)]
    pub fn nearest_reachable(&self, target: &JsPoint, orientation: Option<JsNumber>) -> Result<Ts<ik::Nearest>, Error> {
        let nearest = ik::nearest_reachable(arm_of(self.scenario())?, self::target(target, orientation)?)?;
        Ok(with_configuration(&nearest, &nearest.configuration))
    }
}

members! { Scenario(self): wasm_bindgen(getter);
    /// The name of the scenario.
    name: String = self.scenario().name().to_owned();
    /// The title for people; the name if the document has none.
    title: String = self.scenario().title().to_owned();
    /// The type of the robot.
    robot: RobotType = JsValue::from_str(self.scenario().robot().kind()).unchecked_into();
    /// The degrees of freedom: the length of a configuration.
    dimension: usize = self.inspector.dimension();
}

members! { Scenario(self): wasm_bindgen;
    /// The document, with its defaults written out.
    document: JsDocument = object(self.scenario()).unchecked_into();
    /// The same as `document()`, so that `JSON.stringify(scenario)` writes the document.
    toJSON: JsDocument = self.document();
    /// The box to draw: the bounds, or all obstacles and the reach of the arm.
    extent: JsBox = object(&self.inspector.extent()).unchecked_into();
    /// For each coordinate of a configuration, whether it is a circle: an angle that wraps.
    circles: Booleans = object(&self.inspector.circles()).unchecked_into();
}
