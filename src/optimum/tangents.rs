//! All free tangents between the arcs of a world: with them a search looks for none.
//!
//! Most tangents lead into a corner of the world out of which no other tangent leads, so that a path may take them only near its
//! goal. They are known beforehand (after Oh and Leong 2017, "Edge N-level sparse visibility graphs: fast optimal any-angle
//! pathfinding using hierarchical taut paths").

use super::arcs::{Arcs, Part};
use super::circles::{Tangent, Turn};
use super::grown::Grown;
use super::rays::{Rays, Source};
use super::sight::{Sight, Touch};
use crate::geometry::{Point, sort_numbers};

/// By how much a tangent may leave an arc before another one reaches it, in radians: what covers rounding.
const SLACK: f64 = 1e-9;

/// The most triangles, and parts of arcs in them, that all arcs may see together; each counts once for each part of an arc that
/// sees it, and for each turn. They take some seconds.
const MOST_SEEN: u64 = 16_000_000;

/// The most tangents: they take 64 megabytes, and twice that while they are sorted.
const MOST_TANGENTS: usize = 500_000;

/// The parts of arcs that are sampled beforehand.
const SAMPLED: usize = 64;

/// No number.
const NONE: u32 = u32::MAX;

/// Where a tangent reaches an arc, or leaves it, and how the path turns there.
#[derive(Debug, Clone, Copy)]
pub(super) struct End {
    pub arc: u32,
    pub turn: Turn,
    pub angle: f64,
    pub point: Point,
}

impl End {
    /// The same end of a path in the other direction.
    fn reversed(self) -> Self {
        Self { turn: self.turn.reversed(), ..self }
    }

    /// How far along its arc it is, in the direction of the turn.
    fn place(&self, arcs: &Arcs) -> f64 {
        arcs.arcs[self.arc as usize].place(self.turn, self.angle)
    }
}

/// A tangent, in the direction in which a path leaves one arc for another.
#[derive(Debug, Clone, Copy)]
pub(super) struct Way {
    /// The angle at which it leaves its arc, and how far along the arc that is in the direction of the turn.
    pub left_at: f64,
    place: f64,
    pub to: End,
    pub length: f64,
    /// The same in the other direction.
    twin: u32,
    /// Whether a path can continue from its end along tangents without limit.
    is_endless: bool,
}

/// All free tangents between arcs.
pub(super) struct Tangents {
    /// Those that leave an arc with a turn are in a range of all, in the order of the turn.
    first: Vec<u32>,
    ways: Vec<Way>,
}

/// Which tangents a path to a goal may take.
struct Useful(Vec<u64>);

impl Useful {
    fn has(&self, way: u32) -> bool {
        self.0[way as usize / 64] >> (way % 64) & 1 == 1
    }

    fn add(&mut self, way: u32) {
        self.0[way as usize / 64] |= 1 << (way % 64);
    }
}

impl Tangents {
    /// Finds them; `None` if they are more than [`MOST_TANGENTS`], or if the arcs see more than [`MOST_SEEN`]. O(n s) for n arcs,
    /// from each of which s triangles are seen.
    pub fn new(sight: &Sight<'_>, grown: &Grown) -> Option<Self> {
        let arcs = sight.arcs;
        // Sample some parts to estimate what all of them see.
        let step = arcs.parts.len().div_ceil(SAMPLED).max(1);
        let mut most = MOST_SEEN / step as u64;
        for part in arcs.parts.iter().step_by(step) {
            see(sight, part, &mut most, &mut |_, _| ())?;
        }
        let mut most = MOST_SEEN;
        let (mut slots, mut ways) = (Vec::new(), Vec::new());
        // For both turns there and here, the arc from which each other one was reached last: some are reached twice.
        let mut last_from = vec![NONE; 4 * arcs.arcs.len()];
        for part in &arcs.parts {
            see(sight, part, &mut most, &mut |leaving, Touch { arc, turn, tangent }| {
                let known = &mut last_from[(2 * slot(arc, turn) + u32::from(leaving == Turn::Right)) as usize];
                let Tangent { segment, angles: [first, last] } = tangent;
                // Each tangent is found from both arcs; that from the lower number is kept.
                if arc <= part.arc || std::mem::replace(known, part.arc) == part.arc || !grown.is_free(&segment) {
                    return;
                }
                let from = End { arc: part.arc, turn: leaving, angle: first, point: segment.a };
                let to = End { arc, turn, angle: last, point: segment.b };
                let length = (segment.b - segment.a).norm();
                // Both directions, one after the other.
                for [from, to] in [[from, to], [to.reversed(), from.reversed()]] {
                    let (twin, place) = (ways.len() as u32 ^ 1, from.place(arcs));
                    slots.push(slot(from.arc, from.turn));
                    ways.push(Way { left_at: from.angle, place, to, length, twin, is_endless: true });
                }
            })?;
            if ways.len() > 2 * MOST_TANGENTS {
                return None;
            }
        }
        let mut tangents = Self::sorted(&slots, &ways, 2 * arcs.arcs.len());
        tangents.mark_finite(arcs);
        Some(tangents)
    }

