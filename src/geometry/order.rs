//! Sorting for whatever is not done often.

use super::Aabb;
use std::cmp::Ordering;

/// Up to this length items are sorted where they are, by insertion.
const SHORT: usize = 20;

/// Sorts numbers by a comparison in which no two of them are equal. All callers share one copy of the sort, which takes 4 kB in
/// the WebAssembly module for each type and each comparison that is known when it is compiled.
pub(crate) fn sort_numbers(numbers: &mut [u32], compare: &dyn Fn(usize, usize) -> Ordering) {
    numbers.sort_unstable_by(|&a, &b| compare(a as usize, b as usize));
}

/// Moves the number that would be at this place after sorting to there, all before it in front of it and the others behind it, by
/// a comparison in which no two of them are equal. O(n).
pub(crate) fn select_number(numbers: &mut [u32], place: usize, compare: &dyn Fn(usize, usize) -> Ordering) {
    numbers.select_nth_unstable_by(place, |&a, &b| compare(a as usize, b as usize));
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

/// Orders the numbers of boxes so that neighbours are adjacent: the halves along the longer side of the box around all middles,
/// each ordered likewise, until `leaf` or fewer are left. The first half is `leaf` times a power of two, if `leaf` is one: so
/// groups of groups are compact, too. O(n log n).
pub(crate) fn arrange(order: &mut [u32], boxes: &[Aabb], leaf: usize) {
    if order.len() <= leaf {
        sort_numbers(order, &|i, j| i.cmp(&j));
        return;
    }
    // Twice the middle, which does not overflow.
    let middle = |i: usize, axis: usize| boxes[i].min[axis] + boxes[i].max[axis];
    let spread = |axis: usize| {
        let most = order.iter().map(|&i| middle(i as usize, axis)).fold(f64::NEG_INFINITY, f64::max);
        most - order.iter().map(|&i| middle(i as usize, axis)).fold(f64::INFINITY, f64::min)
    };
    let axis = usize::from(spread(1) > spread(0));
    let half = order.len().next_power_of_two() / 2;
    select_number(order, half, &|i, j| middle(i, axis).total_cmp(&middle(j, axis)).then(i.cmp(&j)));
    let (front, back) = order.split_at_mut(half);
    arrange(front, boxes, leaf);
    arrange(back, boxes, leaf);
}
