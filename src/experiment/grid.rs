//! Lists of values and of seeds, and the combinations of several lists by number.

use super::MAX_LIST;
use super::document::{SeedRange, Span};
use crate::error::{Code, Error, Number};
use crate::json::{self, push_field};
use crate::options::Value;
use crate::random::MAX_SEED;
use serde_json::{Map, Value as Json};
use std::collections::BTreeSet;

/// The least step of values: they are rounded to nine decimals.
const LEAST_STEP: f64 = 1e-6;

/// An error with these parts.
pub(super) fn refused<T>(code: Code, pointer: impl Into<String>, sentence: impl Into<String>) -> Result<T, Error> {
    Err(Error::new(code, pointer, sentence))
}

/// Options by name: fixed ones, and others that vary. A number gives one combination; the last list varies fastest.
pub(super) struct Grid {
    set: Vec<(String, Json)>,
    axes: Vec<(String, Vec<Json>)>,
}

impl Grid {
    /// Reads the fields `set` and `vary` of an entry.
    pub fn read(set: Map<String, Json>, vary: &Map<String, Json>) -> Result<Self, Error> {
        let mut axes = Vec::with_capacity(vary.len());
        for (name, values) in vary {
            let mut pointer = "/vary".to_owned();
            push_field(&mut pointer, name);
            if set.contains_key(name) {
                return refused(Code::DuplicateField, pointer, format!("{name} is fixed and varies"));
            }
            axes.push((name.clone(), axis(values).map_err(|error| error.under(&pointer))?));
        }
        Ok(Self { set: set.into_iter().collect(), axes })
    }

    /// How many combinations there are: at least 1; saturates far above [`MAX_LIST`].
    pub fn len(&self) -> u64 {
        self.axes.iter().fold(1, |product: u64, (_, values)| product.saturating_mul(values.len() as u64))
    }

    /// The names of those that vary.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.axes.iter().map(|(name, _)| name.as_str())
    }

    /// What varies, of one combination.
    pub fn varied(&self, number: u64) -> Vec<(&str, &Json)> {
        self.indices(number).zip(&self.axes).map(|(i, (name, values))| (name.as_str(), &values[i])).collect()
    }

    /// All options of one combination.
    pub fn options(&self, number: u64) -> Vec<(String, Value)> {
        let fixed = self.set.iter().map(|(name, value)| (name.clone(), value.into()));
        fixed.chain(self.varied(number).into_iter().map(|(name, value)| (name.to_owned(), value.into()))).collect()
    }

    /// The index in each list.
    fn indices(&self, number: u64) -> impl Iterator<Item = usize> {
        let lengths = self.axes.iter().map(|(_, values)| values.len() as u64);
        let mut rest = self.len();
        lengths.map(move |length| {
            rest /= length;
            (number / rest % length) as usize
        })
    }

    /// The pointer, below the entry, of the option that the pointer `/name` of an error names; `None` if it is not given here.
    pub fn pointer(&self, number: u64, option: &str) -> Option<String> {
        let is_meant = |name: &str| {
            let mut own = String::new();
            push_field(&mut own, name);
            own == option
        };
        if self.set.iter().any(|(name, _)| is_meant(name)) {
            return Some(format!("/set{option}"));
        }
        let at = self.axes.iter().position(|(name, _)| is_meant(name))?;
        Some(format!("/vary{option}/{}", self.indices(number).nth(at)?))
    }
}

/// The values of a list, or from one number to another.
fn axis(values: &Json) -> Result<Vec<Json>, Error> {
    match values {
        Json::Array(list) if list.is_empty() => refused(Code::OutOfRange, "", "this list must have at least one value"),
        Json::Array(list) if list.len() as u64 > MAX_LIST => too_many(list.len() as f64),
        Json::Array(list) => {
            let mut seen = BTreeSet::new();
            for (i, value) in list.iter().enumerate() {
                if !seen.insert(json::to_string(value)) {
                    let sentence = format!("the value {} occurs twice", json::to_string(value));
                    return refused(Code::OutOfRange, format!("/{i}"), sentence);
                }
            }
            Ok(list.clone())
        }
        Json::Object(_) => span(json::read(values)?),
        _ => refused(Code::WrongType, "", "this must be a list of values, or an object with from, to and step"),
    }
}

fn too_many<T>(count: f64) -> Result<T, Error> {
    let sentence = format!("these are {} values; at most {MAX_LIST} are allowed", Number(count));
    refused(Code::TooLarge, "", sentence)
}

/// Equal steps. Rounding to decimals makes 0.1 + 2 * 0.1 the number that is written 0.3, on every platform.
fn span(Span { from, to, step }: Span) -> Result<Vec<Json>, Error> {
    if step < LEAST_STEP {
        let sentence = format!("a step must be at least {LEAST_STEP}, not {}", Number(step));
        return refused(Code::OutOfRange, "/step", sentence);
    }
    if to < from {
        let sentence = format!("there is no value from {} up to {}", Number(from), Number(to));
        return refused(Code::OutOfRange, "/to", sentence);
    }
    let last = libm::floor((to - from) / step + 1e-9);
    if last >= MAX_LIST as f64 {
        return too_many(last + 1.0);
    }
    let rounded = |value: f64| libm::rint(value * 1e9) / 1e9;
    Ok((0..=last as u64).map(|i| rounded(from + i as f64 * step).into()).collect())
}

/// Seeds, each once.
pub(super) enum Seeds {
    List(Vec<u64>),
    Range(SeedRange),
}

impl Seeds {
    /// Reads a list or a range.
    pub fn read(value: &Json) -> Result<Self, Error> {
        let seeds = match value {
            Json::Array(_) => Seeds::List(json::read(value)?),
            Json::Object(_) => Seeds::Range(json::read(value)?),
            _ => return refused(Code::WrongType, "", "this must be a list of seeds, or an object with from and count"),
        };
        match &seeds {
            Seeds::List(list) => {
                if list.len() as u64 > MAX_LIST {
                    return too_many(list.len() as f64);
                }
                let mut seen = BTreeSet::new();
                for (i, seed) in list.iter().enumerate() {
                    let sentence = match seed {
                        _ if *seed > MAX_SEED => format!("a seed is at most {MAX_SEED}, not {seed}"),
                        _ if !seen.insert(seed) => format!("the seed {seed} occurs twice"),
                        _ => continue,
                    };
                    return refused(Code::OutOfRange, format!("/{i}"), sentence);
                }
            }
            Seeds::Range(SeedRange { from, count }) => {
                if from.saturating_add(*count) > MAX_SEED + 1 {
                    let sentence = format!("a seed is at most {MAX_SEED}; {count} from {from} on go beyond it");
                    return refused(Code::OutOfRange, "/count", sentence);
                }
            }
        }
        if seeds.len() == 0 { refused(Code::OutOfRange, "", "there must be at least one seed") } else { Ok(seeds) }
    }

    pub fn len(&self) -> u64 {
        match self {
            Seeds::List(list) => list.len() as u64,
            Seeds::Range(range) => range.count,
        }
    }

    pub fn at(&self, i: u64) -> u64 {
        match self {
            Seeds::List(list) => list[i as usize],
            Seeds::Range(range) => range.from + i,
        }
    }
}
