// Moments of the move, exact: when the robot first touches, and what it touches then.

import { minus, minkowskiSum, reflected } from "./geometry.js";

const big = ([x, y]) => [BigInt(x), BigInt(y)];
const bigCross = ([ax, ay], [bx, by]) => ax * by - ay * bx;

/** The fraction over / under in lowest terms, under > 0. Both are BigInt. */
export function fraction(over, under) {
  let [a, b] = [over < 0n ? -over : over, under < 0n ? -under : under];
  while (b) [a, b] = [b, a % b];
  const by = under < 0n ? -a : a;
  return { over: over / by, under: under / by };
}

export const toNumber = ({ over, under }) => Number(over) / Number(under);
export const isLess = (p, q) => p.over * q.under < q.over * p.under;
export const fractionText = ({ over, under }) => (under === 1n ? `${over}` : `${over}/${under}`);

/** point + moment * move, as two fractions. */
export function placeAt(point, move, { over, under }) {
  const at = (start, delta) => fraction(BigInt(start) * under + over * BigInt(delta), under);
  return [at(point[0], move[0]), at(point[1], move[1])];
}

/** The Minkowski difference of an obstacle and the robot at its start: obstacle + (-robot). */
export const standingDifference = (obstacle, robot) => minkowskiSum(obstacle, reflected(robot));

/** Where the robot and the obstacle are at a moment: "inside", "boundary" or "outside".
 *
 * The robot has moved by moment * move, so they touch if that point is in obstacle + (-robot);
 * "boundary": only boundary points are shared.
 */
export function stateAt(scene, obstacle, moment) {
  const { zeros, outside } = sides(standingDifference(obstacle, scene.robot), scene.move, moment);
  if (outside) return "outside";
  return zeros.length ? "boundary" : "inside";
}

/** On which side of each edge moment * move lies: {zeros: indices of steps, outside}. */
function sides({ steps }, move, { over, under }) {
  const target = big(move).map((delta) => delta * over);
  const zeros = [];
  let outside = false;
  steps.forEach(({ edge, at }, index) => {
    const from = big(at).map((coordinate) => coordinate * under);
    const side = bigCross(big(edge), minus(target, from));
    if (side < 0n) outside = true;
    if (side === 0n) zeros.push(index);
  });
  return { zeros, outside };
}

/** The first contact of the robot with an obstacle, or null: {moment, kind, corner, edge, ...}.
 *
 * The points moment * move that lie in obstacle + (-robot) are an interval, cut out by one edge
 * after the other. kind: "overlap" (at the start already, more than boundary points) or
 * "corner-edge" {corner of the robot, edge of the obstacle}, "edge-corner" {edge of the robot,
 * corner of the obstacle}, "corner-corner" {corner, other}, "edge-edge" {edge, other}. All points
 * are given as in the input, the robot's at its start. O(n + m).
 */
export function firstContact({ robot, move }, obstacle) {
  const sum = standingDifference(obstacle, robot);
  let from = { over: 0n, under: 1n };
  let until = { over: 1n, under: 1n };
  for (const { edge, at } of sum.steps) {
    const need = bigCross(big(edge), big(at)); // moment * rate must reach this
    const rate = bigCross(big(edge), big(move));
    if (rate === 0n) {
      if (need > 0n) return null;
      continue;
    }
    const bound = fraction(need, rate);
    if (rate > 0n && isLess(from, bound)) from = bound;
    if (rate < 0n && isLess(bound, until)) until = bound;
  }
  if (isLess(until, from)) return null;
  return { moment: from, ...features(sum, sides(sum, move, from).zeros) };
}

/** What meets there: the vertex or the edge of the sum names the features of both polygons. */
function features({ a, b, steps }, zeros) {
  if (!zeros.length) return { kind: "overlap" };
  const obstacleCorner = (i) => a.vertices[i % a.vertices.length];
  const robotCorner = (j) => minus([0, 0], b.vertices[j % b.vertices.length]);
  if (zeros.length === 2) {
    const vertex = zeros[1] - zeros[0] === 1 ? zeros[1] : zeros[0]; // where both edges meet
    const { i, j } = steps[vertex];
    return { kind: "corner-corner", corner: robotCorner(j), other: obstacleCorner(i) };
  }
  const { i, j, takesA, takesB } = steps[zeros[0]];
  const obstacleEdge = [obstacleCorner(i), obstacleCorner(i + 1)];
  const robotEdge = [robotCorner(j), robotCorner(j + 1)];
  if (takesA && takesB) return { kind: "edge-edge", edge: robotEdge, other: obstacleEdge };
  if (takesA) return { kind: "corner-edge", corner: robotCorner(j), edge: obstacleEdge };
  return { kind: "edge-corner", edge: robotEdge, corner: obstacleCorner(i) };
}

/** Whether all of the polygon `inner` lies in `outer`: true only if none of it is outside. */
export function holds(outer, inner) {
  return inner.every((point) => {
    const shifted = outer.map((vertex) => big(minus(vertex, point)));
    return shifted.every((vertex, i) => bigCross(vertex, shifted[(i + 1) % outer.length]) >= 0n);
  });
}

/** The moment that a slider position stands for: position of `positions`, as a fraction. */
export const momentOf = (position, positions) => fraction(BigInt(position), BigInt(positions));
