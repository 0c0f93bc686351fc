//! `planarium verify`: the independent verifier.

use crate::arguments::Verify;
use crate::{Answer, files};
use planarium::path::{self, ResultDocument, Verdict};
use serde_json::json;

/// Verifies and prints the verdict; true if the result is valid.
pub fn verify(arguments: &Verify) -> Answer {
    let scenario = files::scenario(&arguments.file, Some(("result", &arguments.result)))?;
    let result = ResultDocument::parse(&files::read(&arguments.result)?)?;
    let verdict = path::verify(&scenario, &result)?;
    let (message, document) = match &verdict {
        Verdict::Valid { waypoints, samples, clearance } => {
            // JSON has no infinity: without obstacles the clearance is null.
            let clearance = clearance.is_finite().then_some(*clearance);
            let distance = clearance.map_or("no obstacle".to_owned(), |c| format!("clearance {c:.3e} m"));
            let document = json!({ "valid": true, "waypoints": waypoints, "looks": samples, "clearance": clearance });
            (format!("valid: {waypoints} waypoints, {samples} samples, {distance}"), document)
        }
        Verdict::Invalid { why } => (format!("not valid: {why}"), json!({ "valid": false, "why": why })),
    };
    files::say(&message);
    files::print(&document.to_string())?;
    Ok(matches!(verdict, Verdict::Valid { .. }))
}
