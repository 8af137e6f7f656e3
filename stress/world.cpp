// Complete small worlds, part by part: world ROBOT OBSTACLE REACH [FROM COUNT]
//
// Prints an input file with the scenarios FROM, ..., FROM + COUNT - 1 of one world; with
// three arguments, only how many there are. The scenarios of a world, each just once:
//
//   robot      every strictly convex polygon whose vertices fit a ROBOT x ROBOT grid of
//              points, up to translation, rotation by 90 degrees and reflection;
//   obstacle   every one of the OBSTACLE x OBSTACLE grid, up to translation;
//   move       every (dx, dy) with |dx|, |dy| <= REACH;
//   place      every one at which the boxes of sweep and obstacle share a point: at any
//              other the answer is YES, and no method has anything to decide.
//
// A symmetry of the grid, the same for the whole scenario, and the vertices that polygons
// begin with change with a scenario's number, so that all of them occur.
// Time: O(pairs of polygons) to find FROM, then linear in what is printed.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

using Point = std::pair<int, int>;
using Polygon = std::vector<Point>;

struct Shape {
    Polygon ring;  // counter-clockwise, pushed to the axes
    int width, height;
};

long long cross(Point a, Point b, Point c) {
    return 1LL * (b.first - a.first) * (c.second - a.second) -
           1LL * (b.second - a.second) * (c.first - a.first);
}

// The strictly convex hull, counter-clockwise (Andrew's monotone chain).
Polygon hull(Polygon points) {
    std::sort(points.begin(), points.end());
    Polygon ring;
    for (int pass = 0; pass < 2; pass++) {
        size_t start = ring.size();
        for (Point p : points) {
            while (ring.size() >= start + 2 && cross(ring[ring.size() - 2], ring.back(), p) <= 0)
                ring.pop_back();
            ring.push_back(p);
        }
        ring.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return ring;
}

// One of the eight symmetries of the square grid; odd numbers of reflections turn the sense.
Point turned(Point p, int symmetry) {
    if (symmetry & 1) p.first = -p.first;
    if (symmetry & 2) p.second = -p.second;
    if (symmetry & 4) std::swap(p.first, p.second);
    return p;
}

bool turns_sense(int symmetry) { return (symmetry ^ symmetry >> 1 ^ symmetry >> 2) & 1; }

// The vertices in order, pushed to the axes: equal for translated polygons only.
Polygon pushed(Polygon points) {
    int left = points[0].first, low = points[0].second;
    for (Point p : points) left = std::min(left, p.first), low = std::min(low, p.second);
    for (Point &p : points) p.first -= left, p.second -= low;
    std::sort(points.begin(), points.end());
    return points;
}

bool is_least_of_its_images(const Polygon &ring) {
    Polygon own = pushed(ring);
    for (int symmetry = 1; symmetry < 8; symmetry++) {
        Polygon image = ring;
        for (Point &p : image) p = turned(p, symmetry);
        if (pushed(image) < own) return false;
    }
    return true;
}

// All shapes on a side x side grid, by trying every set of grid points.
std::vector<Shape> shapes(int side, bool up_to_symmetry) {
    std::vector<Shape> found;
    for (int set = 1; set < 1 << side * side; set++) {
        Polygon points;
        int left = side, low = side, width = 0, height = 0;
        for (int i = 0; i < side * side; i++) {
            if (!(set >> i & 1)) continue;
            Point p(i / side, i % side);
            points.push_back(p);
            left = std::min(left, p.first), width = std::max(width, p.first);
            low = std::min(low, p.second), height = std::max(height, p.second);
        }
        if (points.size() < 3 || left || low) continue;
        Polygon ring = hull(points);
        if (ring.size() != points.size()) continue;
        if (!up_to_symmetry || is_least_of_its_images(ring)) found.push_back({ring, width, height});
    }
    return found;
}

std::string out;

void print(int number) { out += std::to_string(number); }

void print(Point p) {
    print(p.first), out += ' ', print(p.second), out += '\n';
}

// Print a polygon moved by `at`, in a dress, beginning with vertex `first` (modulo n).
void print(const Polygon &ring, Point at, int symmetry, long long first) {
    int n = ring.size();
    bool backwards = turns_sense(symmetry);
    for (int i = 0; i < n; i++) {
        Point p = ring[(first + (backwards ? n - i : i)) % n];
        print(turned({p.first + at.first, p.second + at.second}, symmetry));
    }
}

void print_scenario(const Shape &robot, const Shape &obstacle, Point move, Point at, long long id) {
    int symmetry = id % 8;
    print(robot.ring.size()), out += " 1\n";
    print(turned(move, symmetry));
    print(robot.ring, {0, 0}, symmetry, id / 3);
    print(obstacle.ring.size()), out += '\n';
    print(obstacle.ring, at, symmetry, id / 7);
}

// How many places along one axis there are, over all moves.
long long places(int robot, int obstacle, int reach) {
    return (2LL * reach + 1) * (robot + obstacle + 1) + 1LL * reach * (reach + 1);
}

int main(int count, char **arguments) {
    if (count != 4 && count != 6) {
        std::fputs("usage: world ROBOT OBSTACLE REACH [FROM COUNT]\n", stderr);
        return 2;
    }
    int robot_side = std::atoi(arguments[1]), obstacle_side = std::atoi(arguments[2]);
    int reach = std::atoi(arguments[3]);
    if (std::min(robot_side, obstacle_side) < 2 || std::max(robot_side, obstacle_side) > 4) {
        std::fputs("world: expected grids of 2 to 4 points a side\n", stderr);
        return 2;
    }
    bool only_count = count == 4;
    long long from = only_count ? 0 : std::atoll(arguments[4]);
    long long to = only_count ? 0 : from + std::atoll(arguments[5]);
    long long id = 0;
    if (!only_count) out = std::to_string(to - from) + "\n";
    std::vector<Shape> obstacles = shapes(obstacle_side, false);
    for (const Shape &robot : shapes(robot_side, true))
        for (const Shape &obstacle : obstacles) {
            long long own = places(robot.width, obstacle.width, reach) *
                            places(robot.height, obstacle.height, reach);
            if (id + own <= from || id >= to) {
                id += own;
                continue;
            }
            for (int dx = -reach; dx <= reach; dx++)
                for (int dy = -reach; dy <= reach; dy++)
                    for (int x = std::min(dx, 0) - obstacle.width;
                         x <= std::max(dx, 0) + robot.width; x++)
                        for (int y = std::min(dy, 0) - obstacle.height;
                             y <= std::max(dy, 0) + robot.height; y++, id++)
                            if (from <= id && id < to)
                                print_scenario(robot, obstacle, {dx, dy}, {x, y}, id);
        }
    if (only_count) out = std::to_string(id) + "\n";
    std::fwrite(out.data(), 1, out.size(), stdout);
}
