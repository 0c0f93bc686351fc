//! Scenes of the pages, and golden files: cases with the outcome that each had.

use planarium::scenario::Scenario;
use serde_json::Value as Json;

/// A scene of the pages.
pub fn scene(name: &str) -> Scenario {
    macro_rules! text {
        ($($scene:literal),*) => {
            match name {
                $($scene => include_str!(concat!("../../www/scenes/", $scene, ".json")),)*
                other => panic!("no scene {other}"),
            }
        };
    }
    let text = text!("corner", "firs", "locked", "pick", "rings", "shelf", "stones", "tentacle", "thicket", "turn");
    Scenario::parse(text).expect("our own scenes are right")
}

/// Compares the outcome of every case of a golden file, given by name and text; `PLANARIUM_BLESS=1` writes them anew.
pub fn check(file: &str, text: &str, least: usize, outcome: impl Fn(&Json) -> Json) {
    let mut cases: Vec<Json> = serde_json::from_str(text).expect("the golden file is JSON");
    assert!(cases.len() >= least, "{file} has {} cases", cases.len());
    #[cfg(not(target_arch = "wasm32"))]
    if std::env::var_os("PLANARIUM_BLESS").is_some() {
        cases.iter_mut().for_each(|case| case["outcome"] = outcome(case));
        // One case a line.
        let lines: Vec<String> = cases.iter().map(Json::to_string).collect();
        let text = format!("[\n{}\n]\n", lines.join(",\n"));
        return std::fs::write(format!("{}/tests/{file}", env!("CARGO_MANIFEST_DIR")), text).expect("written");
    }
    for case in &mut cases {
        assert_eq!(outcome(case), case["outcome"], "{case}");
    }
}

/// The committed file is this text; `PLANARIUM_BLESS=1` writes it anew.
#[cfg(not(target_arch = "wasm32"))]
pub fn committed(file: &str, text: &str) {
    let path = format!("{}/{file}", env!("CARGO_MANIFEST_DIR"));
    if std::env::var_os("PLANARIUM_BLESS").is_some() {
        std::fs::write(&path, text).expect("the file can be written");
    }
    let committed = std::fs::read_to_string(path).expect("the file exists");
    assert!(committed == text, "{file} is out of date: PLANARIUM_BLESS=1 writes it anew");
}
