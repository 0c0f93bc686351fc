//! A shortest path as it is, of straight ways and arcs, and as points: with chords, or with tangents that keep the clearance.

use super::circles::{Path, Turn, along_arc, at};
use super::grown::Grown;
use crate::geometry::{Disc, Point, Segment};

/// The largest turn of a chord or of a tangent along an arc, in radians.
const TURN: f64 = 0.05;

/// How often a turn is halved at most: then a tangent is outside its arc by 1e-16 of the radius.
const HALVINGS: u32 = 22;

/// A way along a circle, between two angles.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bend {
    pub disc: Disc,
    pub turn: Turn,
    pub from: f64,
    pub to: f64,
}

/// A shortest path. It is straight between its ends and the bends.
#[derive(Debug, Clone)]
pub(super) struct Route {
    /// In metres.
    pub length: f64,
    pub ends: [Point; 2],
    pub bends: Vec<Bend>,
}

impl Route {
    /// The path with chords in place of arcs, around circles that are smaller by what they were larger, in metres.
    pub fn chords(&self, larger: f64) -> Path {
        let chords = self.bends.iter().flat_map(|bend| {
            let disc = Disc { radius: bend.disc.radius - larger, ..bend.disc };
            along_arc(bend.from, bend.to, bend.turn, TURN).map(move |angle| at(&disc, angle))
        });
        (self.length, self.through(chords))
    }

    /// The path with tangents in place of arcs: outside the circles, and free. Where there is no room for long ones they are
    /// shorter, down to the arc itself.
    pub fn tangents(&self, grown: &Grown) -> Path {
        let mut corners = Vec::new();
        for &Bend { disc, turn, from, to } in &self.bends {
            corners.push(at(&disc, from));
            let angles: Vec<f64> = along_arc(from, to, turn, TURN).collect();
            angles.windows(2).for_each(|pair| bend(grown, &disc, [pair[0], pair[1]], HALVINGS, &mut corners));
            corners.push(at(&disc, to));
        }
        (self.length, self.through(corners))
    }

    /// All points from end to end.
    fn through(&self, points: impl IntoIterator<Item = Point>) -> Vec<Point> {
        let [start, goal] = self.ends;
        let mut all: Vec<Point> = [start].into_iter().chain(points).chain([goal]).collect();
        all.dedup();
        all
    }
}

/// Adds the corners of tangents that go around a part of a circle, between the points where the first and the last one touch it.
fn bend(grown: &Grown, disc: &Disc, [from, to]: [f64; 2], halvings: u32, corners: &mut Vec<Point>) {
    let middle = 0.5 * (from + to);
    let outside = Disc { radius: disc.radius / libm::cos(0.5 * (to - from)), ..*disc };
    let corner = at(&outside, middle);
    let [first, last] = [Segment::new(at(disc, from), corner), Segment::new(corner, at(disc, to))];
    if halvings == 0 || [first, last].iter().all(|segment| grown.is_free(segment)) {
        corners.push(corner);
        return;
    }
    bend(grown, disc, [from, middle], halvings - 1, corners);
    bend(grown, disc, [middle, to], halvings - 1, corners);
}
