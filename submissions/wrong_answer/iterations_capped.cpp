// Turns an axis towards the obstacle's nearest corners, and gives up after 12 turns: collision.
//
// Each turn mirrors the axis in the line of the two extreme corners (Chung and Wang). Far
// apart, a few turns do; near a touch it takes as many as it takes, and never ends at a touch.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

struct Point {
    int64_t x, y;
};

using Polygon = std::vector<Point>;  // convex, counter-clockwise

Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }

struct Axis {
    double x, y;
};

double dot(Axis axis, Point p) {
    return axis.x * static_cast<double>(p.x) + axis.y * static_cast<double>(p.y);
}

// The vertex that lies farthest along the axis. O(n).
Point farthest(const Polygon& polygon, Axis axis) {
    Point best = polygon[0];
    for (Point vertex : polygon)
        if (dot(axis, vertex) > dot(axis, best)) best = vertex;
    return best;
}

bool collide(const Polygon& robot, Point d, const Polygon& obstacle) {
    Point first = obstacle[0] - robot[0];
    Axis axis = {static_cast<double>(first.x), static_cast<double>(first.y)};
    for (int turns = 0; turns < 12; ++turns) {
        Point swept = farthest(robot, axis);
        if (dot(axis, d) > 0) swept = swept + d;
        Point gap = farthest(obstacle, {-axis.x, -axis.y}) - swept;
        if (dot(axis, gap) > 0) return false;  // a line across the axis separates them
        if (gap.x == 0 && gap.y == 0) return true;
        double length = std::hypot(static_cast<double>(gap.x), static_cast<double>(gap.y));
        double factor = 2 * dot(axis, gap) / (length * length);
        axis = {axis.x - factor * static_cast<double>(gap.x),
                axis.y - factor * static_cast<double>(gap.y)};
    }
    return true;
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
