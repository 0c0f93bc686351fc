//! `planarium verify`: the independent verifiers.

use crate::arguments::Answer;
use crate::files;
use crate::output::Outputs;
use crate::world::{self, Source, WorldOptions};
use clap::Args;
use planarium::certificate::{self, Certificate};
use planarium::fleet::{self, Fleet, FleetResult};
use planarium::json;
use planarium::path::{self, ResultDocument, Verdict};
use planarium::scenario::Scenario;
use serde_json::json;

#[derive(Args)]
#[command(after_help = "\
Prints {\"valid\": true, \"waypoints\", \"looks\", \"clearance\"} or {\"valid\": false, \"why\"}; of a certificate without counts.
Clearance is the smallest distance to an obstacle found, in metres; null without obstacles.
Of a plan of a fleet it prints {\"valid\", \"conflicts\", \"faults\", \"looks\"}.
Exit codes: 0 valid; 1 not valid; 2 the input is wrong.

Examples:
  planarium verify arm.json result.json
  planarium plan arm.json | planarium verify arm.json -")]
pub struct Arguments {
    /// The scenario or the fleet, a JSON file, or a map with the options that it was planned with; - reads it from
    /// standard input
    file: String,

    /// The result document, or the certificate; - reads it from standard input
    result: String,

    #[command(flatten)]
    world: WorldOptions,
}

/// Verifies and prints the verdict; true if the result or the certificate is valid. Only certificates have a format.
/// That of the first document tells whether it is a fleet.
pub fn verify(arguments: &Arguments) -> Answer {
    let inputs = Outputs::beside([&*arguments.file, &*arguments.result], false);
    let other = Some(("result", &*arguments.result));
    let source = world::document_or_map(&arguments.file, other, &arguments.world, &inputs)?;
    let text = files::read(&arguments.result)?;
    if let Source::Document(document) = &source
        && document["format"] == fleet::FORMAT
    {
        let verification = fleet::verify(&Fleet::read(document)?, &FleetResult::parse(&text)?)?;
        let fleet::Verification { conflicts, faults, claims, .. } = &verification;
        let counts = [conflicts.len(), faults.len(), claims.len()];
        let verdict = if verification.is_valid() { "valid" } else { "not valid" };
        files::say(&format!("{verdict}: {} conflicts, {} faults, {} false claims", counts[0], counts[1], counts[2]));
        files::print(&json::to_string(&verification))?;
        return Ok(verification.is_valid());
    }
    let scenario = match source {
        Source::Document(document) => Scenario::read(&document)?,
        Source::Map(scenario) => scenario,
    };
    let is_certificate = json::parse(&text)?.get("format").is_some();
    if is_certificate {
        let why = certificate::verify(&scenario, &Certificate::parse(&text)?)?;
        files::say(&why.as_ref().map_or("valid".to_owned(), |why| format!("not valid: {why}")));
        let document = why.as_ref().map_or(json!({ "valid": true }), |why| json!({ "valid": false, "why": why }));
        files::print(&document.to_string())?;
        return Ok(why.is_none());
    }
    let verdict = path::verify(&scenario, &ResultDocument::parse(&text)?)?;
    let (message, document) = match &verdict {
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
    files::say(&message);
    files::print(&document.to_string())?;
    Ok(matches!(verdict, Verdict::Valid { .. }))
}
