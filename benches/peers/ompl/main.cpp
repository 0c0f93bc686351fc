// OMPL's side of the benchmark: planners for planar arms, rigid bodies and cars, one job a line of standard input, one line of JSON each.
//
//   FILE prm SEED RUNS samples k space                        build and one query
//   FILE rrt-connect SEED RUNS range resolution limit space   up to the first path; lengths in radians, the limit in seconds
//
//   FILE body SEED RUNS range resolution limit checker        RRT-Connect for a rigid body; distances in the metric, range 0 for OMPL's default
//   FILE control SEED RUNS least most limit checker           RRT for a car by controls, held for so many steps of 0.01 s
//   FILE sst SEED RUNS least most limit checker               SST, likewise
//   FILE disc SEED RUNS planner most samples                  a disc; what its best path costs, until so many states were checked
//
// The space is "flat" or "compound", see below, or "plain": flat, with a checker that compares no boxes. The checker of a body or a
// car is "boxes" or "plain". Seeds are SEED, SEED + 1, ... Every run has its own planner, space and validity checker; making them
// is its set-up.
#include "disc.h"
#include "outcome.h"
#include "placed.h"
#include "world.h"
#include <ompl/base/MotionValidator.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/config.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <cstdio>
#include <iostream>
#include <memory>

namespace ob = ompl::base;
namespace og = ompl::geometric;

static const double *angles(const ob::State *state) { return state->as<ob::RealVectorStateSpace::StateType>()->values; }
static double *angles(ob::State *state) { return state->as<ob::RealVectorStateSpace::StateType>()->values; }

// From -2 pi .. 2 pi to the short way round.
static double short_way(double turn) {
    if (turn > M_PI) return turn - 2 * M_PI;
    if (turn < -M_PI) return turn + 2 * M_PI;
    return turn;
}

// One circle a joint, angles in [-pi, pi], distance the sum of the turns. Flat in memory, the least that OMPL allows.
struct Torus : ob::RealVectorStateSpace {
    explicit Torus(unsigned joints) : ob::RealVectorStateSpace(joints) { setBounds(-M_PI, M_PI); }
    bool isMetricSpace() const override { return true; }
    double getMaximumExtent() const override { return M_PI * dimension_; }
    double distance(const ob::State *a, const ob::State *b) const override {
        double sum = 0;
        for (unsigned i = 0; i < dimension_; ++i) {
            const double turn = std::fabs(angles(a)[i] - angles(b)[i]);
            sum += turn > M_PI ? 2 * M_PI - turn : turn;
        }
        return sum;
    }
    void interpolate(const ob::State *a, const ob::State *b, double t, ob::State *at) const override {
        for (unsigned i = 0; i < dimension_; ++i)
            angles(at)[i] = short_way(angles(a)[i] + t * short_way(angles(b)[i] - angles(a)[i]));
    }
};

struct Checker : ob::StateValidityChecker {
    const World &world;
    Checker(const ob::SpaceInformationPtr &space, const World &world) : ob::StateValidityChecker(space), world(world) {}
    bool isValid(const ob::State *state) const override { return world.is_free(angles(state)); }
};

// The same space as OMPL's users write it: a compound of its SO(2) spaces, each joint a state of its own behind a pointer.
struct Compound : ob::CompoundStateSpace {
    explicit Compound(unsigned joints) {
        for (unsigned i = 0; i < joints; ++i) addSubspace(std::make_shared<ob::SO2StateSpace>(), 1.0);
        lock();
    }
    // In the metric of the whole, as in the flat space; OMPL would take the joint that turns most.
    unsigned validSegmentCount(const ob::State *a, const ob::State *b) const override {
        return ob::StateSpace::validSegmentCount(a, b);
    }
};

static double &joint(ob::State *state, unsigned i) {
    return state->as<ob::CompoundState>()->as<ob::SO2StateSpace::StateType>(i)->value;
}

