//! DXF as text: lines, curves and areas, by the reference of AutoCAD (DXF Reference, Autodesk).

mod hatch;
mod pairs;
mod shapes;
mod spline;
mod tables;
mod walk;

use crate::draft::Draft;
use crate::error::{Code, FormatError};
use crate::options::Options;
use crate::outline::add_shapes;
use crate::report::Format;
use crate::vector::{Drawing, Frame};
use pairs::Pairs;
use tables::Tables;
use walk::Walker;

/// How a binary file begins.
const BINARY: &[u8] = b"AutoCAD Binary DXF";

/// Whether a file is DXF: it begins with a section, or it is binary.
pub fn is_dxf(bytes: &[u8]) -> bool {
    bytes.starts_with(BINARY) || Pairs::of(bytes).next().is_ok_and(|pair| pair.is(0, "SECTION"))
}

/// Metres per unit and the name of the unit, by the number of `$INSUNITS`.
fn unit(number: i64) -> Option<(f64, &'static str)> {
    const UNITS: [(f64, &str); 24] = [
        (0.0254, "inches"),
        (0.3048, "feet"),
        (1609.344, "miles"),
        (1e-3, "millimetres"),
        (1e-2, "centimetres"),
        (1.0, "metres"),
        (1e3, "kilometres"),
        (0.0254e-6, "microinches"),
        (0.0254e-3, "mils"),
        (0.9144, "yards"),
        (1e-10, "angstroms"),
        (1e-9, "nanometres"),
        (1e-6, "micrometres"),
        (0.1, "decimetres"),
        (10.0, "decametres"),
        (100.0, "hectometres"),
        (1e9, "gigametres"),
        (149_597_870_700.0, "astronomical units"),
        (9_460_730_472_580_800.0, "light years"),
        (3.085_677_581_491_367e16, "parsecs"),
        (1200.0 / 3937.0, "US survey feet"),
        (100.0 / 3937.0, "US survey inches"),
        (3600.0 / 3937.0, "US survey yards"),
        (6_336_000.0 / 3937.0, "US survey miles"),
    ];
    UNITS.get(usize::try_from(number.checked_sub(1)?).ok()?).copied()
}

/// The draft of a file.
pub fn draft(name: &str, bytes: &[u8], options: &Options) -> Result<Draft, FormatError> {
    read(bytes, options)?.into_draft(Format::Dxf, name, Frame::of_scale(1.0), options)
}

/// Reads a file: a drawing in metres.
fn read(bytes: &[u8], options: &Options) -> Result<Drawing, FormatError> {
    if bytes.starts_with(BINARY) {
        let sentence = "this is binary DXF; only DXF as text is read, which every program that writes it can write";
        return Err(FormatError::new(Code::UnsupportedFeature, sentence));
    }
    let tables = Tables::read(bytes)?;
    let (scale, note) = match (options.scale, unit(tables.units)) {
        (Some(scale), _) => (scale, format!("a unit of the drawing is {scale} m, as given")),
        (None, Some((scale, name))) => (scale, format!("the drawing is in {name}: a unit is {scale} m")),
        (None, None) => (1.0, "a unit of the drawing is 1 m: the file has no units, and no scale is given".to_owned()),
    };
    let mut drawing = Drawing::new();
    let shapes = Walker::walk(&tables, scale, options, &mut drawing)?;
    add_shapes(&mut drawing, &shapes, options)?;
    drawing.notes.push(note);
    let closed = |shape: &&crate::outline::Shape| shape.fill.is_none() && shape.paths.iter().any(|path| path.closed);
    let outlines = shapes.iter().filter(closed).count();
    if outlines > 0 {
        drawing
            .notes
            .push(format!("{outlines} closed lines are walls around free places; the option fill makes them areas"));
    }
    Ok(drawing)
}
