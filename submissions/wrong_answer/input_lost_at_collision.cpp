// Leaves the loop at the first collision: the obstacles not read yet become the next scenario.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <vector>

struct Point {
    int64_t x, y;
};

using Polygon = std::vector<Point>;  // convex, counter-clockwise

Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator-(Point a) { return {-a.x, -a.y}; }

// Lowest first, then leftmost. From that vertex on, edge directions turn from 0 up to 360 degrees.
bool operator<(Point a, Point b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }

// Twice the signed area of the triangle (origin, a, b): positive iff b is to the left of a.
int64_t cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }

// The same polygon, starting at its lowest vertex. O(n).
Polygon from_lowest(Polygon polygon) {
    std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
    return polygon;
}

// {p + q : p in a, q in b}, by merging the edges of both by direction. O(|a| + |b|).
// Both start at their lowest vertex, and so does the result. A segment is a polygon
// of two vertices; if its ends coincide, it is a point, and that works as well.
Polygon minkowski_sum(const Polygon& a, const Polygon& b) {
    Polygon sum;
    sum.reserve(a.size() + b.size());
    size_t i = 0, j = 0;
    while (i < a.size() || j < b.size()) {
        const Point& p = a[i % a.size()];
        const Point& q = b[j % b.size()];
        sum.push_back(p + q);
        int64_t turn = 0;
        if (i == a.size()) {
            turn = -1;
        } else if (j == b.size()) {
            turn = +1;
        } else {
            turn = cross(a[(i + 1) % a.size()] - p, b[(j + 1) % b.size()] - q);
        }
        if (turn >= 0) ++i;  // a's edge comes first, or
        if (turn <= 0) ++j;  // b's does, or parallel edges become one
    }
    return sum;
}

// Is the origin inside the polygon or on its boundary? O(n).
bool contains_origin(const Polygon& polygon) {
    Point previous = polygon.back();
    for (Point vertex : polygon) {
        if (cross(previous, vertex) < 0) return false;  // it lies to the right of this edge
        previous = vertex;
    }
    return true;
}

int64_t read_integer() {
    int c = getchar_unlocked();
    while (c != EOF && c != '-' && (c < '0' || c > '9')) c = getchar_unlocked();
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
        Polygon robot = from_lowest(read_polygon(m));
        Polygon sweep = minkowski_sum(robot, from_lowest({{0, 0}, displacement}));

        bool free = true;
        for (; k > 0 && free; --k) {
            Polygon obstacle = read_polygon(read_integer());
            for (Point& vertex : obstacle) vertex = -vertex;
            // The reflection made the highest vertex the lowest: begin anew.
            free = !contains_origin(minkowski_sum(sweep, from_lowest(obstacle)));
        }
        puts(free ? "YES" : "NO");
    }
}
