//! Real files: every raster and table of the folder that `PLANARIUM_WORLDS` names is read, compared with its bytes at
//! random points by code that has nothing in common with the readers, and planned in. A table of sizes and times is
//! printed.

use crate::documents::{deep, needed};
use crate::files::{Places, Random, file};
use crate::planning::plan;
use planarium::geometry::Point;
use planarium::problem::Status;
use planarium_formats::{Cell, Options, RobotChoice, Unknown, World, read};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// How many points of each raster are compared.
const POINTS: usize = 100_000;

/// The files of a folder whose names end like this.
fn files(folder: &str, end: &str) -> Option<Vec<PathBuf>> {
    let folder = Path::new(&needed("PLANARIUM_WORLDS")?).join(folder);
    let entries = std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("a file").path()).collect();
    paths.retain(|path| path.to_string_lossy().ends_with(end));
    paths.sort();
    assert!(!paths.is_empty(), "{} has no file *{end}", folder.display());
    Some(paths)
}

/// A world of files, and how long reading took.
#[track_caller]
fn world(paths: &[&Path], options: &Options) -> (World, f64) {
    let contents: Vec<(String, Vec<u8>)> =
        paths.iter().map(|path| (path.to_string_lossy().into_owned(), std::fs::read(path).expect("a file"))).collect();
    let all: Vec<_> = contents.iter().map(|(name, bytes)| file(name, bytes)).collect();
    let started = Instant::now();
    let world = read(&all, options).unwrap_or_else(|error| panic!("{error}"));
    (world, started.elapsed().as_secs_f64())
}

/// A row of the table: what was read, and the first path.
fn row(name: &str, robot: &str, world: &World, seconds: f64, path: &str) {
    let size = world.report.grid.as_ref().map_or("–".to_owned(), |grid| format!("{} x {}", grid.width, grid.height));
    let obstacles = world.scenario.world().obstacles.len();
    println!("| {name} | {size} | {obstacles} | {:.1} | {robot} | {path} |", 1e3 * seconds);
}

/// Plans for the query and returns the words for the table; the path is verified.
fn timed(world: &World, planner: Option<&str>, query: &str) -> (Status, String) {
    let started = Instant::now();
    let status =
        plan(&world.scenario, planner, query).unwrap_or_else(|error| panic!("{}: {error}", world.scenario.name()));
    let seconds = started.elapsed().as_secs_f64();
    (status, if status == Status::Solved { format!("{:.1}", 1e3 * seconds) } else { "none".to_owned() })
}

/// Compares the scenario with free cells, told by column and row from the top, at random points.
fn agrees(
    world: &World,
    width: usize,
    height: usize,
    to_cells: impl Fn(Point) -> [f64; 2],
    is_free: impl Fn(usize, usize) -> bool,
) {
    let bounds = world.scenario.world().bounds.expect("bounds");
    let places = Places::of(&world.scenario);
    let mut random = Random(5);
    let mut compared = 0;
    while compared < POINTS {
        let p = Point::new(
            bounds.min.x + random.unit() * (bounds.max.x - bounds.min.x),
            bounds.min.y + random.unit() * (bounds.max.y - bounds.min.y),
        );
        let [column, row] = to_cells(p);
        if [column, row].iter().any(|at| (at - at.round()).abs() < 1e-6) {
            continue;
        }
        let inside = column > 0.0 && row > 0.0 && column < width as f64 && row < height as f64;
        let wanted = inside && is_free(column as usize, row as usize);
        assert_eq!(places.is_free(p), wanted, "{}: {p}", world.scenario.name());
        compared += 1;
    }
}

/// The number after a key of a YAML file.
fn value(yaml: &str, key: &str) -> f64 {
    let line = yaml.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(':')).expect("a key");
    line.trim().parse().expect("a number")
}

/// Width, height and brightness of a picture.
fn brightness(path: &Path) -> (usize, usize, Vec<f64>) {
    let bytes = std::fs::read(path).expect("a picture");
    if bytes.starts_with(b"P5") {
        let pixels = |width: usize, height: usize| {
            bytes[bytes.len() - width * height..].iter().map(|&v| f64::from(v) / 255.0).collect()
        };
        let text = String::from_utf8_lossy(&bytes[..200.min(bytes.len())]).into_owned();
        let numbers: Vec<usize> = text
            .lines()
            .skip(1)
            .filter(|line| !line.starts_with('#'))
            .flat_map(str::split_whitespace)
            .map_while(|word| word.parse().ok())
            .collect();
        return (numbers[0], numbers[1], pixels(numbers[0], numbers[1]));
    }
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG");
    let mut data = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut data).expect("pixels");
    assert_eq!((info.color_type, info.bit_depth), (png::ColorType::Rgb, png::BitDepth::Eight));
    let pixels = data.chunks(3).map(|rgb| rgb.iter().map(|&v| f64::from(v)).sum::<f64>() / 765.0).collect();
    (info.width as usize, info.height as usize, pixels)
}

