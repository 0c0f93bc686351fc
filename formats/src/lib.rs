//! Maps, grids, pictures and benchmark files as scenarios of Planarium.
//!
//! [`read`] turns bytes and [`Options`] into a [`Scenario`] and a [`Report`], which says in numbers what was read,
//! dropped, merged, moved and grown. No file is opened here, nothing is planned, and no obstacle is ever smaller than
//! in the file.
//!
//! | format | files |
//! |---|---|
//! | [`Format::RosMap`] | a YAML file and its picture: PGM, PNG or BMP |
//! | [`Format::MovingAi`] | `.map`, and `.scen` with queries |
//! | [`Format::Grid`] | zeros and ones as text or CSV, and `.npy` |
//! | [`Format::Picture`] | PGM, PNG or BMP without metadata |
//! | [`Format::Tpcap`] | a parking case, CSV |
//! | [`Format::ModernRobotics`] | `obstacles.csv` |
//! | [`Format::OmplGrid`], [`Format::OmplCircles`] | the test files of OMPL |
//! | [`Format::Svg`] | shapes with fill and stroke |
//! | [`Format::Dxf`] | lines, curves and areas, as text |
//! | [`Format::GeoJson`] | features with areas, lines and points |
//! | [`Format::Wkt`] | geometries as well-known text |
//! | [`Format::RmfBuilding`] | `building.yaml` of Open-RMF |
//!
//! The content decides which format it is; files may come in any order.
//!
//! ```
//! use planarium_formats::{File, Options, RobotChoice, read};
//!
//! let map = b"type octile\nheight 2\nwidth 3\nmap\n..@\n...\n";
//! let options = Options { robot: RobotChoice::Disc { radius: 0.2 }, ..Options::default() };
//! let world = read(&[File { name: "small.map", bytes: map }], &options)?;
//! assert_eq!(world.scenario.world().obstacles.len(), 1);
//! assert_eq!(world.report.grid.as_ref().map(|grid| (grid.free, grid.occupied)), Some((5, 1)));
//! # Ok::<(), planarium_formats::FormatError>(())
//! ```
#![deny(missing_docs)]
#![deny(unsafe_code)]
#![deny(clippy::unwrap_used)]

#[cfg(all(target_arch = "wasm32", feature = "bindings"))]
#[allow(unsafe_code)]
mod bindings;
mod detect;
mod draft;
mod dxf;
mod error;
mod geojson;
mod grid;
mod image;
mod matching;
mod movingai;
pub mod npy;
mod numbers;
mod ompl;
mod options;
mod outline;
mod path;
mod plane;
mod raster;
mod rectangles;
mod regions;
mod report;
mod rmf;
mod ros;
mod svg;
mod text;
mod vector;
mod wkt;
mod write;
mod yaml;

pub use detect::is_world;
pub use error::{Code, FormatError, Place};
pub use grid::{Cell, Grid, MAX_CELLS, MAX_SIDE};
pub use options::{Coordinates, Filter, Options, RobotChoice, TOLERANCE, Unknown};
pub use path::{Angles, ColumnRead, MAX_WAYPOINTS, PathFormat, PathOptions, PathRead, PathReport, is_path, read_path};
pub use report::{Dropped, FileRead, Format, GridRead, LayerRead, Obstacles, PlaneRead, QueryRead, Report};

pub use planarium::scenario::MapFrame;
pub use write::{PathForm, PathRows, RouteWriteOptions, RowTiming, WriteOptions, write_path, write_route_graph};

use planarium::scenario::Scenario;

/// The longest file that is read, in bytes.
pub const MAX_BYTES: usize = 64 << 20;

/// The most files that make up a world.
pub const MAX_FILES: usize = 16;

/// A file: its name, which may have folders, and its content.
#[derive(Debug, Clone, Copy)]
pub struct File<'a> {
    /// The name; other files refer to it.
    pub name: &'a str,
    /// The content.
    pub bytes: &'a [u8],
}

/// A world that was read.
#[derive(Debug, Clone)]
pub struct World {
    /// The scenario; [`Scenario::to_json_string`] is its document.
    pub scenario: Scenario,
    /// What was read, dropped, merged, moved and grown.
    pub report: Report,
    /// The cells of a map or a picture, in the coordinates of the scenario.
    pub grid: Option<Grid>,
}

/// Reads the files of one world, in any order.
///
/// # Errors
/// See [`Code`]; the error names the file and, where it is known, the place in it. `missing-file` says in
/// [`FormatError::wanted`] which file is needed as well.
///
/// # Complexity
/// Near linear in the size of the files and the number of cells, see `rectangles.rs`. At most [`MAX_CELLS`] cells are
/// read, and memory is taken only after the announced size was compared with the limits and, but for PNG, with the size
/// of the file.
pub fn read(files: &[File<'_>], options: &Options) -> Result<World, FormatError> {
    check_options(options)?;
    let draft = detect::draft(files, options).map_err(|error| {
        let is_marked = |file: &File<'_>| error.file() == Some(file.name) && file.bytes.starts_with(text::MARK);
        if files.iter().any(is_marked) { error.moved(text::MARK.len()) } else { error }
    })?;
    let main = draft.report.files.first().map(|file| file.name.clone()).unwrap_or_default();
    draft.finish(options).map_err(|error| match error.code() {
        Code::InvalidOption => error,
        _ => error.in_file(&main),
    })
}

fn check_options(options: &Options) -> Result<(), FormatError> {
    let invalid = |sentence: String| Err(FormatError::new(Code::InvalidOption, sentence));
    if let Some(scale) = options.scale.filter(|scale| !(scale.is_finite() && *scale > 0.0)) {
        return invalid(format!("the scale must be positive, not {scale}"));
    }
    if let Some(threshold) = options.threshold.filter(|threshold| !threshold.is_finite()) {
        return invalid(format!("the threshold must be finite, not {threshold}"));
    }
    if !(options.simplify >= 0.0 && options.simplify.is_finite()) {
        return invalid(format!("the bound of simplification must be 0 or more, not {}", options.simplify));
    }
    if let Some(thickness) = options.wall_thickness.filter(|thickness| !(*thickness >= 0.0 && thickness.is_finite())) {
        return invalid(format!("the wall thickness must be 0 or more, not {thickness}"));
    }
    if let Some(tolerance) = options.tolerance.filter(|tolerance| !(*tolerance > 0.0 && tolerance.is_finite())) {
        return invalid(format!("the tolerance of curves must be positive, not {tolerance}"));
    }
    Ok(())
}
