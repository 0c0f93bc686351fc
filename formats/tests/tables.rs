//! Parking cases, the obstacles of Modern Robotics, and the test files of OMPL.

use crate::files::{CIRCLES, MODERN, OMPL_GRID, PARKING, Places, QUERIES, file, one, refused};
use planarium::geometry::Point;
use planarium::scenario::Robot;
use planarium_formats::{Code, Format, Options, Place, RobotChoice, read};

#[test]
fn a_parking_case_has_its_car() {
    let world = one("Case1.csv", PARKING);
    assert_eq!((world.report.format, world.scenario.name()), (Format::Tpcap, "Case1"));
    assert_eq!((world.report.obstacles.polygons, world.report.obstacles.vertices), (2, 7));
    let Robot::Car(car) = world.scenario.robot() else { panic!("a car") };
    assert_eq!((car.wheelbase(), car.steering(), car.shape().vertices().len()), (2.8, [-0.75, 0.75], 4));
    let query = &world.scenario.queries()[0];
    assert_eq!((&query.start[..], query.configuration()), (&[1.0, 1.0, 0.0][..], Some(&[4.0, 4.0, 1.57][..])));
    assert!(query.goal_tolerance.is_some());
    let bounds = world.scenario.world().bounds.expect("bounds");
    assert_eq!((bounds.min, bounds.max), (Point::new(-6.0, -6.0), Point::new(14.0, 13.0)));
    // Another robot: its headings stay, or are dropped and counted.
    let with = |robot| read(&[file("Case1.csv", PARKING)], &Options { robot, ..Options::default() }).expect("a case");
    let body = with(RobotChoice::rectangle(2.0, 1.0));
    assert_eq!(body.scenario.queries()[0].start, [1.0, 1.0, 0.0]);
    assert!(body.scenario.queries()[0].goal_tolerance.is_none());
    let disc = with(RobotChoice::Disc { radius: 1.0 });
    assert_eq!(disc.scenario.queries()[0].start, [1.0, 1.0]);
    assert!(
        disc.report.notes.iter().any(|note| note.contains("headings of 1 queries are dropped")),
        "{:?}",
        disc.report
    );
}

#[test]
fn a_parking_case_far_away_is_moved_and_the_offset_reported() {
    let far = "4484378811.25,-354286007.5,1.5,4484378813.75,-354286000.5,1.5,1,3,4484378817.125,-354286017.25,4484378813.5,-354286002.5,4484378818,-354286016.5";
    let world = one("Case13.csv", far);
    let [x, y] = world.report.offset;
    assert_eq!((x.fract(), y.fract()), (0.0, 0.0));
    let query = &world.scenario.queries()[0];
    assert_eq!((query.start[0] + x, query.start[1] + y), (4_484_378_811.25, -354_286_007.5), "exactly undone");
    assert!(query.start.iter().all(|number| number.abs() < 20.0));
    let corner = world.scenario.world().obstacles[0].aabb().min;
    assert_eq!((corner.x + x, corner.y + y), (4_484_378_813.5, -354_286_017.25));
    assert!(world.report.to_string().contains("moved: [4484378815.0"), "{}", world.report);
}

#[test]
fn wrong_parking_cases_are_refused() {
    let of = |text: &str, code| refused(&[file("Case1.csv", text)], &Options::default(), code);
    let element = |i: usize| Some(Place::Element(format!("obstacle {i}")));
    assert_eq!(of(&PARKING.replace(",0,7\n", ""), Code::Truncated).place(), element(1).as_ref());
    assert_eq!(of("1,1,0,4,4,1.57,2,4\n", Code::Truncated).place(), Some(&Place::Line(1)));
    of(&PARKING.replace(",0,7\n", ",0,7,5\n"), Code::InvalidFile);
    of(&PARKING.replace("1.57,2,", "1.57,-2,"), Code::InvalidNumber);
    of(&PARKING.replace("1.57,2,", "1.57,2.5,"), Code::InvalidNumber);
    of(&PARKING.replace("1.57,2,", "1.57,1e18,"), Code::InvalidNumber);
    assert_eq!(of(&PARKING.replace("2,4,3,", "2,4,0,"), Code::InvalidNumber).place(), element(1).as_ref());
    of(&PARKING.replace("1.57", "inf"), Code::InvalidNumber);
    // A bow tie crosses itself.
    let bow = "1,1,0,4,4,1.57,1,4,6,0,8,2,8,0,6,2\n";
    assert_eq!(of(bow, Code::InvalidFile).place(), element(0).as_ref());
    refused(&[file("Case1.csv", PARKING)], &Options { scale: Some(2.0), ..Options::default() }, Code::InvalidOption);
    refused(&[file("Case1.csv", PARKING)], &Options { min_island: 2, ..Options::default() }, Code::InvalidOption);
    refused(&[file("Case1.csv", PARKING)], &Options { simplify: 0.1, ..Options::default() }, Code::InvalidOption);
}

#[test]
fn walls_without_area_separate() {
    // Between start and goal: two corners, four on one line, one point with a wall on each side.
    for corners in [
        "1,2,10,-50,10,50",
        "1,4,10,-50,10,50,10,50,10,-50",
        "1,3,10,50,10,-50,10,0",
        "3,2,1,2,10,-50,10,0,10,0,10,0,10,50",
    ] {
        let world = one("wall.csv", format!("0,0,0,20,0,0,{corners}\n"));
        assert_eq!(world.report.dropped, []);
        assert!((1e-6..1e-5).contains(&world.report.grown), "{}", world.report);
        let places = Places::of(&world.scenario);
        for i in -500..=500 {
            assert!(!places.is_free(Point::new(10.0, f64::from(i) / 10.0)), "{corners} at {i}");
        }
        assert!(places.is_free(Point::new(9.999, 0.0)) && places.is_free(Point::new(10.001, 0.0)));
    }
}

