//! Every test of the formats in one program. `PLANARIUM_DEEP=1` tries a million mutations; `PLANARIUM_WORLDS` names a
//! folder of real files that are read and planned in as well.

// Of the tests of the library.
#[allow(dead_code)]
#[path = "../../tests/common/documents.rs"]
mod documents;
// The functions of the fuzzers.
#[path = "../../fuzz/worlds.rs"]
mod fuzzed;

mod files;
mod grids;
mod hostile;
mod mutations;
mod pictures;
mod planning;
mod rectangles;
mod ros;
mod tables;
mod worlds;
