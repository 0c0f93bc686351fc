//! `planarium certify`: a certificate that there is no path, or that there is one.

use crate::arguments::Answer;
use crate::files;
use crate::kind::Kind;
use crate::output::Destination;
use crate::world::{self, WorldOptions};
use clap::Args;
use planarium::certificate::{Certificate, DEFAULT_CELLS, Options, Subdivision, Verdict};
use planarium::problem::Stepped;

#[derive(Args)]
#[command(after_help = "\
For an arm of two links and for a disc. The verdict is \"infeasible\" (no path keeps more than the clearance), \"connected\" (a
path does), or \"unknown\" once --cells are spent; then no path keeps more than \"clearance_at_most\", if that is there.
Clearances are known to within \"slack\"; contact is collision.
Exit codes: 0 infeasible or connected; 1 unknown; 2 the input is wrong.

Examples:
  planarium certify arm.json --out certificate.json
  planarium verify arm.json certificate.json
  planarium certify arm.json --query report --clearance 0.01 --cells 200000")]
pub struct Arguments {
    /// The scenario, a JSON file, or a map (see `planarium import`); - reads it from standard input
    file: String,

    /// The query, by name [default: the first of the scenario]
    #[arg(long, value_name = "NAME")]
    query: Option<String>,

    /// The clearance that paths have to exceed, in metres
    #[arg(long, value_name = "E", default_value_t = 0.0, allow_negative_numbers = true)]
    clearance: f64,

    /// The most cells, divided ones too
    #[arg(long, value_name = "N", default_value_t = DEFAULT_CELLS, allow_negative_numbers = true)]
    cells: usize,

    #[command(flatten)]
    destination: Destination,

    #[command(flatten)]
    world: WorldOptions,
}

/// Divides to the end and prints the certificate; true if it is decided.
pub fn certify(arguments: &Arguments) -> Answer {
    let (outputs, out) = arguments.destination.beside([&*arguments.file], Kind::CERTIFICATE)?;
    let scenario = world::scenario(&arguments.file, None, &arguments.world, &outputs)?;
    let Arguments { query, clearance, cells, .. } = arguments;
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
