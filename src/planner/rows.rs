//! The rows of the catalogue: every parameter, with the robots that it is for.

use super::catalogue::DEFAULT_TOLERANCE;
use crate::parameters::{Fallback, Kind, ParameterInfo};

/// Every robot, by its type in documents.
pub(super) const ALL: &[&str] = &["arm", "disc", "rigid_body", "car"];

/// The robot that is moved by controls.
pub(super) const CAR: &[&str] = &["car"];

/// A row without a unit.
const fn row(
    name: &'static str,
    title: &'static str,
    kind: Kind,
    default: Fallback,
    meaning: &'static str,
) -> ParameterInfo {
    ParameterInfo { name, title, kind, unit: "", default, meaning, robots: ALL }
}

pub(super) const fn whole(min: f64, max: f64) -> Kind {
    Kind::Integer { min, max }
}

pub(super) const SAMPLES: ParameterInfo = row(
    "samples",
    "Samples",
    whole(0.0, 1e6),
    Fallback::Number(2000.0),
    "How many free samples the roadmap gets: more find narrower ways and shorter paths, but take longer.",
);

pub(super) const K: ParameterInfo = row(
    "k",
    "Neighbours",
    whole(1.0, 1000.0),
    Fallback::Computed("15, or all within the radius where one is given, for up to 4470 samples"),
    "To how many nearest neighbours each vertex is joined: too few leave gaps, more shorten paths and take longer.",
);

pub(super) const RADIUS: ParameterInfo = ParameterInfo {
    unit: "distance in the metric",
    ..row(
        "radius",
        "Radius",
        Kind::Number { min: 1e-6, max: 1e7 },
        Fallback::Computed("none: only the number of neighbours counts"),
        "How far away a neighbour may be: a small radius leaves gaps, a large one joins more and takes longer.",
    )
};

pub(super) const INSERTION: ParameterInfo = row(
    "insertion",
    "Insertion",
    Kind::Choice(&["batch", "one-by-one"]),
    Fallback::Text("batch"),
    "Whether edges come in a batch, after all samples, or one by one, each sample joined at once to earlier ones.",
);

pub(super) const DISCARD: ParameterInfo = row(
    "discard",
    "Discard unconnected",
    Kind::Switch,
    Fallback::Off,
    "Throws a sample away that can be joined to nothing; only where samples are inserted one by one.",
);

pub(super) const K_RULE: ParameterInfo = row(
    "k_rule",
    "Rule for neighbours",
    Kind::Choice(&["karaman-frazzoli", "log-n"]),
    Fallback::Text("karaman-frazzoli"),
    "How many neighbours for n vertices in d dimensions: e (1 + 1/d) ln n nears the shortest path, ln n is quicker.",
);

pub(super) const FAILURES: ParameterInfo = row(
    "failures",
    "Failures at most",
    whole(1.0, 1e6),
    Fallback::Number(400.0),
    "How many samples in a row may bring no new guard before it stops: more cover more of the free space.",
);

pub(super) const STEP: ParameterInfo = ParameterInfo {
    unit: "distance in the metric",
    ..row(
        "step",
        "Step",
        Kind::Number { min: 1e-6, max: 1e7 },
        Fallback::Computed("a fifth of the largest distance in the space"),
        "How far a tree grows at once: short steps find their way round bends, long ones cross open space quickly.",
    )
};

pub(super) const EXTEND: ParameterInfo = row(
    "extend",
    "Growth",
    Kind::Choice(&["step", "half", "until-obstacle"]),
    Fallback::Text("step"),
    "How far the tree grows towards a sample: one step, half the way, or until just before an obstacle.",
);

pub(super) const GOAL_BIAS: ParameterInfo = row(
    "goal_bias",
    "Goal bias",
    Kind::Number { min: 0.0, max: 1.0 },
    Fallback::Number(0.05),
    "How often the tree grows towards the goal: 0 is never, 1 always; too often, and it is stuck at obstacles.",
);

pub(super) const GOAL_EVERY: ParameterInfo = row(
    "goal_every",
    "Goal every n-th time",
    whole(1.0, 1e6),
    Fallback::Computed("never: the goal bias decides"),
    "Grows towards the goal every so many iterations, in place of the goal bias: a small number is often.",
);

pub(super) const SAMPLER: ParameterInfo = row(
    "sampler",
    "Sampler",
    Kind::Choice(&["uniform", "halton", "lattice", "gaussian", "bridge", "obstacle-based", "goal-biased"]),
    Fallback::Text("uniform"),
    "Where samples fall: anywhere, evenly (halton, lattice), near obstacles, between or on them, or about the goal.",
);

