// Solids in space on a canvas, to be turned.
//
//   view = new SpaceView(host, {label, low: [x, y, z], high: [x, y, z], tools})
//   view.faces = [{points: [[x, y, z]...], colour: [r, g, b], opacity}]   convex, flat
//   view.lines = [{points, colour: "css", width}]
//   view.dots  = [{at, colour: "css", radius}]
//   view.onHover = (x, y) => ...    pixels of a pointer over it that does not turn it; null when it is gone
//   view.look()([x, y, z])          -> [x, y, depth] pixels of a point
//   view.draw()
//   solidFaces(solid) -> [[x, y, z]...] faces of {shape, size, radius, length, triangles} in its frame
//   moved(pose, point)   pose: 12 numbers, the rows of a 3 x 4 matrix
//
// Drag turns, so do the arrow keys; + and - zoom, 0 shows it as at first. z is up.

import { CanvasView } from "./canvas_view.js";
import { themeColour } from "./dom.js";

export function moved(pose, [x, y, z]) {
  return [0, 4, 8].map((row) => pose[row] * x + pose[row + 1] * y + pose[row + 2] * z + pose[row + 3]);
}

function boxFaces([x, y, z]) {
  const corner = (i) => [(i & 1 ? 0.5 : -0.5) * x, (i & 2 ? 0.5 : -0.5) * y, (i & 4 ? 0.5 : -0.5) * z];
  return [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]].map((f) => f.map(corner));
}

/** Around the z axis: rings of [radius, height], from below to above. */
function turnedFaces(rings, sides) {
  const point = ([radius, height], i) => {
    const angle = (2 * Math.PI * i) / sides;
    return [radius * Math.cos(angle), radius * Math.sin(angle), height];
  };
  const faces = [];
  for (let k = 1; k < rings.length; ++k)
    for (let i = 0; i < sides; ++i) {
      const face = [point(rings[k - 1], i), point(rings[k - 1], i + 1), point(rings[k], i + 1), point(rings[k], i)];
      if (rings[k - 1][0] === 0) face.splice(1, 1);
      if (rings[k][0] === 0) face.pop();
      faces.push(face);
    }
  for (const [ring, flip] of [[rings[0], true], [rings.at(-1), false]])
    if (ring[0] > 0) {
      const lid = Array.from({ length: sides }, (_, i) => point(ring, flip ? -i : i));
      faces.push(lid);
    }
  return faces;
}

/** Two half spheres, the upper one `length` above the lower. */
function capsuleRings(radius, length) {
  const rings = [], parts = 4;
  for (let i = 0; i <= parts; ++i) {
    const angle = (0.5 * Math.PI * i) / parts;
    rings.push([radius * Math.sin(angle), -radius * Math.cos(angle)]);
  }
  for (let i = 0; i <= parts; ++i) {
    const angle = (0.5 * Math.PI * i) / parts;
    rings.push([radius * Math.cos(angle), length + radius * Math.sin(angle)]);
  }
  rings[0][0] = rings.at(-1)[0] = 0;
  return rings;
}

