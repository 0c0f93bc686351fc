//! Every test of the formats in one program. `PLANARIUM_DEEP=1` tries a million mutations; `PLANARIUM_WORLDS` names a
//! folder of real files that are read and planned in as well.

// Of the tests of the library.
#[allow(dead_code)]
#[path = "../../tests/common/documents.rs"]
mod documents;
// The functions of the fuzzers.
#[path = "../../fuzz/worlds.rs"]
mod fuzzed;

mod areas;
mod drawings;
mod dxf;
mod files;
mod geojson;
mod golden;
mod grids;
mod hostile;
mod mutations;
mod paths;
mod pictures;
mod planning;
mod plans;
mod rectangles;
mod rmf;
mod ros;
mod route_graphs;
mod svg;
mod tables;
mod widest;
mod wkt;
mod worlds;
mod written;
