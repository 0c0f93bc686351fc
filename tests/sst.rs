//! SST: its best path only ever gets cheaper, and of vertices near each other only the cheapest grow. Of a blossom of controls the
//! one that comes closest is kept.

use crate::common::driven::{Edge, car, distance, edges, is_in_region, vertices_of, with_goal};
use crate::common::graphs::events;
use crate::common::{assert_valid, begin_with, car_and_wall, car_shut_in, finish, parse, seeds};
use planarium::collision::{BodyCollision, BodyValidity, CarDynamics, Integration};
use planarium::graph::EventKind;
use planarium::planner::{Blocked, ByControls, GoalBias, GoalTest, PlannerKind, RrtControlOptions};
use planarium::problem::{Control, Dynamics, Motion, Problem};
use planarium::random::Random;
use planarium::robot::placements;
use planarium::run::{HISTORY_WIDTH, Phase, Status};
use planarium::scenario::Scenario;
use planarium::space::{MotionSpace, Space};
use std::sync::{Arc, Mutex};
use wasm_bindgen_test::wasm_bindgen_test;

/// A car parks between two others in a wide street: where the radii are as wide as the gap, whatever leads in is pruned.
#[wasm_bindgen_test(unsupported = test)]
fn radii_that_are_not_given_shrink_until_there_is_a_path() {
    let rectangle = |[left, bottom]: [f64; 2], [right, top]: [f64; 2]| serde_json::json!({ "type": "polygon", "vertices": [[left, bottom], [right, bottom], [right, top], [left, top]] });
    let street = serde_json::json!({
        "format": "planarium-scenario-1", "name": "street",
        "world": { "bounds": { "min": [-20, -15], "max": [30, 15] }, "obstacles": [
            rectangle([-20.0, -4.0], [30.0, -3.6]), rectangle([-20.0, 4.0], [30.0, 4.4]),
            rectangle([-6.0, -3.4], [-1.2, -1.4]), rectangle([5.3, -3.4], [10.0, -1.4])
        ] },
        "robot": { "type": "car", "shape": rectangle([-0.93, -0.97], [3.76, 0.97]), "wheelbase": 2.8, "speed": [-2.5, 2.5],
            "steering": [-0.75, 0.75] },
        "queries": [{ "name": "park", "start": [-5, 1, 0], "goal": [0.6, -2.4, 0],
            "goal_tolerance": { "translation": 0.25, "rotation": 0.1 } }]
    });
    let street = parse(&street.to_string());
    let parked = finish(begin_with(&street, "sst", 3, ""));
    assert_eq!(parked.status(), Status::Solved);
    assert_valid(&street, &*parked);
    let most = format!("max_iterations={}", parked.iterations());
    let wide = finish(begin_with(&street, "sst", 3, &format!("selection_radius=2.45 pruning_radius=1.23 {most}")));
    assert_eq!(wide.status(), Status::Exhausted);
    assert!(10 * wide.vertex_count() < parked.vertex_count(), "{} vertices", wide.vertex_count());
}

#[wasm_bindgen_test(unsupported = test)]
fn sst_improves_for_its_iterations_and_never_costs_more() {
    let world = car_and_wall(0.1);
    let mut shorter = 0;
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
        let history = run.history_since(0);
        let costs: Vec<f64> = history.chunks(HISTORY_WIDTH).map(|row| row[HISTORY_WIDTH - 1]).collect();
        assert!(costs.windows(2).all(|pair| pair[1] <= pair[0]), "cost never rises");
        assert_eq!(costs[solved_at as usize - 1].to_bits(), first.length.to_bits());
        assert_eq!(costs[costs.len() - 1].to_bits(), run.length().to_bits());
        shorter += u64::from(run.length() < first.length);
        let solutions = events(&*run, EventKind::SolutionFound);
        let falls = costs.windows(2).filter(|pair| pair[1] < pair[0]).count();
        assert_eq!(solutions.len(), falls, "one event per better path");
        assert_valid(&world, &*run);
        // A run that is finished early, or whose iterations are used up, returns the path that it has.
        let mut run = begin_with(&world, "sst", seed, "improve_iterations=1500");
        run.step(solved_at + 100);
        let so_far = run.raw_path();
        assert_eq!((run.finish(), run.path()), (Status::Solved, so_far.clone()));
        // The limit of iterations is for those without a path.
        let settings = format!("improve_iterations=150 max_iterations={}", solved_at + 100);
        let run = finish(begin_with(&world, "sst", seed, &settings));
        assert_eq!((run.status(), run.iterations()), (Status::Solved, solved_at + 150));
    }
    assert!(shorter > 0, "no path got shorter");
}

