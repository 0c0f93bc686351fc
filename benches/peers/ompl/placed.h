// Planners for what is placed by (x, y, theta): a rigid body, and a car by controls, in OMPL's own spaces.
#pragma once
#include "outcome.h"
#include "world.h"
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/control/PathControl.h>
#include <ompl/control/PlannerData.h>
#include <ompl/control/SpaceInformation.h>
#include <ompl/control/planners/rrt/RRT.h>
#include <ompl/control/planners/sst/SST.h>
#include <ompl/control/spaces/RealVectorControlSpace.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <memory>

namespace placed {
namespace ob = ompl::base;
namespace oc = ompl::control;
using Placement = ob::SE2StateSpace::StateType;

// Motions are looked at in places so far apart in the metric of the whole; OMPL would take the part that moves most.
struct Space : ob::SE2StateSpace {
    double resolution = 0.01;
    unsigned validSegmentCount(const ob::State *a, const ob::State *b) const override {
        return std::max(1u, unsigned(std::ceil(distance(a, b) / resolution)));
    }
};

// The reports' metric: 0.7 of the translation and 0.3 of the rotation.
inline std::shared_ptr<Space> space(const World &world) {
    auto space = std::make_shared<Space>();
    ob::RealVectorBounds bounds(2);
    bounds.low = {world.bounds.left, world.bounds.bottom};
    bounds.high = {world.bounds.right, world.bounds.top};
    space->setBounds(bounds);
    space->setSubspaceWeight(0, 0.7);
    space->setSubspaceWeight(1, 0.3);
    return space;
}

struct Checker : ob::StateValidityChecker {
    const World &world;
    Checker(const ob::SpaceInformationPtr &information, const World &world)
        : ob::StateValidityChecker(information), world(world) {}
    bool isValid(const ob::State *state) const override {
        const auto *at = state->as<Placement>();
        return world.is_placed_free(at->getX(), at->getY(), at->getYaw());
    }
};

inline ob::ScopedState<ob::SE2StateSpace> placement(const ob::StateSpacePtr &space, const std::vector<double> &numbers) {
    ob::ScopedState<ob::SE2StateSpace> state(space);
    state->setXY(numbers[0], numbers[1]);
    state->setYaw(std::remainder(numbers[2], 2 * M_PI));
    return state;
}

// Both tolerances must hold.
struct Region : ob::GoalState {
    const World &world;
    Region(const ob::SpaceInformationPtr &information, const World &world) : ob::GoalState(information), world(world) {}
    bool isSatisfied(const ob::State *state, double *distance) const override {
        *distance = distanceGoal(state);
        const auto *at = state->as<Placement>(), *goal = getState()->as<Placement>();
        const double turn = std::remainder(at->getYaw() - goal->getYaw(), 2 * M_PI);
        return std::hypot(at->getX() - goal->getX(), at->getY() - goal->getY()) <= world.tolerance[0] &&
               std::fabs(turn) <= world.tolerance[1];
    }
};
}  // namespace placed

inline Outcome body(const World &world, double range, double resolution, double limit) {
    using namespace placed;
    const double asked = seconds();
    const auto space = placed::space(world);
    const auto information = std::make_shared<ob::SpaceInformation>(space);
    information->setStateValidityChecker(std::make_shared<Checker>(information, world));
    space->resolution = resolution;
    information->setup();
    const auto problem = std::make_shared<ob::ProblemDefinition>(information);
    problem->setStartAndGoalStates(placement(space, world.start), placement(space, world.goal), 1e-9);
    ompl::geometric::RRTConnect planner(information);
    planner.setRange(range);
    planner.setProblemDefinition(problem);
    planner.setup();
    Outcome outcome;
    const double began = seconds();
    const ob::PlannerStatus status = planner.solve(within(limit));
    outcome.build = seconds() - began;
    outcome.setup = began - asked;
    outcome.is_solved = status == ob::PlannerStatus::EXACT_SOLUTION;
    outcome.length = outcome.is_solved ? problem->getSolutionPath()->length() : 0;
    outcome.motions = information->getMotionValidator()->getValidMotionCount() + information->getMotionValidator()->getInvalidMotionCount();
    ob::PlannerData data(information);
    planner.getPlannerData(data);
    outcome.vertices = data.numVertices();
    outcome.edges = data.numEdges();
    return outcome;
}

inline Outcome car(const World &world, bool is_sst, unsigned least, unsigned most, double limit) {
    using namespace placed;
    const double asked = seconds();
    const auto space = placed::space(world);
    const auto controls = std::make_shared<oc::RealVectorControlSpace>(space, 2);
    ob::RealVectorBounds bounds(2);
    bounds.low = {world.speed[0], world.steering[0]};
    bounds.high = {world.speed[1], world.steering[1]};
    controls->setBounds(bounds);
    const auto information = std::make_shared<oc::SpaceInformation>(space, controls);
    information->setStateValidityChecker(std::make_shared<Checker>(information, world));
    // The reports' explicit Euler step, each state of which is checked.
    const double wheelbase = world.wheelbase;
    information->setStatePropagator([wheelbase](const ob::State *from, const oc::Control *control, double step, ob::State *to) {
        const auto *at = from->as<Placement>();
        const double *u = control->as<oc::RealVectorControlSpace::ControlType>()->values;
        const double x = at->getX(), y = at->getY(), turn = at->getYaw();
        to->as<Placement>()->setXY(x + step * u[0] * std::cos(turn), y + step * u[0] * std::sin(turn));
        to->as<Placement>()->setYaw(std::remainder(turn + step * u[0] / wheelbase * std::tan(u[1]), 2 * M_PI));
    });
    information->setPropagationStepSize(0.01);
    information->setMinMaxControlDuration(least, most);
    information->setup();
    const auto problem = std::make_shared<ob::ProblemDefinition>(information);
    problem->addStartState(placement(space, world.start));
    const auto region = std::make_shared<Region>(information, world);
    region->setState(placement(space, world.goal));
    problem->setGoal(region);
    // The first path will do.
    const auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(information);
    objective->setCostThreshold(ob::Cost(1e9));
    problem->setOptimizationObjective(objective);
    ob::PlannerPtr planner;
    if (is_sst) {
        const auto sst = std::make_shared<oc::SST>(information);
        sst->setGoalBias(0.05);
        planner = sst;
    } else {
        const auto rrt = std::make_shared<oc::RRT>(information);
        rrt->setGoalBias(0.05);
        planner = rrt;
    }
    planner->setProblemDefinition(problem);
    planner->setup();
    Outcome outcome;
    const double began = seconds();
    const ob::PlannerStatus status = planner->solve(within(limit));
    outcome.build = seconds() - began;
    outcome.setup = began - asked;
    outcome.is_solved = status == ob::PlannerStatus::EXACT_SOLUTION;
    outcome.length = outcome.is_solved ? problem->getSolutionPath()->length() : 0;
    oc::PlannerData data(information);
    planner->getPlannerData(data);
    outcome.vertices = data.numVertices();
    outcome.edges = data.numEdges();
    return outcome;
}
