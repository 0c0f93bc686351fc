//! Which vertices are neighbours of a state in planners whose paths approach the shortest: all within a radius that falls as
//! vertices grow in number, or the k nearest, with a k that grows. The paper of each rule is beside it.

use super::growth::Growth;
use super::prm::prm_star_k;
use crate::error::Error;
use crate::nearest::{Direction, Index, Nearest, Neighbour, Neighbourhood, Query};
use crate::options::out_of_range;
use crate::problem::Problem;
use crate::random::{Random, Stream};
use crate::space::{MAX_DIMENSION, Space};
use std::f64::consts::E;

/// How many directions measure a ball of the space.
const DIRECTIONS: usize = 1024;
/// Their length, as a fraction of the side of the space.
const LENGTH: f64 = 1e-3;

/// By how much radii and k of batches are above the critical ones, which have to be exceeded.
const EXCESS: f64 = 1.1;

crate::choice! {
    /// Which vertices may become the parent of a new one, or its children.
    pub enum NearRule {
        /// Those within a radius that falls as vertices grow in number.
        Radius,
        /// The nearest, the more the more vertices there are.
        KNearest,
    }
}

crate::options! {
    /// Which vertices are neighbours.
    pub struct Nearness for crate::options::ALL;
    /// Neighbours of a vertex: all within a radius, which are many in high dimensions, or the k nearest.
    near: Option<NearRule>, "Neighbour rule", else "radius; k-nearest in FMT* and along curves of a car";
    /// Multiplies the radius: less than 1 is faster, without a guarantee.
    radius_factor: f64 = 1.0, in 0.01..=10.0, "Radius factor";
}

/// The rule for neighbours in a space.
#[derive(Debug, Clone, Copy)]
pub(super) struct Near {
    /// The radius of a ball with the measure of the space; `None` if the nearest are neighbours.
    scale: Option<f64>,
    factor: f64,
    dimension: usize,
}

impl Near {
    /// The rule that was chosen, or the default one where motions are straight.
    ///
    /// # Errors
    /// `out-of-range`, pointer `/near`, for a radius along curves.
    pub fn new<S: Space>(problem: &Problem<S>, options: Nearness, default: NearRule) -> Result<Self, Error> {
        let space = problem.space();
        let is_straight = space.curve(problem.start(), problem.goal()).is_none();
        if options.near == Some(NearRule::Radius) && !is_straight {
            let sentence = "near must be k-nearest along curves: their balls have no measure to take a radius from";
            return Err(out_of_range("near", sentence.to_owned()));
        }
        let rule = options.near.unwrap_or(if is_straight { default } else { NearRule::KNearest });
        let scale = (rule == NearRule::Radius).then(|| radius_of_space(space));
        Ok(Self { scale, factor: options.radius_factor, dimension: space.dimension() })
    }

    /// Neighbours among the `n` vertices of RRT* whose path, or the distance to the goal if it has none, is so long: the radius
    /// of Solovey, Janson, Schmerling, Frazzoli and Pavone 2020, "Revisiting the asymptotic optimality of RRT*", theorem 1, with
    /// theta = 1/4 and epsilon and mu going to 0, where the cost of the shortest path is replaced by a bound on it; at most
    /// `most`. The k of Karaman and Frazzoli 2011, "Sampling-based algorithms for optimal motion planning".
    pub fn in_tree(&self, n: usize, cost: f64, most: f64) -> Neighbourhood {
        let Some(scale) = self.scale else { return Neighbourhood::Nearest(prm_star_k(n, self.dimension)) };
        let (d, n) = (self.dimension as f64, n as f64);
        // gamma = (2 + theta) (cost |X| / ((d + 1) theta zeta))^(1 / (d + 1)), and |X| / zeta = scale^d.
        let gamma = 2.25 * libm::pow(4.0 * cost / (d + 1.0) * libm::pow(scale, d), 1.0 / (d + 1.0));
        Neighbourhood::Within((self.factor * (gamma * libm::pow(libm::log(n) / n, 1.0 / (d + 1.0)))).min(most))
    }

