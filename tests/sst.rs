//! SST: its best path only ever gets cheaper, and of vertices near each other only the cheapest grow.

mod common;
#[path = "common/driven.rs"]
mod driven;

use common::{begin_with, car_and_wall, finish, seeds};
use driven::{car, edges, events, is_in_region, vertices_of};
use planarium::graph::EventKind;
use planarium::path::{Verdict, verify};
use planarium::run::{HISTORY_WIDTH, Phase, Status};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn sst_improves_for_as_long_as_it_is_told_and_never_costs_more() {
    let world = car_and_wall(0.1);
    for seed in 0..seeds(5) {
        let first = finish(begin_with(&world, "sst", seed, "")).result();
        let mut run = begin_with(&world, "sst", seed, "improve_iterations=1500");
        run.record().expect("nothing is done yet");
        let mut solved_at = 0;
        while run.status() == Status::Running {
            if run.phase() == Phase::Improving && solved_at == 0 {
                solved_at = run.iterations();
                assert_eq!(run.raw_path(), first.path, "the first path is that of a run that stops there");
                assert!(run.path().is_empty(), "it is not over");
            }
            run.step(1);
        }
        assert_eq!((run.status(), run.iterations()), (Status::Solved, solved_at + 1500));
        let history = run.take_history();
        let costs: Vec<f64> = history.chunks(HISTORY_WIDTH).map(|row| row[HISTORY_WIDTH - 1]).collect();
        assert!(costs.windows(2).all(|pair| pair[1] <= pair[0]), "cost never rises");
        assert_eq!(costs[solved_at as usize - 1].to_bits(), first.length.to_bits());
        assert_eq!(costs[costs.len() - 1].to_bits(), run.length().to_bits());
        assert!(run.length() < first.length, "seed {seed}: {} {}", run.length(), first.length);
        let solutions = events(&*run, EventKind::SolutionFound);
        let falls = costs.windows(2).filter(|pair| pair[1] < pair[0]).count();
        assert_eq!(solutions.len(), falls, "one event a better path");
        assert!(matches!(verify(&world, &run.result()), Ok(Verdict::Valid { .. })));
        // A run that is told to finish takes what it has; one whose iterations are over, too.
        let mut run = begin_with(&world, "sst", seed, "improve_iterations=1500");
        run.step(solved_at + 100);
        let so_far = run.raw_path();
        assert_eq!((run.finish(), run.path()), (Status::Solved, so_far.clone()));
        let settings = format!("improve_iterations=1500 max_iterations={}", solved_at + 100);
        let run = finish(begin_with(&world, "sst", seed, &settings));
        assert_eq!((run.status(), run.path()), (Status::Solved, so_far));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn of_vertices_with_one_witness_each_is_cheaper_than_those_before() {
    let world = car_and_wall(0.1);
    let car = car(&world);
    let (radius, mut pruned) = (0.15, 0);
    for seed in 0..seeds(4) {
        let settings = format!("improve_iterations=1500 pruning_radius={radius} selection_radius=0.3");
        let run = finish(begin_with(&world, "sst", seed, &settings));
        let (vertices, edges) = (vertices_of(&*run), edges(&*run));
        let distance = |[x, y, a]: [f64; 3], [u, v, b]: [f64; 3]| {
            0.7 * ((x - u) * (x - u) + (y - v) * (y - v)).sqrt() + 0.3 * planarium::space::angular_distance(a, b)
        };
        // Witnesses, with what the cheapest way to a place near each costs.
        let mut witnesses = vec![(vertices[0], 0.0)];
        let mut costs = vec![0.0];
        let mut children = vec![0; vertices.len()];
        for edge in &edges {
            let pace = 0.7 * edge.speed.abs() + 0.3 * car.turn_rate(edge.speed, edge.steering).abs();
            costs.push(costs[edge.from] + pace * edge.duration);
            children[edge.from] += 1;
            let (place, cost) = (vertices[edge.to], costs[edge.to]);
            let near = (0..witnesses.len())
                .min_by(|&a, &b| distance(witnesses[a].0, place).total_cmp(&distance(witnesses[b].0, place)))
                .expect("the start has one");
            if distance(witnesses[near].0, place) > radius {
                witnesses.push((place, cost));
            } else if !is_in_region(&world, place) {
                assert!(cost < witnesses[near].1, "vertex {} is dominated", edge.to);
                witnesses[near].1 = cost;
            } else {
                witnesses[near].1 = cost.min(witnesses[near].1);
            }
        }
        // What leaves is a leaf by then, leaves once, and is on no path.
        let removed = events(&*run, EventKind::VertexRemoved);
        let way: Vec<Vec<f64>> = run.path();
        for &(_, vertex) in &removed {
            assert_eq!(children[vertex], 0, "vertex {vertex} is no leaf");
            children[edges[vertex - 1].from] -= 1;
            children[vertex] = -1;
            assert!(!way.contains(&vertices[vertex].to_vec()), "vertex {vertex} is on the path");
        }
        pruned += removed.len();
    }
    assert!(pruned > 50, "{pruned}");
}
