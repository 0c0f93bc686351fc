//! The types that a scenario document is read into, and that the JSON Schema is generated from: fields, their types, and
//! the ranges of numbers. [`validate`](super::validate) checks the remaining rules.

use super::number::{
    AngleOrCoordinate, Coordinate, JointAngle, JointLimit, MapCoordinate, MapScale, Margin, NonNegative, Positive,
    Speed, SteeringAngle, Step, Width,
};
use crate::json::{by_type, objects, one_format};
#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;

objects! {
    /// A motion planning scenario: a world, a robot in it, and queries. Lengths in metres, angles in radians,
    /// counter-clockwise, y up.
    #[cfg_attr(feature = "schema", schemars(title = "Planarium scenario"))]
    #[cfg_attr(target_arch = "wasm32", tsify(rename = "ScenarioDocument"))]
    pub(crate) struct Document {
        /// The format of the document.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "\"planarium-scenario-1\""))]
        pub format: Format,
        /// The name, used in results.
        #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
        pub name: String,
        /// The title for people.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        pub title: Option<String>,
        /// The way to the coordinates of the map that the world was read from. No planner reads it; absent if they are the same.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        pub frame: Option<MapFrame>,
        /// The bounds and obstacles.
        pub world: World,
        /// The robot.
        pub robot: Robot,
        /// The queries; names are distinct.
        pub queries: Vec<Query>,
    }

    /// The way to the coordinates of a map: `offset` was subtracted from its metres.
    pub(crate) struct MapFrame {
        /// What was subtracted from every coordinate of the map, in metres.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "Point"))]
        pub offset: [MapCoordinate; 2],
        /// Of a map whose coordinates are not metres, the way to them.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        pub plane: Option<MapPlane>,
    }

    /// Metres are coordinates of the map less `origin`, times `scale`, for each axis.
    pub(crate) struct MapPlane {
        /// What is subtracted from coordinates of the map.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "Point"))]
        pub origin: [MapCoordinate; 2],
        /// Metres per unit of the map.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "Point"))]
        pub scale: [MapScale; 2],
        /// Whether coordinates of the map are longitude and latitude, in degrees.
        pub degrees: bool,
    }

    /// Bounds and obstacles. Only an arm needs no bounds.
    pub(crate) struct World {
        /// The closed box that the whole robot stays in; it may touch it. Required for all but an arm.
        #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "Box"))]
        pub bounds: Option<Bounds>,
        /// Closed obstacles: touching one is collision. All polygons, holes and walls together have at most 1000000 vertices.
        #[cfg_attr(feature = "schema", schemars(length(max = 100000)))]
        pub obstacles: Vec<Obstacle>,
    }

    /// A box; min is less than max in both coordinates.
    #[cfg_attr(target_arch = "wasm32", tsify(rename = "Box"))]
    pub(crate) struct Bounds {
        /// The corner with the smallest coordinates.
        pub min: Point,
        /// The corner with the largest coordinates.
        pub max: Point,
    }

    pub(crate) struct Disc {
        /// The centre.
        pub center: Point,
        /// The radius in metres.
        pub radius: Positive,
    }

    pub(crate) struct Wall {
        /// The points that the wall joins by straight segments, in order; at least two differ. It may cross itself. As for
        /// vertices of polygons, a coordinate is 0 or at least 1e-140 in magnitude.
        #[cfg_attr(feature = "schema", schemars(length(min = 2)))]
        pub points: Vec<Point>,
        /// The width in metres: the wall is all within half of it from the segments, with round ends and joints. 0 makes it a
        /// line.
        pub width: Width,
        /// Whether the last point is joined to the first. What a closed wall encloses is free.
        #[serde(default)]
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        pub closed: bool,
    }

    #[cfg_attr(feature = "schema", schemars(rename = "PolygonObstacle"))]
    #[cfg_attr(target_arch = "wasm32", tsify(rename = "PolygonObstacle"))]
    pub(crate) struct PolygonObstacle {
        /// The corners in order; at least three differ, edges do not touch or cross. A coordinate is 0 or at least 1e-140 in
        /// magnitude: for smaller ones orientations cannot be computed exactly.
        #[cfg_attr(feature = "schema", schemars(length(min = 3)))]
        pub vertices: Vec<Point>,
        /// The holes, each a simple polygon within the outline, in either direction, open or closed: the inside of a hole is
        /// free. Holes lie outside each other; rings may touch in single points.
        #[serde(default)]
        #[cfg_attr(feature = "schema", schemars(inner(length(min = 3))))]
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        pub holes: Vec<Vec<Point>>,
    }

    pub(crate) struct Polygon {
        /// The corners in order; at least three differ, edges do not touch or cross. A coordinate is 0 or at least 1e-140 in
        /// magnitude: for smaller ones orientations cannot be computed exactly.
        #[cfg_attr(feature = "schema", schemars(length(min = 3)))]
        pub vertices: Vec<Point>,
    }

    pub(crate) struct Arm {
        /// The position of the base; no obstacle may lie within `radius` of it.
        pub base: Point,
        /// The lengths of the links in metres, from the base outwards; a prismatic link has this length at the coordinate 0.
        #[cfg_attr(feature = "schema", schemars(length(min = 1, max = 8)))]
        pub links: Vec<Positive>,
        /// Half the width of the links in metres; 0 makes them segments.
        #[serde(default)]
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        pub radius: NonNegative,
        /// One pair (low, high) per link, low less than high, in radians: such a joint does not wrap. Without limits a joint is
        /// a circle. Not together with `joints`.
        #[cfg_attr(feature = "schema", schemars(length(min = 1, max = 8)))]
        #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "Point[]"))]
        pub joint_limits: Option<Vec<[JointLimit; 2]>>,
        /// How each link moves against the one before, one joint per link; if absent all are revolute.
        #[cfg_attr(feature = "schema", schemars(length(min = 1, max = 8), with = "Option<Vec<JointOrWord>>"))]
        #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "(\"revolute\" | Joint)[]"))]
        pub joints: Option<Vec<Value>>,
        /// By how much the robot is planned for as larger on all sides, in metres; 0 by default.
        #[serde(default)]
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        pub margin: Margin,
    }

    /// A joint that turns: its coordinate is the angle of its link to the link before, in radians.
    pub(crate) struct Revolute {
        /// The least and the greatest angle, the first less than the second; without limits the joint is a circle.
        #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "Point"))]
        pub limits: Option<[JointLimit; 2]>,
    }

    /// A joint that slides: its link goes on in the direction of the link before, turned by a fixed angle, and is its length
    /// plus the coordinate long.
    pub(crate) struct Prismatic {
        /// The least and the greatest coordinate in metres, the first less than the second; the link is nowhere shorter than 0.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "Point"))]
        pub range: [Coordinate; 2],
        /// The fixed angle to the link before, in radians; 0 by default.
        #[serde(default)]
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        pub angle: JointAngle,
    }

    pub(crate) struct RigidBody {
        /// The shape in its own frame.
        pub shape: Shape,
        /// The metric of placements.
        #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "Weights"))]
        pub metric: Option<Metric>,
        /// By how much the robot is planned for as larger on all sides, in metres; 0 by default.
        #[serde(default)]
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        pub margin: Margin,
    }

    pub(crate) struct Car {
        /// The shape about the middle of the rear axle; x is forward.
        pub shape: Shape,
        /// The distance between the axles in metres.
        pub wheelbase: Positive,
        /// The least and the greatest speed in metres per second, the first less than the second.
        pub speed: [Speed; 2],
        /// The least and the greatest steering angle in radians, the first less than the second.
        pub steering: [SteeringAngle; 2],
        /// The step in which durations are counted, in seconds; 0.01 by default.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        pub integration_step: Option<Step>,
        /// The metric of placements.
        #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "Weights"))]
        pub metric: Option<Metric>,
        /// By how much the robot is planned for as larger on all sides, in metres; 0 by default.
        #[serde(default)]
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        pub margin: Margin,
    }

    #[cfg_attr(feature = "schema", schemars(rename = "DiscRobot"))]
    pub(crate) struct DiscRobot {
        /// The radius in metres; 0 makes it a point.
        pub radius: NonNegative,
        /// By how much the robot is planned for as larger on all sides, in metres; 0 by default.
        #[serde(default)]
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        pub margin: Margin,
    }

    /// The weights of a metre and a radian in the distance between two placements; 0.7 and 0.3 by default.
    #[cfg_attr(target_arch = "wasm32", tsify(rename = "Weights"))]
    pub(crate) struct Metric {
        /// The weight of a metre.
        pub translation: Positive,
        /// The weight of a radian.
        pub rotation: Positive,
    }

    /// One query, with a goal or a target.
    //
    // Fields for some robots only are read once the robot is known: for another one they are refused whatever they contain.
    #[cfg_attr(
        feature = "schema",
        schemars(extend("oneOf" = [{ "required": ["goal"] }, { "required": ["target"] }]))
    )]
    pub(crate) struct Query {
        /// The name, distinct within the scenario.
        #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
        pub name: String,
        /// The configuration to start from: angles in any number of turns up to 1e6 radians, within the limits if the joint
        /// has limits; coordinates in metres.
        #[cfg_attr(feature = "schema", schemars(length(min = 1, max = 8)))]
        pub start: Vec<AngleOrCoordinate>,
        /// The configuration to reach: exactly, unless there is a tolerance.
        #[cfg_attr(feature = "schema", schemars(length(min = 1, max = 8)))]
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        pub goal: Option<Vec<AngleOrCoordinate>>,
        /// The target of the end effector of an arm, instead of a goal.
        #[cfg_attr(feature = "schema", schemars(with = "Option<Target>"))]
        #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "Target"))]
        pub target: Option<Value>,
        /// The goal region. Planners that grow by controls require it.
        #[cfg_attr(feature = "schema", schemars(with = "Option<GoalTolerance>"))]
        #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "GoalTolerance"))]
        pub goal_tolerance: Option<Value>,
    }

    /// A target of the end effector: any configuration that reaches it is a goal.
    pub(crate) struct Target {
        /// The position of the tip.
        pub point: Point,
        /// The angle of the last link in the world, in radians; any angle if it is absent.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        pub orientation: Option<AngleOrCoordinate>,
    }

    /// A goal region: both bounds must hold. Bodies and cars need both; a disc has no rotation, an arm no translation unless a
    /// link slides.
    pub(crate) struct GoalTolerance {
        /// The largest distance, in metres; of an arm the farthest that each prismatic joint may be from its goal.
        #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number"))]
        pub translation: Option<NonNegative>,
        /// The largest turn, in radians; of an arm the most that each revolute joint may be from its goal.
        #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number"))]
        pub rotation: Option<NonNegative>,
    }
}

