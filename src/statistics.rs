//! Statistics of samples: intervals, quartiles, distributions, and paired comparisons.
//!
//! A sample is a slice of numbers in which NaN stands for a missing value, such as the length of a path that was not found. Every
//! statistic gives `n`, the number of values, and `missing`. Intervals have a confidence of 95 %. Statistics need no more than
//! the sample; they may differ between platforms in their last bits, as rows of trials never do.

use crate::random::{Random, Stream};
use serde::Serialize;
use statrs::distribution::{ContinuousCDF, StudentsT};
use std::cmp::Ordering;
use std::f64::consts::SQRT_2;

/// The 97.5 % quantile of the standard normal distribution.
const NORMAL: f64 = 1.959_963_984_540_054;

/// The half width of an interval that [`Mean::needed`] asks for, as a share of the mean.
const PRECISION: f64 = 0.05;

/// The level below which a difference is called significant, before it is divided by the number of tests.
const LEVEL: f64 = 0.05;

/// Values that differ by at most this share of the larger one are equal.
const EQUAL: f64 = 1e-9;

/// Up to this number of differences the distribution of signed ranks is computed exactly: their sums, in doubled ranks, are
/// counted in 64-bit floats without rounding.
const EXACT: usize = 50;

/// The values that are not missing, and how many are.
fn present(sample: &[f64]) -> (Vec<f64>, u64) {
    let values: Vec<f64> = sample.iter().copied().filter(|value| !value.is_nan()).collect();
    let missing = (sample.len() - values.len()) as u64;
    (values, missing)
}

fn sorted(sample: &[f64]) -> (Vec<f64>, u64) {
    let (mut values, missing) = present(sample);
    values.sort_unstable_by(f64::total_cmp);
    (values, missing)
}

/// A share of trials, with an interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Share {
    /// The number of trials.
    pub n: u64,
    /// The trials of which it is not known.
    pub missing: u64,
    /// The trials of which it is true.
    pub count: u64,
    /// `count / n`; none without trials.
    pub share: Option<f64>,
    /// The lower end of the interval.
    pub low: Option<f64>,
    /// The upper end.
    pub high: Option<f64>,
}

/// The share of values that are not 0, with the score interval of E. B. Wilson, "Probable inference, the law of succession, and
/// statistical inference", 1927: unlike the interval of the textbook it is right for few trials and for shares near 0 and 1.
pub fn share(sample: &[f64]) -> Share {
    let (values, missing) = present(sample);
    let count = values.iter().filter(|value| **value != 0.0).count() as u64;
    let n = values.len() as u64;
    if n == 0 {
        return Share { n, missing, count, share: None, low: None, high: None };
    }
    let (size, z) = (n as f64, NORMAL * NORMAL);
    let p = count as f64 / size;
    let middle = (p + z / (2.0 * size)) / (1.0 + z / size);
    let half = NORMAL / (1.0 + z / size) * (p * (1.0 - p) / size + z / (4.0 * size * size)).sqrt();
    let low = if count == 0 { 0.0 } else { middle - half };
    let high = if count == n { 1.0 } else { middle + half };
    Share { n, missing, count, share: Some(p), low: Some(low), high: Some(high) }
}

/// The five numbers of a box plot.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Quartiles {
    /// The number of values.
    pub n: u64,
    /// The missing ones.
    pub missing: u64,
    /// The smallest value, the quartiles, and the largest value; none without values.
    pub values: Option<[f64; 5]>,
}

/// The quartiles of type 7 of R. J. Hyndman and Y. Fan, "Sample quantiles in statistical packages", 1996: linear between the two
/// nearest values, as in NumPy and R by default. O(n log n).
pub fn quartiles(sample: &[f64]) -> Quartiles {
    let (values, missing) = sorted(sample);
    let at = |quarter: usize| {
        let position = (values.len() - 1) * quarter;
        let (below, part) = (position / 4, (position % 4) as f64 / 4.0);
        let above = (below + 1).min(values.len() - 1);
        values[below] + (values[above] - values[below]) * part
    };
    let five = (!values.is_empty()).then(|| [0, 1, 2, 3, 4].map(at));
    Quartiles { n: values.len() as u64, missing, values: five }
}

