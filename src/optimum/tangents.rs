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

/// Triangles at most that all arcs together see, each from every arc: they take some seconds.
const MOST_SEEN: u64 = 8_000_000;

/// The parts of arcs that are looked at beforehand.
const SAMPLED: usize = 64;

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
        self.turn.sign() * arcs.arcs[self.arc as usize].after(self.angle)
    }
}

/// No number.
const NONE: u32 = u32::MAX;

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
    /// Does another tangent go on from its end, another one from there, and so on for ever?
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
    /// Finds them; `None` if that would take more than [`MOST_SEEN`]. O(n s) for n arcs, from each of which s triangles are seen.
    pub fn new(sight: &Sight<'_>, grown: &Grown) -> Option<Self> {
        let arcs = sight.arcs;
        // Of some parts it is found out what they see, to know whether all see too much.
        let step = arcs.parts.len().div_ceil(SAMPLED).max(1);
        let mut most = MOST_SEEN / step as u64;
        for part in arcs.parts.iter().step_by(step) {
            most = most.checked_sub(see(sight, part, &mut |_, _| ()))?;
        }
        let (mut slots, mut ways) = (Vec::new(), Vec::new());
        // The arc from which each other one was reached last, for both turns of both: some are reached twice.
        let mut last_from = vec![NONE; 4 * arcs.arcs.len()];
        for part in &arcs.parts {
            see(
                sight,
                part,
                &mut |leaving, Touch { arc, turn, tangent: Tangent { segment, angles: [first, last] } }| {
                    let known = &mut last_from[(2 * slot(arc, turn) + u32::from(leaving == Turn::Right)) as usize];
                    // Of both directions that from the lower number.
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
                },
            );
        }
        let mut tangents = Self::sorted(&slots, &ways, 2 * arcs.arcs.len());
        tangents.end_dead_ends(arcs);
        Some(tangents)
    }

    /// Tangents in the order of the arc and turn that they leave, and of the turn.
    fn sorted(slots: &[u32], ways: &[Way], count: usize) -> Self {
        let mut order: Vec<u32> = (0..ways.len() as u32).collect();
        sort_numbers(&mut order, &|i, j| {
            let [(i, a), (j, b)] = [i, j].map(|i| (slots[i], ways[i].place));
            i.cmp(&j).then(a.total_cmp(&b))
        });
        let mut number = vec![0; ways.len()];
        order.iter().enumerate().for_each(|(new, &old)| number[old as usize] = new as u32);
        let mut first = vec![0; count + 1];
        slots.iter().for_each(|&slot| first[slot as usize + 1] += 1);
        (0..count).for_each(|i| first[i + 1] += first[i]);
        let moved = |old: u32| Way { twin: number[ways[old as usize].twin as usize], ..ways[old as usize] };
        Self { first, ways: order.into_iter().map(moved).collect() }
    }

    /// Finds the tangents from which no other one goes on for ever. O(n) for n tangents.
    fn end_dead_ends(&mut self, arcs: &Arcs) {
        // Of those that leave an arc with a turn, the first ones whose other direction has ended, and after the last endless one.
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
        let place = turn.sign() * on.after(angle) - SLACK;
        let before = self.ways[first as usize..last as usize].partition_point(|way| way.place < place);
        first + before as u32..last
    }

    /// The number of all, in both directions.
    pub fn len(&self) -> usize {
        self.ways.len()
    }

    fn way(&self, number: u32) -> &Way {
        &self.ways[number as usize]
    }

    /// Those that are not endless, but lead to a goal, given what it sees. O(found).
    fn useful(&self, arcs: &Arcs, seen: &[Touch]) -> Useful {
        let mut useful = Useful(vec![0; self.ways.len().div_ceil(64)]);
        let mut open: Vec<(u32, Turn, f64)> =
            seen.iter().map(|touch| (touch.arc, touch.turn, touch.tangent.angles[1])).collect();
        while let Some((arc, turn, angle)) = open.pop() {
            // From the goal to where the path comes from.
            for number in self.numbers(arcs, arc, turn, angle) {
                let back = self.way(number);
                if !self.way(back.twin).is_endless && !useful.has(back.twin) {
                    useful.add(back.twin);
                    open.push((back.to.arc, back.to.turn, back.to.angle));
                }
            }
        }
        useful
    }
}

/// Known tangents, and what of them a path to a goal takes.
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
        sight.touch_all(&Source::at(goal), triangle, None, &mut |touch| seen.push(touch));
        let mut numbers = vec![NONE; 2 * sight.arcs.arcs.len()];
        let number = |(i, touch): (usize, &Touch)| numbers[slot(touch.arc, touch.turn) as usize] = i as u32;
        seen.iter().enumerate().for_each(number);
        Self { tangents, useful: tangents.useful(sight.arcs, &seen), seen, numbers }
    }

    /// The tangent to the goal from an arc that is left with a turn, from the goal.
    pub fn to_goal(&self, arc: u32, turn: Turn) -> Option<&Touch> {
        self.seen.get(self.numbers[slot(arc, turn.reversed()) as usize] as usize)
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

/// Calls a function with each tangent from a part of an arc and the turn there. Returns the number of triangles that are seen.
fn see(sight: &Sight<'_>, part: &Part, found: &mut dyn FnMut(Turn, Touch)) -> u64 {
    let from = sight.arcs.arcs[part.arc as usize].from;
    let circle = *sight.arcs.circle(part.arc);
    let of = |turn: Turn| {
        let source = Source { root: 0, circle, turn, point: circle.at(from + part.from), length: 0.0 };
        let rays = Rays::from_arc(turn, [from + part.from, from + part.to]);
        sight.touch_all(&source, part.triangle, Some(&rays), &mut |touch| found(turn, touch))
    };
    Turn::BOTH.map(of).iter().sum()
}

/// The number of an arc and a turn.
fn slot(arc: u32, turn: Turn) -> u32 {
    2 * arc + u32::from(turn == Turn::Right)
}
