//! Documents: objects whose field `format` says what they are.

use super::typed::read;
use crate::error::{Code, Error, quoted};
use serde::Deserialize;
use serde_json::Value;

/// Reads a document of this format as a type. The format comes first, so that any other document is reported as such.
///
/// # Errors
/// `unknown-format`, pointer `/format`, for another format; those of [`read`].
pub(crate) fn read_document<'de, T: Deserialize<'de>>(tree: &'de Value, format: &str) -> Result<T, Error> {
    check_format(tree, format)?;
    read(tree)
}

fn check_format(tree: &Value, wanted: &str) -> Result<(), Error> {
    match tree.get("format").and_then(Value::as_str) {
        Some(format) if format != wanted => {
            let sentence = format!("unsupported format {}; expected \"{wanted}\"", quoted(format));
            Err(Error::new(Code::UnknownFormat, "/format", sentence))
        }
        _ => Ok(()),
    }
}

/// Declares the type of the field `format`, which has one word.
macro_rules! one_format {
    ($visibility:vis enum Format = $format:literal) => {
        /// The one format.
        #[derive(serde::Deserialize)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(inline))]
        $visibility enum Format {
            #[serde(rename = $format)]
            One,
        }
    };
}
pub(crate) use one_format;

/// Declares the objects of a document: each is read with its fields and no others, and has a schema.
macro_rules! objects {
    ($($item:item)*) => {
        $(
            #[derive(serde::Deserialize)]
            #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
            #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
            #[serde(deny_unknown_fields)]
            $item
        )*
    };
}
pub(crate) use objects;
