//! Which files make up which world, by their content.

use crate::draft::{Draft, base};
use crate::error::{Code, FormatError, quoted};
use crate::grid::{Cell, Frame};
use crate::image::Picture;
use crate::numbers::{Table, note_scale, npy_grid};
use crate::options::{Coordinates, Options};
use crate::raster::add_grid;
use crate::report::{FileRead, Format};
use crate::ros::{Metadata, is_metadata};
use crate::text::{is_object, without_mark};
use crate::{File, MAX_BYTES, MAX_FILES, dxf, geojson, movingai, npy, ompl, rmf, svg, wkt};

/// What a file is.
enum Kind {
    Metadata(Metadata),
    Picture(Picture),
    MovingAiMap,
    MovingAiScenarios,
    OmplGrid,
    OmplCircles,
    OmplQueries,
    Npy,
    Numbers(Table, Format),
    GeoJson,
    Wkt,
    Building,
    Svg,
    Dxf,
}

impl Kind {
    /// What a file is, by its content.
    fn of(bytes: &[u8], options: &Options) -> Result<Self, FormatError> {
        if bytes.is_empty() {
            return Err(FormatError::new(Code::Truncated, "the file is empty"));
        }
        if bytes.len() > MAX_BYTES {
            let sentence = format!("the file has more than {MAX_BYTES} bytes, which are the most that are read");
            return Err(FormatError::new(Code::WorldTooLarge, sentence));
        }
        if let Some(kind) = by_first_bytes(bytes) {
            return Ok(kind);
        }
        if let Ok(text) = std::str::from_utf8(bytes) {
            if rmf::is_building(text) {
                return Ok(Self::Building);
            }
            if is_metadata(text) {
                return Metadata::read(text).map(Self::Metadata);
            }
        }
        if let Some(what) = known_but_not_read(bytes) {
            let sentence = format!("this is {what}, which is not read; {KNOWN}");
            return Err(FormatError::new(Code::UnknownWorld, sentence));
        }
        let table = Table::read(bytes).map_err(|error| match error.code() {
            Code::UnknownWorld => {
                let sentence = format!("the format of the file is not known ({error}); {KNOWN}");
                FormatError::new(Code::UnknownWorld, sentence)
            }
            _ => error,
        })?;
        match table.format(options) {
            Some(format) => Ok(Self::Numbers(table, format)),
            None => Err(FormatError::new(
                Code::UnknownWorld,
                format!(
                    "the numbers of the file are of no known shape (a grid of other numbers than 0, 1 and -1 needs a threshold); {KNOWN}"
                ),
            )),
        }
    }

    /// What it is, for the report.
    fn words(&self) -> &'static str {
        match self {
            Self::Metadata(_) => "YAML of a map",
            Self::Picture(picture) => picture.name(),
            Self::MovingAiMap => "MovingAI map",
            Self::MovingAiScenarios => "MovingAI scenarios",
            Self::OmplGrid => "grid of OMPL",
            Self::OmplCircles => "circles of OMPL",
            Self::OmplQueries => "queries of OMPL",
            Self::Npy => "NumPy array",
            Self::Numbers(_, Format::Tpcap) => "parking case",
            Self::Numbers(_, Format::ModernRobotics) => "obstacles of Modern Robotics",
            Self::Numbers(..) => "grid of numbers",
            Self::GeoJson => "GeoJSON",
            Self::Wkt => "WKT",
            Self::Building => "building of Open-RMF",
            Self::Svg => "SVG",
            Self::Dxf => "DXF",
        }
    }

    /// Whether it only adds to another file.
    fn is_addition(&self) -> bool {
        matches!(self, Self::MovingAiScenarios | Self::OmplQueries)
    }
}

/// What is read, for sentences.
const KNOWN: &str = "maps of ROS (YAML with PGM, PNG or BMP), MovingAI maps, 0-1 grids (text, CSV, npy), pictures (PNG, PGM, BMP), \
                     SVG, DXF, GeoJSON, WKT, buildings of Open-RMF, parking cases, and the files of Modern Robotics and OMPL are";

