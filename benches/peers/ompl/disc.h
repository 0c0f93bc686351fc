// Optimal planners for a disc, in OMPL's own plane: what the best path costs after how many states were checked.
#pragma once
#include "world.h"
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <memory>
#include <utility>

namespace disc {
namespace ob = ompl::base;
namespace og = ompl::geometric;
using Point = ob::RealVectorStateSpace::StateType;

struct Checker : ob::StateValidityChecker {
    const World &world;
    mutable size_t checks = 0;
    Checker(const ob::SpaceInformationPtr &information, const World &world)
        : ob::StateValidityChecker(information), world(world) {}
    bool isValid(const ob::State *state) const override {
        ++checks;
        const double *at = state->as<Point>()->values;
        return world.is_disc_free(at[0], at[1]);
    }
};

struct Outcome {
    // Checks and cost whenever the best path became cheaper.
    std::vector<std::pair<size_t, double>> better;
    std::vector<std::pair<double, double>> path;
};

// A planner by name: "rrt-star", "bit-star", or "fmt-star" with so many samples; with OMPL's defaults otherwise.
inline ob::PlannerPtr planner(const ob::SpaceInformationPtr &information, const std::string &name, unsigned samples) {
    if (name == "rrt-star") return std::make_shared<og::RRTstar>(information);
    if (name == "bit-star") return std::make_shared<og::BITstar>(information);
    const auto fmt = std::make_shared<og::FMT>(information);
    fmt->setNumSamples(samples);
    return fmt;
}

// A run until so many states were checked; FMT* ends by itself.
inline Outcome run(const World &world, const std::string &name, size_t most, unsigned samples) {
    const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    ob::RealVectorBounds bounds(2);
    bounds.low = {world.bounds.left, world.bounds.bottom};
    bounds.high = {world.bounds.right, world.bounds.top};
    space->setBounds(bounds);
    const auto information = std::make_shared<ob::SpaceInformation>(space);
    const auto checker = std::make_shared<Checker>(information, world);
    information->setStateValidityChecker(checker);
    information->setup();
    ob::ScopedState<ob::RealVectorStateSpace> start(space), goal(space);
    for (unsigned i = 0; i < 2; ++i) {
        start->values[i] = world.start[i];
        goal->values[i] = world.goal[i];
    }
    const auto problem = std::make_shared<ob::ProblemDefinition>(information);
    problem->setStartAndGoalStates(start, goal, 1e-9);
    problem->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(information));
    Outcome outcome;
    const auto note = [&](double cost) {
        if (outcome.better.empty() || cost < outcome.better.back().second) outcome.better.emplace_back(checker->checks, cost);
    };
    problem->setIntermediateSolutionCallback(
        [&](const ob::Planner *, const std::vector<const ob::State *> &, const ob::Cost cost) { note(cost.value()); });
    const ob::PlannerPtr chosen = planner(information, name, samples);
    chosen->setProblemDefinition(problem);
    chosen->setup();
    checker->checks = 0;
    chosen->solve(ob::PlannerTerminationCondition([&] { return checker->checks >= most; }));
    if (!problem->hasExactSolution()) return outcome;
    auto &path = static_cast<og::PathGeometric &>(*problem->getSolutionPath());
    note(path.length());
    for (const ob::State *state : path.getStates()) outcome.path.emplace_back(state->as<Point>()->values[0], state->as<Point>()->values[1]);
    return outcome;
}

// One line of JSON for a job: FILE disc SEED RUNS planner most samples.
inline std::string answer(const World &world, unsigned seed, unsigned runs, const std::string &name, size_t most, unsigned samples) {
    std::ostringstream out;
    out.precision(17);
    for (unsigned run = 0; run < runs; ++run) {
        ompl::RNG::setSeed(seed + run + 1);
        const Outcome outcome = disc::run(world, name, most, samples);
        out << (run == 0 ? "" : ",") << "{\"better\":[";
        for (size_t i = 0; i < outcome.better.size(); ++i)
            out << (i == 0 ? "" : ",") << "[" << outcome.better[i].first << "," << outcome.better[i].second << "]";
        out << "],\"path\":[";
        for (size_t i = 0; i < outcome.path.size(); ++i)
            out << (i == 0 ? "" : ",") << "[" << outcome.path[i].first << "," << outcome.path[i].second << "]";
        out << "]}";
    }
    return "{\"runs\":[" + out.str() + "]}";
}
}  // namespace disc