#[test]
fn ros_maps_agree_with_their_pictures_and_are_planned_in() {
    let Some(paths) = files("ros", ".yaml") else { return };
    for path in paths {
        let yaml = std::fs::read_to_string(&path).expect("text");
        let image =
            yaml.lines().find_map(|line| line.strip_prefix("image:")).expect("a picture").trim().trim_matches('"');
        let mut images = vec![path.with_file_name(image)];
        images.extend(Some(images[0].with_extension("pgm")).filter(|pgm| *pgm != images[0] && pgm.exists()));
        for image in images {
            let name = image.file_name().expect("a name").to_string_lossy().into_owned();
            let yaml = yaml.replace("testmap.png", &name);
            let origin: Vec<f64> = {
                let line = yaml.lines().find_map(|line| line.strip_prefix("origin:")).expect("an origin").trim();
                line.trim_matches(['[', ']'])
                    .split(',')
                    .map(|number| number.trim().parse().expect("a number"))
                    .collect()
            };
            let (resolution, free, occupied) =
                (value(&yaml, "resolution"), value(&yaml, "free_thresh"), value(&yaml, "occupied_thresh"));
            let (width, height, pixels) = brightness(&image);
            let bytes = std::fs::read(&image).expect("a picture");
            let yaml_name = path.to_string_lossy().into_owned();
            let all = [file(&yaml_name, &yaml), file(&name, &bytes)];
            for unknown in [Unknown::Occupied, Unknown::Free] {
                let options = Options { unknown, ..Options::default() };
                let started = Instant::now();
                let world = read(&all, &options).unwrap_or_else(|error| panic!("{error}"));
                let seconds = started.elapsed().as_secs_f64();
                let (sin, cos) = origin[2].sin_cos();
                let to_cells = |p: Point| {
                    let [x, y] = [p.x - origin[0], p.y - origin[1]];
                    [(cos * x + sin * y) / resolution, height as f64 - (cos * y - sin * x) / resolution]
                };
                let is_free = |column: usize, row: usize| {
                    let dark = 1.0 - pixels[row * width + column];
                    if unknown == Unknown::Free { dark <= occupied } else { dark < free }
                };
                agrees(&world, width, height, to_cells, is_free);
                if unknown == Unknown::Occupied {
                    println!("{}", world.report);
                    planned(&name, &all, &world, seconds);
                }
            }
        }
    }
}

/// Plans in a map of ROS for a disc and for a footprint, between random free places.
fn planned(name: &str, all: &[planarium_formats::File], world: &World, seconds: f64) {
    // The widest disc through tb3_sandbox has a radius of 0.39 m; testmap is a metre wide.
    let [radius, length, width] = match name {
        _ if name.starts_with("testmap") => [0.04, 0.08, 0.05],
        _ if name.starts_with("tb3") => [0.2, 0.5, 0.4],
        _ => [0.2, 0.9, 0.62],
    };
    let robots = [
        (RobotChoice::Disc { radius }, format!("disc, radius {radius} m")),
        (RobotChoice::rectangle(length, width), format!("{length} x {width} m")),
    ];
    let bounds = world.scenario.world().bounds.expect("bounds");
    let mut random = Random(21);
    let grid = world.grid.as_ref().expect("cells");
    let mut place = || loop {
        let x = bounds.min.x + random.unit() * (bounds.max.x - bounds.min.x);
        let p = Point::new(x, bounds.min.y + random.unit() * (bounds.max.y - bounds.min.y));
        if grid.cell_at(p) == Some(Cell::Free) {
            return vec![p.x, p.y];
        }
    };
    for (robot, words) in robots {
        let solved = (0..400).any(|_| {
            let options =
                Options { robot: robot.clone(), start: Some(place()), goal: Some(place()), ..Options::default() };
            let world = read(all, &options).unwrap_or_else(|error| panic!("{error}"));
            let started = Instant::now();
            // The start or the goal may be too near to an obstacle.
            let Ok(Status::Solved) = plan(&world.scenario, Some("rrt-connect"), "given") else { return false };
            row(name, &words, &world, seconds, &format!("{:.1}", 1e3 * started.elapsed().as_secs_f64()));
            true
        });
        assert!(solved, "{name}: no path for {words}");
    }
}

#[test]
fn movingai_maps_agree_with_their_letters_and_are_planned_in() {
    let Some(paths) = files("movingai", ".map") else { return };
    for path in paths {
        let scen = path.with_extension("map.scen");
        let options = Options { robot: RobotChoice::Disc { radius: 0.3 }, ..Options::default() };
        let (world, seconds) = world(&[&scen, &path], &options);
        println!("{}", world.report);
        let text = std::fs::read_to_string(&path).expect("text");
        let rows: Vec<&[u8]> = text.lines().skip(4).map(str::as_bytes).collect();
        let height = rows.len();
        agrees(
            &world,
            rows[0].len(),
            height,
            |p| [p.x, height as f64 - p.y],
            |column, row| b".GS".contains(&rows[row][column]),
        );
        assert_eq!(world.report.queries.len(), std::fs::read_to_string(&scen).expect("text").lines().count() - 1);
        assert!(world.report.queries.iter().all(|query| !query.blocked));
        let last = world.report.queries.last().expect("queries").clone();
        let (status, words) = timed(&world, Some("rrt-connect"), &last.name);
        assert_eq!(status, Status::Solved);
        row(&path.file_name().expect("a name").to_string_lossy(), "disc, radius 0.3 m", &world, seconds, &words);
    }
}

