"""What the reports for people say of a program that was too slow: facts, each in a sentence."""

from __future__ import annotations

from collections.abc import Iterator

from judge.explanation import Growth, Size, Slowness
from judge.kit.text import counted, printable_name

TITLE = "why it is too slow"
LESSON = "docs/editorial.md, part 4, shows how to do without it"
MANY_STEPS = 1_000_000_000  # more than a fast program makes within a time limit of seconds
FEW_STEPS = 10_000_000  # so few that a slow language makes them in seconds
MOST_TOLD = 3  # growths


def slow_sentences(slowness: Slowness) -> list[str]:
    """Return what is known, one sentence each: of the test case, then of how the time grows."""
    said = [] if slowness.size is None else [_shape(slowness.size), _steps(slowness.size)]
    return [printable_name(sentence) for sentence in (*said, *_measured(slowness.growths))]


def _shape(size: Size) -> str:
    """Say what the largest things in the test case are."""
    most = "up to " if size.scenarios > 1 else ""
    scenarios = f"{counted(size.scenarios, 'scenario')}, with " if size.scenarios > 1 else ""
    robots = "robots of up to" if size.scenarios > 1 else "a robot of"
    found = f"{scenarios}{robots} {size.robot:,} vertices"
    found += f" and {most}{counted(size.obstacles, 'obstacle')}"
    if size.obstacles:
        found += f" of up to {size.obstacle:,} vertices"
    family = f" (family {size.family})" if size.family else ""
    promise = f"; the promise of its group: {size.promise.replace('`', '')}" if size.promise else ""
    return f"{size.case}{family} has {found}{promise}."


def _steps(size: Size) -> str:
    """Say how many steps two usual methods take for the test case."""
    walk = "One walk around the robot for each obstacle"
    compare = "To compare each edge of the robot with each edge of each obstacle"
    if size.walks > MANY_STEPS:
        return f"{walk} takes {size.walks:,} steps here: {LESSON}."
    if size.pairs > FEW_STEPS:
        return f"{compare} takes {size.pairs:,} steps here; {walk.lower()} takes {size.walks:,}."
    return (
        f"{compare} takes only {size.pairs:,} steps here: look for what takes more, or never ends."
    )


def _measured(growths: tuple[Growth, ...]) -> Iterator[str]:
    """Say what was measured: what grows too fast, or that nothing does."""
    if not growths:
        return
    told = [growth for growth in growths if growth.too_fast][:MOST_TOLD]
    for growth in told:
        yield (
            f"Its time grows like N^{growth.exponent:.1f}, where N is {growth.quantity}: "
            f"{_times(growth)}; aim at {_aim(growth)}."
        )
    if told:
        return
    stuck = [growth for growth in growths if growth.over is not None and growth.exponent is None]
    for growth in stuck[:1]:
        known = f" ({_times(growth)})" if growth.sizes else ""
        yield (
            f"It is too slow to be measured at N = {growth.over:,}, where N is {growth.quantity}"
            f"{known}."
        )
    measured = [growth for growth in growths if growth.sizes]
    if stuck or not measured:
        return
    slowest = max(measured, key=lambda growth: growth.cpu_s[-1])
    yield (
        "In what was measured, no quantity makes its time grow faster than it may. The longest "
        f"time: {_times(slowest, last=True)}, where N is {slowest.quantity}."
    )


def _times(growth: Growth, *, last: bool = False) -> str:
    """Return the times of a growth: `0.12 s at 1,000, 0.47 s at 2,000`."""
    points = list(zip(growth.sizes, growth.cpu_s, strict=True))
    return ", ".join(
        f"{seconds:.2f} s at {size:,}" for size, seconds in points[-1 if last else 0 :]
    )


def _aim(growth: Growth) -> str:
    return f"about N^{growth.may:g}" if growth.may else "a time that does not depend on N"
