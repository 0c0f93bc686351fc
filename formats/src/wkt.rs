//! Well-known text (OGC 06-103r4): one geometry or several, one after another. What follows x and y, Z and M, is left out.

use crate::draft::Draft;
use crate::error::{Code, FormatError, Place, quoted};
use crate::options::Options;
use crate::plane::{self, Said};
use crate::report::Format;
use crate::text;
use crate::vector::{Drawing, FillRule, Form};
use planarium::geometry::Point;
use planarium::scenario::MAX_VERTICES;

/// How deep collections may lie in each other.
const MAX_DEPTH: usize = 64;

/// The geometries that are read. A linear ring is a line; the faces of surfaces and meshes are polygons.
const KINDS: [(&str, Kind); 11] = [
    ("POINT", Kind::Point),
    ("LINESTRING", Kind::Line),
    ("LINEARRING", Kind::Line),
    ("POLYGON", Kind::Polygon),
    ("TRIANGLE", Kind::Polygon),
    ("MULTIPOINT", Kind::Points),
    ("MULTILINESTRING", Kind::Lines),
    ("MULTIPOLYGON", Kind::Polygons),
    ("POLYHEDRALSURFACE", Kind::Polygons),
    ("TIN", Kind::Polygons),
    ("GEOMETRYCOLLECTION", Kind::Collection),
];

/// Geometries of the standard that are not read.
const CURVES: [&str; 6] = ["CIRCULARSTRING", "COMPOUNDCURVE", "CURVEPOLYGON", "MULTICURVE", "MULTISURFACE", "CIRCLE"];

#[derive(Clone, Copy)]
enum Kind {
    Point,
    Line,
    Polygon,
    Points,
    Lines,
    Polygons,
    Collection,
}

/// Whether the file begins with the word of a geometry, or with a reference system and a geometry.
pub fn is_wkt(bytes: &[u8]) -> bool {
    let mut reader = Reader::of(bytes);
    let word = reader.word().to_ascii_uppercase();
    word == "SRID" && reader.rest().starts_with(b"=") || is_kind(without_dimensions(&word))
}

/// Reads a file.
pub fn draft(name: &str, bytes: &[u8], options: &Options) -> Result<Draft, FormatError> {
    let mut reader = Reader::of(bytes);
    let mut said = Said::Nothing { usually_degrees: false };
    let mut count = 0;
    while reader.skip_separators() {
        let start = reader.at;
        let word = reader.word();
        if word.eq_ignore_ascii_case("SRID") {
            said = match reader.system()? {
                4326 => Said::Degrees,
                other => Said::Other(format!("EPSG:{other}")),
            };
            continue;
        }
        reader.at = start;
        reader.geometry(0)?;
        count += 1;
    }
    let Reader { mut drawing, extra, open_rings, .. } = reader;
    drawing.may_be_walkable = true;
    let mut draft = plane::draft(drawing, Format::Wkt, name, &said, options)?;
    draft.report.notes.push(format!("{count} geometries; layers are the kinds of shapes"));
    for (count, what) in [
        (open_rings, "rings are not closed in the file; they were closed"),
        (extra, "positions have Z or M, which are left out"),
    ] {
        if count > 0 {
            draft.report.notes.push(format!("{count} {what}"));
        }
    }
    Ok(draft)
}

/// Whether a word in capitals names a geometry.
fn is_kind(word: &str) -> bool {
    KINDS.iter().any(|(name, _)| *name == word) || CURVES.contains(&word)
}

/// The word of a geometry without Z, M or ZM at its end.
fn without_dimensions(word: &str) -> &str {
    ["ZM", "Z", "M"].iter().filter_map(|end| word.strip_suffix(end)).find(|plain| is_kind(plain)).unwrap_or(word)
}

struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
    drawing: Drawing,
    points: usize,
    extra: usize,
    open_rings: usize,
}

impl<'a> Reader<'a> {
    fn of(bytes: &'a [u8]) -> Self {
        let mut reader = Self { bytes, at: 0, drawing: Drawing::new(), points: 0, extra: 0, open_rings: 0 };
        reader.skip_blanks();
        reader
    }

