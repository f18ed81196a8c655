// The map, what the colony does on it, and the player over its iterations.
//
//   stage = new Stage(card, {onCells, onStart, onGoal, onFrame})
//     onCells(), onStart(cell), onGoal(cell)   the user changed the map (cells are changed already)
//     onFrame(frame)                           another frame is shown, or null
//   stage.setMap(map, start, goal)             {width, height, cells}: another map
//   stage.setEnds(start, goal)
//   stage.beginRun({index, iterations, most}); stage.addFrame(frame); stage.endRun()
//     index: the trail is a terminal index; a frame is that of tools/playground/binding.cpp
//   stage.showPath(path), stage.showExact(path)   [[x, y], ...], or null
//
// While a run is under way the player follows it, until it is paused or moved by hand.

import { Drawing } from "./drawing.js";
import { channels, element, numberText, onTheme, themeColour } from "./dom.js";
import { pictureButton } from "./files.js";
import { HeatMap, codesOf, heatLegend, rampOf, trailRange } from "./heat_map.js";
import { MapView } from "./map_view.js";
import { Player } from "./player.js";
import { checkBox, choices, swatches } from "./sheet.js";

const kSampled = 40;  // frames that the colours of a run are taken from

/** Sets the red, green, blue and alpha of blocked cells. */
class Walls {
  constructor({ width, height, cells }) {
    this.image = element("canvas", { width, height });
    this.context = this.image.getContext("2d");
    this.pixels = this.context.createImageData(width, height);
    Object.assign(this, { cells, width });
    this.paintAll();
  }

  paintAll() {
    const [red, green, blue] = channels(themeColour("--wall"));
    for (let i = 0; i < this.cells.length; ++i) this.pixels.data.set([red, green, blue, this.cells[i] ? 255 : 0], 4 * i);
    this.context.putImageData(this.pixels, 0, 0);
  }

  paint(cells) {
    this.context.fillStyle = themeColour("--wall");
    for (const [x, y] of cells) {
      this.context.clearRect(x, y, 1, 1);
      if (this.cells[y * this.width + x]) this.context.fillRect(x, y, 1, 1);
    }
  }
}

/** From 0 for what is linear; else six decades below the most at most, as in reports. */
class Scale {
  constructor(name, logarithmic) {
    Object.assign(this, { name, logarithmic, least: logarithmic ? Infinity : 0, most: 0 });
  }

  include(values) {
    for (const value of values) {
      if (!(value > 0) || value === Infinity) continue;
      if (value > this.most) this.most = value;
      if (this.logarithmic && value < this.least) this.least = value;
    }
    if (this.logarithmic) this.least = Math.max(this.least, 1e-6 * this.most);
  }
}

