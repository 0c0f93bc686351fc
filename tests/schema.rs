//! The committed JSON Schema is the one that the types give, and it agrees with the parser.
//!
//! `PLANARIUM_BLESS=1 cargo test --features schema --test schema` writes it anew.

use crate::common::documents;
use planarium::scenario::generate::{ClutterOptions, ForestOptions, Generator};
use planarium::scenario::{Scenario, schema};
use serde_json::{Value, json};

/// Whether the value follows the schema: as much of JSON Schema as this schema uses. A keyword that is not known here is a
/// failure, so that none goes unchecked.
fn follows(root: &Value, schema: &Value, value: &Value) -> bool {
    let keywords = schema.as_object().expect("a schema is an object");
    keywords.iter().all(|(keyword, rule)| match keyword.as_str() {
        "$schema" | "$defs" | "title" | "description" | "default" => true,
        "$ref" => {
            let pointer = rule.as_str().and_then(|path| path.strip_prefix('#')).expect("a pointer into the schema");
            follows(root, root.pointer(pointer).expect("the definition is there"), value)
        }
        "oneOf" => rule.as_array().unwrap().iter().filter(|one| follows(root, one, value)).count() == 1,
        "const" => rule == value,
        "type" => match rule.as_str().expect("one type") {
            "object" => value.is_object(),
            "array" => value.is_array(),
            "string" => value.is_string(),
            "number" => value.is_number(),
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
            assert_eq!(rule, &json!(false));
            value.as_object().is_none_or(|object| object.keys().all(|name| keywords["properties"].get(name).is_some()))
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

fn arm() -> Value {
    let mut document: Value = serde_json::from_str(documents::ARM).unwrap();
    document["queries"].as_array_mut().unwrap().truncate(1);
    document
}

fn disc() -> Value {
    serde_json::from_str(documents::DISC).unwrap()
}

fn reaching() -> Value {
    let mut document = arm();
    document["queries"][0] = json!({"name": "q", "start": [-1, 0], "target": {"point": [1, 0.5], "orientation": 0.25}});
    document
}

fn body() -> Value {
    serde_json::from_str(documents::BODY).unwrap()
}

fn car() -> Value {
    serde_json::from_str(documents::CAR).unwrap()
}

#[test]
fn the_committed_schema_is_that_of_the_types() {
    crate::common::golden::committed("schema/scenario.schema.json", &format!("{:#}\n", schema()));
}

#[test]
fn schema_and_parser_know_and_require_the_same_fields() {
    let all = [arm(), reaching(), disc(), body(), car()];
    for document in &all {
        assert!(is_valid(document));
        for place in documents::objects(document) {
            let mut more = document.clone();
            more.pointer_mut(&place).unwrap()["something"] = json!(1);
            assert!(!is_valid(&more), "{place}");
            for name in document.pointer(&place).unwrap().as_object().unwrap().keys() {
                // What only an arm may leave out, a schema without conditions lets others leave out, too.
                if name == "bounds" && document["robot"]["type"] != "arm" {
                    continue;
                }
                let mut less = document.clone();
                less.pointer_mut(&place).unwrap().as_object_mut().unwrap().remove(name);
                assert_eq!(is_valid(&less), Scenario::parse(&less.to_string()).is_ok(), "without {place}/{name}");
            }
        }
    }
    // Every property of the schema is in one of the documents.
    let mut known = std::collections::BTreeSet::new();
    for place in
        ["", "/$defs/World", "/$defs/Bounds", "/$defs/Query", "/$defs/Target", "/$defs/Metric", "/$defs/GoalTolerance"]
    {
        known.extend(schema().pointer(&format!("{place}/properties")).unwrap().as_object().unwrap().keys().cloned());
    }
    for union in ["Obstacle", "Robot"] {
        for one in schema()["$defs"][union]["oneOf"].as_array().unwrap() {
            known.extend(one["properties"].as_object().unwrap().keys().cloned());
        }
    }
    let mentioned = json!(all).to_string();
    for name in known {
        assert!(mentioned.contains(&format!("{name:?}:")), "{name}");
    }
}

#[test]
fn schema_and_parser_refuse_the_same_values() {
    let cases = [
        ("/format", json!("planarium-scenario-2")),
        ("/format", json!(1)),
        ("/name", json!("")),
        ("/name", json!(null)),
        ("/title", json!(null)),
        ("/world", json!([])),
        ("/world/bounds", json!(null)),
        ("/world/bounds/min", json!([0])),
        ("/world/bounds/min", json!([0, 0, 0])),
        ("/world/bounds/min/0", json!(-1.1e6)),
        ("/world/bounds/max/1", json!(1.1e6)),
        ("/world/obstacles", json!({})),
        ("/world/obstacles", json!(vec![json!({"type": "disc", "center": [2, 0], "radius": 0.25}); 10_001])),
        ("/world/obstacles/0/type", json!("circle")),
        ("/world/obstacles/0/radius", json!(0)),
        ("/world/obstacles/0/radius", json!("1")),
        ("/world/obstacles/0/radius", json!(1e7)),
        ("/world/obstacles/1/vertices", json!([[1, 1], [2, 1]])),
        ("/world/obstacles/1/vertices/0/0", json!("1")),
        ("/robot/type", json!("rigid_body")),
        ("/robot/type", json!("car")),
        ("/robot/type", json!("train")),
        ("/robot/base", json!([0])),
        ("/robot/links", json!([])),
        ("/robot/links", json!([1, 1, 1, 1, 1, 1, 1, 1, 1])),
        ("/robot/links/0", json!(0)),
        ("/robot/links/0", json!(true)),
        ("/robot/radius", json!(-0.1)),
        ("/robot/joint_limits", json!([])),
        ("/robot/joint_limits", json!(null)),
        ("/robot/joint_limits/0", json!([-1])),
        ("/robot/joint_limits/0", json!([-1, 0, 1])),
        ("/robot/joint_limits/0/0", json!(-101)),
        ("/queries", json!(null)),
        ("/queries/0/name", json!("")),
        ("/queries/0/start", json!([])),
        ("/queries/0/start", json!("home")),
        ("/queries/0/goal/0", json!(null)),
        ("/queries/0/goal/0", json!(1e7)),
    ];
    let of_cars = [
        ("/robot/shape", json!([[0, 0], [1, 0], [0, 1]])),
        ("/robot/shape/type", json!("disc")),
        ("/robot/shape/vertices", json!([[0, 0], [1, 0]])),
        ("/robot/wheelbase", json!(0)),
        ("/robot/speed", json!([1])),
        ("/robot/speed/0", json!("1")),
        ("/robot/steering/1", json!(1.6)),
        ("/robot/integration_step", json!(0)),
        ("/robot/integration_step", json!(11)),
        ("/robot/metric/translation", json!(0)),
        ("/robot/metric", json!(null)),
        ("/queries/0/goal_tolerance", json!(0.1)),
        ("/queries/0/goal_tolerance/rotation", json!(-0.1)),
    ];
    let of_arms = cases.into_iter().map(|(place, value)| (arm(), place, value));
    for (mut document, place, value) in of_arms.chain(of_cars.into_iter().map(|(place, value)| (car(), place, value))) {
        *document.pointer_mut(place).expect(place) = value;
        let shown: String = document.pointer(place).unwrap().to_string().chars().take(100).collect();
        assert!(!is_valid(&document), "the schema accepts {place} = {shown}");
        assert!(Scenario::parse(&document.to_string()).is_err(), "the parser accepts {place} = {shown}");
    }
}

#[test]
fn what_is_written_follows_the_schema() {
    let generated = |seed: u64| {
        let forest = ForestOptions { links: 1 + seed as usize % 8, seed }.generate();
        [forest, ClutterOptions { seed, ..ClutterOptions::default() }.generate()]
    };
    let parsed = [arm(), disc(), body(), car()].map(|document| Scenario::parse(&document.to_string()));
    for scenario in (0..10).flat_map(generated).chain(parsed) {
        assert!(is_valid(&serde_json::from_str(&scenario.unwrap().to_json_string()).unwrap()));
    }
}

#[test]
fn the_shared_scenarios_follow_the_schema_where_the_parser_accepts_them() {
    let Some(shared) = documents::shared() else { return };
    let mut seen = 0;
    for (name, text) in shared {
        let accepted = Scenario::parse(&text).is_ok();
        assert_eq!(is_valid(&serde_json::from_str(&text).unwrap()), accepted, "{name}");
        seen += usize::from(accepted);
    }
    assert!(seen > 0, "there are shared scenarios with arms");
}