/// An empirical distribution function.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Ecdf {
    /// The number of values.
    pub n: u64,
    /// The missing ones.
    pub missing: u64,
    /// The distinct values, ascending.
    pub values: Vec<f64>,
    /// For each, the share of all trials, the missing ones included, with at most this value.
    pub shares: Vec<f64>,
}

/// The empirical distribution function. Missing values are in the denominator: of the work until a path is found, it is the share
/// of all trials that are solved with at most that work, and ends at the success rate. O(n log n).
pub fn ecdf(sample: &[f64]) -> Ecdf {
    let (values, missing) = sorted(sample);
    let mut ecdf = Ecdf { n: values.len() as u64, missing, values: Vec::new(), shares: Vec::new() };
    for (i, value) in values.iter().enumerate() {
        if values.get(i + 1) != Some(value) {
            ecdf.values.push(*value);
            ecdf.shares.push((i + 1) as f64 / sample.len() as f64);
        }
    }
    ecdf
}

/// A mean with an interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Mean {
    /// The number of values.
    pub n: u64,
    /// The missing ones.
    pub missing: u64,
    /// The mean; none without values.
    pub mean: Option<f64>,
    /// The standard deviation of the sample; none of fewer than two values, as what follows.
    pub deviation: Option<f64>,
    /// The lower end of the interval.
    pub low: Option<f64>,
    /// The upper end.
    pub high: Option<f64>,
    /// How many values are needed until the interval is at most 5 % of the mean to each side, if they scatter like these; none
    /// if the mean is 0.
    pub needed: Option<u64>,
}

/// The mean with the interval of Student's t distribution. It assumes that means of this number of values are about normal.
pub fn mean(sample: &[f64]) -> Mean {
    let (values, missing) = present(sample);
    let n = values.len() as u64;
    let none = Mean { n, missing, mean: None, deviation: None, low: None, high: None, needed: None };
    if n == 0 {
        return none;
    }
    let mean = values.iter().sum::<f64>() / n as f64;
    if n == 1 {
        return Mean { mean: Some(mean), ..none };
    }
    let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
    let deviation = (squares / (n - 1) as f64).sqrt();
    let half = |n: u64| quantile_of_t(n - 1) * deviation / (n as f64).sqrt();
    Mean {
        mean: Some(mean),
        deviation: Some(deviation),
        low: Some(mean - half(n)),
        high: Some(mean + half(n)),
        needed: needed(PRECISION * mean.abs(), half),
        ..none
    }
}

/// The mean with the percentile interval of the bootstrap (B. Efron 1979, "Bootstrap methods: another look at the jackknife"):
/// the values are drawn again 10,000 times, with replacement and always in the same way. For values of which few lie far from the
/// others, such as the shares of floors. O(n).
pub fn resampled(sample: &[f64]) -> Mean {
    const TIMES: usize = 10_000;
    let (values, _) = present(sample);
    let mut random = Random::new(0, Stream::Resamples);
    let mut draw = || values[random.below(values.len() as u64) as usize];
    let mean = mean(sample);
    if values.len() < 2 {
        return mean;
    }
    let again: Vec<f64> =
        (0..TIMES).map(|_| values.iter().map(|_| draw()).sum::<f64>() / values.len() as f64).collect();
    let (again, _) = sorted(&again);
    Mean { low: Some(again[TIMES / 40]), high: Some(again[TIMES - 1 - TIMES / 40]), ..mean }
}

/// The 97.5 % quantile of Student's t distribution with this number of degrees of freedom, at least one.
fn quantile_of_t(freedom: u64) -> f64 {
    StudentsT::new(0.0, 1.0, freedom as f64).expect("a positive number of degrees").inverse_cdf(0.975)
}

