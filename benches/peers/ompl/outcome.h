// What one run came to, a clock, and a limit in time.
#pragma once
#include <ompl/base/PlannerTerminationCondition.h>
#include <chrono>
#include <cstddef>

struct Outcome {
    double setup = 0, build = 0, search = 0, length = 0;
    bool is_solved = false;
    size_t motions = 0, vertices = 0, edges = 0;
};

inline double seconds() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

// Reads the clock once in 32 iterations, as Planarium's side does; OMPL's own condition reads it in each.
inline ompl::base::PlannerTerminationCondition within(double limit) {
    const double end = seconds() + limit;
    return ompl::base::PlannerTerminationCondition([end, calls = 0u, is_over = false]() mutable {
        if (++calls % 32 == 0) is_over = seconds() > end;
        return is_over;
    });
}