#[test]
fn occupancy_values_need_a_threshold_in_three_columns_too() {
    for text in ["0 0 100\n100 0 0\n0 0 0\n", "0 0 100 0\n-1 0 0 0\n"] {
        let error = refused(&[file("occupancy.txt", text)], &Options::default(), Code::UnknownWorld);
        assert!(error.message().contains("threshold"), "{error}");
        let options = Options { threshold: Some(50.0), ..Options::default() };
        let world = read(&[file("occupancy.txt", text)], &options).expect("a grid");
        assert_eq!(world.report.format, Format::Grid);
    }
}

#[test]
fn obstacles_of_modern_robotics_are_discs_of_a_diameter() {
    let world = one("obstacles.csv", MODERN);
    // One of them has the diameter 0.
    assert_eq!((world.report.format, world.report.obstacles.discs), (Format::ModernRobotics, 3));
    assert!(world.report.notes.iter().any(|note| note.starts_with("1 obstacles without area are grown")));
    let planarium::scenario::Obstacle::Disc(disc) = &world.scenario.world().obstacles[0] else { panic!("a disc") };
    assert_eq!((disc.center, disc.radius), (Point::new(0.0, 0.0), 0.1));
    assert_eq!(world.scenario.queries()[0].start, [-0.5, -0.5]);
    let outside = one("obstacles.csv", "10,10,2\n12,11,1\n");
    assert_eq!(
        (outside.scenario.queries().len(), outside.scenario.world().bounds.expect("bounds").min),
        (0, Point::new(9.0, 9.0))
    );
    let error =
        refused(&[file("obstacles.csv", "0.1,0.1,0.2\n0.1,0.3,-0.2\n")], &Options::default(), Code::InvalidNumber);
    assert_eq!(error.place(), Some(&Place::Line(2)));
}

#[test]
fn a_grid_of_ompl_has_a_start_and_an_end() {
    let world = one("env1.txt", OMPL_GRID);
    let query = &world.scenario.queries()[0];
    // Cells are (row, column): row 0 is at the top of two rows.
    assert_eq!((&query.start[..], query.configuration()), (&[0.5, 1.5][..], Some(&[2.5, 0.5][..])));
    assert_eq!((world.report.format, world.report.obstacles.polygons), (Format::OmplGrid, 1));
    for (from, to, code) in [
        ("0 0 0\n", "0 0\n", Code::Truncated),
        ("0 0 0\n", "0 0 0 0\n", Code::InvalidFile),
        ("0 0 0\n", "0 0 2\n", Code::InvalidNumber),
        ("1 2\n", "2 2\n", Code::InvalidNumber),
        ("2 3", "-2 3", Code::InvalidNumber),
        ("2 3", "2000000000 3", Code::WorldTooLarge),
        ("end", "goal", Code::InvalidFile),
        ("environment:\n0 1 0\n0 0 0\n", "", Code::Truncated),
    ] {
        refused(&[file("env1.txt", &OMPL_GRID.replace(from, to))], &Options::default(), code);
    }
}

#[test]
fn circles_of_ompl_have_queries() {
    let files = [file("circle_queries.txt", QUERIES), file("circle_obstacles.txt", CIRCLES)];
    let world = read(&files, &Options::default()).expect("circles");
    assert_eq!(
        (world.report.format, world.report.obstacles.discs, world.report.queries.len()),
        (Format::OmplCircles, 2, 2)
    );
    assert_eq!(world.scenario.queries()[1].configuration(), Some(&[9.0, 2.0][..]));
    // The box around all circles, widened to the queries.
    let bounds = world.scenario.world().bounds.expect("bounds");
    assert_eq!((bounds.min, bounds.max), (Point::new(0.0, 0.0), Point::new(9.0, 4.0)));
    let alone = one("circle_obstacles.txt", CIRCLES).scenario.world().bounds.expect("bounds");
    assert_eq!((alone.min, alone.max), (Point::new(1.0, 2.0), Point::new(6.5, 4.0)));
    assert_eq!(refused(&files[..1], &Options::default(), Code::MissingFile).wanted(), Some("circle_obstacles.txt"));
    for (from, to, code) in [
        ("1\tgoal:\t9\t2\n", "", Code::Truncated),
        ("1\tgoal:", "2\tgoal:", Code::InvalidFile),
        ("0\tgoal:", "0\tstart:", Code::InvalidFile),
        ("9\t2", "9", Code::InvalidFile),
        ("9\t2", "9\tinf", Code::InvalidNumber),
    ] {
        let queries = QUERIES.replace(from, to);
        refused(&[file("q", &queries), file("c", CIRCLES)], &Options::default(), code);
    }
    for (from, to, code) in [
        ("\t0.5", "\t-0.5", Code::InvalidNumber),
        ("\t0.5", "\tnan", Code::InvalidNumber),
        ("\t0.5", "", Code::InvalidFile),
    ] {
        refused(&[file("c", &CIRCLES.replace(from, to))], &Options::default(), code);
    }
}
