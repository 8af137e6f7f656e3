// Reads input files as strictly as the kit's validator does, with the same messages.

import { convexityFault } from "./geometry.js";

const LINE_BYTES = 64; // more than any valid line has
const SHOWN_BYTES = 24; // of a bad line in a message
const LINES_A_TURN = 10_000; // the reader lets the page breathe after so many
const INTEGER = "(0|-?[1-9][0-9]{0,17})";
const NUMBER = new RegExp(`^${INTEGER}$`);
const PAIR = new RegExp(`^${INTEGER} ${INTEGER}\n$`);
const SINGLE = new RegExp(`^${INTEGER}\n$`);

/** The input is not valid: at `line` (from 1), for this reason. */
export class InputError extends Error {
  constructor(line, reason) {
    super(`line ${line}: ${reason}`);
    this.line = line;
    this.reason = reason;
  }
}

/** Bytes as a string of the characters 0 to 255, so that a message can show any byte. */
export function bytesToText(bytes) {
  const parts = [];
  for (let at = 0; at < bytes.length; at += 8192) {
    parts.push(String.fromCharCode.apply(null, bytes.subarray(at, at + 8192)));
  }
  return parts.join("");
}

/** The scenes of an input file, all of them. rules: the limits that the page holds. */
export function readScenes(text, rules) {
  const scenes = [];
  for (const scene of new Reader(text, rules).file()) if (scene) scenes.push(scene);
  return scenes;
}

/** Read a file in turns, so that the page stays alive: calls found(scene, offset, line) for each.
 *
 * pause: an async function that is awaited between turns, with the share that was read.
 */
export async function readInTurns(text, rules, found, pause) {
  const reader = new Reader(text, rules);
  for (const scene of reader.file()) {
    if (scene) found(scene, reader.sceneAt, reader.sceneLine);
    else await pause(reader.at / text.length);
  }
}

/** One scene that begins at an offset of a text, on a line: of a file that was read before. */
export function readSceneAt(text, rules, offset, line) {
  const reader = new Reader(text, rules);
  reader.at = offset;
  reader.line = line;
  let scene = null;
  for (const part of reader.scenario()) scene = part ?? scene;
  return scene;
}

/** The input of one scene, without the number of scenarios. */
export function sceneText({ robot, move, obstacles }) {
  const lines = [`${robot.length} ${obstacles.length}`, move.join(" ")];
  const add = (polygon) => polygon.forEach((point) => lines.push(point.join(" ")));
  add(robot);
  for (const obstacle of obstacles) {
    lines.push(`${obstacle.length}`);
    add(obstacle);
  }
  return `${lines.join("\n")}\n`;
}

/** A recursive descent over the grammar. Generators yield each scene, and null for a turn's end. */
class Reader {
  constructor(text, rules) {
    this.text = text;
    this.rules = rules;
    this.at = 0;
    this.line = 0;
    this.turnAt = LINES_A_TURN;
    this.vertices = 0;
    this.sceneAt = 0;
    this.sceneLine = 0;
  }

  *file() {
    const count = this.single("t", 1, this.rules.max_scenarios, "");
    for (let number = 0; number < count; number += 1) {
      this.sceneAt = this.at;
      this.sceneLine = this.line;
      yield* this.scenario();
    }
    const extra = this.next();
    if (extra) this.fail(`expected the end of the file, found ${shown(extra)}`);
  }

  *scenario() {
    const { min_polygon_vertices: fewest, max_vertices: most, max_coordinate: far } = this.rules;
    const [m, k] = this.pair("m k", "");
    this.range(m, "m", fewest, most, "");
    this.range(k, "k", 0, Math.floor(most / fewest), "");
    this.count(m);
    const move = this.pair("dx dy", "");
    this.range(move[0], "dx", -2 * far, 2 * far, "");
    this.range(move[1], "dy", -2 * far, 2 * far, "");
    const robot = yield* this.polygon("robot", m, move);
    const obstacles = [];
    for (let number = 1; number <= k; number += 1) {
      const name = `obstacle ${number}`;
      const n = this.single("n", fewest, most, `${name}, `);
      this.count(n);
      obstacles.push(yield* this.polygon(name, n, [0, 0]));
    }
    yield { robot, move, obstacles };
  }

