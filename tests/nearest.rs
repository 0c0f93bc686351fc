//! Nearest neighbours: every exact index gives the answers of a plain scan, to the bit, ties by number; on native, Node and
//! Chrome alike.

use crate::common::cases;
use planarium::graph::VertexId;
use planarium::nearest::{Direction, Forest, ForestParameters, Index, KdTree, LinearScan, Nearest, Neighbour, recall};
use planarium::random::{Random, Stream};
use planarium::space::steering::Steering;
use planarium::space::{Coordinate, Metric, MotionSpace, ProductSpace, Space, gap, gap_to_interval};
use std::f64::consts::{PI, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

/// What the definition says: the distances to all states, sorted, ties by number.
fn truth<S: Space>(space: &S, states: &[S::State], from: &S::State) -> Vec<Neighbour> {
    let mut all: Vec<Neighbour> = (0..)
        .zip(states)
        .map(|(i, state)| Neighbour { distance: space.distance(from, state), vertex: VertexId(i) })
        .collect();
    all.sort_by(|a, b| a.distance.total_cmp(&b.distance).then(a.vertex.cmp(&b.vertex)));
    all
}

fn same(found: &[Neighbour], expected: &[Neighbour], what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}: how many");
    for (place, (a, b)) in found.iter().zip(expected).enumerate() {
        assert_eq!(
            (a.distance.to_bits(), a.vertex),
            (b.distance.to_bits(), b.vertex),
            "{what}: place {place}, {a:?} for {b:?}"
        );
    }
}

/// Asks an index all questions, of which the sorted distances to all states hold the answers.
fn answers<S: Space>(name: &str, index: &impl Nearest<S>, space: &S, from: &S::State, truth: &[Neighbour]) {
    let n = truth.len();
    let mut found = Vec::new();
    assert_eq!((index.len(), index.is_empty()), (n, false), "{name}");
    assert_eq!(index.nearest(space, from), Some(truth[0]), "{name}");
    for k in [0, 1, 2, 10, 30, 100, n, n + 1] {
        index.k_nearest(space, from, k, &mut found);
        same(&found, &truth[..k.min(n)], &format!("{name}: {k} of {n}"));
    }
    // Radii that are distances themselves: those who lie on the rim belong to it.
    for radius in [-1.0, 0.0, truth[n / 50].distance, truth[n / 3].distance, f64::INFINITY] {
        let inside = truth.partition_point(|neighbour| neighbour.distance <= radius);
        index.within(space, from, radius, &mut found);
        same(&found, &truth[..inside], &format!("{name}: within {radius} of {n}"));
    }
}

/// Grows every exact index by the same states and, on the way and at the end, asks each the same questions.
fn agrees<S: Space>(name: &str, space: &S, states: &[S::State], asked: &[S::State]) {
    let (mut linear, mut tree, mut index) = (LinearScan::default(), KdTree::default(), Index::default());
    for (i, &state) in states.iter().enumerate() {
        let vertex = VertexId(i as u32);
        linear.insert(space, vertex, state);
        tree.insert(space, vertex, state);
        index.insert(space, vertex, state);
        let n = i + 1;
        let is_last = n == states.len();
        if !is_last && !n.is_power_of_two() {
            continue;
        }
        let few = if is_last { asked.len() } else { 2 };
        for from in &asked[..few.min(asked.len())] {
            let expected = truth(space, &states[..n], from);
            answers(&format!("scan, {name}"), &linear, space, from, &expected);
            answers(&format!("kd-tree, {name}"), &tree, space, from, &expected);
            answers(&format!("index, {name}"), &index, space, from, &expected);
        }
    }
}

fn spaces() -> Vec<(&'static str, ProductSpace<4>)> {
    let interval = |low, high| Coordinate::Interval { low, high };
    let mut spaces = Vec::new();
    for metric in [Metric::Sum, Metric::Euclidean] {
        spaces.push(("circle", ProductSpace::new(&[Coordinate::Circle; 1], metric)));
        spaces.push(("2-torus", ProductSpace::new(&[Coordinate::Circle; 2], metric)));
        spaces.push(("3-torus", ProductSpace::new(&[Coordinate::Circle; 3], metric)));
        spaces.push(("4-torus", ProductSpace::new(&[Coordinate::Circle; 4], metric)));
        spaces.push(("limits", ProductSpace::new(&[interval(-4.0, 7.5), interval(-1.0, 1.0)], metric)));
        let mixed = [Coordinate::Circle, interval(-9.0, 0.5), Coordinate::Circle];
        spaces.push(("circles and limits", ProductSpace::new(&mixed, metric)));
        spaces.push(("circles cut open", ProductSpace::new(&mixed, metric).cut_open()));
    }
    spaces.push(("placements", ProductSpace::of_placements([0.0, -1.0], [2.0, 3.0], 0.7, 0.3)));
    spaces.push(("placements, turns above all", ProductSpace::of_placements([0.0, 0.0], [1.0, 1.0], 0.01, 5.0)));
    spaces
}

