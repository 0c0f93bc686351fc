//! Paths that are written: each form is read back by the readers of the crate and by programs of others, Python's modules for
//! CSV, JSON and XML, NumPy and PyYAML: `PLANARIUM_PYTHON` names a Python, or else `python3`; what it has not is skipped aloud.

use crate::files::{one, python};
use planarium::geometry::{Aabb, Point};
use planarium::robot::{Arm, Car, DiscRobot, Joint, RigidBody, Weights};
use planarium::scenario::{MapFrame, MapPlane, Obstacle, Robot, Scenario, World, polygon};
use planarium_formats::{
    Code, File, FormatError, PathForm, PathOptions, PathRows, Place, RowTiming, WriteOptions, read_path, write_path,
};
use std::f64::consts::{FRAC_PI_2, PI};
use std::process::{Command, Stdio};

fn body() -> Robot {
    let corners = [[-0.2, -0.1], [0.2, -0.1], [0.2, 0.1], [-0.2, 0.1]].map(|[x, y]| Point::new(x, y));
    RigidBody::new(polygon(&corners).expect("a shape"), Weights::default()).into()
}

fn car() -> Robot {
    let corners = [[-0.1, -0.1], [0.4, -0.1], [0.4, 0.1], [-0.1, 0.1]].map(|[x, y]| Point::new(x, y));
    let shape = polygon(&corners).expect("a shape");
    Car::new(shape, 0.3, [-1.0, 1.0], [-0.6, 0.6], 0.01, Weights::default()).expect("a car").into()
}

fn disc() -> Robot {
    DiscRobot::new(0.1).expect("a disc").into()
}

/// A joint that turns and one that slides.
fn arm() -> Robot {
    let joints = vec![Joint::Revolute { limits: None }, Joint::Prismatic { range: [-0.5, 1.0], angle: 0.3 }];
    Arm::with_joints(Point::new(3.0, 4.0), vec![1.0, 0.5], 0.1, joints).expect("an arm").into()
}

/// A floor with an obstacle of each kind.
fn floor(robot: Robot, frame: MapFrame) -> Scenario {
    let square = |x: f64, y: f64, side: f64| {
        [[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]].map(|[a, b]| Point::new(x + a, y + b))
    };
    let ring = Obstacle::polygon_with_holes(&square(6.0, 6.0, 3.0), &[square(7.0, 7.0, 1.0).to_vec()]);
    let wall = |width: f64, x: f64, closed: bool| {
        let points = [Point::new(x, 8.0), Point::new(x + 0.5, 8.0), Point::new(x + 0.5, 9.0)];
        Obstacle::wall(&points, width, closed).expect("a wall")
    };
    let obstacles = [
        Obstacle::disc(Point::new(8.0, 2.0), 0.5),
        Obstacle::polygon(&square(5.0, 1.0, 1.0)).expect("a square"),
        ring.expect("a ring"),
        wall(0.2, 1.0, false),
        wall(0.0, 3.0, true),
    ];
    let bounds = Aabb::of(Point::origin(), Point::new(10.0, 10.0));
    Scenario::new("floor <1> & \"more\"", World::new(Some(bounds), obstacles), robot, [])
        .expect("a floor")
        .in_frame(frame)
}

/// Three rows that turn by more than half a turn.
fn rows(dimension: usize, timed: bool) -> PathRows {
    let all = [[1.0, 2.0, 3.0], [1.5, 2.25, 3.5], [1.0 / 3.0, 1e-7, 2.0 * PI]];
    let configurations: Vec<Vec<f64>> = all.iter().map(|q| q[..dimension].to_vec()).collect();
    let velocities = vec![vec![0.0; dimension], vec![-0.5; dimension], vec![0.0; dimension]];
    let timing = timed.then(|| RowTiming { times: vec![0.0, 0.25, 1.999_999_999_9], velocities });
    PathRows { query: "any".to_owned(), configurations, timing }
}

