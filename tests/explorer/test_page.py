"""The page as a person uses it: pointer, keys, touch, files, links, and a screen reader's names."""

import json

import pytest

from explorer.cli import PAGE
from gen.families.registry import find
from gen.geometry import is_strictly_convex
from gen.rng import Rng
from gen.scenario import Scenario, parse, render

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
FREE = Scenario(SQUARE, (10, 0), [[(8, 6), (12, 6), (10, 9)]])
HIT = Scenario(SQUARE, (10, 0), [[(8, 3), (12, 3), (10, 9)]])


def link(scenario):
    text = render([scenario]).decode().partition("\n")[2]
    return "#scene=" + text.strip().replace(" ", ",").replace("\n", "/")


def scene(page):
    """Return what the page holds now, as a Scenario."""
    held = json.loads(page.evaluate("JSON.stringify(window.collisionCourse.scene)"))
    robot, *obstacles = (
        [tuple(vertex) for vertex in polygon] for polygon in (held["robot"], *held["obstacles"])
    )
    return Scenario(robot, tuple(held["move"]), obstacles)


def answer(page):
    settle(page)
    return page.text_content("#answer")


def settle(page):
    """Wait until what changed is drawn."""
    page.evaluate("() => new Promise((done) => requestAnimationFrame(() => setTimeout(done)))")


def handle(page, part):
    """Return the middle of a handle, in pixels of the window."""
    settle(page)
    box = page.locator(f'circle[data-part="{part}"]').bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def unit_px(page):
    """Return how many pixels a unit has: from the robot's first edge, which is 4 long."""
    (x0, _), (x1, _) = handle(page, "robot 0 0"), handle(page, "robot 0 1")
    return (x1 - x0) / 4


def drag(page, start, by):
    """Drag with the mouse from a pixel by (right, up) units."""
    unit = unit_px(page)
    x, y = start
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + by[0] * unit / 2, y - by[1] * unit / 2)
    page.mouse.move(x + by[0] * unit, y - by[1] * unit)
    page.mouse.up()
    settle(page)


def test_it_opens_with_a_scene_and_says_why(opened):
    page = opened()
    assert answer(page) == "NO"
    assert "10/27 of the move" in page.text_content("#reason")
    assert page.locator("#scene path.obstacle").count() == 2
    assert page.locator("#difference path.edge").count() >= 2
    assert page.evaluate("document.documentElement.scrollWidth") <= 1280


def test_every_scene_of_the_page_has_its_answer(opened):
    page = opened()
    held = json.loads(page.text_content("#data"))
    scenes = held["scenes"]
    assert len(scenes) >= 8
    text = f"{len(scenes)}\n{''.join(entry['input'] for entry in scenes)}"
    found = page.evaluate("text => window.collisionCourse.answers(text)", text)
    assert found == [entry["answer"] for entry in scenes]
    for entry in scenes[::12]:
        page.select_option("#scenes", entry["name"])
        assert answer(page) == entry["answer"], entry["name"]
        assert page.text_content("#lesson") == held["sentences"][entry["sentence"]]
        page.wait_for_url(f"**#gallery={entry['name']}")


def test_a_gallery_scene_opens_by_its_link(opened):
    page = opened("#gallery=03-touch-1")
    assert answer(page) == "NO"
    assert "They only touch" in page.text_content("#reason")
    page.evaluate("location.hash = '#gallery=03-touch-2'")
    page.locator("#answer", has_text="YES").wait_for()
    page.locator("#next").click()
    page.locator("#lesson", has_text="notch").wait_for()


def test_the_robot_is_dragged_and_the_answer_follows(opened):
    page = opened(link(FREE))
    assert answer(page) == "YES"
    unit = unit_px(page)
    x, y = handle(page, "robot 0 0")
    drag(page, (x + unit, y - unit), (0, 3))
    assert scene(page).robot == [(x, y + 3) for x, y in SQUARE]
    assert answer(page) == "NO"
    page.locator("#undo").click()
    assert answer(page) == "YES"
    assert scene(page) == FREE


