//! The rows of the catalogue: every planner, every parameter.

use super::catalogue::{DEFAULT_TOLERANCE, PlannerInfo};
use super::parameters::{Fallback, Kind, ParameterInfo};

pub(super) const PLANNERS: [PlannerInfo; 5] = [
    PlannerInfo {
        id: "prm",
        title: "PRM",
        summary: "Scatters free samples, joins each to its nearest neighbours, then searches the roadmap.",
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
            TOLERANCE,
            MAX_ITERATIONS,
        ],
    },
    PlannerInfo {
        id: "prm-star",
        title: "PRM*",
        summary: "A PRM whose number of neighbours grows with the logarithm of the samples, as the shortest path demands.",
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
            TOLERANCE,
            MAX_ITERATIONS,
        ],
    },
    PlannerInfo {
        id: "visibility-prm",
        title: "Visibility PRM",
        summary: "Keeps a sample only as a guard that sees what no other sees, or as a link between guards.",
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
            TOLERANCE,
            MAX_ITERATIONS,
        ],
    },
    PlannerInfo {
        id: "rrt",
        title: "RRT",
        summary: "Grows a tree from the start: again and again its nearest vertex takes a step towards a sample.",
        parameters: &[
            ParameterInfo {
                meaning: "How far the tree grows at once, and how near the goal must be to be tried; at least a 10,000th of the largest distance. Growth by half goes farther.",
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
            TOLERANCE,
            MAX_ITERATIONS,
        ],
    },
    PlannerInfo {
        id: "rrt-connect",
        title: "RRT-Connect",
        summary: "Grows one tree from the start and one from the goal, each reaching for the other, until they meet.",
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
    "How many free samples become vertices of the roadmap, besides start and goal.",
);

const K: ParameterInfo = row(
    "k",
    "Neighbours",
    whole(1.0, 1000.0),
    Fallback::Computed("15, or all within the radius where one is given, for up to 4470 samples"),
    "To how many of its nearest neighbours each vertex is joined, where the motion is free.",
);

const RADIUS: ParameterInfo = ParameterInfo {
    unit: "distance in the metric",
    ..row(
        "radius",
        "Radius",
        Kind::Number { min: 1e-6, max: 1e7 },
        Fallback::Computed("none: only the number of neighbours counts"),
        "How far away a neighbour may be for a vertex to be joined to it.",
    )
};

const INSERTION: ParameterInfo = row(
    "insertion",
    "Insertion",
    Kind::Choice(&["batch", "one-by-one"]),
    Fallback::Text("batch"),
    "Whether all samples are drawn before the first edge, or each is joined at once to those before it.",
);

const DISCARD: ParameterInfo = row(
    "discard",
    "Discard unconnected",
    Kind::Switch,
    Fallback::Off,
    "Throw away a sample that connects to nothing; for samples inserted one by one.",
);

const K_RULE: ParameterInfo = row(
    "k_rule",
    "Rule for neighbours",
    Kind::Choice(&["karaman-frazzoli", "log-n"]),
    Fallback::Text("karaman-frazzoli"),
    "How many neighbours for n vertices: the least whole number above e (1 + 1/d) ln n, or ln n rounded up.",
);

const FAILURES: ParameterInfo = row(
    "failures",
    "Failures at most",
    whole(1.0, 1e6),
    Fallback::Number(400.0),
    "After how many samples in a row without a new guard the roadmap is complete; 1 in so many is the share not covered.",
);

const STEP: ParameterInfo = ParameterInfo {
    unit: "distance in the metric",
    ..row(
        "step",
        "Step",
        Kind::Number { min: 1e-6, max: 1e7 },
        Fallback::Computed("a fifth of the largest distance in the space"),
        "The longest edge: how far a tree grows towards a sample at once; at least a 10,000th of the largest distance.",
    )
};

const EXTEND: ParameterInfo = row(
    "extend",
    "Growth",
    Kind::Choice(&["step", "half", "until-obstacle"]),
    Fallback::Text("step"),
    "How far the tree grows towards a sample: one step, half the way, or up to the last free place before an obstacle.",
);

const GOAL_BIAS: ParameterInfo = row(
    "goal_bias",
    "Goal bias",
    Kind::Number { min: 0.0, max: 1.0 },
    Fallback::Number(0.05),
    "With what probability the tree grows towards the goal instead of a sample.",
);

const GOAL_EVERY: ParameterInfo = row(
    "goal_every",
    "Goal every",
    whole(1.0, 1e6),
    Fallback::Computed("never: the goal bias decides"),
    "Every how many iterations the tree grows towards the goal, in place of the goal bias.",
);

const SAMPLER: ParameterInfo = row(
    "sampler",
    "Sampler",
    Kind::Choice(&["uniform", "halton", "lattice", "gaussian", "bridge", "obstacle-based", "goal-biased"]),
    Fallback::Text("uniform"),
    "Where samples fall: anywhere, evenly, near obstacles, between obstacles, on their surface, or about the goal.",
);

const SPREAD: ParameterInfo = ParameterInfo {
    unit: "rad or m",
    ..row(
        "spread",
        "Spread",
        Kind::Number { min: 1e-6, max: 1e6 },
        Fallback::Computed("a twentieth of the largest distance in the space, divided by its dimension"),
        "The deviation of every coordinate for the samplers gaussian, bridge and goal-biased.",
    )
};

const SEARCH: ParameterInfo = row(
    "search",
    "Search",
    Kind::Choice(&["a-star", "dijkstra", "breadth-first", "bidirectional"]),
    Fallback::Text("a-star"),
    "How the roadmap is searched for a path.",
);

const COST: ParameterInfo = row(
    "cost",
    "Cost of an edge",
    Kind::Choice(&["metric", "hops"]),
    Fallback::Text("metric"),
    "What A* and Dijkstra's search count: the length of an edge, or 1; the breadth-first searches always count edges.",
);

const HEURISTIC: ParameterInfo = row(
    "heuristic",
    "Heuristic",
    Kind::Choice(&["metric", "end-effector", "metric-as-hops", "none"]),
    Fallback::Text("metric"),
    "What A* takes for the rest of the way: the distance, the end effector's scaled to stay below it, the distance as if it were hops, or 0.",
);

const EDGE_CHECK: ParameterInfo = row(
    "edge_check",
    "Edges are",
    Kind::Choice(&["proven", "sampled"]),
    Fallback::Text("proven"),
    "Proven free along all of it, or only looked at in a few places: then a path may cross a thin wall.",
);

const EDGE_SAMPLES: ParameterInfo = row(
    "edge_samples",
    "Places on an edge",
    whole(1.0, 10_000.0),
    Fallback::Number(20.0),
    "In how many evenly spaced places a sampled edge is looked at, its far end included.",
);

const REDUCE: ParameterInfo = row(
    "reduce",
    "Reduce vertices",
    Kind::Switch,
    Fallback::Off,
    "Leave out vertices of the path where the straight motion past them is free; improvement comes on top of the iterations.",
);

const SHORTCUT: ParameterInfo = row(
    "shortcut",
    "Shortcuts",
    whole(0.0, 1e6),
    Fallback::Number(0.0),
    "How many shortcuts are tried on the path once it is found.",
);

const PARTIAL_SHORTCUT: ParameterInfo = row(
    "partial_shortcut",
    "Partial shortcuts",
    whole(0.0, 1e6),
    Fallback::Number(0.0),
    "How many shortcuts of one joint or coordinate alone are tried after that.",
);

const METRIC: ParameterInfo = row(
    "metric",
    "Metric",
    Kind::Choice(&["sum", "euclidean", "naive"]),
    Fallback::Computed("sum for arms, euclidean for discs"),
    "How the distances of an arm's joints make one: their sum, the root of their squares, or that root without wrapping at full turns; a disc is always Euclidean.",
);

const TOLERANCE: ParameterInfo = ParameterInfo {
    unit: "of the world's longer side",
    ..row(
        "tolerance",
        "Tolerance",
        Kind::Number { min: 1e-9, max: 0.1 },
        Fallback::Number(DEFAULT_TOLERANCE),
        "A motion that stays this near to an obstacle may be refused unproven; none that touches one is ever accepted.",
    )
};

const MAX_ITERATIONS: ParameterInfo = row(
    "max_iterations",
    "Iterations at most",
    whole(1.0, 4e9),
    Fallback::Number(100_000.0),
    "After how many iterations without a path the planner gives up.",
);
