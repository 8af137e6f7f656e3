// What stands around the boards: the answer, the moment, the steps, the obstacle's chooser.

import { fractionText, toNumber } from "../exact/contact.js";
import { nearPlace } from "./scene_view.js";
import { POSITIONS } from "../control/session.js";

const MOMENT_CHARACTERS = 9; // a longer fraction is shown rounded
const OPTIONS_MAX = 500; // obstacles in the chooser

export const byId = (id) => document.getElementById(id);

/** The scenes that the page holds, in groups. */
export function fillChooser(select, scenes) {
  const own = new Option("your own scene", "");
  own.hidden = true;
  select.append(own);
  for (const group of new Set(scenes.map((scene) => scene.group))) {
    const element = document.createElement("optgroup");
    element.label = group;
    for (const { name, title } of scenes.filter((scene) => scene.group === group)) {
      element.append(new Option(title, name));
    }
    select.append(element);
  }
}

export function paintControls(session, why) {
  const { scene, verdict, selected } = session;
  byId("answer").textContent = verdict.answer;
  byId("result").className = verdict.answer === "YES" ? "yes" : "no";
  byId("reason").textContent = why;
  paintMomentControls(session);
  const [near, origin] = document.querySelectorAll("[data-zoom=near]");
  near.textContent = verdict.first ? "Contact" : "Gap";
  origin.textContent = "Origin";
  near.disabled = origin.disabled = nearPlace(session) === null;
  byId("step").max = session.steps;
  byId("step").value = session.step;
  byId("step-number").textContent = `${session.step} of ${session.steps}`;
  byId("step-first").disabled = byId("step-back").disabled = session.step === 0;
  byId("step-on").disabled = byId("step-last").disabled = session.step === session.steps;
  byId("undo").disabled = !session.history.length;
  byId("remove-obstacle").disabled = !scene.obstacles.length;
  byId("remove-corner").disabled = (selected?.vertex ?? null) === null;
  byId("difference-text").textContent = placeText(session);
  byId("line-key").hidden = !session.line;
  paintChoice(session);
}

function paintMomentControls({ scene, verdict, moment, position, touches }) {
  byId("moment").value = position;
  byId("first").disabled = verdict.first === null;
  const exact = fractionText(moment);
  const isSliders = POSITIONS % Number(moment.under) === 0;
  const rounded = `${isSliders ? "" : "≈ "}${Number(toNumber(moment).toFixed(4))}`;
  const share = isSliders || exact.length > MOMENT_CHARACTERS ? rounded : exact;
  const hit = touches.flatMap((touch, index) => (touch ? [index + 1] : []));
  const names = hit.length > 3 ? `${hit.length} obstacles` : `obstacle ${hit.join(", ")}`;
  const when = { 0: "at the start", 1: "at the end" }[share] ?? `after ${share} of the move`;
  const what = !hit.length ? "free" : scene.obstacles.length === 1 ? "touching" : `touching ${names}`;
  byId("moment-text").textContent = `${when}: ${what}`;
  byId("moment").setAttribute("aria-valuetext", byId("moment-text").textContent);
  byId("moment-text").className = hit.length ? "no" : "";
}

/** Where the origin is, and what follows. */
function placeText({ place }) {
  switch (place) {
    case "inside":
      return "The origin is inside: some point of the sweep is a point of the obstacle.";
    case "boundary":
      return "The origin is on the boundary: they touch without overlapping.";
    case "outside":
      return "The origin is outside: no point of the sweep is a point of the obstacle.";
    default:
      return "There is no obstacle, so there is no difference.";
  }
}

/** Which obstacle's difference is shown. */
function paintChoice({ scene, verdict, shown }) {
  const select = byId("shown");
  const count = Math.min(scene.obstacles.length, OPTIONS_MAX);
  select.hidden = scene.obstacles.length < 2;
  while (select.options.length > count) select.remove(select.options.length - 1);
  while (select.options.length < count) select.append(new Option());
  for (let index = 0; index < count; index += 1) {
    const label = `obstacle ${index + 1}: ${verdict.places[index] === "outside" ? "free" : "hit"}`;
    const option = select.options[index];
    if (option.text !== label) option.text = label;
    option.value = index;
  }
  select.value = shown;
}
