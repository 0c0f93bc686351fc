//! The document that a run ends with: what was asked, the path, its length, the work, and a fingerprint of the growth.

use crate::control::{Control, Motion};
use crate::error::{Code, Error, quoted};
use crate::json::Node;
use crate::random::MAX_SEED;
use crate::scenario::reader::Reader;
use crate::stats::Stats;
use crate::status::Status;

/// The result of a plan, in the order and under the names of its JSON form. Numbers are written with the fewest digits
/// that parse back to the same bits.
#[derive(Debug, Clone, PartialEq)]
pub struct ResultDocument {
    /// The name of the scenario.
    pub scenario: String,
    /// The name of the query.
    pub query: String,
    /// The id of the planner.
    pub planner: String,
    /// The seed, at most 2^53 - 1.
    pub seed: u64,
    /// How the run ended.
    pub status: Status,
    /// The waypoints, one configuration each, from the start to the goal; empty unless solved.
    pub path: Vec<Vec<f64>>,
    /// Of a car, what leads from each waypoint to the next along an exact arc: one fewer than there are waypoints.
    pub motions: Option<Vec<Motion>>,
    /// `euler` where motions were computed by Euler's steps: the path is a picture, not a proof. Absent where they are exact.
    pub integration: Option<String>,
    /// The sum of the space's distances along the path, of a car along its arcs; 0 without one.
    pub length: f64,
    /// The work done.
    pub stats: Stats,
    /// A hash over every vertex, edge and event; 16 lower-case hex digits in JSON.
    pub fingerprint: u64,
    /// `sampled` where edges were only looked at in places: the path is not proven. Absent where it is.
    pub edge_check: Option<String>,
    /// The estimated share of the free space that a visibility roadmap covers; absent for other planners, and where a kept one
    /// was gone on with.
    pub coverage: Option<f64>,
    /// How far an RRT came that gave up; absent otherwise.
    pub approximate: Option<Approximate>,
}

/// An approximate answer: the path to the vertex nearest to the goal. It does not reach the goal.
#[derive(Debug, Clone, PartialEq)]
pub struct Approximate {
    /// The waypoints from the start on.
    pub path: Vec<Vec<f64>>,
    /// Of a car, what leads from each to the next.
    pub motions: Option<Vec<Motion>>,
    /// How far from the goal it ends, in the metric of the space.
    pub goal_distance: f64,
}

/// The fields of a result.
const FIELDS: &[&str] = &[
    "scenario",
    "query",
    "planner",
    "seed",
    "status",
    "path",
    "motions",
    "integration",
    "length",
    "stats",
    "fingerprint",
    "edge_check",
    "coverage",
    "approximate",
];

/// The fields of its counts.
const STATS: &[&str] = &[
    "iterations",
    "vertices",
    "edges",
    "configuration_checks",
    "motion_checks",
    "nearest_queries",
    "visited",
    "clearance_evaluations",
    "build_seconds",
    "search_seconds",
];

