//! The result of a run as a document.

use super::run::Reach;
use super::solutions::Rejected;
use super::verdict::Verdict;
use crate::json::Node;
use crate::robot::MAX_LINKS;
use crate::validity::{Contact, Touched};

impl Reach {
    /// The verdict as a tree: `verdict`, a word; and where they are known `reason`, a word, `nearest`, with `configuration`,
    /// `point` (metres), `distance` (metres) and `turn` (radians), and `touching`, pairs of `part` and `obstacle`.
    pub fn verdict_node(&self) -> Node {
        let verdict = self.explain();
        let (mut reason, mut near, mut touching) = (Node::Null, Node::Null, Node::Null);
        match &verdict {
            Verdict::InCollision { contacts } => touching = contact_nodes(contacts),
            Verdict::OutOfReach { reason: why, nearest } => {
                reason = Node::text(why.as_str());
                near = Node::object(vec![
                    ("configuration", Some(self.row(&nearest.configuration))),
                    ("point", Some(Node::numbers(&[nearest.point.x, nearest.point.y]))),
                    ("distance", Some(Node::Number(nearest.distance))),
                    ("turn", Some(Node::Number(nearest.turn))),
                ]);
            }
            Verdict::Reached | Verdict::Running | Verdict::NotFound => (),
        }
        Node::object(vec![
            ("verdict", Some(Node::text(verdict.as_str()))),
            ("reason", Some(reason)),
            ("nearest", Some(near)),
            ("touching", Some(touching)),
        ])
    }

    /// The result document: scenario, method, target, seed, status, solutions, those rejected, verdict, counts and fingerprint.
    pub fn result(&self) -> Node {
        let target = self.target();
        let rejected = |one: &Rejected| {
            let [q, touching] = [self.row(&one.configuration), contact_nodes(&one.contacts)];
            Node::object(vec![("configuration", Some(q)), ("touching", Some(touching))])
        };
        let rows = |list: &[[f64; MAX_LINKS]]| Node::Array(list.iter().map(|q| self.row(q)).collect());
        let count = |count: u64| Some(Node::Number(count as f64));
        Node::object(vec![
            ("scenario", Some(Node::text(self.scenario()))),
            ("method", Some(Node::text(self.method()))),
            ("target", Some(Node::numbers(&[target.point.x, target.point.y]))),
            ("orientation", Some(target.orientation.map_or(Node::Null, Node::Number))),
            ("seed", count(self.seed())),
            ("status", Some(Node::text(self.status().as_str()))),
            ("solutions", Some(rows(self.solutions()))),
            ("rejected", Some(Node::Array(self.rejected().iter().map(rejected).collect()))),
            ("verdict", Some(self.verdict_node())),
            ("tolerance", Some(Node::Number(self.tolerance()))),
            (
                "stats",
                Some(Node::object(vec![
                    ("iterations", count(self.iterations())),
                    ("restarts", count(u64::from(self.restarts()))),
                    ("configuration_checks", count(self.configuration_checks())),
                ])),
            ),
            ("fingerprint", Some(Node::String(format!("{:016x}", self.fingerprint())))),
        ])
    }

    fn row(&self, q: &[f64; MAX_LINKS]) -> Node {
        Node::numbers(&q[..self.dimension()])
    }
}

fn contact_nodes(contacts: &[Contact]) -> Node {
    let node = |contact: &Contact| {
        let obstacle = match contact.with {
            Touched::Obstacle(i) => Node::Number(i as f64),
            Touched::Bounds => Node::text("bounds"),
        };
        Node::object(vec![("part", Some(Node::Number(contact.part as f64))), ("obstacle", Some(obstacle))])
    };
    Node::Array(contacts.iter().map(node).collect())
}