  count(vertices) {
    this.vertices += vertices;
    const most = this.rules.max_vertices;
    if (this.vertices <= most) return;
    this.fail(`vertices: expected at most ${most} in the file, found ${this.vertices} up to here`);
  }

  *polygon(name, n, move) {
    const firstLine = this.line + 1;
    const most = this.rules.max_coordinate;
    const vertices = [];
    for (let index = 1; index <= n; index += 1) {
      const where = `${name}, vertex ${index}: `;
      const vertex = this.pair(null, where);
      ["x", "y"].forEach((axis, i) => {
        this.range(vertex[i], axis, -most, most, where);
        this.range(vertex[i] + move[i], `${axis} at the end of the move`, -most, most, where);
      });
      vertices.push(vertex);
      if (this.line < this.turnAt) continue;
      this.turnAt = this.line + LINES_A_TURN;
      yield null;
    }
    const fault = convexityFault(vertices);
    if (fault) {
      const mark = fault.reason.startsWith("vertex") ? "," : ":";
      throw new InputError(firstLine + fault.vertex, `${name}${mark} ${fault.reason}`);
    }
    return vertices;
  }

  /** The next line with its end, at most LINE_BYTES of it; "" at the end of the text. */
  next() {
    const end = this.text.indexOf("\n", this.at) + 1 || this.text.length;
    const line = this.text.slice(this.at, Math.min(end, this.at + LINE_BYTES));
    this.at += line.length;
    this.line += 1;
    return line;
  }

  single(name, low, high, where) {
    const line = this.next();
    const match = SINGLE.exec(line);
    if (!match) this.fail(`${where}${name}: ${fault(line, 1)}`);
    const value = integer(match[1]);
    this.range(value, name, low, high, where);
    return value;
  }

  pair(name, where) {
    const line = this.next();
    const match = PAIR.exec(line);
    if (!match) this.fail(`${where}${name === null ? "" : `${name}: `}${fault(line, 2)}`);
    return [integer(match[1]), integer(match[2])];
  }

  /** Hold a value to its limits. Only a Number is within them. */
  range(value, name, low, high, where) {
    if (value >= low && value <= high) return;
    this.fail(`${where}${name}: expected ${low}..${high}, found ${value}`);
  }

  fail(why) {
    throw new InputError(this.line, why);
  }
}

/** The integer that some digits stand for: a Number, or a BigInt where that would be rounded. */
function integer(digits) {
  const value = Number(digits);
  return Number.isSafeInteger(value) ? value : BigInt(digits);
}

/** What is wrong with a line that should be `count` integers. */
function fault(line, count) {
  const wanted = count === 1 ? "one integer" : "two integers and one space between";
  if (!line) return `expected ${wanted}, found the end of the file`;
  if (!line.endsWith("\n")) {
    if (line.length >= LINE_BYTES) {
      return `expected ${wanted}, found a line that begins ${shown(line)}`;
    }
    return `expected a line end after ${shown(line)}, found the end of the file`;
  }
  const body = line.slice(0, -1);
  if (body.endsWith("\r")) return "expected the line to end in \\n, found \\r\\n";
  if (/^[ \t-\r]|[ \t-\r]$| {2}/.test(body)) {
    return `expected ${wanted}, found a blank too much in ${shown(body)}`;
  }
  const tokens = body.split(" ");
  if (tokens.length !== count || body === "") return `expected ${wanted}, found ${shown(body)}`;
  const bad = tokens.find((token) => !NUMBER.test(token));
  return `expected an integer of at most 18 digits, no leading zero, no plus, found ${shown(bad)}`;
}

/** The head of some text, printable and quoted. */
function shown(text) {
  const head = text.slice(0, SHOWN_BYTES);
  const quote = head.includes("'") && !head.includes('"') ? '"' : "'";
  const names = { "\n": "\\n", "\r": "\\r", "\t": "\\t", "\\": "\\\\", [quote]: `\\${quote}` };
  const printed = head.replace(/[^ -~]|\\|['"]/g, (character) => {
    const code = character.charCodeAt(0).toString(16).padStart(2, "0");
    return names[character] ?? (/[ -~]/.test(character) ? character : `\\x${code}`);
  });
  return `${quote}${printed}${quote}${text.length > SHOWN_BYTES ? "..." : ""}`;
}
