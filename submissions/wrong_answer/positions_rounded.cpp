// Looks at 16 positions on the way, each rounded to whole coordinates.
//
// Between two positions much is missed, and a rounded position is not quite on the way, so that
// the robot touches what it passes.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

const int64_t STEPS = 15;

struct Point {
    int64_t x, y;
};

using Polygon = std::vector<Point>;  // convex, counter-clockwise

Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
int64_t dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
Point normal(Point d) { return {d.y, -d.x}; }

struct Range {
    int64_t low, high;
};

// What a polygon covers on the axis. O(n).
Range project(const Polygon& polygon, Point axis) {
    Range range = {dot(polygon[0], axis), dot(polygon[0], axis)};
    for (Point vertex : polygon) {
        range.low = std::min(range.low, dot(vertex, axis));
        range.high = std::max(range.high, dot(vertex, axis));
    }
    return range;
}

// Does any edge of p give an axis that separates p from q?
bool some_edge_parts(const Polygon& p, const Polygon& q) {
    Point previous = p.back();
    for (Point vertex : p) {
        Range mine = project(p, normal(vertex - previous));
        Range others = project(q, normal(vertex - previous));
        if (mine.high < others.low || others.high < mine.low) return true;
        previous = vertex;
    }
    return false;
}

// The nearest integer to part / STEPS of a distance.
int64_t rounded(int64_t distance, int64_t part) {
    return std::llround(static_cast<double>(distance) * part / STEPS);
}

bool collide(const Polygon& robot, Point d, const Polygon& obstacle) {
    for (int64_t part = 0; part <= STEPS; ++part) {
        Polygon moved = robot;
        for (Point& vertex : moved) {
            vertex.x += rounded(d.x, part);
            vertex.y += rounded(d.y, part);
        }
        if (!some_edge_parts(moved, obstacle) && !some_edge_parts(obstacle, moved)) return true;
    }
    return false;
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
