//! Experiments and statistics for JavaScript.

use super::arguments::{count, document_tree, numbers, records, text};
use super::clock::{Timed, advance};
use super::records::{object, record};
use super::types::{ExperimentInput, JsNumber, JsSummary, JsText, JsTrialRow, JsTrialRows, Measures, Sample};
use super::{digits, types};
use crate::Error;
use crate::error::Code;
use crate::experiment::{self, Summary, TrialRun, Trials, cell_text};
use crate::problem;
use crate::problem::Stepped;
use crate::statistics::{self, Ecdf, Mean, Names, Paired, Quartiles, Share};
use serde_json::{Map, Value};
use std::cell::RefCell;
use std::sync::Arc;
use tsify::Ts;
use wasm_bindgen::prelude::*;

/// A checked experiment: every planner with every one of its settings, in every world, with every seed; `Experiment.parse` makes
/// it. Trials are numbered, and depend on nothing but their number, so several workers can share them.
#[wasm_bindgen]
pub struct Experiment {
    experiment: Arc<experiment::Experiment>,
    trials: RefCell<Trials>,
}

#[wasm_bindgen]
impl Experiment {
    /// Reads a document of an experiment: JSON text, or the document as an object.
    /// @throws {PlanariumError} with a JSON pointer: `invalid-json`, `unknown-field`, `out-of-range`, `too-large`,
    /// `unknown-planner`, `unknown-parameter`, `unsupported`, `start-in-collision`, ...
    pub fn parse(input: &ExperimentInput) -> Result<Experiment, Error> {
        let experiment = Arc::new(experiment::Experiment::read(&document_tree(input, "an experiment")?)?);
        Ok(Self { trials: RefCell::new(Trials::new(&experiment)), experiment })
    }

    /// Starts the trial with this number, from 0 to `trialCount` - 1.
    /// @throws {PlanariumError} `out-of-range`, `not-finite`, `wrong-type`
    pub fn trial(&self, number: &JsNumber) -> Result<Trial, Error> {
        let (number, all) = (count(number, "number")?, self.experiment.trial_count());
        if number >= all {
            let sentence = format!("there are {all} trials, and none is number {number}");
            return Err(Error::new(Code::OutOfRange, "/number", sentence));
        }
        let run = self.trials.borrow_mut().start(number)?;
        Ok(Trial(RefCell::new(Timed::new(run))))
    }

    /// The statistics of rows, in any order: the summary that `planarium sweep` prints of the same rows. Rows may have the
    /// columns `build_seconds` and `search_seconds` as well. O(trials) of memory.
    /// @throws {PlanariumError} `other-experiment` for rows of another experiment, `out-of-range` for a trial that it does not
    /// have; `duplicate-name` for two rows of one trial that differ (the same row again counts once); `wrong-type`,
    /// `missing-field`
    pub fn summary(&self, rows: &JsTrialRows) -> Result<JsSummary, Error> {
        let rows: Vec<Map<String, Value>> = records(rows, "rows")?;
        let (fingerprint, all) = (digits(self.experiment.fingerprint()), self.experiment.trial_count());
        let mut summary = Summary::new(&self.experiment);
        for (i, row) in rows.iter().enumerate() {
            let cell = |name: &str| row.get(name).map_or(String::new(), cell_text);
            if cell("experiment") != fingerprint {
                let sentence = format!("row {i} is not one of experiment {fingerprint}");
                return Err(Error::new(Code::OtherExperiment, format!("/rows/{i}/experiment"), sentence));
            }
            let Some(trial) = cell("trial").parse().ok().filter(|trial| *trial < all) else {
                let sentence = format!("there are {all} trials, and none is number {}", cell("trial"));
                return Err(Error::new(Code::OutOfRange, format!("/rows/{i}/trial"), sentence));
            };
            summary.add_row(trial, cell).map_err(|error| error.under(&format!("/rows/{i}")))?;
        }
        Ok(object(&summary.document()).into())
    }
}

members! { Experiment(self): wasm_bindgen(getter);
    /// The title; empty if there is none.
    title: String = self.experiment.title().unwrap_or_default().to_owned();
    /// How many trials there are.
    trialCount: f64 = self.experiment.trial_count() as f64;
    /// 16 hexadecimal digits over the document except its title and its measures, as in rows.
    fingerprint: String = digits(self.experiment.fingerprint());
    /// The columns of rows, in their order.
    columns: Vec<String> = self.experiment.columns();
    /// The columns that the document asks to be summarised.
    measures: Measures = object(self.experiment.measures()).into();
}

