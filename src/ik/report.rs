//! The result of a run as a document.

use super::run::Solver;
use super::verdict::{Reason, Verdict};
use crate::json;
use crate::problem::{Contact, Status, Touched};
use crate::robot::MAX_LINKS;
use serde::{Serialize, Serializer};

/// What has come of a run, as it is written in JSON.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct VerdictDocument {
    /// The verdict: one of the words of [`Verdict::as_str`].
    pub verdict: &'static str,
    /// Why the target is out of reach, where it is.
    pub reason: Option<Reason>,
    /// How near the arm can come, where the target is out of reach.
    pub nearest: Option<NearestDocument>,
    /// What touches what at the first solution, where only such were found.
    pub touching: Option<Vec<Touching>>,
}

/// How near an arm can come, as it is written in JSON.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct NearestDocument {
    /// The configuration that does.
    pub configuration: Vec<f64>,
    /// Where its tip is, in metres.
    pub point: [f64; 2],
    /// How far from the target that is, in metres.
    pub distance: f64,
    /// How far its orientation is from the wanted one, in radians.
    pub turn: f64,
}

/// A part of the arm and what it touches.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Touching {
    /// The link, from 0.
    pub part: usize,
    /// The index of the obstacle, or `bounds`.
    #[serde(serialize_with = "touched")]
    pub obstacle: Touched,
}

/// A configuration that reaches the target, but in collision.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RejectedDocument {
    /// The configuration.
    pub configuration: Vec<f64>,
    /// What touches what.
    pub touching: Vec<Touching>,
}

/// The result of a run, as it is written in JSON.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SolverResult {
    /// The name of the scenario.
    pub scenario: String,
    /// The id of the method.
    pub method: &'static str,
    /// Where the tip was to be, in metres.
    pub target: [f64; 2],
    /// The wanted angle of the last link, in radians, where there is one.
    pub orientation: Option<f64>,
    /// The seed.
    pub seed: u64,
    /// How the run ended.
    pub status: Status,
    /// The configurations that reach the target.
    pub solutions: Vec<Vec<f64>>,
    /// Those kept apart, as they are in collision.
    pub rejected: Vec<RejectedDocument>,
    /// What has come of the run.
    pub verdict: VerdictDocument,
    /// How far from the target the tip may end, in metres.
    pub tolerance: f64,
    /// The work done.
    pub stats: SolverStats,
    /// A hash over every iterate and solution.
    #[serde(with = "json::hex")]
    pub fingerprint: u64,
}

/// The work of a run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SolverStats {
    /// Iterations made.
    pub iterations: u64,
    /// Starts drawn beside the first.
    pub restarts: u32,
    /// Configurations tested for collision.
    pub configuration_checks: u64,
}

impl Solver {
    /// The verdict as a document.
    pub fn verdict_document(&self) -> VerdictDocument {
        let verdict = self.explain();
        let mut document = VerdictDocument { verdict: verdict.as_str(), reason: None, nearest: None, touching: None };
        match verdict {
            Verdict::InCollision { contacts } => document.touching = Some(touching(&contacts)),
            Verdict::OutOfReach { reason, nearest } => {
                document.reason = Some(reason);
                document.nearest = Some(NearestDocument {
                    configuration: self.row(&nearest.configuration),
                    point: [nearest.point.x, nearest.point.y],
                    distance: nearest.distance,
                    turn: nearest.turn,
                });
            }
            Verdict::Reached | Verdict::Running | Verdict::NotFound => (),
        }
        document
    }

    /// The result as a document.
    pub fn result(&self) -> SolverResult {
        let target = self.target();
        let rejected = self.rejected().iter().map(|one| RejectedDocument {
            configuration: self.row(&one.configuration),
            touching: touching(&one.contacts),
        });
        SolverResult {
            scenario: self.scenario().to_owned(),
            method: self.method(),
            target: [target.point.x, target.point.y],
            orientation: target.orientation,
            seed: self.seed(),
            status: self.status(),
            solutions: self.solutions().iter().map(|q| self.row(q)).collect(),
            rejected: rejected.collect(),
            verdict: self.verdict_document(),
            tolerance: self.tolerance(),
            stats: SolverStats {
                iterations: self.iterations(),
                restarts: self.restarts(),
                configuration_checks: self.configuration_checks(),
            },
            fingerprint: self.fingerprint(),
        }
    }

    fn row(&self, q: &[f64; MAX_LINKS]) -> Vec<f64> {
        q[..self.dimension()].to_vec()
    }
}

impl SolverResult {
    /// The document as one line of JSON.
    pub fn to_json(&self) -> String {
        json::to_string(self)
    }
}

fn touching(contacts: &[Contact]) -> Vec<Touching> {
    contacts.iter().map(|contact| Touching { part: contact.part, obstacle: contact.with }).collect()
}

fn touched<S: Serializer>(what: &Touched, target: S) -> Result<S::Ok, S::Error> {
    match what {
        Touched::Obstacle(i) => target.serialize_u64(*i as u64),
        Touched::Bounds => target.serialize_str("bounds"),
    }
}
