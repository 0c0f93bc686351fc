//! The methods that exist, with their options.

use crate::error::{Code, Error, quoted};
use crate::options::{OptionInfo, Options, Value};
use strum::{IntoStaticStr, VariantArray};

/// The most updates of a run.
pub const MOST_ITERATIONS: f64 = 200_000.0;

/// A method of inverse kinematics.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "kebab-case")]
pub enum MethodId {
    /// The closed form.
    ClosedForm,
    /// Newton and Raphson's.
    Newton,
    /// Damped least squares, taken where none is named.
    DampedLeastSquares,
    /// Gradient descent.
    GradientDescent,
}

/// What there is to know about a method before it runs.
#[derive(Debug, Clone, PartialEq)]
pub struct MethodInfo {
    /// The id, in kebab-case, the same everywhere.
    pub id: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// What it does, in one sentence.
    pub summary: &'static str,
    /// Its options.
    pub parameters: Vec<OptionInfo>,
}

crate::options! {
    /// What solutions are looked for.
    pub struct Finding for &["arm"];
    /// How many distinct solutions are looked for; fewer may be found.
    solutions: u64 = 1, in 1.0..=100.0, "Solutions wanted";
    /// Takes only solutions at which the arm touches nothing, and keeps the others apart.
    free_only: bool = false, "Free ones only";
    /// Two solutions are distinct where some joint differs by more than this, whole turns aside.
    separation: Option<f64>, in 1e-6..=3.0, "Separation", unit "rad",
        else "0.001, or 0.5 for an arm with more joints than the target needs, which has infinitely many solutions";
}

crate::options! {
    /// Starts of methods that go from one configuration to the next.
    pub struct Starting for &["arm"];
    /// How often a random start is drawn, where the last one led nowhere or another solution is wanted.
    restarts: u64 = 200, in 0.0..=10_000.0, "Restarts at most";
}

crate::options! {
    /// Options of the closed form.
    pub struct ClosedFormOptions for &["arm"];
    /// How far from the target the tip may end, in metres, and its orientation, in radians; rounding sets a floor for large arms.
    tolerance: f64 = 1e-9, in 1e-12..=1.0, "Tolerance", unit "m, rad";
    /// After how many iterations the run ends: one is an update of the joints, or the drawing of a new start.
    max_iterations: u64 = 10_000, in 0.0..=MOST_ITERATIONS, "Iterations at most";
    /// What is looked for.
    finding: Finding;
}

crate::options! {
    /// Options of the iterative methods.
    pub struct IterativeOptions for &["arm"];
    /// How far from the target the tip may end, in metres, and its orientation, in radians; rounding sets a floor for large arms.
    tolerance: f64 = 1e-9, in 1e-12..=1.0, "Tolerance", unit "m, rad";
    /// After how many iterations the run ends: one is an update of the joints, or the drawing of a new start.
    max_iterations: u64 = 10_000, in 0.0..=MOST_ITERATIONS, "Iterations at most";
    /// Where it starts.
    starting: Starting;
    /// What is looked for.
    finding: Finding;
}

crate::options! {
    /// Options of gradient descent.
    pub struct GradientDescentOptions for &["arm"];
    /// How far from the target the tip may end, in metres, and its orientation, in radians; rounding sets a floor for large arms.
    tolerance: f64 = 1e-4, in 1e-12..=1.0, "Tolerance", unit "m, rad";
    /// After how many iterations the run ends: one is an update of the joints, or the drawing of a new start.
    max_iterations: u64 = 50_000, in 0.0..=MOST_ITERATIONS, "Iterations at most";
    /// Where it starts.
    starting: Starting;
    /// What is looked for.
    finding: Finding;
}

/// The options of any method.
#[derive(Debug, Clone, Copy)]
pub(super) struct Settings {
    pub tolerance: f64,
    pub max_iterations: u64,
    pub restarts: u64,
    pub finding: Finding,
}

impl MethodId {
    /// The id, in kebab-case.
    pub fn as_str(self) -> &'static str {
        self.into()
    }

    /// The method with the given id, or the default.
    ///
    /// # Errors
    /// `out-of-range`, pointer `/method`, naming those that exist.
    pub fn of(id: Option<&str>) -> Result<Self, Error> {
        let Some(id) = id else { return Ok(MethodId::DampedLeastSquares) };
        Self::VARIANTS.iter().copied().find(|method| method.as_str() == id).ok_or_else(|| {
            let known = Self::VARIANTS.iter().map(|method| method.as_str()).collect::<Vec<_>>().join(", ");
            Error::new(Code::OutOfRange, "/method", format!("method must be one of {known}, not {}", quoted(id)))
        })
    }

    /// What there is to know about it.
    pub fn info(self) -> MethodInfo {
        let (title, summary, parameters) = match self {
            MethodId::ClosedForm => (
                "Closed form",
                "Computes the angles of up to two joints at once, elbow on either side; a given orientation fixes one joint more.",
                ClosedFormOptions::table(),
            ),
            MethodId::Newton => (
                "Newton-Raphson",
                "Follows the tangent to the target by the pseudo-inverse of the Jacobian: quick, and wild near singular arms.",
                IterativeOptions::table(),
            ),
            MethodId::DampedLeastSquares => (
                "Damped least squares",
                "Weighs the error against the turn of the joints, so that it stays calm where the arm is nearly singular.",
                IterativeOptions::table(),
            ),
            MethodId::GradientDescent => (
                "Gradient descent",
                "Turns every joint downhill, as far as the error falls: simple, without any inverse, and slow at the end.",
                GradientDescentOptions::table(),
            ),
        };
        MethodInfo { id: self.as_str(), title, summary, parameters }
    }

    /// Its options, given by name.
    pub(super) fn read(self, given: &[(String, Value)]) -> Result<Settings, Error> {
        Ok(match self {
            MethodId::ClosedForm => {
                let ClosedFormOptions { tolerance, max_iterations, finding } = Options::read(given)?;
                Settings { tolerance, max_iterations, restarts: 0, finding }
            }
            MethodId::Newton | MethodId::DampedLeastSquares => {
                let IterativeOptions { tolerance, max_iterations, starting, finding } = Options::read(given)?;
                Settings { tolerance, max_iterations, restarts: starting.restarts, finding }
            }
            MethodId::GradientDescent => {
                let GradientDescentOptions { tolerance, max_iterations, starting, finding } = Options::read(given)?;
                Settings { tolerance, max_iterations, restarts: starting.restarts, finding }
            }
        })
    }
}

/// Every method.
pub fn methods() -> Vec<MethodInfo> {
    MethodId::VARIANTS.iter().map(|method| method.info()).collect()
}