/// A trial that runs. How it is stepped does not change its row.
#[wasm_bindgen]
pub struct Trial(RefCell<Timed<TrialRun>>);

/// A trial may end while its status is still `Running`, once its budget is spent: ask `is_over`, not the status.
impl Stepped for TrialRun {
    fn iterate(&mut self) {
        self.step(1);
    }

    fn status(&self) -> problem::Status {
        self.status()
    }

    fn step(&mut self, n: u64) -> problem::Status {
        self.step(n);
        self.status()
    }

    fn iterations(&self) -> u64 {
        self.iterations()
    }

    fn phase(&self) -> problem::Phase {
        self.phase()
    }
}

#[wasm_bindgen]
impl Trial {
    /// Makes at most `n` iterations; whether the trial goes on.
    pub fn step(&self, n: &JsNumber) -> Result<bool, Error> {
        advance(&self.0, count(n, "n")?, f64::INFINITY);
        Ok(!self.0.borrow().run.is_over())
    }

    /// Makes iterations for about `ms` milliseconds, one at least; whether the trial goes on.
    #[wasm_bindgen(js_name = stepFor)]
    pub fn step_for(&self, ms: &JsNumber) -> Result<bool, Error> {
        advance(&self.0, u64::MAX, super::arguments::not_negative(ms, "ms")?);
        Ok(!self.0.borrow().run.is_over())
    }

    /// The row of the trial, by column: the same on every platform; null where a column does not apply.
    /// @throws {PlanariumError} `unsupported` before the trial is over
    pub fn row(&self) -> Result<JsTrialRow, Error> {
        let timed = self.0.borrow();
        if !timed.run.is_over() {
            return Err(Error::new(Code::Unsupported, "", "the trial is not over: step it until `step` returns false"));
        }
        let mut row = Map::new();
        timed.run.columns().into_iter().zip(timed.run.row()?).for_each(|(name, cell)| drop(row.insert(name, cell)));
        Ok(object(&row).into())
    }
}

members! { Trial(self): wasm_bindgen(getter);
    /// `running` while it goes on, and if its budget was spent without a path.
    status: types::Status = self.0.borrow().run.status().into();
    /// Iterations made so far.
    iterations: f64 = self.0.borrow().run.iterations() as f64;
    /// Seconds spent on growing the graph so far.
    buildSeconds: f64 = self.0.borrow().seconds()[0];
    /// Seconds spent on searching the graph and improving the path so far.
    searchSeconds: f64 = self.0.borrow().seconds()[1];
}