pub(super) const SPREAD: ParameterInfo = ParameterInfo {
    unit: "rad or m",
    ..row(
        "spread",
        "Spread",
        Kind::Number { min: 1e-6, max: 1e6 },
        Fallback::Computed("a twentieth of the largest distance in the space, divided by its dimension"),
        "How widely gaussian, bridge and goal-biased samples scatter: less keeps them nearer to obstacles or the goal.",
    )
};

pub(super) const SEARCH: ParameterInfo = row(
    "search",
    "Search",
    Kind::Choice(&["a-star", "dijkstra", "breadth-first", "bidirectional"]),
    Fallback::Text("a-star"),
    "How the roadmap is searched: A* heads for the goal, bidirectional starts at both ends, the others spread out.",
);

pub(super) const COST: ParameterInfo = row(
    "cost",
    "Cost of an edge",
    Kind::Choice(&["metric", "hops"]),
    Fallback::Text("metric"),
    "What A* and Dijkstra make least: the length of the path, or its hops; breadth-first always counts hops.",
);

pub(super) const HEURISTIC: ParameterInfo = row(
    "heuristic",
    "Heuristic",
    Kind::Choice(&["metric", "end-effector", "metric-as-hops", "none"]),
    Fallback::Text("metric"),
    "How A* guesses the rest of the way: close guesses expand fewer vertices; metric-as-hops may miss the best.",
);

pub(super) const EDGE_CHECK: ParameterInfo = row(
    "edge_check",
    "Edges are",
    Kind::Choice(&["proven", "sampled"]),
    Fallback::Text("proven"),
    "Proven free all along, or sampled: looked at in a few places only, so that a path may go through a thin wall.",
);

pub(super) const EDGE_SAMPLES: ParameterInfo = row(
    "edge_samples",
    "Places on an edge",
    whole(1.0, 10_000.0),
    Fallback::Number(20.0),
    "In how many evenly spaced places a sampled edge is looked at: fewer are quicker and miss more.",
);

pub(super) const REDUCE: ParameterInfo = row(
    "reduce",
    "Reduce vertices",
    Kind::Switch,
    Fallback::Off,
    "Leaves out vertices of the finished path wherever the straight motion past them is free.",
);

pub(super) const SHORTCUT: ParameterInfo = row(
    "shortcut",
    "Shortcuts",
    whole(0.0, 1e6),
    Fallback::Number(0.0),
    "How many shortcuts between random places are tried on the finished path: more make it shorter.",
);

pub(super) const PARTIAL_SHORTCUT: ParameterInfo = row(
    "partial_shortcut",
    "Partial shortcuts",
    whole(0.0, 1e6),
    Fallback::Number(0.0),
    "How many shortcuts of one joint or coordinate alone are tried after that: more take out needless turns.",
);

/// In which metric joints are measured.
pub const METRIC: ParameterInfo = ParameterInfo {
    robots: &["arm", "disc"],
    ..row(
        "metric",
        "Metric",
        Kind::Choice(&["sum", "euclidean", "naive"]),
        Fallback::Computed("sum for arms, euclidean for discs"),
        "How joints' turns make a distance: their sum, the root of their squares, or that as if no joint went round.",
    )
};

pub(super) const STEERING: ParameterInfo = ParameterInfo {
    robots: CAR,
    ..row(
        "steering",
        "Steering",
        Kind::Choice(&["dubins", "reeds-shepp"]),
        Fallback::Computed("reeds-shepp for a car with a reverse gear, else dubins"),
        "Along which curves a car goes between places: the shortest forwards (dubins), or with shunts (reeds-shepp).",
    )
};

pub(super) const TOLERANCE: ParameterInfo = ParameterInfo {
    unit: "of the world's longer side",
    ..row(
        "tolerance",
        "Tolerance",
        Kind::Number { min: 1e-9, max: 0.1 },
        Fallback::Number(DEFAULT_TOLERANCE),
        "How near an obstacle a motion may be refused unproven: less fits finer gaps and takes longer; none may touch.",
    )
};

pub(super) const MAX_ITERATIONS: ParameterInfo = row(
    "max_iterations",
    "Iterations at most",
    whole(1.0, 4e9),
    Fallback::Number(100_000.0),
    "After how many iterations without a path the planner gives up: more let it find harder ones.",
);

/// A row of the planners by controls.
const fn driven(
    name: &'static str,
    title: &'static str,
    kind: Kind,
    default: Fallback,
    meaning: &'static str,
) -> ParameterInfo {
    ParameterInfo { robots: CAR, ..row(name, title, kind, default, meaning) }
}

/// The same where it counts steps of integration.
const fn steps(name: &'static str, title: &'static str, default: Fallback, meaning: &'static str) -> ParameterInfo {
    ParameterInfo { unit: "steps of integration", ..driven(name, title, whole(1.0, MOST_STEPS), default, meaning) }
}

