// Where scenes come from: the samples and the gallery in the page, an input file, the address.

import { bytesToText, readInTurns, readScenes, readSceneAt } from "../exact/parse.js";
import { readLink } from "../exact/link.js";

const FILE_BYTES_MAX = 16_000_000; // the largest valid input has 12 MB
export const SCENE_VERTICES_MAX = 4_000; // what a page can draw and judge while one drags
export const SCENE_WORK_MAX = 400_000; // k * m

/** A text of the page's own fields: as bytes, and with the line end that fields forget. */
export function fieldText(text) {
  const bytes = new TextEncoder().encode(text.endsWith("\n") ? text : `${text}\n`);
  return bytesToText(bytes);
}

/** Why a scene is too large for the page; null if it is not. */
export function tooLarge(vertices, work) {
  if (vertices > SCENE_VERTICES_MAX) {
    return `has ${count(vertices)} vertices; this page shows scenes of up to ${count(SCENE_VERTICES_MAX)}`;
  }
  if (work > SCENE_WORK_MAX) {
    return `has k · m = ${count(work)}; this page shows scenes of up to ${count(SCENE_WORK_MAX)}`;
  }
  return null;
}

const count = (number) => number.toLocaleString("en");

export const sizeOf = ({ robot, obstacles }) =>
  robot.length + obstacles.reduce((sum, obstacle) => sum + obstacle.length, 0);

export const workOf = ({ robot, obstacles }) => robot.length * obstacles.length;

/** An input file whose scenarios are read again when they are wanted. */
export class InputFile {
  constructor(name, text, rules) {
    Object.assign(this, { name, text, rules, index: [] });
  }

  get length() {
    return this.index.length;
  }

  /** Read all of it once, in turns. Raises InputError; returns null if another file came first. */
  async read(isWanted, progress) {
    await readInTurns(
      this.text,
      this.rules,
      (scene, offset, line) =>
        this.index.push({ offset, line, vertices: sizeOf(scene), work: workOf(scene) }),
      async (share) => {
        progress(share);
        await new Promise((resolve) => setTimeout(resolve));
      },
    );
    return isWanted() ? this : null;
  }

  /** {scene} or {fault} of the scenario with this number, from 1. */
  scenario(number) {
    const { offset, line, vertices, work } = this.index[number - 1];
    const why = tooLarge(vertices, work);
    if (why) {
      const command = `python -m pictures show ${this.name} ${number}`;
      return { fault: `Scenario ${number} ${why}. The kit draws it: ${command}` };
    }
    return { scene: readSceneAt(this.text, this.rules, offset, line) };
  }
}

/** The bytes of a file as text, or a fault. */
export async function loadFile(file) {
  if (file.size > FILE_BYTES_MAX) {
    return { fault: `${file.name} has ${count(file.size)} bytes, more than any valid input.` };
  }
  return { text: bytesToText(new Uint8Array(await file.arrayBuffer())) };
}

/** A scene that the page holds, by name: {entry, scene}; null if there is none. */
export function stored(data, name) {
  const entry = data.scenes.find((one) => one.name === name);
  return entry ? { entry, scene: readScenes(`1\n${entry.input}`, data.rules)[0] } : null;
}

/** What the address asks for: {name}, {scene} or {fault}; {} if nothing. */
export function fromAddress(hash, data) {
  const asked = readLink(hash, data.rules);
  if (asked.gallery !== undefined) {
    if (data.scenes.some(({ name }) => name === asked.gallery)) return { name: asked.gallery };
    return { fault: `There is no scene “${asked.gallery.slice(0, 40)}” in the gallery.` };
  }
  if (!asked.scene) return asked;
  const why = tooLarge(sizeOf(asked.scene), workOf(asked.scene));
  return why ? { fault: `The scene of the link ${why}.` } : asked;
}
