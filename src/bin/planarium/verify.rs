//! `planarium verify`: the independent judge.

use crate::arguments::Verify;
use crate::{Answer, files};
use planarium::Error;
use planarium::error::Code;
use planarium::path::{self, ResultDocument, Verdict};
use planarium::scenario::Scenario;

/// Judges, prints the verdict; yes where the result is valid.
pub fn verify(arguments: &Verify) -> Answer {
    if arguments.file == "-" && arguments.result == "-" {
        let sentence = "scenario and result cannot both come from standard input";
        return Err(Error::new(Code::Usage, "", sentence));
    }
    let scenario = Scenario::parse(&files::read(&arguments.file)?)?;
    let result = ResultDocument::parse(&files::read(&arguments.result)?)?;
    let verdict = path::verify(&scenario, &result)?;
    let (message, document) = match &verdict {
        Verdict::Valid { waypoints, looks, clearance } => {
            // JSON has no infinity: without obstacles the clearance is null.
            let clearance = clearance.is_finite().then_some(*clearance);
            let told = clearance.map_or("no obstacle".to_owned(), |c| format!("clearance {c:.3e} m"));
            let document = serde_json::json!({
                "valid": true, "waypoints": waypoints, "looks": looks, "clearance": clearance
            });
            (format!("valid: {waypoints} waypoints, {looks} looks, {told}"), document)
        }
        Verdict::Invalid { why } => (format!("not valid: {why}"), serde_json::json!({ "valid": false, "why": why })),
    };
    files::say(&message);
    files::print(&document.to_string())?;
    Ok(matches!(verdict, Verdict::Valid { .. }))
}
