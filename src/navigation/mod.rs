//! Navigation by a learned policy (draft).

mod comparison;
mod document;
mod episode;
mod execution;
mod floor;
mod generate;
mod policy;
mod result;
mod roadmap;
mod rollout;
mod training;

pub use comparison::{Comparison, ComparisonOptions, Execution, Method, MethodSummary, assess};
#[cfg(feature = "schema")]
pub use document::schema;
pub use document::{MAX_RAYS, Navigation, NavigationQuery, Navigator, Noise, Sensor};
pub use execution::Executor;
pub use generate::{generate, generate_with, navigation_generators};
pub use policy::{MAX_HIDDEN, POLICY_FORMAT, Policy};
pub use result::{NavigationResult, navigate};
pub use roadmap::{EdgeRollouts, RolloutOptions, edge_rollouts, start};
pub use rollout::{Drive, Outcome};
#[cfg(feature = "parallel")]
pub use training::train;
pub use training::{Generation, Training, TrainingOptions};

/// The `format` of a navigation task.
pub const FORMAT: &str = "planarium-navigation-1";
