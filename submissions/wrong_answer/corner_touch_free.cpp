// Forgives corner against corner: segments that share only an end point do not count.
//
// Meant to keep neighbouring edges apart from each other, it also forgives a robot that touches
// an obstacle vertex to vertex.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <vector>

struct Point {
    int64_t x, y;
};

struct Segment {
    Point a, b;
};

using Polygon = std::vector<Point>;  // convex, counter-clockwise

Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }

// -1, 0, +1: c lies to the right of, on, to the left of the line from a to b.
int side(Point a, Point b, Point c) {
    int64_t turn = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return (turn > 0) - (turn < 0);
}

bool boxes_meet(const Segment& s, const Segment& t) {
    return std::min(s.a.x, s.b.x) <= std::max(t.a.x, t.b.x) &&
           std::min(t.a.x, t.b.x) <= std::max(s.a.x, s.b.x) &&
           std::min(s.a.y, s.b.y) <= std::max(t.a.y, t.b.y) &&
           std::min(t.a.y, t.b.y) <= std::max(s.a.y, s.b.y);
}

bool same(Point a, Point b) { return a.x == b.x && a.y == b.y; }

// Do two closed segments share a point that is not an end of both?
bool meet(const Segment& s, const Segment& t) {
    if (same(s.a, t.a) || same(s.a, t.b) || same(s.b, t.a) || same(s.b, t.b)) return false;
    return side(s.a, s.b, t.a) * side(s.a, s.b, t.b) <= 0 &&
           side(t.a, t.b, s.a) * side(t.a, t.b, s.b) <= 0 && boxes_meet(s, t);
}

bool some_meet(const std::vector<Segment>& first, const std::vector<Segment>& second) {
    for (const Segment& s : first)
        for (const Segment& t : second)
            if (meet(s, t)) return true;
    return false;
}

std::vector<Segment> edges(const Polygon& polygon) {
    std::vector<Segment> result;
    Point previous = polygon.back();
    for (Point vertex : polygon) {
        result.push_back({previous, vertex});
        previous = vertex;
    }
    return result;
}

// What the vertices of a polygon travel when it moves by d.
std::vector<Segment> trails(const Polygon& polygon, Point d) {
    std::vector<Segment> result;
    for (Point vertex : polygon) result.push_back({vertex, vertex + d});
    return result;
}

bool contains(const Polygon& polygon, Point p) {
    for (const Segment& edge : edges(polygon))
        if (side(edge.a, edge.b, p) < 0) return false;
    return true;
}

bool collide(const Polygon& robot, const Polygon& obstacle, Point d) {
    return contains(obstacle, robot[0]) || contains(robot, obstacle[0]) ||
           some_meet(edges(robot), edges(obstacle)) ||
           some_meet(trails(robot, d), edges(obstacle)) ||
           some_meet(trails(obstacle, Point{0, 0} - d), edges(robot));
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
            free = free && !collide(robot, obstacle, displacement);
        }
        puts(free ? "YES" : "NO");
    }
}
