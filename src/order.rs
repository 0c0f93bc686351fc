//! Sorting and selecting among numbered things by a rule. The rule is handed over as it is, so that in WebAssembly, where size
//! counts, both are compiled once.

use std::cmp::Ordering;

/// Which of two numbered things comes first; equal only for a thing and itself.
pub type Rule<'a> = &'a dyn Fn(u32, u32) -> Ordering;

/// Sorts the numbers by the rule. O(n log n). A heap (Williams 1964, "Algorithm 232: Heapsort"): a tenth of the code of the
/// standard library's sort, for orders that are found once.
#[inline(never)]
pub fn sort(numbers: &mut [u32], rule: Rule) {
    let sift = |length: usize, mut parent: usize, numbers: &mut [u32]| loop {
        let mut child = 2 * parent + 1;
        if child + 1 < length && rule(numbers[child], numbers[child + 1]) == Ordering::Less {
            child += 1;
        }
        if child >= length || rule(numbers[parent], numbers[child]) != Ordering::Less {
            return;
        }
        numbers.swap(parent, child);
        parent = child;
    };
    let length = numbers.len();
    (0..length / 2).rev().for_each(|parent| sift(length, parent, numbers));
    for end in (1..length).rev() {
        numbers.swap(0, end);
        sift(end, 0, numbers);
    }
}

/// Puts in place `nth` what would stand there if all were sorted, before it what comes before. O(n).
///
/// # Panics
/// Where there is no such place.
#[cfg_attr(not(target_arch = "wasm32"), inline)]
pub fn select(numbers: &mut [u32], nth: usize, rule: Rule) {
    numbers.select_nth_unstable_by(nth, |&a, &b| rule(a, b));
}
