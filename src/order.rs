//! Sorting and selecting among numbered things by a rule. The rule is handed over as it is, so that in WebAssembly, where size
//! counts, both are compiled once.

use std::cmp::Ordering;

/// Which of two numbered things comes first; equal only for a thing and itself.
pub type Rule<'a> = &'a dyn Fn(u32, u32) -> Ordering;

/// Sorts the numbers by the rule. O(n log n).
#[cfg_attr(not(target_arch = "wasm32"), inline)]
pub fn sort(numbers: &mut [u32], rule: Rule) {
    numbers.sort_unstable_by(|&a, &b| rule(a, b));
}

/// Puts in place `nth` what would stand there if all were sorted, before it what comes before. O(n).
///
/// # Panics
/// Where there is no such place.
#[cfg_attr(not(target_arch = "wasm32"), inline)]
pub fn select(numbers: &mut [u32], nth: usize, rule: Rule) {
    numbers.select_nth_unstable_by(nth, |&a, &b| rule(a, b));
}
