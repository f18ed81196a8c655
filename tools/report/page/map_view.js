// A plane with layers on a canvas: zoom, drag, hover.
//
//   view = new MapView(host, {low: [x, y], high: [x, y], up, label, onHover})
//     low, high     corners of what is shown, in the world's coordinates
//     up            true: y grows upwards (polygon worlds); else downwards (bitmaps)
//     onHover(x, y) the pointer's place in the world, null where it left
//   view.layers = [(context, view) => ...]     drawn in order by view.draw()
//   view.at(x, y) -> [px, py]; view.place(px, py) -> [x, y]; view.scale: pixels a unit
//   view.line(context, points, colour, width); view.disc(...); view.image(context, canvas, x, y, width, height)
//   view.toBlob() -> PNG of what is shown
//
// Keys with the focus on it: + and - zoom, arrows move, 0 shows all.

import { element, onTheme, paintSoon, themeColour } from "./dom.js";

export class MapView {
  constructor(host, { low, high, up = false, label, onHover = () => {} }) {
    Object.assign(this, { low, high, up, onHover, layers: [], zoom: 1, pending: false });
    this.middle = [0, 1].map((axis) => 0.5 * (low[axis] + high[axis]));
    this.canvas = element("canvas", { role: "img", "aria-label": label, tabindex: 0, "data-keys": true });
    const button = (text, title, action) =>
      element("button", { type: "button", title, "aria-label": title, onclick: action }, text);
    this.frame = element("div", { class: "map" }, this.canvas,
                         element("div", { class: "zoom" }, button("+", "Zoom in", () => this.zoomBy(1.5)),
                                 button("−", "Zoom out", () => this.zoomBy(1 / 1.5)),
                                 button("⤢", "Show all", () => this.showAll())));
    host.append(this.frame);
    this.listen();
    onTheme(() => this.draw());
    new ResizeObserver(() => this.resize()).observe(this.frame);
    this.resize();
  }

  resize() {
    const width = this.frame.clientWidth;
    if (width === 0) return;
    const aspect = (this.high[1] - this.low[1]) / (this.high[0] - this.low[0]);
    const height = Math.round(Math.min(width * aspect, Math.max(260, 0.72 * innerHeight)));
    const density = Math.min(devicePixelRatio || 1, 2);
    if (this.width === width && this.height === height && this.density === density) return;
    Object.assign(this, { width, height, density });
    this.canvas.width = Math.round(width * density);
    this.canvas.height = Math.round(height * density);
    this.canvas.style.height = `${height}px`;
    this.draw();
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

  draw() {
    paintSoon(this);
  }

  paint() {
    const context = this.canvas.getContext("2d");
    context.setTransform(this.density, 0, 0, this.density, 0, 0);
    context.fillStyle = themeColour("--outside");
    context.fillRect(0, 0, this.width, this.height);
    context.lineJoin = context.lineCap = "round";
    for (const layer of this.layers) layer(context, this);
  }

  image(context, image, x, y, width, height, smooth = false) {
    const [left, top] = this.at(x, this.up ? y + height : y);
    context.imageSmoothingEnabled = smooth;
    context.drawImage(image, left, top, width * this.scale, height * this.scale);
  }

  trace(context, points) {
    context.beginPath();
    for (const [x, y] of points) context.lineTo(...this.at(x, y));
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

  toBlob() {
    this.paint();
    return new Promise((done) => this.canvas.toBlob(done, "image/png"));
  }

  listen() {
    const canvas = this.canvas;
    const pointers = new Map();
    const own = (event) => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    canvas.addEventListener("pointerdown", (event) => {
      pointers.set(event.pointerId, own(event));
      if (this.zoom > 1) canvas.setPointerCapture(event.pointerId);
    });
    for (const end of ["pointerup", "pointercancel", "pointerleave"])
      canvas.addEventListener(end, (event) => {
        pointers.delete(event.pointerId);
        if (end === "pointerleave") this.onHover(null, null);
      });
    canvas.addEventListener("pointermove", (event) => {
      const now = own(event), before = pointers.get(event.pointerId);
      if (before && this.zoom > 1) this.moveBy(now[0] - before[0], now[1] - before[1]);
      if (before) pointers.set(event.pointerId, now);
      this.onHover(...this.place(...now));
    });
    canvas.addEventListener("dblclick", (event) => this.zoomBy(2, ...own(event)));
    canvas.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && document.activeElement !== canvas) return;
      event.preventDefault();
      this.zoomBy(1.002 ** -event.deltaY, ...own(event));
    }, { passive: false });
    canvas.addEventListener("keydown", (event) => {
      const far = 60, keys = {
        "+": () => this.zoomBy(1.5), "=": () => this.zoomBy(1.5), "-": () => this.zoomBy(1 / 1.5),
        0: () => this.showAll(), ArrowLeft: () => this.moveBy(far, 0), ArrowRight: () => this.moveBy(-far, 0),
        ArrowUp: () => this.moveBy(0, far), ArrowDown: () => this.moveBy(0, -far) };
      if (!(event.key in keys) || event.ctrlKey || event.metaKey) return;
      if (this.zoom === 1 && event.key.startsWith("Arrow")) return;
      keys[event.key]();
      event.preventDefault();
    });
  }
}
