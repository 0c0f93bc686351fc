//! Runs that are requested by names, as the command line and the page request them.

use planarium::run::storage::RoadmapDocument;
use planarium::run::{self, CustomProblem, Request, Run};
use planarium::{Error, PlanningWorld};

/// As [`run::start`].
pub fn start(scenario: impl Into<PlanningWorld>, request: &Request) -> Result<Box<dyn Run>, Error> {
    let world = scenario.into();
    let options = request.for_robot(world.scenario().robot())?;
    run::start(&world, &options)
}

/// As [`run::resume`].
pub fn resume(
    scenario: impl Into<PlanningWorld>,
    request: &Request,
    document: &RoadmapDocument,
) -> Result<Box<dyn Run>, Error> {
    let world: PlanningWorld = scenario.into();
    let options = request.for_roadmap(world.scenario(), document)?;
    run::resume(&world, &options, document)
}

/// As [`run::start_problem`].
pub fn start_problem(problem: &CustomProblem, request: &Request) -> Result<Box<dyn Run>, Error> {
    run::start_problem(problem, &request.for_problem(problem)?)
}

/// As [`run::resume_problem`].
pub fn resume_problem(
    problem: &CustomProblem,
    request: &Request,
    document: &RoadmapDocument,
) -> Result<Box<dyn Run>, Error> {
    run::resume_problem(problem, &request.for_roadmap_of(problem, document)?, document)
}
