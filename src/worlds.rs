//! Generated scenarios in which a path exists, or in which none does: a generator draws again until that is known.
//!
//! A path is known once a planner has found one, or a certificate says that there is one. That there is none is known
//! from a certificate alone, so only for robots whose configurations have two coordinates. Both are given limits that
//! no clock decides, so the same options and seed give the same scenario on every platform. The first draw is the
//! world of the seed itself; each further one has a seed of its own, which depends on that seed and the number of the
//! draw and stands in the name of the scenario. Without `ensure` that seed gives the same scenario.

use crate::certificate::{self, Subdivision, Verdict};
use crate::error::{Code, Error};
use crate::generators::given;
use crate::options::{Info, Options as _, Value, refusal};
use crate::problem::{Status, Stepped};
use crate::random::{MAX_SEED, Random, Stream};
use crate::run::{self, EdgeOptions, Limits, RrtConnectOptions};
use crate::scenario::generate as seeded;
use crate::scenario::{Robot, Scenario};
use crate::world::PlanningWorld;
use serde_json::Value as Json;

crate::choice! {
    /// What has to be known about the first query of a generated scenario.
    pub enum Ensure {
        /// Nothing.
        Any,
        /// A path exists.
        Path,
        /// No path exists.
        NoPath,
    }
}

crate::options! {
    /// What a generated scenario is drawn for.
    pub struct EnsureOptions for &[];
    /// Draws again until a path is known, by a planner or a certificate, or until a certificate proves that there is none.
    ensure: Ensure = Ensure::Any, "Path";
    /// The most draws; with `ensure` only.
    draws: usize = 100, in 1.0..=1000.0, "Draws";
}

/// The most iterations of the planner in a draw; of one for a car, whose iterations take longer.
const ITERATIONS: u32 = 5000;
const CAR_ITERATIONS: u32 = 2000;

/// The most cells of the certificate of a draw.
const CELLS: usize = 20_000;

/// The generators with all options that [`generate`] takes.
pub fn generators() -> Vec<Info> {
    let with_ensure = |mut info: Info| {
        info.options.extend(EnsureOptions::table());
        info
    };
    seeded::generators().into_iter().map(with_ensure).collect()
}

/// Generates a scenario by the generator's id, with options given by name: those of [`generators`] and `seed`; the
/// rest take their defaults.
///
/// # Errors
/// Those of [`seeded::generate_with`] and of the options; `unsupported` (pointer `/ensure`) for `no-path` and a robot
/// without certificates; `unknown-field` for `draws` without `ensure`; `gave-up` (pointer `/ensure`) if no draw is
/// known to be as required.
///
/// # Complexity
/// A draw takes at most 5000 iterations of RRT-Connect, 2000 for a car, and a certificate of at most 20,000 cells.
pub fn generate_with(id: &str, options: &[(String, Value)]) -> Result<Scenario, Error> {
    draw(id, options).map(|(scenario, _)| scenario)
}

/// The same with the options as an object (`{}` for all defaults).
///
/// # Errors
/// Those of [`generate_with`], and `wrong-type` if the options are not an object.
pub fn generate(id: &str, options: &Json) -> Result<Scenario, Error> {
    generate_with(id, &given(options)?)
}

/// The options without the [`EnsureOptions`], and the [`EnsureOptions`].
///
/// # Errors
/// Those of reading them.
pub(crate) fn split(options: &[(String, Value)]) -> Result<(Vec<(String, Value)>, EnsureOptions), Error> {
    let (ours, rest): (Vec<_>, Vec<_>) = options.iter().cloned().partition(|(name, _)| EnsureOptions::has(name));
    let ensured = EnsureOptions::read(&ours)?;
    if ensured.ensure == Ensure::Any && ours.iter().any(|(name, _)| name == "draws") {
        let sentence = "draws is for \"ensure\": \"path\" or \"no-path\"; without it the first draw is taken";
        return Err(refusal(Code::UnknownField, "draws", sentence));
    }
    Ok((rest, ensured))
}