export class Stage {
  constructor(card, { onCells, onStart, onGoal, onFrame }) {
    Object.assign(this, { onFrame, frames: [], shown: "trail", path: null, exact: null, withPath: true, withExact: true, following: false });
    this.size = { width: 1, height: 1 };
    const tools = element("div", { class: "row" });
    this.layerBox = element("div", { class: "row" });
    const host = element("div");
    this.readout = element("div", { class: "hover", role: "status" });
    this.legend = element("div");
    card.append(tools, host, this.readout, this.layerBox);
    this.layerBox.append(
      choices("Layer", [["trail", "Trail"], ["tracks", "Ants"], ["none", "Map"]], "trail", (name) => { this.shown = name; this.repaint(); }),
      checkBox("Path", true, (on) => { this.withPath = on; this.view.draw(); }),
      checkBox("Exact", true, (on) => { this.withExact = on; this.view.draw(); }),
      pictureButton("map.png", () => this.view));
    this.view = new MapView(host, { low: [0, 0], high: [1, 1], label: "Map", tools: this.layerBox, onHover: (x, y) => this.pointed(x, y) });
    this.drawing = new Drawing(tools, { size: () => this.size, onStart, onGoal, onCells: (cells, blocked) => {
      for (const [x, y] of cells) this.map.cells[y * this.map.width + x] = blocked ? 1 : 0;
      this.walls.paint(cells);
      this.view.draw();
      onCells();
    } });
    this.drawing.use(this.view);
    this.view.layers = [(c) => this.drawGround(c), (c) => this.drawHeat(c),
                        (c, view) => this.walls && view.image(c, this.walls.image, 0, 0, this.size.width, this.size.height, view.scale < 1),
                        (c) => this.drawPaths(c), (c) => this.drawCursor(c)];
    this.player = new Player(card, { count: 1, name: "iteration", perSecond: 24, label: (i) => this.labelOf(i), onChange: (i) => this.show(i) });
    card.append(this.legend, swatches([["start", "--start"], ["goal", "--goal"], ["blocked", "--wall"],
                                       ["best path so far", "--path", "line"], ["exact", "--exact", "line"]]));
    const byHand = () => (this.following = this.player.timer !== 0);
    for (const type of ["click", "input"]) this.player.slider.parentElement.addEventListener(type, byHand);
    document.addEventListener("keydown", byHand);
    onTheme(() => { this.walls?.paintAll(); this.repaint(); });
  }

  setMap(map, start, goal) {
    this.map = map;
    this.size = { width: map.width, height: map.height };
    this.walls = new Walls(map);
    Object.assign(this.view, { high: [map.width, map.height], middle: [map.width / 2, map.height / 2], zoom: 1, width: 0 });
    this.drawing.cursor = null;
    this.view.resize();
    this.setEnds(start, goal);
  }

  /** What was found on another map, or from elsewhere, is wrong by now. */
  setEnds(start, goal) {
    Object.assign(this, { start, goal });
    this.view.canvas.setAttribute("aria-label", `Map, ${this.size.width} by ${this.size.height} cells, start ${start.x}, ${start.y}, goal ${goal.x}, ${goal.y}`);
    this.clear();
  }

  clear() {
    Object.assign(this, { path: null, exact: null, frames: [], following: false });
    this.player.pause();
    this.player.extend(1);
    this.player.show(0);
  }

  beginRun({ index, iterations, most }) {
    this.clear();
    Object.assign(this, { iterations, most, range: null, following: true });
    this.scales = { trail: new Scale(index ? "terminal index" : "pheromone", !index), tracks: new Scale("ants through a cell", true) };
  }

  addFrame(frame) {
    for (const name of ["trail", "tracks"]) this.scales[name].include(frame[name]);
    frame.points = pairs(frame.path);
    if (this.frames.length >= this.most && frame.iteration < this.iterations) this.thin();
    this.frames.push(frame);
    const count = this.frames.length;
    if (count === 1) this.heat = new HeatMap(frame.width, frame.height);
    this.player.extend(count);
    if (count === 1) this.player.show(0);
    else if (this.following && !this.player.timer && this.player.index === count - 2) this.player.play();
  }

  /** As KeyFrames of tools/report: every second one stays, the first too. */
  thin() {
    this.frames = this.frames.filter((_, i) => i % 2 === 0);
    this.player.extend(this.frames.length);
    this.player.show(this.player.index >> 1);
  }

  /** From here on colours mean the same in every frame. */
  endRun() {
    if (this.frames.length === 0) return;
    const stride = Math.ceil(this.frames.length / kSampled);
    const sample = this.frames.filter((_, i) => (this.frames.length - 1 - i) % stride === 0);
    this.range = trailRange(sample.map(({ trail }) => codesOf(trail, this.scales.trail)), this.scales.trail);
    this.repaint();
  }

  showPath(path) {
    this.path = path;
    this.view.draw();
  }

  showExact(path) {
    this.exact = path;
    this.view.draw();
  }

  labelOf(index) {
    const frame = this.frames[index];
    return frame ? `iteration ${frame.iteration} of ${this.iterations}` : "no run yet";
  }

