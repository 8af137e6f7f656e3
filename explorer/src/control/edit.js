// Changing the scene by pointer, keys and buttons.

import { minus, plus } from "../exact/geometry.js";
import {
  addCorner,
  addObstacle,
  moveTo,
  positionOf,
  removeCorner,
  removeObstacle,
} from "../exact/model.js";
import { handleAt, keyOf, partOf, sceneBox } from "../view/scene_view.js";

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const SHIFT_FACTOR = 10;

/** What begins when the pointer goes down at a pixel: a function that drags, or null to pan. */
export function startDrag(board, session, rules, pixel, event) {
  const body = event.target.closest?.("[data-part]")?.dataset.part;
  const part =
    handleAt(board, session, pixel, event.pointerType !== "mouse") ?? (body ? partOf(body) : null);
  session.select(part);
  if (!part) return null;
  const from = board.view.toWorld(pixel);
  const start = positionOf(session.scene, part);
  let isMoved = false;
  return (move, now) => {
    const by = minus(board.view.toWorld(now), from).map(Math.round);
    const target = plus(start, by);
    const here = positionOf(session.scene, part);
    if (target[0] === here[0] && target[1] === here[1]) return;
    const scene = moveTo(session.scene, part, target, rules.max_coordinate);
    session.edit(scene, !isMoved);
    isMoved = true;
  };
}

/** Move or delete the focused part by keys. Returns true if the key was used. */
export function editByKey(session, rules, part, event, say) {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const arrow = ARROWS[event.key];
  if (arrow) {
    const by = arrow.map((delta) => delta * (event.shiftKey ? SHIFT_FACTOR : 1));
    const target = plus(positionOf(session.scene, part), by);
    const scene = moveTo(session.scene, part, target, rules.max_coordinate);
    const [here, there] = [session.scene, scene].map((one) => `${positionOf(one, part)}`);
    if (here === there) say("It cannot go there: it would not be convex, or leave the limits.");
    else session.edit(scene);
    return true;
  }
  if (event.key !== "Delete" && event.key !== "Backspace") return false;
  if (part.vertex !== null) deleteCorner(session, rules, say);
  else if (part.kind === "obstacle") deleteObstacle(session);
  return true;
}

/** What the corner buttons work on: the selected polygon, else the robot. */
function target(session) {
  const { selected } = session;
  return selected && selected.kind !== "end" ? selected : { kind: "robot", index: 0, vertex: null };
}

export function insertCorner(session, rules, say) {
  const part = target(session);
  const grown = addCorner(session.scene, part, rules.max_coordinate);
  if (!grown) {
    say("No integer point is left for one more corner. Make the polygon larger first.");
    return;
  }
  session.selected = { ...part, vertex: grown.vertex };
  session.edit(grown.scene);
}

export function deleteCorner(session, rules, say) {
  const part = target(session);
  if (part.vertex === null) {
    say("Select a corner first, then it can be removed.");
    return;
  }
  const scene = removeCorner(session.scene, part, rules.min_polygon_vertices);
  if (!scene) {
    say("A polygon has at least three corners.");
    return;
  }
  session.selected = { ...part, vertex: null };
  session.edit(scene);
}

/** A new square in the middle of what the board shows. */
export function insertObstacle(session, rules, board) {
  const { view } = board;
  const [left, bottom, right, top] = sceneBox(session.scene);
  const size = Math.max(right - left, top - bottom) / 8;
  const scene = addObstacle(session.scene, [view.x, view.y], size, rules.max_coordinate);
  const index = scene.obstacles.length - 1;
  session.selected = { kind: "obstacle", index, vertex: null };
  session.choice = index;
  session.edit(scene);
}

export function deleteObstacle(session) {
  const { selected, shown, scene } = session;
  if (!scene.obstacles.length) return;
  const index = selected?.kind === "obstacle" ? selected.index : shown;
  session.selected = null;
  session.choice = null;
  session.edit(removeObstacle(scene, index));
}

/** Keep the focus on the selected part if its element was made anew. */
export function focusSelected(svg, { selected }) {
  if (!selected) return;
  svg.querySelector(`[data-part="${keyOf(selected)}"][tabindex]`)?.focus({ preventScroll: true });
}
