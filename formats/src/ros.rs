//! Maps of ROS's `map_server`: a YAML file with the metadata, and the picture that it names.
//!
//! Cells are read as Nav2's `map_io.cpp` reads them. Brightness p is the mean of the channels; occ is p if `negate` is
//! set, else 1 - p.
//! - `trinary`: occupied if occ > `occupied_thresh`, free if occ < `free_thresh`, else unknown; opacity counts as a
//!   further channel;
//! - `scale`: the same, and a pixel that is not opaque is unknown; what lies between the thresholds is a cost, no
//!   obstacle in a costmap's sense and not free either: it counts as unknown;
//! - `raw`: the brightness from 0 to 255 is the value of the cell: 0 is free, 100 occupied, all else unknown.
//!
//! One thing differs: a pixel that is wholly transparent is unknown in every mode, since nothing of its colour can be
//! seen. Row 0 is the highest y. `origin` is the pose of the lower left corner.

use crate::draft::{Draft, FAR, base};
use crate::error::{Code, FormatError, Place, quoted};
use crate::grid::{Cell, Frame};
use crate::image::{Picture, Pixel};
use crate::options::Options;
use crate::raster::add_grid;
use crate::report::Format;
use crate::yaml::{self, Node, Value};
use planarium::geometry::Point;

/// The metadata of a map.
pub struct Metadata {
    /// The name of the picture.
    pub image: String,
    resolution: f64,
    origin: [f64; 3],
    negate: bool,
    occupied: f64,
    free: f64,
    mode: Mode,
    /// Keys that are not read.
    unread: Vec<String>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Mode {
    Trinary,
    Scale,
    Raw,
}

/// The keys that are read.
const KEYS: [&str; 7] = ["image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode"];

/// Whether text looks like the metadata of a map: it has the key `image` at the beginning of a line, or two others.
pub fn is_metadata(text: &str) -> bool {
    let mut keys = text.lines().filter_map(|line| {
        let (key, _) = line.trim_start_matches(['{', ' ']).split_once(':')?;
        Some(key.trim_end().trim_matches(['"', '\'']))
    });
    let [mut resolution, mut origin] = [false; 2];
    keys.any(|key| {
        resolution |= key == "resolution";
        origin |= key == "origin";
        key == "image" || resolution && origin
    })
}

impl Metadata {
    pub fn read(text: &str) -> Result<Self, FormatError> {
        let root = yaml::read(text)?;
        let entries = root.pairs();
        let find = |key: &str| entries.iter().find(|entry| entry.0 == key);
        let required = |key: &'static str| {
            find(key).ok_or_else(|| {
                FormatError::new(Code::InvalidFile, format!("the key \"{key}\" is missing"))
                    .at(Place::Element(key.to_owned()))
            })
        };
        let image = scalar(required("image")?)?.to_owned();
        if image.is_empty() {
            return Err(invalid(required("image")?, "the name of the picture is empty".to_owned()));
        }
        let resolution_entry = required("resolution")?;
        let resolution = number(resolution_entry, scalar(resolution_entry)?)?;
        if resolution <= 0.0 {
            return Err(out_of_range(resolution_entry, format!("the resolution must be positive, not {resolution}")));
        }
        let origin_entry = required("origin")?;
        let numbers = || origin_entry.1.items().iter().map(Node::text).collect::<Option<Vec<&str>>>();
        let Some(list) = numbers().filter(|_| matches!(origin_entry.1.value, Value::List(_))) else {
            return Err(invalid(origin_entry, "the origin is a list [x, y, yaw]".to_owned()));
        };
        let numbers = list.iter().map(|text| number(origin_entry, text)).collect::<Result<Vec<f64>, _>>()?;
        let &[x, y, yaw] = &numbers[..] else {
            return Err(invalid(
                origin_entry,
                format!("the origin has 3 numbers, x, y and yaw, not {}", numbers.len()),
            ));
        };
        let share = |key: &'static str| -> Result<f64, FormatError> {
            let entry = required(key)?;
            let value = number(entry, scalar(entry)?)?;
            if !(0.0..=1.0).contains(&value) {
                return Err(out_of_range(entry, format!("{key} is from 0 to 1, not {value}")));
            }
            Ok(value)
        };
        let (occupied, free) = (share("occupied_thresh")?, share("free_thresh")?);
        if free > occupied {
            let sentence = format!("free_thresh {free} is above occupied_thresh {occupied}");
            return Err(out_of_range(required("free_thresh")?, sentence));
        }
        let negate_entry = required("negate")?;
        let negate = match scalar(negate_entry)?.to_ascii_lowercase().as_str() {
            "0" | "false" | "no" | "off" => false,
            "1" | "true" | "yes" | "on" => true,
            other => {
                return Err(invalid(negate_entry, format!("negate is 0 or 1, not {}", quoted(other.as_bytes()))));
            }
        };
        let mode = match find("mode").map(|entry| Ok((entry, scalar(entry)?))).transpose()? {
            None | Some((_, "trinary")) => Mode::Trinary,
            Some((_, "scale")) => Mode::Scale,
            Some((_, "raw")) => Mode::Raw,
            Some((entry, other)) => {
                let sentence = format!("the mode is trinary, scale or raw, not {}", quoted(other.as_bytes()));
                return Err(invalid(entry, sentence));
            }
        };
        let unread = entries.iter().filter(|entry| !KEYS.contains(&&*entry.0)).map(|entry| entry.0.clone()).collect();
        Ok(Self { image, resolution, origin: [x, y, yaw], negate, occupied, free, mode, unread })
    }

    /// What a pixel is.
    fn cell(&self, pixel: Pixel) -> Cell {
        if pixel.is_clear() {
            return Cell::Unknown;
        }
        let brightness = if self.mode == Mode::Trinary { pixel.with_alpha() } else { pixel.brightness() };
        let occupied = if self.negate { brightness } else { 1.0 - brightness };
        match self.mode {
            Mode::Raw => match (brightness * 255.0).round() as u32 {
                0 => Cell::Free,
                100 => Cell::Occupied,
                _ => Cell::Unknown,
            },
            Mode::Scale if !pixel.is_opaque() => Cell::Unknown,
            _ if self.occupied < occupied => Cell::Occupied,
            _ if occupied < self.free => Cell::Free,
            _ => Cell::Unknown,
        }
    }

    /// The map of a picture; `name` is that of the YAML file.
    pub fn draft(&self, name: &str, picture: Picture, bytes: &[u8], options: &Options) -> Result<Draft, FormatError> {
        let mut transparent = 0;
        let cells = picture.read(bytes, |pixel| {
            transparent += usize::from(pixel.is_clear());
            self.cell(pixel)
        })?;
        let [x, y, yaw] = self.origin;
        let mut draft = Draft::new(Format::RosMap, name);
        let frame = Frame { origin: Point::origin(), resolution: self.resolution, yaw };
        let mut grid = cells.in_frame(frame);
        if x.abs().max(y.abs()) > FAR {
            let middle = grid.corner(grid.width as f64 / 2.0, grid.height as f64 / 2.0);
            draft.moved = Point::new((x + middle.x).round(), (y + middle.y).round());
        }
        grid.frame.origin = Point::new(x - draft.moved.x, y - draft.moved.y);
        add_grid(&mut draft, grid, options)?;
        if let Some(grid) = &mut draft.report.grid {
            grid.transparent = transparent;
        }
        if !self.unread.is_empty() {
            let keys: Vec<String> = self.unread.iter().map(|key| quoted(key.as_bytes())).collect();
            draft.report.notes.push(format!("keys of the YAML file that are not read: {}", keys.join(", ")));
        }
        Ok(draft)
    }

    /// Whether this file is the picture.
    pub fn is_image(&self, file: &str) -> bool {
        base(file) == base(&self.image)
    }
}

