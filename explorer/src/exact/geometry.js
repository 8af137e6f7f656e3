// Exact plane geometry. A point or vector is [x, y], both integers below 2^31 in absolute value.
// A polygon is a list of points, counter-clockwise and strictly convex.

const EXACT = 2 ** 52;

/** a x b, exact: a Number where that is safe, else a BigInt. Compare it with 0 or print it.
 *
 * A product of two integers that a Number shows as at most 2^52 is exact, because rounding keeps
 * the order and every integer up to 2^53 is a Number. The difference of two such products is at
 * most 2^53, so it is exact, too. Coordinates reach 10^8 and products 10^17: then BigInt decides.
 */
export function cross([ax, ay], [bx, by]) {
  const left = ax * by;
  const right = ay * bx;
  if (Math.abs(left) <= EXACT && Math.abs(right) <= EXACT) return left - right;
  return BigInt(ax) * BigInt(by) - BigInt(ay) * BigInt(bx);
}

export const plus = ([ax, ay], [bx, by]) => [ax + bx, ay + by];
export const minus = ([ax, ay], [bx, by]) => [ax - bx, ay - by];
export const isZero = ([x, y]) => x === 0 && y === 0;
export const translated = (polygon, by) => polygon.map((point) => plus(point, by));
/** The reflection in the origin: -P. (0 - x, because -0 would be another zero.) */
export const reflected = (polygon) => polygon.map((point) => minus([0, 0], point));

/** The polygon from its lowest, then leftmost vertex on: {vertices, edges}.
 *
 * From there on the edges are sorted by their polar angle, which grows from 0 to below 360 degrees.
 * A segment [a, b] counts as a polygon of two edges, there and back. O(n).
 */
function ring(polygon) {
  let first = 0;
  polygon.forEach(([x, y], index) => {
    const [lowX, lowY] = polygon[first];
    if (y < lowY || (y === lowY && x < lowX)) first = index;
  });
  const vertices = [...polygon.slice(first), ...polygon.slice(0, first)];
  const edges = vertices.map((vertex, i) => minus(vertices[(i + 1) % vertices.length], vertex));
  return { vertices, edges };
}

/** The Minkowski sum {a + b}: the edges of both, merged by polar angle. O(n + m).
 *
 * Returns {a, b, steps, vertices}. a, b: the two rings of vertices and edges. Each step takes one
 * edge, or two of the same direction as one: {i, j, turn, takesA, takesB, edge, at}, where i and j
 * are the next edges of a and b, turn = a_i x b_j (null if a list is used up), and the sum's edge
 * leads from its vertex `at` along `edge`. One step for each vertex of the sum.
 *
 * The sign of turn compares the angles, because a_i and b_j never differ by 180 degrees or more:
 * the last edge that was taken from one list came before the next one of the other list, and
 * neighbouring edges of a polygon differ by less. Source: de Berg et al., Computational
 * Geometry (3rd ed.), 13.3.
 */
export function minkowskiSum(polygonA, polygonB) {
  const a = ring(polygonA);
  const b = ring(polygonB);
  const n = a.edges.length;
  const m = b.edges.length;
  const steps = [];
  let at = plus(a.vertices[0], b.vertices[0]);
  for (let i = 0, j = 0; i < n || j < m; ) {
    const turn = i < n && j < m ? cross(a.edges[i], b.edges[j]) : null;
    const takesA = j === m || (i < n && turn >= 0);
    const takesB = i === n || (j < m && turn <= 0);
    const both = takesA && takesB;
    const edge = both ? plus(a.edges[i], b.edges[j]) : takesA ? a.edges[i] : b.edges[j];
    steps.push({ i, j, turn, takesA, takesB, edge, at });
    at = plus(at, edge);
    if (takesA) i += 1;
    if (takesB) j += 1;
  }
  return { a, b, steps, vertices: steps.map((step) => step.at) };
}

/** The convex polygon that the robot covers on its move: P and the segment from 0 to the move. */
export function sweep(robot, move) {
  return isZero(move) ? robot : minkowskiSum(robot, [[0, 0], move]).vertices;
}

/** Where the origin is: "inside", "boundary" or "outside" of a polygon. O(n). */
export function originIn({ steps }) {
  let onBoundary = false;
  for (const { edge, at } of steps) {
    const side = cross(at, edge); // of the origin, seen along the edge: positive on the left
    if (side < 0) return "outside";
    if (side === 0 || side === 0n) onBoundary = true;
  }
  return onBoundary ? "boundary" : "inside";
}

/** Obstacle + (-sweep), the Minkowski difference. It holds the origin if and only if they touch. */
export const difference = (obstacle, covered) => minkowskiSum(obstacle, reflected(covered));

/** A line that separates both polygons of a difference with the origin outside; else null.
 *
 * Returns {step, gap, along, inA, inB}: the edge of the difference with this index has the origin
 * strictly on its right (exact). The line runs along that edge, between the vertex inA of the
 * obstacle and the vertex inB of the sweep; the gap is gap / |along|. Of several edges, the one
 * with the widest gap is taken; rounding may take one that is as good but for the last digit.
 */
export function separation({ a, b, steps }) {
  let best = null;
  let widest = 0;
  steps.forEach(({ edge, at, i, j }, step) => {
    const gap = cross(edge, at);
    if (gap <= 0) return;
    const width = Number(gap) / Math.hypot(...edge);
    if (width <= widest) return;
    widest = width;
    const inA = a.vertices[i % a.vertices.length];
    const inB = minus([0, 0], b.vertices[j % b.vertices.length]);
    best = { step, gap, along: edge, inA, inB };
  });
  return best;
}

/** null for a counter-clockwise, strictly convex polygon of one winding; else its first fault. */
export function convexityFault(polygon) {
  const n = polygon.length;
  const edges = polygon.map((vertex, i) => minus(polygon[(i + 1) % n], vertex));
  const isUpper = ([x, y]) => y > 0 || (y === 0 && x > 0);
  let windings = 0;
  for (let i = 0; i < n; i += 1) {
    const [back, ahead] = [edges[i], edges[(i + 1) % n]];
    const turn = cross(back, ahead);
    if (turn <= 0) {
      let at = (i + 1) % n;
      let kind = turn < 0 ? "clockwise turn" : "no turn";
      if (isZero(back) || isZero(ahead)) kind = "the same vertex again";
      if (isZero(ahead)) at = Math.min(i + 2, n - 1);
      return { vertex: at, reason: `vertex ${at + 1}: ${kind} (cross ${turn})` };
    }
    if (isUpper(ahead) && !isUpper(back)) windings += 1;
  }
  if (windings === 1) return null;
  return { vertex: n - 1, reason: `expected one turn around, found ${windings}` };
}

/** The box [left, bottom, right, top] of many points. */
export function boxOf(points) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of points) {
    box[0] = Math.min(box[0], x);
    box[1] = Math.min(box[1], y);
    box[2] = Math.max(box[2], x);
    box[3] = Math.max(box[3], y);
  }
  return box;
}