fn written(scenario: &Scenario, rows: &PathRows, form: PathForm) -> Vec<u8> {
    write_path(scenario, rows, form, &WriteOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// A map that was moved, one in longitude and latitude, one in centimetres, and none.
fn frames() -> [MapFrame; 4] {
    let plane = |scale, degrees| Some(MapPlane { origin: [13.4, 52.5], scale, degrees });
    let frame = |offset, plane| MapFrame::new(offset, plane).expect("a frame");
    [
        MapFrame::default(),
        frame([4.5e6, -1024.0], None),
        frame([0.0; 2], plane([67_000.0, 111_000.0], true)),
        frame([0.0; 2], plane([0.01; 2], false)),
    ]
}

#[test]
fn every_form_is_read_back_in_the_coordinates_of_the_map() {
    let readable =
        [PathForm::Csv, PathForm::Json, PathForm::Npy, PathForm::GeoJson, PathForm::NavPath, PathForm::NavWaypoints];
    let mut checked = 0;
    for frame in frames() {
        for robot in [disc(), body(), car(), arm()] {
            for timed in [false, true] {
                let rows = rows(robot.dimension(), timed);
                let scenario = floor(robot.clone(), frame);
                for form in readable {
                    let is_arm = matches!(robot, Robot::Arm(_));
                    if is_arm && !matches!(form, PathForm::Csv | PathForm::Json | PathForm::Npy) {
                        continue;
                    }
                    let bytes = written(&scenario, &rows, form);
                    let read = read_path(File { name: "path", bytes: &bytes }, &robot, &frame, &PathOptions::default());
                    if form == PathForm::Npy && timed && robot.dimension() == 2 && !is_arm {
                        // A time, x and y of a disc may as well be a placement.
                        assert_eq!(read.expect_err("it is refused").code(), Code::WrongColumns);
                        continue;
                    }
                    let read = read.unwrap_or_else(|error| panic!("{form:?} {}: {error}", robot.kind()));
                    assert_eq!(read.waypoints.len(), 3);
                    let most: f64 = if frame.is_identity() { 1e-15 } else { 2e-9 };
                    for (found, wanted) in read.waypoints.iter().zip(&rows.configurations) {
                        for (k, (a, b)) in found.iter().zip(wanted).enumerate() {
                            let off = if k == 2 { planarium::geometry::wrap(a - b) } else { a - b };
                            assert!(off.abs() <= most.max(4e-16 * b.abs()), "{form:?} {}: {a}, not {b}", robot.kind());
                        }
                    }
                    checked += 1;
                }
            }
        }
    }
    assert_eq!(checked, 4 * (11 + 12 + 12 + 6));
}

#[test]
fn tables_have_units_and_say_where_the_map_is() {
    let [_, moved, degrees, _] = frames();
    let lines = |scenario: &Scenario, rows: &PathRows| {
        let text = String::from_utf8(written(scenario, rows, PathForm::Csv)).expect("text");
        text.lines().map(str::to_owned).collect::<Vec<_>>()
    };
    let table = lines(&floor(body(), moved), &rows(3, true));
    assert_eq!(table[0], "t_s,x_m,y_m,theta_rad,vx_m_s,vy_m_s,omega_rad_s");
    assert_eq!(table[2], "0.25,4500001.5,-1021.75,3.5,-0.5,-0.5,-0.5");
    assert_eq!(lines(&floor(arm(), moved), &rows(2, false))[..2], ["joint_0_rad,joint_1_m", "1.0,2.0"]);
    assert_eq!(
        lines(&floor(arm(), moved), &rows(2, true))[0],
        "t_s,joint_0_rad,joint_1_m,joint_0_speed_rad_s,joint_1_speed_m_s"
    );
    let placed = lines(&floor(disc(), degrees), &rows(2, false));
    assert_eq!(placed[0], "x_m,y_m,lon_deg,lat_deg");
    let [x, y] = degrees.to_units([1.0, 2.0]);
    assert_eq!(placed[1], format!("1.0,2.0,{x},{y}"));
    // Small numbers have no exponent, which YAML 1.1 and some tables take for text.
    assert_eq!(lines(&floor(disc(), MapFrame::default()), &rows(2, false))[3].split(',').nth(1), Some("0.0000001"));
}

/// The trajectory of a disc that drives along its heading has rows of x, y and the heading.
#[test]
fn a_disc_may_have_a_heading() {
    let [_, moved, degrees, _] = frames();
    let (scenario, rows) = (floor(disc(), moved), rows(3, true));
    let text = |form| String::from_utf8(written(&scenario, &rows, form)).expect("text");
    let table = text(PathForm::Csv);
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines[0], "t_s,x_m,y_m,theta_rad,vx_m_s,vy_m_s,omega_rad_s");
    assert_eq!(lines[2], "0.25,4500001.5,-1021.75,3.5,-0.5,-0.5,-0.5");
    let json: serde_json::Value = serde_json::from_str(&text(PathForm::Json)).expect("JSON");
    assert_eq!(json["columns"]["theta"], serde_json::json!({"unit": "rad", "values": [3, 3.5, 2.0 * PI]}));
    let points: serde_json::Value = serde_json::from_str(&text(PathForm::GeoJson)).expect("JSON");
    let headings = points["features"].as_array().expect("features").iter().map(|one| &one["properties"]["theta"]);
    assert_eq!(headings.skip(1).map(|theta| theta.as_f64()).collect::<Vec<_>>(), [3.0, 3.5, 2.0 * PI].map(Some));
    for form in [PathForm::NavPath, PathForm::NavWaypoints] {
        // Not the direction to the next place.
        let (z, w) = libm::sincos(1.5);
        assert!(text(form).contains(&format!("orientation: {{x: 0.0, y: 0.0, z: {z}, w: {w}}}")), "{}", text(form));
    }
    let bytes = written(&scenario, &rows, PathForm::Npy);
    assert!(String::from_utf8_lossy(&bytes).contains("(3, 4)"), "time, x, y and theta");
    assert_eq!(text(PathForm::Svg).matches("<circle").count(), 1 + 3, "an obstacle, and the robot at each row");
    for form in [PathForm::Csv, PathForm::Json, PathForm::GeoJson, PathForm::NavPath, PathForm::NavWaypoints] {
        let bytes = written(&floor(disc(), degrees), &rows, form);
        let file = File { name: "path", bytes: &bytes };
        let read = read_path(file, &disc(), &degrees, &PathOptions::default()).expect("a path of a disc");
        assert_eq!((read.waypoints.len(), read.waypoints[0].len()), (3, 2), "{form:?}");
    }
    let mut mixed = rows.clone();
    mixed.configurations[1].pop();
    let error = write_path(&scenario, &mixed, PathForm::Csv, &WriteOptions::default()).expect_err("it is refused");
    assert_eq!((error.code(), error.place()), (Code::WrongColumns, Some(&Place::Element("row 1".to_owned()))));
}

/// The header of an array is that of NumPy, padded to 64 bytes.
#[test]
fn arrays_begin_at_a_multiple_of_64_bytes() {
    for count in [1, 9, 10, 99_999, 100_000] {
        let rows = PathRows { query: "any".to_owned(), configurations: vec![vec![0.5, 0.25]; count], timing: None };
        let bytes = written(&floor(disc(), MapFrame::default()), &rows, PathForm::Npy);
        let begin = bytes.len() - 16 * count;
        assert_eq!((begin % 64, bytes[begin - 1], &bytes[..8]), (0, b'\n', &b"\x93NUMPY\x01\x00"[..]));
        let length = usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
        assert_eq!(10 + length, begin);
    }
}

/// A disc has the heading of its way, also where it rests.
#[test]
fn poses_of_a_disc_look_ahead() {
    let places = [[1.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0], [0.0, 2.0]];
    let configurations = places.iter().map(|place| place.to_vec()).collect();
    let rows = PathRows { query: "any".to_owned(), configurations, timing: None };
    let scenario = floor(disc(), MapFrame::default());
    for (rows, wanted) in [
        (rows, vec![FRAC_PI_2, FRAC_PI_2, PI, PI, PI]),
        (PathRows { query: "any".to_owned(), configurations: vec![vec![1.0, 1.0]], timing: None }, vec![0.0]),
    ] {
        for form in [PathForm::NavPath, PathForm::NavWaypoints] {
            let bytes = written(&scenario, &rows, form);
            let file = File { name: "path", bytes: &bytes };
            let read = read_path(file, &body(), &MapFrame::default(), &PathOptions::default()).expect("poses");
            let headings: Vec<f64> = read.waypoints.iter().map(|q| q[2]).collect();
            assert!(headings.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 1e-15), "{headings:?}");
            assert_eq!(headings.len(), wanted.len());
        }
    }
}