/// A key and its value.
type Entry = (String, Node);

fn invalid(entry: &Entry, message: String) -> FormatError {
    FormatError::at_line(Code::InvalidFile, entry.1.line, message)
}

fn out_of_range(entry: &Entry, message: String) -> FormatError {
    FormatError::at_line(Code::InvalidNumber, entry.1.line, message)
}

fn scalar(entry: &Entry) -> Result<&str, FormatError> {
    entry.1.text().ok_or_else(|| invalid(entry, format!("{} is one value", entry.0)))
}

/// A finite number, as YAML writes them.
fn number(entry: &Entry, text: &str) -> Result<f64, FormatError> {
    let text = text.trim();
    let is_special = text.trim_start_matches(['+', '-']).to_ascii_lowercase();
    if [".inf", ".nan", "inf", "nan", "infinity"].contains(&&*is_special) {
        return Err(out_of_range(entry, format!("{} must be finite, not {text}", entry.0)));
    }
    let value: f64 = text
        .parse()
        .map_err(|_| invalid(entry, format!("{} has a number where {} stands", entry.0, quoted(text.as_bytes()))))?;
    if value.is_finite() {
        Ok(value)
    } else {
        Err(out_of_range(entry, format!("{} must be finite, not {text}", entry.0)))
    }
}