/// Witnesses in a simple manner: the position of each, and its representative.
struct Witnesses<'a> {
    world: &'a Scenario,
    radius: f64,
    places: Vec<[f64; 3]>,
    stands_for: Vec<usize>,
    /// The length of the path to every vertex.
    costs: Vec<f64>,
}

impl<'a> Witnesses<'a> {
    fn new(world: &'a Scenario, radius: f64, start: [f64; 3]) -> Self {
        Self { world, radius, places: vec![start], stands_for: vec![0], costs: vec![0.0] }
    }

    /// Adds the vertex at the end of the next edge, which must be the cheapest about its witness, or in the goal region.
    fn add(&mut self, edge: &Edge, place: [f64; 3]) {
        let cost = self.costs[edge.from] + edge.speed.abs() * edge.duration;
        self.costs.push(cost);
        let far = |&i: &usize| distance(self.places[i], place);
        let near = (0..self.places.len()).min_by(|a, b| far(a).total_cmp(&far(b))).expect("the start has one");
        if far(&near) > self.radius {
            self.places.push(place);
            self.stands_for.push(edge.to);
        } else if cost < self.costs[self.stands_for[near]] {
            self.stands_for[near] = edge.to;
        } else {
            assert!(is_in_region(self.world, place), "vertex {} is dominated", edge.to);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn of_vertices_with_one_witness_each_is_cheaper_than_those_before() {
    let world = car_and_wall(0.1);
    let (radius, mut pruned) = (0.15, 0);
    for seed in 0..seeds(4) {
        let settings = format!("improve_iterations=1500 pruning_radius={radius} selection_radius=0.3");
        let run = finish(begin_with(&world, "sst", seed, &settings));
        let (vertices, edges) = (vertices_of(&*run), edges(&*run));
        let mut witnesses = Witnesses::new(&world, radius, vertices[0]);
        let mut children = vec![0; vertices.len()];
        for edge in &edges {
            witnesses.add(edge, vertices[edge.to]);
            children[edge.from] += 1;
        }
        // What leaves is a leaf by then, leaves once, and is on no path.
        let removed = events(&*run, EventKind::VertexRemoved);
        let path: Vec<Vec<f64>> = run.path();
        for vertex in removed.iter().map(|event| event[2] as usize) {
            assert_eq!(children[vertex], 0, "vertex {vertex} is no leaf");
            children[edges[vertex - 1].from] -= 1;
            children[vertex] = -1;
            assert!(!path.contains(&vertices[vertex].to_vec()), "vertex {vertex} is on the path");
            assert!(!witnesses.stands_for.contains(&vertex), "vertex {vertex} is the cheapest about its witness");
        }
        pruned += removed.len();
    }
    assert!(pruned > 50, "{pruned}");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_cheapest_vertex_about_the_sample_grows() {
    // A goal that is met by no luck, on this side of the wall.
    let goal = [0.5, 1.2, 0.5];
    let world = with_goal(&car_and_wall(0.1), goal, true);
    let (mut by_cost, mut by_distance) = (0, 0);
    // Always towards the goal, so that the sample is known.
    let settings = "goal_bias=1 duration_steps=60 pruning_radius=0.05 selection_radius=0.6 max_iterations=1000";
    let mut run = begin_with(&world, "sst", 2, settings);
    let mut witnesses = Witnesses::new(&world, 0.05, vertices_of(&*run)[0]);
    while run.status() == Status::Running {
        let vertices = vertices_of(&*run);
        run.step(1);
        let Some(edge) = edges(&*run).get(vertices.len() - 1).copied() else { continue };
        let active = witnesses.stands_for.iter().copied();
        let (costs, far) = (&witnesses.costs, |vertex: usize| distance(vertices[vertex], goal));
        let near = active.clone().filter(|&vertex| far(vertex) <= 0.6);
        let cheapest = near.min_by(|&a, &b| costs[a].total_cmp(&costs[b]).then(a.cmp(&b)));
        let nearest = active.min_by(|&a, &b| far(a).total_cmp(&far(b)).then(a.cmp(&b))).expect("the start");
        assert_eq!(edge.from, cheapest.unwrap_or(nearest));
        by_cost += u32::from(cheapest.is_some_and(|vertex| vertex != nearest));
        by_distance += u32::from(cheapest.is_none());
        witnesses.add(&edge, vertices_of(&*run)[edge.to]);
    }
    assert!(by_cost > 0 && by_distance > 0, "{by_cost} {by_distance}");
}

/// A dynamics that records its calls.
struct Noted {
    driving: CarDynamics<4>,
    drives: Arc<Mutex<Vec<Asked>>>,
    proofs: Arc<Mutex<Vec<(Asked, u32)>>>,
}

/// The start of a call, its control and its steps.
type Asked = ([f64; 4], Control, u32);

impl Dynamics<[f64; 4]> for Noted {
    fn step(&self) -> f64 {
        self.driving.step()
    }

    fn sample(&self, random: &mut Random) -> Control {
        self.driving.sample(random)
    }

    fn extremes(&self) -> Vec<Control> {
        self.driving.extremes()
    }

    fn drive(&self, from: &[f64; 4], control: Control, steps: u32) -> [f64; 4] {
        self.drives.lock().expect("one thread").push((*from, control, steps));
        self.driving.drive(from, control, steps)
    }

    fn free_steps(&self, from: &[f64; 4], control: Control, steps: u32) -> u32 {
        let free = self.driving.free_steps(from, control, steps);
        self.proofs.lock().expect("one thread").push(((*from, control, steps), free));
        free
    }

    fn length(&self, motion: Motion) -> f64 {
        self.driving.length(motion)
    }

    fn reach(&self, motion: Motion) -> f64 {
        self.driving.reach(motion)
    }

    fn steer(&self, from: &[f64; 4], to: &[f64; 4]) -> Vec<(Motion, [f64; 4])> {
        self.driving.steer(from, to)
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn of_a_blossom_the_control_that_comes_closest_is_kept() {
    let world = car_shut_in(0.1);
    let (car, bounds) = (car(&world), world.world().bounds.expect("a box"));
    let space = MotionSpace::new(placements(car.shape(), car.weights(), &bounds));
    let [start, goal] =
        [&world.queries()[0].start, world.queries()[0].configuration().unwrap()].map(|q| space.state(q));
    let collision = Arc::new(BodyCollision::new(car.shape(), world.world(), 1e-4));
    let driving = || CarDynamics::new(car, space.clone(), Arc::clone(&collision), Integration::Exact);
    let oracle = driving();
    for blocked in [Blocked::Cut, Blocked::Refused] {
        let (drives, proofs) = (Arc::default(), Arc::default());
        let noted = Noted { driving: driving(), drives: Arc::clone(&drives), proofs: Arc::clone(&proofs) };
        let validity = BodyValidity::new(space.clone(), Arc::clone(&collision));
        let mut problem = Problem::new(space.clone(), Box::new(validity), start, goal).expect("both are free");
        problem.dynamics = Some(Box::new(noted));
        let options = RrtControlOptions {
            blossom: 8,
            duration_steps: Some(120),
            shortest_steps: Some(10),
            blocked,
            // Always towards the goal, so that the target is known.
            reaching: GoalBias { goal_bias: 1.0, goal_every: None },
            driving: ByControls { goal_test: GoalTest::Ends, ..ByControls::default() },
            ..RrtControlOptions::default()
        };
        let mut rrt = options.begin(&problem, 5).expect("the options go together");
        let (mut kept, mut spared, mut cut) = (0, 0, 0);
        for iteration in 1..=150 {
            let before = rrt.graph().states().len();
            drives.lock().expect("one thread").clear();
            proofs.lock().expect("one thread").clear();
            rrt.iterate(&problem, iteration);
            let free = |&(from, control, steps): &Asked| match oracle.free_steps(&from, control, steps) {
                0 => None,
                free if free < steps && blocked == Blocked::Refused => None,
                free => Some((space.distance(&oracle.drive(&from, control, free), &goal), control, free)),
            };
            // Where drives are cut, each is proven; else all are driven before the first is proven.
            let tried: Vec<Asked> = match blocked {
                Blocked::Cut => proofs.lock().expect("one thread").iter().map(|(asked, _)| *asked).collect(),
                Blocked::Refused => drives.lock().expect("one thread")[..8].to_vec(),
            };
            let best = tried.iter().filter_map(free).min_by(|a, b| a.0.total_cmp(&b.0));
            let found = rrt.graph().states().get(before).map(|end| {
                let motion = rrt.graph().motions()[before - 1];
                (space.distance(end, &goal), motion.control, (motion.duration / 0.01).round() as u32)
            });
            assert_eq!(found, best, "{blocked:?}");
            kept += u32::from(found.is_some());
            cut += proofs
                .lock()
                .expect("one thread")
                .iter()
                .filter(|((.., steps), free)| (1..*steps).contains(free))
                .count();
            let proofs = proofs.lock().expect("one thread").len();
            assert!(proofs == 8 || blocked == Blocked::Refused);
            spared += 8 - proofs;
        }
        assert!(kept > 20 && cut > 20, "{kept} {cut}");
        assert_eq!(spared > 300, blocked == Blocked::Refused, "only what may be kept is proven: {spared}");
    }
}
