//! `planarium/import`: worlds and paths for JavaScript. The package has checked the arguments and wraps these functions.

mod options;
mod paths;
mod thrown;

use crate::{File, Grid, MAX_BYTES, MAX_FILES, Options, World, read};
use js_sys::{Array, Uint8Array};
use options::options_of;
use planarium::json;
use serde::Serialize;
use thrown::Thrown;
use wasm_bindgen::prelude::*;

/// Reads the files of one world: their names, their contents (each a `Uint8Array`) and the options as JSON. Returns the
/// scenario, the report and what the cells are, as JSON, and the cells, row by row from the lowest y, or null.
///
/// # Errors
/// JSON of an error.
#[wasm_bindgen(js_name = readFiles)]
pub fn read_files(names: Vec<String>, contents: &Array, options: &str) -> Result<Array, JsValue> {
    let options = options_of::<Options>(options).map_err(|error| Thrown::of(&error).value())?;
    // One more than is read shows what is too many, or too long.
    let contents: Vec<Vec<u8>> = contents.iter().take(MAX_FILES + 1).map(content).collect();
    let files: Vec<File> = names.iter().zip(&contents).map(|(name, bytes)| File { name, bytes }).collect();
    let World { scenario, report, grid } = read(&files, &options).map_err(|error| Thrown::in_file(&error).value())?;
    drop(contents);
    let (scenario, report) = (scenario.to_json_string(), report.to_json_string());
    let mut text = format!(r#"{{"scenario":{scenario},"report":{report}"#);
    let mut cells = JsValue::NULL;
    if let Some(grid) = grid {
        text += &format!(r#","grid":{}"#, json::to_string(&Cells::of(&grid)));
        cells = from_below(&grid).into();
    }
    Ok(Array::of2(&(text + "}").into(), &cells))
}

/// The bytes of a file, copied once.
fn content(bytes: JsValue) -> Vec<u8> {
    let bytes: Uint8Array = bytes.unchecked_into();
    let most = u32::try_from(MAX_BYTES + 1).unwrap_or(u32::MAX);
    if bytes.length() <= most { bytes.to_vec() } else { bytes.subarray(0, most).to_vec() }
}

/// Where the cells lie.
#[derive(Serialize)]
struct Cells {
    width: usize,
    height: usize,
    resolution: f64,
    origin: [f64; 2],
    yaw: f64,
}

impl Cells {
    fn of(grid: &Grid) -> Self {
        let origin = grid.frame.origin;
        Self {
            width: grid.width,
            height: grid.height,
            resolution: grid.frame.resolution,
            origin: [origin.x, origin.y],
            yaw: grid.frame.yaw,
        }
    }
}

/// The cells row by row from the lowest y.
fn from_below(grid: &Grid) -> Uint8Array {
    let rows = grid.cells.chunks_exact(grid.width).rev();
    let cells: Vec<u8> = rows.flatten().map(|&cell| cell as u8).collect();
    Uint8Array::from(&cells[..])
}
