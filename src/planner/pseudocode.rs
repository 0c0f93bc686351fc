//! Every planner as pseudo-code, in lines that a viewer lights by what an iteration did: the words of its marks.
//!
//! The marks of an iteration are the phase it began in, `vertex` and `edge` where it added some, the kinds of its events,
//! and `done` where the run has ended with it. A line is lit where one of its marks is among them; a line without marks
//! is there to be read. Each iteration lights at least one line.

use crate::graph::EventKind;
use crate::json::Node;
use crate::phase::Phase;

/// What lights a line of pseudo-code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// The iteration began in this phase, or the run has ended with it ([`Phase::Done`]).
    In(Phase),
    /// A vertex was added.
    Vertex,
    /// An edge was added.
    Edge,
    /// A sample was thrown away: it is in collision, or the sampler found none.
    Rejected,
    /// A motion could not be proven free.
    Refused,
    /// The search expanded a vertex.
    Expanded,
    /// A solution was found.
    Solved,
    /// A free sample was thrown away.
    Discarded,
    /// A vertex became a guard.
    Guard,
    /// A vertex was taken out of the tree.
    Removed,
}

impl Mark {
    /// Every mark.
    pub const ALL: [Mark; 16] = [
        Mark::In(Phase::Sampling),
        Mark::In(Phase::Connecting),
        Mark::In(Phase::Guarding),
        Mark::In(Phase::Searching),
        Mark::In(Phase::Growing),
        Mark::In(Phase::Improving),
        Mark::In(Phase::Done),
        Mark::Vertex,
        Mark::Edge,
        Mark::Rejected,
        Mark::Refused,
        Mark::Expanded,
        Mark::Solved,
        Mark::Discarded,
        Mark::Guard,
        Mark::Removed,
    ];

    /// The word that it is written as.
    pub fn word(self) -> &'static str {
        match self {
            Mark::In(phase) => phase.as_str(),
            Mark::Vertex => "vertex",
            Mark::Edge => "edge",
            Mark::Rejected => "rejected",
            Mark::Refused => "refused",
            Mark::Expanded => "expanded",
            Mark::Solved => "solved",
            Mark::Discarded => "discarded",
            Mark::Guard => "guard",
            Mark::Removed => "removed",
        }
    }

    /// The mark of a kind of event.
    pub fn of(kind: EventKind) -> Self {
        match kind {
            EventKind::SampleRejected => Mark::Rejected,
            EventKind::EdgeRefused => Mark::Refused,
            EventKind::VertexExpanded => Mark::Expanded,
            EventKind::SolutionFound => Mark::Solved,
            EventKind::SampleDiscarded => Mark::Discarded,
            EventKind::GuardAdded => Mark::Guard,
            EventKind::VertexRemoved => Mark::Removed,
        }
    }
}

/// One line of pseudo-code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PseudocodeLine {
    /// The line, of 46 characters at most.
    pub text: &'static str,
    /// How deep it stands, from 0.
    pub indent: u8,
    /// What lights it; nothing lights a line that only frames others.
    pub lit_by: &'static [Mark],
}

impl PseudocodeLine {
    /// The line as it is written.
    pub(super) fn node(&self) -> Node {
        let lit_by: Vec<&str> = self.lit_by.iter().map(|mark| mark.word()).collect();
        Node::object(vec![
            ("text", Some(Node::text(self.text))),
            ("indent", Some(Node::Number(f64::from(self.indent)))),
            ("lit_by", Some(Node::words(&lit_by))),
        ])
    }
}

const fn line(indent: u8, text: &'static str, lit_by: &'static [Mark]) -> PseudocodeLine {
    PseudocodeLine { text, indent, lit_by }
}

const BEGIN: PseudocodeLine = line(0, "G ← {start, goal}; until it has n samples:", &[]);
const SAMPLE: PseudocodeLine = line(1, "q ← a random configuration", &[Mark::In(Phase::Sampling)]);
const KEEP: PseudocodeLine = line(1, "add q to G", &[Mark::Vertex]);
const JOIN: PseudocodeLine = line(1, "if the motion q – p is free: add that edge", &[Mark::Edge]);
const REFUSE: PseudocodeLine = line(1, "else: refuse it", &[Mark::Refused]);
const SEARCH: PseudocodeLine = line(0, "search G from start to goal:", &[Mark::In(Phase::Searching)]);
const EXPAND: PseudocodeLine = line(1, "expand the next open vertex", &[Mark::Expanded, Mark::Solved]);
const NONE_FOUND: PseudocodeLine = line(1, "if the sampler finds none: once more", &[Mark::Rejected]);
const IMPROVE: PseudocodeLine = line(0, "shorten the path, where that is asked for", &[Mark::In(Phase::Improving)]);
const END: PseudocodeLine = line(0, "return the path, or that there is none", &[Mark::In(Phase::Done)]);

/// Of `prm`.
pub(super) const PRM: &[PseudocodeLine] = &[
    BEGIN,
    SAMPLE,
    line(1, "if q collides, or is discarded: next sample", &[Mark::Rejected, Mark::Discarded]),
    KEEP,
    // Connected one by one, edges come while samples do.
    line(0, "for q of G, for p of its nearest neighbours:", &[Mark::In(Phase::Connecting), Mark::Edge, Mark::Refused]),
    JOIN,
    REFUSE,
    SEARCH,
    EXPAND,
    IMPROVE,
    END,
];

