//! Whole runs of planners: how many were solved, milliseconds, work and lengths, a row for each planner. All runs count, solved or
//! not; every path is checked by the verifier. Milliseconds are for comparison within one table; a run pinned to one core is quieter.
//!
//! `cargo bench --bench planning` prints all tables, `-- reports` and so on one of them:
//! - `reports`: the roadmaps of the course reports and RRT-Connect on generated triangle forests;
//! - `control`: planning by controls for the cars of generated worlds, by default options and presets;
//! - `seeds`: every query of bodies and cars, every planner that applies, default options.
//!
//! `-- steps` prints, for every planner in generated worlds of all robots or in those of a folder: how the run ended, its work and its
//! milliseconds, which should be alike (a unit of work is about a microsecond), and the longest step by its milliseconds, its work and
//! its motion checks. Runs end at a tenth of the default limit; planners that go on to shorter paths do so until then.
//!
//! `cargo bench --bench planning --features parallel -- threads` compares several threads with one on large roadmaps.
//!
//! `seeds` reads a folder of scenarios, given as an argument or by `PLANARIUM_SCENARIOS`; `control` takes its cars from one that
//! is given as an argument. Arguments such as `"rrt-control blossom=3"` replace the planners of `control`. `--seeds N` sets the
//! number of seeds, `--only TEXT` selects those rows of `seeds` whose scenario, query or planner contains the text, and `--out DIR`
//! writes one result in ten under the name of its scenario, for other verifiers.

use planarium::Error;
use planarium::path::{Verdict, verify};
use planarium::planner::{ByControls, PlannerKind, RrtControlOptions, Termination};
use planarium::run::{self, Request, Run, Status, Value, planners};
use planarium::scenario::{Robot, Scenario, generate::generate};
use serde_json::json;
use std::path::PathBuf;
use std::time::Instant;

/// The most iterations if a path need not exist: beyond, a search would only measure the budget.
const MOST: u64 = 20_000;

/// A planner: its name in the table, its id, and the options besides the defaults.
type Planner = (String, String, Vec<(String, Value)>);

/// A world: its name, and the scenario.
type World = (String, Scenario);

#[derive(Default)]
struct Arguments {
    table: Option<String>,
    worlds: Vec<World>,
    planners: Vec<Planner>,
    seeds: Option<u64>,
    only: String,
    out: Option<PathBuf>,
}

impl Arguments {
    fn read() -> Self {
        let mut read = Self::default();
        let mut words = std::env::args().skip(1);
        while let Some(word) = words.next() {
            let mut value = || words.next().expect("a value after its name");
            match word.as_str() {
                "--bench" => {}
                "--seeds" => read.seeds = Some(value().parse().expect("a number")),
                "--only" => read.only = value(),
                "--out" => read.out = Some(value().into()),
                "reports" | "control" | "seeds" | "threads" | "steps" => read.table = Some(word),
                _ if PathBuf::from(&word).is_dir() => read.worlds = stored(&word),
                _ => read.planners.push(planner(&word)),
            }
        }
        read
    }
}

/// The scenarios in a folder.
fn stored(folder: &str) -> Vec<World> {
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("so can its entries").path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
    files.sort();
    let world = |file: PathBuf| {
        let name = file.file_stem().expect("a file has a name").to_string_lossy().into_owned();
        // Lists of configurations are not scenarios.
        Some((name, Scenario::parse(&std::fs::read_to_string(&file).expect("the file is text")).ok()?))
    };
    files.into_iter().filter_map(world).collect()
}

/// A planner and its settings in a line.
fn planner(line: &str) -> Planner {
    let mut words = line.split_whitespace();
    let id = words.next().expect("a planner").to_owned();
    let parameters = words.map(|word| {
        let (name, value) = word.split_once('=').expect("name=value");
        (name.to_owned(), Value::from_text(value))
    });
    (line.to_owned(), id, parameters.collect())
}

