//! The obstacles and bounds of a scenario, prepared once for every collision query.

use super::Obstacles;
use crate::geometry::{Aabb, convex_pieces};
use crate::scenario::{Obstacle, World};
use std::sync::{Arc, OnceLock};

/// A world prepared for collision queries: obstacles with their bounding boxes and faces, and their convex pieces. Cheap to
/// clone: clones share what was prepared.
#[derive(Clone)]
pub struct CollisionWorld(Arc<Prepared>);

struct Prepared {
    bounds: Option<Aabb>,
    obstacles: Arc<Obstacles>,
    /// Computed on first use: discs and viewers do without.
    pieces: OnceLock<Arc<Obstacles>>,
}

impl CollisionWorld {
    pub(super) fn bounds(&self) -> Option<&Aabb> {
        self.0.bounds.as_ref()
    }

    /// The obstacles as they are.
    pub(crate) fn obstacles(&self) -> Arc<Obstacles> {
        Arc::clone(&self.0.obstacles)
    }

    /// The obstacles with concave polygons cut into convex pieces.
    pub(super) fn pieces(&self) -> Arc<Obstacles> {
        let obstacles = &self.0.obstacles;
        let is_convex = |shape: &Obstacle| match shape {
            Obstacle::Polygon(polygon) => polygon.is_convex(),
            Obstacle::Disc(_) => true,
        };
        let cut = || {
            if obstacles.shapes.iter().all(is_convex) {
                return Arc::clone(obstacles);
            }
            let pieces: Vec<Obstacle> = obstacles.shapes.iter().flat_map(pieces_of).collect();
            Arc::new(Obstacles::new(pieces))
        };
        Arc::clone(self.0.pieces.get_or_init(cut))
    }
}

/// O(n log n) for n obstacles.
impl From<&World> for CollisionWorld {
    fn from(world: &World) -> Self {
        let obstacles = Arc::new(Obstacles::new(Arc::clone(&world.obstacles)));
        Self(Arc::new(Prepared { bounds: world.bounds, obstacles, pieces: OnceLock::new() }))
    }
}

/// The convex pieces of an obstacle.
fn pieces_of(obstacle: &Obstacle) -> Vec<Obstacle> {
    match obstacle {
        Obstacle::Polygon(polygon) => convex_pieces(polygon).into_iter().map(Obstacle::Polygon).collect(),
        Obstacle::Disc(_) => vec![obstacle.clone()],
    }
}