/// The scenario, and the seed that gives it without `ensure`.
///
/// # Errors
/// Those of [`generate_with`].
pub(crate) fn draw(id: &str, options: &[(String, Value)]) -> Result<(Scenario, u64), Error> {
    let (rest, EnsureOptions { ensure, draws }) = split(options)?;
    let first = seeded::generate_among(id, &rest, &EnsureOptions::names())?;
    let at = rest.iter().position(|(name, _)| name == "seed");
    let seed = match at.map(|at| &rest[at].1) {
        Some(Value::Number(seed)) => *seed as u64,
        _ => 0,
    };
    if ensure == Ensure::Any {
        return Ok((first, seed));
    }
    let mut random = Random::new(seed, Stream::Worlds);
    let (mut next, mut opposite) = (Some((first, seed)), 0);
    for _ in 0..draws {
        // A world of another seed may have no room for its obstacles.
        if let Some((scenario, seed)) = next {
            match (ensure, has_path(&scenario, ensure)?) {
                (Ensure::Path, Some(true)) | (Ensure::NoPath, Some(false)) => return Ok((scenario, seed)),
                (_, Some(_)) => opposite += 1,
                (_, None) => {}
            }
        }
        let seed = random.below(MAX_SEED + 1);
        let given = with_seed(&rest, seed);
        next = seeded::generate_with(id, &given).ok().map(|scenario| (scenario, seed));
    }
    let (wanted, other) = if ensure == Ensure::Path { ("a path", "no path") } else { ("no path", "a path") };
    let open = draws - opposite;
    let sentence = format!(
        "none of {draws} draws is known to have {wanted}: {opposite} have {other}, {open} are undecided; \
         other options, or more draws, may help"
    );
    Err(refusal(Code::GaveUp, "ensure", sentence))
}

/// The options with this seed.
fn with_seed(options: &[(String, Value)], seed: u64) -> Vec<(String, Value)> {
    let mut given: Vec<_> = options.iter().filter(|(name, _)| name != "seed").cloned().collect();
    given.push(("seed".to_owned(), Value::Number(seed as f64)));
    given
}

/// Whether the first query has a path; `None` if that is not known within the limits. A planner is asked only for
/// what it can answer.
///
/// # Errors
/// `unsupported` for [`Ensure::NoPath`] and a robot without certificates.
fn has_path(scenario: &Scenario, ensure: Ensure) -> Result<Option<bool>, Error> {
    let world = PlanningWorld::new(scenario.clone());
    if ensure == Ensure::Path && is_planned(&world)? {
        return Ok(Some(true));
    }
    let options = certificate::Options { cells: CELLS, ..certificate::Options::default() };
    let mut subdivision = match Subdivision::new(&world, &options) {
        Ok(subdivision) => subdivision,
        Err(error) if error.code() == Code::Unsupported && ensure == Ensure::Path => return Ok(None),
        Err(error) if error.code() == Code::Unsupported => {
            let sentence = format!("that no path exists is proven by certificates alone; {}", error.message());
            return Err(refusal(Code::Unsupported, "ensure", sentence));
        }
        Err(error) => return Err(error),
    };
    subdivision.step(u64::MAX);
    Ok(match subdivision.verdict() {
        Some(Verdict::Connected) => Some(true),
        Some(Verdict::Infeasible) => Some(false),
        Some(Verdict::Unknown) | None => None,
    })
}

/// Whether RRT-Connect, which serves every robot, finds a path.
fn is_planned(world: &PlanningWorld) -> Result<bool, Error> {
    let most = if matches!(world.robot(), Robot::Car(_)) { CAR_ITERATIONS } else { ITERATIONS };
    let limits = Limits { max_iterations: Some(most), ..Limits::default() };
    let edges = EdgeOptions { limits, ..EdgeOptions::default() };
    let planner = RrtConnectOptions { edges, ..RrtConnectOptions::default() };
    let options = run::Options { events: false, ..run::Options::new(planner) };
    let mut run = run::start(world, &options)?;
    Ok(run.step(u64::MAX) == Status::Solved)
}
