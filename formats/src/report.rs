//! What was read, dropped, merged, moved and grown, in numbers.

use crate::text::at_most;
use planarium::scenario::Obstacle;
use serde::Serialize;
use std::fmt;

/// The format of a world, as a stable kebab-case word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, strum::IntoStaticStr, strum::VariantArray)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Format {
    /// A map of ROS's `map_server`: a YAML file and a picture.
    RosMap,
    /// A map of the MovingAI benchmarks, with scenarios or without.
    MovingAi,
    /// A grid of zeros and ones: text, CSV or a NumPy array.
    Grid,
    /// A picture without metadata.
    Picture,
    /// A case of the automated parking competition.
    Tpcap,
    /// The obstacles of the course Modern Robotics.
    ModernRobotics,
    /// The grid of OMPL's tests.
    OmplGrid,
    /// The circles of OMPL's tests.
    OmplCircles,
    /// Shapes of SVG.
    Svg,
    /// A drawing of AutoCAD's exchange format.
    Dxf,
    /// Features of GeoJSON.
    #[serde(rename = "geojson")]
    #[strum(serialize = "geojson")]
    GeoJson,
    /// Well-known text.
    Wkt,
    /// A building of Open-RMF's `traffic_editor`.
    RmfBuilding,
}

impl Format {
    /// All formats.
    pub const ALL: &[Format] = <Self as strum::VariantArray>::VARIANTS;

    /// The word for the format.
    pub fn as_str(self) -> &'static str {
        self.into()
    }
}

/// The report about a world that was read. Lengths in metres.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify), tsify(rename = "WorldReport"))]
pub struct Report {
    /// The format.
    pub format: Format,
    /// The files that were used.
    pub files: Vec<FileRead>,
    /// The bounds of the scenario: the lowest and the highest corner.
    pub bounds: [[f64; 2]; 2],
    /// What was subtracted from every coordinate of the file; add it to go back.
    pub offset: [f64; 2],
    /// Of maps and pictures.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grid: Option<GridRead>,
    /// Of drawings whose coordinates are not metres with y up.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub plane: Option<PlaneRead>,
    /// Of drawings, the layers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), tsify(optional))]
    pub layers: Vec<LayerRead>,
    /// Of buildings, the names of the levels, of which one is read.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), tsify(optional))]
    pub levels: Vec<String>,
    /// The obstacles of the scenario.
    pub obstacles: Obstacles,
    /// What was left out.
    pub dropped: Vec<Dropped>,
    /// The farthest that a point of an obstacle is from what the file has.
    pub grown: f64,
    /// The robot, in words.
    pub robot: String,
    /// The queries, in their order.
    pub queries: Vec<QueryRead>,
    /// What else should be known, a sentence each.
    pub notes: Vec<String>,
}

/// A file that was used.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify))]
pub struct FileRead {
    /// Its name, as given.
    pub name: String,
    /// Its size.
    pub bytes: usize,
    /// What it is.
    pub kind: String,
}

/// The cells of a map.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify))]
pub struct GridRead {
    /// The columns.
    pub width: usize,
    /// The rows.
    pub height: usize,
    /// Metres per cell.
    pub resolution: f64,
    /// The turn about the lower left corner, in radians, counter-clockwise.
    pub yaw: f64,
    /// The free cells of the file.
    pub free: usize,
    /// The occupied cells of the file.
    pub occupied: usize,
    /// The unknown cells of the file.
    pub unknown: usize,
    /// Whether unknown cells are obstacles.
    pub unknown_is_occupied: bool,
    /// Of the unknown cells, those of transparent pixels.
    pub transparent: usize,
    /// The kinds of cells that the file has, by its own letters or values, and how many of each.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), tsify(optional))]
    pub kinds: Vec<(String, usize)>,
    /// Islands of obstacles: cells that touch at a side or a corner. Those that were dropped do not count.
    pub islands: usize,
    /// Free regions that no way leads out of, across sides of cells.
    pub enclosed: usize,
    /// The cells that became obstacles by simplification.
    pub grown_cells: usize,
    /// The cells of all obstacles.
    pub merged_cells: usize,
    /// The rectangles that they were merged into.
    pub rectangles: usize,
    /// Whether no fewer rectangles without overlap are possible.
    pub fewest: bool,
}

