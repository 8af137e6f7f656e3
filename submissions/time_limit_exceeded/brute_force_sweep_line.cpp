// The naive way with a sweep line: only segments that overlap in x and y are compared.
//
// Obstacles come in the order of their left ends, and those beyond the sweep's right end are
// never looked at. The segments of a pair are sorted by their left ends; a vertical line runs
// over them and keeps those that it crosses. Where moves are long it crosses all trails at
// once: still O(m * n) for each obstacle.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <utility>
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

struct Entry {
    Segment segment;
    Box box;
    bool of_first;
};

// Does a segment of one set meet one of the other? The lists of open segments keep those that
// the line has passed until they are next looked through.
bool some_meet(const std::vector<Segment>& first, const std::vector<Segment>& second) {
    std::vector<Entry> entries;
    for (const Segment& s : first) entries.push_back({s, box_of(s), true});
    for (const Segment& s : second) entries.push_back({s, box_of(s), false});
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return a.box.low.x < b.box.low.x; });
    std::vector<Entry> open_first, open_second;
    for (const Entry& entry : entries) {
        std::vector<Entry>& others = entry.of_first ? open_second : open_first;
        for (size_t i = 0; i < others.size();) {
            if (others[i].box.high.x < entry.box.low.x) {
                others[i] = others.back();
                others.pop_back();
                continue;
            }
            if (meet(others[i].box, entry.box) && meet(others[i].segment, entry.segment))
                return true;
            ++i;
        }
        (entry.of_first ? open_first : open_second).push_back(entry);
    }
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

bool collide(const Polygon& robot, const std::vector<Polygon>& obstacles, Point d) {
    const Box sweep = box_of(trails(robot, d));
    std::vector<std::pair<Box, const Polygon*>> by_left_end;
    for (const Polygon& obstacle : obstacles)
        by_left_end.push_back({box_of(edges(obstacle)), &obstacle});
    std::sort(by_left_end.begin(), by_left_end.end(),
              [](const auto& a, const auto& b) { return a.first.low.x < b.first.low.x; });
    for (const auto& [box, obstacle] : by_left_end) {
        if (box.low.x > sweep.high.x) break;
        if (meet(box, sweep) && collide(robot, *obstacle, d)) return true;
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
        std::vector<Polygon> obstacles;
        for (; k > 0; --k) obstacles.push_back(read_polygon(read_integer()));
        puts(collide(robot, obstacles, displacement) ? "NO" : "YES");
    }
}
