//! What generators of scenarios, fleets and navigation tasks share: their tables, and how options given by name are read and
//! refused.

use crate::error::{Code, Error, quoted};
use crate::options::{Info, OptionInfo, Options, Range, Value};
use crate::random::MAX_SEED;
use serde_json::Value as Json;

/// The range of a seed.
pub const SEEDS: Range = 0.0..=MAX_SEED as f64;

/// A generator, by the type of its options.
pub trait Generator: Options {
    /// What it makes.
    type Made;

    /// Makes it.
    ///
    /// # Errors
    /// `out-of-range` or `not-finite` with the pointer of the option, also where options do not fit each other or leave no room.
    fn generate(&self) -> Result<Self::Made, Error>;

    #[doc(hidden)]
    /// Refuses options that may not be given together.
    ///
    /// # Errors
    /// `unknown-field` with the pointer of the option.
    fn check_given(_given: &[(String, Value)]) -> Result<(), Error> {
        Ok(())
    }
}

/// Reads options given by name, and generates; the second argument has names that are known elsewhere.
type Make<T> = fn(&[(String, Value)], &[&'static str]) -> Result<T, Error>;

/// A generator in a table.
pub struct Entry<T> {
    id: &'static str,
    title: &'static str,
    summary: &'static str,
    options: fn() -> Vec<OptionInfo>,
    make: Make<T>,
}

impl<T> Entry<T> {
    /// A generator with its id, its title and its summary.
    pub const fn new<G: Generator<Made = T>>(id: &'static str, title: &'static str, summary: &'static str) -> Self {
        Self { id, title, summary, options: G::table, make: make::<G> }
    }
}

/// The generators of one type of document.
pub struct Generators<T: 'static>(pub &'static [Entry<T>]);

impl<T> Generators<T> {
    /// Their descriptions.
    pub fn infos(&self) -> Vec<Info> {
        let info = |entry: &Entry<T>| {
            let &Entry { id, title, summary, options, .. } = entry;
            Info { id, title, summary, options: options() }
        };
        self.0.iter().map(info).collect()
    }

    /// Generates by the id of a generator, with options given by name and `seed`; the rest take their defaults. `others` are
    /// options that the caller takes from the same list: a refusal names them as known.
    ///
    /// # Errors
    /// `unknown-generator`; and, with the pointer `/name`, `unknown-field`, `duplicate-field`, `wrong-type`, `unknown-type`,
    /// `not-finite`, `out-of-range`.
    pub fn generate(&self, id: &str, given: &[(String, Value)], others: &[&'static str]) -> Result<T, Error> {
        if let Some(entry) = self.0.iter().find(|entry| entry.id == id) {
            return (entry.make)(given, others);
        }
        let ids: Vec<&str> = self.0.iter().map(|entry| entry.id).collect();
        let sentence = format!("there is no generator {}; there are {}", quoted(id), ids.join(", "));
        Err(Error::new(Code::UnknownGenerator, "", sentence))
    }
}

fn make<G: Generator>(given: &[(String, Value)], others: &[&'static str]) -> Result<G::Made, Error> {
    let options = G::read_among(given, others).map_err(|error| match (error.code(), error.pointer()) {
        // A robot is a type, as in a scenario.
        (Code::OutOfRange, "/robot") => Error::new(Code::UnknownType, "/robot", error.message()),
        // The options are fields of a document's object.
        (Code::UnknownParameter, pointer) => Error::new(Code::UnknownField, pointer, error.message()),
        _ => error,
    })?;
    G::check_given(given)?;
    options.generate()
}

/// The options of an object by name.
///
/// # Errors
/// `wrong-type` if it is not an object.
pub fn given(options: &Json) -> Result<Vec<(String, Value)>, Error> {
    let Json::Object(fields) = options else {
        return Err(Error::new(Code::WrongType, "", "options must be an object"));
    };
    Ok(fields.iter().map(|(name, value)| (name.clone(), Value::from(value))).collect())
}
