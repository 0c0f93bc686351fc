//! The free state nearest to one in collision, found by a bounded search that is the same everywhere.
//!
//! States are tried on shells about the given one, from tiny ones outwards, in directions along the coordinates and in others
//! drawn evenly. From the first shell with a free state the direction is turned, by smaller and smaller angles, as long as the
//! way out gets shorter: pattern search (Hooke and Jeeves 1961, "Direct search solution of numerical and statistical problems").
//! Around an obstacle with one nearest point of its border that is where it ends, but for the tolerance; a pocket smaller than
//! the gaps between the directions may be missed.

use crate::error::Error;
use crate::random::{Random, Stream};
use crate::space::{MAX_DIMENSION, Space};

/// The number of shells; each has twice the radius of the one before.
const SHELLS: i32 = 28;

/// Directions besides those along the coordinates, and how many more for each coordinate.
const DIRECTIONS: [usize; 2] = [24, 8];

/// The number of halvings that find the border on a ray.
const HALVINGS: u32 = 24;

/// The first and the last change of the direction, as parts of it.
const TURNS: [f64; 2] = [0.5, 1e-4];

/// The most rounds over the coordinates in which the direction is changed.
const ROUNDS: u32 = 60;

/// How far beyond the border the state is placed where there is room, as a part of the size of the space: about as far as the
/// default tolerance of proofs, so that motions can begin there.
const ROOM: f64 = 1e-4;

/// A direction: the change of each coordinate for a unit of distance.
type Direction = [f64; MAX_DIMENSION];

/// The nearest free state that is found around a state in collision, at most so far from it, and its distance; both in
/// [`Space::straight_distance`]. `None` if none is found. At most some thousand calls of `is_free`, usually some hundred.
pub fn nearest_free<S: Space>(
    space: &S,
    is_free: &dyn Fn(&S::State) -> bool,
    from: &S::State,
    most: f64,
) -> Option<(S::State, f64)> {
    let search = Search::new(space, is_free, from)?;
    let (direction, distance) = search.first_out(most)?;
    let (direction, distance) = search.turned(direction, distance);
    let state = search.with_room(&direction, distance, most);
    let distance = space.straight_distance(from, &state);
    (distance <= most).then_some((state, distance))
}

/// An error about a state in collision, with the nearest free one that is found anywhere, if any.
pub(crate) fn naming_nearest<S: Space>(
    error: Error,
    space: &S,
    is_free: &dyn Fn(&S::State) -> bool,
    state: &S::State,
) -> Error {
    // Across the space, or from outside to its middle and across.
    let most = space.straight_distance(state, &state_at(space, 0.5)) + size(space);
    match nearest_free(space, is_free, state, most) {
        Some((nearest, distance)) => error.with_nearest(space.coordinates(&nearest), distance),
        None => error,
    }
}

/// The state with all coordinates at this part of what samples are drawn from.
fn state_at<S: Space>(space: &S, part: f64) -> S::State {
    space.at(&[part; MAX_DIMENSION][..space.dimension()])
}

/// The size of the space, without the detours of curves.
fn size<S: Space>(space: &S) -> f64 {
    2.0 * space.straight_distance(&state_at(space, 0.0), &state_at(space, 0.5))
}

struct Search<'a, S: Space> {
    space: &'a S,
    is_free: &'a dyn Fn(&S::State) -> bool,
    from: &'a S::State,
    /// The change of each coordinate by which a state moves by a unit of distance; 0 if it does not move.
    scale: Direction,
}

impl<'a, S: Space> Search<'a, S> {
    /// `None` in a space in which nothing moves.
    fn new(space: &'a S, is_free: &'a dyn Fn(&S::State) -> bool, from: &'a S::State) -> Option<Self> {
        let mut search = Self { space, is_free, from, scale: [1.0; MAX_DIMENSION] };
        for i in 0..space.dimension() {
            let mut along = [0.0; MAX_DIMENSION];
            along[i] = 1.0;
            search.scale[i] = search.unit(&along).map_or(0.0, |unit| unit[i]);
        }
        search.scale[..space.dimension()].iter().any(|&scale| scale > 0.0).then_some(search)
    }

    /// The state at a distance in a direction.
    fn at(&self, direction: &Direction, distance: f64) -> S::State {
        let mut coordinates = [0.0; MAX_DIMENSION];
        let coordinates = &mut coordinates[..self.space.dimension()];
        coordinates.copy_from_slice(self.space.coordinates(self.from));
        coordinates.iter_mut().zip(direction).for_each(|(x, change)| *x += distance * change);
        self.space.state(coordinates)
    }

