// Collision Course. Reads everything; the answer is still to be found.

#include <cstdint>
#include <iostream>
#include <vector>

struct Point {
    int64_t x, y;
};

using Polygon = std::vector<Point>;  // convex, counter-clockwise

// Can the robot make the whole move without touching any obstacle?
bool is_free(const Polygon& robot, Point move, const std::vector<Polygon>& obstacles) {
    (void)robot, (void)move, (void)obstacles;
    return true;
}

Point read_point() {
    Point point;
    std::cin >> point.x >> point.y;
    return point;
}

Polygon read_polygon(int vertices) {
    Polygon polygon;
    for (int i = 0; i < vertices; ++i) polygon.push_back(read_point());
    return polygon;
}

int main() {
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    int scenarios;
    std::cin >> scenarios;
    while (scenarios-- > 0) {
        int m, k;
        std::cin >> m >> k;
        Point move = read_point();
        Polygon robot = read_polygon(m);
        std::vector<Polygon> obstacles;
        for (int i = 0; i < k; ++i) {
            int n;
            std::cin >> n;
            obstacles.push_back(read_polygon(n));
        }
        std::cout << (is_free(robot, move, obstacles) ? "YES\n" : "NO\n");
    }
}
