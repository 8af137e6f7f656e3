// Changes of a scene. Every function returns a new valid scene, or null if there is none.
// A scene: {robot, move, obstacles}. A part of it is named {kind: "robot" | "end" | "obstacle",
// index (of the obstacle), vertex (or null: all of it)}.

import { cross, isZero, minus, plus, translated } from "./geometry.js";

export const polygonOf = (scene, { kind, index }) =>
  kind === "obstacle" ? scene.obstacles[index] : scene.robot;

/** Where a part is: the vertex, or else the first vertex of the polygon. */
export function positionOf(scene, part) {
  const polygon = polygonOf(scene, part);
  const point = polygon[part.vertex ?? 0];
  return part.kind === "end" ? plus(point, scene.move) : point;
}

/** The scene with a part moved as near to the target as the rules allow. */
export function moveTo(scene, part, target, most) {
  if (part.vertex === null) return moveWhole(scene, part, target, most);
  const polygon = polygonOf(scene, part);
  const isFree = (point) =>
    fitsCorner(polygon, part.vertex, point) && inWorld(scene, part.kind, [point], most);
  const point = nearest(polygon[part.vertex], target, isFree);
  return withPolygon(scene, part, polygon.with(part.vertex, point));
}

function moveWhole(scene, part, target, most) {
  const by = minus(target, positionOf(scene, part));
  if (part.kind === "end") {
    const [dx, dy] = plus(scene.move, by);
    return { ...scene, move: [clampMove(scene, 0, dx, most), clampMove(scene, 1, dy, most)] };
  }
  const polygon = polygonOf(scene, part);
  const reach = part.kind === "robot" ? [...polygon, ...translated(polygon, scene.move)] : polygon;
  const kept = [0, 1].map((axis) => {
    const values = reach.map((point) => point[axis]);
    return clamp(by[axis], -most - least(values), most - greatest(values));
  });
  return withPolygon(scene, part, translated(polygon, kept));
}

function clampMove({ robot }, axis, delta, most) {
  const values = robot.map((point) => point[axis]);
  return clamp(delta, -most - least(values), most - greatest(values));
}

const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
const least = (values) => values.reduce((a, b) => Math.min(a, b));
const greatest = (values) => values.reduce((a, b) => Math.max(a, b));

/** Whether points of a polygon are within the limit; the robot's at the end of its move, too. */
function inWorld({ move }, kind, points, most) {
  const within = ([x, y]) => Math.abs(x) <= most && Math.abs(y) <= most;
  return points.every((point) => within(point) && (kind !== "robot" || within(plus(point, move))));
}

/** Whether the polygon stays strictly convex if this vertex is put there.
 *
 * The other vertices keep their turns. Three left turns, before, at and after the vertex, put it
 * into the region outside the edge between its neighbours that keeps theirs convex.
 */
function fitsCorner(polygon, vertex, point) {
  const n = polygon.length;
  const at = (offset) => (offset ? polygon[(vertex + offset + n) % n] : point);
  const turn = (i) => cross(minus(at(i), at(i - 1)), minus(at(i + 1), at(i)));
  return turn(-1) > 0 && turn(0) > 0 && turn(1) > 0;
}

/** A free point near the target: from a free point on in ever smaller steps, while it gets nearer.
 *
 * So a vertex that is dragged too far slides along the border of what is allowed.
 */
function nearest(start, target, isFree) {
  if (isFree(target)) return target;
  const distance = (point) => Math.hypot(...minus(point, target));
  let here = start;
  for (let step = 2 ** Math.ceil(Math.log2(distance(start) + 1)); step >= 1; step /= 2) {
    for (let moved = true; moved; ) {
      moved = false;
      for (const direction of DIRECTIONS) {
        const there = plus(here, direction.map((part) => part * step));
        if (distance(there) < distance(here) && isFree(there)) {
          here = there;
          moved = true;
        }
      }
    }
  }
  return here;
}

const DIRECTIONS = [-1, 0, 1].flatMap((x) => [-1, 0, 1].map((y) => [x, y])).filter((d) => !isZero(d));

function withPolygon(scene, { kind, index }, polygon) {
  if (kind !== "obstacle") return { ...scene, robot: polygon };
  return { ...scene, obstacles: scene.obstacles.with(index, polygon) };
}

/** One more corner on the longest edge that leaves room for it; null if none does.
 *
 * Returns {scene, vertex}.
 */
export function addCorner(scene, part, most) {
  const polygon = polygonOf(scene, part);
  const n = polygon.length;
  const length = (i) => Math.hypot(...minus(polygon[(i + 1) % n], polygon[i]));
  const byLength = polygon.map((_, i) => i).sort((i, j) => length(j) - length(i));
  for (const i of byLength) {
    const [from, to] = [polygon[i], polygon[(i + 1) % n]];
    const [ex, ey] = minus(to, from);
    for (const share of [0.25, 0.15, 0.08, 0.04, 0.02, 0.01]) {
      for (const along of [0.5, 0.35, 0.65, 0.2, 0.8]) {
        const x = Math.round(from[0] + along * ex + share * ey);
        const y = Math.round(from[1] + along * ey - share * ex);
        const grown = polygon.toSpliced(i + 1, 0, [x, y]);
        if (!fitsCorner(grown, i + 1, [x, y]) || !inWorld(scene, part.kind, [[x, y]], most)) continue;
        return { scene: withPolygon(scene, part, grown), vertex: i + 1 };
      }
    }
  }
  return null;
}

/** The polygon without a corner; null if it has only three. */
export function removeCorner(scene, part, fewest) {
  const polygon = polygonOf(scene, part);
  if (polygon.length <= fewest) return null;
  return withPolygon(scene, part, polygon.toSpliced(part.vertex, 1));
}

/** One more obstacle: a square of about this size around a point; null if it does not fit. */
export function addObstacle(scene, [x, y], size, most) {
  const half = Math.max(1, Math.round(size / 2));
  const [cx, cy] = [x, y].map((c) => clamp(Math.round(c), half - most, most - half));
  const square = [[-half, -half], [half, -half], [half, half], [-half, half]];
  return { ...scene, obstacles: [...scene.obstacles, translated(square, [cx, cy])] };
}

export function removeObstacle(scene, index) {
  return { ...scene, obstacles: scene.obstacles.toSpliced(index, 1) };
}
