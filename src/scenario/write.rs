//! From a checked scenario back to its document, in one normal form.

use super::parse::FORMAT;
use super::{Goal, GoalTolerance, Node, Obstacle, Query, Robot, Scenario, World};
use crate::geometry::{Aabb, Point, Polygon};
use crate::robot::{Target, Weights};

impl Scenario {
    /// The normalised document: fields in the order of the contract, defaults written out, polygons open,
    /// counter-clockwise and without repeated vertices. It reads back as an equal scenario.
    pub fn to_node(&self) -> Node {
        Node::object(vec![
            ("format", Some(Node::text(FORMAT))),
            ("name", Some(Node::text(&self.name))),
            ("title", self.title.as_deref().map(Node::text)),
            ("world", Some(world(&self.world))),
            ("robot", Some(robot(&self.robot))),
            ("queries", Some(Node::Array(self.queries.iter().map(query).collect()))),
        ])
    }

    /// The normalised document as text, on one line. Equal scenarios give equal text, on every platform.
    pub fn to_json_string(&self) -> String {
        self.to_node().to_json()
    }
}

fn point(p: Point) -> Node {
    Node::numbers(&[p.x, p.y])
}

fn world(world: &World) -> Node {
    let bounds = |Aabb { min, max }| Node::object(vec![("min", Some(point(min))), ("max", Some(point(max)))]);
    Node::object(vec![
        ("bounds", world.bounds.map(bounds)),
        ("obstacles", Some(Node::Array(world.obstacles.iter().map(obstacle).collect()))),
    ])
}

fn obstacle(obstacle: &Obstacle) -> Node {
    match obstacle {
        Obstacle::Disc(disc) => Node::object(vec![
            ("type", Some(Node::text("disc"))),
            ("center", Some(point(disc.center))),
            ("radius", Some(Node::Number(disc.radius))),
        ]),
        Obstacle::Polygon(shape) => polygon(shape),
    }
}

fn robot(robot: &Robot) -> Node {
    match robot {
        Robot::Arm(arm) => {
            let pairs = |limits: &[[f64; 2]]| Node::Array(limits.iter().map(|pair| Node::numbers(pair)).collect());
            Node::object(vec![
                ("type", Some(Node::text("arm"))),
                ("base", Some(point(arm.base()))),
                ("links", Some(Node::numbers(arm.links()))),
                ("radius", Some(Node::Number(arm.radius()))),
                ("joint_limits", arm.joint_limits().map(pairs)),
            ])
        }
        Robot::Disc(disc) => {
            Node::object(vec![("type", Some(Node::text("disc"))), ("radius", Some(Node::Number(disc.radius())))])
        }
        Robot::RigidBody(body) => Node::object(vec![
            ("type", Some(Node::text("rigid_body"))),
            ("shape", Some(polygon(body.shape()))),
            ("metric", Some(weights(body.weights()))),
        ]),
        Robot::Car(car) => Node::object(vec![
            ("type", Some(Node::text("car"))),
            ("shape", Some(polygon(car.shape()))),
            ("wheelbase", Some(Node::Number(car.wheelbase()))),
            ("speed", Some(Node::numbers(&car.speed()))),
            ("steering", Some(Node::numbers(&car.steering()))),
            ("integration_step", Some(Node::Number(car.integration_step()))),
            ("metric", Some(weights(car.weights()))),
        ]),
    }
}

fn polygon(polygon: &Polygon) -> Node {
    Node::object(vec![
        ("type", Some(Node::text("polygon"))),
        ("vertices", Some(Node::Array(polygon.vertices().iter().copied().map(point).collect()))),
    ])
}

fn of_placement(translation: f64, rotation: f64) -> Node {
    let (translation, rotation) = (Node::Number(translation), Node::Number(rotation));
    Node::object(vec![("translation", Some(translation)), ("rotation", Some(rotation))])
}

fn weights(weights: Weights) -> Node {
    of_placement(weights.translation, weights.rotation)
}

fn query(query: &Query) -> Node {
    Node::object(vec![
        ("name", Some(Node::text(&query.name))),
        ("start", Some(Node::numbers(&query.start))),
        ("goal", query.configuration().map(Node::numbers)),
        ("target", if let Goal::Target(at) = &query.goal { Some(target(at)) } else { None }),
        ("goal_tolerance", query.goal_tolerance.map(region)),
    ])
}

fn target(target: &Target) -> Node {
    Node::object(vec![("point", Some(point(target.point))), ("orientation", target.orientation.map(Node::Number))])
}

fn region(region: GoalTolerance) -> Node {
    of_placement(region.translation, region.rotation)
}
