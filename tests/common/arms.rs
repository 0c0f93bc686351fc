//! Arms and targets for the tests of inverse kinematics.

use planarium::geometry::Point;
use planarium::ik::{Solver, SolverOptions, Target, orientation};
use planarium::problem::Stepped;
use planarium::random::Random;
use planarium::robot::Arm;
use planarium::scenario::Scenario;
use planarium::space::angular_distance;

/// An arm at the origin without limits.
pub fn free(links: &[f64]) -> Arm {
    Arm::new(Point::origin(), links.to_vec(), 0.0, None).expect("an arm")
}

/// An arm at the origin with limits.
pub fn limited(links: &[f64], limits: &[[f64; 2]]) -> Arm {
    Arm::new(Point::origin(), links.to_vec(), 0.0, Some(limits.to_vec())).expect("an arm")
}

/// A target without an orientation.
pub fn at(x: f64, y: f64) -> Target {
    Target { point: Point::new(x, y), orientation: None }
}

/// The target that the configuration reaches, with its orientation if that is wanted.
pub fn target_of(arm: &Arm, q: &[f64], is_oriented: bool) -> Target {
    Target { point: arm.end_effector(q), orientation: is_oriented.then(|| orientation(arm, q)) }
}

/// A run to its end.
pub fn solve(scenario: &Scenario, options: &SolverOptions) -> Solver {
    let mut run = Solver::new(scenario, options).expect("a run");
    run.step(u64::MAX);
    run
}

/// A random arm of that many links of 0.2 to 1.2 m, with limits of 0.4 to 7 rad per joint if they are wanted.
pub fn arm(random: &mut Random, links: usize, has_limits: bool) -> Arm {
    let lengths = (0..links).map(|_| 0.2 + random.uniform()).collect();
    let mut interval = || {
        let (middle, half) = (4.0 * random.uniform() - 2.0, 0.2 + 3.3 * random.uniform() * random.uniform());
        [middle - half, middle + half]
    };
    let limits: Vec<[f64; 2]> = (0..links).map(|_| interval()).collect();
    let base = Point::new(random.uniform() - 0.5, random.uniform() - 0.5);
    Arm::new(base, lengths, 0.0, has_limits.then_some(limits)).expect("an arm")
}

/// A configuration within the limits.
pub fn configuration(random: &mut Random, arm: &Arm) -> Vec<f64> {
    let range = |i: usize| arm.joint_limits().map_or([-3.1, 3.1], |limits| limits[i]);
    let mut angle = |i: usize| range(i)[0] + (range(i)[1] - range(i)[0]) * random.uniform();
    (0..arm.links().len()).map(&mut angle).collect()
}

/// A target that a configuration within the limits reaches, with its orientation if that is wanted.
pub fn reachable(random: &mut Random, arm: &Arm, is_oriented: bool) -> Target {
    target_of(arm, &configuration(random, arm), is_oriented)
}

/// The deviation of the arm at `q` from the target: metres and radians.
pub fn deviation(arm: &Arm, q: &[f64], target: &Target) -> [f64; 2] {
    let turn = target.orientation.map_or(0.0, |wanted| angular_distance(wanted, orientation(arm, q)));
    [(arm.end_effector(q) - target.point).norm(), turn]
}

/// Whether every joint is within its limits to the bit, or in canonical form on its circle, and all entries past the last are 0.
pub fn is_within(arm: &Arm, q: &[f64]) -> bool {
    let links = arm.links().len();
    let is_fine = |i: usize| match arm.joint_limits() {
        Some(limits) => limits[i][0] <= q[i] && q[i] <= limits[i][1],
        None => -std::f64::consts::PI < q[i] && q[i] <= std::f64::consts::PI,
    };
    (0..links).all(is_fine)
        && q[links..].iter().all(|&angle| angle == 0.0)
        && q.iter().all(|angle| !(*angle == 0.0 && angle.is_sign_negative()))
}

/// A world of that arm, with these obstacles as JSON.
pub fn scenario(arm: &Arm, obstacles: &str) -> Scenario {
    let limits = arm.joint_limits().map_or(String::new(), |limits| format!(r#", "joint_limits": {limits:?}"#));
    let text = format!(
        r#"{{ "format": "planarium-scenario-1", "name": "arm", "world": {{ "obstacles": [{obstacles}] }},
            "robot": {{ "type": "arm", "base": [{:?}, {:?}], "links": {:?}, "radius": {:?}{limits} }}, "queries": [] }}"#,
        arm.base().x,
        arm.base().y,
        arm.links(),
        arm.radius()
    );
    Scenario::parse(&text).expect("a scenario")
}