    /// Tangents in the order of the arc and turn that they leave, and of the turn.
    fn sorted(slots: &[u32], ways: &[Way], count: usize) -> Self {
        let mut order: Vec<u32> = (0..ways.len() as u32).collect();
        sort_numbers(&mut order, &|i, j| {
            slots[i].cmp(&slots[j]).then(ways[i].place.total_cmp(&ways[j].place)).then(i.cmp(&j))
        });
        let mut number = vec![0; ways.len()];
        order.iter().enumerate().for_each(|(new, &old)| number[old as usize] = new as u32);
        let mut first = vec![0; count + 1];
        slots.iter().for_each(|&slot| first[slot as usize + 1] += 1);
        (0..count).for_each(|i| first[i + 1] += first[i]);
        let moved = |old: u32| Way { twin: number[ways[old as usize].twin as usize], ..ways[old as usize] };
        Self { first, ways: order.into_iter().map(moved).collect() }
    }

    /// Marks the tangents from which no path can continue without limit. O(n) for n tangents.
    fn mark_finite(&mut self, arcs: &Arcs) {
        // For each arc and turn: `from` is the first way whose twin is not marked yet, `to` is one past the last endless way.
        let (mut from, mut to) = (self.first.clone(), self.first[1..].to_vec());
        let mut open: Vec<u32> = (0..to.len() as u32).collect();
        while let Some(at) = open.pop() {
            let start = self.first[at as usize];
            let end = &mut to[at as usize];
            while *end > start && !self.ways[*end as usize - 1].is_endless {
                *end -= 1;
            }
            let reach = match *end {
                end if end == start => f64::NEG_INFINITY,
                _ if arcs.arcs[at as usize / 2].is_whole() => f64::INFINITY,
                end => self.ways[end as usize - 1].place + SLACK,
            };
            // What reaches the arc with this turn is the other direction of what leaves it with the other one.
            let (back, last) = (at ^ 1, self.first[(at ^ 1) as usize + 1]);
            let next = &mut from[back as usize];
            while *next < last && -self.ways[*next as usize].place > reach {
                let Way { to, twin, .. } = self.ways[*next as usize];
                self.ways[twin as usize].is_endless = false;
                open.push(slot(to.arc, to.turn.reversed()));
                *next += 1;
            }
        }
    }

    /// The numbers of the tangents that leave an arc with a turn, from an angle on.
    fn numbers(&self, arcs: &Arcs, arc: u32, turn: Turn, angle: f64) -> std::ops::Range<u32> {
        let on = &arcs.arcs[arc as usize];
        let [first, last] = [0, 1].map(|i| self.first[slot(arc, turn) as usize + i]);
        if on.is_whole() {
            return first..last;
        }
        let place = on.place(turn, angle) - SLACK;
        let before = self.ways[first as usize..last as usize].partition_point(|way| way.place < place);
        first + before as u32..last
    }

    /// The number of tangents.
    pub fn len(&self) -> usize {
        self.ways.len() / 2
    }

    fn way(&self, number: u32) -> &Way {
        &self.ways[number as usize]
    }