struct CompoundChecker : ob::StateValidityChecker {
    const World &world;
    CompoundChecker(const ob::SpaceInformationPtr &space, const World &world)
        : ob::StateValidityChecker(space), world(world) {}
    bool isValid(const ob::State *state) const override {
        double at[8];
        const auto *joints = state->as<ob::CompoundState>();
        for (size_t i = 0; i < world.links.size(); ++i) at[i] = joints->as<ob::SO2StateSpace::StateType>(i)->value;
        return world.is_free(at);
    }
};

// The reports' test of an edge: 20 configurations along it, the far end included, from its beginning on.
struct TwentyPlaces : ob::MotionValidator {
    mutable size_t motions = 0;
    ob::State *place;
    explicit TwentyPlaces(const ob::SpaceInformationPtr &space) : ob::MotionValidator(space), place(space->allocState()) {}
    ~TwentyPlaces() override { si_->freeState(place); }
    bool checkMotion(const ob::State *a, const ob::State *b) const override {
        ++motions;
        for (int i = 1; i <= 20; ++i) {
            si_->getStateSpace()->interpolate(a, b, i / 20.0, place);
            if (!si_->isValid(place)) return false;
        }
        return true;
    }
    bool checkMotion(const ob::State *a, const ob::State *b, std::pair<ob::State *, double> &) const override {
        return checkMotion(a, b);
    }
};

// PRM grown to so many milestones and asked once; its own solve() counts time, not milestones.
struct Roadmap : og::PRM {
    using PRM::PRM;
    ob::PathPtr query(const ob::State *start, const ob::State *goal) {
        const Vertex a = addMilestone(si_->cloneState(start)), b = addMilestone(si_->cloneState(goal));
        return sameComponent(a, b) ? constructSolution(a, b) : nullptr;
    }
};

// A problem of its own for every run.
struct Task {
    ob::StateSpacePtr space;
    ob::SpaceInformationPtr information;
    ob::ProblemDefinitionPtr problem;
    ob::ScopedState<> start, goal;

    Task(const World &world, bool is_flat)
        : space(make_space(world.links.size(), is_flat)), information(std::make_shared<ob::SpaceInformation>(space)),
          start(space), goal(space) {
        if (is_flat)
            information->setStateValidityChecker(std::make_shared<Checker>(information, world));
        else
            information->setStateValidityChecker(std::make_shared<CompoundChecker>(information, world));
        for (size_t i = 0; i < world.links.size(); ++i) {
            (is_flat ? angles(start.get())[i] : joint(start.get(), i)) = std::remainder(world.start[i], 2 * M_PI);
            (is_flat ? angles(goal.get())[i] : joint(goal.get(), i)) = std::remainder(world.goal[i], 2 * M_PI);
        }
        problem = std::make_shared<ob::ProblemDefinition>(information);
        problem->setStartAndGoalStates(start, goal, 1e-9);
    }

    static ob::StateSpacePtr make_space(unsigned joints, bool is_flat) {
        if (is_flat) return std::make_shared<Torus>(joints);
        return std::make_shared<Compound>(joints);
    }
};

static Outcome prm(const World &world, bool is_flat, unsigned samples, unsigned k) {
    const double asked = seconds();
    Task task(world, is_flat);
    const auto edges = std::make_shared<TwentyPlaces>(task.information);
    task.information->setMotionValidator(edges);
    task.information->setup();
    Roadmap planner(task.information);
    planner.setProblemDefinition(task.problem);
    planner.setup();
    planner.setMaxNearestNeighbors(k);
    Outcome outcome;
    const double began = seconds();
    planner.growRoadmap(ob::PlannerTerminationCondition([&] { return planner.milestoneCount() >= samples; }));
    const double built = seconds();
    const ob::PathPtr path = planner.query(task.start.get(), task.goal.get());
    const double done = seconds();
    outcome.setup = began - asked;
    outcome.build = built - began;
    outcome.search = done - built;
    outcome.is_solved = path != nullptr;
    outcome.length = path ? path->length() : 0;
    outcome.motions = edges->motions;
    outcome.vertices = planner.milestoneCount();
    outcome.edges = planner.edgeCount();
    return outcome;
}