/** From the z axis to a direction, as a function of points. */
function alongAxis([x, y, z]) {
  const length = Math.hypot(x, y, z);
  if (length === 0) return (p) => p;
  const w = [x / length, y / length, z / length];
  const helper = Math.abs(w[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const raw = cross(helper, w), size = Math.hypot(...raw), u = raw.map((v) => v / size), v = cross(w, u);
  return (p) => [0, 1, 2].map((i) => p[0] * u[i] + p[1] * v[i] + p[2] * w[i]);
}

export function solidFaces({ shape, size, radius, length, triangles }) {
  if (shape === "box") return boxFaces(size);
  if (shape === "sphere") return turnedFaces(capsuleRings(radius, 0).filter((_, i) => i !== 5), 14);
  if (shape === "cylinder") return turnedFaces([[radius, -0.5 * length], [radius, 0.5 * length]], 18);
  if (shape === "capsule") {
    const turn = alongAxis(size);
    return turnedFaces(capsuleRings(radius, Math.hypot(...size)), 14).map((face) => face.map(turn));
  }
  const faces = [];
  for (let i = 0; i + 9 <= triangles.length; i += 9)
    faces.push([0, 3, 6].map((k) => [triangles[i + k], triangles[i + k + 1], triangles[i + k + 2]]));
  return faces;
}

export class SpaceView extends CanvasView {
  constructor(host, { label, low, high, tools }) {
    super(host, { label, kind: "map space", step: 1.25, all: "As at first", tools });
    Object.assign(this, { faces: [], lines: [], dots: [] });
    this.middle = [0, 1, 2].map((i) => 0.5 * (low[i] + high[i]));
    this.reach = 0.5 * Math.hypot(...[0, 1, 2].map((i) => high[i] - low[i])) || 1;
    this.showAll();
    this.listen();
    this.begin();
  }

  showAll() {
    Object.assign(this, { turn: -0.9, tilt: 0.45, zoom: 1 });
    this.draw();
  }

  zoomBy(factor) {
    this.zoom = Math.min(Math.max(this.zoom * factor, 0.3), 12);
    this.draw();
  }

  turnBy(turn, tilt) {
    this.turn += turn;
    this.tilt = Math.min(Math.max(this.tilt + tilt, -1.5), 1.5);
    this.draw();
  }

  heightFor(width) {
    return Math.min(0.75 * width, Math.max(280, 0.7 * innerHeight));
  }

  /** Right, up and away from the viewer. */
  look() {
    const [ct, st, ce, se] = [Math.cos(this.turn), Math.sin(this.turn), Math.cos(this.tilt), Math.sin(this.tilt)];
    const far = 4 * this.reach, pixels = (0.5 * Math.min(this.width, this.height) * this.zoom) / this.reach;
    return ([x, y, z]) => {
      const dx = x - this.middle[0], dy = y - this.middle[1], dz = z - this.middle[2];
      const right = -st * dx + ct * dy, towards = ct * dx + st * dy;
      const up = ce * dz - se * towards, near = se * dz + ce * towards, size = (pixels * far) / Math.max(far - near, 0.1 * far);
      return [0.5 * this.width + size * right, 0.5 * this.height - size * up, near];
    };
  }

  paint() {
    const context = this.cleared(themeColour("--free")), look = this.look();
    const items = [];
    for (const { points, colour, opacity = 1 } of this.faces) {
      const flat = points.map(look);
      let area = 0, depth = 0;
      flat.forEach(([x, y, z], i) => {
        const [nx, ny] = flat[(i + 1) % flat.length];
        area += x * ny - nx * y;
        depth += z / flat.length;
      });
      if (Math.abs(area) > 0.05) items.push({ depth, flat, paint: () => this.paintFace(context, points, flat, colour, opacity) });
    }
    for (const { points, colour, width } of this.lines)
      for (let i = 1; i < points.length; ++i) {
        const a = look(points[i - 1]), b = look(points[i]);
        items.push({ depth: 0.5 * (a[2] + b[2]) + 0.02 * this.reach, paint: () => {
          context.beginPath();
          context.moveTo(a[0], a[1]);
          context.lineTo(b[0], b[1]);
          Object.assign(context, { strokeStyle: colour, lineWidth: width });
          context.stroke();
        } });
      }
    for (const { at, colour, radius } of this.dots) {
      const [x, y, depth] = look(at);
      items.push({ depth: depth + 0.03 * this.reach, paint: () => {
        context.beginPath();
        context.arc(x, y, radius, 0, 2 * Math.PI);
        Object.assign(context, { fillStyle: colour, strokeStyle: themeColour("--mark-rim"), lineWidth: 1.5 });
        context.fill();
        context.stroke();
      } });
    }
    items.sort((a, b) => a.depth - b.depth);
    for (const item of items) item.paint();
  }

  paintFace(context, points, flat, colour, opacity) {
    const [a, b, c] = points;
    const u = [0, 1, 2].map((i) => b[i] - a[i]), v = [0, 1, 2].map((i) => c[i] - a[i]);
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const size = Math.hypot(...normal) || 1;
    const light = 0.62 + 0.38 * Math.abs((0.35 * normal[0] - 0.45 * normal[1] + 0.82 * normal[2]) / size);
    const shaded = colour.map((value) => Math.round(value * light));
    context.beginPath();
    for (const [x, y] of flat) context.lineTo(x, y);
    context.closePath();
    context.fillStyle = `rgb(${shaded.join(" ")} / ${opacity})`;
    context.fill();
    if (opacity < 1) return;
    // Closes the hairlines between faces.
    Object.assign(context, { strokeStyle: context.fillStyle, lineWidth: 0.6 });
    context.stroke();
  }

  keys() {
    return { ArrowLeft: () => this.turnBy(-0.1, 0), ArrowRight: () => this.turnBy(0.1, 0),
             ArrowUp: () => this.turnBy(0, 0.1), ArrowDown: () => this.turnBy(0, -0.1) };
  }

  listen() {
    let before = null;
    this.canvas.addEventListener("pointerdown", (event) => {
      before = [event.clientX, event.clientY];
      this.canvas.setPointerCapture(event.pointerId);
    });
    for (const end of ["pointerup", "pointercancel"]) this.canvas.addEventListener(end, () => (before = null));
    this.canvas.addEventListener("pointermove", (event) => {
      if (!before) return this.onHover?.(...this.own(event));
      this.turnBy(-0.008 * (event.clientX - before[0]), 0.008 * (event.clientY - before[1]));
      before = [event.clientX, event.clientY];
    });
    this.canvas.addEventListener("pointerleave", () => this.onHover?.(null, null));
  }
}