/// How many obstacles the scenario has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify))]
pub struct Obstacles {
    /// Polygons, with holes or without.
    pub polygons: usize,
    /// The holes of all polygons.
    pub holes: usize,
    /// Walls.
    pub walls: usize,
    /// Discs.
    pub discs: usize,
    /// The corners of all polygons and the points of all walls.
    pub vertices: usize,
}

impl Obstacles {
    pub(crate) fn of(obstacles: &[Obstacle]) -> Self {
        let mut count = Self { vertices: obstacles.iter().map(Obstacle::points).sum(), ..Self::default() };
        for obstacle in obstacles {
            match obstacle {
                Obstacle::Polygon(_) => count.polygons += 1,
                Obstacle::PolygonWithHoles(polygon) => {
                    count.polygons += 1;
                    count.holes += polygon.holes().len();
                }
                Obstacle::Wall(_) => count.walls += 1,
                Obstacle::Disc(_) => count.discs += 1,
            }
        }
        count
    }
}

/// A layer of a drawing.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify))]
pub struct LayerRead {
    /// Its name.
    pub name: String,
    /// How many shapes it has.
    pub shapes: usize,
    /// Why it was not read; absent if it was.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub omitted: Option<String>,
}

/// The way from the coordinates of a file to metres: (x - origin) times scale, for each axis; then `offset` is
/// subtracted. The axes are not turned.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify))]
pub struct PlaneRead {
    /// What is subtracted from coordinates of the file; of longitude and latitude, in degrees.
    pub origin: [f64; 2],
    /// Metres per unit of the file; negative where y points down.
    pub scale: [f64; 2],
    /// Of longitude and latitude, the most that a distance on the ellipsoid WGS 84 differs from that in the plane, in
    /// metres.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<f64>,
}

/// What was left out.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify))]
pub struct Dropped {
    /// What, in words.
    pub what: String,
    /// How many.
    pub count: usize,
    /// Of islands, their cells.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cells: Option<usize>,
}

impl Dropped {
    /// Those of which there are some, in words of the plural.
    pub(crate) fn counted(all: impl IntoIterator<Item = (impl Into<String>, usize)>) -> Vec<Self> {
        let some = all.into_iter().filter(|(_, count)| *count > 0);
        some.map(|(what, count)| Self { what: what.into(), count, cells: None }).collect()
    }
}

/// A query and what the file says of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), derive(tsify::Tsify))]
pub struct QueryRead {
    /// The name in the scenario.
    pub name: String,
    /// The bucket of a MovingAI scenario.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bucket: Option<u32>,
    /// The length that the file gives, of a path on the grid, in metres.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// Whether the start or the goal lies in an obstacle cell.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(all(target_arch = "wasm32", feature = "bindings"), tsify(optional))]
    pub blocked: bool,
}

