//! A world that is prepared for shortest paths.

use super::arcs::Arcs;
use super::circles::Path;
use super::dead_ends::DeadEnds;
use super::grown::Grown;
use super::mesh::Mesh;
use super::polyanya::Search;
use super::route::Route;
use super::sight::Sight;
use super::tangents::{Known, Tangents};
use crate::error::Error;
use crate::geometry::{Aabb, Point, Segment};
use crate::scenario::World;

/// The world of a disc, prepared for the shortest paths between any two positions.
pub(super) struct Prepared {
    pub grown: Grown,
    mesh: Mesh,
    arcs: Arcs,
    ends: DeadEnds,
    /// All tangents, where they are known.
    tangents: Option<Tangents>,
}

impl Prepared {
    /// Prepares a world for a disc of a radius, in metres.
    pub fn new(world: &World, bounds: Aabb, radius: f64) -> Self {
        let grown = Grown::new(world, bounds, radius);
        let mesh = Mesh::new(&grown);
        let arcs = Arcs::new(&grown, &mesh);
        let ends = DeadEnds::new(&mesh, &arcs);
        Self { grown, mesh, arcs, ends, tangents: None }
    }

    /// Finds all tangents, unless they are too many.
    pub fn with_tangents(mut self) -> Self {
        self.tangents = Tangents::new(&self.sight(&[]), &self.grown);
        self
    }

    /// The number of known tangents.
    pub fn known(&self) -> Option<usize> {
        self.tangents.as_ref().map(Tangents::len)
    }

    /// The shortest path between two positions: its length and its points, where arcs are replaced by chords of at most 0.05
    /// radians. `None` if there is no path.
    ///
    /// # Errors
    /// `start-in-collision`, `goal-in-collision`.
    pub fn shortest(&self, ends: [Point; 2]) -> Result<Option<Path>, Error> {
        Ok(self.route(ends)?.map(|route| route.chords(self.grown.larger)))
    }

    /// The shortest path between two positions with its arcs; `None` if there is no path.
    ///
    /// # Errors
    /// `start-in-collision`, `goal-in-collision`.
    pub fn route(&self, ends: [Point; 2]) -> Result<Option<Route>, Error> {
        self.grown.check(ends)?;
        if ends[0] == ends[1] {
            return Ok(Some(Route { length: 0.0, ends, bends: Vec::new() }));
        }
        let straight = Segment::new(ends[0], ends[1]);
        if self.grown.is_free(&straight) {
            return Ok(Some(Route { length: (ends[1] - ends[0]).norm(), ends, bends: Vec::new() }));
        }
        let triangles = ends.map(|p| self.mesh.locate(p, 0));
        if !self.ends.are_joined(triangles) {
            return Ok(None);
        }
        let sight = self.sight(&triangles);
        let known = self.tangents.as_ref().map(|tangents| Known::new(tangents, &sight, ends[1], triangles[1]));
        Ok(Search::new(&sight, &self.grown, known.as_ref(), ends, triangles).run())
    }

    /// What is seen by what is not in a dead end, or in the same one as one of the triangles.
    fn sight(&self, triangles: &[u32]) -> Sight<'_> {
        Sight::new(&self.mesh, &self.arcs, &self.ends, triangles)
    }
}
