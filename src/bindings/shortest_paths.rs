//! Shortest paths for JavaScript.

use super::arguments::row;
use super::records::object;
use super::types::{JsConfiguration, JsCountOrNull, JsShortestOrNull};
use crate::Error;
use crate::optimum;
use wasm_bindgen::prelude::*;

/// A world prepared for the shortest paths of its disc or point; `scenario.shortestPaths` makes it.
#[wasm_bindgen]
pub struct ShortestPaths(pub(super) optimum::ShortestPaths);

#[wasm_bindgen]
impl ShortestPaths {
    /// The number of tangents that are known beforehand; null if each query looks for its own.
    #[wasm_bindgen(getter)]
    pub fn tangents(&self) -> JsCountOrNull {
        self.0.tangents().map_or(JsValue::NULL, |count| JsValue::from_f64(count as f64)).unchecked_into()
    }

    /// The shortest path between two positions, in metres: its length, which is the infimum of the lengths of all free paths,
    /// and its points. It touches obstacles, and its arcs are replaced by chords of at most 0.05 radians. Null if there is no
    /// path.
    /// @throws {PlanariumError} `wrong-dimension`, `not-finite`; `start-in-collision`, `goal-in-collision`
    pub fn query(&self, start: &JsConfiguration, goal: &JsConfiguration) -> Result<JsShortestOrNull, Error> {
        let position = |value: &JsConfiguration, name: &str| row(value, 2, name).map(|q| [q[0], q[1]]);
        let found = self.0.query(position(start, "start")?, position(goal, "goal")?)?;
        Ok(found.map_or(JsValue::NULL, |found| object(&found)).unchecked_into())
    }
}
