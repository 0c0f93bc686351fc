//! The committed JSON Schema is the one that the types give, and it agrees with the parser.

use crate::common::documents::{ARM, BODY, CAR, DISC, WALLS, reaching};
use planarium::scenario::generate::{ClutterOptions, ForestOptions, Generator};
use planarium::scenario::{Scenario, schema};
use serde_json::Value;

/// Whether the value follows the schema: as much of JSON Schema as this schema uses. A keyword that is not known here is a
/// failure, so that none goes unchecked.
pub fn follows(root: &Value, schema: &Value, value: &Value) -> bool {
    if let Some(accepts) = schema.as_bool() {
        return accepts;
    }
    let keywords = schema.as_object().expect("a schema is an object, or true or false");
    keywords.iter().all(|(keyword, rule)| match keyword.as_str() {
        "$schema" | "$defs" | "title" | "description" | "default" | "format" => true,
        "$ref" => {
            let pointer = rule.as_str().and_then(|path| path.strip_prefix('#')).expect("a pointer into the schema");
            follows(root, root.pointer(pointer).expect("the definition is there"), value)
        }
        "oneOf" => rule.as_array().unwrap().iter().filter(|one| follows(root, one, value)).count() == 1,
        "anyOf" => rule.as_array().unwrap().iter().any(|one| follows(root, one, value)),
        "const" => rule == value,
        "type" => match rule.as_str().expect("one type") {
            "object" => value.is_object(),
            "array" => value.is_array(),
            "string" => value.is_string(),
            "number" => value.is_number(),
            "integer" => value.as_f64().is_some_and(|number| number.fract() == 0.0),
            "boolean" => value.is_boolean(),
            other => panic!("no value of this document has the type {other}"),
        },
        "required" => value.as_object().is_none_or(|object| {
            rule.as_array().unwrap().iter().all(|name| object.contains_key(name.as_str().unwrap()))
        }),
        "properties" => value.as_object().is_none_or(|object| {
            let known = |(name, field): (&String, &Value)| rule.get(name).is_none_or(|rule| follows(root, rule, field));
            object.iter().all(known)
        }),
        "additionalProperties" => {
            let own = keywords.get("properties").unwrap_or(&Value::Null);
            let is_allowed = |(name, field): (&String, &Value)| own.get(name).is_some() || follows(root, rule, field);
            value.as_object().is_none_or(|object| object.iter().all(is_allowed))
        }
        "items" => {
            let first = keywords.get("prefixItems").map_or(0, |prefix| prefix.as_array().unwrap().len());
            value.as_array().is_none_or(|items| items.iter().skip(first).all(|item| follows(root, rule, item)))
        }
        "prefixItems" => value.as_array().is_none_or(|items| {
            rule.as_array().unwrap().iter().zip(items).all(|(rule, item)| follows(root, rule, item))
        }),
        "minItems" => value.as_array().is_none_or(|items| items.len() >= rule.as_u64().unwrap() as usize),
        "maxItems" => value.as_array().is_none_or(|items| items.len() <= rule.as_u64().unwrap() as usize),
        "minLength" => value.as_str().is_none_or(|text| text.len() >= rule.as_u64().unwrap() as usize),
        "minimum" => value.as_f64().is_none_or(|number| number >= rule.as_f64().unwrap()),
        "maximum" => value.as_f64().is_none_or(|number| number <= rule.as_f64().unwrap()),
        "exclusiveMinimum" => value.as_f64().is_none_or(|number| number > rule.as_f64().unwrap()),
        other => panic!("the keyword {other} is not known to this test"),
    })
}

fn is_valid(value: &Value) -> bool {
    let schema = schema();
    follows(&schema, &schema, value)
}

/// The schema of a kind of documents.
pub fn of(kind: &str) -> Option<Value> {
    match kind {
        "scenario" => Some(schema()),
        "experiment" => Some(planarium::experiment::schema()),
        "fleet" => Some(planarium::fleet::schema()),
        "navigation" => Some(planarium::navigation::schema()),
        _ => None,
    }
}

/// Checks that the schema accepts the document, or that it refuses it.
#[track_caller]
pub fn check(document: &Value, is_accepted: bool) {
    assert_eq!(is_valid(document), is_accepted, "{:.1000}", document.to_string());
}

