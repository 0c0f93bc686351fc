//! Samplers: the distribution of each, and the same samples for the same seed.

use crate::common::bodies::{self, p, rectangle, world};
use planarium::collision::DiscValidity;
use planarium::problem::Problem;
use planarium::random::{Random, Stream};
use planarium::robot::{DiscRobot, Part};
use planarium::sampling::{
    BridgeTest, Gaussian, GoalBiased, Known, ObstacleBased, Sampler, Uniform, halton, lattice, radical_inverse,
};
use planarium::scenario::{Obstacle, World};
use planarium::space::{ProductSpace, Space};
use wasm_bindgen_test::wasm_bindgen_test;

type Plane = ProductSpace<2>;

/// A box of side 10 with two slabs that leave a corridor of width 1 between them.
fn corridor() -> World {
    let slabs = [0.0, 5.5].map(|y| Obstacle::Polygon(rectangle([2.0, y], [8.0, y + 4.5])));
    world([0.0, 0.0], [10.0, 10.0], slabs.to_vec())
}

/// From one side of the corridor to the other, for a point.
fn problem() -> Problem<Plane> {
    let validity = DiscValidity::new(&DiscRobot::new(0.0).expect("a point"), &corridor());
    Problem::new(ProductSpace::of_box(&[0.0; 2], &[10.0; 2]), Box::new(validity), [1.0, 5.0], [9.0, 2.0])
        .expect("free ends")
}

fn samplers(seed: u64) -> Vec<(&'static str, Box<dyn Sampler<Plane>>)> {
    let random = || Random::new(seed, Stream::Samples);
    vec![
        ("uniform", Box::new(Uniform(random()))),
        ("halton", Box::new(halton(random()))),
        ("lattice", Box::new(lattice(2, random()))),
        ("gaussian", Box::new(Gaussian { random: random(), deviation: 0.5 })),
        ("bridge", Box::new(BridgeTest { random: random(), deviation: 1.0 })),
        ("obstacle-based", Box::new(ObstacleBased(random()))),
        ("goal-biased", Box::new(GoalBiased::new(random(), 0.5))),
    ]
}

/// The free samples among so many draws.
fn free_samples(sampler: &mut dyn Sampler<Plane>, problem: &Problem<Plane>, draws: usize) -> Vec<[f64; 2]> {
    let mut checks = 0;
    let mut kept = Vec::new();
    for _ in 0..draws {
        let sample = sampler.draw(problem, &mut checks);
        assert!(problem.space().contains(&sample.state) || sample.known == Known::Useless);
        let is_free = problem.validity().is_free(&sample.state);
        assert!(sample.known != Known::Free || is_free, "what is known to be free is free");
        if is_free && sample.known != Known::Useless {
            kept.push(sample.state);
        }
    }
    kept
}

/// How far the point is from the nearest slab.
fn clearance(q: &[f64; 2]) -> f64 {
    bodies::clearance(&[Part::Disc { center: p(q[0], q[1]), radius: 0.0 }], &corridor())
}

#[wasm_bindgen_test(unsupported = test)]
fn the_same_seed_gives_the_same_samples_and_another_others() {
    let problem = problem();
    for ((name, mut a), ((_, mut b), (_, mut c))) in
        samplers(1).into_iter().zip(samplers(1).into_iter().zip(samplers(2)))
    {
        let [a, b, c] = [&mut a, &mut b, &mut c].map(|sampler| free_samples(sampler.as_mut(), &problem, 300));
        assert_eq!(a, b, "{name}");
        assert_ne!(a, c, "{name}");
        assert!(!a.is_empty(), "{name} finds something");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn samplers_that_use_the_world_sample_in_their_part_of_it() {
    let problem = problem();
    let mean = |values: Vec<f64>| values.iter().sum::<f64>() / values.len() as f64;
    let mut measured = std::collections::BTreeMap::new();
    for (name, mut sampler) in samplers(7) {
        let samples = free_samples(sampler.as_mut(), &problem, 4000);
        let share =
            |is: &dyn Fn(&[f64; 2]) -> bool| samples.iter().filter(|q| is(q)).count() as f64 / samples.len() as f64;
        let in_corridor = share(&|q| (2.0..8.0).contains(&q[0]));
        let near_goal = share(&|q| (q[0] - 9.0).abs() < 1.0 && (q[1] - 2.0).abs() < 1.0);
        measured.insert(name, [mean(samples.iter().map(clearance).collect()), in_corridor, near_goal]);
    }
    let [[clearance, in_corridor, near_goal], gaussian, bridge, by_obstacles, by_goal] =
        ["uniform", "gaussian", "bridge", "obstacle-based", "goal-biased"].map(|name| measured[name]);
    assert!(gaussian[0] < 0.5 * clearance && by_obstacles[0] < 0.02, "{measured:?}");
    assert!(bridge[1] > 0.5 && in_corridor < 0.2 && by_goal[2] > 2.0 * near_goal, "{measured:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn even_sequences_leave_smaller_gaps_than_random_samples() {
    // Dispersion, roughly: the share of cells of a grid that stay empty with one sample per cell on average.
    let problem = problem();
    let empty = |sampler: &mut dyn Sampler<Plane>| {
        let mut checks = 0;
        let mut hit = [[false; 20]; 20];
        for _ in 0..400 {
            let q = sampler.draw(&problem, &mut checks).state;
            hit[(q[0] * 2.0) as usize][(q[1] * 2.0) as usize] = true;
        }
        hit.iter().flatten().filter(|hit| !**hit).count()
    };
    for seed in 0..20 {
        let counts: Vec<usize> = samplers(seed).into_iter().take(3).map(|(_, mut s)| empty(s.as_mut())).collect();
        let [uniform, halton, lattice] = counts[..] else { unreachable!() };
        assert!(uniform > 110, "about 400 / e: {uniform}");
        assert!(halton < uniform && lattice < 100, "{uniform} {halton} {lattice}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_radical_inverse_mirrors_the_digits() {
    assert_eq!(radical_inverse(2, 0b1011), 0b1101 as f64 / 16.0);
    assert_eq!(radical_inverse(3, 5), 2.0 / 3.0 + 1.0 / 9.0);
    assert_eq!(radical_inverse(19, 0), 0.0);
    assert!((1..5000).all(|n| (0.0..1.0).contains(&radical_inverse(7, n))));
}

#[wasm_bindgen_test(unsupported = test)]
fn normal_draws_have_mean_0_and_variance_1() {
    let mut random = Random::new(5, Stream::Samples);
    let draws: Vec<f64> = (0..20_000).map(|_| random.normal()).collect();
    let mean = draws.iter().sum::<f64>() / 20_000.0;
    let variance = draws.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / 20_000.0;
    assert!(mean.abs() < 0.03 && (variance - 1.0).abs() < 0.04, "{mean} {variance}");
    let beyond = draws.iter().filter(|x| x.abs() > 1.96).count();
    assert!((850..1150).contains(&beyond), "one in twenty lies beyond 1.96: {beyond}");
}
