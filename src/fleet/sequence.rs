//! An order in which every robot has a way to its goal while all others stand: those before it at their goals, those after it at
//! their starts.
//!
//! Van den Berg, Snoeyink, Lin and Manocha 2009, "Centralized path planning for multiple robots: optimal decoupling into
//! sequential plans". Planned for by priorities in such an order, each robot finds a way on the same roadmap: it can wait until
//! all before it have arrived. The order is built greedily, and nothing is taken back: one may exist although none is found.

use super::document::Fleet;
use super::priority_tree::{Ground, standing};
use super::result::FleetStats;
use super::safe_intervals::{Expansion, Search};
use super::trajectory::Trajectory;
use std::sync::Arc;

/// A robot that is not in the order yet.
struct Left {
    robot: usize,
    /// How often it was tried; who was in its way the last time, and how many of them have gone since then.
    tries: usize,
    in_the_way: Vec<usize>,
    gone: usize,
}

impl Left {
    /// The more often it had no way, the more of those in its way have to go before it is tried again.
    fn is_next(&self) -> bool {
        self.gone >= self.tries
    }
}

/// The order so far. An iteration is an expansion of the search of one robot.
pub(super) struct Sequence {
    order: Vec<usize>,
    left: Vec<Left>,
    /// Where every robot stands.
    stands: Vec<Arc<Trajectory>>,
    /// The search in progress, and the index in `left` of its robot.
    search: Option<(usize, Search)>,
}

/// How an order goes on.
pub(super) enum Sequenced {
    NotYet,
    /// All robots.
    Order(Vec<usize>),
    /// None of those left has a way.
    Stuck,
    /// No robot has a way while all others stand at their starts. So the first one of every order fails.
    Never,
    /// This robot's roadmap has no way even without the others.
    Unconnected(usize),
}

impl Sequence {
    /// No order yet; the first of these robots are tried first.
    pub fn new(fleet: &Fleet, robots: Vec<usize>) -> Self {
        let left = |robot| Left { robot, tries: 0, in_the_way: Vec::new(), gone: 0 };
        Self { order: Vec::new(), left: robots.into_iter().map(left).collect(), stands: standing(fleet), search: None }
    }

    /// The first robot need not be tried before one of these has gone, which are in its way.
    pub fn first_has_failed(&mut self, in_the_way: Vec<usize>) {
        (self.left[0].tries, self.left[0].in_the_way) = (1, in_the_way);
    }

    /// Expands one node of a search among all robots.
    pub fn iterate(&mut self, ground: &Ground, all: &[usize], stats: &mut FleetStats) -> Sequenced {
        let place = match &self.search {
            Some((place, _)) => *place,
            None if self.left.is_empty() => return Sequenced::Order(std::mem::take(&mut self.order)),
            None => {
                let next = self.left.iter().position(Left::is_next);
                match next.or_else(|| self.left.iter().position(|left| left.gone > 0)) {
                    Some(place) => place,
                    None if self.order.is_empty() => return Sequenced::Never,
                    None => return Sequenced::Stuck,
                }
            }
        };
        let robot = self.left[place].robot;
        let scene = ground.scene(robot, &self.stands, all);
        let (_, search) = self.search.get_or_insert_with(|| (place, ground.search(&scene)));
        match search.step(&scene, &mut stats.pair_checks) {
            Expansion::Vertex => {
                stats.expanded += 1;
                return Sequenced::NotYet;
            }
            Expansion::Part => return Sequenced::NotYet,
            Expansion::Found(_) => {
                let [_, goal] = scene.roadmap.ends(robot);
                self.stands[robot] = Arc::new(Trajectory::standing(scene.roadmap.pose(goal)));
                self.left.remove(place);
                self.order.push(robot);
                for left in self.left.iter_mut().filter(|left| left.in_the_way.contains(&robot)) {
                    left.gone += 1;
                }
            }
            Expansion::Nothing(None) => return Sequenced::Unconnected(robot),
            Expansion::Nothing(Some(in_the_way)) => {
                let left = &mut self.left[place];
                (left.tries, left.in_the_way, left.gone) = (left.tries + 1, in_the_way, 0);
            }
        }
        self.search = None;
        Sequenced::NotYet
    }
}
