//! Options as JSON, whose unknown names are refused with the nearest known one.

use planarium::{Error, error::Code, json};
use serde::de::{self, DeserializeOwned, Deserializer, Visitor, value};

/// The options, or what is wrong with them; for an unknown one the nearest name.
pub(super) fn options_of<T: DeserializeOwned>(text: &str) -> Result<T, Error> {
    let tree = json::parse(text)?;
    json::read(&tree).map_err(|error| {
        let name = error.pointer().trim_start_matches('/');
        if error.code() != Code::UnknownField || name.contains('/') {
            return error;
        }
        let near = names::<T>().iter().min_by_key(|known| distance(name, known)).copied().unwrap_or_default();
        Error::new(error.code(), error.pointer(), format!("{}; the nearest is {near}", error.message()))
    })
}

/// The names of all options.
fn names<T: DeserializeOwned>() -> &'static [&'static str] {
    /// Hands over the names in place of values.
    struct Names<'a>(&'a mut &'static [&'static str]);

    impl<'de> Deserializer<'de> for Names<'_> {
        type Error = value::Error;

        fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, value::Error> {
            Err(de::Error::custom("no struct"))
        }

        fn deserialize_struct<V: Visitor<'de>>(
            self,
            _: &'static str,
            fields: &'static [&'static str],
            visitor: V,
        ) -> Result<V::Value, value::Error> {
            *self.0 = fields;
            self.deserialize_any(visitor)
        }

        serde::forward_to_deserialize_any! {
            bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
            newtype_struct seq tuple tuple_struct map enum identifier ignored_any
        }
    }

    let mut names: &[&str] = &[];
    // It fails once it has the names.
    let _ = T::deserialize(Names(&mut names));
    names
}

/// The edits between two names: characters put in, taken out or replaced.
fn distance(a: &str, b: &str) -> usize {
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.bytes().take(60).enumerate() {
        let mut before = std::mem::replace(&mut row[0], i + 1);
        for (j, y) in b.bytes().enumerate() {
            let replaced = before + usize::from(!x.eq_ignore_ascii_case(&y));
            before = row[j + 1];
            row[j + 1] = replaced.min(row[j].min(before) + 1);
        }
    }
    row.last().copied().unwrap_or_default()
}
