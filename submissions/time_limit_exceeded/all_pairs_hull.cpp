// The Minkowski sum by its definition: the hull of all differences of two vertices.
//
// The robot at both ends of its move and the obstacle give 2 m n differences; the origin is
// looked for in their convex hull. The differences are gathered in batches, so that memory
// is no trouble, but time is: O(m n log(m n)) for each obstacle.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <vector>

struct Point {
    int64_t x, y;
};

using Polygon = std::vector<Point>;

Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
bool operator<(Point a, Point b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }

int64_t cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }

// The convex hull, counter-clockwise, by two monotone chains. O(n log n).
Polygon convex_hull(Polygon points) {
    std::sort(points.begin(), points.end());
    Polygon hull;
    for (int chain = 0; chain < 2; ++chain) {
        size_t start = hull.size();
        for (Point point : points) {
            while (hull.size() >= start + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0)
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();  // the next chain begins with it
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

bool contains_origin(const Polygon& polygon) {
    Point previous = polygon.back();
    for (Point vertex : polygon) {
        if (cross(previous, vertex) < 0) return false;
        previous = vertex;
    }
    return true;
}

bool collide(const Polygon& robot, const Polygon& obstacle, Point d) {
    const size_t batch = 1 << 20;
    Polygon differences;
    for (Point p : robot) {
        for (Point q : obstacle) {
            differences.push_back(p - q);
            differences.push_back(p + d - q);
            if (differences.size() >= batch) differences = convex_hull(differences);
        }
    }
    return contains_origin(convex_hull(differences));
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
