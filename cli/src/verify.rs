//! `planarium verify`: the independent verifiers.

use crate::arguments::Answer;
use crate::files;
use crate::judge::Judging;
use crate::output::Outputs;
use crate::world::{self, Source, WorldOptions};
use clap::Args;
use planarium::Error;
use planarium::certificate::{self, Certificate};
use planarium::error::Code;
use planarium::fleet::{self, Fleet, FleetResult};
use planarium::json;
use planarium::path::{self, ResultDocument, Verdict};
use planarium::scenario::Scenario;
use planarium::timing;
use planarium_formats::{File, is_path};
use serde_json::{Value, json};

#[derive(Args)]
#[command(after_help = "\
Prints {\"valid\": true, \"waypoints\", \"looks\", \"clearance\"} or {\"valid\": false, \"why\"}; of a certificate without counts.
Clearance is the smallest distance to an obstacle found, in metres; null without obstacles.
With a trajectory it also prints its duration, the times examined, and the largest shares of its limits:
\"trajectory\": {\"duration\", \"looks\", \"speed\", \"acceleration\"}.
Of a plan of a fleet it prints {\"valid\", \"conflicts\", \"faults\", \"looks\"}.
Of a path of any other origin it prints {\"valid\", \"free\", \"waypoints\", \"contact\", \"clearance\", \"turns\", \"read\"}: where it is no longer free,
the smallest clearance if it is, and of a car the turns that it cannot drive. It is valid if it is free and can be driven.
Exit codes: 0 valid; 1 not valid; 2 the input is wrong.

Examples:
  planarium verify arm.json result.json
  planarium plan arm.json | planarium verify arm.json -
  planarium verify arm.json result.json --trajectory trajectory.json
  planarium verify map.yaml path.csv --footprint 0.9x0.62
  planarium verify Case1.csv solution.csv --arcs")]
pub struct Arguments {
    /// The scenario or the fleet, a JSON file, or a map with the options that it was planned with; - reads it from
    /// standard input
    file: String,

    /// The result document, or the certificate; or a path of any origin: a table (CSV and the like), .npy, GeoJSON, or poses of
    /// ROS; - reads it from standard input
    result: String,

    /// A trajectory along the path of the result (see `planarium time`), verified with it; - reads it from standard input
    #[arg(long, value_name = "FILE")]
    trajectory: Option<String>,

    #[command(flatten)]
    judging: Judging,

    #[command(flatten)]
    world: WorldOptions,
}

/// Verifies and prints the verdict; true if the result or the certificate is valid. Only certificates have a format.
/// That of the first document tells whether it is a fleet.
pub fn verify(arguments: &Arguments) -> Answer {
    let inputs = Outputs::beside([&*arguments.file, &*arguments.result], false);
    if let Some(trajectory) = &arguments.trajectory {
        files::refuse_both(&arguments.result, Some(("trajectory", trajectory)))?;
        files::refuse_both(&arguments.file, Some(("trajectory", trajectory)))?;
    }
    let other = Some(("result", &*arguments.result));
    let source = world::document_or_map(&arguments.file, other, &arguments.world, &inputs)?;
    let bytes = files::read_bytes(&arguments.result)?;
    let is_fleet = matches!(&source, Source::Document(document) if document["format"] == fleet::FORMAT);
    if !is_fleet && is_path(&bytes) {
        refuse_trajectory(arguments)?;
        return arguments.judging.judge(&source.scenario()?, File { name: &arguments.result, bytes: &bytes });
    }
    arguments.judging.refuse()?;
    let text = files::text(&arguments.result, bytes)?;
    if let Source::Document(document) = &source
        && is_fleet
    {
        refuse_trajectory(arguments)?;
        let verification = fleet::verify(&Fleet::read(document)?, &FleetResult::parse(&text)?)?;
        let fleet::Verification { conflicts, faults, claims, .. } = &verification;
        let counts = [conflicts.len(), faults.len(), claims.len()];
        let verdict = if verification.is_valid() { "valid" } else { "not valid" };
        files::say(&format!("{verdict}: {} conflicts, {} faults, {} false claims", counts[0], counts[1], counts[2]));
        files::print(&json::to_string(&verification))?;
        return Ok(verification.is_valid());
    }
    let scenario = source.with_query()?;
    let is_certificate = json::parse(&text)?.get("format").is_some();
    if is_certificate {
        refuse_trajectory(arguments)?;
        let why = certificate::verify(&scenario, &Certificate::parse(&text)?)?;
        files::say(&why.as_ref().map_or("valid".to_owned(), |why| format!("not valid: {why}")));
        let document = why.as_ref().map_or(json!({ "valid": true }), |why| json!({ "valid": false, "why": why }));
        files::print(&document.to_string())?;
        return Ok(why.is_none());
    }
    let result = ResultDocument::parse(&text)?;
    let verdict = path::verify(&scenario, &result)?;
    let timed = arguments.trajectory.as_deref().filter(|_| verdict.is_valid());
    let timed = timed.map(|name| timed_along(&scenario, &result, &files::read(name)?)).transpose()?;
    let (mut message, mut document) = match &verdict {
        Verdict::Valid { waypoints, samples, clearance, moved_start, moved_goal } => {
            // JSON has no infinity: without obstacles the clearance is null.
            let clearance = clearance.is_finite().then_some(*clearance);
            let distance = clearance.map_or("no obstacle".to_owned(), |c| format!("clearance {c:.3e} m"));
            let mut document =
                json!({ "valid": true, "waypoints": waypoints, "looks": samples, "clearance": clearance });
            let mut message = format!("valid: {waypoints} waypoints, {samples} samples, {distance}");
            for (what, is_moved) in [("start", moved_start), ("goal", moved_goal)] {
                if *is_moved {
                    document[format!("moved_{what}")] = true.into();
                    message += &format!("; the {what} of the query is in collision and was moved");
                }
            }
            (message, document)
        }
        Verdict::Invalid { why } => (format!("not valid: {why}"), json!({ "valid": false, "why": why })),
    };
    let is_valid = match timed {
        Some(Err(why)) => {
            message = format!("not valid: the trajectory: {why}");
            document = json!({ "valid": false, "why": format!("the trajectory: {why}") });
            false
        }
        Some(Ok(trajectory)) => {
            message += &format!("; trajectory of {} s", trajectory["duration"]);
            document["trajectory"] = trajectory;
            true
        }
        None => verdict.is_valid(),
    };
    files::say(&message);
    files::print(&document.to_string())?;
    Ok(is_valid)
}

/// What is known of a valid trajectory along the path of a result, or why it is not valid.
fn timed_along(scenario: &Scenario, result: &ResultDocument, text: &str) -> Result<Result<Value, String>, Error> {
    Ok(match timing::verify_document(scenario, result, &json::parse(text)?)? {
        timing::Verdict::Valid { duration, samples, speed, acceleration } => {
            Ok(json!({ "duration": duration, "looks": samples, "speed": speed, "acceleration": acceleration }))
        }
        timing::Verdict::Invalid { why } => Err(why),
    })
}

/// Refuses a trajectory beside a document that is no result of a plan.
fn refuse_trajectory(arguments: &Arguments) -> Result<(), Error> {
    match arguments.trajectory {
        Some(_) => Err(Error::new(Code::Usage, "", "--trajectory is for the result of a plan")),
        None => Ok(()),
    }
}
