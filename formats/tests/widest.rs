//! The widest robot on maps of the folder that `PLANARIUM_WORLDS` names, against certificates.

use crate::documents::needed;
use crate::files::{Random, file};
use planarium::certificate::{MAX_CELLS, Options as CertificateOptions, Subdivision, Verdict};
use planarium::geometry::Aabb;
use planarium::optimum::{Limit, widest};
use planarium::problem::Stepped;
use planarium::robot::DiscRobot;
use planarium::scenario::{Query, Scenario};
use planarium::{Error, PlanningWorld};
use planarium_formats::{Options, read};
use std::path::Path;
use std::time::Instant;

/// Queries for each map.
const QUERIES: usize = 10;

/// How far certificates look below and above, in metres.
const APART: f64 = 1e-3;

/// A map as a world for a point.
fn map(folder: &Path, names: &[&str]) -> Scenario {
    let contents: Vec<(&str, Vec<u8>)> =
        names.iter().map(|name| (*name, std::fs::read(folder.join(name)).expect("a file"))).collect();
    let files: Vec<_> = contents.iter().map(|(name, bytes)| file(name, bytes)).collect();
    read(&files, &Options::default()).unwrap_or_else(|error| panic!("{error}")).scenario
}

/// The map with one query, for a disc.
fn between(map: &Scenario, radius: f64, ends: [[f64; 2]; 2]) -> Result<PlanningWorld, Error> {
    let query = Query::new("given", ends[0], ends[1]);
    Ok(PlanningWorld::new(Scenario::new("map", map.world().clone(), DiscRobot::new(radius)?, [query])?))
}

#[test]
fn certificates_agree_on_real_maps() {
    let Some(folder) = needed("PLANARIUM_WORLDS") else { return };
    let maps: [&[&str]; 3] = [
        &["ros/depot.yaml", "ros/depot.pgm"],
        &["ros/tb3_sandbox.yaml", "ros/tb3_sandbox.pgm"],
        &["movingai/Berlin_0_256.map"],
    ];
    for names in maps {
        let map = map(Path::new(&folder), names);
        let Aabb { min, max } = map.world().bounds.expect("bounds");
        let mut random = Random(7);
        let mut place = || [min.x + random.unit() * (max.x - min.x), min.y + random.unit() * (max.y - min.y)];
        let (mut queries, mut closed, mut slowest) = (0, 0, 0.0_f64);
        while queries < QUERIES {
            let ends = [place(), place()];
            let world = between(&map, 0.0, ends).expect("a scenario");
            let started = Instant::now();
            // Ends in obstacles are refused.
            let Ok(found) = widest(&world, None) else { continue };
            slowest = slowest.max(started.elapsed().as_secs_f64());
            // What a certificate says of a disc; of one that does not fit at the start or the goal, that it has no path.
            let certified = |radius: f64| {
                let options = CertificateOptions { cells: MAX_CELLS, ..CertificateOptions::default() };
                let world = between(&map, radius, ends).expect("a scenario");
                match Subdivision::new(&world, &options) {
                    Ok(mut subdivision) => {
                        subdivision.step(u64::MAX);
                        subdivision.verdict()
                    }
                    Err(error) => error.code().as_str().ends_with("in-collision").then_some(Verdict::Infeasible),
                }
            };
            match found.radius {
                None if closed < QUERIES / 2 => {
                    closed += 1;
                    assert_eq!(found.limit, Limit::Closed);
                    assert_eq!(certified(0.0), Some(Verdict::Infeasible), "{names:?}: {found:?}");
                }
                Some(radius) if radius > APART => {
                    queries += 1;
                    assert_eq!(certified(radius - APART), Some(Verdict::Connected), "{names:?}: {found:?}");
                    assert_eq!(certified(radius + APART), Some(Verdict::Infeasible), "{names:?}: {found:?}");
                }
                _ => {}
            }
        }
        println!("{}: {queries} queries, {closed} closed, at most {:.1} ms", names[0], 1e3 * slowest);
    }
}
