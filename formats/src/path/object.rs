//! An object of columns as JSON: each has its name, its `unit` and its `values`.

use super::{PathFormat, Places, Rows};
use crate::error::{Code, FormatError, Place, quoted};
use serde::Deserialize;
use std::collections::BTreeMap;

#[derive(Deserialize)]
struct Document {
    columns: BTreeMap<String, Column>,
}

#[derive(Deserialize)]
struct Column {
    unit: Option<String>,
    values: Vec<f64>,
}

/// Whether text is such an object.
pub fn is_object(text: &str) -> bool {
    #[derive(Deserialize)]
    struct Head {
        columns: Option<serde::de::IgnoredAny>,
    }
    text.trim_start().starts_with('{') && serde_json::from_str::<Head>(text).is_ok_and(|head| head.columns.is_some())
}

/// Reads the columns, in the order of their names.
///
/// # Errors
/// `truncated`, `invalid-file`, `invalid-number` with the line; `contradiction` if columns have different lengths.
pub fn rows(text: &str) -> Result<Rows, FormatError> {
    let Document { columns } =
        serde_json::from_str(text).map_err(|error| FormatError::of_json(&error, "object of columns"))?;
    let count = columns.values().next().map_or(0, |column| column.values.len());
    for (name, Column { values, .. }) in &columns {
        if values.len() != count {
            let sentence = format!("the column has {} values, but the first has {count}", values.len());
            let place = Place::Element(format!("column {}", quoted(name.as_bytes())));
            return Err(FormatError::new(Code::Contradiction, sentence).at(place));
        }
    }
    let named = |(name, column): (&String, &Column)| match &column.unit {
        Some(unit) => format!("{name} [{unit}]"),
        None => name.clone(),
    };
    let names: Vec<String> = columns.iter().map(named).collect();
    let numbers = (0..count).flat_map(|i| columns.values().map(move |column| column.values[i])).collect();
    Ok(Rows::plain(PathFormat::Columns, Some(names), columns.len(), numbers, Places::Elements("row")))
}
