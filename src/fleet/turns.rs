//! Searches for a plan that take turns: how long a turn is, and whose it is.

use super::composite::Composite;
use super::document::Fleet;
use super::moves::Moves;
use super::prioritized::Orders;
use super::priority_tree::{Ground, PriorityTree};
use super::result::{Blocked, FleetStats};
use super::trajectory::Trajectory;
use crate::problem::Status;
use std::sync::Arc;

/// The iterations of a turn of a search of single robots, and as many more for each robot.
const TURN: [u64; 2] = [5000, 1000];
/// How many times as many iterations orders get: a second one mostly gives a plan.
const ORDERS: u64 = 4;
/// How many times as many iterations joint moves get: one takes less time.
const JOINT: u64 = 8;

/// One of the searches.
pub(super) enum Search {
    Orders(Box<Orders>),
    Tree(Box<PriorityTree>),
    Composite(Box<Composite>),
    Moves(Box<Moves>),
}

/// Searches that take turns, on roadmaps that are complete.
#[derive(Default)]
pub(super) struct Searches {
    /// Those that have not tried everything, and whose turn it is.
    pub left: Vec<Search>,
    pub turn: usize,
    /// The iterations left of this turn, and the turns left of this round.
    pub iterations: u64,
    pub turns: u64,
}

impl Searches {
    /// The iterations of the turn that it is.
    pub fn of_a_turn(&self, fleet: &Fleet) -> u64 {
        let single = TURN[0] + TURN[1] * fleet.kinds().len() as u64;
        match self.left.get(self.turn) {
            Some(Search::Orders(_)) => ORDERS * single,
            Some(Search::Moves(_)) => JOINT * single,
            _ => single,
        }
    }

    /// Goes on with the next search, without the one whose turn it was if that is over. If the round is over, it is nobody's
    /// turn.
    pub fn go_on(&mut self, fleet: &Fleet, is_over: bool) {
        if is_over {
            self.left.remove(self.turn);
        } else {
            self.turn += 1;
        }
        self.turns -= 1;
        if self.turn >= self.left.len() && self.turns > 0 {
            self.turn = 0;
        }
        if self.turns == 0 {
            self.turn = self.left.len();
        }
        self.iterations = self.of_a_turn(fleet);
    }
}

impl Search {
    pub fn iterate(&mut self, ground: &Ground, stats: &mut FleetStats) -> Status {
        match self {
            Search::Orders(orders) => orders.iterate(ground, stats),
            Search::Tree(tree) => tree.iterate(ground, stats),
            Search::Moves(moves) => moves.iterate(ground, stats),
            Search::Composite(composite) => {
                let before = composite.stats();
                let status = composite.iterate(ground.fleet, u32::MAX);
                let after = composite.stats();
                stats.pair_checks += after.pair_checks - before.pair_checks;
                stats.motion_checks += after.motion_checks - before.motion_checks;
                status
            }
        }
    }

    pub fn take_solution(&mut self) -> Vec<Arc<Trajectory>> {
        match self {
            Search::Orders(orders) => orders.take_solution(),
            Search::Tree(tree) => tree.take_solution(),
            Search::Moves(moves) => moves.take_solution(),
            Search::Composite(composite) => composite.take_solution(),
        }
    }

    /// The robot that found no way last.
    pub fn blocked(&self) -> Option<&Blocked> {
        match self {
            Search::Orders(orders) => orders.blocked(),
            Search::Tree(tree) => tree.blocked(),
            Search::Composite(_) | Search::Moves(_) => None,
        }
    }
}
