// A world for planar arms, rigid bodies and cars, read from the flat text that the benchmark writes, and the question whether the robot is free in it.
//
// The checker is meant to be as good as a careful user's: obstacles are prepared once, a link is compared with the box of an
// obstacle first, only then with its edges, and the first touch ends the test. Without boxes it is the checker of the course
// reports, which the aims of the benchmark were set against.
#pragma once
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

struct Box {
    double left, bottom, right, top;
};

// A directed line: positive on its left, in units of its length squared.
struct Line {
    double a, b, c;
    double side(double x, double y) const { return a * x + b * y + c; }
};

struct Convex {
    Box box;
    std::vector<Line> edges;  // counter-clockwise: inside is where no side is negative
    std::vector<double> corners;
};

struct Disc {
    double x, y, radius;
};

struct World {
    double base_x = 0, base_y = 0, radius = 0;
    std::vector<double> links, start, goal;
    bool is_bounded = false;
    Box bounds{};
    std::vector<Convex> polygons;
    std::vector<Disc> discs;
    // Of a body or a car: its convex shape in its own frame, corners counter-clockwise.
    std::vector<double> shape;
    // Of a car.
    double wheelbase = 0;
    std::vector<double> speed, steering, tolerance;
    // Off for the plain checker, which tests every link, or the shape, against every obstacle.
    bool compares_boxes = true;

    explicit World(const std::string &file);

    // Whether the arm at these angles, each relative to the link before, touches no obstacle and stays within the bounds.
    bool is_free(const double *angles) const;

    // The same for the shape placed at (x, y) and turned: by boxes, then by the edges of either polygon as separating lines.
    bool is_placed_free(double x, double y, double turn) const;

    // Whether a disc of the world's radius is free at (x, y): by boxes, then by the distance to a polygon that it is not within.
    bool is_disc_free(double x, double y) const;

private:
    bool is_link_free(double x0, double y0, double x1, double y1) const;
};

// Whether a segment meets a convex polygon: it is cut off at each edge in turn (Cyrus and Beck 1978), and something must stay.
inline bool meets(double x0, double y0, double x1, double y1, const Convex &polygon) {
    double from = 0, to = 1;
    for (const Line &edge : polygon.edges) {
        const double first = edge.side(x0, y0), last = edge.side(x1, y1);
        if (first < 0) {
            if (last < 0) return false;
            from = std::max(from, first / (first - last));
        } else if (last < 0) {
            to = std::min(to, first / (first - last));
        }
    }
    return from <= to;
}

inline double squared_distance(double x, double y, double x0, double y0, double x1, double y1) {
    const double along_x = x1 - x0, along_y = y1 - y0;
    const double t = ((x - x0) * along_x + (y - y0) * along_y) / (along_x * along_x + along_y * along_y);
    const double clamped = std::min(1.0, std::max(0.0, t));
    const double dx = x0 + clamped * along_x - x, dy = y0 + clamped * along_y - y;
    return dx * dx + dy * dy;
}

inline bool World::is_link_free(double x0, double y0, double x1, double y1) const {
    const double left = std::min(x0, x1), right = std::max(x0, x1), bottom = std::min(y0, y1), top = std::max(y0, y1);
    for (const Convex &polygon : polygons) {
        const Box &box = polygon.box;
        if (compares_boxes && (right < box.left || left > box.right || top < box.bottom || bottom > box.top)) continue;
        if (meets(x0, y0, x1, y1, polygon)) return false;
    }
    for (const Disc &disc : discs) {
        const double reach = disc.radius + radius;
        if (compares_boxes && (right < disc.x - reach || left > disc.x + reach || top < disc.y - reach || bottom > disc.y + reach)) continue;
        if (squared_distance(disc.x, disc.y, x0, y0, x1, y1) <= reach * reach) return false;
    }
    return true;
}

inline bool World::is_free(const double *angles) const {
    double x = base_x, y = base_y, direction = 0;
    for (size_t i = 0; i < links.size(); ++i) {
        direction += angles[i];
        const double next_x = x + links[i] * std::cos(direction), next_y = y + links[i] * std::sin(direction);
        if (is_bounded && (next_x - radius < bounds.left || next_x + radius > bounds.right ||
                           next_y - radius < bounds.bottom || next_y + radius > bounds.top))
            return false;
        if (!is_link_free(x, y, next_x, next_y)) return false;
        x = next_x;
        y = next_y;
    }
    return true;
}

// Whether one of the polygon's edges has all of the corners on its outer side.
inline bool separates(const Convex &polygon, const double *corners, size_t count) {
    for (const Line &edge : polygon.edges) {
        bool is_outside = true;
        for (size_t i = 0; i < count && is_outside; ++i) is_outside = edge.side(corners[2 * i], corners[2 * i + 1]) < 0;
        if (is_outside) return true;
    }
    return false;
}