def test_the_end_of_the_move_is_dragged(opened):
    page = opened(link(HIT))
    assert answer(page) == "NO"
    drag(page, handle(page, "end 0 all"), (-8, -5))
    assert scene(page).move == (2, -5)
    assert answer(page) == "YES"


@pytest.mark.slow  # the robot and the end of the move are dragged in fast tests
def test_an_obstacle_and_its_corner_are_dragged(opened):
    page = opened(link(FREE))
    (x0, y0), (x1, _) = handle(page, "obstacle 0 0"), handle(page, "obstacle 0 1")
    drag(page, ((x0 + x1) / 2, y0 - unit_px(page)), (1, 1))
    assert scene(page).obstacles == [[(9, 7), (13, 7), (11, 10)]]
    drag(page, handle(page, "obstacle 0 2"), (2, -1))
    assert scene(page).obstacles == [[(9, 7), (13, 7), (13, 9)]]


@pytest.mark.slow  # other drags are fast tests
def test_a_corner_stays_where_the_polygon_is_convex(opened):
    page = opened(link(HIT))
    for by in ((9, 3), (2, 9), (-3, -3), (0, 5), (-9, 7), (3, -8)):
        drag(page, handle(page, "robot 0 0"), by)
        robot = scene(page).robot
        assert is_strictly_convex(robot)
        assert robot[0] != SQUARE[0]
        assert robot[1:] == SQUARE[1:]
        page.locator("#undo").click()
        assert scene(page) == HIT


@pytest.mark.slow  # other drags are fast tests
def test_of_coinciding_corners_the_selected_polygons_is_dragged(opened):
    page = opened(link(Scenario(SQUARE, (9, 0), [[(4, 4), (9, 4), (9, 9)]])))
    page.locator('path[data-part="robot 0 all"]').focus()
    drag(page, handle(page, "obstacle 0 0"), (-1, 0))
    assert scene(page).robot == [(0, 0), (4, 0), (3, 4), (0, 4)]
    page.locator('path[data-part="obstacle 0 all"]').focus()
    drag(page, handle(page, "obstacle 0 0"), (-1, 0))
    assert scene(page).obstacles == [[(3, 4), (9, 4), (9, 9)]]


def test_keys_move_what_is_focused(opened):
    page = opened(link(FREE))
    corner = page.locator('circle[data-part="obstacle 0 2"]')
    corner.focus()
    page.keyboard.press("ArrowUp")
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Shift+ArrowUp")
    settle(page)
    assert scene(page).obstacles[0][2] == (11, 20)
    name = page.evaluate("document.activeElement.getAttribute('aria-label')")
    assert name == "Obstacle 1, corner 3 of 3, at (11, 20)"
    page.keyboard.press("Control+z")
    settle(page)
    assert scene(page).obstacles[0][2] == (11, 10)
    page.locator('path[data-part="end 0 all"]').focus()
    page.keyboard.press("ArrowLeft")
    settle(page)
    assert scene(page).move == (9, 0)


def test_a_key_that_would_break_the_polygon_is_refused_in_words(opened):
    page = opened(link(Scenario([(0, 0), (1, 0), (0, 1)], (0, 0), [])))
    page.locator('circle[data-part="robot 0 0"]').focus()
    page.keyboard.press("ArrowUp")
    assert "not be convex" in page.text_content("#message")
    assert scene(page).robot == [(0, 0), (1, 0), (0, 1)]


def test_tab_reaches_every_part_and_every_part_has_a_name(opened):
    page = opened(link(HIT))
    page.locator("#scene [data-part]").first.focus()
    seen = []
    for _ in range(10):
        seen.append(page.evaluate("document.activeElement.dataset.part"))
        page.keyboard.press("Tab")
    corners = [f"robot 0 {i}" for i in range(4)] + [f"obstacle 0 {i}" for i in range(3)]
    assert set(seen) == {"robot 0 all", "end 0 all", "obstacle 0 all", *corners}


