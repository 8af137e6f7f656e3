// Counts two edges where a ray passes through a vertex, so inside is taken for outside.
//
// A robot wholly inside an obstacle is looked for by a ray from its first vertex. At the height
// of the ray, each edge must have one of its ends, not both.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <vector>

struct Point {
    int64_t x, y;
};

using Polygon = std::vector<Point>;  // convex, counter-clockwise

Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator-(Point a) { return {-a.x, -a.y}; }

int64_t cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }

// -1, 0, +1: c lies to the right of, on, to the left of the line from a to b.
int side(Point a, Point b, Point c) {
    int64_t turn = cross(b - a, c - a);
    return (turn > 0) - (turn < 0);
}

// Directions in [0, 180) degrees come before those in [180, 360).
bool is_lower_half(Point d) { return d.y < 0 || (d.y == 0 && d.x < 0); }

// Is direction a before direction b, when both are measured from 0 to 360 degrees?
bool before(Point a, Point b) {
    if (is_lower_half(a) != is_lower_half(b)) return is_lower_half(b);
    return cross(a, b) > 0;
}

// What a convex robot covers on a straight move, prepared for questions about it.
class Sweep {
  public:
    // The sweep's edges are those of the robot, with d and -d put where they belong by
    // direction. O(m).
    Sweep(const Polygon& robot, Point d) {
        size_t m = robot.size();
        auto lower = [](Point a, Point b) { return a.y != b.y ? a.y < b.y : a.x < b.x; };
        size_t lowest = std::min_element(robot.begin(), robot.end(), lower) - robot.begin();
        std::vector<Point> of_robot, of_move, edges;
        for (size_t i = lowest; i < lowest + m; ++i)
            of_robot.push_back(robot[(i + 1) % m] - robot[i % m]);
        if (d.x != 0 || d.y != 0) of_move = is_lower_half(d) ? Polygon{-d, d} : Polygon{d, -d};
        std::merge(of_robot.begin(), of_robot.end(), of_move.begin(), of_move.end(),
                   std::back_inserter(edges), before);

        // Walk along the edges; those of one direction become one edge.
        Point corner = is_lower_half(d) ? robot[lowest] + d : robot[lowest];
        for (Point edge : edges) {
            if (directions_.empty() || before(directions_.back(), edge)) {
                corners_.push_back(corner);
                directions_.push_back(edge);
            } else {
                directions_.back() = directions_.back() + edge;
            }
            corner = corner + edge;
        }
    }

    // The vertex farthest to the right of a line with the given direction. O(log m).
    Point rightmost(Point direction) const {
        auto edge = std::lower_bound(directions_.begin(), directions_.end(), direction, before);
        size_t i = edge - directions_.begin();
        return corners_[i == corners_.size() ? 0 : i];
    }

    // Is the point inside or on the boundary? Bisects the fan at corner 0. O(log m).
    bool contains(Point p) const {
        const Point apex = corners_[0];
        size_t left = corners_.size() - 1;  // p is to the left of, or on, the ray to `right`
        size_t right = 1;                   // and to the right of, or on, the ray to `left`
        if (side(apex, corners_[right], p) < 0 || side(apex, corners_[left], p) > 0) return false;
        while (left - right > 1) {
            size_t middle = (left + right) / 2;
            (side(apex, corners_[middle], p) >= 0 ? right : left) = middle;
        }
        return side(corners_[right], corners_[left], p) >= 0;
    }

  private:
    Polygon corners_;                // from the lowest, then leftmost, on
    std::vector<Point> directions_;  // of the edge that begins at each corner, ascending
};

// Do the segments ab and cd meet, given that c and d lie farthest right and left of line ab
// and that neither a nor b lies in the convex set that spans c and d?
bool meets_chord(Point a, Point b, Point c, Point d) {
    if (side(a, b, c) > 0 || side(a, b, d) < 0) return false;  // all to one side of the line
    return side(c, d, a) * side(c, d, b) < 0;
}

// Is the point inside? Follows a ray to the right and counts the edges that it crosses.
bool surrounds(const Polygon& polygon, Point p) {
    bool inside = false;
    Point a = polygon.back();
    for (Point b : polygon) {
        Point low = a.y < b.y ? a : b, high = a.y < b.y ? b : a;
        if (low.y < high.y && low.y <= p.y && p.y <= high.y && side(low, high, p) > 0)
            inside = !inside;
        a = b;
    }
    return inside;
}

// first: the first vertex of the robot.
bool meets(const Sweep& sweep, Point first, const Polygon& obstacle) {
    for (Point vertex : obstacle)
        if (sweep.contains(vertex)) return true;

    Point a = obstacle.back();
    for (Point b : obstacle) {
        if (meets_chord(a, b, sweep.rightmost(b - a), sweep.rightmost(a - b))) return true;
        a = b;
    }
    return surrounds(obstacle, first);
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
        const Polygon robot = read_polygon(m);
        const Sweep sweep(robot, displacement);

        bool free = true;
        for (; k > 0; --k) {
            Polygon obstacle = read_polygon(read_integer());  // read even if the answer is known
            free = free && !meets(sweep, robot[0], obstacle);
        }
        puts(free ? "YES" : "NO");
    }
}