    /// The direction with a change that moves a state by a unit of distance; `None` if it moves nothing.
    fn unit(&self, direction: &Direction) -> Option<Direction> {
        /// How far a state is moved to measure that.
        const PROBE: f64 = 1e-3;
        let size = direction.iter().fold(0.0, |most: f64, change| most.max(change.abs()));
        if size.is_nan() || size <= 0.0 {
            return None;
        }
        // Where one way leads over a cut, the other does not.
        let ways = [PROBE, -PROBE].map(|way| self.space.straight_distance(self.from, &self.at(direction, way / size)));
        let pace = ways[0].min(ways[1]) * size / PROBE;
        (pace > 0.0 && pace < f64::INFINITY).then(|| direction.map(|change| change / pace))
    }

    fn is_free(&self, state: &S::State) -> bool {
        self.space.contains(state) && (self.is_free)(state)
    }

    fn is_free_at(&self, direction: &Direction, distance: f64) -> bool {
        self.is_free(&self.at(direction, distance))
    }

    /// The directions of the shells.
    fn directions(&self) -> Vec<Direction> {
        let (dimension, mut random) = (self.space.dimension(), Random::new(0, Stream::Ends));
        let along = (0..2 * dimension).map(|i| {
            let mut direction = [0.0; MAX_DIMENSION];
            direction[i / 2] = if i % 2 == 0 { self.scale[i / 2] } else { -self.scale[i / 2] };
            direction
        });
        let [some, more] = DIRECTIONS;
        let drawn = (0..some + more * dimension).map(|_| {
            let mut direction = [0.0; MAX_DIMENSION];
            direction.iter_mut().zip(&self.scale).take(dimension).for_each(|(x, scale)| *x = scale * random.normal());
            direction
        });
        along.chain(drawn).filter_map(|direction| self.unit(&direction)).collect()
    }

    /// The shortest way out on the first shell that has any.
    fn first_out(&self, most: f64) -> Option<(Direction, f64)> {
        let directions = self.directions();
        let mut radius = most * libm::ldexp(1.0, 1 - SHELLS);
        for _ in 0..SHELLS {
            let mut best: Option<(Direction, f64)> = None;
            for direction in &directions {
                let tried = best.map_or(radius, |(_, distance)| distance);
                if self.is_free_at(direction, tried) {
                    best = Some((*direction, self.border(direction, 0.5 * radius, tried)));
                }
            }
            if best.is_some() {
                return best;
            }
            radius *= 2.0;
        }
        None
    }

    /// The least free distance on a ray that halving finds, between one that counts as in collision and a free one.
    fn border(&self, direction: &Direction, within: f64, outside: f64) -> f64 {
        let (mut within, mut outside) = (within, outside);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (within + outside);
            if self.is_free_at(direction, middle) { outside = middle } else { within = middle }
        }
        outside
    }

    /// A direction with a shorter way out, if there is one by turning it.
    fn turned(&self, direction: Direction, distance: f64) -> (Direction, f64) {
        let (mut best, mut turn) = ((direction, distance), TURNS[0]);
        for _ in 0..ROUNDS {
            if turn < TURNS[1] {
                break;
            }
            let mut is_better = false;
            for i in 0..2 * self.space.dimension() {
                let mut direction = best.0;
                direction[i / 2] += if i % 2 == 0 { turn } else { -turn } * self.scale[i / 2];
                let Some(direction) = self.unit(&direction) else { continue };
                // Near the best direction the way gets shorter with the square of the turn.
                let shorter = best.1 * (1.0 - 0.1 * turn * turn);
                if self.is_free_at(&direction, shorter) {
                    best = (direction, self.border(&direction, 0.0, shorter));
                    is_better = true;
                }
            }
            if !is_better {
                turn *= 0.5;
            }
        }
        best
    }

    /// The state beyond the border, as far as there is room for and no farther than allowed, with few decimal places if those are
    /// enough.
    fn with_room(&self, direction: &Direction, distance: f64, most: f64) -> S::State {
        let room = ROOM * size(self.space);
        let rooms = (0..10).map(|i| distance + room * libm::ldexp(1.0, -i)).filter(|&beyond| beyond <= most);
        let beyond = rooms.into_iter().find(|&beyond| self.is_free_at(direction, beyond)).unwrap_or(distance);
        let state = self.at(direction, beyond);
        let mut places = 1.0;
        while places < 1e12 && places * (beyond - distance).max(1e-9 * room) < 1.0 {
            places *= 10.0;
        }
        let mut coordinates = [0.0; MAX_DIMENSION];
        let coordinates = &mut coordinates[..self.space.dimension()];
        let before = self.space.coordinates(self.from);
        for ((x, exact), before) in coordinates.iter_mut().zip(self.space.coordinates(&state)).zip(before) {
            // A coordinate that has not changed stays as it was.
            *x = if exact == before { *before } else { libm::rint(exact * places) / places };
        }
        let rounded = self.space.state(coordinates);
        let is_near = self.space.straight_distance(self.from, &rounded) <= most;
        if is_near && self.is_free(&rounded) { rounded } else { state }
    }
}
