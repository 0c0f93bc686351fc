//! Every test of the command line in one program. `PLANARIUM_DEEP=1` tests more seeds.

// The tests of the library use the rest.
#[allow(dead_code)]
#[path = "../../tests/common/documents.rs"]
mod documents;
mod program;

mod commands;
mod convert;
mod files;
mod import;
mod nearest;
mod sweep;
mod truth;
