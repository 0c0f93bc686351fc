//! A path as text with a row a line, and as an object of columns.

use super::columns::{Column, Table};
use super::{PathRows, decimal};
use planarium::scenario::Scenario;
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

/// CSV: the names of the columns with their units, and a line for each row.
pub fn csv(Table { columns, .. }: &Table) -> String {
    let names: Vec<String> =
        columns.iter().map(|Column { name, unit, .. }| format!("{name}_{}", unit.replace('/', "_"))).collect();
    let mut text = names.join(",");
    for i in 0..columns.first().map_or(0, |column| column.numbers.len()) {
        for (k, column) in columns.iter().enumerate() {
            text.push(if k == 0 { '\n' } else { ',' });
            text += &decimal(column.numbers[i]);
        }
    }
    text + "\n"
}

/// The document of a table.
#[derive(Serialize)]
struct Document<'a> {
    scenario: &'a str,
    query: &'a str,
    rows: usize,
    columns: Columns<'a>,
}

struct Columns<'a>(&'a [Column]);

#[derive(Serialize)]
struct Values<'a> {
    unit: &'static str,
    values: &'a [f64],
}

impl Serialize for Columns<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_map(Some(self.0.len()))?;
        for Column { name, unit, numbers } in self.0 {
            object.serialize_entry(name, &Values { unit, values: numbers })?;
        }
        object.end()
    }
}

/// JSON: an object of columns by their names, each with its unit.
pub fn json(scenario: &Scenario, rows: &PathRows, Table { columns, .. }: &Table) -> String {
    let document = Document {
        scenario: scenario.name(),
        query: &rows.query,
        rows: rows.configurations.len(),
        columns: Columns(columns),
    };
    planarium::json::to_string(&document) + "\n"
}