one_format!(pub(crate) enum Format = "planarium-scenario-1");

/// A point [x, y] in metres.
#[derive(Deserialize, Clone, Copy)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub(crate) struct Point(pub Coordinate, pub Coordinate);

/// A closed obstacle.
#[cfg_attr(feature = "schema", derive(JsonSchema), schemars(tag = "type", rename_all = "snake_case"))]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), serde(tag = "type", rename_all = "snake_case"))]
pub(crate) enum Obstacle {
    /// A disc.
    Disc(Disc),
    /// A simple polygon, convex or concave, in either direction, open or closed, with or without holes.
    Polygon(PolygonObstacle),
    /// A polyline or a ring with a width.
    Wall(Wall),
}

by_type!(Obstacle { "disc" => Disc, "polygon" => Polygon, "wall" => Wall });

/// The robot.
#[cfg_attr(feature = "schema", derive(JsonSchema), schemars(tag = "type", rename_all = "snake_case"))]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), serde(tag = "type", rename_all = "snake_case"))]
pub(crate) enum Robot {
    /// A planar arm. A configuration contains one number per link: its angle to the link before, or what a prismatic link is
    /// longer than its given length.
    Arm(Arm),
    /// A polygon that translates and rotates. A configuration is [x, y, theta], the position and rotation of its frame.
    RigidBody(RigidBody),
    /// A first-order car. A configuration is [x, y, theta], the position of its rear axle and its heading; a control is a
    /// speed and a steering angle.
    Car(Car),
    /// A disc that translates. A configuration is its centre [x, y].
    Disc(DiscRobot),
}

