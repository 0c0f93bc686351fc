//! Drawings against other libraries: at random points, nothing is free that the file has within a shape, and nothing that
//! is farther from all shapes than curves may grow is an obstacle. Skipped aloud where Python does not have them.

use crate::documents::needed;
use crate::dxf::document;
use crate::files::{Places, Random, file, python};
use crate::planning::plan;
use planarium::geometry::Point;
use planarium::problem::Status;
use planarium_formats::{Options, RobotChoice, World, read};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// Compares a file at random points. `metres` is the length of a pixel or a unit, `wide` half of the widest line.
fn compare(python: &str, path: &Path, metres: f64, wide: f64, options: &Options) {
    let bytes = std::fs::read(path).expect("a file");
    let name = path.to_string_lossy();
    let world = read(&[file(&name, &bytes)], options).unwrap_or_else(|error| panic!("{error}"));
    let larger = 2.0 * options.tolerance.expect("a tolerance") + wide;
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/drawings.py");
    let thickness = options.wall_thickness.unwrap_or(0.0);
    let numbers = [metres, larger, thickness].map(|number| number.to_string());
    let output = Command::new(python).arg(script).arg(path).args(numbers).output().expect("Python");
    assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    let places = Places::of(&world.scenario);
    let [x, y] = world.report.offset;
    let mut counts = [0, 0];
    for line in String::from_utf8(output.stdout).expect("text").lines() {
        let numbers: Vec<f64> = line.split(' ').map(|word| word.parse().expect("a number")).collect();
        let p = Point::new(numbers[1] - x, numbers[2] - y);
        let is_inside = numbers[0] == 1.0;
        counts[usize::from(is_inside)] += 1;
        assert_eq!(places.is_free(p), !is_inside, "{name} at {p}");
    }
    println!("{name}: {} points within shapes, {} far from them", counts[1], counts[0]);
    assert!(counts[1] > 100, "{name}");
}

/// Writes a file beside those of other tests.
fn written(name: &str, text: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let path = folder.join(name);
    std::fs::write(&path, text).expect("a folder for files of tests");
    path
}

/// A drawing with curves, transforms, rules and strokes.
pub const DRAWING: &str = "<svg xmlns='http://www.w3.org/2000/svg' width='200' height='100' viewBox='0 0 200 100'>
  <path d='M10 10C40 15 0 35 30 40S50 10 60 20L40 5Z' fill='black'/>
  <path d='M100 30A20 15 30 1 1 60 30A20 15 30 0 1 100 30Z M90 30A10 6 0 1 0 70 30A10 6 0 1 0 90 30Z' fill-rule='evenodd'/>
  <g transform='translate(120 10) rotate(20) skewX(15) scale(1.5 .8)'><rect width='30' height='20' rx='6' ry='3'/>
    <path d='M0 30Q10 50 20 30T40 30' fill='none' stroke='black' stroke-width='3' stroke-linejoin='round'/></g>
  <polyline points='10,60 40,60 40,80 20,90 60,95' fill='none' stroke='black' stroke-width='4'/>
  <ellipse cx='90' cy='75' rx='15' ry='8' stroke='black' stroke-width='2'/>
  <circle cx='130' cy='80' r='9' fill='none' stroke='black' stroke-width='3'/>
  <polygon points='160,60 190,60 165,80 175,50 187,80' fill='black'/>
  <line x1='150' y1='92' x2='190' y2='92' stroke='black' stroke-width='5' stroke-linecap='square'/>
</svg>";

#[test]
fn svg_agrees_with_another_reader() {
    let Some(python) = python("svgelements, ezdxf, shapely") else { return };
    let path = written("drawing.svg", DRAWING);
    for tolerance in [1.0, 0.01] {
        let options = Options { tolerance: Some(tolerance), ..Options::default() };
        compare(&python, &path, 1.0, 2.5, &options);
    }
    let Some(worlds) = needed("PLANARIUM_WORLDS") else { return };
    for name in ["car", "parking1", "warehouse", "warehouse_robot"] {
        let path = Path::new(&worlds).join("svg").join(name).with_extension("svg");
        // A unit is a millimetre; as a metre, a pixel is longer.
        let options = Options { tolerance: Some(1e-3), scale: Some(1.0), ..Options::default() };
        compare(&python, &path, 25.4 / 96.0, 0.01, &options);
    }
}

