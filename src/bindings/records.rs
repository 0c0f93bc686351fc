//! The records that exist in JavaScript only. Those of documents are declared where they belong, and their types derived there.

use crate::driving;
use crate::problem::{Contact, Touched};
use crate::run::neighbours::NearestResult;
use js_sys::{Float64Array, Uint32Array};
use serde::Serialize;
use serde_wasm_bindgen::{Serializer, preserve};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsValue;

/// A record as a plain object.
pub(super) fn record<T: Serialize + Tsify>(value: &T) -> Ts<T> {
    Ts::new_unchecked(object(value))
}

/// A value as plain values.
pub(super) fn object<T: Serialize + ?Sized>(value: &T) -> JsValue {
    value.serialize(&Serializer::json_compatible()).expect("a record has a form in JavaScript")
}

/// A record whose field `configuration` is a typed array.
pub(super) fn with_configuration<T: Serialize + Tsify>(value: &T, configuration: &[f64]) -> Ts<T> {
    let object = object(value);
    // Setting a property of a fresh object cannot fail.
    let _ = js_sys::Reflect::set(&object, &"configuration".into(), &Float64Array::from(configuration));
    Ts::new_unchecked(object)
}

/// Whether a configuration is free, and what touches if it is not.
#[derive(Serialize, Tsify)]
pub struct Check {
    /// Whether nothing touches.
    free: bool,
    /// Every pair that touches.
    #[tsify(type = "Touching[]")]
    touching: Vec<Contact>,
}

impl From<Vec<Contact>> for Check {
    fn from(touching: Vec<Contact>) -> Self {
        Self { free: touching.is_empty(), touching }
    }
}

/// Whether the start and the goal of a query are free.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct QueryCheck {
    /// The name of the query.
    pub query: String,
    /// Whether both are free; a planner refuses the query otherwise.
    pub free: bool,
    /// The check of the start.
    pub start: Check,
    /// The check of the goal; null if the query has a target instead.
    pub goal: Option<Check>,
}

impl QueryCheck {
    pub(super) fn new(query: String, start: Check, goal: Option<Check>) -> Self {
        Self { query, free: start.free && goal.as_ref().is_none_or(|goal| goal.free), start, goal }
    }
}

/// What stops a car.
#[derive(Serialize)]
#[serde(untagged)]
pub(super) enum Obstructed {
    Touched(Touched),
    Near(&'static str),
}

impl Obstructed {
    pub fn of(blocked: Option<Option<Touched>>) -> Option<Self> {
        blocked.map(|touched| touched.map_or(Obstructed::Near("near"), Obstructed::Touched))
    }
}

/// The state of a drive.
#[derive(Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
#[tsify(missing_as_null)]
pub struct DriveState {
    /// The pose of the car: x, y in metres, theta in radians within (-pi, pi].
    pose: [f64; 3],
    /// The speed, in metres per second; backward if negative.
    v: f64,
    /// The angle of the front wheels, in radians; to the left if positive.
    phi: f64,
    /// The steps made so far, driving or standing.
    steps: u64,
    /// The same in seconds.
    seconds: f64,
    /// What stopped the car, until it moves again; null otherwise.
    #[tsify(type = "Obstructed | null")]
    blocked: Option<Obstructed>,
    /// The number of rows of its trace.
    trace_count: usize,
    /// The number of recorded keys.
    key_count: usize,
}

impl From<&driving::Drive> for DriveState {
    fn from(drive: &driving::Drive) -> Self {
        let (control, steps) = (drive.control(), drive.steps());
        Self {
            pose: drive.pose(),
            v: control.speed,
            phi: control.steering,
            steps,
            seconds: steps as f64 * drive.step(),
            blocked: Obstructed::of(drive.blocked()),
            trace_count: drive.trace().len(),
            key_count: drive.record().len(),
        }
    }
}

/// The motion of a car under one control.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct Rollout {
    /// Rows of x, y, theta: the start, the pose after each whole step, and the end.
    #[serde(with = "preserve")]
    #[tsify(type = "Float64Array")]
    poses: Float64Array,
    /// The duration that is proven free, in seconds: the requested one, unless the car is blocked.
    seconds: f64,
    /// What blocks it; null if nothing does.
    #[tsify(type = "Obstructed | null")]
    blocked: Option<Obstructed>,
}

impl From<driving::Rollout> for Rollout {
    fn from(driving::Rollout { poses, seconds, blocked }: driving::Rollout) -> Self {
        Self { poses: poses.as_flattened().into(), seconds, blocked: Obstructed::of(blocked) }
    }
}

/// The neighbours that an index has found, nearest first; ties go to the lower number.
#[derive(Serialize, Tsify)]
pub struct NeighboursFound {
    /// The numbers of the configurations, from 0 in the order in which they were added.
    #[serde(with = "preserve")]
    #[tsify(type = "Uint32Array")]
    indices: Uint32Array,
    /// Their distances in the metric; those of a forest are true distances, too.
    #[serde(with = "preserve")]
    #[tsify(type = "Float64Array")]
    distances: Float64Array,
    /// The number of configurations whose distance was computed. The shape of a kd-tree, and so this number, may differ between
    /// platforms.
    visited: usize,
}

impl From<NearestResult> for NeighboursFound {
    fn from(NearestResult { neighbours, visited }: NearestResult) -> Self {
        let indices: Vec<u32> = neighbours.iter().map(|neighbour| neighbour.vertex.0).collect();
        let distances: Vec<f64> = neighbours.iter().map(|neighbour| neighbour.distance).collect();
        Self { indices: indices.as_slice().into(), distances: distances.as_slice().into(), visited }
    }
}