/// The least n from 2 on for which the half width, which falls with n, is at most `wanted`.
fn needed(wanted: f64, half: impl Fn(u64) -> f64) -> Option<u64> {
    const MOST: u64 = 1 << 40;
    let (mut low, mut high) = (1, 2);
    while half(high) > wanted {
        (low, high) = (high, high * 2);
        if high > MOST {
            return None;
        }
    }
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        if half(middle) > wanted { low = middle } else { high = middle }
    }
    Some(high)
}

/// The moving average: for each value the mean of it and of those before it, `width` in all; NaN while there are fewer, and if
/// one of them is missing. O(n width).
pub fn moving_average(sample: &[f64], width: usize) -> Vec<f64> {
    let average = |i: usize| match (i + 1).checked_sub(width) {
        Some(first) if width > 0 => sample[first..=i].iter().sum::<f64>() / width as f64,
        _ => f64::NAN,
    };
    (0..sample.len()).map(average).collect()
}

/// Two samples of the same trials compared: of each pair, which value is smaller.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Paired {
    /// The pairs of which both values are known.
    pub n: u64,
    /// The other pairs.
    pub missing: u64,
    /// The pairs in which the first value is smaller.
    pub smaller: u64,
    /// The pairs in which it is larger.
    pub larger: u64,
    /// The median of the first value minus the second; none without pairs.
    pub median: Option<f64>,
    /// The two-sided p-value of the sign test: how probable it is that the pairs differ in one direction so often, if both
    /// directions are equally likely.
    pub sign_p: f64,
    /// The two-sided p-value of Wilcoxon's test, which ranks the differences by their size.
    pub wilcoxon_p: f64,
    /// The result in words.
    pub words: String,
}

/// What a comparison is called.
#[derive(Debug, Clone, Copy)]
pub struct Names<'a> {
    /// The first sample.
    pub a: &'a str,
    /// The second sample.
    pub b: &'a str,
    /// What was measured, such as `length`.
    pub measure: &'a str,
}

/// Compares two samples pair by pair; entries with the same index belong to the same trial. `tests` is how many comparisons are
/// made together: a difference is called significant if its p-value is at most 5 % divided by it (Bonferroni's correction).
/// Values that differ by at most 1e-9 of the larger one are equal: the same path, whose length was summed in another order.
///
/// The sign test is exact. Wilcoxon's test (F. Wilcoxon, "Individual comparisons by ranking methods", 1945) drops pairs without a
/// difference and gives equal sizes their mean rank; it is exact for up to 50 differences, equal sizes included, and the normal
/// approximation with the correction for equal sizes for more. O(n log n), exact O(n^3) for n up to 50.
pub fn paired(a: &[f64], b: &[f64], names: Names, tests: u64) -> Paired {
    let (differences, missing) = present(&a.iter().zip(b).map(|(a, b)| difference(*a, *b)).collect::<Vec<_>>());
    let count = |wanted| differences.iter().filter(|value| value.partial_cmp(&&0.0) == Some(wanted)).count() as u64;
    let (smaller, larger) = (count(Ordering::Less), count(Ordering::Greater));
    let sign_p = sign_test(smaller, larger);
    let wilcoxon_p = wilcoxon(&differences);
    let n = differences.len() as u64;
    let median = quartiles(&differences).values.map(|five| five[2]);
    let words = in_words(names, [n, smaller, larger], wilcoxon_p, tests.max(1));
    Paired { n, missing, smaller, larger, median, sign_p, wilcoxon_p, words }
}

/// The difference of two values; 0 where only rounding makes it.
fn difference(a: f64, b: f64) -> f64 {
    let difference = a - b;
    if difference.is_finite() && difference.abs() <= EQUAL * a.abs().max(b.abs()) { 0.0 } else { difference }
}

