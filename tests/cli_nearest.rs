//! `planarium nearest` as a person or a script meets it.

use serde_json::{Value, json};
use std::path::PathBuf;
use std::process::Command;

const FIRS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/scenes/firs.json");

/// Exit code and what stands on standard output.
fn nearest(arguments: &[&str]) -> (i32, Value) {
    let output =
        Command::new(env!("CARGO_BIN_EXE_planarium")).arg("nearest").args(arguments).output().expect("it runs");
    let text = String::from_utf8(output.stdout).expect("text");
    let json = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text:?}"));
    assert!(!output.stderr.is_empty(), "a word for people");
    (output.status.code().expect("no signal"), json)
}

/// The path of a file with these bytes.
fn file(name: &str, bytes: &[u8]) -> String {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, bytes).expect("the folder for test files can be written");
    path.into_os_string().into_string().expect("the folder's name is text")
}

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

const LIST: [[f64; 2]; 5] = [[3.0, 0.0], [-3.0, 0.5], [0.0, 0.0], [-3.0, 0.0], [3.0, 0.0]];

#[test]
fn it_prints_numbers_and_distances_nearest_first() {
    let list = file("nearest.json", json!(LIST).to_string().as_bytes());
    let [c, fortran] = [["False", "c.npy"], ["True", "f.npy"]].map(|[order, name]| {
        let columns: Vec<f64> = (0..2).flat_map(|axis| LIST.map(|row| row[axis])).collect();
        let numbers = if order == "True" { columns } else { LIST.concat() };
        let data: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
        file(name, &npy("<f8", order, "5, 2", &data))
    });
    let big: Vec<u8> = LIST.concat().iter().flat_map(|&x| (x as f32).to_be_bytes()).collect();
    let big = file("big.npy", &npy(">f4", "False", "5, 2", &big));
    for name in [&list, &c, &fortran, &big] {
        for index in ["linear", "kd-tree", "forest"] {
            let (code, answer) =
                nearest(&[FIRS, "--configurations", name, "--target", "-3,0", "--k", "4", "--index", index]);
            assert_eq!((code, &answer["indices"]), (0, &json!([3, 0, 4, 1])), "{answer}");
            let gap = 2.0 * std::f64::consts::PI - 6.0;
            assert_eq!(answer["distances"], json!([0, gap, gap, 0.5]));
            assert_eq!((&answer["configurations"], &answer["visited"]), (&json!(5), &json!(5)));
            assert_eq!(answer.get("recall"), (index == "forest").then_some(&json!(1)));
            assert!(answer["query_seconds"].as_f64().expect("seconds") > 0.0);
            assert!(answer["build_seconds"].as_f64().expect("seconds") > 0.0);
        }
    }
    let (_, naive) = nearest(&[FIRS, "--configurations", &list, "--target", "-0.1,0", "--k", "5", "--metric", "naive"]);
    assert_eq!(naive["indices"], json!([3, 1, 0, 4, 2]), "-0.1 is read as 6.18");
    let (_, within) = nearest(&[FIRS, "--configurations", &list, "--target", "-3,0", "--within", "0.3"]);
    assert_eq!(within["indices"], json!([3, 0, 4]));
}

#[test]
fn it_draws_by_seed_and_the_tree_visits_few() {
    let ask = |index: &str| {
        let arguments =
            [FIRS, "--samples", "20000", "--seed", "7", "--free", "--target", "3.14,0", "--k", "10", "--index", index];
        nearest(&arguments).1
    };
    let [scan, tree] = [ask("linear"), ask("kd-tree")];
    assert_eq!((&scan["indices"], &scan["distances"]), (&tree["indices"], &tree["distances"]));
    assert_eq!(scan["visited"], 20000);
    assert!(tree["visited"].as_u64().expect("a count") < 1000, "{}", tree["visited"]);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let list = |name: &str, text: &str| file(name, text.as_bytes());
    let word = file("word.npy", &npy("<U4", "False", "5, 2", &[0; 160]));
    let short = file("short.npy", &npy("<f8", "False", "5, 2", &[0; 79]));
    let flat = file("flat.npy", &npy("<f8", "False", "10,", &[0; 80]));
    let wide = file("wide.npy", &npy("<f8", "False", "5, 3", &[0; 120]));
    let huge = file("huge.npy", &npy("<f8", "False", "4611686018427387904, 8", &[0; 80]));
    for (name, code, pointer) in [
        (&word, "file", ""),
        (&short, "file", ""),
        (&flat, "file", ""),
        (&huge, "file", ""),
        (&wide, "wrong-dimension", "/rows"),
        (&list("n1.json", "[[0, 0], [1]]"), "wrong-dimension", "/rows/1"),
        (&list("n2.json", "[[0, 0], 1]"), "wrong-type", "/rows/1"),
        (&list("n3.json", "[[0, 0], [1, \"a\"]]"), "wrong-type", "/rows/1/1"),
        (&list("n4.json", "{}"), "wrong-type", "/rows"),
        (&list("n5.json", "[[0, 0], [1, 1e7]]"), "out-of-range", "/rows/1/1"),
        (&list("n6.json", "[[0, 0"), "invalid-json", "/0"),
    ] {
        let (exit, answer) = nearest(&[FIRS, "--configurations", name, "--target", "0,0"]);
        let error = &answer["error"];
        assert_eq!((exit, &error["code"], &error["pointer"]), (2, &json!(code), &json!(pointer)), "{name}: {answer}");
    }
    for (target, pointer) in [("0", "/target"), ("0,1e7", "/target/1"), ("nan,0", "/target/0")] {
        let (exit, answer) = nearest(&[FIRS, "--target", target]);
        assert_eq!((exit, &answer["error"]["pointer"]), (2, &json!(pointer)), "{target}: {answer}");
    }
    for (arguments, code) in [
        (&["--target", "0"][..], "wrong-dimension"),
        (&["--target", "0,0", "--index", "ball-tree"], "out-of-range"),
        (&["--target", "0,0", "--set", "trees=3"], "unknown-parameter"),
        (&["--target", "0,0", "--samples", "2000000"], "out-of-range"),
        (&["--target", "0,0", "--within", "-1"], "out-of-range"),
        (&["--target", "0,x"], "usage"),
        (&["--k", "3"], "usage"),
        (&["--target", "0,0", "--k", "3", "--within", "2"], "usage"),
    ] {
        let (exit, answer) = nearest(&[&[FIRS], arguments].concat());
        assert_eq!((exit, &answer["error"]["code"]), (2, &json!(code)), "{arguments:?}");
    }
}
