// What a reader learns who points at a path: place, length up to it, clearance.
//
//   hover = new PathHover(points, {name, place(at), length(value), clearance(found) or null})
//   found = hover.near(x, y, reach)     {at, length, segment}, or null
//   hover.text(found)

import { cumulated, nearestOn } from "./walk.js";

export class PathHover {
  constructor(path, { name, place, length, clearance = null }) {
    Object.assign(this, { path, name, place, lengthText: length, clearance, sums: cumulated(path) });
  }

  near(x, y, reach) {
    const found = nearestOn(this.path, this.sums, x, y);
    return found.distance <= reach ? found : null;
  }

  text(found) {
    const total = this.lengthText(this.sums.at(-1) ?? 0);
    const text = `On the ${this.name}: ${this.place(found.at)} · ${this.lengthText(found.length)} of ${total}`;
    return this.clearance ? `${text} · clearance ${this.clearance(found)}` : text;
  }
}