    fn rest(&self) -> &'a [u8] {
        &self.bytes[self.at..]
    }

    fn skip_blanks(&mut self) {
        self.at = self.bytes.len() - self.rest().trim_ascii_start().len();
    }

    /// Skips what may stand between geometries; false at the end of the file.
    fn skip_separators(&mut self) -> bool {
        self.skip_blanks();
        while matches!(self.rest().first(), Some(b';' | b',')) {
            self.at += 1;
            self.skip_blanks();
        }
        !self.rest().is_empty()
    }

    /// The letters here, in the case of the file, and the blanks after them.
    fn word(&mut self) -> &'a str {
        let rest = self.rest();
        let length = rest.iter().take_while(|byte| byte.is_ascii_alphabetic()).count();
        self.at += length;
        self.skip_blanks();
        std::str::from_utf8(&rest[..length]).unwrap_or_default()
    }

    fn takes(&mut self, byte: u8) -> bool {
        let is_there = self.rest().first() == Some(&byte);
        if is_there {
            self.at += 1;
            self.skip_blanks();
        }
        is_there
    }

    fn error(&self, code: Code, message: String) -> FormatError {
        FormatError::new(code, message).at(Place::Byte(self.at))
    }

    fn expect(&mut self, byte: u8) -> Result<(), FormatError> {
        if self.takes(byte) {
            return Ok(());
        }
        let wanted = char::from(byte);
        Err(match self.rest() {
            [] => self.error(Code::Truncated, format!("the file ends where {wanted:?} is expected")),
            rest => {
                let found = quoted(&rest[..rest.len().min(12)]);
                self.error(Code::InvalidFile, format!("{found} stands where {wanted:?} is expected"))
            }
        })
    }

    /// `=4326;` after the word `SRID`.
    fn system(&mut self) -> Result<usize, FormatError> {
        self.expect(b'=')?;
        let rest = self.rest();
        let length = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let number = text::count(&rest[..length])
            .ok_or_else(|| self.error(Code::InvalidNumber, "SRID is a whole number".to_owned()))?;
        self.at += length;
        self.skip_blanks();
        self.expect(b';')?;
        Ok(number)
    }

    fn geometry(&mut self, depth: usize) -> Result<(), FormatError> {
        if depth > MAX_DEPTH {
            let sentence = format!("collections lie more than {MAX_DEPTH} deep in each other");
            return Err(self.error(Code::WorldTooLarge, sentence));
        }
        let start = self.at;
        let word = self.word().to_ascii_uppercase();
        let plain = without_dimensions(&word);
        let Some(&(_, kind)) = KINDS.iter().find(|(name, _)| *name == plain) else {
            self.at = start;
            let found = quoted(&self.rest()[..self.rest().len().min(24)]);
            return Err(match self.rest() {
                [] => self.error(Code::Truncated, "the file ends where a geometry is expected".to_owned()),
                _ if CURVES.contains(&plain) => {
                    self.error(Code::UnsupportedFeature, format!("{plain} has curves, which are not read"))
                }
                _ => self.error(Code::InvalidFile, format!("{found} is no geometry")),
            });
        };
        let mut mark = self.at;
        let mut next = self.word();
        if ["Z", "M", "ZM"].iter().any(|dimensions| next.eq_ignore_ascii_case(dimensions)) {
            mark = self.at;
            next = self.word();
        }
        if next.eq_ignore_ascii_case("EMPTY") {
            self.drawing.drop("empty geometries", 1);
            return Ok(());
        }
        self.at = mark;
        match kind {
            Kind::Point => {
                self.expect(b'(')?;
                self.spot()?;
                self.expect(b')')
            }
            // The points of several may stand in brackets of their own.
            Kind::Points => self.list(|reader| match reader.takes(b'(') {
                true => reader.spot().and_then(|()| reader.expect(b')')),
                false if reader.skips_empty() => Ok(()),
                false => reader.spot(),
            }),
            Kind::Line => self.line(),
            Kind::Lines => self.list(|reader| if reader.skips_empty() { Ok(()) } else { reader.line() }),
            Kind::Polygon => self.polygon(),
            Kind::Polygons => self.list(|reader| if reader.skips_empty() { Ok(()) } else { reader.polygon() }),
            Kind::Collection => self.list(|reader| reader.geometry(depth + 1)),
        }
    }

    /// Skips the word `EMPTY` among the parts of a geometry.
    fn skips_empty(&mut self) -> bool {
        let start = self.at;
        let is_empty = self.word().eq_ignore_ascii_case("EMPTY");
        if is_empty {
            self.drawing.drop("empty geometries", 1);
        } else {
            self.at = start;
        }
        is_empty
    }

    /// Items in brackets, with commas between them.
    fn list(&mut self, mut item: impl FnMut(&mut Self) -> Result<(), FormatError>) -> Result<(), FormatError> {
        self.expect(b'(')?;
        item(self)?;
        while self.takes(b',') {
            item(self)?;
        }
        self.expect(b')')
    }

    fn spot(&mut self) -> Result<(), FormatError> {
        let place = self.position()?;
        let layer = self.drawing.layer("points");
        self.drawing.push(layer, Form::Spot(place));
        Ok(())
    }

    fn line(&mut self) -> Result<(), FormatError> {
        let points = self.positions()?;
        let layer = self.drawing.layer("lines");
        self.drawing.push(layer, Form::Line { points, closed: false, width: None });
        Ok(())
    }

    fn polygon(&mut self) -> Result<(), FormatError> {
        let mut rings = Vec::new();
        self.list(|reader| {
            if !reader.skips_empty() {
                let ring = reader.positions()?;
                reader.open_rings += usize::from(ring.first() != ring.last());
                rings.push(ring);
            }
            Ok(())
        })?;
        let layer = self.drawing.layer("areas");
        self.drawing.push(layer, Form::Area { rings, rule: FillRule::EvenOdd });
        Ok(())
    }

    fn positions(&mut self) -> Result<Vec<Point>, FormatError> {
        let mut points = Vec::new();
        self.list(|reader| {
            points.push(reader.position()?);
            Ok(())
        })?;
        Ok(points)
    }

    /// Two numbers, and up to two that are left out.
    fn position(&mut self) -> Result<Point, FormatError> {
        self.points += 1;
        if self.points > MAX_VERTICES {
            let sentence = format!("there are more than {MAX_VERTICES} positions, the most of a scenario");
            return Err(self.error(Code::WorldTooLarge, sentence));
        }
        let point = Point::new(self.number()?, self.number()?);
        let mut extra = 0;
        while extra < 2 && !matches!(self.rest().first(), None | Some(b',' | b')')) {
            self.number()?;
            extra += 1;
        }
        self.extra += usize::from(extra > 0);
        Ok(point)
    }

    fn number(&mut self) -> Result<f64, FormatError> {
        let rest = self.rest();
        let length = rest.iter().take_while(|byte| !byte.is_ascii_whitespace() && !b"(),;".contains(byte)).count();
        let word = &rest[..length];
        let Some(number) = text::number(word) else {
            return Err(match rest {
                [] => self.error(Code::Truncated, "the file ends where a number is expected".to_owned()),
                _ => self.error(Code::InvalidNumber, format!("{} is not a finite number", quoted(word))),
            });
        };
        self.at += length;
        self.skip_blanks();
        Ok(number)
    }
}
