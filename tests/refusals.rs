//! Refusals: every case of `refusals.json` is refused with its code, its pointer and, where it has one, a part of its sentence. They
//! are asked for here natively, in Node and in Chrome, and in `package/refusals.test.mjs` through the npm package.
//!
//! A case has a kind, which says what is asked for; a document of the table with values that are set and removed at pointers, or a
//! `text` in its place; and options by name. In options the words "NaN" and "Infinity" are numbers. `schema` says that the schema
//! refuses the document too: it judges each value alone.

use crate::common::documents::refuses;
use crate::common::{arm_and_wall, begin_with, finish, given, options, requests};
use planarium::certificate::{self, Subdivision};
use planarium::fleet::{self, Fleet, FleetOptions, FleetPlanner};
use planarium::geometry::Point;
use planarium::ik::{MethodOptions, Solver, SolverOptions};
use planarium::json::{parse, read};
use planarium::navigation::{self, Comparison, ComparisonOptions, Navigation, Policy, Training, TrainingOptions};
use planarium::optimum::MetricOptions;
use planarium::options::{Options as _, Value};
use planarium::robot::Target;
use planarium::run::neighbours::{self, IndexOptions};
use planarium::run::{CustomProblem, Free, Request, storage::RoadmapDocument};
use planarium::trajectories::{Trajectories, TrajectoryOptions};
use planarium::{Error, experiment::Experiment, scenario::Scenario, worlds};
use serde_json::{Map, Value as Json};
use wasm_bindgen_test::wasm_bindgen_test;

/// A number, of a word too.
fn number(value: &Json) -> f64 {
    value.as_f64().unwrap_or_else(|| value.as_str().and_then(|word| word.parse().ok()).expect("a number"))
}

fn numbers(values: &Json) -> Vec<f64> {
    values.as_array().expect("numbers").iter().map(number).collect()
}

/// The options of a case, from which those that are no parameters are taken.
struct Given(Map<String, Json>);

impl Given {
    fn text(&mut self, name: &str) -> Option<String> {
        self.0.remove(name).map(|value| value.as_str().expect("a word").to_owned())
    }

    fn seed(&mut self) -> u64 {
        self.0.remove("seed").map_or(0, |seed| seed.as_u64().expect("a seed"))
    }

    fn parameters(self) -> Vec<(String, Value)> {
        let value = |value: Json| match value.as_str() {
            Some("NaN" | "Infinity") => Value::Number(number(&value)),
            _ => Value::from(&value),
        };
        self.0.into_iter().map(|(name, given)| (name, value(given))).collect()
    }

    fn request(mut self) -> Request {
        let (planner, query, seed) = (self.text("algorithm"), self.text("query"), self.seed());
        Request { planner, query, seed, parameters: self.parameters(), ..Request::default() }
    }
}

/// One case and the table of documents.
struct Case<'a> {
    case: &'a Json,
    documents: &'a Json,
}

