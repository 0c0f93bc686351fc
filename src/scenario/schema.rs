//! The JSON Schema of the scenario document, generated from types that mirror it field by field.
//!
//! A schema can say what fields there are, of what type and within which ranges. What needs more (simple polygons, distinct
//! names, dimensions, a free base) only [`Scenario::parse`](super::Scenario::parse) can say.

#![allow(dead_code)] // The types below are only looked at by the generator of the schema.

use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};

/// The JSON Schema (draft 2020-12) of the documents that `Scenario::parse` accepts.
pub fn schema() -> serde_json::Value {
    let settings = SchemaSettings::draft2020_12().with_transform(RecursiveTransform(tidy));
    settings.into_generator().into_root_schema_for::<ScenarioDocument>().to_value()
}

/// Takes out what the types of Rust bring along: the default of what may be absent, which is no value; formats of numbers,
/// which JSON does not have; and the line breaks of comments.
fn tidy(schema: &mut Schema) {
    if schema.get("default").is_some_and(serde_json::Value::is_null) {
        schema.remove("default");
    }
    if schema.get("type").is_some_and(|kind| kind == "number") {
        schema.remove("format");
    }
    if let Some(serde_json::Value::String(text)) = schema.get_mut("description") {
        *text = text.replace('\n', " ");
    }
}

/// A motion planning scenario: a world, a robot in it, and questions. Lengths in metres, angles in radians,
/// counter-clockwise, y up.
#[derive(JsonSchema)]
#[schemars(title = "Planarium scenario", deny_unknown_fields)]
struct ScenarioDocument {
    /// Which contract the document follows.
    #[schemars(schema_with = "format")]
    format: String,
    /// The name, used in results.
    #[schemars(length(min = 1))]
    name: String,
    /// The title for people.
    #[schemars(default, schema_with = "text")]
    title: Option<String>,
    /// Where the robot moves.
    world: WorldDocument,
    /// Who moves.
    robot: RobotDocument,
    /// From where to where; names are distinct.
    queries: Vec<QueryDocument>,
}

/// Bounds and obstacles. Only an arm can do without bounds.
#[derive(JsonSchema)]
#[schemars(rename = "World", deny_unknown_fields)]
struct WorldDocument {
    /// The closed box that the whole robot stays in; it may touch it. Required for all but an arm.
    #[schemars(default, schema_with = "bounds")]
    bounds: Option<BoundsDocument>,
    /// Closed, filled obstacles: touching one is collision. All polygons together have at most 100000 vertices.
    #[schemars(length(max = 10000))]
    obstacles: Vec<ObstacleDocument>,
}

/// A box; min is less than max in both coordinates.
#[derive(JsonSchema)]
#[schemars(rename = "Bounds", deny_unknown_fields)]
struct BoundsDocument {
    /// The corner with the smallest coordinates.
    min: PointDocument,
    /// The corner with the largest coordinates.
    max: PointDocument,
}

/// A point [x, y] in metres.
#[derive(JsonSchema)]
#[schemars(rename = "Point")]
struct PointDocument(Coordinate, Coordinate);

