//! The rows of the catalogue: every planner, every parameter.

use super::catalogue::{DEFAULT_TOLERANCE, PlannerInfo};
use super::parameters::{Fallback, Kind, ParameterInfo};
use super::pseudocode;

pub(super) const PLANNERS: [PlannerInfo; 5] = [
    PlannerInfo {
        id: "prm",
        title: "PRM",
        summary: "Scatters free samples, joins each to its nearest neighbours, and searches this roadmap for a path.",
        pseudocode: pseudocode::PRM,
        parameters: &[
            SAMPLES,
            K,
            RADIUS,
            INSERTION,
            DISCARD,
            SAMPLER,
            SPREAD,
            SEARCH,
            COST,
            HEURISTIC,
            EDGE_CHECK,
            EDGE_SAMPLES,
            REDUCE,
            SHORTCUT,
            PARTIAL_SHORTCUT,
            METRIC,
            STEERING,
            TOLERANCE,
            MAX_ITERATIONS,
        ],
    },
    PlannerInfo {
        id: "prm-star",
        title: "PRM*",
        summary: "A PRM that takes more neighbours as samples grow: just enough for its path to near the shortest.",
        pseudocode: pseudocode::PRM_STAR,
        parameters: &[
            ParameterInfo { kind: whole(0.0, 250_000.0), ..SAMPLES },
            K_RULE,
            SAMPLER,
            SPREAD,
            SEARCH,
            COST,
            HEURISTIC,
            EDGE_CHECK,
            EDGE_SAMPLES,
            REDUCE,
            SHORTCUT,
            PARTIAL_SHORTCUT,
            METRIC,
            STEERING,
            TOLERANCE,
            MAX_ITERATIONS,
        ],
    },
    PlannerInfo {
        id: "visibility-prm",
        title: "Visibility PRM",
        summary: "Keeps few samples: guards, which no other guard sees, and links between guards.",
        pseudocode: pseudocode::VISIBILITY_PRM,
        parameters: &[
            FAILURES,
            SAMPLER,
            SPREAD,
            SEARCH,
            COST,
            HEURISTIC,
            EDGE_CHECK,
            EDGE_SAMPLES,
            REDUCE,
            SHORTCUT,
            PARTIAL_SHORTCUT,
            METRIC,
            STEERING,
            TOLERANCE,
            MAX_ITERATIONS,
        ],
    },
    PlannerInfo {
        id: "rrt",
        title: "RRT",
        summary: "Grows a tree from the start: again and again its nearest vertex takes a step towards a random sample.",
        pseudocode: pseudocode::RRT,
        parameters: &[
            ParameterInfo {
                meaning: "How far the tree grows at once, and how near it tries the goal: short steps find bends, long ones are quick.",
                ..STEP
            },
            EXTEND,
            GOAL_BIAS,
            GOAL_EVERY,
            SAMPLER,
            SPREAD,
            EDGE_CHECK,
            EDGE_SAMPLES,
            REDUCE,
            SHORTCUT,
            PARTIAL_SHORTCUT,
            METRIC,
            STEERING,
            TOLERANCE,
            MAX_ITERATIONS,
        ],
    },
    PlannerInfo {
        id: "rrt-connect",
        title: "RRT-Connect",
        summary: "Grows one tree from the start and one from the goal, each reaching for the other, until they meet.",
        pseudocode: pseudocode::RRT_CONNECT,
        parameters: &[
            STEP,
            SAMPLER,
            SPREAD,
            EDGE_CHECK,
            EDGE_SAMPLES,
            REDUCE,
            SHORTCUT,
            PARTIAL_SHORTCUT,
            METRIC,
            STEERING,
            TOLERANCE,
            MAX_ITERATIONS,
        ],
    },
];

/// A row without a unit.
const fn row(
    name: &'static str,
    title: &'static str,
    kind: Kind,
    default: Fallback,
    meaning: &'static str,
) -> ParameterInfo {
    ParameterInfo { name, title, kind, unit: "", default, meaning }
}

