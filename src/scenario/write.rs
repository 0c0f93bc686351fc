//! From a checked scenario back to its document, in one normal form.

use super::parse::FORMAT;
use super::{Node, Obstacle, Query, Robot, Scenario, World};
use crate::geometry::{Aabb, Point};

impl Scenario {
    /// The normalised document: fields in the order of the contract, defaults written out, polygons open,
    /// counter-clockwise and without repeated vertices. It reads back as an equal scenario.
    pub fn to_node(&self) -> Node {
        let mut fields = vec![field("format", text(FORMAT)), field("name", text(&self.name))];
        fields.extend(self.title.as_deref().map(|title| field("title", text(title))));
        fields.push(field("world", world(&self.world)));
        fields.push(field("robot", robot(&self.robot)));
        fields.push(field("queries", Node::Array(self.queries.iter().map(query).collect())));
        Node::Object(fields)
    }

    /// The normalised document as a value of serde_json, which sorts the fields by name.
    pub fn to_json(&self) -> serde_json::Value {
        serde_json::to_value(self.to_node()).expect("a tree of strings and finite numbers is JSON")
    }

    /// The normalised document as text, on one line. Equal scenarios give equal text, on every platform.
    pub fn to_json_string(&self) -> String {
        serde_json::to_string(&self.to_node()).expect("a tree of strings and finite numbers is JSON")
    }
}

fn field(name: &str, value: Node) -> (String, Node) {
    (name.to_owned(), value)
}

fn text(value: &str) -> Node {
    Node::String(value.to_owned())
}

fn numbers(values: impl IntoIterator<Item = f64>) -> Node {
    Node::Array(values.into_iter().map(Node::Number).collect())
}

fn point(p: Point) -> Node {
    numbers([p.x, p.y])
}

fn world(world: &World) -> Node {
    let bounds =
        |Aabb { min, max }| field("bounds", Node::Object(vec![field("min", point(min)), field("max", point(max))]));
    let mut fields: Vec<(String, Node)> = world.bounds.map(bounds).into_iter().collect();
    fields.push(field("obstacles", Node::Array(world.obstacles.iter().map(obstacle).collect())));
    Node::Object(fields)
}

fn obstacle(obstacle: &Obstacle) -> Node {
    Node::Object(match obstacle {
        Obstacle::Disc(disc) => vec![
            field("type", text("disc")),
            field("center", point(disc.center)),
            field("radius", Node::Number(disc.radius)),
        ],
        Obstacle::Polygon(polygon) => vec![
            field("type", text("polygon")),
            field("vertices", Node::Array(polygon.vertices().iter().copied().map(point).collect())),
        ],
    })
}

fn robot(robot: &Robot) -> Node {
    Node::Object(match robot {
        Robot::Arm(arm) => {
            let mut fields = vec![
                field("type", text("arm")),
                field("base", point(arm.base())),
                field("links", numbers(arm.links().iter().copied())),
                field("radius", Node::Number(arm.radius())),
            ];
            let pairs = |limits: &[[f64; 2]]| Node::Array(limits.iter().copied().map(numbers).collect());
            fields.extend(arm.joint_limits().map(|limits| field("joint_limits", pairs(limits))));
            fields
        }
        Robot::Disc(disc) => vec![field("type", text("disc")), field("radius", Node::Number(disc.radius()))],
    })
}

fn query(query: &Query) -> Node {
    Node::Object(vec![
        field("name", text(&query.name)),
        field("start", numbers(query.start.iter().copied())),
        field("goal", numbers(query.goal.iter().copied())),
    ])
}
