// Where the plane is on the screen: scale, fitting, grid steps, and clipping for drawing.
// Floating-point numbers are used here only: nothing is decided by what is drawn.

const FIT_MARGIN = 0.1; // of the board, on each side
const SCALE_MIN = 1e-7; // pixels for one unit
const SCALE_MAX = 200;
const FAR = 4_000; // pixels beyond the board at which a path is cut off
const OUTSIDE = [-FAR, -FAR];
const FULLNESS_MIN = 0.35; // below this share of the board, a fit is worth it

/** A board of width x height pixels that shows the plane around [x, y], with y upwards. */
export class Viewport {
  constructor() {
    this.width = 400;
    this.height = 300;
    this.x = 0;
    this.y = 0;
    this.scale = 20;
  }

  toScreen([x, y]) {
    return [
      (x - this.x) * this.scale + this.width / 2,
      (this.y - y) * this.scale + this.height / 2,
    ];
  }

  toWorld([left, top]) {
    return [
      (left - this.width / 2) / this.scale + this.x,
      (this.height / 2 - top) / this.scale + this.y,
    ];
  }

  fit(box) {
    const [left, bottom, right, top] = box;
    this.x = (left + right) / 2;
    this.y = (bottom + top) / 2;
    this.scale = this.scaleFor(box);
  }

  /** The scale at which a box fits on the board, with a margin. */
  scaleFor([left, bottom, right, top]) {
    const room = 1 - 2 * FIT_MARGIN;
    const wide = (this.width * room) / Math.max(right - left, 1);
    const high = (this.height * room) / Math.max(top - bottom, 1);
    return bounded(Math.min(wide, high));
  }

  /** Whether a box is all on the board. */
  holds([left, bottom, right, top]) {
    const [west, south] = this.toScreen([left, bottom]);
    const [east, north] = this.toScreen([right, top]);
    return west >= 0 && north >= 0 && east <= this.width && south <= this.height;
  }

  /** Whether a box is all on the board and fills enough of it. */
  isGoodFor(box) {
    const [left, bottom, right, top] = box;
    const wide = ((right - left) * this.scale) / this.width;
    const high = ((top - bottom) * this.scale) / this.height;
    return this.holds(box) && Math.max(wide, high) >= FULLNESS_MIN;
  }

  pan(right, down) {
    this.x -= right / this.scale;
    this.y += down / this.scale;
  }

  /** Zoom by a factor; the point of the plane under this pixel stays there. */
  zoom(factor, pixel) {
    const [x, y] = this.toWorld(pixel);
    this.scale = bounded(this.scale * factor);
    const [left, top] = this.toScreen([x, y]);
    this.pan(pixel[0] - left, pixel[1] - top);
  }

  /** Numbers 1, 2 or 5 times a power of ten, so that lines are at least this far apart. */
  gridStep(pixels) {
    const least = Math.max(1, pixels / this.scale);
    const power = 10 ** Math.floor(Math.log10(least));
    return [1, 2, 5, 10].map((n) => Math.round(n * power)).find((step) => step >= least * 0.999);
  }

  /** The SVG path of a polygon or, if not closed, of a chain of points. */
  path(points, closed = true) {
    let pixels = points.map((point) => this.toScreen(point));
    const limits = [-FAR, -FAR, this.width + FAR, this.height + FAR];
    if (closed && pixels.some(([x, y]) => isFar(x, y, limits))) pixels = clipped(pixels, limits);
    const parts = pixels.map(([x, y], i) => `${i ? "L" : "M"}${x.toFixed(2)} ${y.toFixed(2)}`);
    return parts.join("") + (closed && parts.length ? "Z" : "");
  }

  /** Both ends, in pixels, of the part of a line near the board; the line need not cross it. */
  line(through, along) {
    const [x, y] = this.toScreen(through);
    const size = Math.hypot(...along);
    const [right, down] = [along[0] / size, -along[1] / size];
    const nearest = (this.width / 2 - x) * right + (this.height / 2 - y) * down;
    const reach = this.width + this.height;
    return [nearest - reach, nearest + reach].map((t) => [x + t * right, y + t * down]);
  }

  /** Both ends of an edge, cut off far outside of the board.
   *
   * An edge that is wholly far away becomes a point: such coordinates would disturb the dashes of
   * the others in its path.
   */
  segment(from, to) {
    const [[x, y], [endX, endY]] = [this.toScreen(from), this.toScreen(to)];
    const reach = FAR + this.width + this.height;
    const [right, down] = [endX - x, endY - y];
    const size = Math.hypot(right, down);
    if (size < reach) return [[x, y], [endX, endY]];
    const middle = ((this.width / 2 - x) * right + (this.height / 2 - y) * down) / size ** 2;
    const at = (t) => [x + t * right, y + t * down];
    const [nearX, nearY] = at(Math.min(Math.max(middle, 0), 1));
    if (Math.hypot(nearX - this.width / 2, nearY - this.height / 2) > reach) return [OUTSIDE, OUTSIDE];
    return [at(Math.max(0, middle - reach / size)), at(Math.min(1, middle + reach / size))];
  }
}

const bounded = (scale) => Math.min(Math.max(scale, SCALE_MIN), SCALE_MAX);
const isFar = (x, y, [left, top, right, bottom]) => x < left || x > right || y < top || y > bottom;

/** A convex polygon cut to a box, by Sutherland and Hodgman. */
function clipped(polygon, [left, top, right, bottom]) {
  const sides = [
    ([x]) => x - left,
    ([x]) => right - x,
    ([, y]) => y - top,
    ([, y]) => bottom - y,
  ];
  return sides.reduce((points, inside) => {
    const kept = [];
    points.forEach((to, i) => {
      const from = points.at(i - 1);
      const [a, b] = [inside(from), inside(to)];
      if (a < 0 !== b < 0) kept.push([0, 1].map((k) => from[k] + ((to[k] - from[k]) * a) / (a - b)));
      if (b >= 0) kept.push(to);
    });
    return kept;
  }, polygon);
}
