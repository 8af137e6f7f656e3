// A dial: every edge of both polygons as a ray from one centre, and how far the merge has turned.

import { Layer } from "./layer.js";

const RAYS_MAX = 120; // of both polygons; with more, the dial would be a disc
const RADIUS = 56;
const LENGTHS = { a: 42, b: 54 }; // so that edges of one direction are both seen

const dials = new WeakMap();

const angleOf = ([x, y]) => (Math.atan2(y, x) + 2 * Math.PI) % (2 * Math.PI);
const onCircle = (angle, radius) => [radius * Math.cos(angle), -radius * Math.sin(angle)];

export function paintDial(svg, { a, b, steps }, step) {
  if (!dials.has(svg)) dials.set(svg, new Layer(svg));
  const layer = dials.get(svg);
  const isDisc = a.edges.length + b.edges.length > RAYS_MAX;
  svg.classList.toggle("none", isDisc);
  if (isDisc) return;
  const now = steps[step] ?? { i: a.edges.length, j: b.edges.length };
  layer.begin();
  layer.put("circle", "circle", { r: RADIUS, class: "circle" });
  const angle = now.edge ? angleOf(now.edge) : 2 * Math.PI;
  if (now.edge) layer.put("path", "turned", { d: sector(angle), class: "turned" });
  else layer.put("circle", "turned all", { r: RADIUS, class: "turned" });
  const rays = (name, { edges }, pointer) =>
    edges.forEach((edge, index) => {
      const end = onCircle(angleOf(edge), LENGTHS[name]);
      const look = index < pointer ? "done" : index === pointer ? "now" : "";
      layer.line(`${name}${index}`, [[0, 0], end], { class: `ray ${name} ${look}` });
    });
  rays("a", a, now.i);
  rays("b", b, now.j);
  layer.end();
}

/** The part of the disc from angle 0 on, counter-clockwise. */
function sector(angle) {
  const large = angle > Math.PI ? 1 : 0;
  return `M0 0L${RADIUS} 0A${RADIUS} ${RADIUS} 0 ${large} 0 ${onCircle(angle, RADIUS).join(" ")}Z`;
}