/// Of `prm-star`.
pub(super) const PRM_STAR: &[PseudocodeLine] = &[
    BEGIN,
    SAMPLE,
    line(1, "if q collides: next sample", &[Mark::Rejected]),
    KEEP,
    line(0, "k ← e (1 + 1/d) ln n, or by the rule chosen", &[]),
    line(0, "for q of G, for p of its k nearest:", &[Mark::In(Phase::Connecting)]),
    JOIN,
    REFUSE,
    SEARCH,
    EXPAND,
    IMPROVE,
    END,
];

/// Of `visibility-prm`.
pub(super) const VISIBILITY_PRM: &[PseudocodeLine] = &[
    // A roadmap that is gone on with joins the two to what it has.
    line(0, "G ← start and goal, joined where that is free", &[Mark::In(Phase::Connecting)]),
    line(0, "until m samples in a row make no guard:", &[]),
    line(1, "q ← a random configuration", &[Mark::In(Phase::Guarding)]),
    line(1, "if q collides: next sample", &[Mark::Rejected]),
    line(1, "which parts of G have a guard that sees q?", &[Mark::Vertex, Mark::Discarded]),
    line(2, "none: add q, as a guard", &[Mark::Guard]),
    line(2, "one: discard q", &[Mark::Discarded]),
    line(2, "several: add q, and an edge to each of them", &[Mark::Edge]),
    SEARCH,
    EXPAND,
    IMPROVE,
    END,
];

/// Of `rrt`.
pub(super) const RRT: &[PseudocodeLine] = &[
    line(0, "T ← {start}; repeat:", &[]),
    line(1, "q ← a random configuration, or the goal", &[Mark::In(Phase::Growing)]),
    NONE_FOUND,
    line(1, "near ← the vertex of T nearest to q", &[Mark::Edge, Mark::Refused]),
    line(1, "new ← from near some way towards q", &[Mark::Edge, Mark::Refused]),
    line(1, "if near – new is free: add both to T", &[Mark::Vertex, Mark::Edge]),
    line(1, "within a step of the goal, try new – goal:", &[]),
    line(2, "if that is free: solved", &[Mark::Solved]),
    line(1, "a motion that is not free is refused", &[Mark::Refused]),
    IMPROVE,
    line(0, "return the path, or the nearest miss", &[Mark::In(Phase::Done)]),
];

/// Of `rrt-connect`.
pub(super) const RRT_CONNECT: &[PseudocodeLine] = &[
    line(0, "two trees, {start} and {goal}; repeat:", &[]),
    line(1, "A ← the smaller tree, B ← the other one", &[Mark::In(Phase::Growing)]),
    line(1, "q ← a random configuration", &[Mark::In(Phase::Growing)]),
    NONE_FOUND,
    line(1, "new ← from A's nearest a step towards q", &[Mark::Vertex, Mark::Refused]),
    line(1, "if that is free: add it to A, and", &[Mark::Vertex, Mark::Edge]),
    line(2, "B goes step by step from its nearest to new", &[Mark::Vertex, Mark::Edge]),
    line(2, "if B arrives: join the trees, solved", &[Mark::Solved]),
    line(1, "a step that is not free is refused", &[Mark::Refused]),
    IMPROVE,
    END,
];

/// Of `rrt-control`.
pub(super) const RRT_CONTROL: &[PseudocodeLine] = &[
    line(0, "T ← {start}; repeat:", &[]),
    line(1, "q ← a random placement, or the goal", &[Mark::In(Phase::Growing)]),
    NONE_FOUND,
    line(1, "near ← the vertex of T nearest to q", &[Mark::Edge, Mark::Refused]),
    line(1, "if no vertex sees q: once more", &[Mark::Discarded]),
    line(1, "for b controls u, for a while each:", &[Mark::Edge, Mark::Refused]),
    line(2, "drive u from near, up to an obstacle", &[Mark::Edge, Mark::Refused]),
    line(1, "add the end nearest to q, with its u, to T", &[Mark::Vertex, Mark::Edge]),
    line(2, "within the goal region: solved", &[Mark::Solved]),
    line(1, "if none is free: refuse them", &[Mark::Refused]),
    line(0, "return the path, or the nearest miss", &[Mark::In(Phase::Done)]),
];

/// Of `sst`.
pub(super) const SST: &[PseudocodeLine] = &[
    line(0, "T ← {start}; repeat:", &[]),
    line(1, "q ← a random placement, or the goal", &[Mark::In(Phase::Growing), Mark::In(Phase::Improving)]),
    NONE_FOUND,
    line(1, "near ← the cheapest of T about q", &[Mark::Edge, Mark::Refused, Mark::Discarded]),
    line(1, "drive a random control for a random while", &[Mark::Edge, Mark::Refused, Mark::Discarded]),
    line(1, "if that is not free: refuse it", &[Mark::Refused]),
    line(1, "if the end costs least about it: add it", &[Mark::Vertex, Mark::Edge]),
    line(2, "what cost least there before grows no more", &[Mark::Vertex]),
    line(2, "and leaves T once nothing hangs on it", &[Mark::Removed]),
    line(2, "within the goal region: solved", &[Mark::Solved]),
    line(1, "else: throw it away", &[Mark::Discarded]),
    line(0, "return the path, or the nearest miss", &[Mark::In(Phase::Done)]),
];
