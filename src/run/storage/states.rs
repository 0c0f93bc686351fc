//! Whether all of a saved roadmap is free.

use super::{RoadmapDocument, damaged};
use crate::error::Error;
use crate::problem::Validity;
use crate::space::Space;

/// The states of the vertices; checks every vertex and proves every edge by `validity`.
///
/// # Errors
/// `invalid-roadmap` with the pointer of the first vertex or edge that is not free.
pub(crate) fn checked_states<S: Space>(
    space: &S,
    validity: &dyn Validity<S::State>,
    document: &RoadmapDocument,
) -> Result<Vec<S::State>, Error> {
    if let Some(i) = (0..space.dimension()).find(|&i| space.period(i).is_finite() != document.circles[i]) {
        return Err(damaged(
            format!("/circles/{i}"),
            format!("coordinate {i} wraps in the roadmap or in the space, but not in both"),
        ));
    }
    let mut states = Vec::with_capacity(document.vertex_count());
    for (i, row) in document.rows().enumerate() {
        let state = space.state(row);
        let is_same = space.coordinates(&state).iter().zip(row).all(|(a, b)| a.to_bits() == b.to_bits());
        let why = match () {
            () if !is_same || !space.contains(&state) => "lies outside the space",
            () if !validity.is_free(&state) => "is in collision",
            () => {
                states.push(state);
                continue;
            }
        };
        return Err(damaged(format!("/vertices/{i}"), format!("vertex {i} {row:?} {why}")));
    }
    for (i, &[from, to]) in document.edges.iter().enumerate() {
        if !validity.is_motion_free(&states[from as usize], &states[to as usize]) {
            let sentence = format!("edge {i} from vertex {from} to vertex {to} is not free");
            return Err(damaged(format!("/edges/{i}"), sentence));
        }
    }
    Ok(states)
}
