// The merge, step by step: both lists of edges by polar angle, the comparison, the growing sum.

import { pointText } from "../exact/reason.js";
import { paintDial } from "./dial.js";

const WINDOW = 14; // chips of a row that are shown; of longer lists, those around the pointer

export function paintMerge(root, sum, step) {
  const { a, b, steps } = sum;
  const now = steps[step] ?? { i: a.edges.length, j: b.edges.length };
  row(root.querySelector("#row-a"), a.edges, now.i, now.takesA, "a");
  row(root.querySelector("#row-b"), b.edges, now.j, now.takesB, "b");
  const done = steps.map(({ edge, takesA, takesB }) => ({
    edge,
    look: takesA && takesB ? "a b" : takesA ? "a" : "b",
  }));
  sumRow(root.querySelector("#row-sum"), done, step);
  paintDial(root.querySelector("#dial"), sum, step);
  root.querySelector("#step-text").textContent = stepText(sum, step);
}

/** One sentence on what this step does, and why. */
export function stepText({ a, b, steps }, step) {
  if (step >= steps.length) {
    const [n, m, total] = [a.edges.length, b.edges.length, steps.length];
    const joined = n + m - total;
    const why = joined ? `; ${joined === 1 ? "one pair" : `${joined} pairs`} of equal direction joined` : "";
    return `Done: ${n} + ${m} edges were merged into ${total}${why}. The polygon closes.`;
  }
  const { i, j, turn, takesA, takesB } = steps[step];
  const [nameA, nameB] = [`a${sub(i + 1)}`, `b${sub(j + 1)}`];
  if (turn === null) {
    return takesA
      ? `B is used up: take ${nameA} = ${pointText(a.edges[i])}.`
      : `A is used up: take ${nameB} = ${pointText(b.edges[j])}.`;
  }
  const [[ax, ay], [bx, by]] = [a.edges[i], b.edges[j]].map((edge) => edge.map(factor));
  const product = `${nameA} × ${nameB} = ${ax}·${by} − ${ay}·${bx} = ${turn}`;
  if (takesA && takesB) return `${product}: the same direction, so both together make one edge.`;
  return takesA
    ? `${product} > 0: ${nameA} comes first by angle, so take it.`
    : `${product} < 0: ${nameB} comes first by angle, so take it.`;
}

const factor = (value) => (value < 0 ? `(${value})` : `${value}`);
const sub = (number) => `${number}`.replace(/\d/g, (digit) => "₀₁₂₃₄₅₆₇₈₉"[digit]);

function row(list, edges, pointer, isTaken, name) {
  const from = windowStart(edges.length, pointer);
  const chips = edges.slice(from, from + WINDOW).map((edge, offset) => {
    const index = from + offset;
    const state = index < pointer ? "done" : index === pointer ? (isTaken ? "now taken" : "now") : "";
    return chip(`${name}${sub(index + 1)}`, edge, `${name} ${state}`, index === pointer);
  });
  fill(list, chips, from, edges.length);
}

function sumRow(list, done, step) {
  const from = windowStart(done.length, step - 1);
  const chips = done
    .slice(from, from + WINDOW)
    .map(({ edge, look }, offset) => {
      const index = from + offset;
      return index < step ? chip("", edge, look, false) : chip("", null, "empty", false);
    });
  fill(list, chips, from, done.length);
}

function fill(list, chips, from, total) {
  const more = (count) => (count > 0 ? [moreItem(`+ ${count}`)] : []);
  list.replaceChildren(...more(from), ...chips, ...more(total - from - WINDOW));
}

const windowStart = (total, pointer) =>
  Math.max(0, Math.min(pointer - Math.floor(WINDOW / 2), total - WINDOW));

function moreItem(text) {
  const item = document.createElement("li");
  item.className = "more";
  item.textContent = text;
  return item;
}

/** An edge as an arrow in its direction, with its name and its vector. */
function chip(name, edge, look, isCurrent) {
  const item = document.createElement("li");
  item.className = `chip ${look}`;
  if (isCurrent) item.setAttribute("aria-current", "step");
  if (edge === null) {
    item.setAttribute("aria-hidden", "true");
    return item;
  }
  const arrow = document.createElement("span");
  arrow.className = "direction";
  arrow.setAttribute("aria-hidden", "true");
  arrow.style.transform = `rotate(${-Math.atan2(edge[1], edge[0])}rad)`;
  const label = document.createElement("span");
  label.textContent = name ? `${name} ${pointText(edge)}` : pointText(edge);
  item.append(arrow, label);
  return item;
}