/// A coordinate in metres.
#[derive(JsonSchema)]
struct Coordinate(#[schemars(range(min = -1e6, max = 1e6))] f64);

/// A closed, filled obstacle.
#[derive(JsonSchema)]
#[schemars(rename = "Obstacle", tag = "type", rename_all = "snake_case", deny_unknown_fields)]
enum ObstacleDocument {
    /// A disc.
    Disc {
        /// The centre.
        center: PointDocument,
        /// The radius in metres.
        #[schemars(schema_with = "positive")]
        radius: f64,
    },
    /// A simple polygon, convex or concave, in either direction, open or closed.
    Polygon {
        /// The corners in order; at least three differ, edges do not touch or cross.
        #[schemars(length(min = 3))]
        vertices: Vec<PointDocument>,
    },
}

/// The robot.
#[derive(JsonSchema)]
#[schemars(rename = "Robot", tag = "type", rename_all = "snake_case", deny_unknown_fields)]
enum RobotDocument {
    /// A planar arm of revolute joints. A configuration holds one angle a link, each relative to the link before.
    Arm {
        /// Where the arm is fixed; no obstacle may lie within `radius` of it.
        base: PointDocument,
        /// The lengths of the links in metres, from the base outwards.
        #[schemars(length(min = 1, max = 8), schema_with = "links")]
        links: Vec<f64>,
        /// Half the width of the links in metres; 0 makes them segments.
        #[schemars(default, schema_with = "radius")]
        radius: f64,
        /// One pair (low, high) a link, low less than high, in radians: such a joint does not wrap. Without limits a joint is
        /// a circle.
        #[schemars(default, schema_with = "joint_limits")]
        joint_limits: Option<Vec<(f64, f64)>>,
    },
    /// A polygon that translates and turns. A configuration is [x, y, theta], which places its frame.
    RigidBody {
        /// The shape in its own frame.
        shape: ShapeDocument,
        /// How placements are measured.
        #[schemars(default, schema_with = "metric")]
        metric: Option<MetricDocument>,
    },
    /// A first-order car. A configuration is [x, y, theta], the place of its rear axle and its heading; a control is a speed
    /// and a steering angle.
    Car {
        /// The shape about the middle of the rear axle; x is forward.
        shape: ShapeDocument,
        /// The distance between the axles in metres.
        #[schemars(schema_with = "positive")]
        wheelbase: f64,
        /// The least and the greatest speed in metres a second, the first less than the second.
        #[schemars(schema_with = "speeds")]
        speed: (f64, f64),
        /// The least and the greatest steering angle in radians, the first less than the second.
        #[schemars(schema_with = "angles")]
        steering: (f64, f64),
        /// The step in which durations are counted, in seconds; 0.01 where it is absent.
        #[schemars(default, schema_with = "step")]
        integration_step: Option<f64>,
        /// How placements are measured.
        #[schemars(default, schema_with = "metric")]
        metric: Option<MetricDocument>,
    },
    /// A disc that translates. A configuration is its centre [x, y].
    Disc {
        /// The radius in metres; 0 makes it a point.
        #[schemars(schema_with = "radius")]
        radius: f64,
    },
}

/// The shape of a body in its own frame.
#[derive(JsonSchema)]
#[schemars(rename = "Shape", tag = "type", rename_all = "snake_case", deny_unknown_fields)]
enum ShapeDocument {
    /// A simple polygon, convex or concave, in either direction, open or closed.
    Polygon {
        /// The corners in order; at least three differ, edges do not touch or cross.
        #[schemars(length(min = 3))]
        vertices: Vec<PointDocument>,
    },
}

/// What a metre and a radian count in the distance between two placements; 0.7 and 0.3 where it is absent.
#[derive(JsonSchema)]
#[schemars(rename = "Metric", deny_unknown_fields)]
struct MetricDocument {
    /// What a metre counts.
    #[schemars(schema_with = "positive")]
    translation: f64,
    /// What a radian counts.
    #[schemars(schema_with = "positive")]
    rotation: f64,
}

/// How near to the goal is near enough: both must hold.
#[derive(JsonSchema)]
#[schemars(rename = "GoalTolerance", deny_unknown_fields)]
struct GoalToleranceDocument {
    /// How far away at most, in metres.
    #[schemars(schema_with = "radius")]
    translation: f64,
    /// Turned by how much at most, in radians.
    #[schemars(schema_with = "radius")]
    rotation: f64,
}

/// Where an end effector is to be: any configuration that reaches it will do.
#[derive(JsonSchema)]
#[schemars(rename = "Target", deny_unknown_fields)]
struct TargetDocument {
    /// Where the tip is to be.
    point: PointDocument,
    /// The angle of the last link in the world, in radians; any where it is absent.
    #[schemars(default, schema_with = "angle")]
    orientation: Option<f64>,
}

/// One question, with a goal or a target.
#[derive(JsonSchema)]
#[schemars(rename = "Query", deny_unknown_fields, extend("oneOf" = [{ "required": ["goal"] }, { "required": ["target"] }]))]
struct QueryDocument {
    /// The name, distinct within the scenario.
    #[schemars(length(min = 1))]
    name: String,
    /// The configuration to start from: angles in any number of turns up to 1e6 radians, within their limits where the joint
    /// has limits; coordinates in metres.
    #[schemars(length(min = 1, max = 8), inner(range(min = -1e6, max = 1e6)))]
    start: Vec<f64>,
    /// The configuration to reach, exactly but for a body or a car with a tolerance.
    #[schemars(default, schema_with = "configuration")]
    goal: Option<Vec<f64>>,
    /// Where the end effector of an arm is to be, in place of a goal.
    #[schemars(default, schema_with = "target")]
    target: Option<TargetDocument>,
    /// How near to the goal is near enough; for bodies and cars only.
    #[schemars(default, schema_with = "goal_tolerance")]
    goal_tolerance: Option<GoalToleranceDocument>,
}

fn format(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "string", "const": super::FORMAT })
}

fn text(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "string" })
}

fn bounds(generator: &mut SchemaGenerator) -> Schema {
    generator.subschema_for::<BoundsDocument>()
}

fn positive(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "number", "exclusiveMinimum": 0, "maximum": 1e6 })
}

fn radius(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "number", "minimum": 0, "maximum": 1e6 })
}

fn links(generator: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "array", "items": positive(generator) })
}

fn metric(generator: &mut SchemaGenerator) -> Schema {
    generator.subschema_for::<MetricDocument>()
}

fn configuration(_: &mut SchemaGenerator) -> Schema {
    let entry = angle(&mut SchemaGenerator::default());
    json_schema!({ "type": "array", "items": entry, "minItems": 1, "maxItems": 8 })
}

fn angle(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "number", "minimum": -1e6, "maximum": 1e6 })
}

fn target(generator: &mut SchemaGenerator) -> Schema {
    generator.subschema_for::<TargetDocument>()
}

fn goal_tolerance(generator: &mut SchemaGenerator) -> Schema {
    generator.subschema_for::<GoalToleranceDocument>()
}

fn step(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "number", "exclusiveMinimum": 0, "maximum": 10 })
}

fn speeds(_: &mut SchemaGenerator) -> Schema {
    pair(1e6)
}

fn angles(_: &mut SchemaGenerator) -> Schema {
    pair(1.55)
}

fn pair(most: f64) -> Schema {
    let limit = json_schema!({ "type": "number", "minimum": -most, "maximum": most });
    json_schema!({ "type": "array", "prefixItems": [limit, limit], "minItems": 2, "maxItems": 2 })
}

fn joint_limits(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "array", "items": pair(100.0), "minItems": 1, "maxItems": 8 })
}