fn in_words(Names { a, b, measure }: Names, [n, smaller, larger]: [u64; 3], p: f64, tests: u64) -> String {
    if n == 0 {
        return format!("No pair has a {measure} of both {a} and {b}.");
    }
    let of = if tests > 1 { format!(" of {tests} tests") } else { String::new() };
    let verdict = if p > LEVEL / tests as f64 { "A difference is not shown" } else { "The difference is significant" };
    let equal = n - smaller - larger;
    let rounded = libm::rint(p * 1e4) / 1e4;
    let p = if rounded > 0.0 { format!("= {rounded}") } else { "< 0.0001".to_owned() };
    format!(
        "The {measure} of {a} is smaller than that of {b} in {smaller} of {n} pairs, larger in {larger}, equal in {equal}. \
         {verdict} at 5 %{of} (Wilcoxon's test, p {p})."
    )
}

/// The two-sided p-value of the sign test: the numbers of differences in one direction and in the other.
///
/// The sum of binomial coefficients up to the smaller of the two over 2^n, without a transcendental function, so that it is the
/// same on every platform. O(n).
fn sign_test(smaller: u64, larger: u64) -> f64 {
    let (n, few) = (smaller + larger, smaller.min(larger));
    // Numbers are kept below 2^HALF, and halvings that are still to be done are counted.
    const HALF: u64 = 512;
    let (mut term, mut sum, mut halvings) = (1.0, 1.0, n);
    for i in 0..few {
        term *= (n - i) as f64 / (i + 1) as f64;
        sum += term;
        if sum > libm::ldexp(1.0, HALF as i32) && halvings >= HALF {
            (term, sum) = (libm::ldexp(term, -(HALF as i32)), libm::ldexp(sum, -(HALF as i32)));
            halvings -= HALF;
        }
    }
    (2.0 * libm::ldexp(sum, -(halvings.min(10_000) as i32))).min(1.0)
}

/// The two-sided p-value of the signed-rank test; 1 without differences.
fn wilcoxon(differences: &[f64]) -> f64 {
    let sizes: Vec<f64> = differences.iter().filter(|value| **value != 0.0).map(|value| value.abs()).collect();
    let (sizes, _) = sorted(&sizes);
    // Twice the ranks, so that mean ranks of equal sizes are whole numbers.
    let mut ranks = Vec::with_capacity(sizes.len());
    let mut ties = 0.0;
    for equal in sizes.chunk_by(|a, b| a == b) {
        let size = equal.len() as f64;
        ties += size * size * size - size;
        ranks.resize(ranks.len() + equal.len(), 2 * ranks.len() + equal.len() + 1);
    }
    let rank = |value: &f64| ranks[sizes.partition_point(|size| size < value)];
    let positive: usize = differences.iter().filter(|value| **value > 0.0).map(rank).sum();
    if ranks.len() <= EXACT { exact(&ranks, positive) } else { normal(ranks.len() as f64, ties, positive as f64 / 2.0) }
}

/// Of all assignments of signs to the doubled ranks, the share whose sum of positive ones is as far from its mean as `positive`.
fn exact(ranks: &[usize], positive: usize) -> f64 {
    let total: usize = ranks.iter().sum();
    let mut ways = vec![0.0; total + 1];
    ways[0] = 1.0;
    for rank in ranks {
        (*rank..=total).rev().for_each(|sum| ways[sum] += ways[sum - rank]);
    }
    let tail = positive.min(total - positive);
    let all: f64 = ways.iter().sum();
    (2.0 * ways[..=tail].iter().sum::<f64>() / all).min(1.0)
}

/// The normal approximation: `ties` is the sum of t^3 - t over groups of t equal sizes, `positive` the sum of positive ranks.
fn normal(n: f64, ties: f64, positive: f64) -> f64 {
    let mean = n * (n + 1.0) / 4.0;
    let variance = n * (n + 1.0) * (2.0 * n + 1.0) / 24.0 - ties / 48.0;
    libm::erfc((positive - mean).abs() / variance.sqrt() / SQRT_2)
}
