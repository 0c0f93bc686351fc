//! Paths of other programs: every form, in the coordinates of a map, and what is refused.

use crate::documents::needed;
use crate::files::{file, npy, one};
use planarium::geometry::Point;
use planarium::path::{Blocked, JudgeOptions, judge};
use planarium::robot::{Arm, DiscRobot, RigidBody, Weights};
use planarium::scenario::{Robot, Scenario, World, polygon};
use planarium_formats::{
    Angles, Code, Coordinates, FormatError, MapFrame, Options, PathFormat, PathOptions, PathRead, Place, is_path, read,
    read_path,
};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::time::Instant;

/// As `ros2 topic echo` prints it.
pub const POSES: &str = "header:\n  stamp:\n    sec: 12\n    nanosec: 0\n  frame_id: map\nposes:\n- header:\n    frame_id: map\n  pose:\n    \
    position:\n      x: 1.0\n      y: 2.5\n      z: 0.0\n    orientation:\n      x: 0.0\n      y: 0.0\n      z: 0.7071067811865476\n      \
    w: 0.7071067811865476\n- header:\n    frame_id: map\n  pose:\n    position: {x: 2.0, y: 2.5, z: 0.1}\n    orientation: {z: 0.0, w: 1.0}\n---\n";
pub const POSES_JSON: &str = r#"[{"header": {"frame_id": "odom"}, "pose": {"position": {"x": 1, "y": 2.5}, "orientation": {"z": 1, "w": 0}}},
    {"position": {"x": 2, "y": 3}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}]"#;
pub const LINE: &str = r#"{"type": "Feature", "properties": {"name": "way"}, "geometry":
    {"type": "LineString", "coordinates": [[1, 2], [3, 4, 5], [5.5, -6]]}}"#;
pub const POINTS: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"theta_deg": 90}, "geometry": {"type": "Point", "coordinates": [1, 2]}},
    {"type": "Feature", "properties": {"theta_deg": -45.0}, "geometry": {"type": "Point", "coordinates": [3, 4]}}]}"#;

fn disc() -> Robot {
    DiscRobot::new(0.1).expect("a disc").into()
}

fn body() -> Robot {
    let corners = [[-0.2, -0.1], [0.2, -0.1], [0.2, 0.1], [-0.2, 0.1]].map(|[x, y]| Point::new(x, y));
    RigidBody::new(polygon(&corners).expect("a shape"), Weights::default()).into()
}

fn arm() -> Robot {
    Arm::new(Point::origin(), vec![1.0, 0.5], 0.1, None).expect("an arm").into()
}

fn reading(robot: &Robot, bytes: &[u8], angles: Option<Angles>) -> Result<PathRead, FormatError> {
    read_path(file("path", bytes), robot, &MapFrame::default(), &PathOptions { angles })
}

#[track_caller]
fn reads(robot: &Robot, bytes: impl AsRef<[u8]>, wanted: &[&[f64]]) -> PathRead {
    let read = reading(robot, bytes.as_ref(), None).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(read.waypoints.len(), wanted.len(), "{:?}", read.waypoints);
    for (q, wanted) in read.waypoints.iter().zip(wanted) {
        let is_near = q.len() == wanted.len() && q.iter().zip(*wanted).all(|(a, b)| (a - b).abs() < 1e-12);
        assert!(is_near, "{q:?}, not {wanted:?}");
    }
    read
}

#[track_caller]
fn refuses(robot: &Robot, bytes: impl AsRef<[u8]>, code: Code, place: Option<Place>, words: &str) {
    let error = reading(robot, bytes.as_ref(), None).map(|read| read.waypoints).expect_err("it is refused");
    assert_eq!((error.code(), error.place(), error.file()), (code, place.as_ref(), Some("path")), "{error}");
    assert!(error.message().contains(words), "{error}");
}

