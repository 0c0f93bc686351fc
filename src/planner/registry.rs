//! The planners: one line each. Their files declare everything else.

use super::info::{PlannerInfo, PlannerKind};
use super::{Limits, Planner};
use crate::error::{Code, Error, quoted};
use crate::options::{Field, OptionInfo, Options, Value, out_of_range};
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

/// The default planner for a robot of this type.
pub fn default_planner(robot: &str) -> &'static str {
    if robot == "car" { super::RrtControlOptions::INFO.id } else { super::RrtConnectOptions::INFO.id }
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

        /// Every planner with its default options.
        pub fn planners() -> [PlannerOptions; [$(stringify!($Variant)),*].len()] {
            [$(PlannerOptions::$Variant(Default::default())),*]
        }

        impl PlannerOptions {
            /// Its description.
            pub fn info(&self) -> PlannerInfo {
                match self { $(PlannerOptions::$Variant(_) => <$Options>::INFO,)* }
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

            /// The same planner with options given by name; the rest take their defaults.
            ///
            /// # Errors
            /// As [`Options::read`].
            pub fn read(&self, given: &[(String, Value)]) -> Result<Self, Error> {
                Ok(match self { $(PlannerOptions::$Variant(_) => PlannerOptions::$Variant(Options::read(given)?),)* })
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
                match self { $(PlannerOptions::$Variant(options) => options.begin(problem, seed),)* }
            }
        }
    };
}
use registry;

impl PlannerOptions {
    /// The planner with the given id and its default options.
    ///
    /// # Errors
    /// `unknown-planner`, pointer `/algorithm`, naming those that exist.
    pub fn of(id: &str) -> Result<Self, Error> {
        planners().into_iter().find(|planner| planner.info().id == id).ok_or_else(|| {
            let known = planners().map(|planner| planner.info().id).join(", ");
            let sentence = format!("unknown planner {}; known planners are {known}", quoted(id));
            Error::new(Code::UnknownPlanner, "/algorithm", sentence)
        })
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

    /// Refuses a robot that the planner is not for, by its type.
    ///
    /// # Errors
    /// `unsupported`, pointer `/algorithm`, naming planners for it.
    pub fn check_robot(&self, robot: &str) -> Result<(), Error> {
        let (id, robots) = (self.info().id, self.robots());
        if robots.contains(&robot) {
            return Ok(());
        }
        let fitting: Vec<&str> =
            planners().iter().filter(|other| other.robots().contains(&robot)).map(|other| other.info().id).collect();
        let (own, fitting) = (robots.join(", "), fitting.join(", "));
        let sentence = format!("{id} plans for robots of type {own}, not {robot}; planners for it are {fitting}");
        Err(Error::new(Code::Unsupported, "/algorithm", sentence))
    }
}
