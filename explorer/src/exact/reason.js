// The answer in words, exact: what meets what and when, or which line separates.

import { boxOf, difference, originIn, sweep } from "./geometry.js";
import { firstContact, fractionText, holds, isLess, placeAt, toNumber } from "./contact.js";

export const pointText = ([x, y]) => `(${x}, ${y})`;
const edgeText = ([from, to]) => `${pointText(from)}–${pointText(to)}`;

/** The answer to a scene, with what is needed to say why.
 *
 * Returns {answer, places, first, covered}. places: for each obstacle, where the origin is in
 * obstacle + (-sweep). first: the first contact with any of them, with the obstacle's index, or
 * null. covered: the sweep. O(k * m + n).
 */
export function judge(scene) {
  const covered = sweep(scene.robot, scene.move);
  const box = boxOf(covered);
  const places = scene.obstacles.map((obstacle) => {
    if (areApart(box, boxOf(obstacle))) return "outside";
    return originIn(difference(obstacle, covered));
  });
  const answer = places.every((place) => place === "outside") ? "YES" : "NO";
  return { answer, places, first: firstOf(scene, places), covered };
}

/** The contact before all others, {index, ...}; null if every obstacle is outside. */
function firstOf(scene, places) {
  let first = null;
  for (let index = 0; index < places.length; index += 1) {
    if (places[index] === "outside") continue;
    const contact = firstContact(scene, scene.obstacles[index]);
    if (first === null || isLess(contact.moment, first.moment)) first = { index, ...contact };
    if (first.moment.over === 0n) break;
  }
  return first;
}

const areApart = ([left, bottom, right, top], [left2, bottom2, right2, top2]) =>
  right < left2 || right2 < left || top < bottom2 || top2 < bottom;

/** One or two sentences that say why the answer is so.
 *
 * shown, line: the obstacle that is shown, and the line that separates it or null.
 */
export function reason(scene, verdict, shown, line) {
  if (!scene.obstacles.length) return "There is no obstacle that could be touched.";
  const { places, first } = verdict;
  if (first === null) return freeReason(scene, shown, line);
  const name = obstacleName(scene, first.index);
  const isTouch = places[first.index] === "boundary";
  const touch = isTouch ? " They only touch; that is a collision, too." : "";
  return `${contactText(scene, scene.obstacles[first.index], first, name)}${touch}`;
}

function obstacleName(scene, index) {
  return scene.obstacles.length === 1 ? "the obstacle" : `obstacle ${index + 1}`;
}

function freeReason(scene, shown, line) {
  const gap = gapText(line);
  const area = "all that the robot covers";
  if (scene.obstacles.length === 1) {
    return `A line separates the obstacle from ${area}, with a gap of ${gap}.`;
  }
  const count = scene.obstacles.length;
  return (
    `A line separates each of the ${count} obstacles from ${area}; ` +
    `for obstacle ${shown + 1}, with a gap of ${gap}.`
  );
}

/** A gap as an exact term with its rounded value: 3/√13 ≈ 0.83. */
function gapText(line) {
  const [x, y] = line.along.map(BigInt);
  const common = absolute(gcd(x, y)); // it divides the cross product, too
  const gap = BigInt(line.gap) / common;
  const square = (x * x + y * y) / (common * common);
  const root = BigInt(Math.round(Math.sqrt(Number(square))));
  if (root * root === square) {
    const divisor = gcd(gap, root);
    const [over, under] = [gap / divisor, root / divisor];
    return under === 1n ? `${over}` : `${over}/${under}`;
  }
  return `${gap}/√${square} ≈ ${Number((Number(gap) / Math.sqrt(Number(square))).toPrecision(3))}`;
}

const gcd = (a, b) => (b ? gcd(b, a % b) : a);
const absolute = (a) => (a < 0n ? -a : a);

function contactText(scene, obstacle, contact, name) {
  if (contact.kind === "overlap") return overlapText(scene, obstacle, name);
  const { over, under } = contact.moment;
  let when = `After ${fractionText(contact.moment)} of the move,`;
  if (over === 0n) when = "At the start,";
  if (over === under) when = "At the very end of the move,";
  return `${when} ${meeting(contact, name)}.`;
}

function meeting({ kind, corner, edge, other }, name) {
  switch (kind) {
    case "corner-edge":
      return `the robot’s corner ${pointText(corner)} meets the edge ${edgeText(edge)} of ${name}`;
    case "edge-corner":
      return `the robot’s edge ${edgeText(edge)} meets the corner ${pointText(corner)} of ${name}`;
    case "corner-corner":
      return `the robot’s corner ${pointText(corner)} meets the corner ${pointText(other)} of ${name}`;
    default:
      return `the robot’s edge ${edgeText(edge)} meets the edge ${edgeText(other)} of ${name}`;
  }
}

function overlapText(scene, obstacle, name) {
  if (holds(obstacle, scene.robot)) return `The robot starts inside ${name}.`;
  const title = name.replace(/^./, (letter) => letter.toUpperCase());
  if (holds(scene.robot, obstacle)) return `${title} lies inside the robot at the start.`;
  return `The robot and ${name} overlap at the start.`;
}

/** A point of the first contact, as numbers for drawing; null for an overlap. */
export function contactPoint(scene, contact) {
  if (contact.kind === "overlap") return null;
  const { kind, corner, other, edge, moment } = contact;
  if (kind === "edge-corner") return corner;
  if (kind === "corner-corner") return other;
  const moved = (point) => placeAt(point, scene.move, moment).map(toNumber);
  if (kind === "corner-edge") return moved(corner);
  return middleOfOverlap(edge.map(moved), other);
}

/** The middle of what two overlapping edges on one line share. */
function middleOfOverlap(edge, other) {
  const ends = [...edge, ...other].sort(([ax, ay], [bx, by]) => ax - bx || ay - by);
  return [(ends[1][0] + ends[2][0]) / 2, (ends[1][1] + ends[2][1]) / 2];
}
