//! What was read is planned in, and what is closed in the file stays closed.

use crate::files::{PARKING, SCEN, file};
use planarium::PlanningWorld;
use planarium::certificate::{Options as CertificateOptions, Subdivision, Verdict};
use planarium::path::{Verdict as Judgement, verify};
use planarium::problem::{Status, Stepped};
use planarium::run::{self, Request, Value};
use planarium::scenario::Scenario;
use planarium_formats::{Options, RobotChoice, read};

/// The iterations of a planner that looks for a way where there is none.
const TRIED: Option<u32> = Some(5_000);

/// How a planner ends with a query; a path is verified.
pub fn plan(scenario: &Scenario, planner: Option<&str>, query: &str) -> Result<Status, planarium::Error> {
    plan_within(scenario, planner, query, None)
}

/// The same with a limit of iterations.
fn plan_within(
    scenario: &Scenario,
    planner: Option<&str>,
    query: &str,
    most: Option<u32>,
) -> Result<Status, planarium::Error> {
    let parameters = most.map(|most| ("max_iterations".to_owned(), Value::Number(most.into()))).into_iter().collect();
    let (planner, query) = (planner.map(str::to_owned), Some(query.to_owned()));
    let request = Request { planner, query, seed: 1, parameters, ..Request::default() };
    let mut run = run::start(PlanningWorld::new(scenario.clone()), request.for_robot(scenario.robot())?)?;
    while run.step(1000) == Status::Running {}
    if run.status() == Status::Solved {
        let verdict = verify(scenario, &run.result())?;
        assert!(matches!(verdict, Judgement::Valid { .. }), "{verdict:?}");
    }
    Ok(run.status())
}

/// A grid in which start and goal are apart from each other.
fn query(grid: &str, robot: RobotChoice, start: [f64; 2], goal: [f64; 2]) -> Scenario {
    let options = Options { robot, start: Some(start.to_vec()), goal: Some(goal.to_vec()), ..Options::default() };
    read(&[file("a.txt", grid)], &options).expect("a grid").scenario
}

#[test]
fn what_touches_at_a_corner_is_closed() {
    // Two walls that meet in one corner, in the middle.
    let grid = "000100\n000100\n000100\n001000\n001000\n001000\n";
    for radius in [0.0, 1e-9, 0.2] {
        let scenario = query(grid, RobotChoice::Disc { radius }, [1.0, 4.5], [5.0, 1.5]);
        for planner in ["rrt-connect", "prm"] {
            assert_eq!(
                plan_within(&scenario, Some(planner), "given", TRIED).expect("a run"),
                Status::Exhausted,
                "{planner} {radius}"
            );
        }
        let options = CertificateOptions { query: None, clearance: 0.0, cells: 200_000 };
        let mut subdivision = Subdivision::new(&scenario, &options).expect("a disc");
        subdivision.step(u64::MAX);
        assert_eq!(subdivision.certificate().verdict, Verdict::Infeasible, "{radius}");
    }
    // The straight line through the corner is refused as well: the closed squares share the point.
    let through = query(grid, RobotChoice::Disc { radius: 0.0 }, [2.5, 3.5], [3.5, 2.5]);
    assert_eq!(plan_within(&through, Some("rrt-connect"), "given", TRIED).expect("a run"), Status::Exhausted);
    // With a cell less there is a way.
    let open = query(&grid.replacen("001000", "000000", 1), RobotChoice::Disc { radius: 0.2 }, [1.0, 4.5], [5.0, 1.5]);
    assert_eq!(plan(&open, Some("rrt-connect"), "given").expect("a run"), Status::Solved);
}

#[test]
fn a_turned_wall_of_many_rectangles_has_no_gap() {
    // A staircase of cells that touch in corners and sides, turned by an angle that no coordinate represents exactly.
    let pixels: Vec<u8> = (0..256).map(|i| if i / 16 == i % 16 || i / 16 == i % 16 + 1 { 0 } else { 255 }).collect();
    let picture = [b"P5 16 16 255\n", &pixels[..]].concat();
    for yaw in [0.0, 0.3, 1.0, 2.5] {
        let yaml = format!(
            "image: a.pgm\nresolution: 0.05\norigin: [3.1, -7.7, {yaw}]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n"
        );
        let files = [file("a.yaml", &yaml), file("a.pgm", &picture)];
        let place = |x: f64, y: f64| {
            let world = read(&files, &Options::default()).expect("a map");
            let p = world.grid.expect("cells").corner(x, y);
            vec![p.x, p.y]
        };
        let options = Options { start: Some(place(12.0, 3.0)), goal: Some(place(3.0, 12.0)), ..Options::default() };
        let world = read(&files, &options).expect("a map");
        assert!(!world.report.queries[0].blocked);
        for planner in ["rrt-connect", "prm"] {
            assert_eq!(
                plan_within(&world.scenario, Some(planner), "given", TRIED).expect("a run"),
                Status::Exhausted,
                "{yaw} {planner}"
            );
        }
    }
}

#[test]
fn every_robot_drives_through_a_grid() {
    let grid = "00000000\n00000000\n00001000\n00001000\n00001000\n";
    for robot in [
        RobotChoice::Format,
        RobotChoice::Disc { radius: 0.4 },
        RobotChoice::rectangle(0.9, 0.6),
        RobotChoice::Footprint { corners: vec![[0.4, 0.0], [-0.3, 0.3], [-0.3, -0.3]] },
        RobotChoice::Car { length: 0.8, width: 0.4, wheelbase: 0.5, steering: 0.9 },
    ] {
        let scenario = query(grid, robot.clone(), [1.5, 1.5], [6.5, 1.5]);
        assert_eq!(plan(&scenario, None, "given").expect("a run"), Status::Solved, "{robot:?}");
    }
}

#[test]
fn queries_of_the_files_are_planned_for() {
    let map = "type octile\nheight 4\nwidth 5\nmap\n.....\n.@@..\n...@.\n.....\n";
    let options = Options { robot: RobotChoice::Disc { radius: 0.3 }, ..Options::default() };
    let world = read(&[file("small.map", map), file("small.scen", SCEN)], &options).expect("a map");
    for query in world.scenario.queries() {
        assert_eq!(plan(&world.scenario, None, &query.name).expect("a run"), Status::Solved, "{}", query.name);
    }
    let world = read(&[file("Case1.csv", PARKING)], &Options::default()).expect("a case");
    let _ = plan(&world.scenario, Some("rrt-connect"), "park").expect("a run");
}
