//! The planners of fleets with their options, and the options of a run.

use super::composite::CompositeOptions;
use super::pbs::PbsOptions;
use super::prioritized::PrioritizedOptions;
use crate::error::{Code, Error, quoted};
use crate::options::{Info, Options as _, Value};

/// A planner of fleets with its options.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum FleetPlannerOptions {
    /// Priority-based search.
    Pbs(PbsOptions),
    /// One robot after the other.
    Prioritized(PrioritizedOptions),
    /// Two or three robots as one.
    Composite(CompositeOptions),
}

impl From<PbsOptions> for FleetPlannerOptions {
    fn from(options: PbsOptions) -> Self {
        Self::Pbs(options)
    }
}

impl From<PrioritizedOptions> for FleetPlannerOptions {
    fn from(options: PrioritizedOptions) -> Self {
        Self::Prioritized(options)
    }
}

impl From<CompositeOptions> for FleetPlannerOptions {
    fn from(options: CompositeOptions) -> Self {
        Self::Composite(options)
    }
}

impl FleetPlannerOptions {
    /// Its id, in kebab-case.
    pub fn id(&self) -> &'static str {
        match self {
            Self::Pbs(_) => "pbs",
            Self::Prioritized(_) => "prioritized",
            Self::Composite(_) => "composite",
        }
    }

    /// The planner with the given id and with options given by name; the rest have their defaults.
    ///
    /// # Errors
    /// `unknown-planner`, pointer `/algorithm`; `unknown-parameter`, `duplicate-field`, `wrong-type`, `not-finite` or
    /// `out-of-range`, with the pointer `/name`.
    pub fn read(id: &str, given: &[(String, Value)]) -> Result<Self, Error> {
        let Some(planner) = all().into_iter().find(|planner| planner.id() == id) else {
            let known = all().map(|planner| planner.id()).join(", ");
            let sentence = format!("unknown planner {}; the planners of fleets are {known}", quoted(id));
            return Err(Error::new(Code::UnknownPlanner, "/algorithm", sentence));
        };
        planner.updated(given)
    }

    /// Refuses values out of range.
    pub(super) fn check(&self) -> Result<(), Error> {
        self.updated(&[]).map(|_| ())
    }

    fn updated(&self, given: &[(String, Value)]) -> Result<Self, Error> {
        Ok(match self {
            Self::Pbs(options) => options.updated(given)?.into(),
            Self::Prioritized(options) => options.updated(given)?.into(),
            Self::Composite(options) => options.updated(given)?.into(),
        })
    }
}

/// Every planner with its default options.
fn all() -> [FleetPlannerOptions; 3] {
    [PbsOptions::default().into(), PrioritizedOptions::default().into(), CompositeOptions::default().into()]
}

/// The planners of fleets with their options.
pub fn fleet_planners() -> Vec<Info> {
    let info = |id, title, summary, options| Info { id, title, summary, options };
    vec![
        info(
            "pbs",
            "PBS",
            "Priority-based search: where two robots conflict, one gives way; robots that no priorities help move jointly.",
            PbsOptions::table(),
        ),
        info(
            "prioritized",
            "Prioritized",
            "The robots plan one after the other by safe intervals, each around those before it.",
            PrioritizedOptions::table(),
        ),
        info(
            "composite",
            "Composite",
            "RRT-Connect plans for two or three robots at once, in the product of their configuration spaces.",
            CompositeOptions::table(),
        ),
    ]
}

/// The planner, seed and order of priorities of a run.
///
/// # Example
/// ```
/// use planarium::fleet::{FleetOptions, PbsOptions};
///
/// let pbs = PbsOptions { samples: Some(300), ..PbsOptions::default() };
/// let options = FleetOptions { planner: Some(pbs.into()), seed: 1, ..FleetOptions::default() };
/// # assert_eq!(options.order, None);
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FleetOptions {
    /// The planner with its options; by default `pbs`, or `prioritized` if there is an order.
    pub planner: Option<FleetPlannerOptions>,
    /// The seed, 0 to 2^53 - 1.
    pub seed: u64,
    /// The order of priorities, the highest first, of every robot once: names, or indices from 0. For `prioritized` only, which
    /// begins with that of the document if it is `None`, and tries others if it fails.
    pub order: Option<Vec<String>>,
}

impl From<&FleetOptions> for FleetOptions {
    fn from(options: &FleetOptions) -> Self {
        options.clone()
    }
}

/// The options of a planner of fleets, with seed 0.
macro_rules! of_planner {
    ($($Options:ty),*) => { $(
        impl From<$Options> for FleetOptions {
            fn from(options: $Options) -> Self {
                Self { planner: Some(options.into()), ..Self::default() }
            }
        }
    )* };
}

of_planner!(PbsOptions, PrioritizedOptions, CompositeOptions, FleetPlannerOptions);

impl FleetOptions {
    /// These options with the planner of this id, and options of the planner by name.
    ///
    /// # Errors
    /// Those of [`FleetPlannerOptions::read`].
    pub fn with(self, id: Option<&str>, given: &[(String, Value)]) -> Result<Self, Error> {
        let planner = FleetPlannerOptions::read(id.unwrap_or(self.planner().id()), given)?;
        Ok(Self { planner: Some(planner), ..self })
    }

    /// The planner, or that by default.
    pub(super) fn planner(&self) -> FleetPlannerOptions {
        let by_order = || match self.order {
            Some(_) => PrioritizedOptions::default().into(),
            None => PbsOptions::default().into(),
        };
        self.planner.unwrap_or_else(by_order)
    }
}
