//! How far trees grow in one step: by a step that was given, or by steps that adapt to the scene.
//!
//! Without a step, each vertex has its own. A step that is refused halves that of its vertex, down to a smallest; one that is
//! free doubles it, and the new vertex begins with as much. So steps become about as long as free motions are, whatever the size
//! of the scene. To adapt a length of each vertex by its failures and successes is the idea of Jaillet, Yershova, LaValle and
//! Simeon 2005, "Adaptive tuning of the sampling domain for dynamic-domain RRTs": there it limits which samples are accepted,
//! here how far the tree grows.

use super::groups::step_in;
use crate::error::Error;
use crate::graph::VertexId;

/// The smallest step that adapting ends at, as a fraction of the longest.
const SMALLEST: f64 = 1.0 / 1024.0;

/// The steps of a tree.
#[derive(Debug, Clone)]
pub(super) struct Strides {
    /// The step given, or the longest.
    longest: f64,
    /// By vertex, as a fraction of the longest; 1 for a vertex that is missing. `None` if a step was given.
    own: Option<Vec<f64>>,
}

impl Strides {
    /// The step given, or steps that adapt, in a space of this extent.
    ///
    /// # Errors
    /// As [`step_in`].
    pub fn new(step: Option<f64>, extent: f64) -> Result<Self, Error> {
        Ok(Self { longest: step_in(step, extent)?, own: step.is_none().then(Vec::new) })
    }

    /// The longest step.
    pub fn longest(&self) -> f64 {
        self.longest
    }

    /// Whether steps adapt.
    pub fn adapts(&self) -> bool {
        self.own.is_some()
    }

    /// The step from a vertex.
    pub fn of(&self, vertex: VertexId) -> f64 {
        let part = self.own.as_ref().and_then(|own| own.get(vertex.index())).copied().unwrap_or(1.0);
        part * self.longest
    }

    /// Notes that a step from a vertex was refused.
    pub fn refused(&mut self, vertex: VertexId) {
        if let Some(part) = self.part(vertex) {
            *part = (*part / 2.0).max(SMALLEST);
        }
    }

    /// Notes that a step from a vertex was free, and the new vertex that it led to.
    pub fn free(&mut self, vertex: VertexId, new: VertexId) {
        let Some(part) = self.part(vertex) else { return };
        *part = (2.0 * *part).min(1.0);
        let part = *part;
        *self.part(new).expect("steps adapt") = part;
    }

    fn part(&mut self, vertex: VertexId) -> Option<&mut f64> {
        let own = self.own.as_mut()?;
        if own.len() <= vertex.index() {
            own.resize(vertex.index() + 1, 1.0);
        }
        own.get_mut(vertex.index())
    }
}