#[test]
fn tables_are_read_by_names_and_without() {
    let wanted: &[&[f64]] = &[&[1.0, 2.0, FRAC_PI_2], &[1.5, -2.0, -PI]];
    for text in [
        "x,y,theta_deg\n1,2,90\n1.5,-2,-180\n",
        "x;y;theta [deg]\r\n1;2;90\r\n1.5;-2;-180",
        "\tx\ty\ttheta\tv\n0\t1\t2\t1.5707963267948966\t0.1\n1\t1.5\t-2\t-3.141592653589793\t\n",
        "# t x y yaw_deg\n0 1 2 90\n# more\n\n1 1.5 -2 -180\n",
        "\"time\",\"pose.position.x (mm)\",\"pose.position.y (mm)\",\"heading (°)\"\n0,1000,2000,90\n1,1500,-2000,-180,\n",
        "time,pos_y,pos_x,qz,qw\n0,2,1,0.70710678118654757,0.70710678118654757\nnan,-2,1.5,-1,0\n",
        "0 1 2 1.5707963267948966\n1 1.5 -2 -3.141592653589793\n",
        "1,2,1.5707963267948966\n1.5,-2,-3.141592653589793\n",
    ] {
        let read = reads(&body(), text, wanted);
        assert_eq!((read.report.format, read.report.waypoints), (PathFormat::Table, 2));
        let used = read.report.columns.iter().filter(|column| column.meaning.is_some()).count();
        assert_eq!(used, if text.contains("qw") { 4 } else { 3 }, "{}", read.report);
    }
    reads(&disc(), "x y\n1 2\n", &[&[1.0, 2.0]]);
    reads(&disc(), "1 2 0.3\n2 2 0.3\n", &[&[1.0, 2.0], &[2.0, 2.0]]);
    reads(&arm(), "q1 [deg],q0 [deg]\n90,45\n", &[&[FRAC_PI_4, FRAC_PI_2]]);
    reads(&arm(), "0.5 0.25\n", &[&[0.5, 0.25]]);
    let said = reads(&body(), "t,x,y,theta_deg\n0,1,2,90\n", &[&[1.0, 2.0, FRAC_PI_2]]).report.to_string();
    assert!(said.contains("theta [deg] (\"theta_deg\")") && said.contains("left out: the columns \"t\""), "{said}");
}

#[test]
fn degrees_are_asked_for() {
    let turned = "x,y,theta\n0,0,0\n1,0,90\n";
    refuses(&body(), turned, Code::InvalidOption, Some(Place::Line(3)), "theta 90 looks like degrees");
    let theta = |angles| reading(&body(), turned.as_bytes(), Some(angles)).map(|read| read.waypoints[1][2]);
    assert_eq!((theta(Angles::Degrees), theta(Angles::Radians)), (Ok(FRAC_PI_2), Ok(90.0)));
    // Many turns are no degrees, and what the file says is so.
    reads(&body(), "x,y,theta\n0,0,400\n", &[&[0.0, 0.0, 400.0]]);
    reads(&body(), "x,y,theta_rad\n0,0,90\n", &[&[0.0, 0.0, 90.0]]);
    refuses(&arm(), "90,180\n", Code::InvalidOption, Some(Place::Line(1)), "joint 0 90 looks like degrees");
}

