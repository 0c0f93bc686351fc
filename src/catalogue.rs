//! Everything that can be chosen, as one document: planners, generators, methods, indexes and error codes, with their options.
//!
//! `schema/catalogue.json` holds it; a test compares. It is shipped beside the WebAssembly module, not in it.

use crate::error::Code;
use crate::fleet::{fleet_generators, fleet_planners};
use crate::graph::EventKind;
use crate::ik::methods;
use crate::navigation::{ComparisonOptions, RolloutOptions, TrainingOptions, navigation_generators};
use crate::options::{Info, Kind, OptionInfo, Options, Value, in_camel_case};
use crate::planner::{self, ByControls, Phase, PlannerOptions, Preset, planners};
use crate::run::HISTORY_COLUMNS;
use crate::run::neighbours::{self, indexes};
use crate::trajectories::{ParticleOptions, TrajectoryOptions};
use crate::worlds::generators;
use serde::Serialize;
use serde_json::{Map, Value as Json, json};

/// Declares records of the document, whose types the package derives from them.
macro_rules! records {
    ($($item:item)*) => {
        $(
            #[derive(Serialize)]
            #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
            $item
        )*
    };
}

records! {
    /// A planner, as a page would offer it.
    struct PlannerInfo {
        /// The value of `algorithm`.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "PlannerId"))]
        id: &'static str,
        /// The title for people.
        title: &'static str,
        /// A summary, in a sentence or two.
        summary: &'static str,
        /// What is known about its results, in a sentence.
        guarantee: &'static str,
        /// What it grows: a roadmap, a tree from the start, or one from the start and one from each goal.
        #[cfg_attr(target_arch = "wasm32", tsify(type = r#""roadmap" | "tree" | "trees""#))]
        grows: &'static str,
        /// Whether its edges are drives by controls, so that the goal is a region.
        driven: bool,
        /// The algorithm, line by line.
        pseudocode: Vec<PseudocodeLine>,
        /// The types of robots that it plans for.
        #[cfg_attr(target_arch = "wasm32", tsify(type = r#"Robot["type"][]"#))]
        robots: Vec<&'static str>,
        /// Named settings; may be empty.
        presets: Vec<PresetInfo>,
        /// Its options.
        parameters: Vec<ParameterInfo>,
    }

    /// Settings of a planner that belong together.
    struct PresetInfo {
        /// Unique in its planner.
        id: &'static str,
        /// The title for people.
        title: &'static str,
        /// Options by name, in JavaScript by their names there; others keep their defaults.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "Record<string, number | string | boolean>"))]
        settings: Map<String, Json>,
    }

    /// One line of pseudo-code. An iteration with one of its marks highlights it; each iteration highlights at least one line.
    struct PseudocodeLine {
        /// The line, at most 46 characters.
        text: &'static str,
        /// The depth of its indentation, from 0.
        indent: u8,
        /// The marks that highlight it; none for a line that only encloses others.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "PseudocodeMark[]"))]
        lit_by: Vec<&'static str>,
    }

    /// One option of a planner, a method, an index or a generator.
    struct ParameterInfo {
        /// The name in documents and on the command line, in snake_case.
        name: &'static str,
        /// The name in JavaScript, in camelCase.
        option: String,
        /// The title for people.
        title: &'static str,
        /// The kind of its values.
        #[cfg_attr(target_arch = "wasm32", tsify(type = r#""integer" | "number" | "boolean" | "choice""#))]
        kind: &'static str,
        /// The unit, or an empty string.
        unit: &'static str,
        /// The least value of a number; null if there is none.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "number | null"))]
        min: Option<Json>,
        /// The greatest value of a number; null if there is none.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "number | null"))]
        max: Option<Json>,
        /// The default; null if it depends on the scenario.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "number | boolean | string | null"))]
        default: Option<Json>,
        /// What the default depends on, in words; null if `default` is not.
        #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "string | null"))]
        default_meaning: Option<&'static str>,
        /// The words of a choice.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "string[] | null"))]
        choices: Option<&'static [&'static str]>,
        /// What it does.
        meaning: String,
        /// The types of robots that it is for; it has no meaning for others.
        #[cfg_attr(target_arch = "wasm32", tsify(type = r#"Robot["type"][]"#))]
        robots: &'static [&'static str],
    }

    /// A method of inverse kinematics, as a page would offer it.
    struct ReachMethodInfo {
        /// The value of `method`.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "ReachMethodId"))]
        id: &'static str,
        /// The title for people.
        title: &'static str,
        /// A summary, in a sentence.
        summary: &'static str,
        /// Its options.
        parameters: Vec<ParameterInfo>,
    }

    /// An index of configurations, as a page would offer it.
    struct IndexInfo {
        /// The value of `index`.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "IndexId"))]
        id: &'static str,
        /// The title for people.
        title: &'static str,
        /// A summary, in a sentence.
        summary: &'static str,
        /// Whether it always finds the nearest.
        exact: bool,
        /// Its options.
        parameters: Vec<ParameterInfo>,
    }

    /// A planner of fleets, as a page would offer it.
    struct FleetPlannerInfo {
        /// The value of `algorithm`.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "FleetPlannerId"))]
        id: &'static str,
        /// The title for people.
        title: &'static str,
        /// A summary, in a sentence.
        summary: &'static str,
        /// Its options.
        parameters: Vec<ParameterInfo>,
    }
}

