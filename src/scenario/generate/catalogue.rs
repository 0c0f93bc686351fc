//! The table of generators, to be written.

use super::options::{OptionInfo, OptionKind};
use super::{GENERATORS, GeneratorInfo};
use crate::json::Node;

/// The table of generators, to be written: options as a planner's parameters.
pub fn catalogue() -> Node {
    let row = |info: &GeneratorInfo| {
        Node::object(vec![
            ("id", Some(Node::text(info.id))),
            ("title", Some(Node::text(info.title))),
            ("summary", Some(Node::text(info.summary))),
            ("options", Some(Node::Array(info.options.iter().map(option).collect()))),
        ])
    };
    Node::Array(GENERATORS.iter().map(row).collect())
}

fn option(info: &OptionInfo) -> Node {
    let (kind, [min, max, default], choices) = match info.kind {
        OptionKind::Integer { min, max, default } => ("integer", [min, max, default].map(Node::Number), Node::Null),
        OptionKind::Number { min, max, default } => ("number", [min, max, default].map(Node::Number), Node::Null),
        OptionKind::Choice(words) => ("choice", [Node::Null, Node::Null, Node::text(words[0])], Node::words(words)),
    };
    Node::object(vec![
        ("name", Some(Node::text(info.name))),
        ("title", Some(Node::text(info.title))),
        ("kind", Some(Node::text(kind))),
        ("unit", Some(Node::text(info.unit))),
        ("min", Some(min)),
        ("max", Some(max)),
        ("choices", Some(choices)),
        ("default", Some(default)),
        ("meaning", Some(Node::text(info.meaning))),
    ])
}