    /// Those that are not endless, but lead to a goal, given what it sees. O(n) for n tangents that lead there.
    fn useful(&self, arcs: &Arcs, seen: &[Touch]) -> Useful {
        let mut useful = Useful(vec![0; self.ways.len().div_ceil(64)]);
        // For each arc and turn, the ways before this one have not been visited.
        let mut end = self.first[1..].to_vec();
        let mut open: Vec<(u32, Turn, f64)> =
            seen.iter().map(|touch| (touch.arc, touch.turn, touch.tangent.angles[1])).collect();
        while let Some((arc, turn, angle)) = open.pop() {
            let end = &mut end[slot(arc, turn) as usize];
            let start = self.numbers(arcs, arc, turn, angle).start;
            // From the goal to where the path comes from.
            for number in start..*end {
                let back = self.way(number);
                if !self.way(back.twin).is_endless {
                    useful.add(back.twin);
                    open.push((back.to.arc, back.to.turn, back.to.angle));
                }
            }
            *end = start.min(*end);
        }
        useful
    }
}

/// Known tangents, and which of them a path to one goal may take.
pub(super) struct Known<'a> {
    tangents: &'a Tangents,
    useful: Useful,
    /// What the goal sees, and the number of each there by arc and turn; [`NONE`] of others.
    seen: Vec<Touch>,
    numbers: Vec<u32>,
}

impl<'a> Known<'a> {
    /// For a goal in a triangle.
    pub fn new(tangents: &'a Tangents, sight: &Sight<'_>, goal: Point, triangle: u32) -> Self {
        let mut seen: Vec<Touch> = Vec::new();
        let mut unlimited = u64::MAX;
        sight.touch_all(&Source::at(goal), triangle, None, &mut unlimited, &mut |touch| seen.push(touch));
        let mut numbers = vec![NONE; 2 * sight.arcs.arcs.len()];
        let number = |(i, touch): (usize, &Touch)| numbers[slot(touch.arc, touch.turn) as usize] = i as u32;
        seen.iter().enumerate().for_each(number);
        Self { tangents, useful: tangents.useful(sight.arcs, &seen), seen, numbers }
    }

    /// The tangent from an arc to the goal, as seen from the goal, if the arc is left with a turn from an angle on.
    pub fn to_goal(&self, arcs: &Arcs, arc: u32, turn: Turn, angle: f64) -> Option<&Tangent> {
        let number = self.numbers[slot(arc, turn.reversed()) as usize];
        let Touch { tangent, .. } = self.seen.get(number as usize)?;
        let on = &arcs.arcs[arc as usize];
        let is_ahead = on.is_whole() || on.place(turn, angle) <= on.place(turn, tangent.angles[1]) + SLACK;
        is_ahead.then_some(tangent)
    }

    /// The tangents that leave an arc with a turn, from an angle on, and that a path may take.
    pub fn leaving(&self, arcs: &Arcs, arc: u32, turn: Turn, angle: f64) -> impl Iterator<Item = u32> {
        let tangents = self.tangents;
        let numbers = tangents.numbers(arcs, arc, turn, angle);
        numbers.filter(|&number| tangents.way(number).is_endless || self.useful.has(number))
    }

    /// A tangent.
    pub fn way(&self, number: u32) -> &Way {
        self.tangents.way(number)
    }
}

/// Calls a function with each tangent from a part of an arc and the turn there. See [`Sight::touch_all`].
fn see(sight: &Sight<'_>, part: &Part, most: &mut u64, found: &mut dyn FnMut(Turn, Touch)) -> Option<()> {
    let from = sight.arcs.arcs[part.arc as usize].from;
    let circle = *sight.arcs.circle(part.arc);
    for turn in Turn::BOTH {
        let source = Source { root: 0, circle, turn, point: circle.at(from + part.from), length: 0.0 };
        let rays = Rays::from_arc(turn, [from + part.from, from + part.to]);
        sight.touch_all(&source, part.triangle, Some(&rays), most, &mut |touch| found(turn, touch))?;
    }
    Some(())
}

/// The number of an arc and a turn.
fn slot(arc: u32, turn: Turn) -> u32 {
    2 * arc + u32::from(turn == Turn::Right)
}
