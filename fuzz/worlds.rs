//! The readers of maps, pictures and benchmark files, given any bytes.

use planarium::geometry::{Point, Polygon};
use planarium::robot::{Arm, DiscRobot, RigidBody, Weights};
use planarium::scenario::{Robot, Scenario, polygon};
use planarium_formats::{Angles, File, MapFrame, Options, PathOptions, RobotChoice, Unknown, is_path, read, read_path};

const YAML: &[u8] = b"image: map\nresolution: 0.05\norigin: [-1.5, 2.0, 0.3]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\nmode: scale\n";
const PGM: &[u8] = b"P5\n4 3\n255\n\x00\xff\xff\xcd\xff\xff\xff\x00\xff\x00\xff\xff";
const MAP: &[u8] = b"type octile\nheight 2\nwidth 3\nmap\n..@\n...\n";
const CIRCLES: &[u8] = b"units: meter\n\tx\ty\tr\n1\t2\t3\t1\n";

/// A file alone: any format.
pub fn alone(bytes: &[u8]) {
    check(&[File { name: "world", bytes }]);
}

/// The picture of a map.
pub fn picture(bytes: &[u8]) {
    check(&[File { name: "map.yaml", bytes: YAML }, File { name: "map", bytes }]);
}

/// The metadata of a map.
pub fn metadata(bytes: &[u8]) {
    check(&[File { name: "map.yaml", bytes }, File { name: "map", bytes: PGM }]);
}

/// Scenarios of a map.
pub fn scenarios(bytes: &[u8]) {
    check(&[File { name: "small.map", bytes: MAP }, File { name: "small.scen", bytes }]);
}

/// Queries between circles.
pub fn queries(bytes: &[u8]) {
    check(&[File { name: "circles", bytes: CIRCLES }, File { name: "queries", bytes }]);
}

/// A drawing: areas, lines and points.
pub fn drawing(bytes: &[u8]) {
    let files = [File { name: "drawing", bytes }];
    let walkable = Options {
        walkable: Some(true),
        wall_thickness: Some(0.25),
        robot: RobotChoice::Disc { radius: 0.5 },
        start: Some(vec![0.5, 0.5]),
        goal: Some(vec![1.5, 0.5]),
        ..Options::default()
    };
    let coarse = Options { walkable: Some(false), scale: Some(0.5), tolerance: Some(0.1), ..Options::default() };
    // Of DXF only; others refuse it.
    let filled = Options { fill: vec!["*".to_owned()], ..coarse.clone() };
    for options in [Options::default(), walkable, coarse, filled] {
        check_with(&files, &options);
    }
}

/// Reads with several options. What is read is a scenario whose numbers agree with the report; what is refused says
/// why.
fn check(files: &[File<'_>]) {
    let turning = Options {
        robot: RobotChoice::rectangle(0.5, 0.25),
        unknown: Unknown::Free,
        min_island: 2,
        simplify: 2.0,
        threshold: Some(0.25),
        scale: Some(0.5),
        start: Some(vec![0.5, 0.5, 1.0]),
        goal: Some(vec![1.5, 0.5]),
        ..Options::default()
    };
    for options in [Options::default(), turning] {
        check_with(files, &options);
    }
}

fn check_with(files: &[File<'_>], options: &Options) {
    let world = match read(files, options) {
        Ok(world) => world,
        Err(error) => {
            assert!(!error.message().is_empty());
            return;
        }
    };
    let report = &world.report;
    let again = Scenario::parse(&world.scenario.to_json_string()).expect("a scenario is read back");
    assert_eq!(again, world.scenario);
    let obstacles = world.scenario.world().obstacles.len();
    let planarium_formats::Obstacles { polygons, walls, discs, .. } = report.obstacles;
    assert_eq!(polygons + walls + discs, obstacles);
    assert_eq!(report.queries.len(), world.scenario.queries().len());
    if let (Some(read), Some(grid)) = (&report.grid, &world.grid) {
        assert_eq!(read.free + read.occupied + read.unknown, grid.width() * grid.height());
        assert_eq!(grid.cells().len(), grid.width() * grid.height());
        assert!(read.rectangles <= read.merged_cells && read.rectangles <= obstacles + 1);
    }
    assert!(!report.to_string().is_empty() && report.to_json_string().starts_with('{'));
}

/// A path, for a robot of each number of coordinates, on a map of its own coordinates.
pub fn path(bytes: &[u8]) {
    let file = File { name: "path", bytes };
    let body = RigidBody::new(shape(), Weights::default());
    let arm = Arm::new(Point::origin(), vec![1.0, 0.5], 0.1, None).expect("an arm");
    let disc = DiscRobot::new(0.1).expect("a disc");
    let robots: [Robot; 3] = [disc.into(), body.into(), arm.into()];
    for (robot, angles) in robots.iter().zip([None, Some(Angles::Degrees), Some(Angles::Radians)]) {
        match read_path(file, robot, &MapFrame::default(), &PathOptions { angles }) {
            Ok(path) => {
                assert_eq!(path.report.waypoints, path.waypoints.len());
                for q in &path.waypoints {
                    assert!(q.len() == robot.dimension() && q.iter().all(|number| !number.is_nan()), "{q:?}");
                }
                assert!(!path.report.to_string().is_empty());
            }
            Err(error) => assert!(error.message().len() > 8, "{error}"),
        }
    }
    is_path(bytes);
}

fn shape() -> Polygon {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|[x, y]| Point::new(x, y));
    polygon(&corners).expect("a triangle")
}
