//! The success rate of bodies and cars: every query of a folder of scenarios, every planner that applies, a hundred seeds, with
//! default options; every path checked by the verifier.
//!
//! `cargo bench --bench seeds -- FOLDER` (or `PLANARIUM_SCENARIOS`) prints a table; `--seeds N` takes so many, `--only TEXT`
//! those rows whose scenario, query or planner contains the text, and `--out DIR` writes one result in ten with the file of
//! its scenario, for other verifiers. Milliseconds are for comparison within one table.

use planarium::path::{Verdict, verify};
use planarium::planner::ByControls;
use planarium::run::{Options, Status, Value, planners, start};
use planarium::scenario::{Robot, Scenario};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// A row of the table: its name, the planner, and the options besides the defaults.
type Arm = (String, &'static str, Vec<(String, Value)>);

/// Every planner that applies to the robot, with its defaults, or with both kinds of curves if it steers along curves; then the
/// presets of the course reports.
fn arms(robot: &Robot) -> Vec<Arm> {
    let fitting = planners().into_iter().filter(|planner| planner.robots().contains(&robot.kind()));
    let mut arms = Vec::new();
    for planner in fitting {
        let info = planner.info();
        if !matches!(robot, Robot::Car(_)) || planner.group::<ByControls>().is_some() {
            arms.push((info.title.to_owned(), info.id, Vec::new()));
            let name = |title| format!("{}: {title}", info.title);
            arms.extend(info.presets.iter().map(|preset| (name(preset.title), info.id, preset.parameters())));
            continue;
        }
        for (name, word) in [("Reeds-Shepp", "reeds-shepp"), ("Dubins", "dubins")] {
            // Visibility graphs need motions that can be reversed.
            if (info.id, word) != ("visibility-prm", "dubins") {
                let steering = ("steering".to_owned(), Value::Text(word.to_owned()));
                arms.push((format!("{}, {name}", info.title), info.id, vec![steering]));
            }
        }
    }
    arms
}

struct Arguments {
    folder: PathBuf,
    seeds: u64,
    only: String,
    out: Option<PathBuf>,
}

fn main() {
    let Some(arguments) = arguments() else {
        println!("Name a folder of scenarios, or set PLANARIUM_SCENARIOS.");
        return;
    };
    let entries = std::fs::read_dir(&arguments.folder).expect("the folder can be read");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("so can its entries").path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
    files.sort();
    println!("| scenario, query | planner | solved | median ms | slowest ms | median iterations | length |");
    println!("|---|---|---|---|---|---|---|");
    for file in files {
        let text = std::fs::read_to_string(&file).expect("the file is text");
        // Lists of configurations are not scenarios.
        let Ok(scenario) = Scenario::parse(&text) else { continue };
        if scenario.robot().placed_shape().is_none() {
            continue;
        }
        for query in scenario.queries() {
            for arm in &arms(scenario.robot()) {
                let what = format!("{} {} {}", scenario.name(), query.name, arm.0);
                if what.contains(&arguments.only) {
                    row(&file, &scenario, &query.name, arm, &arguments);
                }
            }
        }
    }
}

fn arguments() -> Option<Arguments> {
    let (mut folder, mut seeds, mut only, mut out) =
        (std::env::var_os("PLANARIUM_SCENARIOS").map(PathBuf::from), 100, String::new(), None);
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        match word.as_str() {
            "--seeds" => seeds = words.next()?.parse().ok()?,
            "--only" => only = words.next()?,
            "--out" => out = Some(PathBuf::from(words.next()?)),
            "--bench" => {}
            _ => folder = Some(PathBuf::from(word)),
        }
    }
    Some(Arguments { folder: folder?, seeds, only, out })
}

/// All seeds of one planner on one query.
fn row(file: &Path, scenario: &Scenario, query: &str, (name, planner, parameters): &Arm, arguments: &Arguments) {
    let (mut solved, mut times, mut iterations, mut lengths) = (0, Vec::new(), Vec::new(), Vec::new());
    for seed in 0..arguments.seeds {
        let options = Options {
            planner: Some((*planner).to_owned()),
            query: Some(query.to_owned()),
            seed,
            parameters: parameters.clone(),
        };
        let began = Instant::now();
        let mut run = start(scenario, &options).unwrap_or_else(|error| panic!("{name}: {error}"));
        run.step(u64::MAX);
        times.push(began.elapsed().as_secs_f64() * 1e3);
        iterations.push(run.iterations() as f64);
        if run.status() != Status::Solved {
            continue;
        }
        solved += 1;
        let result = run.result();
        lengths.push(result.length);
        let verdict = verify(scenario, &result).expect("the result is this scenario's");
        assert!(
            matches!(verdict, Verdict::Valid { .. }),
            "{} {query} {name} seed {seed}: {verdict:?}",
            scenario.name()
        );
        if let Some(out) = arguments.out.as_ref().filter(|_| seed % 10 == 0) {
            std::fs::create_dir_all(out).expect("the folder can be made");
            let stem = file.file_stem().expect("a file has a name").to_string_lossy();
            let to = out.join(format!("{stem}--{query}--{}--{seed}.json", name.replace([' ', ',', '=', ':'], "-")));
            std::fs::write(to, result.to_json()).expect("the result can be written");
        }
    }
    println!(
        "| {} {query} | {name} | {solved} of {} | {:.2} | {:.1} | {} | {:.2} |",
        scenario.name(),
        arguments.seeds,
        quantile(&mut times, 0.5),
        quantile(&mut times, 1.0),
        quantile(&mut iterations, 0.5),
        quantile(&mut lengths, 0.5)
    );
}

fn quantile(values: &mut [f64], part: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get((values.len().saturating_sub(1) as f64 * part).round() as usize).copied().unwrap_or(f64::NAN)
}
