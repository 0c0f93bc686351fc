// OMPL on the cells of a map: the other side of `npm run bench:worlds -- --files`.
//
//   FILE PLANNER SEED SECONDS
//
// The checker is a plain one for an occupancy grid: it looks at every occupied cell under the box of the robot. A motion is checked
// every cell. Planners have OMPL's defaults and end with their first path; times are those of the processor.
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/config.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Point = ob::RealVectorStateSpace::StateType;
using Pose = ob::SE2StateSpace::StateType;

// The occupied cells, from the lowest row, and the robot: a disc, or a convex shape, counter-clockwise.
struct Map {
    int width = 0, height = 0;
    double resolution = 1;
    std::vector<bool> occupied;
    double radius = 0;
    std::vector<double> shape, start, goal;

    explicit Map(const std::string &file);

    // Calls `touches` with the corners of every occupied cell under a box, until one does; what leaves the map touches.
    template <class Touches> bool is_free(double left, double bottom, double right, double top, Touches touches) const {
        if (left < 0 || bottom < 0 || right > width * resolution || top > height * resolution) return false;
        const auto cell = [&](double x, int count) { return std::min(count - 1, static_cast<int>(x / resolution)); };
        for (int y = cell(bottom, height); y <= cell(top, height); ++y)
            for (int x = cell(left, width); x <= cell(right, width); ++x)
                if (occupied[y * width + x] && touches(x * resolution, y * resolution)) return false;
        return true;
    }

    bool is_disc_free(double x, double y) const {
        return is_free(x - radius, y - radius, x + radius, y + radius, [&](double left, double bottom) {
            const double dx = std::max({left - x, 0.0, x - left - resolution});
            const double dy = std::max({bottom - y, 0.0, y - bottom - resolution});
            return dx * dx + dy * dy <= radius * radius;
        });
    }

    bool is_shape_free(double x, double y, double turn) const {
        double corners[64];
        const double c = std::cos(turn), s = std::sin(turn);
        double left = 1e300, bottom = 1e300, right = -1e300, top = -1e300;
        for (size_t i = 0; i < shape.size(); i += 2) {
            corners[i] = x + c * shape[i] - s * shape[i + 1];
            corners[i + 1] = y + s * shape[i] + c * shape[i + 1];
            left = std::min(left, corners[i]);
            right = std::max(right, corners[i]);
            bottom = std::min(bottom, corners[i + 1]);
            top = std::max(top, corners[i + 1]);
        }
        // The box of the shape meets the cell; else a side of the shape is between them.
        return is_free(left, bottom, right, top, [&](double low_x, double low_y) {
            for (size_t i = 0; i < shape.size(); i += 2) {
                const size_t next = (i + 2) % shape.size();
                const double ax = corners[next] - corners[i], ay = corners[next + 1] - corners[i + 1];
                const double from_x = low_x + (ay > 0 ? 0 : resolution), from_y = low_y + (ax > 0 ? resolution : 0);
                if (ax * (from_y - corners[i + 1]) - ay * (from_x - corners[i]) < 0) return false;
            }
            return true;
        });
    }
};

Map::Map(const std::string &file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot read " + file);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        std::vector<double> numbers;
        if (kind == "cells") {
            std::string row;
            words >> row;
            for (const char cell : row) occupied.push_back(cell == '1');
            continue;
        }
        for (double number; words >> number;) numbers.push_back(number);
        if (kind == "grid") {
            width = static_cast<int>(numbers.at(0));
            height = static_cast<int>(numbers.at(1));
            resolution = numbers.at(2);
        } else if (kind == "radius") {
            radius = numbers.at(0);
        } else if (kind == "shape") {
            if (numbers.size() > 64) throw std::runtime_error("at most 32 corners");
            shape = numbers;
        } else if (kind == "start") {
            start = numbers;
        } else if (kind == "goal") {
            goal = numbers;
        } else {
            throw std::runtime_error("unknown item in " + file + ": " + kind);
        }
    }
    if (occupied.size() != static_cast<size_t>(width) * height) throw std::runtime_error("cells are missing in " + file);
}

