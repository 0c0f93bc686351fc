//! The methods and their options, and the options of a run.

use crate::error::{Code, Error, quoted};
use crate::options::{ANY, Field, Info, OptionInfo, Options, Value};
use crate::robot::{Arm, Target};
use crate::scenario::{Robot, Scenario};
use strum::{EnumMessage, IntoStaticStr, VariantArray};

/// A method of inverse kinematics; its documentation is its summary.
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumMessage, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum MethodId {
    /// Computes the angles of up to two joints directly, elbow on either side; a given orientation fixes one joint more.
    #[strum(message = "Closed form")]
    ClosedForm,
    /// Solves the linear model by the pseudo-inverse of the Jacobian: fast, but unstable near singular configurations.
    #[strum(message = "Newton-Raphson")]
    Newton,
    /// Weighs the error against the rotation of the joints, which keeps it stable near singular configurations.
    #[strum(message = "Damped least squares")]
    DampedLeastSquares,
    /// Turns every joint against the gradient while the error falls: simple, without any inverse, and slow near the target.
    #[strum(message = "Gradient descent")]
    GradientDescent,
}

crate::options! {
    /// Which solutions are searched for.
    pub struct Finding for &["arm"];
    /// How many distinct solutions are searched for; fewer may be found.
    solutions: u64 = 1, in 1.0..=100.0, "Solutions wanted";
    /// Accepts only solutions at which the arm touches nothing, and lists the others apart.
    free_only: bool = false, "Free ones only";
    /// Two solutions are distinct if some joint differs by more than this, modulo whole turns.
    separation: Option<f64>, in 1e-6..=3.0, "Separation", unit "rad",
        else "0.001, or 0.5 for an arm with more joints than the target needs, which has infinitely many solutions";
}

crate::options! {
    /// Random starts.
    pub struct Starting for &["arm"];
    /// How often a random start is drawn when the last one led nowhere or another solution is wanted.
    restarts: u64 = 200, in 0.0..=10_000.0, "Restarts at most";
}

crate::options! {
    /// When a run has reached its target, and when it ends.
    pub struct Stopping for &["arm"];
    /// How far from the target the tip may end, in metres, and its orientation, in radians; rounding sets a floor for large arms.
    tolerance: f64 = 1e-9, in 1e-12..=1.0, "Tolerance", unit "m, rad";
    /// After how many iterations the run ends: one is an update of the joints, or the drawing of a new start.
    max_iterations: u64 = 10_000, in 0.0..=200_000.0, "Iterations at most";
}

crate::options! {
    /// Options of the closed form.
    pub struct ClosedFormOptions for &["arm"];
    /// When it ends.
    stopping: Stopping;
    /// What is searched for.
    finding: Finding;
}

crate::options! {
    /// Options of the other methods.
    pub struct IterativeOptions for &["arm"];
    /// When it ends.
    stopping: Stopping;
    /// Where it starts.
    starting: Starting;
    /// What is searched for.
    finding: Finding;
}

impl MethodId {
    /// The id, in kebab-case.
    pub fn as_str(self) -> &'static str {
        self.into()
    }

    /// The method with the given id, or the default.
    ///
    /// # Errors
    /// `out-of-range`, pointer `/method`.
    pub fn of(id: Option<&str>) -> Result<Self, Error> {
        let Some(id) = id else { return Ok(MethodId::DampedLeastSquares) };
        Self::VARIANTS.iter().copied().find(|method| method.as_str() == id).ok_or_else(|| {
            let known = Self::VARIANTS.iter().map(|method| method.as_str()).collect::<Vec<_>>().join(", ");
            Error::new(Code::OutOfRange, "/method", format!("method must be one of {known}, not {}", quoted(id)))
        })
    }

    /// The method with its default options: gradient descent is slow near the target, so that it stops farther from it.
    pub fn options(self) -> MethodOptions {
        match self {
            MethodId::ClosedForm => MethodOptions::ClosedForm(ClosedFormOptions::default()),
            MethodId::Newton => MethodOptions::Newton(IterativeOptions::default()),
            MethodId::DampedLeastSquares => MethodOptions::DampedLeastSquares(IterativeOptions::default()),
            MethodId::GradientDescent => {
                let stopping = Stopping { tolerance: 1e-4, max_iterations: 50_000 };
                MethodOptions::GradientDescent(IterativeOptions { stopping, ..IterativeOptions::default() })
            }
        }
    }

    /// Its description.
    pub fn info(self) -> Info {
        let mut options = Vec::new();
        match self.options() {
            MethodOptions::ClosedForm(_) => options = ClosedFormOptions::table(),
            MethodOptions::Newton(own)
            | MethodOptions::DampedLeastSquares(own)
            | MethodOptions::GradientDescent(own) => own.rows(OptionInfo::default(), &ANY, &mut options),
        }
        let [title, summary] = [self.get_message(), self.get_documentation()].map(Option::unwrap_or_default);
        Info { id: self.as_str(), title, summary, options }
    }
}

