//! Statistics against NumPy and SciPy. `tests/statistics.py` writes their numbers to `statistics.json`, with the versions.

use planarium::statistics::{Names, ecdf, mean, moving_average, paired, quartiles, share};
use serde_json::Value;
use wasm_bindgen_test::wasm_bindgen_test;

fn fixtures() -> Value {
    serde_json::from_str(include_str!("statistics.json")).expect("the fixtures are JSON")
}

/// The cases of one kind.
fn cases(kind: &str) -> Vec<Value> {
    let cases = fixtures()[kind].as_array().expect("cases").clone();
    assert!(!cases.is_empty());
    cases
}

fn numbers(list: &Value) -> Vec<f64> {
    list.as_array().expect("numbers").iter().map(|number| number.as_f64().unwrap_or(f64::NAN)).collect()
}

/// Relative to 1 or the value.
#[track_caller]
fn is_near(found: impl Into<Option<f64>>, expected: &Value, tolerance: f64, what: &Value) {
    let (found, expected) = (found.into().expect("a value"), expected.as_f64().expect("a number"));
    assert!((found - expected).abs() <= tolerance * expected.abs().max(1e-3), "{found} is not {expected}: {what:.80}");
}

const NAMES: Names = Names { a: "one", b: "other", measure: "length" };

#[wasm_bindgen_test(unsupported = test)]
fn shares_have_the_interval_of_scipy() {
    for case in cases("shares") {
        let [count, n] = ["count", "n"].map(|name| case[name].as_u64().unwrap());
        let mut sample: Vec<f64> = (0..n).map(|i| f64::from(u8::from(i < count))).collect();
        sample.push(f64::NAN);
        let found = share(&sample);
        assert_eq!((found.n, found.count, found.missing), (n, count, 1));
        assert_eq!(found.share, Some(count as f64 / n as f64));
        is_near(found.low, &case["low"], 1e-12, &case);
        is_near(found.high, &case["high"], 1e-12, &case);
    }
    assert_eq!(share(&[f64::NAN]).share, None);
}

#[wasm_bindgen_test(unsupported = test)]
fn quartiles_means_and_distributions_are_those_of_numpy_and_scipy() {
    for case in cases("samples") {
        let sample = numbers(&case["sample"]);
        let missing = sample.iter().filter(|value| value.is_nan()).count() as u64;
        let (box_plot, mean, ecdf) = (quartiles(&sample), mean(&sample), ecdf(&sample));
        let n = sample.len() as u64 - missing;
        for counts in [(box_plot.n, box_plot.missing), (mean.n, mean.missing), (ecdf.n, ecdf.missing)] {
            assert_eq!(counts, (n, missing));
        }
        for (found, expected) in box_plot.values.unwrap().into_iter().zip(case["quartiles"].as_array().unwrap()) {
            is_near(found, expected, 1e-14, &case);
        }
        is_near(mean.mean, &case["mean"], 1e-14, &case);
        is_near(mean.deviation, &case["deviation"], 1e-13, &case);
        is_near(mean.low, &case["low"], 1e-12, &case);
        is_near(mean.high, &case["high"], 1e-12, &case);
        assert_eq!(mean.needed, case["needed"].as_u64(), "{:.80}", case);
        assert_eq!(ecdf.values, numbers(&case["ecdf"][0]));
        for (found, expected) in ecdf.shares.iter().zip(case["ecdf"][1].as_array().unwrap()) {
            is_near(*found, expected, 1e-15, &case);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn moving_averages_are_those_of_numpy() {
    for case in cases("averages") {
        let width = case["width"].as_u64().unwrap() as usize;
        let found = moving_average(&numbers(&case["sample"]), width);
        let expected = case["average"].as_array().unwrap();
        assert_eq!(found.len(), expected.len() + width - 1);
        assert!(found[..width - 1].iter().all(|value| value.is_nan()));
        found[width - 1..].iter().zip(expected).for_each(|(found, expected)| is_near(*found, expected, 1e-13, &case));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn paired_tests_are_those_of_scipy() {
    for case in cases("pairs") {
        let [a, b] = ["a", "b"].map(|name| numbers(&case[name]));
        let found = paired(&a, &b, NAMES, 1);
        let missing = a.iter().zip(&b).filter(|(a, b)| a.is_nan() || b.is_nan()).count() as u64;
        assert_eq!((found.n, found.missing), (a.len() as u64 - missing, missing));
        assert_eq!([found.smaller, found.larger].map(Some), ["smaller", "larger"].map(|name| case[name].as_u64()));
        is_near(found.median, &case["median"], 1e-13, &case);
        is_near(found.sign_p, &case["sign_p"], 1e-12, &case);
        is_near(found.wilcoxon_p, &case["wilcoxon_p"], 1e-12, &case);
        let swapped = paired(&b, &a, NAMES, 1);
        assert_eq!((swapped.smaller, swapped.larger), (found.larger, found.smaller));
        assert!((swapped.wilcoxon_p - found.wilcoxon_p).abs() < 1e-14);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_comparison_says_in_words_what_is_shown() {
    let a: Vec<f64> = (0..10).map(f64::from).collect();
    let b: Vec<f64> = a.iter().map(|value| value + 1.0).collect();
    let words = |tests| paired(&a, &b, NAMES, tests).words;
    assert_eq!(
        words(1),
        "The length of one is smaller than that of other in 10 of 10 pairs, larger in 0, equal in 0. The difference is \
         significant at 5 % (Wilcoxon's test, p = 0.002)."
    );
    assert!(words(100).contains("A difference is not shown at 5 % of 100 tests"), "{}", words(100));
    let [a100, b100] = [0.0, 1.0].map(|less| (0..100).map(|i| f64::from(i) * 2.0 + less).collect::<Vec<_>>());
    assert!(paired(&a100, &b100, NAMES, 1).words.ends_with("p < 0.0001)."));
    let same = paired(&a, &a, NAMES, 1);
    assert_eq!((same.sign_p, same.wilcoxon_p, same.median), (1.0, 1.0, Some(0.0)));
    assert!(same.words.contains("equal in 10. A difference is not shown"), "{}", same.words);
    let rounded = [5.5, 5.500000000000001, 5.499999999999999, -5.500000000000001, 0.0, 1e-300, f64::INFINITY];
    let found = paired(&rounded, &[5.5, 5.5, 5.5, -5.5, 0.0, 2e-300, 1.0], NAMES, 1);
    assert_eq!((found.n, found.smaller, found.larger), (7, 1, 1), "only rounding makes no difference");
    assert_eq!(paired(&[f64::NAN], &[1.0], NAMES, 1).words, "No pair has a length of both one and other.");
}
