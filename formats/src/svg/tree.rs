//! The elements of an SVG file. No entity is expanded, nothing is fetched and nothing is run.

use crate::error::{Code, FormatError, Place, quoted};
use quick_xml::Reader;
use quick_xml::escape::unescape;
use quick_xml::events::{BytesStart, Event};
use std::collections::{BTreeMap, HashMap};

/// The most elements of a file.
const MAX_ELEMENTS: usize = 1_000_000;

/// How deep elements may be nested.
const MAX_DEPTH: usize = 256;

/// The attributes that mean something, without prefix.
#[rustfmt::skip]
const ATTRIBUTES: [&str; 51] = [
    "class", "clip-path", "clip-rule", "cx", "cy", "d", "display", "fill", "fill-opacity", "fill-rule", "filter",
    "groupmode", "height", "href", "id", "label", "marker", "marker-end", "marker-mid", "marker-start", "mask",
    "opacity", "points", "preserveAspectRatio", "r", "requiredExtensions", "rx", "ry", "stroke", "stroke-dasharray",
    "stroke-linecap", "stroke-linejoin", "stroke-miterlimit", "stroke-opacity", "stroke-width", "style",
    "systemLanguage", "transform", "transform-box", "transform-origin", "type", "vector-effect", "viewBox",
    "visibility", "width", "x", "x1", "x2", "y", "y1", "y2",
];

/// An element.
pub struct Element {
    /// Its name without prefix; empty for elements of other namespaces.
    pub name: Box<str>,
    attributes: Vec<(&'static str, Box<str>)>,
    pub parent: Option<usize>,
    pub children: Vec<usize>,
    /// The byte at which it begins.
    pub byte: usize,
}

impl Element {
    pub fn get(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(known, _)| *known == name).map(|(_, value)| &**value)
    }

    pub fn attributes(&self) -> impl Iterator<Item = (&'static str, &str)> {
        self.attributes.iter().map(|(name, value)| (*name, &**value))
    }
}

/// The elements in the order of the file; the first is the root.
pub struct Tree {
    pub elements: Vec<Element>,
    pub ids: HashMap<String, usize>,
    /// The text of all style elements.
    pub styles: String,
    /// What is left out, in the plural, and how many of each.
    pub dropped: BTreeMap<&'static str, usize>,
}

/// Whether a file may be SVG: its root element has that name.
pub fn is_svg(bytes: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(bytes) else { return false };
    if !text.trim_start().starts_with('<') {
        return false;
    }
    let mut reader = Reader::from_str(text);
    loop {
        match reader.read_event() {
            Ok(Event::Start(start) | Event::Empty(start)) => return start.local_name().as_ref() == "svg",
            Ok(Event::Eof) | Err(_) => return false,
            Ok(_) => {}
        }
    }
}

impl Tree {
    pub fn read(bytes: &[u8]) -> Result<Self, FormatError> {
        let text = std::str::from_utf8(bytes).map_err(|error| {
            let sentence = "the file is no UTF-8, the only encoding of SVG that is read";
            FormatError::new(Code::UnsupportedFeature, sentence).at(Place::Byte(error.valid_up_to()))
        })?;
        let mut builder = Builder {
            tree: Self { elements: Vec::new(), ids: HashMap::new(), styles: String::new(), dropped: BTreeMap::new() },
            open: Vec::new(),
            prefix: None,
            namespace: None,
        };
        let mut reader = Reader::from_str(text);
        loop {
            let byte = usize::try_from(reader.buffer_position()).unwrap_or(usize::MAX);
            let line = || Place::Line(line_of(bytes, byte));
            let event = reader.read_event().map_err(|error| {
                let code = match error {
                    quick_xml::Error::Syntax(_) => Code::Truncated,
                    _ => Code::InvalidFile,
                };
                FormatError::new(code, format!("this is no XML: {error}")).at(line())
            })?;
            if matches!(event, Event::Eof) {
                break;
            }
            builder.add(event, byte).map_err(|error| error.at_or(line))?;
        }
        if !builder.open.is_empty() {
            let sentence = format!("the file ends within {} elements", builder.open.len());
            return Err(FormatError::new(Code::Truncated, sentence));
        }
        if builder.tree.elements.is_empty() {
            return Err(FormatError::new(Code::Truncated, "the file has no element"));
        }
        Ok(builder.tree)
    }
}

/// The line of a byte.
pub fn line_of(bytes: &[u8], byte: usize) -> usize {
    // The position is the end of what was read before, so blanks and line ends are skipped.
    let rest = &bytes[byte.min(bytes.len())..];
    let blanks = rest.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
    let before = &bytes[..(byte + blanks).min(bytes.len())];
    1 + before.iter().filter(|&&byte| byte == b'\n').count()
}

struct Builder {
    tree: Tree,
    /// The elements that are open, and whether each is of another namespace.
    open: Vec<(usize, bool)>,
    prefix: Option<String>,
    /// The default namespace of the root.
    namespace: Option<String>,
}