#[test]
fn the_committed_schemas_are_those_of_the_types() {
    let experiment = format!("{:#}\n", planarium::experiment::schema());
    crate::common::golden::committed("schema/experiment.schema.json", &experiment);
    let fleet = format!("{:#}\n", planarium::fleet::schema());
    crate::common::golden::committed("schema/fleet.schema.json", &fleet);
    let navigation = format!("{:#}\n", planarium::navigation::schema());
    crate::common::golden::committed("schema/navigation.schema.json", &navigation);
    crate::common::golden::committed("schema/scenario.schema.json", &format!("{:#}\n", schema()));
}

/// A document with every field that a scenario with an arm whose joints are given one by one may have.
const SLIDING: &str = r#"{
  "format": "planarium-scenario-1", "name": "sliding", "title": "An arm that slides", "world": {"obstacles": []},
  "robot": {"type": "arm", "base": [0, 0], "links": [1, 0.5, 0.5], "radius": 0.05, "joints": [
    "revolute", {"type": "prismatic", "range": [0, 0.5], "angle": 0.1}, {"type": "revolute", "limits": [-1, 1]}]},
  "queries": [{"name": "out", "start": [-1, 0, 0], "goal": [1, 0.5, 1]}]
}"#;

/// A document that was read from a map in longitude and latitude.
const MAPPED: &str = r#"{
  "format": "planarium-scenario-1", "name": "house", "frame": {"offset": [0, -3],
  "plane": {"origin": [13.4, 52.5], "scale": [67000, 111000], "degrees": true}},
  "world": {"bounds": {"min": [-2, -2], "max": [2, 2]}, "obstacles": []}, "robot": {"type": "disc", "radius": 0.1}, "queries": []
}"#;

/// What the parser is tested on is all that the schema knows.
#[test]
fn every_property_of_the_schema_is_in_a_document() {
    let mut known = std::collections::BTreeSet::new();
    for place in [
        "",
        "/$defs/MapFrame",
        "/$defs/MapPlane",
        "/$defs/World",
        "/$defs/Bounds",
        "/$defs/Query",
        "/$defs/Target",
        "/$defs/Metric",
        "/$defs/GoalTolerance",
    ] {
        known.extend(schema().pointer(&format!("{place}/properties")).unwrap().as_object().unwrap().keys().cloned());
    }
    for union in ["Joint", "Obstacle", "Robot"] {
        for one in schema()["$defs"][union]["oneOf"].as_array().unwrap() {
            known.extend(one["properties"].as_object().unwrap().keys().cloned());
        }
    }
    let mentioned = [ARM, SLIDING, MAPPED, DISC, BODY, CAR, WALLS, &reaching()].concat();
    for name in known {
        assert!(mentioned.contains(&format!("{name:?}:")), "{name}");
    }
}

#[test]
fn what_is_written_follows_the_schema() {
    let generated = |seed: u64| {
        let forest = ForestOptions { links: 1 + seed as usize % 8, seed }.generate();
        [forest, ClutterOptions { seed, ..ClutterOptions::default() }.generate()]
    };
    let parsed = [ARM, SLIDING, MAPPED, DISC, BODY, CAR, WALLS].map(Scenario::parse);
    for scenario in (0..10).flat_map(generated).chain(parsed) {
        assert!(is_valid(&serde_json::from_str(&scenario.unwrap().to_json_string()).unwrap()));
    }
}

/// The JSON examples in `docs/scenarios.md`.
fn examples() -> Vec<&'static str> {
    let blocks = include_str!("../docs/scenarios.md").split("```json\n").skip(1);
    blocks.map(|block| block.split("```").next().unwrap_or_default()).collect()
}

/// The names of all fields of the objects in a schema.
fn fields(schema: &Value, found: &mut Vec<String>) {
    let own = schema.get("properties").and_then(Value::as_object);
    found.extend(own.into_iter().flat_map(|properties| properties.keys().cloned()));
    let inner: Vec<&Value> = match schema {
        Value::Object(object) => object.values().collect(),
        Value::Array(items) => items.iter().collect(),
        _ => Vec::new(),
    };
    inner.into_iter().for_each(|value| fields(value, found));
}

#[test]
fn the_documentation_shows_every_field_in_an_example_that_is_a_scenario() {
    let examples = examples();
    for example in &examples {
        Scenario::parse(example).unwrap_or_else(|error| panic!("{error}: {example}"));
    }
    let mut all = Vec::new();
    fields(&schema(), &mut all);
    assert!(all.len() > 30, "{all:?}");
    let is_shown = |name: &String| examples.iter().any(|example| example.contains(&format!("\"{name}\"")));
    let hidden: Vec<&String> = all.iter().filter(|name| !is_shown(name)).collect();
    assert!(hidden.is_empty(), "docs/scenarios.md shows no {hidden:?}");
}
