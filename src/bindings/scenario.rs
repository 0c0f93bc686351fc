//! A scenario in JavaScript's hands.

use super::RawPlanner;
use super::convert::{count, entries, node, number, text, throw, to_object, value};
use crate::geometry::Point;
use crate::inspect::Inspector;
use crate::kept::RoadmapDocument;
use crate::robot::Part;
use crate::run::{self, Options};
use crate::scenario::{Robot, Scenario};
use crate::validity::Touched;
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// A checked scenario and answers about it.
#[wasm_bindgen]
pub struct RawScenario {
    scenario: Scenario,
    inspector: Inspector,
}

/// The answer of a check, as JavaScript sees it.
#[derive(Serialize)]
struct Check {
    free: bool,
    touching: Vec<Touching>,
}

/// A touching pair, as JavaScript sees it.
#[derive(Serialize)]
struct Touching {
    part: usize,
    obstacle: Thing,
}

/// What is touched: the number of an obstacle, or the word `bounds`.
#[derive(Serialize)]
#[serde(untagged)]
enum Thing {
    Obstacle(usize),
    Bounds(&'static str),
}

/// A part of the robot, as JavaScript sees it.
#[derive(Serialize)]
#[serde(tag = "type", rename_all = "lowercase")]
enum Drawn {
    Capsule { a: [f64; 2], b: [f64; 2], radius: f64 },
    Disc { center: [f64; 2], radius: f64 },
}

impl RawScenario {
    fn new(scenario: Scenario) -> Self {
        let inspector = Inspector::new(&scenario);
        Self { scenario, inspector }
    }
}

#[wasm_bindgen]
impl RawScenario {
    /// Reads a scenario from JSON text.
    pub fn parse(text: &str) -> Result<RawScenario, JsValue> {
        Scenario::parse(text).map(Self::new).map_err(throw)
    }

    /// Generates a scenario by the generator's id, with options as a plain object.
    pub fn generate(kind: &str, options: JsValue) -> Result<RawScenario, JsValue> {
        let node = node(options)?;
        crate::scenario::generate::generate(kind, &node).map(Self::new).map_err(throw)
    }

    /// The name.
    pub fn name(&self) -> String {
        self.scenario.name().to_owned()
    }

    /// The title for people.
    pub fn title(&self) -> String {
        self.scenario.title().to_owned()
    }

    /// `arm` or `disc`.
    pub fn robot(&self) -> String {
        match self.scenario.robot() {
            Robot::Arm(_) => "arm".to_owned(),
            Robot::Disc(_) => "disc".to_owned(),
        }
    }

    /// Numbers a configuration.
    pub fn dimension(&self) -> usize {
        self.inspector.dimension()
    }

    /// The scenario as a plain object, normalised.
    pub fn document(&self) -> Result<JsValue, JsValue> {
        to_object(&self.scenario.to_node())
    }

    /// The box worth drawing: min x, min y, max x, max y.
    pub fn extent(&self) -> Vec<f64> {
        let extent = self.inspector.extent();
        vec![extent.min.x, extent.min.y, extent.max.x, extent.max.y]
    }

    /// For every coordinate 1 where it wraps, else 0.
    pub fn circles(&self) -> Vec<u8> {
        self.inspector.circles().into_iter().map(u8::from).collect()
    }

    /// Whether `q` is free, and each touching pair.
    pub fn check(&self, q: &[f64]) -> Result<JsValue, JsValue> {
        let contacts = self.inspector.check(q).map_err(throw)?;
        let touching: Vec<Touching> = contacts
            .iter()
            .map(|contact| match contact.with {
                Touched::Obstacle(i) => Touching { part: contact.part, obstacle: Thing::Obstacle(i) },
                Touched::Bounds => Touching { part: contact.part, obstacle: Thing::Bounds("bounds") },
            })
            .collect();
        to_object(&Check { free: touching.is_empty(), touching })
    }

