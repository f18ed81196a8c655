// A plane with layers on a canvas: zoom, drag, hover.
//
//   view = new MapView(host, {low: [x, y], high: [x, y], up, label, tools, onHover})
//     low, high     corners of what is shown, in the world's coordinates
//     up            true: y grows upwards (polygon worlds); else downwards (bitmaps)
//     tools         the row that the buttons join which zoom
//     onHover(x, y) the pointer's place in the world, null where it left
//   view.layers = [(context, view) => ...]     drawn in order by view.draw()
//   view.at(x, y) -> [px, py]; view.place(px, py) -> [x, y]; view.scale: pixels a unit
//   view.line(context, points, colour, width); view.disc(...); view.image(context, canvas, x, y, width, height)
//
// Keys with the focus on it: + and - zoom, arrows move, 0 shows all.

import { CanvasView } from "./canvas_view.js";
import { themeColour } from "./dom.js";
import { arcAngles } from "./walk.js";

export class MapView extends CanvasView {
  constructor(host, { low, high, up = false, label, tools, onHover = () => {} }) {
    super(host, { label, kind: "map", step: 1.5, all: "Show all", tools });
    Object.assign(this, { low, high, up, onHover, layers: [] });
    this.middle = [0, 1].map((axis) => 0.5 * (low[axis] + high[axis]));
    this.listen();
    this.begin();
  }

  heightFor(width) {
    const aspect = (this.high[1] - this.low[1]) / (this.high[0] - this.low[0]);
    return Math.min(width * aspect, Math.max(260, 0.72 * innerHeight));
  }

  get scale() {
    const fit = Math.min(this.width / (this.high[0] - this.low[0]), this.height / (this.high[1] - this.low[1]));
    return fit * this.zoom;
  }

  at(x, y) {
    const s = this.scale;
    return [0.5 * this.width + s * (x - this.middle[0]),
            0.5 * this.height + s * (this.up ? this.middle[1] - y : y - this.middle[1])];
  }

  place(px, py) {
    const s = this.scale, dy = (py - 0.5 * this.height) / s;
    return [this.middle[0] + (px - 0.5 * this.width) / s, this.middle[1] + (this.up ? -dy : dy)];
  }

  zoomBy(factor, px = 0.5 * this.width, py = 0.5 * this.height) {
    const fixed = this.place(px, py);
    this.zoom = Math.min(Math.max(this.zoom * factor, 1), 64);
    const moved = this.place(px, py);
    this.middle = this.middle.map((value, axis) => value + fixed[axis] - moved[axis]);
    this.keepInside();
  }

  moveBy(dx, dy) {
    const s = this.scale;
    this.middle = [this.middle[0] - dx / s, this.middle[1] + ((this.up ? 1 : -1) * dy) / s];
    this.keepInside();
  }

  showAll() {
    this.zoom = 1;
    this.keepInside();
  }

  keepInside() {
    const s = this.scale, sides = [this.width, this.height];
    this.middle = this.middle.map((value, axis) => {
      const half = (0.5 * sides[axis]) / s, low = this.low[axis] + half, high = this.high[axis] - half;
      return low > high ? 0.5 * (this.low[axis] + this.high[axis]) : Math.min(Math.max(value, low), high);
    });
    this.draw();
  }

  paint() {
    const context = this.cleared(themeColour("--outside"));
    for (const layer of this.layers) layer(context, this);
  }

  image(context, image, x, y, width, height, smooth = false) {
    const [left, top] = this.at(x, this.up ? y + height : y);
    context.imageSmoothingEnabled = smooth;
    context.drawImage(image, left, top, width * this.scale, height * this.scale);
  }

  /** Points and, between two of them, perhaps an arc, as a result's curve has it. */
  trace(context, points) {
    context.beginPath();
    points.forEach((point, i) => {
      if (Array.isArray(point)) return context.lineTo(...this.at(...point));
      const { centre, radius, turn } = point, [from, to] = arcAngles(points, i);
      context.arc(...this.at(...centre), radius * this.scale, from, to, turn < 0);
    });
  }

  line(context, points, colour, width, dashes = []) {
    if (points.length < 2) return;
    this.trace(context, points);
    context.setLineDash(dashes);
    context.lineWidth = width;
    context.strokeStyle = colour;
    context.stroke();
    context.setLineDash([]);
  }

  disc(context, [x, y], radius, fill, rim = null) {
    context.beginPath();
    context.arc(...this.at(x, y), radius, 0, 2 * Math.PI);
    context.fillStyle = fill;
    context.fill();
    if (!rim) return;
    context.lineWidth = 2;
    context.strokeStyle = rim;
    context.stroke();
  }

  /** Start as a ring, goal as a diamond. */
  ends(context, start, goal) {
    const rim = themeColour("--mark-rim");
    if (goal) {
      const [x, y] = this.at(...goal);
      context.beginPath();
      for (const [dx, dy] of [[0, -9], [9, 0], [0, 9], [-9, 0]]) context.lineTo(x + dx, y + dy);
      context.closePath();
      Object.assign(context, { fillStyle: themeColour("--goal"), strokeStyle: rim, lineWidth: 2 });
      context.fill();
      context.stroke();
    }
    if (start) this.disc(context, start, 7, themeColour("--start"), rim);
  }

  /** Nothing can be moved while all is shown. */
  keys() {
    const far = 60;
    if (this.zoom === 1) return {};
    return { ArrowLeft: () => this.moveBy(far, 0), ArrowRight: () => this.moveBy(-far, 0),
             ArrowUp: () => this.moveBy(0, far), ArrowDown: () => this.moveBy(0, -far) };
  }

  listen() {
    const canvas = this.canvas;
    const pointers = new Map();
    canvas.addEventListener("pointerdown", (event) => {
      pointers.set(event.pointerId, this.own(event));
      if (this.zoom > 1) canvas.setPointerCapture(event.pointerId);
    });
    for (const end of ["pointerup", "pointercancel", "pointerleave"])
      canvas.addEventListener(end, (event) => {
        pointers.delete(event.pointerId);
        if (end === "pointerleave") this.onHover(null, null);
      });
    canvas.addEventListener("pointermove", (event) => {
      const now = this.own(event), before = pointers.get(event.pointerId);
      if (before && this.zoom > 1) this.moveBy(now[0] - before[0], now[1] - before[1]);
      if (before) pointers.set(event.pointerId, now);
      this.onHover(...this.place(...now));
    });
    canvas.addEventListener("dblclick", (event) => this.zoomBy(2, ...this.own(event)));
  }
}
