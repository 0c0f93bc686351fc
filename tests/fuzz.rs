//! The corpus of the fuzzers (see `fuzz/README.md`), once through the functions that they call. What they have found is in it.

#[path = "../fuzz/calls.rs"]
mod calls;
#[path = "../fuzz/readers.rs"]
mod readers;

use std::fs;
use std::path::Path;

/// Calls a function with every file of a corpus.
fn replay(name: &str, target: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus").join(name);
    let mut files: Vec<_> =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("a file").path()).collect();
    files.sort();
    assert!(files.len() > 1, "{name} has a corpus");
    for file in files {
        println!("{}", file.display());
        target(&fs::read(file).expect("a file"));
    }
}

#[test]
fn readers_survive_the_corpus() {
    replay("scenario", readers::scenario);
    replay("experiment", readers::experiment);
    replay("roadmap", readers::roadmap);
    replay("judged", readers::judged);
    replay("fleet", readers::fleet);
    replay("navigation", readers::navigation);
}

#[test]
fn sequences_of_calls_survive_the_corpus() {
    replay("calls", calls::calls);
}
