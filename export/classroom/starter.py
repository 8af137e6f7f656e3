"""Collision Course. Reads everything; the answer is still to be found."""

import sys

Point = tuple[int, int]
Polygon = list[Point]  # convex, counter-clockwise


def free(robot: Polygon, move: Point, obstacles: list[Polygon]) -> bool:
    """Tell whether the robot can make the whole move without touching any obstacle."""
    return True


def main() -> None:
    """Answer every scenario."""
    numbers = iter(map(int, sys.stdin.buffer.read().split()))

    def polygon(vertices: int) -> Polygon:
        return [(next(numbers), next(numbers)) for _ in range(vertices)]

    answers = []
    for _ in range(next(numbers)):
        m, k = next(numbers), next(numbers)
        move = next(numbers), next(numbers)
        robot = polygon(m)
        obstacles = [polygon(next(numbers)) for _ in range(k)]
        answers.append("YES" if free(robot, move, obstacles) else "NO")
    print("\n".join(answers))


if __name__ == "__main__":
    main()
