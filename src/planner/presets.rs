//! Settings of the course reports that planners here continue, by name.

use super::Value;
use crate::json::Node;

/// Settings of a planner that belong together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Preset {
    /// The id, in kebab-case, distinct within the planner.
    pub id: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// Names and values of parameters, as on the command line; all others keep their defaults.
    pub settings: &'static [(&'static str, &'static str)],
}

impl Preset {
    /// The settings as options take them.
    pub fn parameters(&self) -> Vec<(String, Value)> {
        self.settings.iter().map(|&(name, value)| (name.to_owned(), Value::from_text(value))).collect()
    }

    /// The preset as it is written.
    pub(super) fn node(&self) -> Node {
        // Numbers and truth values read as JSON; a word does not.
        let value = |text: &str| Node::parse(text).unwrap_or_else(|_| Node::text(text));
        let settings = self.settings.iter().map(|&(name, text)| (name, Some(value(text))));
        Node::object(vec![
            ("id", Some(Node::text(self.id))),
            ("title", Some(Node::text(self.title))),
            ("settings", Some(Node::object(settings.collect()))),
        ])
    }
}

/// Of `prm`.
pub(super) const PRM: &[Preset] = &[
    Preset { id: "thirty-nearest", title: "1000 samples, k = 30", settings: &[("samples", "1000"), ("k", "30")] },
    Preset {
        id: "three-nearest",
        title: "500 joined samples, k = 3",
        settings: &[("samples", "500"), ("k", "3"), ("insertion", "one-by-one"), ("discard", "true")],
    },
];

/// Of `rrt`.
pub(super) const RRT: &[Preset] = &[
    Preset {
        id: "half-way",
        title: "Half the way",
        settings: &[("extend", "half"), ("goal_bias", "0.05"), ("max_iterations", "1000")],
    },
    Preset {
        id: "last-free-point",
        title: "To the last free point",
        settings: &[("extend", "until-obstacle"), ("goal_bias", "0.05"), ("max_iterations", "1000")],
    },
    Preset {
        id: "every-fifth",
        title: "Goal every 5th sample",
        settings: &[("goal_every", "5"), ("max_iterations", "2000")],
    },
];

/// The settings of the report with blossoms of several sizes.
const fn blossom(count: &'static str) -> [(&'static str, &'static str); 5] {
    [
        ("blossom", count),
        ("duration_steps", "250"),
        ("goal_bias", "0.05"),
        ("goal_test", "ends"),
        ("max_iterations", "10000"),
    ]
}

/// Of `rrt-control`.
pub(super) const RRT_CONTROL: &[Preset] = &[
    Preset { id: "blossom-1", title: "Blossom of 1", settings: &blossom("1") },
    Preset { id: "blossom-3", title: "Blossom of 3", settings: &blossom("3") },
    Preset { id: "blossom-5", title: "Blossom of 5", settings: &blossom("5") },
    Preset {
        id: "schedule",
        title: "Finer in the end",
        settings: &[
            ("blossom", "30"),
            ("duration_steps", "200"),
            ("late_duration_steps", "100"),
            ("goal_every", "10"),
            ("late_goal_every", "5"),
            ("blocked", "refused"),
            ("goal_test", "ends"),
            ("max_iterations", "4000"),
        ],
    },
    Preset {
        id: "six-controls",
        title: "Six controls",
        settings: &[
            ("controls", "reeds-shepp"),
            ("nearest", "nearest-visible"),
            ("once", "true"),
            ("duration_steps", "100"),
            ("near_goal_steps", "10"),
            ("goal_test", "ends"),
            ("max_iterations", "2000"),
        ],
    },
];