// The same for the edges of the corners, counter-clockwise, and the polygon's corners.
inline bool separates(const double *corners, size_t count, const Convex &polygon) {
    for (size_t i = 0; i < count; ++i) {
        const double x = corners[2 * i], y = corners[2 * i + 1];
        const size_t next = (i + 1) % count;
        const double along_x = corners[2 * next] - x, along_y = corners[2 * next + 1] - y;
        bool is_outside = true;
        for (size_t j = 0; j < polygon.corners.size() && is_outside; j += 2)
            is_outside = along_x * (polygon.corners[j + 1] - y) - along_y * (polygon.corners[j] - x) < 0;
        if (is_outside) return true;
    }
    return false;
}

inline bool World::is_placed_free(double x, double y, double turn) const {
    double corners[64];
    const double c = std::cos(turn), s = std::sin(turn);
    Box box{1e300, 1e300, -1e300, -1e300};
    for (size_t i = 0; i < shape.size(); i += 2) {
        const double at_x = x + c * shape[i] - s * shape[i + 1], at_y = y + s * shape[i] + c * shape[i + 1];
        corners[i] = at_x;
        corners[i + 1] = at_y;
        box = {std::min(box.left, at_x), std::min(box.bottom, at_y), std::max(box.right, at_x), std::max(box.top, at_y)};
    }
    if (box.left < bounds.left || box.right > bounds.right || box.bottom < bounds.bottom || box.top > bounds.top) return false;
    const size_t count = shape.size() / 2;
    for (const Convex &polygon : polygons) {
        const Box &other = polygon.box;
        if (compares_boxes && (box.right < other.left || box.left > other.right || box.top < other.bottom || box.bottom > other.top)) continue;
        if (!separates(polygon, corners, count) && !separates(corners, count, polygon)) return false;
    }
    return true;
}

inline bool World::is_disc_free(double x, double y) const {
    if (x - radius < bounds.left || x + radius > bounds.right || y - radius < bounds.bottom || y + radius > bounds.top) return false;
    for (const Convex &polygon : polygons) {
        const Box &box = polygon.box;
        if (x + radius < box.left || x - radius > box.right || y + radius < box.bottom || y - radius > box.top) continue;
        bool is_within = true;
        for (const Line &edge : polygon.edges) is_within = is_within && edge.side(x, y) >= 0;
        if (is_within) return false;
        const std::vector<double> &corners = polygon.corners;
        for (size_t i = 0; i < corners.size(); i += 2) {
            const size_t next = (i + 2) % corners.size();
            if (squared_distance(x, y, corners[i], corners[i + 1], corners[next], corners[next + 1]) <= radius * radius) return false;
        }
    }
    for (const Disc &disc : discs) {
        const double reach = disc.radius + radius, dx = disc.x - x, dy = disc.y - y;
        if (dx * dx + dy * dy <= reach * reach) return false;
    }
    return true;
}

inline Convex convex(const std::vector<double> &corners) {
    Convex polygon{{corners[0], corners[1], corners[0], corners[1]}, {}, corners};
    for (size_t i = 0; i < corners.size(); i += 2) {
        const double x = corners[i], y = corners[i + 1];
        const size_t next = (i + 2) % corners.size();
        const double along_x = corners[next] - x, along_y = corners[next + 1] - y;
        polygon.edges.push_back({-along_y, along_x, along_y * x - along_x * y});
        Box &box = polygon.box;
        box = {std::min(box.left, x), std::min(box.bottom, y), std::max(box.right, x), std::max(box.top, y)};
    }
    return polygon;
}

// One item a line: a word and its numbers.
inline World::World(const std::string &file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot read " + file);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        std::vector<double> numbers;
        for (double number; words >> number;) numbers.push_back(number);
        if (kind == "base") {
            base_x = numbers.at(0);
            base_y = numbers.at(1);
        } else if (kind == "radius") {
            radius = numbers.at(0);
        } else if (kind == "links") {
            links = numbers;
        } else if (kind == "start") {
            start = numbers;
        } else if (kind == "goal") {
            goal = numbers;
        } else if (kind == "shape") {
            if (numbers.size() > 64) throw std::runtime_error("at most 32 corners");
            shape = numbers;
        } else if (kind == "wheelbase") {
            wheelbase = numbers.at(0);
        } else if (kind == "speed") {
            speed = numbers;
        } else if (kind == "steering") {
            steering = numbers;
        } else if (kind == "tolerance") {
            tolerance = numbers;
        } else if (kind == "bounds") {
            is_bounded = true;
            bounds = {numbers.at(0), numbers.at(1), numbers.at(2), numbers.at(3)};
        } else if (kind == "polygon") {
            polygons.push_back(convex(numbers));
        } else if (kind == "disc") {
            discs.push_back({numbers.at(0), numbers.at(1), numbers.at(2)});
        } else {
            throw std::runtime_error("unknown item in " + file + ": " + kind);
        }
    }
    if (!polygons.empty() && radius > 0 && !links.empty()) throw std::runtime_error("thick links among polygons are not prepared for");
}
