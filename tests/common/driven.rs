//! Trees of driven motions, as viewers see them, recomputed in a simple manner.

use planarium::geometry::arc_pose;
use planarium::robot::Car;
use planarium::run::Run;
use planarium::scenario::{GoalTolerance, Robot, Scenario};
use planarium::space::{angular_distance, wrap};

/// An edge of a tree, as a viewer sees it.
#[derive(Debug, Clone, Copy)]
pub struct Edge {
    pub from: usize,
    pub to: usize,
    pub speed: f64,
    pub steering: f64,
    pub duration: f64,
}

/// The car of a world.
pub fn car(world: &Scenario) -> &Car {
    let Robot::Car(car) = world.robot() else { panic!("a car") };
    car
}

/// The vertices of a tree.
pub fn vertices_of(run: &dyn Run) -> Vec<[f64; 3]> {
    run.vertex_rows(0).as_chunks().0.to_vec()
}

/// Its edges.
pub fn edges(run: &dyn Run) -> Vec<Edge> {
    let (ends, motions) = (run.edge_rows(0), run.motion_rows(0));
    assert_eq!((ends.len() / 2, motions.len() / 4), (run.edge_count(), run.edge_count()), "one motion per edge");
    let edge = |(i, (ends, motion)): (usize, (&[u32; 2], &[f64; 4]))| {
        assert_eq!(motion[0], i as f64);
        let [from, to] = ends.map(|vertex| vertex as usize);
        Edge { from, to, speed: motion[1], steering: motion[2], duration: motion[3] }
    };
    ends.as_chunks().0.iter().zip(motions.as_chunks().0).enumerate().map(edge).collect()
}

/// The number of integration steps of an edge.
pub fn steps(car: &Car, edge: &Edge) -> u32 {
    let steps = (edge.duration / car.integration_step()).round();
    assert_eq!((steps * car.integration_step()).to_bits(), edge.duration.to_bits(), "whole steps: {edge:?}");
    steps as u32
}

/// The pose after so many steps of the edge.
pub fn driven(car: &Car, from: [f64; 3], edge: &Edge, steps: u32) -> [f64; 3] {
    let duration = f64::from(steps) * car.integration_step();
    let [x, y, theta] = arc_pose(from, edge.speed, car.turn_rate(edge.speed, edge.steering), duration);
    [x + 0.0, y + 0.0, wrap(theta)]
}

/// The distance in the metric of the worlds here.
pub fn distance([x, y, a]: [f64; 3], [u, v, b]: [f64; 3]) -> f64 {
    0.7 * ((x - u) * (x - u) + (y - v) * (y - v)).sqrt() + 0.3 * angular_distance(a, b)
}

/// Whether a placement lies within the region about the goal.
pub fn is_in_region(world: &Scenario, [x, y, theta]: [f64; 3]) -> bool {
    let query = &world.queries()[0];
    let GoalTolerance { translation, rotation } = query.goal_tolerance.expect("a region");
    let [u, v, goal] = [0, 1, 2].map(|i| query.configuration().unwrap()[i]);
    ((x - u) * (x - u) + (y - v) * (y - v)).sqrt() <= translation && wrap(theta - goal).abs() <= rotation
}

/// The world with another goal, and a goal region that is a point if `is_point`.
pub fn with_goal(world: &Scenario, goal: [f64; 3], is_point: bool) -> Scenario {
    let mut document = serde_json::json!(world);
    document["queries"][0]["goal"] = serde_json::json!(goal);
    if is_point {
        document["queries"][0]["goal_tolerance"] = serde_json::json!({ "translation": 0, "rotation": 0 });
    }
    super::parse(&document.to_string())
}
