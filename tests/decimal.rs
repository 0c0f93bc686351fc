//! Decimal numbers against the standard library, which reads and shows them by other ways.

use planarium::decimal::{Decimal, Row, read};
use planarium::random::{Random, Stream};
use wasm_bindgen_test::wasm_bindgen_test;

/// Numbers on which such algorithms fail: powers of two and ten and their neighbours, ends of ranges, halves between.
fn hard() -> Vec<f64> {
    let mut numbers = vec![
        0.1,
        0.3,
        1.0 / 3.0,
        5e-324,
        1e-323,
        2.2250738585072014e-308,
        2.225073858507201e-308,
        f64::MAX,
        f64::MIN_POSITIVE,
        1e15,
        1e16,
        1e21,
        1e22,
        1e23,
        9007199254740991.0,
        9007199254740993.0,
        123456789012345680.0,
        9.5,
        99999999999999980.0,
        1e-5,
        9.999e-6,
        0.00001234,
        4.35,
        2e-44,
        2.24159265358979,
        5e-5,
        999999999999999.9,
        0.1 + 0.2,
        1e-7,
    ];
    for exponent in -1074..1024 {
        numbers.push(libm::ldexp(1.0, exponent));
    }
    for exponent in -323..309 {
        numbers.push(format!("1e{exponent}").parse().expect("a number"));
    }
    let near = |number: &f64| [number.to_bits() - 1, number.to_bits() + 1].map(f64::from_bits);
    numbers.extend(numbers.clone().iter().flat_map(near));
    numbers
}

fn random(count: u32) -> impl Iterator<Item = f64> {
    let mut random = Random::new(3, Stream::Samples);
    (0..count).flat_map(move |i| {
        let digits = libm::pow(10.0, f64::from(i % 17));
        let short = libm::round(random.uniform() * digits) / digits;
        [f64::from_bits(random.bits()), random.uniform(), 10.0 * random.uniform() - 5.0, short, 1000.0 * short]
    })
}

#[wasm_bindgen_test(unsupported = test)]
fn numbers_are_shown_as_the_standard_library_shows_them() {
    for number in hard().into_iter().chain(random(20_000)).filter(|number| number.is_finite()) {
        for number in [number, -number] {
            assert_eq!(Decimal(number).to_string(), number.to_string());
            assert_eq!(Row(&[number]).to_string(), format!("{:?}", [number]));
        }
    }
    for number in [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(Decimal(number).to_string(), number.to_string());
        assert_eq!(Row(&[number, 1.0]).to_string(), format!("{:?}", [number, 1.0]));
    }
    assert_eq!(Row(&[]).to_string(), "[]");
}

#[wasm_bindgen_test(unsupported = test)]
fn numbers_are_read_as_the_standard_library_reads_them() {
    let mut texts: Vec<String> = [
        "0",
        "-0",
        "0.0",
        "0e5",
        "-0.000e-9",
        "1",
        "00000000000000000000000012",
        "0.30000000000000004",
        "1.7976931348623157e308",
        "1.7976931348623158e308",
        "1.7976931348623159e308",
        "1e309",
        "-1e400",
        "1e99999999999999999999",
        "1e-99999999999999999999",
        "4.9e-324",
        "2.4703282292062327e-324",
        "2.4703282292062328e-324",
        "2e-324",
        "1e-400",
        "2.2250738585072011e-308",
        "9007199254740992",
        "9007199254740993",
        "9007199254740993.0000000000000000000000000000000000000000000000000000001",
        "9007199254740994",
        "9007199254740995",
        "1E5",
        "1e+5",
        "123456789012345678901234567890",
        "8.5e22",
        "1e23",
        "179769313486231580793728971405301e276",
        "1.00000000000000011102230246251565404236316680908203125",
        "1.00000000000000011102230246251565404236316680908203124",
        "1.00000000000000011102230246251565404236316680908203126",
    ]
    .map(str::to_owned)
    .to_vec();
    texts.push(format!("0.{}1", "0".repeat(400)));
    texts.push(format!("0.{}1e401", "0".repeat(400)));
    texts.push(format!("1{}e-400", "0".repeat(400)));
    // Halfway between two floats, and a digit beyond those that are kept tips it.
    texts.push(format!("9007199254740993.{}", "0".repeat(2000)));
    texts.push(format!("9007199254740993.{}1", "0".repeat(2000)));
    for number in hard().into_iter().chain(random(20_000)).filter(|number| number.is_finite()) {
        texts.extend([format!("{number:e}"), format!("{number:.3e}"), format!("{number:.25e}"), number.to_string()]);
        let middle = 0.5 * (number + f64::from_bits(number.to_bits() + 1));
        texts.extend(middle.is_finite().then(|| format!("{middle:.40e}")));
    }
    // Exactly halfway between neighbours, in all digits.
    for odd in [(1u64 << 53) | 1, (1 << 54) - 1, (12345678901234567 << 1) | 1] {
        for exponent in [0, 10, 100] {
            texts.push(format!("{odd}e{exponent}"));
        }
    }
    for text in texts {
        let expected: f64 = text.parse().expect("a number");
        assert_eq!(read(&text).to_bits(), expected.to_bits(), "{text}");
    }
}
