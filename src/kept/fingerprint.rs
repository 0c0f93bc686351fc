//! What a roadmap depends on, as 64 bits.

use crate::graph::Fingerprint;
use crate::scenario::{Node, Scenario};

/// 64-bit FNV-1a over world and robot of the scenario in their normal form: scenarios that differ in name, title or queries
/// alone have the same. Numbers count by their bits, so that no way of writing them matters. O(size).
pub fn fingerprint(scenario: &Scenario) -> u64 {
    let mut hash = Fingerprint::new();
    if let Node::Object(fields) = scenario.to_node() {
        let depends = |name: &str| name == "world" || name == "robot";
        fields.iter().filter(|(name, _)| depends(name)).for_each(|(_, node)| add(&mut hash, node));
    }
    hash.value()
}

/// Adds a tree: what kind each node is, how much it holds, and what.
fn add(hash: &mut Fingerprint, node: &Node) {
    match node {
        Node::Null => hash.integer(0),
        Node::Bool(value) => [1, u64::from(*value)].into_iter().for_each(|part| hash.integer(part)),
        Node::Number(value) => [2, value.to_bits()].into_iter().for_each(|part| hash.integer(part)),
        Node::String(value) => add_text(hash, value),
        Node::Array(items) => {
            [4, items.len() as u64].into_iter().for_each(|part| hash.integer(part));
            items.iter().for_each(|item| add(hash, item));
        }
        Node::Object(fields) => {
            [5, fields.len() as u64].into_iter().for_each(|part| hash.integer(part));
            for (name, value) in fields {
                add_text(hash, name);
                add(hash, value);
            }
        }
    }
}

fn add_text(hash: &mut Fingerprint, text: &str) {
    [3, text.len() as u64].into_iter().for_each(|part| hash.integer(part));
    hash.bytes(text.as_bytes());
}
