//! `planarium import`: maps, pictures, drawings and benchmark files as scenarios.

use crate::arguments::Answer;
use crate::kind::Kind;
use crate::output::Destination;
use crate::world::{WorldOptions, read_file, world};
use clap::Args;
use planarium::Error;
use planarium::error::Code;

#[derive(Args)]
#[command(after_help = "\
Reads maps of ROS (YAML with PGM, PNG or BMP), MovingAI maps and scenarios, 0-1 grids (text, CSV, npy), pictures, SVG, DXF, GeoJSON, WKT,
buildings of Open-RMF, parking cases, and the files of Modern Robotics and OMPL. A file that is named by another one is found beside it. The scenario goes to standard output, what was
read, dropped, merged, moved and grown to standard error.
Exit codes: 0 read; 2 the input is wrong, and the error has its file and line, byte or element.

Examples:
  planarium import map.yaml --radius 0.2 --start 1,1 --goal 8,5 --out map.json
  planarium import Berlin.map Berlin.map.scen > berlin.json
  planarium import house.geojson --filter type!=window --radius 0.2 > house.json
  planarium import office.building.yaml --layers walls,doors --level L1 > office.json
  planarium import plan.png --scale 0.05 --footprint 0.9x0.62 --start 1,1,0 --goal 8,5,1.57 | planarium plan -")]
pub struct Arguments {
    /// The files of one world, in any order; - reads one from standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<String>,

    #[command(flatten)]
    destination: Destination,

    #[command(flatten)]
    world: WorldOptions,
}

/// Reads the files and prints the scenario; always true.
pub fn import(arguments: &Arguments) -> Answer {
    let (outputs, out) = arguments.destination.beside(arguments.files.iter().map(String::as_str), Kind::SCENARIO)?;
    if arguments.files.iter().filter(|name| *name == "-").count() > 1 {
        return Err(Error::new(Code::Usage, "", "only one file can come from standard input").into());
    }
    let given = arguments.files.iter().map(|name| Ok((name.clone(), read_file(name)?)));
    let world = world(given.collect::<Result<_, Error>>()?, &arguments.world, &outputs)?;
    out.write(&world.scenario.to_json_string())?;
    arguments.world.say(&world.report);
    Ok(true)
}