impl Report {
    pub(crate) fn new(format: Format) -> Self {
        Self {
            format,
            files: Vec::new(),
            bounds: [[0.0; 2]; 2],
            offset: [0.0; 2],
            grid: None,
            plane: None,
            layers: Vec::new(),
            levels: Vec::new(),
            obstacles: Obstacles::default(),
            dropped: Vec::new(),
            grown: 0.0,
            robot: String::new(),
            queries: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// The report as JSON, on one line.
    pub fn to_json_string(&self) -> String {
        serde_json::to_string(self).expect("a report has no map with other keys than strings")
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "read {}:", self.format.as_str())?;
        for (i, file) in self.files.iter().enumerate() {
            let comma = if i == 0 { "" } else { "," };
            write!(f, "{comma} {} ({}, {} bytes)", file.name, file.kind, file.bytes)?;
        }
        if let Some(grid) = &self.grid {
            write!(f, "\n{grid}")?;
        }
        let [min, max] = self.bounds;
        write!(f, "\nbounds: x from {} to {}, y from {} to {}", min[0], max[0], min[1], max[1])?;
        if self.offset != [0.0; 2] {
            write!(f, "\nmoved: {:?} was subtracted from every coordinate", self.offset)?;
        }
        if let Some(PlaneRead { origin: [x, y], scale: [east, north], error }) = &self.plane {
            write!(f, "\nplane: x = {east} (x - {x}), y = {north} (y - {y}) in metres")?;
            if let Some(error) = error {
                write!(f, ", of longitude and latitude; distances differ by at most {error:.1e} m")?;
            }
        }
        let (read, left): (Vec<_>, Vec<_>) = self.layers.iter().partition(|layer| layer.omitted.is_none());
        for (what, layers) in [("layers", read), ("layers left out", left)] {
            for (i, LayerRead { name, shapes, omitted }) in layers.into_iter().enumerate() {
                let before = if i == 0 { format!("\n{what}: ") } else { ", ".to_owned() };
                let why = omitted.as_ref().map(|why| format!(", {why}")).unwrap_or_default();
                write!(f, "{before}{name:?} ({shapes}{why})")?;
            }
        }
        let Obstacles { polygons, holes, walls, discs, vertices } = self.obstacles;
        write!(f, "\nobstacles: {polygons} polygons")?;
        if holes > 0 {
            write!(f, " with {holes} holes")?;
        }
        if walls > 0 {
            write!(f, ", {walls} walls")?;
        }
        write!(f, ", {discs} discs; {vertices} corners")?;
        for Dropped { what, count, cells } in &self.dropped {
            write!(f, "\ndropped: {count} {what}")?;
            if let Some(cells) = cells {
                write!(f, " of {cells} cells")?;
            }
        }
        if self.grown > 0.0 {
            write!(f, "\ngrown: by at most {} m", at_most(self.grown))?;
        }
        write!(f, "\nrobot: {}", self.robot)?;
        write!(f, "\nqueries: {}", self.queries.len())?;
        let buckets = || self.queries.iter().filter_map(|query| query.bucket);
        if let (Some(low), Some(high)) = (buckets().min(), buckets().max()) {
            write!(f, ", buckets {low} to {high}")?;
        }
        let lengths = || self.queries.iter().filter_map(|query| query.length);
        if let (Some(low), Some(high)) = (lengths().reduce(f64::min), lengths().reduce(f64::max)) {
            write!(f, ", lengths on the grid {low:.3} to {high:.3} m")?;
        }
        let blocked = self.queries.iter().filter(|query| query.blocked).count();
        if blocked > 0 {
            write!(f, ", {blocked} with an end in an obstacle")?;
        }
        for note in &self.notes {
            write!(f, "\nnote: {note}")?;
        }
        Ok(())
    }
}

impl fmt::Display for GridRead {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { width, height, resolution, yaw, free, occupied, unknown, .. } = self;
        write!(f, "grid: {width} x {height} cells of {resolution} m")?;
        if *yaw != 0.0 {
            write!(f, ", turned by {yaw} rad")?;
        }
        let meaning = if self.unknown_is_occupied { "obstacles" } else { "free" };
        write!(f, "\ncells: {free} free, {occupied} occupied, {unknown} unknown")?;
        if self.transparent > 0 {
            write!(f, " ({} of them transparent)", self.transparent)?;
        }
        write!(f, "; unknown ones are {meaning}")?;
        if !self.kinds.is_empty() {
            let kinds: Vec<String> = self.kinds.iter().map(|(kind, count)| format!("{count} {kind}")).collect();
            write!(f, "\nkinds: {}", kinds.join(", "))?;
        }
        write!(f, "\nregions: {} islands of obstacles, {} enclosed free regions", self.islands, self.enclosed)?;
        if self.grown_cells > 0 {
            write!(f, "\nsimplified: {} more cells are obstacles", self.grown_cells)?;
        }
        let fewest = if self.fewest { ", the fewest possible" } else { "" };
        write!(f, "\nmerged: {} cells into {} rectangles{fewest}", self.merged_cells, self.rectangles)
    }
}