#[test]
fn parking_cases_are_read_and_most_are_solved() {
    let Some(mut paths) = files("tpcap", ".csv") else { return };
    paths.retain(|path| path.file_name().is_some_and(|name| name.to_string_lossy().starts_with("Case")));
    let mut solved = 0;
    for path in &paths {
        let (world, seconds) = world(&[path], &Options::default());
        let text = std::fs::read_to_string(path).expect("text");
        let numbers: Vec<f64> = text.trim().split(',').map(|word| word.parse().expect("a number")).collect();
        let [x, y] = world.report.offset;
        let start = &world.scenario.queries()[0].start;
        assert_eq!((start[0] + x, start[1] + y, start[2]), (numbers[0], numbers[1], numbers[2]), "the offset undone");
        assert_eq!(world.report.obstacles.polygons, numbers[6] as usize);
        // The slot of case 7 is so tight that a path takes a minute.
        if path.ends_with("Case7.csv") && !deep() {
            continue;
        }
        let (status, words) = timed(&world, Some("rrt-connect"), "park");
        solved += usize::from(status == Status::Solved);
        row(&path.file_name().expect("a name").to_string_lossy(), "its car", &world, seconds, &words);
    }
    assert_eq!(paths.len(), 20);
    assert!(solved >= 19, "{solved} of {} are solved", paths.len());
}

#[test]
fn the_files_of_ompl_are_read_and_planned_in() {
    let Some(paths) = files("ompl", ".txt") else { return };
    let find = |name: &str| paths.iter().find(|path| path.ends_with(name)).expect("a file");
    let (grid, seconds) = world(&[find("env1.txt")], &Options::default());
    let (status, words) = timed(&grid, Some("rrt-connect"), "start to end");
    assert_eq!(status, Status::Solved);
    row("env1.txt", "a point", &grid, seconds, &words);
    let (circles, seconds) = world(&[find("circle_obstacles.txt"), find("circle_queries.txt")], &Options::default());
    println!("{}", circles.report);
    assert_eq!(circles.report.queries.len(), 100);
    let mut slowest = 0.0f64;
    for query in circles.scenario.queries() {
        let started = Instant::now();
        assert_eq!(plan(&circles.scenario, Some("rrt-connect"), &query.name).expect("a run"), Status::Solved);
        slowest = slowest.max(started.elapsed().as_secs_f64());
    }
    row("circle_obstacles.txt", "a point, 100 queries", &circles, seconds, &format!("{:.1} at most", 1e3 * slowest));
}

#[test]
fn plans_of_buildings_are_read_and_planned_in() {
    let mut paths = Vec::new();
    for (folder, end) in [("geojson", ".geojson"), ("wkt", ".wkt"), ("rmf", ".building.yaml")] {
        let Some(found) = files(folder, end) else { return };
        paths.extend(found);
    }
    for path in &paths {
        let (empty, seconds) = world(&[path], &Options::default());
        println!("{}", empty.report);
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        let robots = [
            (RobotChoice::Disc { radius: 0.2 }, "disc, radius 0.2 m"),
            (RobotChoice::rectangle(0.5, 0.4), "0.5 x 0.4 m"),
        ];
        for (robot, words) in robots {
            let (status, time) = between_places(path, &empty, &robot);
            assert_eq!(status, Status::Solved, "{name}: no path for {words}");
            row(&name, words, &empty, seconds, &time);
        }
    }
}

/// Plans between two random places far from each other: starts that are not free are passed over.
fn between_places(path: &Path, empty: &World, robot: &RobotChoice) -> (Status, String) {
    let bounds = empty.scenario.world().bounds.expect("bounds");
    let mut random = Random(21);
    let mut place = || {
        let x = bounds.min.x + random.unit() * (bounds.max.x - bounds.min.x);
        Point::new(x, bounds.min.y + random.unit() * (bounds.max.y - bounds.min.y))
    };
    // Start and goal are in coordinates of the file: degrees, where these are degrees.
    let to_file = |p: Point| match empty.report.plane.as_ref().filter(|plane| plane.error.is_some()) {
        Some(plane) => (0..2).map(|i| plane.origin[i] + (p[i] + empty.report.offset[i]) / plane.scale[i]).collect(),
        None => vec![p.x, p.y],
    };
    for _ in 0..100 {
        let (from, to) = (place(), place());
        if (to - from).norm() < 0.3 * (bounds.max - bounds.min).norm() {
            continue;
        }
        let options =
            Options { robot: robot.clone(), start: Some(to_file(from)), goal: Some(to_file(to)), ..Options::default() };
        let (world, _) = world(&[path], &options);
        let started = Instant::now();
        if let Ok(Status::Solved) = plan(&world.scenario, Some("rrt-connect"), "given") {
            return (Status::Solved, format!("{:.1}", 1e3 * started.elapsed().as_secs_f64()));
        }
    }
    (Status::Exhausted, "none".to_owned())
}