  show(index) {
    this.frame = this.frames[index] ?? null;
    this.repaint();
    this.onFrame(this.frame);
  }

  toIteration(x) {
    const at = this.frames.findLastIndex(({ iteration }) => iteration <= x + 0.5);
    this.following = false;
    if (this.frames.length) this.player.chosen(Math.max(0, at));
  }

  repaint() {
    const { frame, shown } = this;
    this.legend.replaceChildren();
    const any = frame && shown !== "none" && this.scales[shown].most > 0;
    this.painted = any;
    if (any) {
      const scale = this.scales[shown], codes = codesOf(frame[shown], scale);
      const range = shown === "tracks" ? [1, 255] : this.range ?? trailRange([codes], scale);
      const ramp = rampOf(shown, scale), note = scale.logarithmic ? (range[0] > 1 ? "clear: less than that" : "") : "clear: unknown";
      this.heat.paint(codes, range, ramp);
      this.legend.append(heatLegend(scale, range, ramp, note));
    }
    if (!this.pointing) this.readout.textContent = this.frameText();
    this.view.draw();
  }

  frameText() {
    if (!this.frame) return "Draw on the map, set start and goal, then run.";
    const { arrived, ants, best } = this.frame;
    return `${arrived} of ${ants} ants arrive · ` + (best > 0 ? `best path ${numberText(best, 3)} cells` : "no path yet");
  }

  pointed(x, y) {
    this.pointing = x != null;
    this.readout.textContent = x == null ? this.frameText() : this.placeText(Math.floor(x), Math.floor(y));
  }

  placeText(x, y) {
    if (!this.drawing.inside([x, y])) return "outside";
    const blocked = this.map.cells[y * this.map.width + x];
    const value = this.valueAt(x, y);
    return `cell ${x}, ${y} · ${blocked ? "blocked" : "free"}` + (value > 0 ? ` · ${this.scales[this.shown].name} ${Number(value.toPrecision(4))}` : "");
  }

  valueAt(x, y) {
    if (!this.painted) return 0;
    const side = this.frame.cells_a_pixel;
    return this.frame[this.shown][Math.floor(y / side) * this.frame.width + Math.floor(x / side)];
  }

  drawGround(context) {
    const [left, top] = this.view.at(0, 0);
    context.fillStyle = themeColour("--free");
    context.fillRect(left, top, this.size.width * this.view.scale, this.size.height * this.view.scale);
  }

  drawHeat(context) {
    if (!this.painted) return;
    const { width, height, cells_a_pixel } = this.frame;
    this.view.image(context, this.heat.image, 0, 0, width * cells_a_pixel, height * cells_a_pixel);
  }

  drawPaths(context) {
    if (!this.map) return;
    if (this.withExact && this.exact) this.view.line(context, this.exact, themeColour("--exact"), 3, [8, 6]);
    const last = !this.frame || this.frame === this.frames.at(-1);
    const path = last && this.path ? this.path : this.frame?.points;
    if (this.withPath && path) {
      this.view.line(context, path, themeColour("--path-rim"), 5);
      this.view.line(context, path, themeColour("--path"), 2.5);
    }
    this.view.ends(context, [this.start.x + 0.5, this.start.y + 0.5], [this.goal.x + 0.5, this.goal.y + 0.5]);
  }

  drawCursor(context) {
    const { cursor } = this.drawing;
    if (!cursor) return;
    const [left, top] = this.view.at(cursor.x, cursor.y), side = Math.max(this.view.scale, 6);
    context.lineWidth = 2;
    context.strokeStyle = themeColour("--accent");
    context.strokeRect(left - 1, top - 1, side + 2, side + 2);
  }
}

/** x, y, x, y ... as [[x, y], ...] */
export function pairs(numbers) {
  return Array.from({ length: numbers.length / 2 }, (_, i) => [numbers[2 * i], numbers[2 * i + 1]]);
}
