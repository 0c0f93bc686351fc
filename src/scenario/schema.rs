//! The JSON Schema of the scenario document, generated from the types that it is read into.
//!
//! A schema describes fields, their types and ranges. The rest (simple polygons, distinct names, dimensions, a free base)
//! only [`Scenario::parse`](super::Scenario::parse) checks.

use super::document::Document;
use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde_json::{Value, json};

/// The JSON Schema (draft 2020-12) of the documents that `Scenario::parse` accepts.
pub fn schema() -> Value {
    schema_of::<Document>()
}

/// The schema of a type that a document is read into.
pub(crate) fn schema_of<T: JsonSchema>() -> Value {
    let settings = SchemaSettings::draft2020_12().with_transform(RecursiveTransform(tidy));
    settings.into_generator().into_root_schema_for::<T>().to_value()
}

/// Removes artefacts of the Rust types: `null` for fields that may be absent, defaults, a choice of one, and the line
/// breaks of comments.
fn tidy(schema: &mut Schema) {
    schema.remove("default");
    if let Some(Value::Array(types)) = schema.get_mut("type") {
        types.retain(|kind| kind != "null");
        let kind = types.remove(0);
        schema.insert("type".to_owned(), kind);
    }
    if let Some(Value::Array(choices)) = schema.get_mut("anyOf") {
        choices.retain(|choice| *choice != json!({ "type": "null" }));
        if let [Value::Object(only)] = &mut choices[..] {
            let only = std::mem::take(only);
            schema.remove("anyOf");
            only.into_iter().for_each(|(name, value)| drop(schema.insert(name, value)));
        }
    }
    if let Some(Value::Array(words)) = schema.get_mut("enum") {
        let word = words.remove(0);
        schema.remove("enum");
        schema.insert("const".to_owned(), word);
    }
    if let Some(Value::String(text)) = schema.get_mut("description") {
        *text = text.replace('\n', " ");
    }
}
