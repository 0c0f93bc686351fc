//! Sorting for whatever is not done often.

use std::cmp::Ordering;

/// Up to this length items are sorted where they are, by insertion.
const SHORT: usize = 20;

/// Sorts numbers by a comparison in which no two of them are equal. All callers share one copy of the sort, which takes 4 kB in
/// the WebAssembly module for each type and each comparison that is known when it is compiled.
pub(crate) fn sort_numbers(numbers: &mut [u32], compare: &dyn Fn(usize, usize) -> Ordering) {
    numbers.sort_unstable_by(|&a, &b| compare(a as usize, b as usize));
}

/// Sorts items by a comparison; equal ones keep their order.
pub(crate) fn sort_stably<T>(items: &mut Vec<T>, compare: impl Fn(&T, &T) -> Ordering) {
    if items.len() <= SHORT {
        for i in 1..items.len() {
            let mut at = i;
            while at > 0 && compare(&items[at - 1], &items[at]).is_gt() {
                items.swap(at - 1, at);
                at -= 1;
            }
        }
        return;
    }
    let mut order: Vec<u32> = (0..items.len() as u32).collect();
    sort_numbers(&mut order, &|i, j| compare(&items[i], &items[j]).then(i.cmp(&j)));
    let mut unsorted: Vec<Option<T>> = items.drain(..).map(Some).collect();
    items.extend(order.into_iter().filter_map(|i| unsorted[i as usize].take()));
}