def test_everything_that_can_be_focused_has_a_name(opened):
    page = opened()
    page.locator("#input summary").click()
    session = page.context.new_cdp_session(page)
    nodes = session.send("Accessibility.getFullAXTree")["nodes"]
    focusable = [
        node
        for node in nodes
        if any(p["name"] == "focusable" and p["value"]["value"] for p in node.get("properties", []))
        and node["role"]["value"] != "RootWebArea"
    ]
    assert len(focusable) > 30
    nameless = [node for node in focusable if not node.get("name", {}).get("value", "").strip()]
    assert nameless == []


def test_the_answer_is_spoken_when_the_scene_rests(opened):
    page = opened(link(FREE))
    page.locator("#spoken", has_text="YES. A line separates").wait_for(state="attached")
    assert page.get_attribute("#spoken", "aria-live") == "polite"


def test_corners_and_obstacles_are_added_and_removed(opened):
    page = opened(link(FREE))
    page.locator("#add-obstacle").click()
    settle(page)
    assert len(scene(page).obstacles) == 2
    page.locator("#add-corner").click()
    settle(page)
    assert [len(polygon) for polygon in scene(page).obstacles] == [3, 5]
    page.locator("#remove-corner").click()
    page.locator("#remove-obstacle").click()
    settle(page)
    assert scene(page).obstacles == FREE.obstacles
    page.locator("#remove-obstacle").click()
    assert answer(page) == "YES"
    assert page.text_content("#reason") == "There is no obstacle that could be touched."
    assert page.locator("#merge").is_hidden()
    for polygon in (scene(page).robot, *scene(page).obstacles):
        assert is_strictly_convex(polygon)


def test_the_slider_moves_the_robot(opened):
    page = opened(link(HIT))
    assert page.locator("#scene path.passing").count() == 0
    page.locator("#moment").fill("600")
    settle(page)
    assert page.text_content("#moment-text") == "after 0.6 of the move: touching"
    assert page.locator("#scene path.passing.hit").count() == 1
    page.locator("#first").click()
    settle(page)
    assert page.text_content("#moment-text") == "after 0.4 of the move: touching"
    page.locator("#moment").fill("399")
    settle(page)
    assert page.text_content("#moment-text") == "after 0.399 of the move: free"
    page.locator("#play").click()
    settle(page)
    assert page.text_content("#moment-text") == "at the end: touching"  # motion is reduced


@pytest.mark.slow  # the slider moves the robot in a fast test
def test_a_moment_that_is_no_decimal_is_exact(opened):
    page = opened("#gallery=02-sweep-1")
    page.locator("#first").click()
    settle(page)
    assert page.text_content("#moment-text") == "after 10/27 of the move: touching obstacle 1"


def test_the_merge_is_stepped_through(opened):
    page = opened(link(HIT))
    settle(page)
    assert page.text_content("#step-text").startswith(
        "Done: 3 + 4 edges were merged into 6; one pair"
    )
    page.locator("#step-first").click()
    texts = []
    for step in range(6):
        settle(page)
        assert page.text_content("#step-number") == f"{step} of 6"
        texts.append(page.text_content("#step-text"))
        assert page.locator("#row-sum .chip:not(.empty)").count() == step
        page.locator("#step-on").click()
    settle(page)
    assert page.locator("#step-on").is_disabled()
    assert sum("the same direction" in text for text in texts) == 1
    assert texts[0] == (
        "a₁ × b₁ = 4·0 − 0·14 = 0: the same direction, so both together make one edge."
    )
    assert texts[-1].startswith("A is used up: take b₄")


