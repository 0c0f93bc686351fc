//! SVG: shapes with fill and stroke, by the specification (SVG 2, W3C 2018), without colours.

mod css;
mod lengths;
mod page;
mod path;
mod shapes;
mod style;
mod tree;
mod walk;

pub use tree::is_svg;

use crate::draft::Draft;
use crate::error::{FormatError, Place};
use crate::options::Options;
use crate::outline::add_shapes;
use crate::report::Format;
use crate::vector::{Drawing, Frame};
use css::Sheet;
use page::Page;
use tree::{Tree, line_of};
use walk::Walker;

/// The draft of a file.
pub fn draft(name: &str, bytes: &[u8], options: &Options) -> Result<Draft, FormatError> {
    read(bytes, options)?.into_draft(Format::Svg, name, Frame::of_scale(1.0), options)
}

/// Reads a file: a drawing in metres, y up, whose origin is the lower left corner of the page.
fn read(bytes: &[u8], options: &Options) -> Result<Drawing, FormatError> {
    let tree = Tree::read(bytes)?;
    let sheet = Sheet::read(&tree.styles);
    let mut drawing = Drawing::new();
    for (what, count) in &tree.dropped {
        drawing.drop(what, *count);
    }
    drawing.drop("rules of style sheets", sheet.dropped);
    let at = |error: FormatError, byte: usize| error.at_or(|| Place::Line(line_of(bytes, byte)));
    let root = &tree.elements[0];
    let page = Page::of(root, options.scale).map_err(|error| at(error, root.byte))?;
    let shapes = Walker::walk(&tree, &sheet, &page, options.layers.as_deref(), &mut drawing)
        .map_err(|(error, byte)| at(error, byte))?;
    add_shapes(&mut drawing, &shapes, options)?;
    drawing.page = page.area;
    drawing.notes.push(page.note);
    if shapes.iter().any(|shape| shape.stroke.is_some()) {
        drawing.notes.push("lines are walls of their width, with round ends".to_owned());
    }
    Ok(drawing)
}
