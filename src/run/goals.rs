//! The configurations that a query is content with.

use crate::error::{Code, Error};
use crate::scenario::{Goal, Query, Scenario};

/// The goal of the query, or of a query with a target free configurations that reach it, one at least.
pub(super) fn goals(_scenario: &Scenario, query: &Query, _seed: u64, _place: usize) -> Result<Vec<Vec<f64>>, Error> {
    match &query.goal {
        Goal::Configuration(goal) => Ok(vec![goal.clone()]),
        Goal::Target(_) => {
            Err(Error::new(Code::Unsupported, format!("/queries/{_place}/target"), "targets cannot be planned for yet"))
        }
    }
}
