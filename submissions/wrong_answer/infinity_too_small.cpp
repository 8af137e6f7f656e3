// Looks for the least and the greatest product from 10^15 down and up: products reach 4 * 10^16.
//
// If all products of a polygon are beyond 10^15, its range on the axis begins there instead.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <vector>

struct Point {
    int64_t x, y;
};

using Polygon = std::vector<Point>;  // convex, counter-clockwise

Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
int64_t dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
Point normal(Point d) { return {d.y, -d.x}; }

const int64_t INFINITE = 1000000000000000;  // 10^15

struct Range {
    int64_t low, high;
};

// What a polygon covers on the axis. O(n).
Range project(const Polygon& polygon, Point axis) {
    Range range = {INFINITE, -INFINITE};
    for (Point vertex : polygon) {
        range.low = std::min(range.low, dot(vertex, axis));
        range.high = std::max(range.high, dot(vertex, axis));
    }
    return range;
}

// Does a line across the axis separate the robot, on its whole move, from the obstacle?
bool parts(const Polygon& robot, Point d, const Polygon& obstacle, Point axis) {
    Range swept = project(robot, axis);
    swept.low += std::min<int64_t>(0, dot(d, axis));
    swept.high += std::max<int64_t>(0, dot(d, axis));
    Range still = project(obstacle, axis);
    return swept.high < still.low || still.high < swept.low;
}

// Does any edge of the polygon give an axis that separates the two?
bool some_edge_parts(const Polygon& polygon, const Polygon& robot, Point d,
                     const Polygon& obstacle) {
    Point previous = polygon.back();
    for (Point vertex : polygon) {
        if (parts(robot, d, obstacle, normal(vertex - previous))) return true;
        previous = vertex;
    }
    return false;
}

bool collide(const Polygon& robot, Point d, const Polygon& obstacle) {
    return !some_edge_parts(robot, robot, d, obstacle) &&
           !some_edge_parts(obstacle, robot, d, obstacle) &&
           !parts(robot, d, obstacle, normal(d));
}

int64_t read_integer() {
    int c = getchar_unlocked();
    while (c != '-' && (c < '0' || c > '9')) c = getchar_unlocked();
    bool negative = c == '-';
    if (negative) c = getchar_unlocked();
    int64_t value = 0;
    for (; '0' <= c && c <= '9'; c = getchar_unlocked()) value = 10 * value + (c - '0');
    return negative ? -value : value;
}

Point read_point() {
    int64_t x = read_integer();
    int64_t y = read_integer();
    return {x, y};
}

Polygon read_polygon(int64_t vertices) {
    Polygon polygon(vertices);
    for (Point& vertex : polygon) vertex = read_point();
    return polygon;
}

int main() {
    for (int64_t t = read_integer(); t > 0; --t) {
        int64_t m = read_integer();
        int64_t k = read_integer();
        Point displacement = read_point();
        Polygon robot = read_polygon(m);

        bool free = true;
        for (; k > 0; --k) {
            Polygon obstacle = read_polygon(read_integer());
            free = free && !collide(robot, displacement, obstacle);
        }
        puts(free ? "YES" : "NO");
    }
}