/// A drawing is a world of its own: its obstacles are those of the scenario.
#[test]
fn a_drawing_shows_obstacles_where_they_are() {
    let configurations = vec![vec![1.0, 2.0], vec![4.0, 2.5]];
    let rows = PathRows { query: "any".to_owned(), configurations, timing: None };
    let svg = String::from_utf8(written(&floor(disc(), MapFrame::default()), &rows, PathForm::Svg)).expect("text");
    let (width, height) = (10.2 + 0.2, 10.2 + 0.2);
    assert!(svg.contains(&format!("viewBox=\"-0.2 -10.2 {width} {height}\"")), "{svg}");
    assert!(svg.contains("floor &lt;1&gt; &amp;"), "{svg}");
    let world = one("path.svg", &svg);
    // The outlines of the robot, of the bounds and the path are lines; the lower left corner of the page is the origin there.
    for (x, y) in [(8.0, 2.0), (5.5, 1.5), (6.5, 6.5), (1.25, 8.0), (3.5, 8.5)] {
        let at = Point::new(x + 0.2, y + 0.2);
        let at = planarium::geometry::Segment::new(at, at);
        let nearest = world.scenario.world().obstacles.iter().map(|o| o.distance_to_segment(&at)).fold(9.0, f64::min);
        assert!(nearest < 1e-9, "({x}, {y}) is {nearest} m from all that is drawn");
    }
    // The hole stays one.
    let at = Point::new(7.7, 7.7);
    let at = planarium::geometry::Segment::new(at, at);
    assert!(world.scenario.world().obstacles.iter().all(|obstacle| obstacle.distance_to_segment(&at) > 0.4));
    // An arm needs no bounds, and its tip is drawn along its curve.
    let bare = Scenario::new("bare", World::new(None, []), arm(), []).expect("an arm");
    let rows = PathRows { query: "any".to_owned(), configurations: vec![vec![0.0, 0.0], vec![1.0, 0.5]], timing: None };
    let svg = String::from_utf8(written(&bare, &rows, PathForm::Svg)).expect("text");
    let points = svg.split("points=\"").nth(1).and_then(|rest| rest.split('"').next()).expect("points");
    assert_eq!(points.split(' ').count(), 17);
}

