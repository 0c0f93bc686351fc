// What one run came to, and a clock.
#pragma once
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
