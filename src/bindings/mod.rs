//! The classes and functions of the package, exported as they are declared here: their comments are those of the TypeScript
//! declarations. The package wraps each once more in JavaScript, where use before `init` and after `free` is caught.
//!
//! Every argument is checked in [`arguments`]; every error is an `Error` with `code` and `pointer`. Records cross as plain
//! objects, their types generated from the Rust ones; tables cross as typed arrays, which are copies.
//!
//! Two modules are built of them: `planarium` without the feature `full`, which plans in scenarios and in problems, and
//! `planarium/full` with it, which has all. What no export calls is not linked.

/// Declares members of a class without arguments, each by the value that it returns: getters or methods, as the attribute says.
macro_rules! members {
    ($Class:ident($self:ident): $kind:meta; $( $(#[$doc:meta])+ $name:ident: $Type:ty = $value:expr; )+) => {
        #[wasm_bindgen]
        #[allow(non_snake_case)]
        impl $Class {
            $( $(#[$doc])+ #[$kind] pub fn $name(&$self) -> $Type { $value } )+
        }
    };
}

/// Declares methods that read the rows of a table from a cursor on, each by the number of rows and by the rows from one on.
macro_rules! tables {
    ($Class:ident($self:ident, $row:ident) $( $(#[$doc:meta])+ $name:ident: $Type:ty = $count:expr => $rows:expr; )+) => {
        #[wasm_bindgen]
        #[allow(non_snake_case)]
        impl $Class {
            $( $(#[$doc])+ pub fn $name(&$self, row: &$crate::bindings::types::JsNumber) -> Result<$Type, $crate::Error> {
                let $row = $crate::bindings::arguments::cursor(row, $count)?;
                Ok($rows)
            } )+
        }
    };
}

mod arguments;
mod clock;
mod drive;
#[cfg(feature = "full")]
mod experiment;
#[cfg(feature = "full")]
mod fleet;
#[cfg(feature = "full")]
mod judgement;
#[cfg(feature = "full")]
mod navigation;
mod neighbours;
#[cfg(feature = "full")]
mod path_types;
mod planner;
mod problem;
#[cfg(feature = "full")]
mod reach;
mod records;
#[cfg(feature = "full")]
mod room;
mod scenario;
mod shortest_paths;
mod subdivision;
#[cfg(feature = "full")]
mod timing;
#[cfg(feature = "full")]
mod trajectories;
mod types;
#[cfg(feature = "full")]
mod verification;

use crate::Error;
use wasm_bindgen::prelude::*;

/// An `Error` with `code` and `pointer`, and `nearest` if it has one.
impl From<Error> for JsValue {
    fn from(error: Error) -> Self {
        let thrown = JsValue::from(js_sys::Error::new(error.message()));
        for (key, value) in [("code", error.code().as_str()), ("pointer", error.pointer())] {
            // Setting a property of a fresh object cannot fail.
            let _ = js_sys::Reflect::set(&thrown, &key.into(), &value.into());
        }
        if let Some(nearest) = error.nearest() {
            let numbers: js_sys::Array = nearest.into_iter().map(JsValue::from).collect();
            let _ = js_sys::Reflect::set(&thrown, &"nearest".into(), &numbers.into());
        }
        thrown
    }
}

/// 16 hexadecimal digits.
fn digits(fingerprint: u64) -> String {
    format!("{fingerprint:016x}")
}

/// Draws a seed from the entropy of the platform: a whole number from 0 to 2^53 - 1.
#[wasm_bindgen(js_name = randomSeed)]
pub fn random_seed() -> Result<f64, Error> {
    crate::random::random_seed().map(|seed| seed as f64)
}
