// The naive way with bounding boxes: pairs whose boxes do not meet are skipped.
//
// An obstacle is skipped when its box misses the sweep's, and an edge or a trail when its box
// misses that of all it is compared with. The rest are the rays of brute_force.cpp. Boxes
// decide most of a random scene, and nothing where all boxes overlap: still O(m * n) for
// each obstacle.

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

struct Box {
    Point low, high;
};

bool meet(const Box& a, const Box& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

Box box_of(const Segment& s) {
    return {{std::min(s.a.x, s.b.x), std::min(s.a.y, s.b.y)},
            {std::max(s.a.x, s.b.x), std::max(s.a.y, s.b.y)}};
}

Box box_of(const std::vector<Segment>& segments) {
    Box all = box_of(segments[0]);
    for (const Segment& segment : segments) {
        Box one = box_of(segment);
        all.low = {std::min(all.low.x, one.low.x), std::min(all.low.y, one.low.y)};
        all.high = {std::max(all.high.x, one.high.x), std::max(all.high.y, one.high.y)};
    }
    return all;
}

// Do two closed segments share a point? A segment may be a single point.
bool meet(const Segment& s, const Segment& t) {
    return side(s.a, s.b, t.a) * side(s.a, s.b, t.b) <= 0 &&
           side(t.a, t.b, s.a) * side(t.a, t.b, s.b) <= 0 && meet(box_of(s), box_of(t));
}

// Those of the segments whose boxes meet the given one.
std::vector<Segment> near(const std::vector<Segment>& segments, const Box& box) {
    std::vector<Segment> result;
    for (const Segment& segment : segments)
        if (meet(box_of(segment), box)) result.push_back(segment);
    return result;
}

bool some_meet(const std::vector<Segment>& first, const std::vector<Segment>& second) {
    const std::vector<Segment> candidates = near(second, box_of(first));
    for (const Segment& s : near(first, box_of(second)))
        for (const Segment& t : candidates)
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
    if (!meet(box_of(trails(robot, d)), box_of(edges(obstacle)))) return false;
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
