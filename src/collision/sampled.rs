//! The check of a motion that proves nothing: looks at evenly spaced configurations, as most planners do. What is thinner
//! than the step between two looks is missed.

/// Whether all looks at the fractions i / `samples` of a motion are free, i from 1 to `samples`. The start is not looked at.
/// Coarse steps first, finer ones between them, so that wide obstacles are found early.
pub(super) fn are_looks_free(samples: u32, is_free: impl Fn(f64) -> bool) -> bool {
    let Some(highest) = samples.checked_ilog2() else { return true };
    (0..=highest).rev().all(|level| {
        // The odd multiples of each power of two: every number once.
        let mut looks = (1 << level..=samples).step_by(2 << level);
        looks.all(|i| is_free(f64::from(i) / f64::from(samples)))
    })
}
