//! What generators of scenarios, fleets and navigation tasks share: their tables, and how options given by name are read and
//! refused.

use crate::error::{Code, Error, quoted};
use crate::options::{Options, Range, Value};
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
    fn generate(&self) -> Result<Self::Made, Error> {
        self.check()?;
        self.make()
    }

    /// Makes it of options that are in range.
    #[doc(hidden)]
    fn make(&self) -> Result<Self::Made, Error>;

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
pub type Make<T> = fn(&[(String, Value)], &[&'static str]) -> Result<T, Error>;

/// Declares the generators of one type of document, each with its id, its title and its summary: `MAKERS` and the functions that
/// generate, and the function that describes them. They are apart so that a program which only generates holds no texts.
macro_rules! generators {
    ($Made:ty, $descriptions:ident: $($Options:ty => $id:literal, $title:literal, $summary:literal;)+) => {
        /// The generators by their ids.
        const MAKERS: &[(&str, $crate::generators::Make<$Made>)] = &[$(($id, $crate::generators::make::<$Options>)),+];

        /// The generators with their options.
        pub fn $descriptions() -> Vec<$crate::options::Info> {
            vec![$({
                let options = <$Options as $crate::options::Options>::table();
                $crate::options::Info { id: $id, title: $title, summary: $summary, options }
            }),+]
        }

        /// Generates by the generator's id, with options given by name, and `seed`; the rest take their defaults.
        ///
        /// # Errors
        /// `unknown-generator`; and, with the pointer `/name`, `unknown-field`, `duplicate-field`, `wrong-type`, `unknown-type`,
        /// `not-finite`, `out-of-range`, which is also the error where obstacles or robots do not fit.
        pub fn generate_with(
            id: &str,
            options: &[(String, $crate::options::Value)],
        ) -> Result<$Made, $crate::error::Error> {
            $crate::generators::generate(MAKERS, id, options, &[])
        }

        /// The same with the options as an object (`{}` for all defaults).
        ///
        /// # Errors
        /// Those of [`generate_with`], and `wrong-type` if the options are not an object.
        pub fn generate(id: &str, options: &serde_json::Value) -> Result<$Made, $crate::error::Error> {
            generate_with(id, &$crate::generators::given(options)?)
        }
    };
}
pub(crate) use generators;

/// Generates by the id of a generator, with options given by name and `seed`; the rest take their defaults. `others` are options
/// that the caller takes from the same list: a refusal names them as known.
///
/// # Errors
/// `unknown-generator`; and, with the pointer `/name`, `unknown-field`, `duplicate-field`, `wrong-type`, `unknown-type`,
/// `not-finite`, `out-of-range`.
pub fn generate<T>(
    makers: &[(&str, Make<T>)],
    id: &str,
    given: &[(String, Value)],
    others: &[&'static str],
) -> Result<T, Error> {
    if let Some((_, make)) = makers.iter().find(|(known, _)| *known == id) {
        return make(given, others);
    }
    let ids: Vec<&str> = makers.iter().map(|(known, _)| *known).collect();
    let sentence = format!("there is no generator {}; there are {}", quoted(id), ids.join(", "));
    Err(Error::new(Code::UnknownGenerator, "", sentence))
}

/// Reads options given by name, and generates.
///
/// # Errors
/// As [`generate()`].
pub fn make<G: Generator>(given: &[(String, Value)], others: &[&'static str]) -> Result<G::Made, Error> {
    let options = G::read_among(given, others).map_err(|error| match (error.code(), error.pointer()) {
        // A robot is a type, as in a scenario.
        (Code::OutOfRange, "/robot") => Error::new(Code::UnknownType, "/robot", error.message()),
        // The options are fields of a document's object.
        (Code::UnknownParameter, pointer) => Error::new(Code::UnknownField, pointer, error.message()),
        _ => error,
    })?;
    G::check_given(given)?;
    options.make()
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