    /// Neighbours among the `n` vertices of FMT*: the radius of Janson, Schmerling, Clark and Pavone 2015, "Fast marching tree: a
    /// fast marching sampling-based method for optimal motion planning in many dimensions", theorem 4.1; or e times as many as a
    /// ball of that radius holds on average, and so all of them with a probability that goes to 1.
    pub fn in_march(&self, n: usize) -> Neighbourhood {
        let d = self.dimension as f64;
        self.in_batch(n, 1.0, 1.0 / d, libm::pow(2.0, d) / d)
    }

    /// Neighbours among `n` vertices and samples of BIT* that fill a share of the space: radius and k of Gammell, Barfoot and
    /// Srinivasa 2020, "Batch Informed Trees (BIT*): informed asymptotically optimal anytime search".
    pub fn in_informed_set(&self, n: usize, share: f64) -> Neighbourhood {
        let each = 1.0 + 1.0 / self.dimension as f64;
        self.in_batch(n, share, each, each)
    }

    /// Neighbours among `n` vertices that fill a share of the space: within 2 (by_radius |X| ln n / (zeta n))^(1 / d), or
    /// the e by_number ln n nearest, and a bit more.
    fn in_batch(&self, n: usize, share: f64, by_radius: f64, by_number: f64) -> Neighbourhood {
        let (d, n) = (self.dimension as f64, n as f64);
        match self.scale {
            None => Neighbourhood::Nearest(libm::ceil(EXCESS * E * by_number * libm::log(n)) as usize),
            Some(scale) => {
                let volume = by_radius * share * libm::log(n) / n;
                Neighbourhood::Within(self.factor * (EXCESS * 2.0 * scale * libm::pow(volume, 1.0 / d)))
            }
        }
    }
}

/// Whether the neighbours that are found are in order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    /// The nearest first.
    Sorted,
    /// As the index visits them, which takes no time to sort.
    Any,
}

/// The neighbours of a state, by motions in one direction, into `found`; those of an indexed vertex are with itself.
pub(super) fn find_near<S: Space>(
    problem: &Problem<S>,
    growth: &mut Growth<S>,
    index: &Index,
    (direction, state): (Direction, &S::State),
    (neighbourhood, order): (Neighbourhood, Order),
    found: &mut Vec<Neighbour>,
) {
    let query = Query { space: problem.space(), states: growth.graph.states(), direction, from: state };
    let visited = match order {
        Order::Sorted => index.find(query, neighbourhood, found),
        Order::Any => index.find_in_any_order(query, neighbourhood, found),
    };
    growth.counters.nearest_queries += 1;
    growth.note_visited(problem.space(), visited);
    growth.looked += found.len() as u64;
}

/// The radius of a ball whose measure is that of the space, if balls of every size are as they are about the middle of the space:
/// so a ball of radius r has the share (r / radius)^d of the space. O(1): short motions in many directions are measured.
///
/// The share of a ball of radius r is s^d E[(r g / rho)^d] for points drawn in a cube of side s about the middle, where g is how
/// far out in the cube a point is, 0 to 1, and rho its distance: along the direction of each point, the ball ends r g / rho out.
fn radius_of_space<S: Space>(space: &S) -> f64 {
    let (d, middle) = (space.dimension(), space.at(&[0.5; MAX_DIMENSION][..space.dimension()]));
    let mut random = Random::new(0, Stream::Samples);
    let mut sum = 0.0;
    for _ in 0..DIRECTIONS {
        let mut unit = [0.0; MAX_DIMENSION];
        let mut out = 0.0f64;
        for x in &mut unit[..d] {
            let offset = 2.0 * random.uniform() - 1.0;
            out = out.max(offset.abs());
            *x = 0.5 + LENGTH / 2.0 * offset;
        }
        let distance = space.distance(&middle, &space.at(&unit[..d]));
        sum += libm::pow(LENGTH * out / distance, d as f64);
    }
    libm::pow(sum / DIRECTIONS as f64, -1.0 / d as f64)
}