fn main() {
    let arguments = Arguments::read();
    if arguments.table.as_deref() == Some("threads") {
        return threads();
    }
    if arguments.table.as_deref() == Some("steps") {
        return steps(&arguments);
    }
    println!(
        "| world | planner | solved | ms: median | quartiles | 95 % | slowest | mean | iterations | motions | 95 % | vertices | \
         edges | length |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
    let is_wanted = |name: &str| arguments.table.as_deref().is_none_or(|table| table == name);
    if is_wanted("reports") {
        reports(&arguments);
    }
    if is_wanted("control") {
        control(&arguments);
    }
    if is_wanted("seeds") {
        seeds(&arguments);
    }
}

#[cfg(not(feature = "parallel"))]
fn threads() {
    panic!("threads need the feature \"parallel\"");
}

/// Prints a line of JSON for two threads, and for one per core if there are more: the mean milliseconds of roadmaps of 10,000
/// samples, k = 30, in forests of four links, each the least of several runs in turns with one thread, and the ratio.
#[cfg(feature = "parallel")]
fn threads() {
    use std::num::NonZeroUsize;
    let cores = std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let counts: Vec<usize> = [1, 2].into_iter().chain((cores > 2).then_some(cores)).collect();
    let (_, id, parameters) = planner("prm samples=10000 k=30 max_iterations=1000000");
    let mut means = vec![0.0; counts.len()];
    let forests = worlds("forest", 3, |seed| json!({ "links": 4, "seed": seed }));
    for (_, scenario) in &forests {
        let request =
            Request { planner: Some(id.clone()), query: None, seed: 0, parameters: parameters.clone(), events: true };
        let mut least = vec![f64::INFINITY; counts.len()];
        let mut result = None;
        for _ in 0..7 {
            for (&threads, least) in counts.iter().zip(&mut least) {
                let mut run = begin(scenario, &request).expect("start and goal are free");
                run.set_threads(NonZeroUsize::new(threads).expect("at least one"));
                let began = Instant::now();
                run.step(u64::MAX);
                *least = least.min(began.elapsed().as_secs_f64() * 1e3);
                let ended = (run.fingerprint(), run.stats());
                assert_eq!(*result.get_or_insert(ended), ended, "threads change no result");
            }
        }
        means.iter_mut().zip(least).for_each(|(mean, least)| *mean += least / forests.len() as f64);
    }
    for (threads, mean) in counts.iter().zip(&means).skip(1) {
        println!("{}", json!({ "threads": threads, "one": means[0], "several": mean, "ratio": means[0] / mean }));
    }
}

/// Prints the table of steps: the first query of each world.
fn steps(arguments: &Arguments) {
    /// A tenth of the default limit of work.
    const MOST_WORK: u64 = 500_000;
    let mut scenes = arguments.worlds.clone();
    if scenes.is_empty() {
        for robot in ["arm", "disc", "rigid_body", "car"] {
            for kind in ["clutter", "gap"] {
                scenes.extend(worlds(kind, 1, |seed| json!({ "robot": robot, "seed": seed })));
            }
        }
        scenes.extend(worlds("forest", 1, |seed| json!({ "links": 6, "seed": seed })));
    }
    println!(
        "| world | planner | ended | iterations | work | ms | ms per 1000 units | longest step: ms | work | motions |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for (name, scenario) in &scenes {
        for planner in planners().iter().filter(|planner| planner.robots().contains(&scenario.robot().kind())) {
            let id = planner.info().id;
            if !format!("{name} {id}").contains(&arguments.only) {
                continue;
            }
            let goes_on = planner.group::<Termination>().is_some();
            let parameters =
                goes_on.then(|| ("improve_iterations".to_owned(), Value::Number(1e9))).into_iter().collect();
            let request = Request { planner: Some(id.to_owned()), seed: 1, parameters, ..Request::default() };
            let Ok(mut run) = begin(scenario, &request) else { continue };
            let (mut total, mut longest, mut heaviest, mut motions) = (0.0, 0.0f64, 0, 0);
            let mut before = run.stats();
            while run.status() == Status::Running && before.work < MOST_WORK {
                let began = Instant::now();
                run.step(1);
                let seconds = began.elapsed().as_secs_f64();
                let now = run.stats();
                (total, longest) = (total + seconds, longest.max(seconds));
                heaviest = heaviest.max(now.work - before.work);
                motions = motions.max(now.motion_checks - before.motion_checks);
                before = now;
            }
            let ended = run.reason().map_or(run.status().as_str(), |reason| reason.as_str());
            let (ms, work) = (total * 1e3, before.work);
            print!(
                "| {name} | {id} | {ended} | {} | {work} | {ms:.1} | {:.2} ",
                run.iterations(),
                ms / work as f64 * 1e3
            );
            println!("| {:.2} | {heaviest} | {motions} |", longest * 1e3);
        }
    }
}

fn reports(arguments: &Arguments) {
    for links in [2, 3, 4] {
        let forests = worlds("forest", 5, |seed| json!({ "links": links, "seed": seed }));
        let prm = planner(&format!("prm samples={} k=30", 300 * links - 200));
        for (planner, seeds) in [(prm, 7), (planner("rrt-connect"), 100)] {
            row(&format!("{links}R forests"), &forests, None, &planner, (seeds, MOST), arguments);
        }
    }
}

fn control(arguments: &Arguments) {
    let mut cars = arguments.worlds.clone();
    cars.retain(|(_, scenario)| matches!(scenario.robot(), Robot::Car(_)));
    if cars.is_empty() {
        let kinds = ["clutter", "discs", "gap"].into_iter();
        cars = kinds.flat_map(|kind| worlds(kind, 4, |seed| json!({ "robot": "car", "seed": seed }))).collect();
    }
    let mut planners = arguments.planners.clone();
    if planners.is_empty() {
        planners = ["rrt-control", "sst"].map(planner).to_vec();
        let presets = RrtControlOptions::INFO.presets.iter();
        planners.extend(presets.map(|preset| planner(&format!("rrt-control {}", preset.settings))));
    }
    for planner in &planners {
        row("cars", &cars, None, planner, (20, MOST), arguments);
    }
}

fn seeds(arguments: &Arguments) {
    let mut worlds = arguments.worlds.clone();
    if let (true, Ok(folder)) = (worlds.is_empty(), std::env::var("PLANARIUM_SCENARIOS")) {
        worlds = stored(&folder);
    }
    if worlds.is_empty() {
        println!("\nFor the table of seeds, name a folder of scenarios, or set PLANARIUM_SCENARIOS.");
    }
    for world @ (_, scenario) in worlds.iter().filter(|world| world.1.robot().placed_shape().is_some()) {
        for query in scenario.queries() {
            for planner in &all_planners(scenario.robot()) {
                let what = format!("{} {}", scenario.name(), query.name);
                if format!("{what} {}", planner.0).contains(&arguments.only) {
                    let world = std::slice::from_ref(world);
                    row(&what, world, Some(&query.name), planner, (100, u64::MAX), arguments);
                }
            }
        }
    }
}

/// Every planner that applies to the robot, with its defaults, or with both kinds of curves if it steers along curves; then the
/// presets of the course reports.
fn all_planners(robot: &Robot) -> Vec<Planner> {
    let mut all = Vec::new();
    for planner in planners().into_iter().filter(|planner| planner.robots().contains(&robot.kind())) {
        let info = planner.info();
        if !matches!(robot, Robot::Car(_)) || planner.group::<ByControls>().is_some() {
            all.push((info.title.to_owned(), info.id.to_owned(), Vec::new()));
            let name = |title| format!("{}: {title}", info.title);
            all.extend(info.presets.iter().map(|it| (name(it.title), info.id.to_owned(), it.parameters())));
            continue;
        }
        for (name, word) in [("Reeds-Shepp", "reeds-shepp"), ("Dubins", "dubins")] {
            // Visibility graphs need motions that can be reversed.
            if (info.id, word) != ("visibility-prm", "dubins") {
                let steering = ("steering".to_owned(), Value::Text(word.to_owned()));
                all.push((format!("{}, {name}", info.title), info.id.to_owned(), vec![steering]));
            }
        }
    }
    all
}

/// Worlds made by the generator of this name from the options for each seed.
fn worlds(kind: &str, count: u64, options: impl Fn(u64) -> serde_json::Value) -> Vec<World> {
    let world = |seed| generate(kind, &options(seed)).expect("a world can be generated");
    (0..count).map(world).map(|scenario| (scenario.name().to_owned(), scenario)).collect()
}

/// Prints the row of a planner: the query of that name, or all, of all worlds, by a number of seeds, each for at most a number of iterations.
fn row(
    what: &str,
    worlds: &[World],
    only: Option<&str>,
    (name, id, parameters): &Planner,
    (seeds, most): (u64, u64),
    arguments: &Arguments,
) {
    let seeds = arguments.seeds.unwrap_or(seeds);
    let (mut columns, mut lengths) = ([(); 5].map(|()| Vec::new()), Vec::new());
    let queries =
        worlds.iter().flat_map(|(file, scenario)| scenario.queries().iter().map(move |it| (file, scenario, it)));
    for (file, scenario, query) in queries.filter(|(.., query)| only.is_none_or(|only| only == query.name)) {
        for seed in 0..seeds {
            let (planner, query) = (Some(id.clone()), Some(query.name.clone()));
            let request = Request { planner, query, seed, parameters: parameters.clone(), ..Request::default() };
            let began = Instant::now();
            let mut run = begin(scenario, &request).unwrap_or_else(|error| panic!("{name}: {error}"));
            run.step(most);
            let (seconds, stats) = (began.elapsed().as_secs_f64(), run.stats());
            let counts = [stats.iterations, stats.motion_checks, stats.vertices, stats.edges].map(|count| count as f64);
            let numbers = [seconds * 1e3].into_iter().chain(counts);
            columns.iter_mut().zip(numbers).for_each(|(column, number)| column.push(number));
            if run.status() != Status::Solved {
                continue;
            }
            let result = run.result();
            lengths.push(result.length);
            let verdict = verify(scenario, &result).expect("the result is this scenario's");
            assert!(matches!(verdict, Verdict::Valid { .. }), "{file} {name} seed {seed}: {verdict:?}");
            if let Some(out) = arguments.out.as_ref().filter(|_| seed % 10 == 0) {
                std::fs::create_dir_all(out).expect("the folder can be made");
                let name = name.replace([' ', ',', '=', ':'], "-");
                let to = out.join(format!("{file}--{}--{name}--{seed}.json", result.query));
                std::fs::write(to, result.to_json()).expect("the result can be written");
            }
        }
    }
    columns.iter_mut().chain([&mut lengths]).for_each(|column| column.sort_by(f64::total_cmp));
    let at = |column: &[f64], part: f64| {
        column.get((column.len().saturating_sub(1) as f64 * part).round() as usize).copied().unwrap_or(f64::NAN)
    };
    let [times, iterations, motions, vertices, edges] = &columns;
    let [low, median, high, few, slowest] = [0.25, 0.5, 0.75, 0.95, 1.0].map(|part| at(times, part));
    let (count, mean) = (times.len(), times.iter().sum::<f64>() / times.len() as f64);
    print!("| {what} | {name} | {} of {count} | {median:.4} | {low:.4} to {high:.4} | {few:.2} ", lengths.len());
    print!("| {slowest:.1} | {mean:.2} | {} | {} | {} ", at(iterations, 0.5), at(motions, 0.5), at(motions, 0.95));
    println!("| {} | {} | {:.2} |", at(vertices, 0.5), at(edges, 0.5), at(&lengths, 0.5));
}

/// A run as it is requested.
fn begin(scenario: &Scenario, request: &Request) -> Result<Box<dyn Run>, Error> {
    run::start(scenario, &request.for_robot(scenario.robot())?)
}