/// Declares the record of a type of generator, with the type of its ids.
macro_rules! generator_records {
    ($($(#[$doc:meta])* $Name:ident { $(#[$first:meta])* $id:literal })*) => {
        records! {
            $(
                $(#[$doc])*
                struct $Name {
                    $(#[$first])*
                    #[cfg_attr(target_arch = "wasm32", tsify(type = $id))]
                    id: &'static str,
                    /// The title for people.
                    title: &'static str,
                    /// A summary, in a sentence.
                    summary: &'static str,
                    /// Its options, except `seed`.
                    options: Vec<ParameterInfo>,
                }
            )*
        }

        $(
            impl From<Info> for $Name {
                fn from(Info { id, title, summary, options }: Info) -> Self {
                    Self { id, title, summary, options: table(&options) }
                }
            }
        )*
    };
}

generator_records! {
    /// A generator of scenarios, as a page would offer it.
    GeneratorInfo {
        /// The first argument of `Scenario.generate`.
        "GeneratorId"
    }
    /// A generator of fleets, as a page would offer it.
    FleetGeneratorInfo {
        /// The first argument of `Fleet.generate`.
        "FleetGeneratorId"
    }
    /// A generator of navigation tasks, as a page would offer it.
    NavigationGeneratorInfo {
        /// The first argument of `Navigation.generate`.
        "NavigationGeneratorId"
    }
}

/// The document.
pub fn catalogue() -> Json {
    let method = |info: &Info| {
        let &Info { id, title, summary, ref options } = info;
        ReachMethodInfo { id, title, summary, parameters: table(options) }
    };
    let fleet_planner = |info: &Info| {
        let &Info { id, title, summary, ref options } = info;
        FleetPlannerInfo { id, title, summary, parameters: table(options) }
    };
    let index = |info: &neighbours::IndexInfo| {
        let &neighbours::IndexInfo { id, title, summary, is_exact: exact, ref parameters, .. } = info;
        IndexInfo { id, title, summary, exact, parameters: table(parameters) }
    };
    json!({
        "planners": planners().iter().map(planner).collect::<Vec<_>>(),
        "reach_methods": methods().iter().map(method).collect::<Vec<_>>(),
        "indexes": indexes().iter().map(index).collect::<Vec<_>>(),
        "generators": generators().into_iter().map(GeneratorInfo::from).collect::<Vec<_>>(),
        "fleet_planners": fleet_planners().iter().map(fleet_planner).collect::<Vec<_>>(),
        "fleet_generators": fleet_generators().into_iter().map(FleetGeneratorInfo::from).collect::<Vec<_>>(),
        "navigation_generators": navigation_generators().into_iter().map(NavigationGeneratorInfo::from).collect::<Vec<_>>(),
        "rollouts": table(&RolloutOptions::table()),
        "training": table(&TrainingOptions::table()),
        "comparison": table(&ComparisonOptions::table()),
        "trajectories": table(&TrajectoryOptions::table()),
        "particle": table(&ParticleOptions::table()),
        "phases": Phase::ALL.iter().map(|phase| phase.as_str()).collect::<Vec<_>>(),
        "event_kinds": EventKind::ALL.iter().map(|kind| kind.as_str()).collect::<Vec<_>>(),
        "history_columns": HISTORY_COLUMNS,
        "errors": Code::ALL.iter().map(|code| json!({ "code": code.as_str(), "meaning": code.meaning() })).collect::<Vec<_>>(),
    })
}

fn planner(planner: &PlannerOptions) -> PlannerInfo {
    let info = planner.info();
    let line = |line: &planner::PseudocodeLine| PseudocodeLine {
        text: line.text,
        indent: line.indent,
        lit_by: line.lit_by.iter().map(|&mark| mark.into()).collect(),
    };
    let preset = |preset: &Preset| {
        let settings = preset.parameters().into_iter().map(|(name, setting)| (name, value(&setting)));
        PresetInfo { id: preset.id, title: preset.title, settings: settings.collect() }
    };
    PlannerInfo {
        id: info.id,
        title: info.title,
        summary: info.summary,
        guarantee: info.guarantee,
        grows: info.grows.into(),
        driven: planner.group::<ByControls>().is_some(),
        pseudocode: info.pseudocode.iter().map(line).collect(),
        robots: planner.robots().to_vec(),
        presets: info.presets.iter().map(preset).collect(),
        parameters: table(&planner.table()),
    }
}

/// A table of options: a default that depends on the rest is null and described in words.
fn table(options: &[OptionInfo]) -> Vec<ParameterInfo> {
    let row = |info: &OptionInfo| {
        let (kind, range, choices) = match &info.kind {
            Kind::Integer(range) => ("integer", Some(range), None),
            Kind::Number(range) => ("number", Some(range), None),
            Kind::Choice(words) => ("choice", None, Some(*words)),
            Kind::Switch => ("boolean", None, None),
        };
        ParameterInfo {
            name: info.name,
            option: in_camel_case(info.name),
            title: info.title,
            kind,
            unit: info.unit,
            min: range.map(|range| number(*range.start())),
            max: range.map(|range| number(*range.end())),
            default: info.default.as_ref().map(value),
            default_meaning: Some(info.computed).filter(|words| !words.is_empty()),
            choices,
            meaning: info.meaning.clone(),
            robots: info.robots,
        }
    };
    options.iter().map(row).collect()
}

fn value(value: &Value) -> Json {
    match value {
        Value::Number(value) => number(*value),
        Value::Text(word) => json!(word),
        Value::Boolean(yes) => json!(yes),
        Value::Other(_) => Json::Null,
    }
}

/// A number, without a fraction if it is whole.
fn number(value: f64) -> Json {
    if value.fract() == 0.0 && value.abs() <= (1u64 << 53) as f64 { json!(value as i64) } else { json!(value) }
}