impl ResultDocument {
    /// Reads a result document.
    ///
    /// # Errors
    /// With the pointer of the offending value: the codes of [`Node::parse`], `unknown-field`, `missing-field`,
    /// `wrong-type`, `not-finite`, `out-of-range` (a seed or a count above 2^53 - 1 or with a fraction, a negative length or
    /// time), and `invalid-result` for a status or a fingerprint that is none. Whether the path is any good is for
    /// [`verify`](crate::path::verify) to say.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let node = Node::parse(text)?;
        let root = Reader::root(&node);
        let fields = root.object()?;
        fields.only(FIELDS)?;
        let text = |name| fields.required(name)?.string().map(str::to_owned);
        Ok(Self {
            scenario: text("scenario")?,
            query: text("query")?,
            planner: text("planner")?,
            seed: fields.required("seed")?.integer("a seed", 0, MAX_SEED)?,
            status: status(fields.required("status")?)?,
            path: fields.required("path")?.items()?.map(|waypoint| waypoint.numbers()).collect::<Result<_, _>>()?,
            motions: fields.optional("motions").map(motions).transpose()?,
            integration: fields.optional("integration").map(|word| word.string().map(str::to_owned)).transpose()?,
            length: fields.required("length")?.number_within("a length", 0.0, f64::MAX)?,
            stats: stats(fields.required("stats")?)?,
            fingerprint: fields.required("fingerprint")?.digits(Code::InvalidResult)?,
            edge_check: fields.optional("edge_check").map(|word| word.string().map(str::to_owned)).transpose()?,
            coverage: fields.optional("coverage").map(|share| share.number_within("a share", 0.0, 1.0)).transpose()?,
            approximate: fields.optional("approximate").map(approximate).transpose()?,
        })
    }

    /// The document as a tree.
    pub fn to_node(&self) -> Node {
        let near = |near: &Approximate| {
            let distance = Node::Number(near.goal_distance);
            let motions = near.motions.as_deref().map(driven);
            Node::object(vec![
                ("path", Some(Node::rows(&near.path))),
                ("motions", motions),
                ("goal_distance", Some(distance)),
            ])
        };
        Node::object(vec![
            ("scenario", Some(Node::text(&self.scenario))),
            ("query", Some(Node::text(&self.query))),
            ("planner", Some(Node::text(&self.planner))),
            ("seed", Some(Node::Number(self.seed as f64))),
            ("status", Some(Node::text(self.status.as_str()))),
            ("path", Some(Node::rows(&self.path))),
            ("motions", self.motions.as_deref().map(driven)),
            ("integration", self.integration.as_deref().map(Node::text)),
            ("length", Some(Node::Number(self.length))),
            ("stats", Some(self.stats.to_node())),
            ("fingerprint", Some(Node::String(format!("{:016x}", self.fingerprint)))),
            ("edge_check", self.edge_check.as_deref().map(Node::text)),
            ("coverage", self.coverage.map(Node::Number)),
            ("approximate", self.approximate.as_ref().map(near)),
        ])
    }

    /// The document as one line of JSON.
    pub fn to_json(&self) -> String {
        self.to_node().to_json()
    }
}

fn status(value: Reader) -> Result<Status, Error> {
    let word = value.string()?;
    let found = [Status::Running, Status::Solved, Status::Exhausted].into_iter().find(|status| status.as_str() == word);
    found.ok_or_else(|| {
        let sentence = format!("a status is running, solved or exhausted, not {}", quoted(word));
        value.error(Code::InvalidResult, sentence)
    })
}

fn stats(value: Reader) -> Result<Stats, Error> {
    let fields = value.object()?;
    fields.only(STATS)?;
    let count = |name| fields.required(name)?.integer("a count", 0, MAX_SEED);
    let seconds = |name| fields.required(name)?.number_within("a time", 0.0, f64::MAX);
    Ok(Stats {
        iterations: count("iterations")?,
        vertices: count("vertices")?,
        edges: count("edges")?,
        configuration_checks: count("configuration_checks")?,
        motion_checks: count("motion_checks")?,
        nearest_queries: count("nearest_queries")?,
        visited: count("visited")?,
        clearance_evaluations: count("clearance_evaluations")?,
        build_seconds: seconds("build_seconds")?,
        search_seconds: seconds("search_seconds")?,
    })
}

/// The motions of a car as a tree.
fn driven(motions: &[Motion]) -> Node {
    let one = |&Motion { control, duration }: &Motion| {
        let control = Node::numbers(&[control.speed, control.steering]);
        Node::object(vec![("control", Some(control)), ("duration", Some(Node::Number(duration)))])
    };
    Node::Array(motions.iter().map(one).collect())
}

fn motions(value: Reader) -> Result<Vec<Motion>, Error> {
    let one = |item: Reader| {
        let fields = item.object()?;
        fields.only(&["control", "duration"])?;
        let control = fields.required("control")?;
        let [speed, steering] = control.tuple("a control")?;
        let control = Control { speed: speed.number()?, steering: steering.number()? };
        Ok(Motion { control, duration: fields.required("duration")?.number_within("a duration", 0.0, f64::MAX)? })
    };
    value.items()?.map(one).collect()
}

fn approximate(value: Reader) -> Result<Approximate, Error> {
    let fields = value.object()?;
    fields.only(&["path", "motions", "goal_distance"])?;
    let path = fields.required("path")?.items()?.map(|waypoint| waypoint.numbers()).collect::<Result<_, _>>()?;
    Ok(Approximate {
        path,
        motions: fields.optional("motions").map(motions).transpose()?,
        goal_distance: fields.required("goal_distance")?.number_within("a distance", 0.0, f64::MAX)?,
    })
}