/// A method with its options.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum MethodOptions {
    /// The closed form.
    ClosedForm(ClosedFormOptions),
    /// Newton-Raphson.
    Newton(IterativeOptions),
    /// Damped least squares, the default.
    DampedLeastSquares(IterativeOptions),
    /// Gradient descent, whose default options [`MethodId::options`] has.
    GradientDescent(IterativeOptions),
}

impl Default for MethodOptions {
    fn default() -> Self {
        MethodOptions::DampedLeastSquares(IterativeOptions::default())
    }
}

impl MethodOptions {
    /// The method with the given id, by default damped least squares, and with options given by name; the rest have the defaults
    /// of the method.
    ///
    /// # Errors
    /// Those of [`MethodId::of`]; `unknown-parameter`, `duplicate-field`, `wrong-type`, `not-finite` or `out-of-range`, with the
    /// pointer `/name`.
    pub fn read(id: Option<&str>, given: &[(String, Value)]) -> Result<Self, Error> {
        MethodId::of(id)?.options().updated(given)
    }

    fn updated(self, given: &[(String, Value)]) -> Result<Self, Error> {
        Ok(match self {
            Self::ClosedForm(options) => Self::ClosedForm(options.updated(given)?),
            Self::Newton(options) => Self::Newton(options.updated(given)?),
            Self::DampedLeastSquares(options) => Self::DampedLeastSquares(options.updated(given)?),
            Self::GradientDescent(options) => Self::GradientDescent(options.updated(given)?),
        })
    }

    /// The method, and when it stops, how often it restarts and what it finds, all in range; the closed form has no restarts.
    pub(super) fn checked(self) -> Result<(MethodId, Stopping, u64, Finding), Error> {
        let (id, IterativeOptions { stopping, starting, finding }) = match self.updated(&[])? {
            Self::ClosedForm(ClosedFormOptions { stopping, finding }) => {
                return Ok((MethodId::ClosedForm, stopping, 0, finding));
            }
            Self::Newton(options) => (MethodId::Newton, options),
            Self::DampedLeastSquares(options) => (MethodId::DampedLeastSquares, options),
            Self::GradientDescent(options) => (MethodId::GradientDescent, options),
        };
        Ok((id, stopping, starting.restarts, finding))
    }
}

/// The target, method, start and seed of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct SolverOptions {
    /// The target of the tip.
    pub target: Target,
    /// The method with its options.
    pub method: MethodOptions,
    /// The first start; by default the start of the scenario's first query, or without a query all joints at 0 or as near to it
    /// as the limits allow.
    pub start: Option<Vec<f64>>,
    /// The seed of the other starts, up to 2^53 - 1.
    pub seed: u64,
}

impl SolverOptions {
    /// All defaults, for a target.
    pub fn to(target: Target) -> Self {
        Self { target, method: MethodOptions::default(), start: None, seed: 0 }
    }
}

/// The arm of the scenario.
///
/// # Errors
/// `unsupported` if the robot is not an arm.
pub fn arm_of(scenario: &Scenario) -> Result<&Arm, Error> {
    match scenario.robot() {
        Robot::Arm(arm) => Ok(arm),
        other => {
            let sentence = format!("only an arm reaches for a target; this robot is of type {}", other.kind());
            Err(Error::new(Code::Unsupported, "", sentence))
        }
    }
}

/// Every method.
pub fn methods() -> Vec<Info> {
    MethodId::VARIANTS.iter().map(|method| method.info()).collect()
}
