// A scene in the address: #scene=4,2/12,4/... is its input, with "," for blanks and "/" for line
// ends; #gallery=NAME opens a scene of the gallery.

import { InputError, readScenes, sceneText } from "./parse.js";

export const LINK_CHARACTERS_MAX = 8_000; // what mail and chat programs pass on

/** The scene as the part of an address after "#"; null if it would be too long to pass on. */
export function linkOf(scene) {
  const text = sceneText(scene).trimEnd().replaceAll(" ", ",").replaceAll("\n", "/");
  return text.length > LINK_CHARACTERS_MAX ? null : `scene=${text}`;
}

/** What an address asks for: {}, {gallery: name}, {scene} or {fault: one sentence}. */
export function readLink(hash, rules) {
  const [key, value] = split(decode(hash.replace(/^#/, "")));
  if (key === "") return {};
  if (key === "gallery") return { gallery: value };
  if (key !== "scene") {
    return { fault: `The link says “${key.slice(0, 24)}”; expected scene=… or gallery=….` };
  }
  try {
    const [scene] = readScenes(`1\n${value.replaceAll(",", " ").replaceAll("/", "\n")}\n`, rules);
    return { scene };
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    // The link leaves out the first line of a file.
    return { fault: `The link is damaged, in line ${error.line - 1}: ${error.reason}` };
  }
}

function split(text) {
  const at = text.indexOf("=");
  return at < 0 ? [text, ""] : [text.slice(0, at), text.slice(at + 1)];
}

function decode(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text; // a lone % is no code
  }
}
