// What views on a canvas have in common: size, buttons and keys that zoom, the picture of it.
//
//   class View extends CanvasView               has heightFor(width), paint(), zoomBy(factor, px, py),
//                                               showAll() and keys(): {key: action}, the arrows
//     super(host, {label, kind, step, all, tools})
//                                               kind: class of its frame; step: of the zoom by buttons
//                                               and keys; all: what the last button shows; tools: the row
//                                               that the buttons join, else one of their own above it
//     this.begin()                              when there is all that paint() needs
//   view.draw()                                 paint() at the next frame of the screen
//   view.cleared(colour) -> context             to paint on
//   view.own(event) -> [px, py]                 of a pointer over it
//   view.toBlob() -> PNG of what is shown

import { element, onTheme, paintSoon } from "./dom.js";

export class CanvasView {
  constructor(host, { label, kind, step, all, tools }) {
    Object.assign(this, { step, zoom: 1, pending: false });
    this.canvas = element("canvas", { role: "img", "aria-label": label, tabindex: 0, "data-keys": true });
    const button = (text, title, action) =>
      element("button", { type: "button", title, "aria-label": title, onclick: action }, text);
    const zoom = element("div", { class: "zoom" }, button("+", "Zoom in", () => this.zoomBy(step)),
                         button("−", "Zoom out", () => this.zoomBy(1 / step)), button("⤢", all, () => this.showAll()));
    this.frame = element("div", { class: kind }, this.canvas);
    host.append(this.frame);
    if (tools) tools.append(zoom);
    else host.prepend(zoom);
  }

  begin() {
    this.canvas.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && document.activeElement !== this.canvas) return;
      event.preventDefault();
      this.zoomBy(1.002 ** -event.deltaY, ...this.own(event));
    }, { passive: false });
    this.canvas.addEventListener("keydown", (event) => {
      const larger = () => this.zoomBy(this.step), smaller = () => this.zoomBy(1 / this.step);
      const keys = { "+": larger, "=": larger, "-": smaller, 0: () => this.showAll(), ...this.keys() };
      if (!(event.key in keys) || event.ctrlKey || event.metaKey) return;
      keys[event.key]();
      event.preventDefault();
    });
    onTheme(() => this.draw());
    new ResizeObserver(() => this.resize()).observe(this.frame);
    this.resize();
  }

  resize() {
    const width = this.frame.clientWidth;
    if (width === 0) return;
    const height = Math.round(this.heightFor(width)), density = Math.min(devicePixelRatio || 1, 2);
    if (this.width === width && this.height === height && this.density === density) return;
    Object.assign(this, { width, height, density });
    this.canvas.width = Math.round(width * density);
    this.canvas.height = Math.round(height * density);
    this.canvas.style.height = `${height}px`;
    this.draw();
  }

  draw() {
    paintSoon(this);
  }

  cleared(colour) {
    const context = this.canvas.getContext("2d");
    context.setTransform(this.density, 0, 0, this.density, 0, 0);
    context.fillStyle = colour;
    context.fillRect(0, 0, this.width, this.height);
    context.lineJoin = context.lineCap = "round";
    return context;
  }

  own({ clientX, clientY }) {
    const { left, top } = this.canvas.getBoundingClientRect();
    return [clientX - left, clientY - top];
  }

  toBlob() {
    this.paint();
    return new Promise((done) => this.canvas.toBlob(done, "image/png"));
  }
}
