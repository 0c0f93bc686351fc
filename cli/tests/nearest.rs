//! `planarium nearest`: lists of configurations, as JSON and as arrays of NumPy, and the same neighbours by every index.

use crate::program::{file, planarium};
use serde_json::json;

#[path = "../../fuzz/npy.rs"]
mod fuzzed;

/// An array file of NumPy.
fn npy(kind: &str, fortran: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': {fortran}, 'shape': ({shape}), }}");
    while (10 + header.len() + 1) % 64 != 0 {
        header.push(' ');
    }
    header.push('\n');
    let length = (header.len() as u16).to_le_bytes();
    [b"\x93NUMPY\x01\x00".as_slice(), &length, header.as_bytes(), data].concat()
}

#[test]
fn nearest_prints_indices_and_distances_nearest_first() {
    const LIST: [[f64; 2]; 5] = [[3.0, 0.0], [-3.0, 0.5], [0.0, 0.0], [-3.0, 0.0], [3.0, 0.0]];
    let columns: Vec<f64> = (0..2).flat_map(|axis| LIST.map(|row| row[axis])).collect();
    let little = |numbers: &[f64]| numbers.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>();
    let big: Vec<u8> = LIST.concat().iter().flat_map(|&x| (x as f32).to_be_bytes()).collect();
    file("nearest.json", json!(LIST).to_string());
    file("c.npy", npy("<f8", "False", "5, 2", &little(&LIST.concat())));
    file("f.npy", npy("<f8", "True", "5, 2", &little(&columns)));
    file("big.npy", npy(">f4", "False", "5, 2", &big));
    for name in ["nearest.json", "c.npy", "f.npy", "big.npy"] {
        for index in ["linear", "kd-tree", "forest"] {
            let line = format!("nearest firs.json --configurations {name} --target -3,0 --k 4 --index {index}");
            let finished = planarium(&line);
            let found = finished.json();
            assert_eq!((finished.code, &found["indices"]), (0, &json!([3, 0, 4, 1])), "{found}");
            assert!(!finished.stderr.is_empty(), "a summary for people");
            let gap = 2.0 * std::f64::consts::PI - 6.0;
            assert_eq!(found["distances"], json!([0, gap, gap, 0.5]));
            assert_eq!((&found["configurations"], &found["visited"]), (&json!(5), &json!(5)));
            assert_eq!(found.get("recall"), (index == "forest").then_some(&json!(1)));
            assert!(["query_seconds", "build_seconds"].iter().all(|&key| found[key].as_f64() > Some(0.0)), "{found}");
        }
    }
    let indices =
        |rest: &str| planarium(&format!("nearest firs.json --configurations {rest}")).json()["indices"].take();
    let naive = indices("nearest.json --target -0.1,0 --k 5 --metric naive");
    assert_eq!(naive, json!([3, 1, 0, 4, 2]), "-0.1 is read as 6.18");
    assert_eq!(indices("nearest.json --target -3,0 --within 0.3"), json!([3, 0, 4]));
    let line = "nearest firs.json --configurations nearest.json --target -3,0 --k 4 --index kd-tree-unwrapped";
    let found = planarium(line).json();
    assert_eq!(found["indices"], json!([3, 1, 2, 0]), "3 is as far as a plain number is");
    assert_eq!((&found["distances"], &found["recall"]), (&json!([0, 0.5, 3, 6]), &json!(0.75)), "4 is missed");
    let naive = planarium(&format!("{line} --metric naive")).json();
    assert_eq!(naive["recall"], 1, "the naive metric wraps nothing");
}

#[test]
fn nearest_draws_by_seed_and_the_tree_visits_few() {
    let [scan, tree] = ["linear", "kd-tree"].map(|index| {
        let drawn = "nearest firs.json --samples 20000 --seed 7 --free --target 3.14,0 --k 10 --index";
        planarium(&format!("{drawn} {index}")).json()
    });
    assert_eq!((&scan["indices"], &scan["distances"]), (&tree["indices"], &tree["distances"]));
    assert_eq!(scan["visited"], 20000);
    assert!(tree["visited"].as_u64().expect("a count") < 1000, "{}", tree["visited"]);
}

#[test]
fn lists_of_configurations_are_checked() {
    let array = |kind: &str, shape: &str, bytes: usize| npy(kind, "False", shape, &vec![0; bytes]);
    for (name, contents, code, pointer) in [
        ("word.npy", array("<U4", "5, 2", 160), "file", ""),
        ("short.npy", array("<f8", "5, 2", 79), "file", ""),
        ("flat.npy", array("<f8", "10,", 80), "file", ""),
        ("huge.npy", array("<f8", "4611686018427387904, 8", 80), "file", ""),
        ("wide.npy", array("<f8", "5, 3", 120), "wrong-dimension", "/rows"),
        ("n1.json", b"[[0, 0], [1]]".to_vec(), "wrong-dimension", "/rows/1"),
        ("n2.json", b"[[0, 0], 1]".to_vec(), "wrong-type", "/rows/1"),
        ("n3.json", b"[[0, 0], [1, \"a\"]]".to_vec(), "wrong-type", "/rows/1/1"),
        ("n4.json", b"{}".to_vec(), "wrong-type", "/rows"),
        ("n5.json", b"[[0, 0], [1, 1e7]]".to_vec(), "out-of-range", "/rows/1/1"),
        ("n6.json", b"[[0, 0".to_vec(), "invalid-json", "/0"),
    ] {
        file(name, contents);
        planarium(&format!("nearest firs.json --configurations {name} --target 0,0")).refuses(code, pointer);
    }
}

/// What the fuzzer has found (see `fuzz/README.md`).
#[test]
fn the_reader_of_arrays_survives_the_corpus() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../fuzz/corpus/npy");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let file = entry.expect("a file").path();
        println!("{}", file.display());
        fuzzed::npy(&std::fs::read(file).expect("a file"));
        count += 1;
    }
    assert!(count > 1, "{count} files");
}