def test_the_separating_line_is_shown_when_there_is_one(opened):
    page = opened(link(FREE))
    settle(page)
    for board in ("#scene", "#difference"):
        assert page.locator(f"{board} line.separating").count() == 1
    assert "with a gap of 2." in page.text_content("#reason")
    page = opened(link(HIT))
    settle(page)
    assert page.locator("line.separating").count() == 0


TRIANGLE = [(6, 1), (9, 0), (9, 4)]  # its corner (6, 1) is its leftmost point


REASONS = [
    (
        Scenario(SQUARE, (10, 0), [TRIANGLE]),
        "After 1/5 of the move, the robot’s edge (4, 0)–(4, 4) meets the corner (6, 1) "
        "of the obstacle.",
    ),
    (
        Scenario([(0, 2), (2, 1), (2, 3)], (-9, 0), [[(-6, 0), (-3, 0), (-3, 9), (-6, 9)]]),
        "After 1/3 of the move, the robot’s corner (0, 2) meets the edge (-3, 0)–(-3, 9) "
        "of the obstacle.",
    ),
    (
        Scenario(SQUARE, (3, 3), [[(7, 7), (9, 7), (9, 9)]]),
        "At the very end of the move, the robot’s corner (4, 4) meets the corner (7, 7) "
        "of the obstacle. They only touch; that is a collision, too.",
    ),
    (
        Scenario(SQUARE, (0, 0), [[(4, 1), (9, 1), (4, 3)], TRIANGLE]),
        "At the start, the robot’s edge (4, 0)–(4, 4) meets the edge (4, 3)–(4, 1) "
        "of obstacle 1. They only touch; that is a collision, too.",
    ),
    (
        Scenario([(1, 1), (2, 1), (1, 2)], (7, 0), [SQUARE]),
        "The robot starts inside the obstacle.",
    ),
    (
        Scenario(SQUARE, (7, 0), [TRIANGLE, [(1, 1), (2, 1), (1, 2)]]),
        "Obstacle 2 lies inside the robot at the start.",
    ),
    (
        Scenario(SQUARE, (7, 0), [[(3, 3), (9, 3), (9, 9)]]),
        "The robot and the obstacle overlap at the start.",
    ),
    (
        Scenario(SQUARE, (-2, -1), [TRIANGLE]),
        "A line separates the obstacle from all that the robot covers, with a gap of 2.",
    ),
    (
        Scenario(SQUARE, (-2, -2), [[(5, 5), (7, 4), (7, 7)], [(90, 90), (99, 90), (90, 99)]]),
        "A line separates each of the 2 obstacles from all that the robot covers; "
        "for obstacle 1, with a gap of 3/√5 ≈ 1.34.",
    ),
]


def test_the_reason_is_exact(opened):
    page = opened()
    for scenario, expected in REASONS:
        page.evaluate("address => (location.hash = address)", link(scenario))
        page.locator("#reason", has_text=expected).wait_for()
        assert page.text_content("#reason") == expected


@pytest.mark.slow
def test_the_contact_and_the_gap_are_seen_closely(opened):
    far = 10**8
    robot = [(-far, -far), (far, -far), (far, far - 1)]
    obstacle = [(-far, -far + 1), (far - 1, far), (-far, far)]
    page = opened(link(Scenario(robot, (0, 0), [obstacle])))
    assert answer(page) == "YES"
    for button in page.locator("[data-zoom=near]").all():
        button.click()
    settle(page)
    labels = page.locator("#difference text.number").all_text_contents()
    assert {"−1", "0", "1"} <= set(labels)
    assert page.locator("#scene circle[data-part]").count() == 7


@pytest.mark.slow
def test_a_file_of_many_scenarios_is_opened(opened, tmp_path):
    scenarios = find("contacts").scenarios({}, 1)[:30]
    file = tmp_path / "my.in"
    file.write_bytes(render(scenarios))
    page = opened()
    page.set_input_files("#file", file)
    page.locator("#scenario-count", has_text="30").wait_for()
    assert scene(page) == scenarios[0]
    page.locator("#next").click()
    page.locator("#next").click()
    assert scene(page) == scenarios[2]
    page.locator("#scenario").fill("30")
    page.locator("#scenario").blur()
    assert scene(page) == scenarios[29]
    page.locator("#scenario").fill("31")
    page.locator("#scenario").blur()
    assert "There is no scenario 31; the file has 30." in page.text_content("#message")
    page.locator("#close").click()
    assert page.locator("#scenario-chooser").is_hidden()