#[test]
fn arrays_poses_and_lists_are_read() {
    let numbers: Vec<u8> = [0.5_f64, 1.0, 2.0, 3.0].iter().flat_map(|x| x.to_le_bytes()).collect();
    reads(&disc(), npy("<f8", 2, 2, &numbers), &[&[0.5, 1.0], &[2.0, 3.0]]);
    let read = reads(&body(), POSES, &[&[1.0, 2.5, FRAC_PI_2], &[2.0, 2.5, 0.0]]);
    assert_eq!(read.report.format, PathFormat::Poses);
    assert!(read.report.to_string().contains("in the frame \"map\"") && read.report.dropped[0].what == "heights");
    reads(&disc(), POSES, &[&[1.0, 2.5], &[2.0, 2.5]]);
    reads(&body(), POSES_JSON, &[&[1.0, 2.5, PI], &[2.0, 3.0, 0.0]]);
    reads(&disc(), "[[1, 2], [3, 4.5]]", &[&[1.0, 2.0], &[3.0, 4.5]]);
    let columns = r#"{"columns": {"y": {"values": [2, 4]}, "theta": {"unit": "deg", "values": [90, 0]}, "x": {"unit": "cm", "values": [100, 300]}}}"#;
    let read = reads(&body(), columns, &[&[1.0, 2.0, FRAC_PI_2], &[3.0, 4.0, 0.0]]);
    assert_eq!(read.report.format, PathFormat::Columns);
    reads(&arm(), r#"{"path": [[1, 2], [3, 4.5]]}"#, &[&[1.0, 2.0], &[3.0, 4.5]]);
    reads(&disc(), LINE, &[&[1.0, 2.0], &[3.0, 4.0], &[5.5, -6.0]]);
    let ends = format!(
        r#"{{"type": "FeatureCollection", "features": [{LINE}, {}, {}]}}"#,
        r#"{"type": "Point", "coordinates": [1, 2]}"#, r#"{"type": "Point", "coordinates": [5.5, -6]}"#
    );
    reads(&disc(), &ends, &[&[1.0, 2.0], &[3.0, 4.0], &[5.5, -6.0]]);
    refuses(&disc(), ends.replace("[5.5, -6]}", "[5.5, 6]}"), Code::Contradiction, None, "which is the path");
    reads(
        &disc(),
        "- frame_id: map\n  position: {x: 1, y: 2}\n- frame_id: map\n  position: {x: 3, y: 4}\n",
        &[&[1.0, 2.0], &[3.0, 4.0]],
    );
    reads(&body(), POINTS, &[&[1.0, 2.0, FRAC_PI_2], &[3.0, 4.0, -FRAC_PI_4]]);
    for (bytes, is_one) in [(POSES, true), (columns, true), (POSES_JSON, true), (LINE, true), ("1,2\n", true)]
        .into_iter()
        .chain([(r#"{"scenario": "s", "path": []}"#, false), (r#"{"format": "planarium-certificate-1"}"#, false)])
    {
        assert_eq!(is_path(bytes.as_bytes()), is_one, "{bytes}");
    }
}

#[test]
fn what_is_no_path_is_refused_with_its_place() {
    let line = |line| Some(Place::Line(line));
    let element = |name: &str| Some(Place::Element(name.to_owned()));
    refuses(&disc(), "", Code::Truncated, None, "empty");
    refuses(&disc(), "# x y\n", Code::Truncated, None, "no row");
    refuses(&disc(), "x,y\n", Code::Truncated, None, "no waypoint");
    refuses(&disc(), "x,y\n1,2\n3", Code::Truncated, line(3), "1 cells");
    refuses(&disc(), "x,y\n1\n3,4", Code::InvalidFile, line(2), "1 cells");
    refuses(&disc(), "x,y\n1,2\n3,nan\n", Code::InvalidNumber, line(3), "NaN");
    refuses(&disc(), "x,y\n1,inf\n", Code::InvalidNumber, line(2), "inf");
    refuses(&disc(), "x,y\n1,b\n", Code::InvalidFile, line(2), "\"b\" is no number");
    refuses(&disc(), "hello world\n1 b\n", Code::InvalidFile, line(2), "\"b\" is no number");
    refuses(&disc(), "1 b\n", Code::UnknownWorld, line(1), "no path");
    refuses(&disc(), b"\xff\xfe1,2", Code::UnknownWorld, None, "neither text");
    refuses(&body(), "x,y\n1,2\n", Code::WrongColumns, None, "x, y and theta");
    refuses(&body(), "1,2\n", Code::WrongColumns, None, "2 numbers");
    refuses(&body(), "5,1,2,0\n4,1,2,0\n", Code::WrongColumns, None, "do not grow");
    refuses(&disc(), "0,1,2\n1,1,2\n", Code::WrongColumns, None, "could be a time");
    refuses(&arm(), "x,y\n1,2\n", Code::WrongColumns, None, "joint_0 to joint_1");
    refuses(&arm(), "q0,q2\n1,2\n", Code::Contradiction, None, "one after the other");
    refuses(&disc(), "x,x [m],y\n1,2,3\n", Code::Contradiction, None, "mean the same");
    refuses(&disc(), "x [deg],y\n1,2\n", Code::InvalidFile, None, "cannot have the unit deg");
    refuses(&disc(), "lon,lat\n1,2\n", Code::InvalidFile, None, "the map has none");
    refuses(&body(), "x,y,qz,qw\n1,2,0,0\n", Code::InvalidNumber, line(2), "no quaternion");
    let cut = POSES.split("- header").take(2).collect::<Vec<_>>().join("- header") + "- '...'\n";
    refuses(&body(), cut, Code::Truncated, line(19), "--full-length");
    refuses(&disc(), POSES.replace("2.5", ".nan"), Code::InvalidNumber, line(12), "nan");
    refuses(&disc(), POSES_JSON.replace("2.5", "\"b\""), Code::InvalidFile, element("pose 0"), "no number");
    let columns = r#"{"columns": {"x": {"values": [1, 2]}, "y": {"values": [1]}}}"#;
    refuses(&disc(), columns, Code::Contradiction, element("column \"y\""), "1 values");
    refuses(&disc(), columns.replace("[1]", "[1, null]"), Code::InvalidFile, line(1), "object of columns");
    refuses(&disc(), r#"{"columns": {}}"#, Code::Truncated, None, "no waypoint");
    refuses(&disc(), "[[1, 2], [3]]", Code::InvalidFile, element("row 1"), "1 numbers");
    refuses(&disc(), "[[1, 2], [3,", Code::Truncated, line(1), "JSON");
    refuses(&body(), LINE, Code::WrongColumns, None, "theta");
    refuses(&disc(), LINE.replace("LineString", "Polygon"), Code::Truncated, None, "neither a line");
    refuses(&arm(), LINE, Code::WrongColumns, None, "joint_0");
    refuses(&disc(), npy("<f8", 1, 2, &[255; 16]), Code::InvalidNumber, element("row 0"), "NaN");
    refuses(&disc(), npy("<f8", 1, 2, &[0; 8]), Code::InvalidFile, None, "2 numbers");
}

#[test]
fn paths_are_in_the_coordinates_of_their_map() {
    // Longitude and latitude, back through the plane of the import.
    let square =
        r#"{"type": "Polygon", "coordinates": [[[13.0, 52.0], [13.001, 52.0], [13.001, 52.001], [13.0, 52.001]]]}"#;
    let house = one("house.geojson", square);
    let frame = *house.scenario.frame();
    assert!(frame.has_degrees());
    let bounds = house.scenario.world().bounds.expect("bounds");
    let wanted = [[bounds.min.x, bounds.min.y], [bounds.max.x, 0.5 * bounds.max.y]];
    let [a, b] = wanted.map(|place| frame.to_units(place));
    let line = format!(r#"{{"type": "LineString", "coordinates": [{a:?}, {b:?}]}}"#);
    let table = format!("longitude,latitude\n{},{}\n{},{}\n", a[0], a[1], b[0], b[1]);
    let [c, d] = wanted.map(|place| frame.to_metres(place));
    let metres = format!("x,y\n{},{}\n{},{}\n", c[0], c[1], d[0], d[1]);
    for text in [line, table, metres] {
        let read = read_path(file("path", &text), &disc(), &frame, &PathOptions::default()).expect("a path");
        for (q, wanted) in read.waypoints.iter().zip(wanted) {
            assert!((q[0] - wanted[0]).abs() < 1e-8 && (q[1] - wanted[1]).abs() < 1e-8, "{q:?}, not {wanted:?}");
        }
    }
    // A map in centimetres has paths of GeoJSON in centimetres, and tables in metres.
    let options = Options { scale: Some(0.01), coordinates: Coordinates::Metres, ..Options::default() };
    let drawn = r#"{"type": "LineString", "coordinates": [[0, 0], [900, 0]]}"#;
    let frame = *read(&[file("wall.geojson", drawn)], &options).expect("a wall").scenario.frame();
    for text in [r#"{"type": "LineString", "coordinates": [[100, 200], [300, 400]]}"#, "x,y\n1,2\n3,4\n"] {
        let read = read_path(file("path", text), &disc(), &frame, &PathOptions::default()).expect("a path");
        assert_eq!(read.waypoints, [[1.0, 2.0], [3.0, 4.0]]);
    }
    // A parking case far from the origin, which the import moves.
    let far = one("far.csv", "4500000001,1,0,4500000004,4,0,1,3,4500000006,0,4500000008,0,4500000008,2\n");
    let frame = *far.scenario.frame();
    let path = "x,y,theta\n4500000001,1,0\n4500000004,4,0\n";
    let read = read_path(file("path", path), far.scenario.robot(), &frame, &PathOptions::default()).expect("a path");
    let query = &far.scenario.queries()[0];
    assert_eq!(read.waypoints, [query.start.clone(), query.configuration().expect("a goal").to_vec()]);
    assert_eq!(read.report.offset, far.report.offset);
}

#[test]
fn a_million_waypoints_are_read() {
    let mut text = "t,x,y,theta\n".to_owned();
    for i in 0..1_000_000 {
        let angle = 1e-6 * f64::from(i);
        text += &format!("{i},{:.6},{:.6},{angle:.6}\n", angle.cos(), angle.sin());
    }
    let begun = Instant::now();
    let read = reading(&body(), text.as_bytes(), None).expect("a path");
    println!("a million waypoints, {} bytes: {:.2} s", text.len(), begun.elapsed().as_secs_f64());
    assert_eq!(read.waypoints.len(), 1_000_000);
    // As YAML they are more text than becomes a tree.
    let poses = format!("poses:\n{}", "- pose: {position: {x: 1.0, y: 2.0, z: 0.0}}\n".repeat(1_000_000));
    refuses(&disc(), poses, Code::WorldTooLarge, None, "at most");
}

/// The published solutions of parking cases, judged on their cases with the car of the competition. The format has no bounds: those
/// of the import are grown, so that they decide nothing. The clearances were found as well by samples of other code.
#[test]
fn published_parking_solutions_are_judged() {
    let Some(folder) = needed("PLANARIUM_WORLDS") else { return };
    // The case; the contact of the straight motions and that of the arcs, or the clearances; the turns that cannot be driven, and the
    // least radius.
    let findings = [
        (1, [Ok(0.1368), Ok(0.1368)], 85, 2.400),
        (2, [Ok(0.0490), Ok(0.0466)], 112, 3.128),
        (3, [Ok(0.3028), Ok(0.3031)], 40, 3.077),
        (5, [Err((350, 0.272)), Err((350, 0.684))], 394, 0.084),
        (9, [Ok(0.0760), Ok(0.0744)], 82, 3.005),
    ];
    for (case, wanted, count, radius) in findings {
        let read =
            |name: String| std::fs::read(std::path::Path::new(&folder).join("tpcap").join(name)).expect("a file");
        let world = one("case.csv", read(format!("Case{case}.csv")));
        let bytes = read(format!("Solution_Case{case}.csv"));
        let frame = *world.scenario.frame();
        let robot = world.scenario.robot().clone();
        let path = read_path(file("solution.csv", &bytes), &robot, &frame, &PathOptions::default())
            .unwrap_or_else(|error| panic!("{error}"));
        let bounds = world.scenario.world().bounds.map(|bounds| bounds.grown(20.0));
        let obstacles = world.scenario.world().obstacles.to_vec();
        let open = Scenario::new("case", World::new(bounds, obstacles), robot, []).expect("a scenario");
        for (arcs, wanted) in [false, true].into_iter().zip(wanted) {
            let found = judge(&open, &path.waypoints, &JudgeOptions { arcs, ..JudgeOptions::default() })
                .unwrap_or_else(|error| panic!("{error}"));
            match (wanted, &found.contact, &found.clearance) {
                (Ok(least), None, Some(clearance)) => {
                    assert!((clearance.distance - least).abs() < 2e-4, "case {case}: {clearance:?}");
                }
                (Err((edge, fraction)), Some(contact), None) => {
                    assert_eq!((contact.at.edge, contact.with), (edge, Blocked::Obstacle(0)), "case {case}");
                    assert!((contact.at.fraction - fraction).abs() < 1e-3, "case {case}: {contact:?}");
                }
                found => panic!("case {case}: {found:?}"),
            }
            let turns = found.turns.expect("a car has turns");
            assert_eq!(turns.count, count, "case {case}");
            let least = turns.least_radius.expect("there are turns");
            assert!((least - radius).abs() < 1e-3, "case {case}: {least}");
        }
    }
}