/// Whether bytes begin like a file of a known format. Numbers count too; of JSON, only GeoJSON does.
pub fn is_world(bytes: &[u8]) -> bool {
    let bytes = without_mark(bytes);
    by_first_bytes(bytes).is_some()
        || !is_object(bytes)
            && (std::str::from_utf8(bytes).is_ok_and(|text| is_metadata(text) || rmf::is_building(text))
                || Table::read(bytes).is_ok_and(|table| table.format(&Options::default()).is_some()))
}

fn by_first_bytes(bytes: &[u8]) -> Option<Kind> {
    // JSON is often one long line: other formats would read all of it.
    if is_object(bytes) {
        return geojson::is_geojson(bytes).then_some(Kind::GeoJson);
    }
    if let Some(picture) = Picture::of(bytes) {
        return Some(Kind::Picture(picture));
    }
    type IsKind = fn(&[u8]) -> bool;
    let kinds: [(IsKind, Kind); 9] = [
        (|bytes| bytes.starts_with(npy::MAGIC), Kind::Npy),
        (movingai::is_map, Kind::MovingAiMap),
        (movingai::is_scenarios, Kind::MovingAiScenarios),
        (ompl::is_grid, Kind::OmplGrid),
        (ompl::is_circles, Kind::OmplCircles),
        (ompl::is_queries, Kind::OmplQueries),
        (wkt::is_wkt, Kind::Wkt),
        (svg::is_svg, Kind::Svg),
        (dxf::is_dxf, Kind::Dxf),
    ];
    kinds.into_iter().find(|(is_it, _)| is_it(bytes)).map(|(_, kind)| kind)
}

/// A format that is recognised, so that the error can say so.
fn known_but_not_read(bytes: &[u8]) -> Option<&'static str> {
    let start = bytes.trim_ascii_start();
    let begins = |with: &[u8]| start.starts_with(with);
    match () {
        () if begins(b"{") || begins(b"[") => Some("JSON"),
        () if begins(b"<") => Some("XML, but not SVG"),
        () if begins(b"\xff\xd8\xff") => Some("JPEG"),
        () if begins(b"GIF8") => Some("GIF"),
        () if begins(b"RIFF") => Some("WebP"),
        () if begins(b"PK\x03\x04") => Some("a ZIP archive (such as npz)"),
        () if begins(b"\x1f\x8b") => Some("gzip"),
        () if begins(b"P1") || begins(b"P4") => Some("PBM"),
        () if begins(b"P3") || begins(b"P6") => Some("PPM"),
        () if begins(b"%PDF") => Some("PDF"),
        () => None,
    }
}

/// Reads the files of one world. A byte order mark before a file is skipped.
pub fn draft(files: &[File<'_>], options: &Options) -> Result<Draft, FormatError> {
    if files.is_empty() {
        return Err(FormatError::new(Code::InvalidOption, "no file is given"));
    }
    if files.len() > MAX_FILES {
        let sentence = format!("{} files are given; at most {MAX_FILES} make up a world", files.len());
        return Err(FormatError::new(Code::WorldTooLarge, sentence));
    }
    let whole = files;
    let files: Vec<File<'_>> =
        whole.iter().map(|&File { name, bytes }| File { name, bytes: without_mark(bytes) }).collect();
    let found: Vec<_> = files.iter().map(|file| Kind::of(file.bytes, options)).collect();
    // What a map names as its picture is never quoted: the map may come from anyone.
    let is_named = |file: &File<'_>| {
        found.iter().any(|kind| matches!(kind, Ok(Kind::Metadata(metadata)) if metadata.is_image(file.name)))
    };
    let named: Vec<bool> = files.iter().map(is_named).collect();
    let mut kinds = Vec::with_capacity(files.len());
    for ((file, kind), is_named) in files.iter().zip(found).zip(named) {
        let is_picture = matches!(kind, Ok(Kind::Picture(_)));
        let is_unread = matches!(&kind, Err(error) if error.code() == Code::UnknownWorld);
        if is_named && !is_picture && (kind.is_ok() || is_unread) {
            let sentence = "the YAML file names it as the picture, but it is no PGM, PNG or BMP";
            return Err(FormatError::new(Code::InvalidFile, sentence).in_file(file.name));
        }
        kinds.push((*file, kind.map_err(|error| error.in_file(file.name))?));
    }
    let main = main_file(&kinds)?;
    let (file, kind) = &kinds[main];
    check_fit(kind, options).map_err(|error| error.in_file(file.name))?;
    let mut used = vec![main];
    let mut draft = read_main(&kinds, main, &mut used, options)?;
    for (i, (file, kind)) in kinds.iter().enumerate() {
        match (&kinds[main].1, kind) {
            (Kind::MovingAiMap, Kind::MovingAiScenarios) => movingai::add_scenarios(&mut draft, file.bytes),
            (Kind::OmplCircles, Kind::OmplQueries) => ompl::add_queries(&mut draft, file.bytes),
            _ => continue,
        }
        .map_err(|error| error.in_file(file.name))?;
        used.push(i);
    }
    if let Some(i) = (0..kinds.len()).find(|i| !used.contains(i)) {
        let sentence =
            format!("this is {}, which does not belong to {}", kinds[i].1.words(), quoted(base(file.name).as_bytes()));
        return Err(FormatError::new(Code::UnusedFile, sentence).in_file(kinds[i].0.name));
    }
    draft.report.files = used
        .iter()
        .map(|&i| {
            let (file, kind) = &kinds[i];
            FileRead { name: file.name.to_owned(), bytes: whole[i].bytes.len(), kind: kind.words().to_owned() }
        })
        .collect();
    Ok(draft)
}

