//! The configurations that a run has found, each once.

use crate::problem::Contact;
use crate::robot::MAX_LINKS;
use crate::space::angular_distance;

/// A configuration that reaches the target but is in collision.
#[derive(Debug, Clone, PartialEq)]
pub struct Rejected {
    /// The configuration; entries past the last joint are 0.
    pub configuration: [f64; MAX_LINKS],
    /// What touches what.
    pub contacts: Vec<Contact>,
}

/// Whether no joint differs by more than `separation`, whole turns aside.
pub(super) fn are_same(a: &[f64; MAX_LINKS], b: &[f64; MAX_LINKS], separation: f64) -> bool {
    a.iter().zip(b).all(|(&a, &b)| angular_distance(a, b) <= separation)
}
