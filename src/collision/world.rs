//! The obstacles and bounds of a scenario, prepared once for every collision query.

use super::Obstacles;
use super::obstacles::MOST_CORNERS;
use crate::geometry::{Aabb, small_convex_pieces};
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

    /// The obstacles with concave polygons, and those of many corners, cut into small convex pieces, walls into segments with a
    /// width, and of polygons with holes the border: what does not meet it is inside or outside with all of it, so that one point
    /// of the robot decides about the inside.
    pub(super) fn pieces(&self) -> Arc<Obstacles> {
        let obstacles = &self.0.obstacles;
        // Discs, small convex polygons and walls of one segment.
        let is_core = |i: usize| obstacles.disc(i).is_some() || !obstacles.faces(i).is_empty();
        let cut = || {
            if (0..obstacles.len()).all(is_core) {
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

/// The convex pieces of an obstacle, or of its border.
fn pieces_of(obstacle: &Obstacle) -> Vec<Obstacle> {
    match obstacle {
        Obstacle::Polygon(polygon) => {
            small_convex_pieces(polygon, MOST_CORNERS).into_iter().map(Obstacle::Polygon).collect()
        }
        Obstacle::PolygonWithHoles(polygon) => polygon.border().map(Obstacle::Wall).collect(),
        Obstacle::Wall(wall) => wall.pieces().map(Obstacle::Wall).collect(),
        Obstacle::Disc(_) => vec![obstacle.clone()],
    }
}