impl Builder {
    fn add(&mut self, event: Event<'_>, byte: usize) -> Result<(), FormatError> {
        match event {
            Event::Start(start) => self.start(&start, byte, false),
            Event::Empty(start) => self.start(&start, byte, true),
            Event::End(_) => {
                self.open.pop();
                Ok(())
            }
            Event::Text(text) if self.is_in_style() => {
                self.tree.styles.push_str(&text);
                Ok(())
            }
            Event::CData(text) if self.is_in_style() => {
                self.tree.styles.push_str(&text);
                Ok(())
            }
            Event::GeneralRef(reference) => {
                let text = unescape(&format!("&{};", &*reference)).map(|text| text.into_owned()).map_err(|_| {
                    let sentence = format!("the entity {} is not expanded", quoted(reference.as_bytes()));
                    FormatError::new(Code::UnsupportedFeature, sentence)
                })?;
                if self.is_in_style() {
                    self.tree.styles.push_str(&text);
                }
                Ok(())
            }
            Event::PI(instruction) if instruction.target() == "xml-stylesheet" => {
                self.drop("style sheets of other files, which are not fetched");
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn drop(&mut self, what: &'static str) {
        *self.tree.dropped.entry(what).or_default() += 1;
    }

    fn is_in_style(&self) -> bool {
        self.open.last().is_some_and(|&(i, _)| {
            let element = &self.tree.elements[i];
            &*element.name == "style" && element.get("type").is_none_or(|kind| kind.trim() == "text/css")
        })
    }

    fn start(&mut self, start: &BytesStart<'_>, byte: usize, is_empty: bool) -> Result<(), FormatError> {
        let too_many = |sentence: String| Err(FormatError::new(Code::WorldTooLarge, sentence));
        if self.tree.elements.len() == MAX_ELEMENTS {
            return too_many(format!("the file has more than {MAX_ELEMENTS} elements"));
        }
        if self.open.len() == MAX_DEPTH {
            return too_many(format!("elements are nested deeper than {MAX_DEPTH}"));
        }
        let full = start.name();
        let (prefix, name) = split(full.as_ref());
        let parent = self.open.last().copied();
        if parent.is_none() && !self.tree.elements.is_empty() {
            return Err(FormatError::new(Code::InvalidFile, "the file has more than one root element"));
        }
        let (attributes, namespace) = self.attributes(start)?;
        let is_foreign = match parent {
            None => {
                self.prefix = prefix.map(str::to_owned);
                self.namespace = namespace;
                false
            }
            Some((_, is_foreign)) => {
                let is_other = prefix.is_none() && namespace.is_some() && namespace != self.namespace;
                is_foreign || prefix != self.prefix.as_deref() || is_other
            }
        };
        let i = self.tree.elements.len();
        let element = Element {
            name: if is_foreign { "" } else { name }.into(),
            attributes,
            parent: parent.map(|(parent, _)| parent),
            children: Vec::new(),
            byte,
        };
        if let Some(id) = element.get("id").filter(|_| !is_foreign) {
            // The first one counts, as in browsers.
            self.tree.ids.entry(id.to_owned()).or_insert(i);
        }
        if let Some((parent, _)) = parent {
            self.tree.elements[parent].children.push(i);
        }
        self.tree.elements.push(element);
        if !is_empty {
            self.open.push((i, is_foreign));
        }
        Ok(())
    }

    /// The attributes that are known, and the default namespace that is declared.
    #[allow(clippy::type_complexity)]
    fn attributes(
        &self,
        start: &BytesStart<'_>,
    ) -> Result<(Vec<(&'static str, Box<str>)>, Option<String>), FormatError> {
        let mut known = Vec::new();
        let mut namespace = None;
        for attribute in start.attributes().with_checks(false) {
            let attribute = attribute
                .map_err(|error| FormatError::new(Code::InvalidFile, format!("an attribute is wrong: {error}")))?;
            let key = attribute.key;
            let (prefix, name) = split(key.as_ref());
            if key.as_ref() == "xmlns" {
                namespace = Some(attribute.value.into_owned());
                continue;
            }
            let counts = match prefix {
                None => !matches!(name, "label" | "groupmode"),
                Some("inkscape") => matches!(name, "label" | "groupmode"),
                Some(_) => name == "href",
            };
            let Some(name) = ATTRIBUTES.into_iter().find(|known| counts && *known == name) else { continue };
            if known.iter().any(|(other, _)| *other == name) {
                continue;
            }
            let value = unescape(&attribute.value).map_err(|error| {
                let sentence = format!("{name} has an entity that is not expanded: {error}");
                FormatError::new(Code::UnsupportedFeature, sentence)
            })?;
            known.push((name, value.into()));
        }
        Ok((known, namespace))
    }
}

/// The prefix and the name of a qualified name.
fn split(full: &str) -> (Option<&str>, &str) {
    match full.split_once(':') {
        Some((prefix, name)) => (Some(prefix), name),
        None => (None, full),
    }
}