def test_a_faulty_file_is_refused_with_its_line(opened, tmp_path):
    file = tmp_path / "bad.in"
    file.write_bytes(b"1\n3 0\n0 0\n0 0\n0 1\n1 0\n")
    page = opened(link(FREE))
    page.set_input_files("#file", file)
    page.locator("#message").wait_for()
    told = page.text_content("#message span")
    assert told == "bad.in, line 5: robot, vertex 2: clockwise turn (cross -1)"
    assert scene(page) == FREE


def large_polygon(n):
    """Return a strictly convex polygon with 2n vertices."""
    chain = [(i, i * (i - 1) // 2) for i in range(n)]
    x, y = chain[-1]
    return chain + [(x - a, y + 1 - b) for a, b in chain]


@pytest.mark.slow  # a faulty file is refused in a fast test
def test_a_scene_that_is_too_large_is_named_and_the_next_one_opens(opened, tmp_path):
    large = Scenario(large_polygon(3_000), (0, 0), [])
    file = tmp_path / "large.in"
    file.write_bytes(render([large, FREE]))
    page = opened(link(HIT))
    page.set_input_files("#file", file)
    page.locator("#message", has_text="Scenario 1 has 6,000 vertices").wait_for()
    assert "python -m pictures show large.in 1" in page.text_content("#message")
    page.locator("#next").click()
    assert scene(page) == FREE
    assert page.locator("#message").is_hidden()


def test_a_file_that_cannot_be_an_input_is_not_read(opened, tmp_path):
    file = tmp_path / "film.in"
    with file.open("wb") as stream:
        stream.truncate(20_000_000)
    page = opened()
    page.set_input_files("#file", file)
    page.locator("#message", has_text="film.in has 20,000,000 bytes").wait_for()


def test_a_large_scene_has_handles_only_where_it_is_selected(opened):
    page = opened(link(Scenario(large_polygon(40), (0, 0), [[(99, 0), (101, 0), (100, 2)]])))
    settle(page)
    assert page.locator("#scene circle[data-part]").count() == 1
    page.locator('path[data-part="obstacle 0 all"]').focus()
    settle(page)
    assert page.locator("#scene circle[data-part]").count() == 4


def test_the_scene_is_copied_as_input(opened):
    page = opened(link(HIT))
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.locator("#copy").click()
    page.locator("#message", has_text="copied").wait_for()
    copied = page.evaluate("navigator.clipboard.readText()")
    assert copied.encode() == render([HIT])


@pytest.mark.slow
def test_a_link_restores_the_scene(opened):
    page = opened(link(HIT))
    drag(page, handle(page, "end 0 all"), (3, 2))
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.locator("#link").click()
    page.locator("#message", has_text="copied").wait_for()
    copied = page.evaluate("navigator.clipboard.readText()")
    assert copied.startswith(PAGE.as_uri() + "#scene=4,1/13,2/0,0/")
    other = opened(copied.removeprefix(PAGE.as_uri()))
    assert scene(other) == scene(page) == Scenario(SQUARE, (13, 2), HIT.obstacles)
    page.wait_for_url(copied)  # the address follows the scene, too
    page.reload()
    assert scene(page) == scene(other)


DAMAGED = {
    "#gallery=none-such": "There is no scene “none-such” in the gallery.",
    "#scene=": "The link is damaged, in line 1: m k: expected two integers",
    "#scene=3,0/0,0/0,0/0,1/1,0": "in line 4: robot, vertex 2: clockwise turn (cross -1)",
    "#scene=3,0/0,0/0,0/1,0/0,1/7,7": "in line 6: expected the end of the file",
    "#scene=<img src=x onerror=alert(1)>": "The link is damaged, in line 1",
    "#%E0%A4%A": "The link says “%E0%A4%A”; expected",
    "#scenes": "The link says “scenes”; expected scene=… or gallery=….",
}


@pytest.mark.slow
def test_a_damaged_link_is_named_and_the_page_still_works(opened):
    page = opened("#scene=3,0/0,0/0,0/1,0")
    assert "in line 5: robot, vertex 3: expected two integers" in page.text_content("#message")
    assert answer(page) == "NO"  # the scene that the page begins with
    for address, message in DAMAGED.items():
        page.evaluate("address => (location.hash = address)", address)
        page.locator("#message", has_text=message).wait_for()
        assert answer(page) == "NO"


def test_the_input_can_be_edited_as_text(opened):
    page = opened(link(HIT))
    page.locator("#input summary").click()
    text = page.locator("#text")
    assert text.input_value().encode() == render([HIT])
    text.fill(render([FREE]).decode().strip())
    assert answer(page) == "YES"
    assert scene(page) == FREE
    text.fill("1\n3 0\n0 0\n0 0\n1 0\n2 é\n")
    assert page.text_content("#text-fault").startswith("Line 6: robot, vertex 3: expected an")
    assert scene(page) == FREE
    text.fill(render([HIT, FREE]).decode())
    page.locator("#scenario-count", has_text="2").wait_for()


@pytest.mark.slow
def test_scenes_as_wide_as_the_world_and_a_unit_apart(opened):
    far = 100_000_000
    robot = [(-far, -far), (far, -far), (far, -1)]
    obstacle = [(-far, -far + 1), (far - 1, 0), (-far, far)]
    page = opened(link(Scenario(robot, (0, 0), [obstacle])))
    expected = page.evaluate(
        "text => window.collisionCourse.answers(text)[0]",
        render([Scenario(robot, (0, 0), [obstacle])]).decode(),
    )
    assert answer(page) == expected == "YES"
    page.keyboard.press("0")
    settle(page)
    labels = page.locator("#scene text.number").all_text_contents()
    assert 4 < len(labels) < 40
    assert "100\u202f000\u202f000" in labels
    assert page.evaluate(
        """() => {
            const board = document.getElementById("scene").getBoundingClientRect();
            return [...document.querySelectorAll("#scene text.number")]
                .map((label) => label.getBoundingClientRect())
                .every(({left, right}) => board.left <= left && right <= board.right);
        }"""
    )
    page.locator("#scene").hover(position={"x": 300, "y": 150})
    page.keyboard.down("Control")
    for _ in range(3):
        page.mouse.wheel(0, -600)
    page.keyboard.up("Control")
    settle(page)
    assert page.locator("#scene text.number").all_text_contents() != labels
    page.locator(".zoom[data-board=scene] [data-zoom=fit]").click()
    settle(page)
    assert page.locator("#scene text.number").all_text_contents() == labels


def test_it_opens_on_the_place_that_decides_where_nothing_is_seen_of_it_in_the_whole_scene(opened):
    far = 10**8
    corner = [(-far, -far), (1 - far, -far), (1 - far, 1 - far)]
    thin = Scenario(corner, (2 * far - 2, 2 * far - 1), [[(0, 0), (1, -1), (1, 0)]])
    page = opened(link(thin))
    assert answer(page) == "NO"
    notes = page.locator(".part")
    assert notes.evaluate_all("notes => notes.map((note) => note.hidden)") == [False, False]
    for board in ("scene", "difference"):
        labels = page.locator(f"#{board} text.number").all_text_contents()
        assert {"−1", "0", "1"} <= set(labels), board
    for whole, near in (("press 0", "press 1"), ("note", "button"), ("button", "press 1")):
        show(page, whole, "fit")
        assert notes.evaluate_all("notes => notes.every((note) => note.hidden)"), whole
        assert "1" not in page.locator("#scene text.number").all_text_contents()
        show(page, near, "near")
        assert notes.evaluate_all("notes => notes.every((note) => !note.hidden)"), near
        assert "1" in page.locator("#scene text.number").all_text_contents()
    page.locator("#input summary").click()
    page.locator("#text").press("0")
    settle(page)
    assert "1" in page.locator("#scene text.number").all_text_contents()


def show(page, how, what):
    """Show all or the place that decides, on both boards: by a key, the notes, or the buttons."""
    if how.startswith("press"):
        page.keyboard.press(how[-1])
    else:
        for button in page.locator(".part" if how == "note" else f"[data-zoom={what}]").all():
            button.click()
    settle(page)


@pytest.mark.parametrize("size", [1, 10**6])
def test_a_scene_that_can_be_seen_opens_whole(opened, size):
    robot, *obstacles = (
        [(x * size, y * size) for x, y in polygon] for polygon in (HIT.robot, *HIT.obstacles)
    )
    page = opened(link(Scenario(robot, (10 * size, 0), obstacles)))
    assert answer(page) == "NO"
    hidden = page.locator(".part").evaluate_all("notes => notes.map((note) => note.hidden)")
    assert hidden == [True, True]


def test_dragging_at_the_limit_stays_within_it(opened):
    far = 100_000_000
    robot = [(far - 4, 0), (far, 0), (far, 4), (far - 4, 4)]
    page = opened(link(Scenario(robot, (0, -5), [])))
    page.locator('path[data-part="robot 0 all"]').focus()
    page.keyboard.press("ArrowRight")
    assert scene(page).robot == robot
    page.locator('path[data-part="end 0 all"]').focus()
    page.keyboard.press("ArrowRight")
    assert scene(page).move == (0, -5)


def test_a_finger_drags_on_a_phone_and_nothing_is_cut_off(opened):
    page = opened(link(HIT), phone=True)
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    unit = unit_px(page)
    x, y = handle(page, "end 0 all")
    session = page.context.new_cdp_session(page)

    def touch(kind, *points):
        session.send(
            "Input.dispatchTouchEvent",
            {"type": kind, "touchPoints": [{"x": x, "y": y} for x, y in points]},
        )

    touch("touchStart", (x + 8, y + 8))  # a finger is not exact
    for step in range(1, 6):
        touch("touchMove", (x + 8 - step * unit, y + 8 + step * unit))
    touch("touchEnd")
    settle(page)
    assert scene(page).move == (5, -5)
    assert page.evaluate("window.scrollY") == 0


@pytest.mark.slow  # a finger drags in a fast test
def test_two_fingers_zoom(opened):
    page = opened(link(HIT), phone=True)
    before = unit_px(page)
    board = page.locator("#scene").bounding_box()
    x, y = board["x"] + 60, board["y"] + 40
    session = page.context.new_cdp_session(page)
    for kind, spread in (("touchStart", 20), ("touchMove", 30), ("touchMove", 40), ("touchEnd", 0)):
        points = [{"x": x, "y": y, "id": 0}, {"x": x + spread, "y": y, "id": 1}] if spread else []
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
    assert unit_px(page) > 1.5 * before
    assert scene(page) == HIT


@pytest.mark.slow
def test_random_drags_keep_the_scene_valid(opened):
    rng = Rng(7)
    page = opened("#gallery=01-first-1")
    for _ in range(25):
        settle(page)
        parts = page.locator("#scene circle[data-part]")
        box = parts.nth(rng.below(parts.count())).bounding_box()
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x + rng.between(-150, 150), y + rng.between(-150, 150))
        page.mouse.up()
        found = scene(page)
        assert parse(render([found])) == [found]
        assert all(is_strictly_convex(polygon) for polygon in (found.robot, *found.obstacles))
