// The page: wires what is shown, its controls, and where scenes come from.

import { firstContact, fractionText, momentOf, stateAt } from "./exact/contact.js";
import { convexityFault, minkowskiSum } from "./exact/geometry.js";
import { linkOf } from "./exact/link.js";
import { bytesToText, InputError, readScenes, sceneText } from "./exact/parse.js";
import { judge, reason } from "./exact/reason.js";
import {
  deleteCorner,
  deleteObstacle,
  editByKey,
  focusSelected,
  insertCorner,
  insertObstacle,
  startDrag,
} from "./control/edit.js";
import {
  fieldText,
  fromAddress,
  InputFile,
  loadFile,
  sizeOf,
  stored,
  tooLarge,
  workOf,
} from "./control/library.js";
import { POSITIONS, Session } from "./control/session.js";
import { Board } from "./view/board.js";
import { DIFFERENCE_LAYERS, paintDifference } from "./view/difference_view.js";
import { paintMerge } from "./view/merge_view.js";
import { paintScene, partOf, SCENE_LAYERS } from "./view/scene_view.js";
import { byId, fillChooser, paintControls } from "./view/panels.js";
import { Sight } from "./view/sight.js";

const PLAY_MS = 2500;
const SPEAK_AFTER_MS = 500; // when nothing changed for so long
const ADDRESS_AFTER_MS = 300;
const NOTE_MS = 4000;
const BUTTON_ZOOM = 1.5;

const data = JSON.parse(byId("data").textContent);
const { rules } = data;

let source = { name: null, file: null, number: 0 }; // where the scene came from
let isDrawing = false;
let isEdited = false;
const timers = {};

function later(name, action, milliseconds) {
  clearTimeout(timers[name]);
  timers[name] = setTimeout(action, milliseconds);
}

/** Tell the user something, until it is dismissed or, for a note, for a short time. */
function say(text, isNote = false) {
  byId("message").querySelector("span").textContent = text;
  byId("message").hidden = !text;
  clearTimeout(timers.note);
  if (isNote) later("note", () => say(""), NOTE_MS);
}
const note = (text) => say(text, true);

// Drawing: once for each frame, whatever changed before it.

function redraw() {
  if (isDrawing || !session) return;
  isDrawing = true;
  requestAnimationFrame(() => {
    isDrawing = false;
    draw();
  });
}

function draw() {
  for (const sight of Object.values(sights)) sight.follow(session);
  const focused = document.activeElement;
  paintScene(sceneBoard, session);
  paintDifference(differenceBoard, session);
  if (focused !== document.activeElement && focused.isConnected) focused.focus();
  byId("merge").hidden = !session.sum;
  if (session.sum) paintMerge(byId("merge"), session.sum, session.step);
  const why = reason(session.scene, session.verdict, session.shown, session.line);
  paintControls(session, why);
  const { answer } = session.verdict;
  later("spoken", () => (byId("spoken").textContent = `${answer}. ${why}`), SPEAK_AFTER_MS);
}

function changed(isOtherScene) {
  if (isOtherScene && session) {
    isEdited = true;
    if (document.activeElement !== byId("text")) showText();
    later("address", showAddress, ADDRESS_AFTER_MS);
    byId("lesson").classList.add("past");
  }
  redraw();
}

function showText() {
  byId("text").value = `1\n${sceneText(session.scene)}`;
  byId("text-fault").textContent = "";
}

/** The address always leads back to what is shown, if it is short enough for an address. */
function showAddress() {
  clearTimeout(timers.address);
  const isStored = source.name !== null && !isEdited;
  const link = isStored ? `gallery=${encodeURIComponent(source.name)}` : linkOf(session.scene);
  history.replaceState(null, "", link === null ? " " : `#${link}`);
}

// Opening

function show(scene, from) {
  source = { name: null, file: null, number: 0, ...from };
  session.open(scene);
  isEdited = false;
  const entry = data.scenes.find(({ name }) => name === source.name);
  byId("lesson").classList.remove("past");
  byId("lesson").textContent = entry ? data.sentences[entry.sentence] : "";
  byId("scenes").options[0].text = source.file?.name ?? "your own scene";
  byId("scenes").value = source.name ?? "";
  byId("scenario-chooser").hidden = !source.file;
  byId("scenario").value = source.number;
  if (source.file) {
    byId("scenario").max = source.file.length;
    byId("scenario-count").textContent = source.file.length.toLocaleString("en");
  }
  say("");
  for (const sight of Object.values(sights)) sight.open(session);
  showText();
  showAddress();
  redraw();
}

const showStored = (name) => show(stored(data, name).scene, { name });