/// The file that the world is named after: the metadata of a map, else the first that stands alone.
fn main_file(kinds: &[(File<'_>, Kind)]) -> Result<usize, FormatError> {
    let metadata = kinds.iter().position(|(_, kind)| matches!(kind, Kind::Metadata(_)));
    let alone = || kinds.iter().position(|(_, kind)| !kind.is_addition());
    metadata.or_else(alone).ok_or_else(|| {
        let (file, kind) = &kinds[0];
        let wanted = match kind {
            Kind::MovingAiScenarios => movingai::map_of(file.bytes).unwrap_or_else(|| "its map".to_owned()),
            _ => "circle_obstacles.txt".to_owned(),
        };
        let sentence = format!("these are {}; the file {} is needed, too", kind.words(), quoted(wanted.as_bytes()));
        FormatError::missing(&wanted, sentence).in_file(file.name)
    })
}

/// Refuses options that have no meaning for a file.
fn check_fit(kind: &Kind, options: &Options) -> Result<(), FormatError> {
    let invalid = |option: &str, why: &str| {
        Err(FormatError::new(Code::InvalidOption, format!("the option {option} has no meaning for this format: {why}")))
    };
    let is_drawing = matches!(kind, Kind::Svg | Kind::Dxf | Kind::GeoJson | Kind::Wkt | Kind::Building);
    let is_list = matches!(kind, Kind::OmplCircles | Kind::Numbers(_, Format::Tpcap | Format::ModernRobotics));
    let is_vector = is_drawing || is_list;
    if options.scale.is_some() && matches!(kind, Kind::Metadata(_)) {
        return invalid("scale", "the YAML file has the resolution");
    }
    if options.scale.is_some() && is_list {
        return invalid("scale", "it has coordinates");
    }
    let takes_threshold = matches!(kind, Kind::Picture(_) | Kind::Npy | Kind::Numbers(_, Format::Grid));
    if options.threshold.is_some() && !takes_threshold {
        return invalid("threshold", "it says itself what is free");
    }
    if is_vector && options.min_island > 0 {
        return invalid("min_island", "it has no cells");
    }
    if is_vector && options.simplify > 0.0 {
        return invalid("simplify", "it has no cells");
    }
    for (is_given, option) in [
        (options.layers.is_some(), "layers"),
        (options.wall_thickness.is_some(), "wall_thickness"),
        (options.tolerance.is_some(), "tolerance"),
        (options.walkable.is_some(), "walkable"),
    ] {
        if is_given && !is_drawing {
            return invalid(option, "it is no drawing");
        }
    }
    if !options.fill.is_empty() && !matches!(kind, Kind::Dxf) {
        return invalid("fill", "it says itself what is filled");
    }
    if !options.filters.is_empty() && !matches!(kind, Kind::GeoJson) {
        return invalid("filters", "its shapes have no properties");
    }
    if options.level.is_some() && !matches!(kind, Kind::Building) {
        return invalid("level", "it is no building");
    }
    if options.coordinates != Coordinates::Auto && !matches!(kind, Kind::GeoJson | Kind::Wkt) {
        return invalid("coordinates", "they are never degrees");
    }
    Ok(())
}

/// Reads the main file, and the picture that it names.
fn read_main(
    kinds: &[(File<'_>, Kind)],
    main: usize,
    used: &mut Vec<usize>,
    options: &Options,
) -> Result<Draft, FormatError> {
    let (File { name, bytes }, kind) = &kinds[main];
    let draft = match kind {
        Kind::Metadata(metadata) => {
            let found = kinds.iter().enumerate().find_map(|(i, (file, kind))| match kind {
                Kind::Picture(picture) if metadata.is_image(file.name) => Some((i, *picture)),
                _ => None,
            });
            // A picture whose name is unknown, as from standard input, is taken if it is the only one.
            let mut pictures = kinds.iter().enumerate().filter_map(|(i, (file, kind))| match kind {
                Kind::Picture(picture) if file.name == "-" || file.name.is_empty() => Some((i, *picture)),
                _ => None,
            });
            let Some((i, picture)) = found.or_else(|| pictures.next()) else {
                let sentence =
                    format!("the picture {} is needed, too: the YAML file names it", quoted(metadata.image.as_bytes()));
                return Err(FormatError::missing(&metadata.image, sentence).in_file(name));
            };
            used.push(i);
            let file = kinds[i].0;
            return metadata.draft(name, picture, file.bytes, options).map_err(|error| error.in_file(file.name));
        }
        Kind::Picture(picture) => picture_alone(name, *picture, bytes, options),
        Kind::MovingAiMap => movingai::map(name, bytes, options),
        Kind::OmplGrid => ompl::grid(name, bytes, options),
        Kind::OmplCircles => ompl::circles(name, bytes),
        Kind::Npy => npy_grid(name, bytes, options),
        Kind::Numbers(table, Format::Tpcap) => table.parking(name),
        Kind::Numbers(table, Format::ModernRobotics) => table.modern_robotics(name),
        Kind::Numbers(table, _) => table.grid(name, options),
        Kind::Svg => svg::draft(name, bytes, options),
        Kind::Dxf => dxf::draft(name, bytes, options),
        Kind::GeoJson => geojson::draft(name, bytes, options),
        Kind::Wkt => wkt::draft(name, bytes, options),
        Kind::Building => rmf::draft(name, std::str::from_utf8(bytes).unwrap_or_default(), options),
        Kind::MovingAiScenarios | Kind::OmplQueries => unreachable!("it only adds to another file"),
    };
    draft.map_err(|error| error.in_file(name))
}

/// A picture without metadata: bright is free, transparent unknown.
fn picture_alone(name: &str, picture: Picture, bytes: &[u8], options: &Options) -> Result<Draft, FormatError> {
    let threshold = options.threshold.unwrap_or(0.5);
    if !(0.0..=1.0).contains(&threshold) {
        let sentence = format!("the threshold of a picture is a brightness from 0 to 1, not {threshold}");
        return Err(FormatError::new(Code::InvalidOption, sentence));
    }
    let mut transparent = 0;
    let cells = picture.read(bytes, |pixel| {
        if !pixel.is_opaque() {
            transparent += 1;
            Cell::Unknown
        } else if pixel.brightness() >= threshold {
            Cell::Free
        } else {
            Cell::Occupied
        }
    })?;
    let mut draft = Draft::new(Format::Picture, name);
    add_grid(&mut draft, cells.in_frame(Frame::of_scale(options.scale.unwrap_or(1.0))), options)?;
    if let Some(grid) = &mut draft.report.grid {
        grid.transparent = transparent;
    }
    draft
        .report
        .notes
        .push(format!("a picture without metadata: pixels of a brightness of {threshold} or more are free"));
    note_scale(&mut draft, options);
    Ok(draft)
}