#[test]
fn dxf_agrees_with_another_reader() {
    let Some(python) = python("svgelements, ezdxf, shapely") else { return };
    let blocks =
        "0 BLOCK 8 0 2 b 70 0 10 1 20 0 30 0 3 b 0 LINE 100 AcDbEntity 8 0 100 AcDbLine 10 0 20 0 11 5 21 0 0 ARC 100 AcDbEntity 8 0 100 AcDbCircle 10 5 20 5 40 5 100 AcDbArc 50 270 51 30
         0 LWPOLYLINE 100 AcDbEntity 8 0 100 AcDbPolyline 90 3 70 1 10 0 20 0 42 0.4 10 4 20 0 42 -0.3 10 4 20 6 0 ENDBLK 8 0";
    let text = document(
        "9 $ACADVER 1 AC1015",
        "",
        blocks,
        "0 INSERT 100 AcDbEntity 8 a 100 AcDbBlockReference 2 b 10 0 20 0 0 INSERT 100 AcDbEntity 8 a 100 AcDbBlockReference 2 b 10 30 20 0 41 2 42 0.5 43 1 50 30
         0 INSERT 100 AcDbEntity 8 a 100 AcDbBlockReference 2 b 10 -20 20 20 210 0 220 0 230 -1 0 INSERT 100 AcDbEntity 8 a 100 AcDbBlockReference 2 b 10 0 20 30 41 -1 42 1 43 1 50 200
         0 ELLIPSE 100 AcDbEntity 8 a 100 AcDbEllipse 10 60 20 30 30 0 11 8 21 4 31 0 210 0 220 0 230 1 40 0.3 41 1 42 5
         0 SPLINE 100 AcDbEntity 8 a 100 AcDbSpline 210 0 220 0 230 1 70 8 71 3 72 9 73 5 74 0 40 0 40 0 40 0 40 0 40 0.7 40 1 40 1 40 1 40 1
           10 60 20 0 30 0 10 60 20 10 30 0 10 70 20 10 30 0 10 70 20 0 30 0 10 80 20 5 30 0
         0 SOLID 100 AcDbEntity 8 a 100 AcDbTrace 10 80 20 20 30 0 11 90 21 20 31 0 12 80 22 30 32 0 13 90 23 30 33 0
         0 LWPOLYLINE 100 AcDbEntity 8 a 100 AcDbPolyline 90 3 70 0 43 2 10 80 20 40 10 90 20 40 10 90 20 50",
    );
    let path = written("drawing.dxf", &text);
    let options = |tolerance| Options { tolerance: Some(tolerance), wall_thickness: Some(0.3), ..Options::default() };
    for tolerance in [0.3, 0.01] {
        compare(&python, &path, 1.0, 2.0, &options(tolerance));
    }
    let Some(worlds) = needed("PLANARIUM_WORLDS") else { return };
    for name in ["Gallery", "ISO-Office"] {
        compare(&python, &Path::new(&worlds).join("dxf").join(name).with_extension("dxf"), 1.0, 0.2, &options(0.01));
    }
}

/// A scenario with a path between two places that are a third of its size apart, and the milliseconds that reading and
/// planning took.
fn planned(path: &Path, options: &Options) -> Option<(World, [f64; 2])> {
    let bytes = std::fs::read(path).expect("a file");
    let name = path.to_string_lossy();
    let open = |options: &Options| read(&[file(&name, &bytes)], options).unwrap_or_else(|error| panic!("{error}"));
    let started = Instant::now();
    let bounds = open(options).scenario.world().bounds.expect("bounds");
    let read = 1e3 * started.elapsed().as_secs_f64();
    let mut random = Random(3);
    let mut place = || {
        let x = bounds.min.x + random.unit() * (bounds.max.x - bounds.min.x);
        vec![x, bounds.min.y + random.unit() * (bounds.max.y - bounds.min.y)]
    };
    (0..200).find_map(|_| {
        let (start, goal) = (place(), place());
        let size = (bounds.max - bounds.min).norm();
        if (start[0] - goal[0]).hypot(start[1] - goal[1]) < size / 3.0 {
            return None;
        }
        let world = open(&Options { start: Some(start), goal: Some(goal), ..options.clone() });
        let started = Instant::now();
        let status = plan(&world.scenario, Some("rrt-connect"), "given");
        (status == Ok(Status::Solved)).then(|| (world, [read, 1e3 * started.elapsed().as_secs_f64()]))
    })
}

#[test]
fn drawings_are_read_and_planned_in() {
    let Some(worlds) = needed("PLANARIUM_WORLDS") else { return };
    let disc = |radius: f64| RobotChoice::Disc { radius };
    let in_metres = Options { scale: Some(1.0), ..Options::default() };
    let of_layers = |names: &[&str]| Options {
        layers: Some(names.iter().map(|name| (*name).to_owned()).collect()),
        wall_thickness: Some(0.1),
        ..Options::default()
    };
    let cases = [
        ("svg/parking1.svg", in_metres.clone(), disc(0.2), "disc, radius 0.2 m"),
        ("svg/parking1.svg", in_metres.clone(), RobotChoice::rectangle(0.9, 0.62), "0.9 x 0.62 m"),
        ("svg/warehouse.svg", in_metres.clone(), disc(0.2), "disc, radius 0.2 m"),
        ("svg/warehouse.svg", in_metres, RobotChoice::rectangle(0.9, 0.62), "0.9 x 0.62 m"),
        ("dxf/Gallery.dxf", of_layers(&["jps-obstacles"]), disc(0.2), "disc, radius 0.2 m"),
        ("dxf/Gallery.dxf", of_layers(&["jps-obstacles"]), RobotChoice::rectangle(0.9, 0.62), "0.9 x 0.62 m"),
        ("dxf/ISO-Office.dxf", of_layers(&["jps-obstacles", "walkablearea"]), disc(0.2), "disc, radius 0.2 m"),
        ("dxf/ISO-Office.dxf", of_layers(&["jps-obstacles"]), RobotChoice::rectangle(0.5, 0.4), "0.5 x 0.4 m"),
    ];
    for (name, options, robot, words) in cases {
        let path = Path::new(&worlds).join(name);
        let (world, [read, planned]) =
            planned(&path, &Options { robot, ..options }).unwrap_or_else(|| panic!("{name}: no path"));
        let name = path.file_name().expect("a name").to_string_lossy();
        println!("| `{name}` | – | {} | {read:.1} | {words} | {planned:.1} |", world.scenario.world().obstacles.len());
    }
}