function showScenario(file, number) {
  const { scene, fault } = file.scenario(number);
  if (scene) {
    show(scene, { file, number });
    return;
  }
  source = { ...source, file, number };
  byId("scenario-chooser").hidden = false;
  byId("scenario").value = number;
  byId("scenario-count").textContent = file.length.toLocaleString("en");
  say(`${fault} — the scene below is another one.`);
}

let wanted = 0; // the number of the file that was asked for last

async function openText(name, text) {
  const number = ++wanted;
  try {
    const file = await new InputFile(name, text, rules).read(
      () => number === wanted,
      (share) => number === wanted && say(`Reading ${name}: ${Math.round(100 * share)} %`),
    );
    if (!file) return;
    say("");
    showScenario(file, 1);
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    if (number === wanted) say(`${name}, line ${error.line}: ${error.reason}`);
  }
}

async function openFile(file) {
  const { text, fault } = await loadFile(file);
  if (fault) say(fault);
  else await openText(file.name, text);
}

function openAddress(hash) {
  const { name, scene, fault } = fromAddress(hash, data);
  if (scene) show(scene, {});
  else showStored(name ?? data.first);
  if (fault) say(fault);
}

/** The scene before or after this one: of the file, if one is open. */
function turn(by) {
  if (source.file) {
    const number = source.number + by;
    if (number >= 1 && number <= source.file.length) showScenario(source.file, number);
    return;
  }
  const names = data.scenes.map(({ name }) => name);
  const at = names.indexOf(source.name);
  showStored(names.at((at + by + names.length) % names.length));
}

// The input as text

function readText() {
  try {
    const text = fieldText(byId("text").value);
    const scenes = readScenes(text, rules);
    if (scenes.length > 1) {
      openText("the pasted text", text);
      return;
    }
    const why = tooLarge(sizeOf(scenes[0]), workOf(scenes[0]));
    byId("text-fault").textContent = why ? `The scene ${why}.` : "";
    if (!why) session.edit(scenes[0]);
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    byId("text-fault").textContent = error.message.replace(/^l/, "L");
  }
}

async function copy(text, done) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const field = document.createElement("textarea"); // where the clipboard may not be used
    field.value = text;
    document.body.append(field);
    field.select();
    document.execCommand("copy");
    field.remove();
  }
  note(done);
}

function copyLink() {
  const link = linkOf(session.scene);
  if (link === null) {
    say("The scene is too large for a link. Copy its input instead.");
    return;
  }
  copy(`${location.href.replace(/#.*/, "")}#${link}`, "The link is copied. It opens this scene.");
}

// The move

let playing = 0;

function stopPlaying() {
  cancelAnimationFrame(playing);
  playing = 0;
  byId("play").textContent = "▶";
}

function play() {
  if (playing) {
    stopPlaying();
    return;
  }
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
    session.goTo(momentOf(session.position === POSITIONS ? 0 : POSITIONS, POSITIONS));
    return;
  }
  const start = session.position === POSITIONS ? 0 : session.position;
  let begun = null;
  const frame = (now) => {
    begun ??= now;
    const position = Math.min(POSITIONS, start + Math.round(((now - begun) / PLAY_MS) * POSITIONS));
    session.goTo(momentOf(position, POSITIONS));
    if (position < POSITIONS) playing = requestAnimationFrame(frame);
    else stopPlaying();
  };
  byId("play").textContent = "⏸";
  playing = requestAnimationFrame(frame);
}

// Wiring

const on = (id, type, action) => byId(id).addEventListener(type, action);

let session = null;
const sceneBoard = new Board(byId("scene"), SCENE_LAYERS, redraw, (pixel, event) => {
  stopPlaying();
  const drag = startDrag(sceneBoard, session, rules, pixel, event);
  if (drag) requestAnimationFrame(() => focusSelected(byId("scene"), session));
  return drag;
});
const differenceBoard = new Board(byId("difference"), DIFFERENCE_LAYERS, redraw);
const sights = {
  scene: new Sight("scene", sceneBoard, byId("scene-note")),
  difference: new Sight("difference", differenceBoard, byId("difference-note")),
};

fillChooser(byId("scenes"), data.scenes);
session = new Session(stored(data, data.first).scene, changed);
openAddress(location.hash);

