//! `planarium/shortest`: the map for JavaScript, as flat numbers. The package has checked the arguments and wraps this class.

use crate::{Fault, Found, Kind, Map, Part, Settings, Subject};
use planarium::error::Code;
use wasm_bindgen::prelude::*;

/// A map that is prepared for shortest paths.
#[wasm_bindgen]
pub struct ShortestMap(Map);

#[wasm_bindgen]
impl ShortestMap {
    /// Prepares a map: the coordinates of all positions, of each part its kind (points, a line, an outline, a hole) and the number
    /// of its positions, the distance that is kept, four numbers of bounds or none, whether numbers are metres, and whether many queries follow.
    ///
    /// # Errors
    /// A text of four lines: the code, the subject, the number of the part, and a sentence.
    #[wasm_bindgen(constructor)]
    pub fn new(
        coordinates: &[f64],
        kinds: &[u8],
        counts: &[u32],
        distance: f64,
        bounds: &[f64],
        planar: bool,
        many_queries: bool,
    ) -> Result<Self, JsValue> {
        let (mut positions, _) = coordinates.as_chunks::<2>();
        let mut parts = Vec::with_capacity(kinds.len());
        for (kind, &count) in kinds.iter().zip(counts) {
            let (own, others) = positions.split_at(positions.len().min(count as usize));
            let kind = match kind {
                0 => Kind::Points,
                1 => Kind::Line,
                2 => Kind::Outline,
                _ => Kind::Hole,
            };
            parts.push(Part { kind, positions: own });
            positions = others;
        }
        let bounds = match bounds {
            &[a, b, c, d] => Some([[a, b], [c, d]]),
            _ => None,
        };
        Map::new(&parts, &Settings { distance, bounds, planar, many_queries }).map(Self).map_err(thrown)
    }

    /// The number of tangents that are known beforehand, if they are.
    #[wasm_bindgen(getter)]
    pub fn tangents(&self) -> Option<f64> {
        self.0.tangents().map(|count| count as f64)
    }

    /// The shortest path between two positions: its length, the distortion, and the coordinates of its positions; nothing if there
    /// is none.
    ///
    /// # Errors
    /// As the constructor.
    pub fn query(&self, x: f64, y: f64, to_x: f64, to_y: f64) -> Result<Vec<f64>, JsValue> {
        let numbers = |Found { length, distortion, path, .. }| {
            [length, distortion].into_iter().chain(path.into_iter().flatten()).collect()
        };
        Ok(self.0.query([x, y], [to_x, to_y]).map_err(thrown)?.map_or(Vec::new(), numbers))
    }
}

/// An error as a text, of which the package makes its own.
fn thrown(fault: Fault) -> JsValue {
    let code: Code = fault.code();
    let (subject, part) = match fault.subject() {
        Subject::Part(part) => ("part", part),
        Subject::Map => ("map", 0),
        Subject::Distance => ("distance", 0),
        Subject::Bounds => ("bounds", 0),
        Subject::Start => ("start", 0),
        Subject::Goal => ("goal", 0),
    };
    format!("{}\n{subject}\n{part}\n{}", code.as_str(), fault.message()).into()
}
