//! What is read of a document, by serde. Properties are kept as text; positions take no more memory than four times
//! their text.

use crate::error::{Code, FormatError};
use planarium::geometry::Point;
use serde::Deserialize;
use serde::de::{self, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use std::collections::BTreeMap;
use std::fmt;

/// An object of GeoJSON, whatever it is.
#[derive(Deserialize)]
pub struct Object {
    #[serde(rename = "type")]
    pub kind: Option<String>,
    pub coordinates: Option<Coordinates>,
    pub geometries: Option<Vec<Object>>,
    pub geometry: Option<Box<Object>>,
    pub features: Option<Vec<Object>>,
    pub properties: Option<Properties>,
    pub feature_type: Option<Scalar>,
    pub crs: Option<Crs>,
}

/// A reference system: an object with its name among the properties, or, as some programs write it, the name alone.
#[derive(Deserialize)]
#[serde(untagged)]
pub enum Crs {
    Object { properties: Option<Properties> },
    Name(Scalar),
}

impl Crs {
    /// Its name; its EPSG code, where an object of the first edition of GeoJSON (2007) has that.
    pub fn name(&self) -> Option<&str> {
        match self {
            Self::Object { properties: Some(Properties(all)) } => {
                all.get("name").or_else(|| all.get("code")).map(String::as_str)
            }
            Self::Object { properties: None } => None,
            Self::Name(name) => name.0.as_deref(),
        }
    }

    /// Whether coordinates are longitude and latitude on WGS 84.
    pub fn is_degrees(name: &str) -> bool {
        let name = name.trim().to_ascii_uppercase().replace(' ', "");
        name == "4326" || ["CRS84", "EPSG::4326", "EPSG:4326", "WGS84"].iter().any(|known| name.ends_with(known))
    }
}

/// The properties that are text, numbers or truth values, as text.
#[derive(Default)]
pub struct Properties(pub BTreeMap<String, String>);

/// Text, a number or a truth value; `None` for anything else.
pub struct Scalar(pub Option<String>);

/// Positions, in lists of lists.
pub enum Coordinates {
    Position { point: Point, is_flat: bool },
    List(Vec<Coordinates>),
}

/// What the beginning of a document says.
#[derive(Deserialize)]
pub struct Head {
    #[serde(rename = "type")]
    pub kind: Option<String>,
    #[serde(rename = "format")]
    _format: Option<OtherFormat>,
}

/// The field `format` of another document. Reading it is an error, so that nothing more is read.
struct OtherFormat;

/// How that error begins.
pub const OTHER_FORMAT: &str = "this has a format";

impl<'de> Deserialize<'de> for OtherFormat {
    fn deserialize<D: Deserializer<'de>>(_: D) -> Result<Self, D::Error> {
        Err(de::Error::custom(OTHER_FORMAT))
    }
}

impl Object {
    /// A property, as text.
    pub fn property(&self, key: &str) -> Option<&str> {
        let own = || self.feature_type.as_ref().and_then(|text| text.0.as_deref()).filter(|_| key == "feature_type");
        self.properties.as_ref().and_then(|properties| properties.0.get(key)).map(String::as_str).or_else(own)
    }
}

impl Coordinates {
    /// The parts of a list.
    pub fn list(&self) -> Result<&[Coordinates], FormatError> {
        match self {
            Self::List(list) => Ok(list),
            Self::Position { .. } => {
                Err(FormatError::new(Code::InvalidFile, "there is a position in place of a list of positions"))
            }
        }
    }
}

impl<'de> Deserialize<'de> for Coordinates {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match deserializer.deserialize_any(Element)? {
            Item::Number(_) => Err(de::Error::custom("coordinates are a list, not a number")),
            Item::Coordinates(coordinates) => Ok(coordinates),
        }
    }
}

/// A number or a list in coordinates.
enum Item {
    Number(f64),
    Coordinates(Coordinates),
}

impl<'de> Deserialize<'de> for Item {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Element)
    }
}

struct Element;

impl<'de> Visitor<'de> for Element {
    type Value = Item;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or a list")
    }

    fn visit_f64<E>(self, number: f64) -> Result<Item, E> {
        Ok(Item::Number(number))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Item, E> {
        Ok(Item::Number(number as f64))
    }

    fn visit_u64<E>(self, number: u64) -> Result<Item, E> {
        Ok(Item::Number(number as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Item, A::Error> {
        let mixed = || de::Error::custom("a list has numbers or lists, not both");
        let x = match items.next_element()? {
            None => return Ok(Item::Coordinates(Coordinates::List(Vec::new()))),
            Some(Item::Number(x)) => x,
            Some(Item::Coordinates(first)) => {
                let mut list = vec![first];
                while let Some(item) = items.next_element()? {
                    let Item::Coordinates(next) = item else { return Err(mixed()) };
                    list.push(next);
                }
                return Ok(Item::Coordinates(Coordinates::List(list)));
            }
        };
        let y = match items.next_element()? {
            Some(Item::Number(y)) => y,
            Some(Item::Coordinates(_)) => return Err(mixed()),
            None => return Err(de::Error::custom("a position has two numbers at least")),
        };
        let mut is_flat = true;
        while let Some(item) = items.next_element()? {
            let Item::Number(_) = item else { return Err(mixed()) };
            is_flat = false;
        }
        Ok(Item::Coordinates(Coordinates::Position { point: Point::new(x, y), is_flat }))
    }
}

impl<'de> Deserialize<'de> for Properties {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(Pairs)
    }
}

struct Pairs;

impl<'de> Visitor<'de> for Pairs {
    type Value = Properties;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object of properties")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut pairs: A) -> Result<Properties, A::Error> {
        let mut properties = BTreeMap::new();
        while let Some((key, Scalar(value))) = pairs.next_entry::<String, Scalar>()? {
            properties.extend(value.map(|value| (key, value)));
        }
        Ok(Properties(properties))
    }
}

impl<'de> Deserialize<'de> for Scalar {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(AsText)
    }
}

struct AsText;

impl<'de> Visitor<'de> for AsText {
    type Value = Scalar;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value")
    }

    fn visit_str<E>(self, text: &str) -> Result<Scalar, E> {
        Ok(Scalar(Some(text.to_owned())))
    }

    fn visit_bool<E>(self, value: bool) -> Result<Scalar, E> {
        Ok(Scalar(Some(value.to_string())))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Scalar, E> {
        Ok(Scalar(Some(number.to_string())))
    }

    fn visit_u64<E>(self, number: u64) -> Result<Scalar, E> {
        Ok(Scalar(Some(number.to_string())))
    }

    fn visit_f64<E>(self, number: f64) -> Result<Scalar, E> {
        Ok(Scalar(Some(number.to_string())))
    }

    fn visit_unit<E>(self) -> Result<Scalar, E> {
        Ok(Scalar(None))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Scalar, A::Error> {
        while items.next_element::<IgnoredAny>()?.is_some() {}
        Ok(Scalar(None))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut pairs: A) -> Result<Scalar, A::Error> {
        while pairs.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
        Ok(Scalar(None))
    }
}