/// The same where it is a length.
const fn radius(name: &'static str, title: &'static str, default: Fallback, meaning: &'static str) -> ParameterInfo {
    let kind = Kind::Number { min: 0.0, max: 1e7 };
    ParameterInfo { unit: "distance in the metric", ..driven(name, title, kind, default, meaning) }
}

/// The longest duration of a control, in steps of integration.
pub const MOST_STEPS: f64 = 10_000.0;

pub(super) const CONTROLS: ParameterInfo = driven(
    "controls",
    "Controls",
    Kind::Choice(&["random", "reeds-shepp"]),
    Fallback::Text("random"),
    "Random ones, of which the best is kept, or full speed straight, left and right, both ways, all of them kept.",
);

pub(super) const BLOSSOM: ParameterInfo = driven(
    "blossom",
    "Blossom",
    whole(1.0, 100.0),
    Fallback::Number(1.0),
    "How many random controls are tried at once: more aim better, but a tree that aims too well gets stuck.",
);

pub(super) const DURATION_STEPS: ParameterInfo = steps(
    "duration_steps",
    "Duration at most",
    Fallback::Computed("as many as the fastest straight drive of 0.3 times the largest distance takes"),
    "How long a control is held at most: short drives find bends, long ones cross open space quickly.",
);

pub(super) const SHORTEST_STEPS: ParameterInfo = steps(
    "shortest_steps",
    "Duration at least",
    Fallback::Computed("as many as duration_steps: all drives last equally long"),
    "How long a control is held at least: durations are drawn between this and the longest.",
);

pub(super) const NEAR_GOAL_STEPS: ParameterInfo = steps(
    "near_goal_steps",
    "Least near the goal",
    Fallback::Computed("none: durations are the same everywhere"),
    "Durations shrink in proportion where a drive could pass the goal, but not below this many steps.",
);

pub(super) const BLOCKED: ParameterInfo = driven(
    "blocked",
    "A blocked drive",
    Kind::Choice(&["cut", "refused"]),
    Fallback::Text("cut"),
    "A drive towards an obstacle is cut where its last free step ends, or refused as a whole.",
);

pub(super) const NEAREST: ParameterInfo = driven(
    "nearest",
    "Grown from",
    Kind::Choice(&["nearest", "nearest-visible"]),
    Fallback::Text("nearest"),
    "The vertex nearest to the sample grows, or the nearest that sees it: the straight motion there is free.",
);

pub(super) const ONCE: ParameterInfo = driven(
    "once",
    "Only once",
    Kind::Switch,
    Fallback::Off,
    "Each vertex grows only once; when all have grown, the planner gives up.",
);

pub(super) const LATE_DURATION_STEPS: ParameterInfo = steps(
    "late_duration_steps",
    "Late duration",
    Fallback::Computed("as before"),
    "The longest duration in the last quarter of the iterations: short drives meet a small goal region better.",
);

pub(super) const LATE_GOAL_EVERY: ParameterInfo = driven(
    "late_goal_every",
    "Late goal",
    whole(1.0, 1e6),
    Fallback::Computed("as before"),
    "Grows towards the goal every so many iterations in the last quarter of them.",
);

pub(super) const GOAL_TEST: ParameterInfo = driven(
    "goal_test",
    "Goal looked for",
    Kind::Choice(&["along", "ends"]),
    Fallback::Text("along"),
    "After each step along an edge, which ends where it meets the goal region, or only at the ends of edges.",
);

pub(super) const INTEGRATION: ParameterInfo = driven(
    "integration",
    "Integration",
    Kind::Choice(&["exact", "euler"]),
    Fallback::Text("exact"),
    "Exact arcs, proven free, or explicit Euler steps, looked at one by one: neither exact nor proven, to compare.",
);

pub(super) const SELECTION_RADIUS: ParameterInfo = radius(
    "selection_radius",
    "Selection radius",
    Fallback::Computed("0.06 times the largest distance in the space"),
    "Of the vertices so near to a sample, the cheapest grows: a large radius betters paths, a small one explores.",
);

pub(super) const PRUNING_RADIUS: ParameterInfo = radius(
    "pruning_radius",
    "Pruning radius",
    Fallback::Computed("0.03 times the largest distance in the space"),
    "Of the vertices about so near to each other, only the cheapest grows: a large radius makes the tree sparse.",
);

pub(super) const IMPROVE_ITERATIONS: ParameterInfo = driven(
    "improve_iterations",
    "Improve for",
    whole(0.0, 1e9),
    Fallback::Number(0.0),
    "For how many iterations the tree grows on once it has a path, to find shorter ones.",
);