#[test]
fn what_cannot_be_written_is_refused_with_its_place() {
    let scenario = floor(body(), MapFrame::default());
    let refuses = |scenario: &Scenario, rows: &PathRows, form: PathForm, id: Option<&str>| -> FormatError {
        let options = WriteOptions { frame_id: id.map(str::to_owned) };
        write_path(scenario, rows, form, &options).expect_err("it is refused")
    };
    let good = rows(3, true);
    let changed = |change: fn(&mut PathRows)| {
        let mut rows = good.clone();
        change(&mut rows);
        let error = refuses(&scenario, &rows, PathForm::Csv, None);
        (error.code(), error.place().cloned())
    };
    let row = |i: usize| Some(Place::Element(format!("row {i}")));
    assert_eq!(changed(|rows| rows.configurations.clear()), (Code::Truncated, None));
    assert_eq!(changed(|rows| rows.configurations[1].truncate(2)), (Code::WrongColumns, row(1)));
    assert_eq!(changed(|rows| rows.configurations[2][0] = f64::NAN), (Code::InvalidNumber, row(2)));
    assert_eq!(changed(|rows| rows.timing.as_mut().expect("times").times.truncate(2)), (Code::WrongColumns, None));
    assert_eq!(
        changed(|rows| rows.timing.as_mut().expect("times").times[1] = f64::INFINITY),
        (Code::InvalidNumber, row(1))
    );
    assert_eq!(
        changed(|rows| rows.timing.as_mut().expect("times").velocities[0].push(1.0)),
        (Code::WrongColumns, row(0))
    );
    let mut late = good.clone();
    late.timing.as_mut().expect("times").times[2] = 3e9;
    let error = refuses(&scenario, &late, PathForm::NavPath, None);
    assert_eq!((error.code(), error.place().cloned()), (Code::InvalidNumber, row(2)));
    assert_eq!(refuses(&scenario, &good, PathForm::NavPath, Some("")).code(), Code::InvalidOption);
    let error = refuses(&scenario, &good, PathForm::Svg, Some("odom"));
    assert!(error.code() == Code::InvalidOption && error.message().contains("\"odom\""), "{error}");
    for form in [PathForm::GeoJson, PathForm::NavPath, PathForm::NavWaypoints] {
        let error = refuses(&floor(arm(), MapFrame::default()), &rows(2, false), form, None);
        assert!(error.code() == Code::InvalidOption && error.message().contains(form.as_str()), "{error}");
    }
    let many = PathRows { query: "any".to_owned(), configurations: vec![Vec::new(); 2_000_001], timing: None };
    assert_eq!(refuses(&scenario, &many, PathForm::Csv, None).code(), Code::WorldTooLarge);
    assert!(MapFrame::new([f64::NAN, 0.0], None).is_err());
    for (scale, pointer) in [([0.0, 1.0], "/plane/scale/0"), ([1.0, -1.0], "/plane/scale/1")] {
        let plane = MapPlane { origin: [0.0; 2], scale, degrees: false };
        let error = MapFrame::new([0.0; 2], Some(plane)).expect_err("it is refused");
        assert_eq!((error.code(), error.pointer()), (planarium::error::Code::OutOfRange, pointer));
    }
}

