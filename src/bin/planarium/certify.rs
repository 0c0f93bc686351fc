//! `planarium certify`: a certificate that there is no path, or that there is one.

use crate::arguments::Certify;
use crate::output::{Kind, Outputs};
use crate::{Answer, files};
use planarium::certificate::{Options, Subdivision, Verdict};

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
    let sentence = match (certificate.verdict, certificate.clearance_at_most) {
        (Verdict::Connected, _) => format!("a {} exists", path(*clearance)),
        (_, Some(most)) => format!("no {} exists", path(most)),
        (_, None) => "nothing is proven".to_owned(),
    };
    let word: &str = certificate.verdict.into();
    files::say(&format!("{word}: {sentence}; {} cells", certificate.cells));
    Ok(certificate.verdict != Verdict::Unknown)
}