/// Declares statistics of one sample.
macro_rules! of_samples {
    ($($(#[$doc:meta])+ $name:ident: $Type:ty;)+) => { $(
        $(#[$doc])+
        #[wasm_bindgen]
        pub fn $name(sample: &Sample) -> Result<Ts<$Type>, Error> {
            Ok(record(&statistics::$name(&numbers(sample, "sample")?)))
        }
    )+ };
}

of_samples! {
    /// The share of numbers that are not 0, with Wilson's 95 % interval. NaN is a missing value, here and in the other
    /// statistics.
    /// @throws {PlanariumError} `wrong-type`
    share: Share;
    /// The quartiles of type 7: linear between neighbours.
    /// @throws {PlanariumError} `wrong-type`
    quartiles: Quartiles;
    /// The empirical distribution function, with missing values in its denominator.
    /// @throws {PlanariumError} `wrong-type`
    ecdf: Ecdf;
    /// The mean with Student's 95 % interval, and how many values it needs to be within 5 % of the mean.
    /// @throws {PlanariumError} `wrong-type`
    mean: Mean;
}

/// The mean of each number and those before it, `width` in all; NaN while there are fewer.
/// @throws {PlanariumError} `wrong-type`, `not-finite`, `out-of-range`
#[wasm_bindgen(js_name = movingAverage)]
pub fn moving_average(sample: &Sample, width: &JsNumber) -> Result<Vec<f64>, Error> {
    let width = usize::try_from(count(width, "width")?).unwrap_or(usize::MAX);
    Ok(statistics::moving_average(&numbers(sample, "sample")?, width))
}

/// Compares two samples of the same trials pair by pair, with the sign test and Wilcoxon's test, and says in words what is shown
/// of the measure of both. `tests` is the number of comparisons made together, 1 by default.
/// @throws {PlanariumError} `wrong-type`, `wrong-dimension`, `not-finite`, `out-of-range`
#[wasm_bindgen]
pub fn paired(
    a: &Sample,
    b: &Sample,
    name_of_a: &JsText,
    name_of_b: &JsText,
    measure: &JsText,
    tests: Option<JsNumber>,
) -> Result<Ts<Paired>, Error> {
    let (first, second) = (numbers(a, "a")?, numbers(b, "b")?);
    if first.len() != second.len() {
        let sentence = format!("both samples must have the same length, not {} and {}", first.len(), second.len());
        return Err(Error::new(Code::WrongDimension, "/b", sentence));
    }
    let [a, b, measure] = [text(name_of_a, "nameOfA")?, text(name_of_b, "nameOfB")?, text(measure, "measure")?];
    let tests = tests.map_or(Ok(1), |tests| count(&tests, "tests"))?;
    Ok(record(&statistics::paired(&first, &second, Names { a: &a, b: &b, measure: &measure }, tests)))
}

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** The document of an experiment. */
export interface ExperimentDocument {
  /** The format of the document. */
  format: "planarium-experiment-1";
  /** The title for people. */
  title?: string;
  /** The worlds; names are distinct. */
  worlds: ExperimentWorld[];
  /** The planners; names are distinct. Parameters are named in snake_case, as on the command line. */
  planners: { algorithm: PlannerId; name?: string; set?: Record<string, number | string | boolean>; vary?: Record<string, ExperimentAxis> }[];
  /** The seeds of the planners. */
  seeds: ExperimentSeeds;
  /** The work of a trial at most; without it, the limits of the planners. */
  budget?: { iterations: number } | { clearance_evaluations: number };
  /** Whether every path is verified; `false` by default. */
  verify?: boolean;
  /** The columns that are summarised. */
  measures?: Measure[];
}

/** A scenario, or a generator with its options and seeds. */
export type ExperimentWorld = { name?: string; queries?: string[] } & (
  | { scenario: ScenarioDocument }
  | { generate: GeneratorId; set?: Record<string, number | string | boolean>; vary?: Record<string, ExperimentAxis>; seeds?: ExperimentSeeds });

/** The values of a parameter: a list, or numbers in equal steps. */
export type ExperimentAxis = (number | string | boolean)[] | { from: number; to: number; step: number };

/** A list of seeds, or consecutive ones. */
export type ExperimentSeeds = number[] | { from: number; count: number };

/** A measured number of a trial: a column of rows, or a time. */
export type Measure = "iterations" | "vertices" | "edges" | "waypoints" | "length" | "cost" | "chord_length" | "configuration_checks" | "rejected_samples" | "goal_samples" | "motion_checks"
  | "unchecked_edges" | "nearest_queries" | "visited" | "reopened" | "clearance_evaluations" | "unproven_motions" | "work" | "build_seconds" | "search_seconds";

/** A row by column. */
export type TrialRow = Record<string, number | string | boolean | null>;

/** Values of parameters by name. */
export type ExperimentSettings = Record<string, number | string | boolean>;

/** The statistics of one planner with one setting in worlds of one kind: of the trials that differ in seeds alone. */
export interface ExperimentGroup {
  /** The name of the worlds. */
  world: string;
  /** The options of the generator that vary. */
  world_settings: ExperimentSettings;
  /** The name of the query; null if it is the first of each world. */
  query: string | null;
  /** The name of the planner. */
  planner: string;
  /** Its parameters that vary. */
  settings: ExperimentSettings;
  /** The share of trials that are solved. */
  solved: Share;
  /** The share of paths that the verifier accepts; absent if it was not asked. */
  valid?: Share;
  /** The statistics of every measure of the document, over the trials that are solved. */
  measures: Partial<Record<Measure, { quartiles: Quartiles; mean: Mean }>>;
}

/** One setting compared with the first setting of the first planner, on the same worlds and seeds. */
export interface ExperimentComparison {
  /** The index of its group. */
  group: number;
  /** The index of the group that it is compared with. */
  with: number;
  /** Which of the two is solved, pair by pair: 1 or 0. */
  solved: Paired;
  /** Every measure, over the pairs in which both are solved. */
  measures: Partial<Record<Measure, Paired>>;
}

/** The summary of an experiment. */
export interface ExperimentSummary {
  /** The fingerprint of the experiment. */
  experiment: string;
  /** Its title; absent if there is none. */
  title?: string;
  /** How many trials it has. */
  trials: number;
  /** How many of them are summarised. */
  rows: number;
  /** The trials that differ in seeds alone. */
  groups: ExperimentGroup[];
  /** Each setting compared with the first. */
  comparisons: ExperimentComparison[];
}
"#;
