//! The planners: one line each. Their files declare everything else.

use super::direct::Direct;
use super::groups::{EdgeOptions, Overgrowth, Termination};
use super::info::{Grows, PlannerInfo, PlannerKind};
use super::{Limits, Planner};
use crate::error::{Code, Error, quoted};
use crate::options::{Change, Field, OptionInfo, Options, Value, is_for, out_of_range};
use crate::problem::Problem;
use crate::space::Space;

registry! {
    Prm(super::prm::PrmOptions),
    PrmStar(super::prm::PrmStarOptions),
    LazyPrm(super::prm::LazyPrmOptions),
    LazyPrmStar(super::prm::LazyPrmStarOptions),
    VisibilityPrm(super::visibility_prm::VisibilityPrmOptions),
    Rrt(super::rrt::RrtOptions),
    RrtConnect(super::rrt_connect::RrtConnectOptions),
    RrtStar(super::rrt_star::RrtStarOptions),
    InformedRrtStar(super::informed_rrt_star::InformedRrtStarOptions),
    FmtStar(super::fmt_star::FmtStarOptions),
    BitStar(super::bit_star::BitStarOptions),
    Aorrtc(super::aorrtc::AorrtcOptions),
    RrtControl(super::rrt_control::RrtControlOptions),
    Sst(super::sst::SstOptions),
}

/// Everything that names each planner.
macro_rules! registry {
    ($($Variant:ident($Options:ty),)*) => {
        /// A planner with its options.
        #[derive(Debug, Clone, Copy, PartialEq)]
        #[non_exhaustive]
        pub enum PlannerOptions {
            $(#[allow(missing_docs)] $Variant($Options),)*
        }

        $(impl From<$Options> for PlannerOptions {
            fn from(options: $Options) -> Self {
                PlannerOptions::$Variant(options)
            }
        })*

        /// Every planner with its default options.
        pub fn planners() -> [PlannerOptions; [$(stringify!($Variant)),*].len()] {
            [$(PlannerOptions::$Variant(Default::default())),*]
        }

        impl PlannerOptions {
            /// Its description.
            pub fn info(&self) -> PlannerInfo {
                match self { $(PlannerOptions::$Variant(_) => <$Options>::INFO,)* }
            }

            /// Its id, in kebab-case.
            pub fn id(&self) -> &'static str {
                match self { $(PlannerOptions::$Variant(_) => <$Options>::INFO.id,)* }
            }

            /// What it grows.
            pub fn grows(&self) -> Grows {
                match self { $(PlannerOptions::$Variant(_) => <$Options>::INFO.grows,)* }
            }

            /// Whether it has an option of this name.
            pub fn has(&self, name: &str) -> bool {
                match self { $(PlannerOptions::$Variant(_) => <$Options as Options>::has(name),)* }
            }

            /// The types of robots that it plans for, as in documents.
            pub fn robots(&self) -> &'static [&'static str] {
                match self { $(PlannerOptions::$Variant(_) => <$Options>::ROBOTS,)* }
            }

            /// Whether every motion must be possible in both directions.
            pub fn needs_symmetry(&self) -> bool {
                match self { $(PlannerOptions::$Variant(_) => <$Options>::NEEDS_SYMMETRY,)* }
            }

            /// The table of its options.
            pub fn table(&self) -> Vec<OptionInfo> {
                match self { $(PlannerOptions::$Variant(_) => <$Options>::table(),)* }
            }

            /// The options that differ from their defaults.
            pub fn changes(&self) -> Vec<Change> {
                match self { $(PlannerOptions::$Variant(options) => options.changes(),)* }
            }

            /// Refuses values out of range.
            ///
            /// # Errors
            /// `not-finite` or `out-of-range`, with the pointer `/name`.
            pub fn check(&self) -> Result<(), Error> {
                self.updated(&[]).map(|_| ())
            }

            /// These options with the values given by name; all must be in range.
            ///
            /// # Errors
            /// `unknown-parameter`, `duplicate-field`, `wrong-type`, `not-finite` or `out-of-range`, with the pointer `/name`.
            pub fn updated(self, given: &[(String, Value)]) -> Result<Self, Error> {
                Ok(match self { $(PlannerOptions::$Variant(options) => PlannerOptions::$Variant(options.updated(given)?),)* })
            }

            /// The group of options of this type, if the planner has it.
            pub fn group<G: 'static>(&self) -> Option<&G> {
                match self { $(PlannerOptions::$Variant(options) => options.group(),)* }
            }

            /// The samples that were asked for, and the iterations that this takes at least; `None` if the planner decides.
            pub fn needed(&self) -> Option<[u64; 2]> {
                match self { $(PlannerOptions::$Variant(options) => options.needed(),)* }
            }

            /// The planner at its beginning.
            ///
            /// # Errors
            /// `out-of-range`, with the pointer of the option, if options do not fit the space or each other.
            pub fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error> {
                self.check_limits()?;
                let planner = match self { $(PlannerOptions::$Variant(options) => options.begin(problem, seed),)* }?;
                Ok(if self.is_direct() {
                    let improves = self.group::<Termination>().is_some();
                    let minimises = improves || matches!(self, PlannerOptions::FmtStar(_));
                    Box::new(Direct::first(planner, improves, minimises))
                } else {
                    planner
                })
            }
        }
    };
}
use registry;