/// What a Python program prints about bytes.
fn told(modules: &str, form: &str, bytes: &[u8]) -> Option<String> {
    let python = python(modules)?;
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/written.py");
    let mut child = Command::new(python)
        .args([script, form])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    std::io::Write::write_all(&mut child.stdin.take().expect("a pipe"), bytes).expect("it reads");
    let output = child.wait_with_output().expect("the program ends");
    assert!(output.status.success(), "{form}");
    Some(String::from_utf8(output.stdout).expect("text"))
}

/// A frame with a name that YAML could take for something else.
const ODD: &str = "robot_1/map: \"no\" # 1 \u{7f}\u{9b}\u{2028}";

#[test]
fn programs_of_others_read_every_form() {
    let [_, moved, ..] = frames();
    let scenario = floor(body(), moved);
    let rows = rows(3, true);
    let modules = [
        (PathForm::Csv, "csv"),
        (PathForm::Json, "json"),
        (PathForm::GeoJson, "json"),
        (PathForm::Svg, "xml"),
        (PathForm::Npy, "numpy"),
        (PathForm::NavPath, "yaml"),
        (PathForm::NavWaypoints, "yaml"),
    ];
    assert_eq!(modules.len(), PathForm::ALL.len());
    for (form, modules) in modules {
        let is_of_ros = modules == "yaml";
        let options = WriteOptions { frame_id: is_of_ros.then(|| ODD.to_owned()) };
        let bytes = write_path(&scenario, &rows, form, &options).expect("it is written");
        let Some(told) = told(modules, form.as_str(), &bytes) else { continue };
        let numbers: Vec<Vec<f64>> = told
            .lines()
            .skip(1)
            .map(|line| line.split(' ').map(|word| word.parse().expect("a number")).collect())
            .collect();
        let wanted = match form {
            PathForm::Csv => "t_s x_m y_m theta_rad vx_m_s vy_m_s omega_rad_s".to_owned(),
            PathForm::Json => "t[s] x[m] y[m] theta[rad] vx[m/s] vy[m/s] omega[rad/s]".to_owned(),
            PathForm::GeoJson => "start goal 3".to_owned(),
            PathForm::Svg => "floor <1> & \"more\", any".to_owned(),
            PathForm::Npy => "float64 (3, 4)".to_owned(),
            _ => ODD.to_owned(),
        };
        assert_eq!(told.lines().next(), Some(&*wanted));
        assert_eq!(numbers.len(), 3, "{told}");
        // Where the place begins in a row, and whether the heading follows as an angle; a drawing is in the scenario.
        let (at, frame) = match form {
            PathForm::Csv | PathForm::Json | PathForm::Npy => (1, moved),
            PathForm::Svg => (0, MapFrame::default()),
            _ => (0, moved),
        };
        for (found, q) in numbers.iter().zip(&rows.configurations) {
            assert_eq!(found[at..at + 2], frame.to_metres([q[0], q[1]]), "{form:?}");
            if form != PathForm::Svg {
                assert!(planarium::geometry::wrap(found[at + 2] - q[2]).abs() < 1e-15, "{form:?}: {found:?}");
            }
        }
        if form == PathForm::NavPath {
            let stamps: Vec<f64> = numbers.iter().map(|row| row[3]).collect();
            assert_eq!(stamps, [0.0, 0.25, 2.0]);
        }
    }
}
