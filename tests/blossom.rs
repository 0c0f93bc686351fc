//! Of a blossom of controls the one that comes closest is kept.

use crate::common::car_shut_in;
use crate::common::driven::car;
use planarium::collision::{BodyCollision, BodyValidity, CarDynamics, Integration};
use planarium::planner::{Blocked, ByControls, GoalBias, GoalTest, PlannerKind, RrtControlOptions};
use planarium::problem::{Control, Dynamics, Motion, Problem};
use planarium::random::Random;
use planarium::robot::placements;
use planarium::space::{MotionSpace, Space};
use std::cell::RefCell;
use std::rc::Rc;
use wasm_bindgen_test::wasm_bindgen_test;

/// A dynamics that notes what it is asked.
struct Noted {
    driving: CarDynamics<4>,
    drives: Rc<RefCell<Vec<Asked>>>,
    proofs: Rc<RefCell<Vec<(Asked, u32)>>>,
}

/// From where, which control, for how many steps.
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
        self.drives.borrow_mut().push((*from, control, steps));
        self.driving.drive(from, control, steps)
    }

    fn free_steps(&self, from: &[f64; 4], control: Control, steps: u32) -> u32 {
        let free = self.driving.free_steps(from, control, steps);
        self.proofs.borrow_mut().push(((*from, control, steps), free));
        free
    }

    fn length(&self, motion: Motion) -> f64 {
        self.driving.length(motion)
    }

    fn steer(&self, from: &[f64; 4], to: &[f64; 4]) -> Vec<(Motion, [f64; 4])> {
        self.driving.steer(from, to)
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn of_a_blossom_the_one_that_comes_closest_is_kept() {
    let world = car_shut_in(0.1);
    let (car, bounds) = (car(&world), world.world().bounds.expect("a box"));
    let space = MotionSpace::new(placements(car.shape(), car.weights(), &bounds));
    let [start, goal] =
        [&world.queries()[0].start, world.queries()[0].configuration().unwrap()].map(|q| space.state(q));
    let collision = Rc::new(BodyCollision::new(car.shape(), world.world(), 1e-4));
    let driving = || CarDynamics::new(car, space.clone(), Rc::clone(&collision), Integration::Exact);
    let oracle = driving();
    for blocked in [Blocked::Cut, Blocked::Refused] {
        let (drives, proofs) = (Rc::default(), Rc::default());
        let noted = Noted { driving: driving(), drives: Rc::clone(&drives), proofs: Rc::clone(&proofs) };
        let validity = BodyValidity::new(space.clone(), Rc::clone(&collision));
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
            drives.borrow_mut().clear();
            proofs.borrow_mut().clear();
            rrt.iterate(&problem, iteration);
            let free = |&(from, control, steps): &Asked| match oracle.free_steps(&from, control, steps) {
                0 => None,
                free if free < steps && blocked == Blocked::Refused => None,
                free => Some((space.distance(&oracle.drive(&from, control, free), &goal), control, free)),
            };
            // Where drives are cut, each is proven; else all are driven before the first is proven.
            let tried: Vec<Asked> = match blocked {
                Blocked::Cut => proofs.borrow().iter().map(|(asked, _)| *asked).collect(),
                Blocked::Refused => drives.borrow()[..8].to_vec(),
            };
            let best = tried.iter().filter_map(free).min_by(|a, b| a.0.total_cmp(&b.0));
            let found = rrt.graph().states().get(before).map(|end| {
                let motion = rrt.graph().motions()[before - 1];
                (space.distance(end, &goal), motion.control, (motion.duration / 0.01).round() as u32)
            });
            assert_eq!(found, best, "{blocked:?}");
            kept += u32::from(found.is_some());
            cut += proofs.borrow().iter().filter(|((.., steps), free)| (1..*steps).contains(free)).count();
            let proofs = proofs.borrow().len();
            assert!(proofs == 8 || blocked == Blocked::Refused);
            spared += 8 - proofs;
        }
        assert!(kept > 20 && cut > 20, "{kept} {cut}");
        assert_eq!(spared > 300, blocked == Blocked::Refused, "only what may be kept is proven: {spared}");
    }
}