by_type!(Robot { "arm" => Arm, "disc" => Disc, "rigid_body" => RigidBody, "car" => Car });

/// A joint of an arm.
#[cfg_attr(feature = "schema", derive(JsonSchema), schemars(tag = "type", rename_all = "snake_case"))]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), serde(tag = "type", rename_all = "snake_case"))]
pub(crate) enum Joint {
    /// A joint that turns.
    Revolute(Revolute),
    /// A joint that slides.
    Prismatic(Prismatic),
}

by_type!(Joint { "revolute" => Revolute, "prismatic" => Prismatic });

/// A joint of an arm, or the word "revolute".
#[cfg(feature = "schema")]
#[derive(JsonSchema)]
#[schemars(untagged)]
#[expect(dead_code, reason = "it is for the schema alone")]
enum JointOrWord {
    Word(Turning),
    Joint(Joint),
}

/// A joint that turns without limits.
#[cfg(feature = "schema")]
#[derive(JsonSchema)]
#[schemars(rename_all = "snake_case")]
#[expect(dead_code, reason = "it is for the schema alone")]
enum Turning {
    Revolute,
}

/// The shape of a body in its own frame.
#[cfg_attr(feature = "schema", derive(JsonSchema), schemars(tag = "type", rename_all = "snake_case"))]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), serde(tag = "type", rename_all = "snake_case"))]
pub(crate) enum Shape {
    /// A simple polygon, convex or concave, in either direction, open or closed.
    Polygon(Polygon),
}

by_type!(Shape { "polygon" => Polygon });
