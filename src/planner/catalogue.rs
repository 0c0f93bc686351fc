//! The planners that exist, with their parameters: the one table that help texts, documents and controls are made from.

use super::presets::Preset;
use super::pseudocode::PseudocodeLine;
use super::table::PLANNERS;
use crate::error::{Code, Error, quoted};
use crate::json::Node;
use crate::parameters::ParameterInfo;

/// What there is to know about a planner before it runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlannerInfo {
    /// The id, in kebab-case, the same everywhere.
    pub id: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// What it does, in one sentence.
    pub summary: &'static str,
    /// How it works, line by line.
    pub pseudocode: &'static [PseudocodeLine],
    /// The types of robots that it plans for, as in documents.
    pub robots: &'static [&'static str],
    /// Settings with a name.
    pub presets: &'static [Preset],
    /// Its parameters.
    pub parameters: &'static [ParameterInfo],
}

/// Every planner.
pub fn planners() -> &'static [PlannerInfo] {
    &PLANNERS
}

/// The planner with the given id.
///
/// # Errors
/// `unknown-planner`, pointer `/algorithm`, naming those that exist.
pub fn planner_info(id: &str) -> Result<&'static PlannerInfo, Error> {
    PLANNERS.iter().find(|info| info.id == id).ok_or_else(|| {
        let known = PLANNERS.iter().map(|info| info.id).collect::<Vec<_>>().join(", ");
        Error::new(Code::UnknownPlanner, "/algorithm", format!("there is no planner {}; there are {known}", quoted(id)))
    })
}

impl PlannerInfo {
    /// Refuses a robot that the planner is not for, by its type.
    ///
    /// # Errors
    /// `unsupported`, pointer `/algorithm`, naming planners for it.
    pub fn check_robot(&self, robot: &str) -> Result<(), Error> {
        if self.robots.contains(&robot) {
            return Ok(());
        }
        let fitting = PLANNERS.iter().filter(|info| info.robots.contains(&robot)).map(|info| info.id);
        let (id, own, fitting) = (self.id, self.robots.join(", "), fitting.collect::<Vec<_>>().join(", "));
        let sentence = format!("{id} plans for robots of type {own}, not {robot}; for that there are {fitting}");
        Err(Error::new(Code::Unsupported, "/algorithm", sentence))
    }
}

/// The table of planners, to be written: a default that depends on the space is null and told in words.
pub fn catalogue() -> Node {
    let row = |info: &PlannerInfo| {
        Node::object(vec![
            ("id", Some(Node::text(info.id))),
            ("title", Some(Node::text(info.title))),
            ("summary", Some(Node::text(info.summary))),
            ("pseudocode", Some(Node::Array(info.pseudocode.iter().map(PseudocodeLine::node).collect()))),
            ("robots", Some(Node::words(info.robots))),
            ("presets", Some(Node::Array(info.presets.iter().map(Preset::node).collect()))),
            ("parameters", Some(Node::Array(info.parameters.iter().map(ParameterInfo::node).collect()))),
        ])
    };
    Node::Array(PLANNERS.iter().map(row).collect())
}

/// The planner taken where none is named, for a robot of that type.
pub fn default_planner(robot: &str) -> &'static str {
    if robot == "car" { "rrt-control" } else { "rrt-connect" }
}

/// The tolerance taken where none is given, as a fraction of the world's longer side.
pub const DEFAULT_TOLERANCE: f64 = 1e-4;
