// The scene: what stands where, the move, the first contact or a separating line, and handles.

import { boxOf, cross, plus, translated } from "../exact/geometry.js";
import { toNumber } from "../exact/contact.js";
import { polygonOf } from "../exact/model.js";
import { contactPoint, pointText } from "../exact/reason.js";

export const SCENE_LAYERS = ["areas", "bodies", "lines", "labels", "handles"];
const HANDLES_MAX = 60; // with more corners, only those of the selected polygon have handles
const NAMES_MAX = 40; // of more obstacles, only the one that is shown has its number
const GRIP_PX = 9;
const GRIP_TOUCH_PX = 20;
const SELECTED_PX = 3; // so much nearer counts a handle of the selected polygon
const NEAR_UNITS = 3; // around a contact that is looked at closely

/** The box of all that a scene shows. */
export function sceneBox({ robot, move, obstacles }) {
  return boxOf([...robot, ...translated(robot, move), ...obstacles.flat()]);
}

/** How far both polygons of a difference are apart, or else overlap; rounded, only to be shown. */
export function marginOf({ steps }) {
  const apart = ({ edge, at }) => Number(cross(edge, at)) / Math.hypot(...edge);
  return Math.abs(steps.reduce((widest, step) => Math.max(widest, apart(step)), -Infinity));
}

/** Where they come nearest: [the first contact's point, its room], or of the gap; else null. */
export function nearPlace({ scene, verdict, line, sum }) {
  if (!sum) return null;
  const room = Math.max(NEAR_UNITS, 3 * marginOf(sum));
  if (verdict.first) {
    const point = contactPoint(scene, verdict.first);
    return point && [point, room];
  }
  return line && [sum.steps[line.step].takesA ? line.inB : line.inA, room];
}

/** The middle of the robot's vertices: the arrow of the move begins there. */
export function middleOf(polygon) {
  const sum = polygon.reduce(plus);
  return sum.map((coordinate) => coordinate / polygon.length);
}

/** The parts of a scene that have a handle: corners, and the tip of the move's arrow. */
export function handlesOf(scene, selected) {
  const { robot, obstacles } = scene;
  const corners = robot.length + obstacles.reduce((sum, polygon) => sum + polygon.length, 0);
  const parts = [];
  const add = (kind, index) => {
    const polygon = polygonOf(scene, { kind, index });
    const isSelected = selected?.kind === kind && selected.index === index;
    if (corners > HANDLES_MAX && !(isSelected && polygon.length <= HANDLES_MAX)) return;
    polygon.forEach((_, vertex) => parts.push({ kind, index, vertex }));
  };
  add("robot", 0);
  parts.push({ kind: "end", index: 0, vertex: null });
  obstacles.forEach((_, index) => add("obstacle", index));
  return parts;
}

/** Where a handle is drawn, in the plane. */
export function handlePlace(scene, part) {
  if (part.kind === "end") return plus(middleOf(scene.robot), scene.move);
  return polygonOf(scene, part)[part.vertex];
}

/** The handle that is nearest to a pixel and near enough; null if there is none.
 *
 * Where corners of two polygons coincide, that of the selected one is meant.
 */
export function handleAt(board, state, pixel, isTouch) {
  let best = null;
  let nearest = isTouch ? GRIP_TOUCH_PX : GRIP_PX;
  for (const part of handlesOf(state.scene, state.selected)) {
    const [x, y] = board.view.toScreen(handlePlace(state.scene, part));
    const isSelected = part.kind === state.selected?.kind && part.index === state.selected.index;
    const distance = Math.hypot(pixel[0] - x, pixel[1] - y) - (isSelected ? SELECTED_PX : 0);
    if (distance <= nearest) [best, nearest] = [part, distance];
  }
  return best;
}

export const keyOf = ({ kind, index, vertex }) => `${kind} ${index} ${vertex ?? "all"}`;

export function partOf(key) {
  const [kind, index, vertex] = key.split(" ");
  return { kind, index: Number(index), vertex: vertex === "all" ? null : Number(vertex) };
}

/** What a screen reader says of a part. */
export function partName(scene, part) {
  if (part.kind === "end") return `End of the move, displacement ${pointText(scene.move)}`;
  const polygon = polygonOf(scene, part);
  const name = part.kind === "robot" ? "Robot" : `Obstacle ${part.index + 1}`;
  if (part.vertex === null) return `${name}, ${polygon.length} corners`;
  const at = pointText(polygon[part.vertex]);
  return `${name}, corner ${part.vertex + 1} of ${polygon.length}, at ${at}`;
}