    /// The parts of the robot at `q`.
    pub fn footprint(&self, q: &[f64]) -> Result<JsValue, JsValue> {
        let place = |p: Point| [p.x, p.y];
        let parts = self.inspector.footprint(q).map_err(throw)?;
        let drawn = parts.into_iter().map(|part| match part {
            Part::Capsule { a, b, radius } => Drawn::Capsule { a: place(a), b: place(b), radius },
            Part::Disc { center, radius } => Drawn::Disc { center: place(center), radius },
        });
        to_object(&drawn.collect::<Vec<_>>())
    }

    /// The tip of the arm or the centre of the disc at `q`: x, y.
    pub fn end_effector(&self, q: &[f64]) -> Result<Vec<f64>, JsValue> {
        self.inspector.end_effector(q).map(|tip| vec![tip.x, tip.y]).map_err(throw)
    }

    /// The same for rows of configurations: rows of x, y.
    pub fn end_effectors(&self, rows: &[f64]) -> Result<Vec<f64>, JsValue> {
        let mut tips = Vec::with_capacity(rows.len() / self.dimension() * 2);
        for row in rows.chunks(self.dimension()) {
            let tip = self.inspector.end_effector(row).map_err(throw)?;
            tips.extend([tip.x, tip.y]);
        }
        Ok(tips)
    }

    /// The configuration a fraction `t` along the motion from `a` to `b`.
    pub fn interpolate(&self, a: &[f64], b: &[f64], t: f64) -> Result<Vec<f64>, JsValue> {
        self.inspector.interpolate(a, b, t).map_err(throw)
    }

    /// The distance from `a` to `b` in the default metric.
    pub fn distance(&self, a: &[f64], b: &[f64]) -> Result<f64, JsValue> {
        self.inspector.distance(a, b).map_err(throw)
    }

    /// Where the motion from `a` to `b` first cannot be proven free; undefined where all of it is proven.
    pub fn first_hit(&self, a: &[f64], b: &[f64]) -> Result<Option<f64>, JsValue> {
        self.inspector.first_hit(a, b).map_err(throw)
    }

    /// The configuration space of an arm of two links, one byte a cell, 1 for collision.
    pub fn cspace(&self, width: f64, height: f64) -> Result<Vec<u8>, JsValue> {
        let (width, height) = (count(width, "width")?, count(height, "height")?);
        // A width beyond what this machine can count is beyond the limit too.
        let cells = |count: u64| usize::try_from(count).unwrap_or(usize::MAX);
        self.inspector.configuration_space(cells(width), cells(height)).map_err(throw)
    }

    /// The angles that it shows: low and high of the first joint, then of the second.
    pub fn cspace_range(&self) -> Result<Vec<f64>, JsValue> {
        self.inspector.configuration_space_range().map(|range| range.concat()).map_err(throw)
    }

    /// Begins a run; `options` holds `algorithm`, `query`, `seed` and the planner's parameters.
    pub fn planner(&self, options: JsValue) -> Result<RawPlanner, JsValue> {
        let wanted = wanted(&options, Options::default())?;
        run::start(&self.scenario, &wanted).map(RawPlanner::new).map_err(throw)
    }

    /// Begins a run that goes on with a roadmap, in its JSON or its binary form; the same options, but that the planner is
    /// the one that built it.
    pub fn resume(&self, roadmap: &[u8], options: JsValue) -> Result<RawPlanner, JsValue> {
        let document = RoadmapDocument::read(roadmap).map_err(throw)?;
        let wanted = wanted(&options, Options { planner: document.planner.clone(), ..Options::default() })?;
        run::resume(&self.scenario, &wanted, &document).map(RawPlanner::new).map_err(throw)
    }
}

/// The options of a run from a plain object, beginning with the defaults.
fn wanted(options: &JsValue, mut wanted: Options) -> Result<Options, JsValue> {
    for (name, given) in entries(options)? {
        match name.as_str() {
            "algorithm" => wanted.planner = text(&name, &given)?,
            "query" => wanted.query = Some(text(&name, &given)?),
            "seed" => wanted.seed = count(number(&name, &given)?, &name)?,
            _ => {
                let parameter = value(&name, &given)?;
                wanted.parameters.push((name, parameter));
            }
        }
    }
    Ok(wanted)
}
