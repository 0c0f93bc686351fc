//! Errors as JavaScript gets them: as JSON, from which the package makes its own.

use crate::{FormatError, Place};
use planarium::{Error, json};
use serde::Serialize;
use wasm_bindgen::JsValue;

/// An error as it is thrown.
#[derive(Serialize)]
pub(super) struct Thrown<'a> {
    code: &'static str,
    message: &'a str,
    pointer: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    place: Option<&'a Place>,
    #[serde(skip_serializing_if = "Option::is_none")]
    wanted: Option<&'a str>,
}

impl<'a> Thrown<'a> {
    /// An error about the arguments.
    pub fn of(error: &'a Error) -> Self {
        let (code, message, pointer) = (error.code().as_str(), error.message(), error.pointer());
        Self { code, message, pointer, file: None, place: None, wanted: None }
    }

    /// An error about the files.
    pub fn in_file(error: &'a FormatError) -> Self {
        let (code, message) = (error.code().as_str(), error.message());
        Self { code, message, pointer: "", file: error.file(), place: error.place(), wanted: error.wanted() }
    }

    pub fn value(&self) -> JsValue {
        json::to_string(self).into()
    }
}