export function paintScene(board, state) {
  const { scene, verdict } = state;
  const { robot, move, obstacles } = scene;
  board.paint(({ areas, bodies, lines, labels, handles }) => {
    const { view } = board;
    const grip = (part, look) => ({
      class: look + (state.selected && keyOf(part) === keyOf(state.selected) ? " selected" : ""),
      "data-part": keyOf(part),
      tabindex: 0,
      role: "button",
      "aria-label": partName(scene, part),
    });
    const body = (part, polygon, look) =>
      bodies.put("path", keyOf(part), { d: view.path(polygon), ...grip(part, look) });

    areas.put("path", "covered", { d: view.path(verdict.covered), class: "covered" });
    obstacles.forEach((polygon, index) => {
      const look = verdict.places[index] === "outside" ? "obstacle" : "obstacle hit";
      body({ kind: "obstacle", index, vertex: null }, polygon, look);
    });
    body({ kind: "end", index: 0, vertex: null }, translated(robot, move), "robot end");
    body({ kind: "robot", index: 0, vertex: null }, robot, "robot");
    paintMoment(lines, view, state);
    paintArrow(lines, view, scene);
    paintContact(lines, labels, view, state);
    if (state.line) paintStrip(areas, lines, view, state.line);
    paintCompared(lines, view, state);
    if (obstacles.length > 1) {
      obstacles.forEach((polygon, index) => {
        if (obstacles.length > NAMES_MAX && index !== state.shown) return;
        const [x, y] = view.toScreen(middleOf(polygon));
        labels.put("text", `name ${index}`, { x, y: y + 5, class: "name" }, `${index + 1}`);
      });
    }
    for (const part of handlesOf(scene, state.selected)) {
      paintHandle(handles, view, part, handlePlace(scene, part), grip);
    }
  });
}

function paintHandle(handles, view, part, place, grip) {
  const [cx, cy] = view.toScreen(place);
  const at = { cx: cx.toFixed(2), cy: cy.toFixed(2) };
  // The end's polygon can be reached by Tab already.
  const hidden = part.kind === "end" ? { tabindex: null, role: null, "aria-label": null } : {};
  const look = `handle ${part.kind}`;
  handles.put("circle", keyOf(part), { ...at, r: 5.5, ...grip(part, look), ...hidden });
}

/** The robot at the moment that the slider shows. */
function paintMoment(lines, view, { scene, moment, touches }) {
  const share = toNumber(moment);
  if (share === 0) return;
  const there = translated(scene.robot, scene.move.map((delta) => delta * share));
  const look = touches.some(Boolean) ? "passing hit" : "passing";
  lines.put("path", "moment", { d: view.path(there), class: look });
}

function paintArrow(lines, view, { robot, move }) {
  const middle = middleOf(robot);
  const [[x, y], [endX, endY]] = view.segment(middle, plus(middle, move));
  const length = Math.hypot(endX - x, endY - y);
  if (length < 24) return;
  const [right, down] = [(endX - x) / length, (endY - y) / length];
  const [tipX, tipY] = [endX - 7 * right, endY - 7 * down]; // the handle is at the end
  const [baseX, baseY] = [tipX - 13 * right, tipY - 13 * down];
  lines.line("shaft", [[x, y], [baseX, baseY]], { class: "arrow" });
  const head = [
    [tipX, tipY],
    [baseX - 5 * down, baseY + 5 * right],
    [baseX + 5 * down, baseY - 5 * right],
  ];
  lines.put("path", "head", { d: `M${head.join("L")}Z`, class: "arrow head" });
}

/** The robot at the first contact, and the point where they meet. */
function paintContact(lines, labels, view, { scene, verdict }) {
  const contact = verdict.first;
  if (contact === null) return;
  const share = toNumber(contact.moment);
  if (share > 0) {
    const there = translated(scene.robot, scene.move.map((delta) => delta * share));
    lines.put("path", "contact", { d: view.path(there), class: "contact" });
  }
  const point = contactPoint(scene, contact);
  if (!point) return;
  const [cx, cy] = view.toScreen(point);
  labels.put("circle", "ring", { cx, cy, r: 9, class: "ring" });
}

/** The separating line, midway between both polygons, with the free strip around it. */
function paintStrip(areas, lines, view, { along, inA, inB }) {
  const [a, b] = [view.line(inA, along), view.line(inB, along)];
  areas.put("path", "strip", { d: `M${a[0]}L${a[1]}L${b[1]}L${b[0]}Z`, class: "strip" });
  const middle = [0, 1].map((axis) => (inA[axis] + inB[axis]) / 2);
  lines.line("separating", view.line(middle, along), { class: "separating" });
}

/** The edges that the merge compares now, on their polygons. */
function paintCompared(lines, view, { scene, sum, step, shown }) {
  if (!sum || step >= sum.steps.length || step < 0) return;
  const { i, j, takesA, takesB } = sum.steps[step];
  const paint = (key, [from, to], look) =>
    lines.line(key, view.segment(from, to), { class: `current ${look}` });
  const edge = ({ vertices }, index) =>
    [index, index + 1].map((at) => vertices[at % vertices.length]);
  const { a, b } = sum;
  if (i < a.edges.length) paint("edge a", edge(a, i), takesA ? "a taken" : "a");
  if (j < b.edges.length) {
    const mirrored = edge(b, j).map(([x, y]) => [-x, -y]);
    paint("edge b", mirrored, takesB ? "b taken" : "b");
  }
}