const fn whole(min: f64, max: f64) -> Kind {
    Kind::Integer { min, max }
}

const SAMPLES: ParameterInfo = row(
    "samples",
    "Samples",
    whole(0.0, 1e6),
    Fallback::Number(2000.0),
    "How many free samples the roadmap gets: more find narrower ways and shorter paths, but take longer.",
);

const K: ParameterInfo = row(
    "k",
    "Neighbours",
    whole(1.0, 1000.0),
    Fallback::Computed("15, or all within the radius where one is given, for up to 4470 samples"),
    "To how many nearest neighbours each vertex is joined: too few leave gaps, more shorten paths and take longer.",
);

const RADIUS: ParameterInfo = ParameterInfo {
    unit: "distance in the metric",
    ..row(
        "radius",
        "Radius",
        Kind::Number { min: 1e-6, max: 1e7 },
        Fallback::Computed("none: only the number of neighbours counts"),
        "How far away a neighbour may be: a small radius leaves gaps, a large one joins more and takes longer.",
    )
};

const INSERTION: ParameterInfo = row(
    "insertion",
    "Insertion",
    Kind::Choice(&["batch", "one-by-one"]),
    Fallback::Text("batch"),
    "Whether edges come in a batch, after all samples, or one by one, each sample joined at once to earlier ones.",
);

const DISCARD: ParameterInfo = row(
    "discard",
    "Discard unconnected",
    Kind::Switch,
    Fallback::Off,
    "Throws a sample away that can be joined to nothing; only where samples are inserted one by one.",
);

const K_RULE: ParameterInfo = row(
    "k_rule",
    "Rule for neighbours",
    Kind::Choice(&["karaman-frazzoli", "log-n"]),
    Fallback::Text("karaman-frazzoli"),
    "How many neighbours for n vertices in d dimensions: e (1 + 1/d) ln n nears the shortest path, ln n is quicker.",
);

const FAILURES: ParameterInfo = row(
    "failures",
    "Failures at most",
    whole(1.0, 1e6),
    Fallback::Number(400.0),
    "How many samples in a row may bring no new guard before it stops: more cover more of the free space.",
);

const STEP: ParameterInfo = ParameterInfo {
    unit: "distance in the metric",
    ..row(
        "step",
        "Step",
        Kind::Number { min: 1e-6, max: 1e7 },
        Fallback::Computed("a fifth of the largest distance in the space"),
        "How far a tree grows at once: short steps find their way round bends, long ones cross open space quickly.",
    )
};

const EXTEND: ParameterInfo = row(
    "extend",
    "Growth",
    Kind::Choice(&["step", "half", "until-obstacle"]),
    Fallback::Text("step"),
    "How far the tree grows towards a sample: one step, half the way, or until just before an obstacle.",
);

const GOAL_BIAS: ParameterInfo = row(
    "goal_bias",
    "Goal bias",
    Kind::Number { min: 0.0, max: 1.0 },
    Fallback::Number(0.05),
    "How often the tree grows towards the goal: 0 is never, 1 always; too often, and it is stuck at obstacles.",
);

const GOAL_EVERY: ParameterInfo = row(
    "goal_every",
    "Goal every n-th time",
    whole(1.0, 1e6),
    Fallback::Computed("never: the goal bias decides"),
    "Grows towards the goal every so many iterations, in place of the goal bias: a small number is often.",
);

const SAMPLER: ParameterInfo = row(
    "sampler",
    "Sampler",
    Kind::Choice(&["uniform", "halton", "lattice", "gaussian", "bridge", "obstacle-based", "goal-biased"]),
    Fallback::Text("uniform"),
    "Where samples fall: anywhere, evenly (halton, lattice), near obstacles, between or on them, or about the goal.",
);

