"""Why an answer is YES or NO, in one exact sentence."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt, sqrt

from gen.geometry import Point
from gen.scenario import Scenario
from pictures.exact.meeting import ExactPoint, Feature
from pictures.moment import Approach, Contact, Kind, decisive

EXACT_CHARS = 9  # a longer fraction is shown as a decimal; whole numbers are exact
DIGITS = 3  # significant ones of a distance


def sentence(scenario: Scenario) -> str:
    """Return one English sentence that says why the answer is YES or NO. Exact; see `decisive`.

    Obstacles are counted from 1. The robot's corners are named by where they are at the start.

    >>> sentence(Scenario([(0, 0), (1, 0), (0, 1)], (0, 0), [[(1, 0), (5, 0), (5, 9)]]))
    'The robot does not move, and its corner (1, 0) touches the corner (1, 0) of obstacle 1.'
    """
    return tell(scenario, decisive(scenario))


def tell(scenario: Scenario, moment: Contact | Approach | None) -> str:
    """Return the sentence of a scenario whose decisive moment is known already."""
    if moment is None:
        return "There are no obstacles, so the robot can touch nothing."
    if isinstance(moment, Contact):
        return _contact(scenario, moment)
    return _approach(scenario, moment)


def _contact(scenario: Scenario, contact: Contact) -> str:
    name = f"obstacle {contact.obstacle + 1}"
    robot, feature = part(contact.robot), part(contact.feature)
    match contact.kind:
        case Kind.ROBOT_INSIDE if {*scenario.robot} == {*scenario.obstacles[contact.obstacle]}:
            return f"The robot stands exactly where {name} is, from the start."
        case Kind.ROBOT_INSIDE:
            return f"The robot stands inside {name} from the start."
        case Kind.OBSTACLE_INSIDE:
            return f"{name.capitalize()} is inside the robot from the start."
        case Kind.OVERLAP if not contact.feature:
            return f"The robot's {robot} is inside {name} from the start."
        case Kind.OVERLAP if not contact.robot:
            return f"The {feature} of {name} is inside the robot from the start."
        case Kind.OVERLAP:
            point = place(contact.point)
            return (
                f"The robot's {robot} crosses the {feature} of {name} from the start, at {point}."
            )
    its = f"the {feature} of {name}"
    if contact.kind is Kind.CORNER_EDGE:
        its += f", at the point {place(contact.point)}"
    if contact.kind is Kind.EDGE_EDGE:
        first, last = shared_by_edges(scenario, contact)
        its += f", all along from {place(first)} to {place(last)}"
    if scenario.move == (0, 0):
        return f"The robot does not move, and its {robot} touches {its}."
    if contact.time > 0:
        robot = part(contact.robot, "that started at ")
    return f"{_when(contact.time)}, the robot's {robot} touches {its}."


def shared_by_edges(scenario: Scenario, contact: Contact) -> tuple[ExactPoint, ExactPoint]:
    """Return the ends of what two edges in contact share, which lie on one line."""
    dx, dy = scenario.move
    moved = [(x + contact.time * dx, y + contact.time * dy) for x, y in contact.robot]
    fixed = [(Fraction(x), Fraction(y)) for x, y in contact.feature]
    _, first, last, _ = sorted([*moved, *fixed])
    return first, last


def _approach(scenario: Scenario, approach: Approach) -> str:
    name, how_far = f"obstacle {approach.obstacle + 1}", distance(approach.squared)
    its = f"the {part(approach.feature)} of {name}"
    if scenario.move == (0, 0):
        nearest = "" if len(scenario.obstacles) == 1 else f" {name} is nearest, and"
        return f"No contact:{nearest} the robot's {part(approach.robot)} is {how_far} from {its}."
    robot = part(approach.robot)
    if approach.time > 0 and len(approach.robot) == 1:
        robot += f", then at {place(approach.robot_point)},"
    when = _when(approach.time)
    when = when[0].lower() + when[1:]
    return (
        f"No contact: the robot comes closest to {name} {when}, where its {robot} is {how_far} "
        f"from the {part(approach.feature)}."
    )


def _when(time: Fraction) -> str:
    if time == 0:
        return "At the start of the move (t = 0)"
    if time == 1:
        return "At the end of the move (t = 1)"
    return f"At t {equals(time)} of the move"


def part(feature: Feature, before: str = "") -> str:
    """Return `corner (1, 2)` or `edge (1, 2)–(3, 4)`, with some words before the places."""
    name = "corner" if len(feature) == 1 else "edge"
    return f"{name} {before}{'–'.join(map(place, feature))}"


def place(point: Point | ExactPoint) -> str:
    """Return a point as `(5, 7/2)`; with long fractions as rounded decimals, `≈ (0.6667, 2)`."""
    x, y = (shown(Fraction(c)) for c in point)
    rounded = any(c.startswith("≈") for c in (x, y))
    return f"{'≈ ' if rounded else ''}({x.removeprefix('≈ ')}, {y.removeprefix('≈ ')})"


def equals(value: Fraction) -> str:
    """Return `= 2/3`, or `≈ 0.802` where the fraction is long."""
    text = shown(value)
    return text if text.startswith("≈") else f"= {text}"


def shown(value: Fraction) -> str:
    """Return a fraction as it is if it is short, else a rounded decimal that is marked.

    >>> shown(Fraction(7, 2)), shown(Fraction(123456789012345678, 987654321))
    ('7/2', '≈ 124999998.8734')
    """
    exact = str(value)
    if value.denominator == 1 or len(exact) <= EXACT_CHARS:
        return exact
    return f"≈ {float(value):.4f}".rstrip("0").removesuffix(".")


def distance(squared: Fraction) -> str:
    """Return the root of a fraction, exact and rounded.

    >>> distance(Fraction(1, 5)), distance(Fraction(25, 4))
    ('1/√5 ≈ 0.447', '5/2')
    """
    top, bottom = squared.as_integer_ratio()
    top_root, bottom_root = isqrt(top), isqrt(bottom)
    top_is_square = top_root * top_root == top
    bottom_is_square = bottom_root * bottom_root == bottom
    above = str(top_root) if top_is_square else f"√{top}"
    below = str(bottom_root) if bottom_is_square else f"√{bottom}"
    exact = above if bottom == 1 else f"{above}/{below}"
    if not top_is_square and not bottom_is_square:
        exact = f"√({squared})"
    if top_is_square and bottom_is_square:
        return exact
    return f"{exact} ≈ {approximate_root(squared)}"


def approximate_root(squared: Fraction) -> str:
    """Return the root of a fraction, rounded.

    >>> approximate_root(Fraction(1, 5)), approximate_root(Fraction(1, 10**17))
    ('0.447', '3.16e-9')
    >>> approximate_root(Fraction(2 * 10**12))
    '1,414,214'
    """
    root = sqrt(squared)  # rounded anyway
    return f"{root:,.0f}" if root >= 1000 else f"{root:.{DIGITS}g}".replace("e-0", "e-")