impl PlannerOptions {
    /// Whether the straight motion is tried before the planner begins. Roadmaps have it as an edge, and a tree that is to grow
    /// past its goal would have nothing to grow past.
    fn is_direct(&self) -> bool {
        let grows_on = self.group::<Overgrowth>().is_some_and(|overgrowth| overgrowth.vertices.is_some());
        let is_wanted = self.group::<EdgeOptions>().is_some_and(|edges| edges.direct);
        is_wanted && !grows_on && self.grows() != Grows::Roadmap
    }

    /// The planner with the given id and its default options.
    ///
    /// # Errors
    /// `unknown-planner`, pointer `/algorithm`, naming those that exist.
    pub fn of(id: &str) -> Result<Self, Error> {
        planners().into_iter().find(|planner| planner.id() == id).ok_or_else(|| {
            let known = planners().map(|planner| planner.id()).join(", ");
            let sentence = format!("unknown planner {}; known planners are {known}", quoted(id));
            Error::new(Code::UnknownPlanner, "/algorithm", sentence)
        })
    }

    /// The planner with the given id and with options given by name; the rest have their defaults.
    ///
    /// # Errors
    /// `unknown-planner`, pointer `/algorithm`, and those of [`PlannerOptions::updated`].
    ///
    /// # Example
    /// ```
    /// use planarium::run::{PlannerOptions, PrmOptions, Value};
    ///
    /// let read = PlannerOptions::read("prm", &[("samples".to_owned(), Value::Number(700.0))])?;
    /// assert_eq!(read, PrmOptions { samples: Some(700), ..PrmOptions::default() }.into());
    /// # Ok::<(), planarium::Error>(())
    /// ```
    pub fn read(id: &str, given: &[(String, Value)]) -> Result<Self, Error> {
        Self::of(id)?.updated(given)
    }

    /// Refuses a limit of iterations that cannot suffice for the samples that were asked for.
    fn check_limits(&self) -> Result<(), Error> {
        let given = self.group::<Limits>().and_then(|limits| limits.max_iterations);
        match (given, self.needed()) {
            (Some(most), Some([samples, least])) if u64::from(most) < least => Err(out_of_range(
                "max_iterations",
                format!(
                    "max_iterations must be at least {least} for samples = {samples}, not {most}: {samples} samples cannot be drawn and connected in fewer"
                ),
            )),
            _ => Ok(()),
        }
    }

    /// Whether it plans for robots of this type.
    pub fn is_for(&self, robot: &str) -> bool {
        is_for(self.robots(), robot)
    }
}
