//! From a scenario and options to a run: where the names of robots become types.

use super::choices;
use super::runner::{Runner, Ticket};
use super::{Options, Run};
use crate::collision::{ArmValidity, DiscValidity, Sampled, joint_space, plane};
use crate::error::{Code, Error};
use crate::path::Wanted;
use crate::planner::{Parameters, planner_info};
use crate::problem::{Estimate, Problem};
use crate::robot::{Arm, DiscRobot};
use crate::scenario::{Robot, Scenario};
use crate::space::{MAX_DIMENSION, Metric, Space, Torus};
use crate::validity::Validity;

/// The smaller size of states: most robots have no more coordinates.
const SMALL: usize = 4;

/// Begins a run.
///
/// # Errors
/// `unknown-planner`, `unknown-query`, `unknown-parameter`, and the errors of parameter values, with a pointer into the
/// options; `start-in-collision` or `goal-in-collision` with a pointer into the scenario.
pub fn start(scenario: &Scenario, options: &Options) -> Result<Box<dyn Run>, Error> {
    let info = planner_info(&options.planner)?;
    options.check_seed()?;
    let parameters = Parameters::resolve(info.parameters, &options.parameters)?;
    let (place, query) = options.find_query(scenario)?;
    let ticket = Ticket {
        scenario: scenario.name().to_owned(),
        query: query.name.clone(),
        planner: info.id,
        seed: options.seed,
        max_iterations: parameters.integer("max_iterations") as u32,
        wanted: Wanted {
            reduce: parameters.is_on("reduce"),
            shortcuts: parameters.integer("shortcut"),
            partial_shortcuts: parameters.integer("partial_shortcut"),
        },
        is_sampled: parameters.text("edge_check") == Some("sampled"),
    };
    let launch = Launch { scenario, parameters, ticket, ends: [&query.start, &query.goal] };
    // Entries past the dimension are 0 and change no bit: two sizes serve every robot.
    let run = match scenario.robot() {
        Robot::Arm(arm) if arm.links().len() <= SMALL => launch.arm::<SMALL>(arm),
        Robot::Arm(arm) => launch.arm::<MAX_DIMENSION>(arm),
        Robot::Disc(disc) => launch.disc(disc),
    };
    let in_query = |error: &Error| matches!(error.code(), Code::StartInCollision | Code::GoalInCollision);
    run.map_err(|error| if in_query(&error) { error.under(&format!("/queries/{place}")) } else { error })
}

/// All that a run is made from.
struct Launch<'a> {
    scenario: &'a Scenario,
    parameters: Parameters,
    ticket: Ticket,
    ends: [&'a [f64]; 2],
}

impl Launch<'_> {
    fn arm<const N: usize>(self, arm: &Arm) -> Result<Box<dyn Run>, Error> {
        let (metric, is_naive) = match self.parameters.text("metric") {
            Some("euclidean") => (Metric::Euclidean, false),
            Some("naive") => (Metric::Euclidean, true),
            _ => (Metric::Sum, false),
        };
        let space: Torus<N> = joint_space(arm, metric);
        let space = if is_naive { space.cut_open() } else { space };
        let [start, goal] = self.ends.map(|q| space.state(q));
        let validity = ArmValidity::new(arm, space.clone(), self.scenario.world(), self.tolerance());
        let validity = Box::new(validity.fitted(&start, &goal));
        let estimate = from_end_effector(arm, metric);
        self.plan(space, validity, [start, goal], Box::new(move |a, b| estimate(a, b)))
    }

    fn disc(self, disc: &DiscRobot) -> Result<Box<dyn Run>, Error> {
        if let Some(word @ ("sum" | "naive")) = self.parameters.text("metric") {
            let sentence = format!("the metric of a disc is always euclidean, not {word:?}");
            return Err(Error::new(Code::OutOfRange, "/metric", sentence));
        }
        let world = self.scenario.world();
        let bounds = world.bounds.expect("a disc has bounds");
        let space: Torus<SMALL> = plane(&bounds);
        let ends = self.ends.map(|q| space.state(q));
        let measure = space.clone();
        let validity = Box::new(DiscValidity::new(disc, world));
        self.plan(space, validity, ends, Box::new(move |a, b| measure.distance(a, b)))
    }

    /// The wanted tolerance, as a fraction of the world's longer side.
    fn tolerance(&self) -> f64 {
        self.parameters.number("tolerance").expect("the tolerance has a fixed default")
    }

    fn plan<S: Space + Clone + 'static>(
        self,
        space: S,
        proven: Box<dyn Validity<S::State>>,
        [start, goal]: [S::State; 2],
        end_effector: Estimate<S::State>,
    ) -> Result<Box<dyn Run>, Error> {
        let validity: Box<dyn Validity<S::State>> = if self.ticket.is_sampled {
            let places = self.parameters.integer("edge_samples") as u32;
            Box::new(Sampled::new(space.clone(), proven, places))
        } else {
            proven
        };
        let problem = Problem::new(space, validity, start, goal)?.with_end_effector(end_effector);
        let planner = choices::planner(self.ticket.planner, &self.parameters, &problem, self.ticket.seed)?;
        Ok(Box::new(Runner::new(problem, planner, self.ticket)))
    }
}

/// How far apart two configurations of the arm are at least, from where the end effector is: joint j turns what lies beyond
/// it, which reaches r_j at most, so the end effector moves at most sum r_j |turn j|, which is at most r_1 times their sum,
/// and at most the root of sum r_j^2 times the root of the sum of their squares (Cauchy and Schwarz).
fn from_end_effector<const N: usize>(arm: &Arm, metric: Metric) -> impl Fn(&[f64; N], &[f64; N]) -> f64 + use<N> {
    let arm = arm.clone();
    let (mut reach, mut squares) = (0.0, 0.0);
    for length in arm.links().iter().rev() {
        reach += length;
        squares += reach * reach;
    }
    let furthest = if metric == Metric::Sum { reach } else { f64::sqrt(squares) };
    move |a, b| {
        let tip = |q: &[f64; N]| arm.end_effector(&q[..arm.links().len()]);
        (tip(a) - tip(b)).norm() / furthest
    }
}
