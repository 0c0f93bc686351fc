//! What a roadmap was built for, as 64 bits: a scenario, or the space of a custom robot.

use super::RoadmapMetric;
use crate::fingerprint::Fingerprint;
use crate::run::SpaceDescription;
use crate::scenario::Scenario;
use serde_json::Value;

/// The fields of world and robot in the order of their contract, which is that of their objects' fields; then those of a space.
const ORDER: &str = "type bounds min max obstacles shape center vertices base links wheelbase speed steering \
    integration_step radius joint_limits metric translation rotation coordinates kind low high weight joints limits range angle";

/// 64-bit FNV-1a over world and robot of the scenario in their normal form: scenarios that differ in name, title or queries
/// alone have the same. Numbers count by their bits, however they are written. O(size).
pub fn fingerprint(scenario: &Scenario) -> u64 {
    let mut hash = Fingerprint::default();
    for value in [serde_json::to_value(scenario.world()), serde_json::to_value(scenario.robot())] {
        add(&mut hash, &value.expect("world and robot have a form in JSON"));
    }
    hash.value()
}

/// The same over the space of a custom robot, described in full. Its function has no fingerprint.
pub(crate) fn fingerprint_of_space(space: &SpaceDescription) -> u64 {
    let mut hash = Fingerprint::default();
    add(&mut hash, &RoadmapMetric::Space(space.clone()).to_tree()["space"]);
    hash.value()
}

/// Adds a value: its kind, its size and its content.
fn add(hash: &mut Fingerprint, value: &Value) {
    match value {
        Value::Null => hash.integer(0),
        Value::Bool(value) => [1, u64::from(*value)].into_iter().for_each(|part| hash.integer(part)),
        Value::Number(value) => {
            let bits = value.as_f64().unwrap_or_default().to_bits();
            [2, bits].into_iter().for_each(|part| hash.integer(part));
        }
        Value::String(value) => add_text(hash, value),
        Value::Array(items) => {
            [4, items.len() as u64].into_iter().for_each(|part| hash.integer(part));
            items.iter().for_each(|item| add(hash, item));
        }
        Value::Object(fields) => {
            [5, fields.len() as u64].into_iter().for_each(|part| hash.integer(part));
            for (name, value) in ORDER.split(' ').filter_map(|name| Some((name, fields.get(name)?))) {
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