impl Case<'_> {
    fn word(&self, name: &str) -> &str {
        self.case[name].as_str().unwrap_or_default()
    }

    fn given(&self) -> Given {
        Given(self.case["options"].as_object().cloned().unwrap_or_default())
    }

    /// The document as it is changed.
    fn tree(&self) -> Json {
        let mut tree = self.documents[self.word("document")].clone();
        let at = |pointer: &str| {
            let (parent, name) = pointer.rsplit_once('/').expect("a pointer");
            (parent.to_owned(), name.replace("~1", "/").replace("~0", "~"))
        };
        for pointer in self.case["remove"].as_array().into_iter().flatten() {
            let (parent, name) = at(pointer.as_str().expect("a pointer"));
            tree.pointer_mut(&parent).and_then(Json::as_object_mut).expect("fields").remove(&name).expect("a field");
        }
        for (pointer, value) in self.case["set"].as_object().into_iter().flatten() {
            let (parent, name) = at(pointer);
            match tree.pointer_mut(&parent).expect("a place") {
                Json::Array(items) => items[name.parse::<usize>().expect("an index")] = value.clone(),
                parent => parent[name] = value.clone(),
            }
        }
        tree
    }

    fn text(&self) -> String {
        self.case["text"].as_str().map_or_else(|| self.tree().to_string(), str::to_owned)
    }

    fn scenario(&self) -> Scenario {
        Scenario::parse(&self.text()).expect("a scenario")
    }

    fn task(&self) -> Navigation {
        Navigation::parse(&self.text()).expect("a task")
    }

    fn policy(&self) -> Policy {
        Policy::read(&self.documents["policy"]).expect("a policy")
    }

    fn problem(&self) -> Result<CustomProblem, Error> {
        let tree = self.tree();
        let nowhere = |_: &[f64], clearances: &mut [f64]| {
            clearances.fill(f64::INFINITY);
            Ok(())
        };
        let free = match (tree["free"].as_str(), tree.get("reach")) {
            (Some("samples"), _) => Free::by_samples(tree["resolution"].as_f64(), |_, free| {
                free.fill(true);
                Ok(())
            }),
            (_, Some(reach)) => Free::by_reach(&numbers(reach), nowhere),
            _ => Free::by_clearance(nowhere),
        };
        let goals: Vec<_> = tree["goals"].as_array().expect("goals").iter().map(numbers).collect();
        CustomProblem::new(read(&tree["space"])?, free, &numbers(&tree["start"]), &goals)
    }

    /// Asks for what is refused. Options that are no object are those of a generator.
    fn ask(&self) -> Result<(), Error> {
        let (id, mut given) = (self.word("generator"), self.given());
        let whole = self.case.get("options").filter(|options| !options.is_object());
        match self.word("kind") {
            "scenario" => Scenario::parse(&self.text()).map(drop),
            "fleet" => Fleet::parse(&self.text()).map(drop),
            "navigation" => Navigation::parse(&self.text()).map(drop),
            "policy" => Policy::parse(&self.text()).map(drop),
            "experiment" => Experiment::parse(&self.text()).map(drop),
            "roadmap" => RoadmapDocument::parse(&self.text()).map(drop),
            "problem" => self.problem().map(drop),
            "generate" => match whole {
                Some(options) => worlds::generate(id, options).map(drop),
                None => worlds::generate_with(id, &given.parameters()).map(drop),
            },
            "generate-fleet" => fleet::generate_with(id, &given.parameters()).map(drop),
            "generate-navigation" => navigation::generate_with(id, &given.parameters()).map(drop),
            "plan" => requests::start(self.scenario(), &given.request()).map(drop),
            "plan-problem" => requests::start_problem(&self.problem()?, &given.request()).map(drop),
            "resume" => {
                let scenario = self.scenario();
                let saved = finish(begin_with(&scenario, "prm", 1, "samples=40 k=6")).roadmap().expect("a roadmap");
                requests::resume(&scenario, &given.request(), &saved).map(drop)
            }
            "plan-fleet" => {
                let names = |order: Json| read(&order).expect("names");
                let id = given.text("algorithm");
                let (seed, order) = (given.seed(), given.0.remove("order").map(names));
                let options = FleetOptions { seed, order, ..FleetOptions::default() };
                let options = options.with(id.as_deref(), &given.parameters())?;
                FleetPlanner::new(&Fleet::parse(&self.text())?, &options).map(drop)
            }
            "plan-navigation" => {
                let (rollouts, options) = navigation::read_options(&given.request())?;
                navigation::start(&self.task(), &self.policy(), &rollouts, &options).map(drop)
            }
            "train" => {
                let seed = given.seed();
                Training::new(&self.task(), &TrainingOptions::read(&given.parameters())?, seed).map(drop)
            }
            "compare" => {
                let seed = given.seed();
                let options = ComparisonOptions::read(&given.parameters())?;
                Comparison::new(&self.task(), &self.policy(), &options, seed).map(drop)
            }
            "reach" => {
                let target = numbers(&given.0.remove("target").expect("a target"));
                let orientation = given.0.remove("orientation").as_ref().map(number);
                let target = Target { point: Point::new(target[0], target[1]), orientation };
                let (method, seed, start) = (given.text("method"), given.seed(), given.0.remove("start"));
                let start = start.as_ref().map(numbers);
                let method = MethodOptions::read(method.as_deref(), &given.parameters())?;
                let options = SolverOptions { target, method, start, seed };
                Solver::new(self.scenario(), &options).map(drop)
            }
            "trajectories" => {
                let seed = given.seed();
                Trajectories::new(&TrajectoryOptions::read(&given.parameters())?, seed).map(drop)
            }
            "neighbours" => {
                let index = given.text("index");
                let options = IndexOptions::read(index.as_deref(), &given.parameters())?;
                neighbours::index(self.scenario(), &options).map(drop)
            }
            "certify" => {
                let mut options =
                    certificate::Options { query: given.text("query"), ..certificate::Options::default() };
                options.clearance = given.0.get("clearance").map_or(options.clearance, number);
                options.cells = given.0.get("cells").map_or(options.cells, |cells| number(cells) as usize);
                Subdivision::new(self.scenario(), &options).map(drop)
            }
            "optimum" => {
                let query = given.text("query");
                let options = MetricOptions::read(&given.parameters())?;
                planarium::optimum::optimum(self.scenario(), query.as_deref(), options).map(drop)
            }
            other => panic!("no kind {other}"),
        }
    }

    /// What is not as the case says, if anything.
    fn fault(&self) -> Option<String> {
        let Err(error) = self.ask() else { return Some(format!("accepted: {}", self.case)) };
        let expected = (self.word("code"), self.word("pointer"));
        let sentence = error.message();
        let is_told = sentence.len() > 10 && !sentence.contains("  ") && sentence.contains(self.word("message"));
        let is_right = (error.code().as_str(), error.pointer()) == expected && is_told;
        (!is_right).then(|| format!("{} at {:?}, {error}: {}", error.code().as_str(), error.pointer(), self.case))
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_case_has_its_code_its_pointer_and_its_sentence() {
    let corpus = parse(include_str!("refusals.json")).expect("JSON");
    let cases = corpus["cases"].as_array().expect("cases");
    let case = |case| Case { case, documents: &corpus["documents"] };
    let faults: Vec<String> = cases.iter().filter_map(|one| case(one).fault()).collect();
    assert!(faults.is_empty(), "{} of {}:\n{}", faults.len(), cases.len(), faults.join("\n"));
}

/// No object has a field twice, but a list of options may.
#[wasm_bindgen_test(unsupported = test)]
fn an_option_given_twice_is_refused() {
    let run = requests::start(arm_and_wall(0.1), &options("rrt-connect", 0, "step=1 step=2"));
    refuses(run.map(drop), "duplicate-field", "/step");
    refuses(TrajectoryOptions::read(&given("count=5 count=6")), "duplicate-field", "/count");
    let twice = given("seed=1 seed=2");
    refuses(worlds::generate_with("forest", &twice), "duplicate-field", "/seed");
    refuses(fleet::generate_with("swap", &twice), "duplicate-field", "/seed");
    refuses(navigation::generate_with("rooms", &twice), "duplicate-field", "/seed");
}

#[cfg(all(feature = "schema", not(target_arch = "wasm32")))]
#[test]
fn schemas_refuse_what_a_value_alone_shows() {
    let corpus = parse(include_str!("refusals.json")).expect("JSON");
    let mut faults = Vec::new();
    for case in corpus["cases"].as_array().expect("cases") {
        let Some(schema) = crate::schema::of(case["kind"].as_str().expect("a kind")) else { continue };
        let Ok(document) = parse(&Case { case, documents: &corpus["documents"] }.text()) else { continue };
        if crate::schema::follows(&schema, &schema, &document) == (case["schema"] == true) {
            faults.push(case.to_string());
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
