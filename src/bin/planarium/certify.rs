//! `planarium certify`: a certificate that there is no path, or that there is one.

use crate::arguments::Certify;
use crate::output::{Kind, Outputs};
use crate::{Answer, files};
use planarium::certificate::{Certificate, Options, Subdivision, Verdict};

/// Divides to the end and prints the certificate; true if it is decided.
pub fn certify(arguments: &Certify) -> Answer {
    let out = Outputs::beside([&*arguments.file], arguments.force).add(arguments.out.as_deref(), Kind::CERTIFICATE)?;
    let scenario = files::scenario(&arguments.file, None)?;
    let Certify { query, clearance, cells, .. } = arguments;
    let options = Options { query: query.clone(), clearance: *clearance, cells: *cells };
    let mut subdivision = Subdivision::new(&scenario, &options)?;
    subdivision.step(u64::MAX);
    let certificate = subdivision.certificate();
    out.write(&certificate.to_json())?;
    let path = |most: f64| if most > 0.0 { format!("path with clearance above {most} m") } else { "path".to_owned() };
    let Certificate { verdict, clearance_at_most, slack, cells, .. } = certificate;
    let sentence = match (verdict, clearance_at_most) {
        (Verdict::Connected, _) => format!("a {} exists; {cells} cells", path(*clearance)),
        (Verdict::Infeasible, most) => {
            let path = path(most.unwrap_or(*clearance));
            format!("no {path} exists; {cells} cells; clearances are known to within {slack:e} m")
        }
        (Verdict::Unknown, Some(most)) => format!("gave up after {cells} cells; no {} exists", path(most)),
        (Verdict::Unknown, None) => format!("gave up after {cells} cells; nothing is proven"),
    };
    let word: &str = verdict.into();
    files::say(&format!("{word}: {sentence}"));
    Ok(verdict != Verdict::Unknown)
}