const SPREAD: ParameterInfo = ParameterInfo {
    unit: "rad or m",
    ..row(
        "spread",
        "Spread",
        Kind::Number { min: 1e-6, max: 1e6 },
        Fallback::Computed("a twentieth of the largest distance in the space, divided by its dimension"),
        "How widely gaussian, bridge and goal-biased samples scatter: less keeps them nearer to obstacles or the goal.",
    )
};

const SEARCH: ParameterInfo = row(
    "search",
    "Search",
    Kind::Choice(&["a-star", "dijkstra", "breadth-first", "bidirectional"]),
    Fallback::Text("a-star"),
    "How the roadmap is searched: A* heads for the goal, bidirectional starts at both ends, the others spread out.",
);

const COST: ParameterInfo = row(
    "cost",
    "Cost of an edge",
    Kind::Choice(&["metric", "hops"]),
    Fallback::Text("metric"),
    "What A* and Dijkstra make least: the length of the path, or its hops; breadth-first always counts hops.",
);

const HEURISTIC: ParameterInfo = row(
    "heuristic",
    "Heuristic",
    Kind::Choice(&["metric", "end-effector", "metric-as-hops", "none"]),
    Fallback::Text("metric"),
    "How A* guesses the rest of the way: close guesses expand fewer vertices; metric-as-hops may miss the best.",
);

const EDGE_CHECK: ParameterInfo = row(
    "edge_check",
    "Edges are",
    Kind::Choice(&["proven", "sampled"]),
    Fallback::Text("proven"),
    "Proven free all along, or sampled: looked at in a few places only, so that a path may go through a thin wall.",
);

const EDGE_SAMPLES: ParameterInfo = row(
    "edge_samples",
    "Places on an edge",
    whole(1.0, 10_000.0),
    Fallback::Number(20.0),
    "In how many evenly spaced places a sampled edge is looked at: fewer are quicker and miss more.",
);

const REDUCE: ParameterInfo = row(
    "reduce",
    "Reduce vertices",
    Kind::Switch,
    Fallback::Off,
    "Leaves out vertices of the finished path wherever the straight motion past them is free.",
);

const SHORTCUT: ParameterInfo = row(
    "shortcut",
    "Shortcuts",
    whole(0.0, 1e6),
    Fallback::Number(0.0),
    "How many shortcuts between random places are tried on the finished path: more make it shorter.",
);

const PARTIAL_SHORTCUT: ParameterInfo = row(
    "partial_shortcut",
    "Partial shortcuts",
    whole(0.0, 1e6),
    Fallback::Number(0.0),
    "How many shortcuts of one joint or coordinate alone are tried after that: more take out needless turns.",
);

const METRIC: ParameterInfo = row(
    "metric",
    "Metric",
    Kind::Choice(&["sum", "euclidean", "naive"]),
    Fallback::Computed("sum for arms, euclidean for discs"),
    "How joints' turns make a distance: their sum, the root of their squares, or that as if no joint went round.",
);

const STEERING: ParameterInfo = row(
    "steering",
    "Steering",
    Kind::Choice(&["dubins", "reeds-shepp"]),
    Fallback::Computed("reeds-shepp for a car with a reverse gear, else dubins"),
    "Along which curves a car goes from place to place: the shortest forwards (dubins), or with shunts (reeds-shepp).",
);

const TOLERANCE: ParameterInfo = ParameterInfo {
    unit: "of the world's longer side",
    ..row(
        "tolerance",
        "Tolerance",
        Kind::Number { min: 1e-9, max: 0.1 },
        Fallback::Number(DEFAULT_TOLERANCE),
        "How near an obstacle a motion may be refused unproven: less fits finer gaps and takes longer; none may touch.",
    )
};

const MAX_ITERATIONS: ParameterInfo = row(
    "max_iterations",
    "Iterations at most",
    whole(1.0, 4e9),
    Fallback::Number(100_000.0),
    "After how many iterations without a path the planner gives up: more let it find harder ones.",
);