static double spent() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

static ob::PlannerPtr planner(const ob::SpaceInformationPtr &information, const std::string &name) {
    if (name == "rrt-connect") return std::make_shared<og::RRTConnect>(information);
    if (name == "rrt") return std::make_shared<og::RRT>(information);
    if (name == "prm") return std::make_shared<og::PRM>(information);
    if (name == "bit-star") return std::make_shared<og::BITstar>(information);
    throw std::runtime_error("there is no planner " + name);
}

static std::string solve(const Map &map, const std::string &name, unsigned seed, double limit) {
    ompl::RNG::setSeed(seed);
    const double began = spent();
    const bool turns = !map.shape.empty();
    ob::RealVectorBounds bounds(2);
    bounds.low = {0, 0};
    bounds.high = {map.width * map.resolution, map.height * map.resolution};
    const double step = map.resolution / std::hypot(bounds.high[0], bounds.high[1]);
    ob::StateSpacePtr space;
    if (turns) {
        const auto poses = std::make_shared<ob::SE2StateSpace>();
        poses->setBounds(bounds);
        poses->getSubspace(0)->setLongestValidSegmentFraction(step);
        space = poses;
    } else {
        const auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
        plane->setBounds(bounds);
        plane->setLongestValidSegmentFraction(step);
        space = plane;
    }
    const auto information = std::make_shared<ob::SpaceInformation>(space);
    information->setStateValidityChecker([&](const ob::State *state) {
        if (turns) {
            const auto *pose = state->as<Pose>();
            return map.is_shape_free(pose->getX(), pose->getY(), pose->getYaw());
        }
        const double *at = state->as<Point>()->values;
        return map.is_disc_free(at[0], at[1]);
    });
    information->setup();
    ob::ScopedState<> start(space), goal(space);
    for (size_t i = 0; i < map.start.size(); ++i) {
        start[i] = map.start[i];
        goal[i] = map.goal[i];
    }
    const auto problem = std::make_shared<ob::ProblemDefinition>(information);
    problem->setStartAndGoalStates(start, goal);
    if (name == "bit-star") {
        const auto length = std::make_shared<ob::PathLengthOptimizationObjective>(information);
        length->setCostThreshold(length->infiniteCost());
        problem->setOptimizationObjective(length);
    }
    const ob::PlannerPtr chosen = planner(information, name);
    chosen->setProblemDefinition(problem);
    chosen->setup();
    chosen->solve(ob::PlannerTerminationCondition([&] { return spent() - began > limit; }));
    const double seconds = spent() - began;
    std::ostringstream out;
    out.precision(17);
    out << "{\"seconds\":" << seconds << ",\"path\":[";
    if (problem->hasExactSolution()) {
        const auto &path = static_cast<og::PathGeometric &>(*problem->getSolutionPath());
        for (size_t i = 0; i < path.getStateCount(); ++i) {
            std::vector<double> numbers;
            space->copyToReals(numbers, path.getState(i));
            out << (i == 0 ? "[" : ",[");
            for (size_t k = 0; k < numbers.size(); ++k) out << (k == 0 ? "" : ",") << numbers[k];
            out << "]";
        }
    }
    out << "]}";
    return out.str();
}

int main() {
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    std::cout << "{\"name\":\"OMPL " << OMPL_MAJOR_VERSION << "." << OMPL_MINOR_VERSION << "." << OMPL_PATCH_VERSION << "\"}" << std::endl;
    std::string last;
    std::unique_ptr<Map> map;
    for (std::string line; std::getline(std::cin, line);) {
        std::istringstream words(line);
        std::string file, name;
        unsigned seed = 0;
        double limit = 0;
        words >> file >> name >> seed >> limit;
        try {
            if (file != last) {
                map = std::make_unique<Map>(file);
                last = file;
            }
            std::cout << solve(*map, name, seed, limit) << std::endl;
        } catch (const std::exception &error) {
            std::cout << "{\"error\":\"" << error.what() << "\"}" << std::endl;
        }
    }
}