addEventListener("hashchange", ({ newURL }) => openAddress(new URL(newURL).hash));
on("scenes", "change", () => byId("scenes").value && showStored(byId("scenes").value));
on("previous", "click", () => turn(-1));
on("next", "click", () => turn(1));
on("open", "click", () => byId("file").click());
on("file", "change", () => {
  const [file] = byId("file").files;
  if (file) openFile(file);
  byId("file").value = "";
});
on("scenario", "change", () => {
  const number = Number(byId("scenario").value);
  if (Number.isInteger(number) && number >= 1 && number <= source.file.length) {
    showScenario(source.file, number);
  } else {
    say(`There is no scenario ${byId("scenario").value}; the file has ${source.file.length}.`);
  }
});
on("close", "click", () => showStored(data.first));
byId("message").querySelector("button").addEventListener("click", () => say(""));
addEventListener("dragover", (event) => event.preventDefault());
addEventListener("drop", (event) => {
  event.preventDefault();
  const [file] = event.dataTransfer.files;
  if (file) openFile(file);
});

on("moment", "input", () => {
  stopPlaying();
  session.goTo(momentOf(Number(byId("moment").value), POSITIONS));
});
on("play", "click", play);
on("first", "click", () => {
  stopPlaying();
  session.goTo(session.verdict.first.moment);
});
on("shown", "change", () => session.choose(Number(byId("shown").value)));
on("step", "input", () => session.goToStep(Number(byId("step").value)));
on("step-first", "click", () => session.goToStep(0));
on("step-back", "click", () => session.goToStep(session.step - 1));
on("step-on", "click", () => session.goToStep(session.step + 1));
on("step-last", "click", () => session.goToStep(session.steps));

on("undo", "click", () => session.undo());
on("add-corner", "click", () => insertCorner(session, rules, note));
on("remove-corner", "click", () => deleteCorner(session, rules, note));
on("add-obstacle", "click", () => insertObstacle(session, rules, sceneBoard));
on("remove-obstacle", "click", () => deleteObstacle(session));
on("copy", "click", () => copy(`1\n${sceneText(session.scene)}`, "The input is copied."));
on("link", "click", copyLink);
on("text", "input", readText);

for (const group of document.querySelectorAll(".zoom")) {
  const sight = sights[group.dataset.board];
  const actions = {
    in: () => sight.board.zoom(BUTTON_ZOOM),
    out: () => sight.board.zoom(1 / BUTTON_ZOOM),
    fit: () => sight.showWhole(session),
    near: () => sight.showNear(session),
  };
  group.addEventListener("click", (event) => actions[event.target.dataset.zoom]?.());
  sight.note.addEventListener("click", actions.fit);
}
addEventListener("keydown", (event) => {
  const { key, target, ctrlKey, metaKey, altKey } = event;
  const action = { 0: "showWhole", 1: "showNear" }[key];
  if (!action || ctrlKey || metaKey || altKey || target.closest?.("input, select, textarea")) return;
  for (const sight of Object.values(sights)) sight[action](session);
});
on("scene", "focusin", (event) => {
  const key = event.target.dataset.part;
  if (key && !sceneBoard.drag) session.select(partOf(key));
});
on("scene", "keydown", (event) => {
  const key = event.target.dataset.part;
  if (!key || !editByKey(session, rules, partOf(key), event, note)) return;
  event.preventDefault();
  requestAnimationFrame(() => focusSelected(byId("scene"), session));
});
addEventListener("keydown", (event) => {
  const isUndo = (event.ctrlKey || event.metaKey) && event.key === "z" && !event.shiftKey;
  if (!isUndo || event.target === byId("text")) return;
  event.preventDefault();
  session.undo();
});

/** A file is given as a string of its bytes. */
function faultOf(bytes) {
  try {
    readScenes(bytesToText(Uint8Array.from(bytes, (byte) => byte.charCodeAt(0))), rules);
    return null;
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    return { line: error.line, reason: error.reason };
  }
}

// For tests, and for whoever wants to compare: what the page computes, without its views.
window.collisionCourse = {
  /** The answers of all scenarios of an input file. Raises InputError. */
  answers: (text) => readScenes(text, rules).map((scene) => judge(scene).answer),
  /** The line and the reason of the first fault of each file, null if it is valid. */
  faults: (files) => files.map(faultOf),
  /** For each obstacle of each scenario: [moment, state then] of the first contact, or null. */
  contacts: (text) =>
    readScenes(text, rules).map((scene) =>
      scene.obstacles.map((obstacle) => {
        const contact = firstContact(scene, obstacle);
        return contact && [fractionText(contact.moment), stateAt(scene, obstacle, contact.moment)];
      }),
    ),
  /** The vertices of the sums of pairs of polygons. */
  sums: (pairs) => pairs.map(([a, b]) => minkowskiSum(a, b).vertices),
  /** Which of some polygons are convex. */
  convex: (polygons) => polygons.map((polygon) => convexityFault(polygon) === null),
  get scene() {
    return session.scene;
  },
};