fn samples<S: Space>(space: &S, seed: u64, n: usize) -> Vec<S::State> {
    let mut random = Random::new(seed, Stream::Samples);
    (0..n).map(|_| space.sample(&mut random)).collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn random_states_have_the_neighbours_of_the_definition() {
    for (name, space) in spaces() {
        for (seed, n) in [(1, 1), (2, 33), (3, 300), (4, 2000)] {
            agrees(name, &space, &samples(&space, seed, n), &samples(&space, seed + 100, cases(40)));
        }
    }
    let plane = ProductSpace::<2>::of_box(&[0.0, -1.0], &[3.0, 5.0]);
    agrees("plane", &plane, &samples(&plane, 5, 2000), &samples(&plane, 105, cases(40)));
    let slab = ProductSpace::<3>::of_box(&[0.0, 0.0, -1e6], &[1.0, 1e-3, 1e6]);
    agrees("slab", &slab, &samples(&slab, 6, 2000), &samples(&slab, 106, cases(40)));
}

#[wasm_bindgen_test(unsupported = test)]
fn ties_go_to_the_lower_number_on_grids_where_nearly_all_are_ties() {
    for (name, space) in spaces() {
        let d = space.dimension();
        let side = [1, 200, 20, 8, 5][d];
        let n = (side as usize).pow(d as u32);
        // An odd stride goes through the whole grid in a scattered order.
        let states: Vec<_> = (0..n)
            .map(|i| {
                let at = i * 7919 % n;
                let place = |axis| (at / (side as usize).pow(axis as u32) % side as usize) as f64;
                let on = |axis: usize| match space.is_circle(axis) {
                    true => PI - place(axis) * TAU / side as f64,
                    false => space.range(axis)[0] + place(axis) * 0.125,
                };
                space.state(&(0..d).map(on).collect::<Vec<_>>())
            })
            .collect();
        let mut asked: Vec<_> = states.iter().step_by(n.div_ceil(cases(20))).copied().collect();
        asked.extend(samples(&space, 7, cases(10)));
        agrees(&format!("grid on {name}"), &space, &states, &asked);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn states_that_are_equal_close_or_at_the_seam_are_told_apart_as_the_definition_does() {
    for (name, space) in spaces() {
        let d = space.dimension();
        let asked = samples(&space, 8, cases(20));
        agrees(&format!("one state on {name}"), &space, &vec![asked[0]; 500], &asked);
        let few = samples(&space, 9, 5);
        let many: Vec<_> = (0..700).map(|i| few[i * i % 5]).collect();
        agrees(&format!("five states on {name}"), &space, &many, &asked);
        // On either side of the seam, and on it; at the limits; a few steps of rounding apart.
        let mut random = Random::new(10, Stream::Samples);
        let seam: Vec<_> = (0..700)
            .map(|_| {
                let number = |axis: usize| {
                    let [low, high] = space.range(axis);
                    let steps = f64::EPSILON * random.below(4) as f64;
                    match random.below(5) {
                        0 => high,
                        1 => high - high.abs() * steps,
                        2 => low + low.abs() * (steps + f64::EPSILON),
                        3 => 0.0 + steps,
                        _ => low + (high - low) * random.uniform(),
                    }
                };
                space.state(&(0..d).map(number).collect::<Vec<_>>())
            })
            .collect();
        let asked: Vec<_> = seam.iter().step_by(20).copied().take(cases(35)).collect();
        agrees(&format!("seam of {name}"), &space, &seam, &asked);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_order_of_insertion_changes_nothing() {
    for (name, space) in spaces() {
        let mut states = samples(&space, 11, 1500);
        let asked = samples(&space, 12, cases(15));
        states.sort_by(|a, b| a[0].total_cmp(&b[0]));
        agrees(&format!("increasing on {name}"), &space, &states, &asked);
        states.reverse();
        agrees(&format!("decreasing on {name}"), &space, &states, &asked);
        // A spiral that closes in: every new state lies in the smallest box.
        let spiral: Vec<_> = (0..1500)
            .map(|i| {
                space.state(&[0, 1, 2, 3].map(|axis| 0.4 * 0.98f64.powf(f64::from(i)) * f64::from(1 - (i + axis) % 3)))
            })
            .collect();
        agrees(&format!("spiral on {name}"), &space, &spiral, &asked);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn questions_between_insertions_see_what_was_inserted() {
    for (name, space) in spaces() {
        let (mut linear, mut tree) = (LinearScan::default(), KdTree::default());
        let (mut one, mut other) = (Vec::new(), Vec::new());
        let asked = samples(&space, 14, cases(2000));
        for (i, (&state, from)) in samples(&space, 13, asked.len()).iter().zip(&asked).enumerate() {
            // Numbers increase, but not by one.
            let vertex = VertexId(3 * i as u32 + 1);
            linear.insert(&space, vertex, state);
            tree.insert(&space, vertex, state);
            assert_eq!(linear.nearest(&space, from), tree.nearest(&space, from), "{name} after {i}");
            for k in [1, 2, 10, 30] {
                linear.k_nearest(&space, from, k, &mut one);
                tree.k_nearest(&space, from, k, &mut other);
                same(&other, &one, &format!("{name} after {i}, {k} neighbours"));
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn an_empty_index_and_no_neighbours_are_no_trouble() {
    fn empty(index: &impl Nearest<ProductSpace<4>>, space: &ProductSpace<4>) {
        let from = space.state(&[1.0; 4]);
        let mut found = vec![Neighbour { distance: 1.0, vertex: VertexId(1) }];
        assert!(index.is_empty());
        assert_eq!(index.nearest(space, &from), None);
        index.k_nearest(space, &from, 3, &mut found);
        assert!(found.is_empty(), "what the list held before is gone");
        index.k_nearest(space, &from, 0, &mut found);
        index.within(space, &from, 10.0, &mut found);
        assert!(found.is_empty());
    }
    for (_, space) in spaces() {
        empty(&LinearScan::default(), &space);
        empty(&KdTree::default(), &space);
        empty(&Index::default(), &space);
        empty(&Forest::new(ForestParameters::default(), 1), &space);
    }
}

/// A forest of the states, and the average part of the nearest `k` that it finds.
fn forest_recall<S: Space>(space: &S, seed: u64, n: usize, k: usize, parameters: ForestParameters) -> f64 {
    let mut forest = Forest::new(parameters, Random::new(seed, Stream::Projections).bits());
    let states = samples(space, seed, n);
    (0..).zip(&states).for_each(|(i, &state)| forest.insert(space, VertexId(i), state));
    assert_eq!(forest.len(), n);
    let asked = samples(space, seed + 1, cases(40));
    let parts = asked.iter().map(|from| {
        let exact = truth(space, &states, from);
        let mut found = Vec::new();
        forest.k_nearest(space, from, k, &mut found);
        assert_eq!(found.len(), k.min(n), "as many as asked for, if not all the nearest");
        for (i, neighbour) in found.iter().enumerate() {
            let distance = space.distance(from, &states[neighbour.vertex.index()]);
            assert_eq!(neighbour.distance.to_bits(), distance.to_bits(), "its distance is true");
            assert!(i == 0 || found[i - 1].is_before(neighbour), "nearest first, none twice");
        }
        assert_eq!(forest.nearest(space, from).is_some(), n > 0);
        let radius = found[k / 2].distance;
        let (first, mut inside) = (found[..=k / 2].to_vec(), Vec::new());
        forest.within(space, from, radius, &mut inside);
        same(&inside, &first, "within a radius are those of the k nearest that are");
        recall(&found, &exact[..k.min(n)])
    });
    parts.sum::<f64>() / asked.len() as f64
}

#[wasm_bindgen_test(unsupported = test)]
fn the_approximate_index_finds_most_of_the_nearest_and_more_if_it_looks_at_more() {
    let n = cases(10_000);
    let six = ProductSpace::<8>::new(&[Coordinate::Circle; 6], Metric::Sum);
    let of = |candidates| ForestParameters { candidates, ..ForestParameters::default() };
    let [few, default, all] = [100, 400, n].map(|candidates| forest_recall(&six, 21, n, 10, of(candidates)));
    assert!(few < default, "{few} with 100 candidates, {default} with 400");
    assert!(default >= 0.8, "{default} of the ten nearest");
    assert_eq!(all, 1.0, "all candidates are all states");
    let mixed = [Coordinate::Circle, Coordinate::Interval { low: -9.0, high: 0.5 }, Coordinate::Circle];
    let three = ProductSpace::<4>::new(&mixed, Metric::Euclidean);
    let found = forest_recall(&three, 23, n, 10, of(400));
    assert!(found >= 0.98, "{found} of the ten nearest in three dimensions");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_forest_stays_flat_whatever_order_states_come_in() {
    let space = MotionSpace::new(ProductSpace::<4>::of_box(&[0.0, 0.0], &[1.0, 1.0]));
    let n = cases(20_000);
    let parameters = ForestParameters { trees: 2, leaf: 8, candidates: n };
    let line = |i: usize| [i as f64 / n as f64, 0.5];
    type Place<'a> = &'a dyn Fn(usize) -> [f64; 2];
    let orders: [(&str, Place); 4] = [
        ("on a line", &line),
        ("on a line, backwards", &|i| line(n - 1 - i)),
        ("a lattice, row by row", &|i| [(i / 128) as f64 / 160.0, (i % 128) as f64 / 128.0]),
        ("the same, but for a few", &|i| if i % 97 == 0 { line(i) } else { [0.25, 0.25] }),
    ];
    for (what, place) in orders {
        let mut forest = Forest::new(parameters, 3);
        let states: Vec<_> = (0..n).map(|i| space.state(&place(i))).collect();
        (0..).zip(&states).for_each(|(i, &state)| forest.insert(&space, VertexId(i), state));
        // Twice as deep as it has to be, and a few.
        let most = 18.0 + 2.0 * libm::log2(n as f64 / 8.0);
        assert!(forest.depth() as f64 <= most, "{what}: {} of {most}", forest.depth());
        // All of them are still there.
        let (from, mut found) = (space.state(&[0.3, 0.4]), Vec::new());
        assert_eq!(forest.k_nearest(&space, &from, n, &mut found), n, "{what}");
        same(&found, &truth(&space, &states, &from), what);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_forest_of_equal_states_grows_and_the_same_key_grows_the_same_forest() {
    let space = ProductSpace::<4>::new(&[Coordinate::Circle; 4], Metric::Sum);
    let parameters = ForestParameters { trees: 3, leaf: 2, candidates: 50 };
    let mut equal = Forest::new(parameters, 5);
    let state = space.state(&[1.0, 2.0, 3.0, -3.0]);
    (0..200).for_each(|i| equal.insert(&space, VertexId(i), state));
    let mut found = Vec::new();
    equal.k_nearest(&space, &state, 70, &mut found);
    assert!(found.len() == 70 && found.iter().all(|neighbour| neighbour.distance == 0.0));

    let states = samples(&space, 24, 2000);
    let found_by = |key| {
        let mut forest = Forest::new(parameters, key);
        (0..).zip(&states).for_each(|(i, &state)| forest.insert(&space, VertexId(i), state));
        let mut all = Vec::new();
        for from in samples(&space, 25, 20) {
            let mut found = Vec::new();
            forest.k_nearest(&space, &from, 30, &mut found);
            all.extend(found);
        }
        all
    };
    same(&found_by(7), &found_by(7), "one key");
    assert_ne!(found_by(7), found_by(8), "another key draws other planes");
}

#[wasm_bindgen_test(unsupported = test)]
fn recall_is_the_part_of_the_exact_answer_that_was_found() {
    let all = [1, 2, 3, 4].map(|i| Neighbour { distance: f64::from(i), vertex: VertexId(i) });
    assert_eq!(recall(&all[1..], &all), 0.75);
    assert_eq!(recall(&all, &all[..2]), 1.0);
    assert_eq!(recall(&[], &all), 0.0);
    assert_eq!(recall(&all, &[]), 1.0);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_metric_of_the_gaps_is_the_distance_to_the_bit() {
    fn holds<S: Space>(space: &S) {
        let states = samples(space, 17, cases(4000));
        for (a, b) in states.iter().zip(&states[1..]) {
            let (x, y) = (space.coordinates(a), space.coordinates(b));
            let [distance] = space.norm(|i| [gap(x[i], y[i], space.period(i))]);
            assert_eq!(distance.to_bits(), space.distance(a, b).to_bits(), "{a:?} {b:?}");
        }
    }
    spaces().iter().for_each(|(_, space)| holds(space));
    holds(&ProductSpace::<2>::of_box(&[0.0, -1.0], &[3.0, 5.0]));
}

#[wasm_bindgen_test(unsupported = test)]
fn no_gap_is_less_than_the_gap_to_an_interval_around_it() {
    let mut random = Random::new(18, Stream::Samples);
    // Numbers of the circle, many of them at the seam, at quarters, or a step of rounding away from another.
    let mut number = || {
        let quarter = PI * 0.5 * (random.below(4) as f64 - 1.0);
        match random.below(3) {
            0 => quarter,
            1 if quarter < PI => quarter + f64::EPSILON * random.below(3) as f64,
            _ => PI - TAU * random.uniform(),
        }
    };
    for _ in 0..cases(200_000) {
        let (a, mut in_order) = (number(), [number(), number(), number()]);
        in_order.sort_by(f64::total_cmp);
        let [low, x, high] = in_order;
        for period in [TAU, f64::INFINITY] {
            let bound = gap_to_interval(a, low, high, period);
            assert!(bound <= gap(a, x, period), "{a} from [{low}, {high}] and {x}");
            let is_inside = low <= a && a <= high;
            assert_eq!(bound == 0.0, is_inside || gap(a, low, period) * gap(a, high, period) == 0.0);
        }
    }
}

/// The definition for steered motions: the distances in one direction to or from all states, sorted, ties by number.
fn steered_truth(space: &MotionSpace<4>, direction: Direction, states: &[[f64; 4]], from: &[f64; 4]) -> Vec<Neighbour> {
    let number = |i: usize| VertexId(3 * i as u32 + 1);
    let all = states.iter().enumerate();
    let distance = |state: &[f64; 4]| match direction {
        Direction::In => space.distance(state, from),
        Direction::Out => space.distance(from, state),
    };
    let mut all: Vec<Neighbour> =
        all.map(|(i, state)| Neighbour { distance: distance(state), vertex: number(i) }).collect();
    all.sort_by(|a, b| a.distance.total_cmp(&b.distance).then(a.vertex.cmp(&b.vertex)));
    all
}

#[wasm_bindgen_test(unsupported = test)]
fn steered_motions_have_the_neighbours_of_a_plain_scan_in_either_direction() {
    for (steering, radius) in [(Steering::Dubins, 0.5), (Steering::ReedsShepp, 0.5), (Steering::ReedsShepp, 4.0)] {
        let space = MotionSpace::steered(
            ProductSpace::<4>::of_placements([0.0, 0.0], [10.0, 10.0], 0.7, 0.3),
            steering,
            radius,
        );
        let few = samples(&space, 20, 4);
        let lattice: Vec<_> = (0..512)
            .map(|i| space.state(&[f64::from(i % 8), f64::from(i / 8 % 8), f64::from(i / 64) * TAU / 8.0]))
            .collect();
        // At random, on a lattice where most are ties, many times the same, and hardly any.
        let sets = [samples(&space, 21, 1500), lattice, (0..300).map(|i| few[i * i % 4]).collect(), few.clone()];
        for states in &sets {
            let mut index = Index::default();
            for (i, &state) in states.iter().enumerate() {
                index.insert(&space, VertexId(3 * i as u32 + 1), state);
            }
            let mut asked = samples(&space, 22, cases(20));
            asked.extend(states.iter().step_by(states.len().div_ceil(4)));
            for (from, direction) in asked.iter().flat_map(|from| [(from, Direction::In), (from, Direction::Out)]) {
                let truth = steered_truth(&space, direction, states, from);
                let n = truth.len();
                let mut found = Vec::new();
                assert_eq!((index.len(), index.nearest_by(&space, direction, from)), (n, Some(truth[0])));
                for k in [0, 1, 2, 10, 100, n, n + 1, usize::MAX] {
                    index.k_nearest_by(&space, direction, from, k, &mut found);
                    same(&found, &truth[..k.min(n)], &format!("{steering:?} {direction:?}: {k} of {n}"));
                }
                for reach in [-1.0, 0.0, truth[n / 50].distance, truth[n / 3].distance, f64::INFINITY] {
                    index.within_by(&space, direction, from, reach, &mut found);
                    let inside = truth.partition_point(|neighbour| neighbour.distance <= reach);
                    same(&found, &truth[..inside], &format!("{steering:?} {direction:?}: within {reach} of {n}"));
                }
                if direction == Direction::In {
                    assert_eq!(
                        index.nearest(&space, from),
                        Some(truth[0]),
                        "plain queries are about motions to the state"
                    );
                    index.k_nearest(&space, from, 5, &mut found);
                    same(&found, &truth[..5.min(n)], "plainly");
                }
            }
        }
        assert_eq!(Index::default().nearest_by(&space, Direction::Out, &few[0]), None);
    }
}