static Outcome rrt_connect(const World &world, bool is_flat, double range, double resolution, double limit) {
    const double asked = seconds();
    Task task(world, is_flat);
    task.space->setLongestValidSegmentFraction(resolution / task.space->getMaximumExtent());
    task.information->setup();
    og::RRTConnect planner(task.information);
    planner.setRange(range);
    planner.setProblemDefinition(task.problem);
    planner.setup();
    Outcome outcome;
    const double began = seconds();
    const ob::PlannerStatus status = planner.solve(within(limit));
    outcome.build = seconds() - began;
    outcome.setup = began - asked;
    outcome.is_solved = status == ob::PlannerStatus::EXACT_SOLUTION;
    outcome.length = outcome.is_solved ? task.problem->getSolutionPath()->length() : 0;
    // OMPL's own validator counts its motions.
    outcome.motions = task.information->getMotionValidator()->getValidMotionCount() +
                      task.information->getMotionValidator()->getInvalidMotionCount();
    ob::PlannerData data(task.information);
    planner.getPlannerData(data);
    outcome.vertices = data.numVertices();
    outcome.edges = data.numEdges();
    return outcome;
}

static std::string answer(const std::string &job) {
    std::istringstream words(job);
    std::string file, planner, space;
    unsigned seed = 0, runs = 0;
    words >> file >> planner >> seed >> runs;
    if (planner == "disc") {
        std::string name;
        size_t most = 0;
        unsigned samples = 0;
        words >> name >> most >> samples;
        return disc::answer(World(file), seed, runs, name, most, samples);
    }
    double a = 0, b = 0, c = 0;
    words >> a >> b;
    if (planner != "prm") words >> c;
    words >> space;
    const bool is_placed = planner == "body" || planner == "control" || planner == "sst";
    if (space != "plain" && (is_placed ? space != "boxes" : space != "flat" && space != "compound")) throw std::runtime_error("not a job: " + job);
    const bool is_flat = space != "compound";
    World world(file);
    world.compares_boxes = space != "plain";
    std::ostringstream out;
    out.precision(9);
    for (unsigned run = 0; run < runs; ++run) {
        // OMPL takes no seed 0.
        ompl::RNG::setSeed(seed + run + 1);
        const Outcome outcome = planner == "prm"       ? prm(world, is_flat, unsigned(a), unsigned(b))
                                : planner == "body"    ? body(world, a, b, c)
                                : planner == "control" ? car(world, false, unsigned(a), unsigned(b), c)
                                : planner == "sst"     ? car(world, true, unsigned(a), unsigned(b), c)
                                                       : rrt_connect(world, is_flat, a, b, c);
        out << (run == 0 ? "" : ",") << "{\"setup\":" << outcome.setup << ",\"build\":" << outcome.build << ",\"search\":" << outcome.search
            << ",\"solved\":" << (outcome.is_solved ? "true" : "false") << ",\"length\":" << outcome.length
            << ",\"motions\":" << outcome.motions << ",\"vertices\":" << outcome.vertices << ",\"edges\":" << outcome.edges
            << "}";
    }
    return "{\"runs\":[" + out.str() + "]}";
}

int main() {
    ompl::msg::noOutputHandler();
    std::cout << "{\"name\":\"OMPL " << OMPL_MAJOR_VERSION << "." << OMPL_MINOR_VERSION << "." << OMPL_PATCH_VERSION << "\"}" << std::endl;
    for (std::string job; std::getline(std::cin, job);) {
        try {
            std::cout << answer(job) << std::endl;
        } catch (const std::exception &error) {
            std::cout << "{\"error\":\"" << error.what() << "\"}" << std::endl;
        }
    }
}
