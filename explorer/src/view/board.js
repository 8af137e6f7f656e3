// A board: an SVG that shows a part of the plane with a grid, and is panned and zoomed by pointer,
// Ctrl and wheel, pinch, keys and buttons.

import { Layer } from "./layer.js";
import { Viewport } from "./viewport.js";

const WHEEL_SPEED = 0.01;
const WHEEL_MAX = 30; // a mouse turns in large steps, a pinch on a trackpad in small ones
const KEY_FACTOR = 1.25;
const DIGIT_PX = 6.7;

export class Board {
  /** svg: the element. layers: names from back to front. redraw: called when the view changed.
   *
   * press(point, event): asked at each press; it may return a function that takes each further
   * pointer event until the release, so that what is under the pointer is dragged, not the board.
   */
  constructor(svg, layers, redraw, press = () => null) {
    this.svg = svg;
    this.view = new Viewport();
    this.redraw = redraw;
    this.press = press;
    this.isOwnView = false; // the user panned or zoomed; fitting stops
    this.grid = new Layer(svg);
    this.layers = Object.fromEntries(layers.map((name) => [name, new Layer(svg)]));
    this.numbers = new Layer(svg);
    this.pointers = new Map();
    this.drag = null;
    this.held = null; // where the board was when the first pointer went down
    new ResizeObserver(() => this.resize()).observe(svg);
    this.resize();
    this.listen();
  }

  resize() {
    const { width, height } = this.svg.getBoundingClientRect();
    if (!width || !height) return;
    const { view } = this;
    const ratio = Math.min(width / view.width, height / view.height);
    if (view.width !== width || view.height !== height) view.scale *= ratio;
    Object.assign(view, { width, height });
    this.redraw();
  }

  /** Show a box, unless the user chose the view or it is good enough (and not forced). */
  fit(box, force = false) {
    if (force) this.isOwnView = false;
    if (force || !(this.isOwnView || this.view.isGoodFor(box))) this.view.fit(box);
  }

  zoom(factor, pixel = [this.view.width / 2, this.view.height / 2]) {
    this.isOwnView = true;
    this.view.zoom(factor, pixel);
    this.redraw();
  }

  /** Draw with all layers; paint(layers) puts the elements. */
  paint(paint) {
    const all = [this.grid, ...Object.values(this.layers), this.numbers];
    all.forEach((layer) => layer.begin());
    this.paintGrid();
    paint(this.layers);
    all.forEach((layer) => layer.end());
  }

  paintGrid() {
    const { view, grid, numbers } = this;
    const [left, top] = view.toWorld([0, 0]);
    const [right, bottom] = view.toWorld([view.width, view.height]);
    const digits = numberText(Math.round(Math.max(Math.abs(left), Math.abs(right)))).length + 1;
    const half = (digits * DIGIT_PX) / 2 + 2;
    const step = view.gridStep(18);
    const xStep = labelStep(view, step, digits * DIGIT_PX + 10);
    const yStep = labelStep(view, step, 30);
    for (let x = Math.ceil(left / step) * step; x <= right; x += step) {
      const [px] = view.toScreen([x, 0]);
      grid.line(`x${x}`, [[px, 0], [px, view.height]], { class: x ? "grid" : "axis" });
      if (x % xStep === 0 && px > half && px < view.width - half) {
        const at = { x: px, y: view.height - 5, class: "number", "text-anchor": "middle" };
        numbers.put("text", `x${x}`, at, numberText(x));
      }
    }
    for (let y = Math.ceil(bottom / step) * step; y <= top; y += step) {
      const [, py] = view.toScreen([0, y]);
      grid.line(`y${y}`, [[0, py], [view.width, py]], { class: y ? "grid" : "axis" });
      if (y % yStep === 0 && py > 10 && py < view.height - 20) {
        numbers.put("text", `y${y}`, { x: 5, y: py + 3.5, class: "number" }, numberText(y));
      }
    }
  }

  pixelOf(event) {
    const { left, top } = this.held ?? this.svg.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }

  listen() {
    const { svg } = this;
    svg.addEventListener("pointerdown", (event) => this.down(event));
    svg.addEventListener("pointermove", (event) => this.moved(event));
    for (const end of ["pointerup", "pointercancel"]) {
      svg.addEventListener(end, (event) => this.up(event));
    }
    // A finger that drags a part, or pinches, does not scroll the page. (pointerdown comes first.)
    svg.addEventListener(
      "touchstart",
      (event) => {
        if (this.drag || event.touches.length > 1) event.preventDefault();
      },
      { passive: false },
    );
    svg.addEventListener(
      "wheel",
      (event) => {
        if (!event.ctrlKey && !event.metaKey) return; // the wheel alone scrolls the page
        event.preventDefault();
        const turn = Math.min(Math.max(event.deltaY, -WHEEL_MAX), WHEEL_MAX);
        this.zoom(Math.exp(-turn * WHEEL_SPEED), this.pixelOf(event));
      },
      { passive: false },
    );
    svg.addEventListener("keydown", (event) => {
      const factor = { "+": KEY_FACTOR, "=": KEY_FACTOR, "-": 1 / KEY_FACTOR }[event.key];
      if (!factor || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      this.zoom(factor);
    });
  }

  down(event) {
    if (event.button) return;
    // What is dragged stays under the pointer, even if text above grows and the board moves.
    this.held ??= this.svg.getBoundingClientRect();
    const pixel = this.pixelOf(event);
    if (this.pointers.size === 0) {
      this.leader = event.pointerId; // it drags; other fingers do not
      this.drag = this.press(pixel, event);
    }
    if (this.pointers.size === 1 && !this.drag) this.isOwnView = true; // a pinch begins
    this.pointers.set(event.pointerId, pixel);
    this.svg.setPointerCapture(event.pointerId);
  }

  moved(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const pixel = this.pixelOf(event);
    if (this.drag) {
      if (event.pointerId === this.leader) this.drag(event, pixel);
    } else if (this.pointers.size === 1) {
      this.isOwnView = true;
      this.view.pan(pixel[0] - before[0], pixel[1] - before[1]);
      this.redraw();
    } else {
      this.pinch(event.pointerId, before, pixel);
    }
    this.pointers.set(event.pointerId, pixel);
  }

  pinch(id, before, pixel) {
    const [, other] = [...this.pointers].find(([key]) => key !== id);
    const distance = ([x, y]) => Math.hypot(x - other[0], y - other[1]);
    this.zoom(distance(pixel) / Math.max(distance(before), 1), other);
  }

  up(event) {
    if (!this.pointers.delete(event.pointerId)) return;
    if (this.drag && event.pointerId === this.leader) {
      if (event.type === "pointerup") this.drag(event, this.pixelOf(event));
      this.drag = null;
    }
    if (!this.pointers.size) this.held = null;
    this.redraw();
  }
}

/** A multiple of the grid's step at which numbers of this width fit beside each other. */
function labelStep(view, step, pixels) {
  return [1, 2, 5, 10, 20, 50, 100].map((n) => n * step).find((s) => s * view.scale >= pixels) ?? step * 200;
}

/** 100 000 000: with narrow blanks between thousands, and a real minus. */
export const numberText = (value) =>
  `${Math.abs(value)}`.replace(/\B(?=(\d{3})+$)/g, "\u202f").replace(/^/, value < 0 ? "−" : "");
