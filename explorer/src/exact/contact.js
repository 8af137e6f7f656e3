// Moments of the move, exact: when the robot first touches, and what it touches then.

import { cross, minus, minkowskiSum, reflected } from "./geometry.js";

const big = ([x, y]) => [BigInt(x), BigInt(y)];
const bigCross = ([ax, ay], [bx, by]) => ax * by - ay * bx;

/** The fraction over / under in lowest terms, under > 0. Both are BigInt. */
export function fraction(over, under) {
  let [a, b] = [over, under];
  while (b) [a, b] = [b, a % b];
  const by = a < 0n === under < 0n ? a : -a;
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
  const zeros = zeroSides(standingDifference(obstacle, scene.robot), scene.move, moment);
  if (zeros === null) return "outside";
  return zeros.length ? "boundary" : "inside";
}

/** The indices of the edges on whose lines moment * move lies; null if it is outside. */
function zeroSides({ steps }, move, { over, under }) {
  const zeros = [];
  const side = under <= SLIDER_MAX ? sliderSide(over, under, move) : bigSide(over, under, move);
  for (let index = 0; index < steps.length; index += 1) {
    const value = side(steps[index]);
    if (value < 0) return null;
    if (value == 0) zeros.push(index); // 0 or 0n
  }
  return zeros;
}

const SLIDER_MAX = 1_000_000n; // up to here, coordinates times the moment's terms are exact Numbers

function sliderSide(over, under, move) {
  const [a, b] = [Number(over), Number(under)];
  const target = move.map((delta) => delta * a);
  return ({ edge, at }) => cross(edge, minus(target, [at[0] * b, at[1] * b]));
}

function bigSide(over, under, move) {
  const target = big(move).map((delta) => delta * over);
  return ({ edge, at }) =>
    bigCross(big(edge), minus(target, big(at).map((coordinate) => coordinate * under)));
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
    const need = cross(edge, at); // moment * rate must reach this
    const rate = cross(edge, move);
    if (need > 0 && rate <= 0) return null;
    if (rate > 0 && need > 0) {
      const bound = { over: BigInt(need), under: BigInt(rate) };
      if (isLess(from, bound)) from = bound;
    } else if (rate < 0) {
      const bound = { over: -BigInt(need), under: -BigInt(rate) };
      if (isLess(bound, until)) until = bound;
    }
  }
  if (isLess(until, from)) return null;
  const moment = fraction(from.over, from.under);
  return { moment, ...features(sum, zeroSides(sum, move, moment)) };
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
