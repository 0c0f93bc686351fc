//! From a scenario and options to a run: the one place where names become types.

use super::runner::{Runner, Ticket};
use super::{Options, Run};
use crate::collision::{ArmValidity, DiscValidity, joint_space};
use crate::error::{Code, Error};
use crate::planner::{Parameters, Prm, RrtConnect, planner_info};
use crate::problem::Problem;
use crate::robot::{Arm, DiscRobot};
use crate::scenario::{Robot, Scenario};
use crate::space::{Euclidean, Metric, Space};
use crate::validity::Validity;

/// Of the space's extent, the step taken where none is given.
const DEFAULT_STEP: f64 = 0.2;
/// Of the space's extent, the smallest step: it bounds the motions of one greedy connection.
const SMALLEST_STEP: f64 = 1e-4;

/// The most motions that a roadmap may try: it keeps what became of each.
const MOST_MOTIONS: u64 = 20_000_000;

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
        shortcuts: parameters.integer("shortcut"),
    };
    let launch = Launch { scenario, parameters, ticket, ends: [&query.start, &query.goal] };
    // Entries past the dimension are 0 and change no bit: three sizes serve arms of 1 to 8 links.
    let run = match scenario.robot() {
        Robot::Arm(arm) => match arm.links().len() {
            1 | 2 => launch.arm::<2>(arm),
            3 | 4 => launch.arm::<4>(arm),
            _ => launch.arm::<8>(arm),
        },
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
        let metric = match self.parameters.text("metric") {
            Some("euclidean") => Metric::Euclidean,
            _ => Metric::Sum,
        };
        let space = joint_space::<N>(arm, metric);
        let [start, goal] = self.ends.map(|q| space.state(q));
        let validity = ArmValidity::new(arm, space.clone(), self.scenario.world(), self.tolerance());
        let problem = Problem::new(space, validity.fitted(&start, &goal), start, goal)?;
        self.plan(problem)
    }

    fn disc(self, disc: &DiscRobot) -> Result<Box<dyn Run>, Error> {
        if self.parameters.text("metric") == Some("sum") {
            let sentence = "the metric of a disc is always euclidean, not \"sum\"";
            return Err(Error::new(Code::OutOfRange, "/metric", sentence));
        }
        let world = self.scenario.world();
        let bounds = world.bounds.expect("a disc has bounds");
        let corner = |p: crate::geometry::Point| [p.x, p.y];
        let space = Euclidean::new(corner(bounds.min), corner(bounds.max));
        let [start, goal] = self.ends.map(|q| space.state(q));
        let problem = Problem::new(space, DiscValidity::new(disc, world), start, goal)?;
        self.plan(problem)
    }

    /// The wanted tolerance, as a fraction of the world's longer side.
    fn tolerance(&self) -> f64 {
        self.parameters.number("tolerance").expect("the tolerance has a fixed default")
    }

    fn plan<S, V>(self, problem: Problem<S, V>) -> Result<Box<dyn Run>, Error>
    where
        S: Space + 'static,
        V: Validity<S::State> + 'static,
    {
        let (parameters, seed) = (&self.parameters, self.ticket.seed);
        match self.ticket.planner {
            "prm" => {
                let (samples, k) = (parameters.integer("samples"), parameters.integer("k"));
                if samples * k > MOST_MOTIONS {
                    let sentence = format!("samples times k must be at most {MOST_MOTIONS}, not {samples} times {k}");
                    return Err(Error::new(Code::OutOfRange, "/samples", sentence));
                }
                let planner = Prm::new(&problem, samples as usize, k as usize, seed);
                Ok(Box::new(Runner::new(problem, planner, self.ticket)))
            }
            "rrt-connect" => {
                let step = step(parameters, problem.space().extent())?;
                let planner = RrtConnect::new(&problem, step, seed);
                Ok(Box::new(Runner::new(problem, planner, self.ticket)))
            }
            other => unreachable!("the catalogue lists {other}, the factory does not"),
        }
    }
}

/// The step given, or the default for a space of this extent.
fn step(parameters: &Parameters, extent: f64) -> Result<f64, Error> {
    let Some(step) = parameters.number("step") else { return Ok(DEFAULT_STEP * extent) };
    let smallest = SMALLEST_STEP * extent;
    if step < smallest {
        let sentence = format!("step must be at least {smallest}, a 10,000th of the space's extent, not {step}");
        return Err(Error::new(Code::OutOfRange, "/step", sentence));
    }
    Ok(step)
}
