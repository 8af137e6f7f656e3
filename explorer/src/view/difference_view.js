// The Minkowski difference: obstacle + (-sweep), its edges in the two colours, and the origin.

import { boxOf, translated } from "../exact/geometry.js";
import { toNumber } from "../exact/contact.js";

export const DIFFERENCE_LAYERS = ["areas", "edges", "marks"];

export const differenceBox = ({ vertices }) => boxOf([...vertices, [0, 0]]);

/** state.sum: the difference that is shown, null if there is no obstacle. state.standing: that of
 * the obstacle and the robot at its start, moved by the slider.
 */
export function paintDifference(board, state) {
  const { sum, standing, scene, moment, step } = state;
  board.paint(({ areas, edges, marks }) => {
    const { view } = board;
    if (sum) {
      const look = state.place === "outside" ? "difference" : "difference hit";
      areas.put("path", "sum", { d: view.path(sum.vertices), class: look });
      const back = scene.move.map((delta) => -delta * toNumber(moment));
      const there = translated(standing.vertices, back);
      const touch = state.touches[state.shown] ? "standing hit" : "standing";
      areas.put("path", "standing", { d: view.path(there), class: touch });
      paintEdges(edges, view, sum, step);
      if (state.line) paintSupport(edges, view, sum.steps[state.line.step]);
    }
    paintOrigin(marks, view, state.place);
  });
}

/** All edges of one look are one path, so that thousands of edges stay fast. */
function paintEdges(edges, view, { steps }, step) {
  const paths = new Map();
  steps.forEach(({ edge, at, takesA, takesB }, index) => {
    const [from, to] = view.segment(at, [at[0] + edge[0], at[1] + edge[1]]);
    const line = `M${from}L${to}`;
    const look = index < step ? "done" : index === step ? "now" : "later";
    if (takesA) paths.set(`a ${look}`, (paths.get(`a ${look}`) ?? "") + line);
    if (takesB) paths.set(`b ${look}`, (paths.get(`b ${look}`) ?? "") + line);
  });
  for (const look of [...paths.keys()].sort()) {
    edges.put("path", look, { d: paths.get(look), class: `edge ${look}` });
  }
  if (step >= steps.length) return;
  const [cx, cy] = view.toScreen(steps[step].at);
  edges.put("circle", "pen", { cx, cy, r: 4.5, class: "pen" });
}

/** The edge with the origin on its outer side, as a line. */
function paintSupport(edges, view, { edge, at }) {
  edges.line("separating", view.line(at, edge), { class: "separating" });
}

function paintOrigin(marks, view, place) {
  const [x, y] = view.toScreen([0, 0]);
  const look = place === "outside" || place === null ? "origin" : "origin hit";
  marks.put("circle", "disc", { cx: x, cy: y, r: 8, class: look });
  marks.put("path", "cross", { d: `M${x - 13} ${y}H${x + 13}M${x} ${y - 13}V${y + 13}`, class: look });
  const left = x > view.width - 80;
  const at = { x: x + (left ? -14 : 14), y: y - 12, "text-anchor": left ? "end" : "start" };
  marks.put("text", "origin", { ...at, class: look }, "origin");
}
