// The naive way with a uniform grid: only segments that share a cell are compared.
//
// The grid has about as many cells as there are edges in it, and spans the whole scene: once
// for the edges of all obstacles, against the robot's edges and trails, and once for the
// robot's edges, against the trails of the obstacles. Where small polygons of many
// vertices make long moves, everything lies in a few cells: still O(m * n).

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

class Grid {
  public:
    // An empty grid over a box, with about so many cells, as square as the box.
    Grid(const Box& box, size_t cells) : origin_(box.low) {
        while (side_ * side_ < cells) ++side_;
        width_ = (box.high.x - box.low.x) / side_ + 1;
        height_ = (box.high.y - box.low.y) / side_ + 1;
        cells_.resize(side_ * side_);
    }

    void add(const Segment& segment) {
        visit(segment, [&](std::vector<Segment>& cell) {
            cell.push_back(segment);
            return false;
        });
    }

    bool meets(const Segment& segment) {
        const Box box = box_of(segment);
        return visit(segment, [&](const std::vector<Segment>& cell) {
            for (const Segment& other : cell)
                if (::meet(box, box_of(other)) && ::meet(segment, other)) return true;
            return false;
        });
    }

  private:
    // Calls a function for every cell that the segment may enter, until one returns true.
    template <typename Function>
    bool visit(const Segment& s, Function function) {
        const auto [low, high] = box_of(s);
        const int64_t first_row = row(low.y), last_row = row(high.y);
        for (int64_t r = first_row; r <= last_row; ++r) {
            // The segment between the heights at which this row begins and ends. Rounding is
            // far less than a cell; one more cell on either side makes up for it.
            int64_t from = column(low.x), to = column(high.x);
            if (first_row != last_row) {
                const double bottom = std::max<int64_t>(low.y, origin_.y + r * height_);
                const double top = std::min<int64_t>(high.y, origin_.y + (r + 1) * height_);
                const double slope = double(s.b.x - s.a.x) / double(s.b.y - s.a.y);
                const double x0 = s.a.x + slope * (bottom - s.a.y);
                const double x1 = s.a.x + slope * (top - s.a.y);
                from = std::max(from, column(std::min(x0, x1)) - 1);
                to = std::min(to, column(std::max(x0, x1)) + 1);
            }
            for (int64_t c = from; c <= to; ++c)
                if (function(cells_[r * side_ + c])) return true;
        }
        return false;
    }

    int64_t column(int64_t x) const {
        return std::clamp<int64_t>((x - origin_.x) / width_, 0, side_ - 1);
    }
    int64_t row(int64_t y) const {
        return std::clamp<int64_t>((y - origin_.y) / height_, 0, side_ - 1);
    }

    Point origin_;
    size_t side_ = 1;
    int64_t width_, height_;  // of a cell
    std::vector<std::vector<Segment>> cells_;
};

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

bool some_meet(const std::vector<Segment>& segments, Grid& grid) {
    for (const Segment& segment : segments)
        if (grid.meets(segment)) return true;
    return false;
}

bool collide(const Polygon& robot, const std::vector<Polygon>& obstacles, Point d) {
    std::vector<Segment> all = trails(robot, d), walls, back;
    const Box sweep = box_of(all);
    for (const Polygon& obstacle : obstacles) {
        if (!meet(box_of(edges(obstacle)), sweep)) continue;
        if (contains(obstacle, robot[0]) || contains(robot, obstacle[0])) return true;
        for (const Segment& edge : edges(obstacle)) walls.push_back(edge);
        for (const Segment& trail : trails(obstacle, Point{0, 0} - d)) back.push_back(trail);
    }
    all.insert(all.end(), walls.begin(), walls.end());
    all.insert(all.end(), back.begin(), back.end());
    const Box scene = box_of(all);
    Grid of_walls(scene, walls.size()), of_robot(scene, robot.size());
    for (const Segment& edge : walls) of_walls.add(edge);
    for (const Segment& edge : edges(robot)) of_robot.add(edge);
    return some_meet(edges(robot), of_walls) || some_meet(trails(robot, d), of_walls) ||
           some_meet(back, of_robot);
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
