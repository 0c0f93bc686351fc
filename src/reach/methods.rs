//! The methods that exist, with their parameters: the one table that help texts, documents and controls are made from.

use crate::error::{Code, Error, quoted};
use crate::json::Node;
use crate::parameters::{Fallback, Kind, ParameterInfo};

/// The most updates of a run.
pub const MOST_ITERATIONS: f64 = 200_000.0;

/// What there is to know about a method before it runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MethodInfo {
    /// The id, in kebab-case, the same everywhere.
    pub id: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// What it does, in one sentence.
    pub summary: &'static str,
    /// Its parameters.
    pub parameters: &'static [ParameterInfo],
}

/// The method taken where none is named.
pub const DEFAULT_METHOD: &str = "damped-least-squares";

const ARM: &[&str] = &["arm"];

const fn row(
    name: &'static str,
    title: &'static str,
    kind: Kind,
    default: Fallback,
    meaning: &'static str,
) -> ParameterInfo {
    ParameterInfo { name, title, kind, unit: "", default, meaning, robots: ARM }
}

const TOLERANCE: ParameterInfo = ParameterInfo {
    unit: "m, rad",
    ..row(
        "tolerance",
        "Tolerance",
        Kind::Number { min: 1e-12, max: 1.0 },
        Fallback::Number(1e-9),
        "How far from the target the tip may end, in metres, and its orientation, in radians; rounding sets a floor for large arms.",
    )
};

const MAX_ITERATIONS: ParameterInfo = row(
    "max_iterations",
    "Iterations at most",
    Kind::Integer { min: 0.0, max: MOST_ITERATIONS },
    Fallback::Number(10_000.0),
    "After how many iterations the run ends: one is an update of the joints, or the drawing of a new start.",
);

const RESTARTS: ParameterInfo = row(
    "restarts",
    "Restarts at most",
    Kind::Integer { min: 0.0, max: 10_000.0 },
    Fallback::Number(200.0),
    "How often a random start is drawn, where the last one led nowhere or another solution is wanted.",
);

const SOLUTIONS: ParameterInfo = row(
    "solutions",
    "Solutions wanted",
    Kind::Integer { min: 1.0, max: 100.0 },
    Fallback::Number(1.0),
    "How many distinct solutions are looked for; fewer may be found.",
);

const FREE_ONLY: ParameterInfo = row(
    "free_only",
    "Free ones only",
    Kind::Switch,
    Fallback::Off,
    "Takes only solutions at which the arm touches nothing, and keeps the others apart.",
);

const SEPARATION: ParameterInfo = ParameterInfo {
    unit: "rad",
    ..row(
        "separation",
        "Separation",
        Kind::Number { min: 1e-6, max: 3.0 },
        Fallback::Computed(
            "0.001, or 0.5 for an arm with more joints than the target needs, which has infinitely many solutions",
        ),
        "Two solutions are distinct where some joint differs by more than this, whole turns aside.",
    )
};

const METHODS: [MethodInfo; 4] = [
    MethodInfo {
        id: "closed-form",
        title: "Closed form",
        summary: "Computes the angles of up to two joints at once, elbow on either side; a given orientation fixes one joint more.",
        parameters: &[TOLERANCE, MAX_ITERATIONS, SOLUTIONS, FREE_ONLY, SEPARATION],
    },
    MethodInfo {
        id: "newton",
        title: "Newton-Raphson",
        summary: "Follows the tangent to the target by the pseudo-inverse of the Jacobian: quick, and wild near singular arms.",
        parameters: &[TOLERANCE, MAX_ITERATIONS, RESTARTS, SOLUTIONS, FREE_ONLY, SEPARATION],
    },
    MethodInfo {
        id: "damped-least-squares",
        title: "Damped least squares",
        summary: "Weighs the error against the turn of the joints, so that it stays calm where the arm is nearly singular.",
        parameters: &[TOLERANCE, MAX_ITERATIONS, RESTARTS, SOLUTIONS, FREE_ONLY, SEPARATION],
    },
    MethodInfo {
        id: "gradient-descent",
        title: "Gradient descent",
        summary: "Turns every joint downhill, as far as the error falls: simple, without any inverse, and slow at the end.",
        parameters: &[
            ParameterInfo { default: Fallback::Number(1e-4), ..TOLERANCE },
            ParameterInfo { default: Fallback::Number(50_000.0), ..MAX_ITERATIONS },
            RESTARTS,
            SOLUTIONS,
            FREE_ONLY,
            SEPARATION,
        ],
    },
];

/// Every method.
pub fn methods() -> &'static [MethodInfo] {
    &METHODS
}

/// The method with the given id.
///
/// # Errors
/// `out-of-range`, pointer `/method`, naming those that exist.
pub fn method_info(id: &str) -> Result<&'static MethodInfo, Error> {
    METHODS.iter().find(|info| info.id == id).ok_or_else(|| {
        let known = METHODS.iter().map(|info| info.id).collect::<Vec<_>>().join(", ");
        Error::new(Code::OutOfRange, "/method", format!("method must be one of {known}, not {}", quoted(id)))
    })
}

/// The table of methods, to be written.
pub fn catalogue() -> Node {
    let row = |info: &MethodInfo| {
        Node::object(vec![
            ("id", Some(Node::text(info.id))),
            ("title", Some(Node::text(info.title))),
            ("summary", Some(Node::text(info.summary))),
            ("parameters", Some(Node::Array(info.parameters.iter().map(ParameterInfo::node).collect()))),
        ])
    };
    Node::Array(METHODS.iter().map(row).collect())
}
