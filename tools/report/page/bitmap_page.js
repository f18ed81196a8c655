// The report of a plan on a bitmap.

import { Curves, indexAt } from "./curves.js";
import { channels, element, isNumber, numberText, onTheme, shortText, themeColour } from "./dom.js";
import { pictureButton, saveCsv } from "./files.js";
import { HeatMap, heatLegend, rampOf, trailRange } from "./heat_map.js";
import { MapView } from "./map_view.js";
import { framesOf, unpacked } from "./packed.js";
import { Player } from "./player.js";
import { PathHover } from "./path_hover.js";
import { Sheet, checkBox, choices, percentText, swatches } from "./sheet.js";
import { cumulated, pointsOf } from "./walk.js";

/** Walls as an image: a colour of the theme, as strong as the share of blocked cells. */
export async function wallImage({ width, height, shares: packed }, variable = "--wall") {
  const shares = await unpacked(packed), image = element("canvas", { width, height }), context = image.getContext("2d");
  const paint = () => {
    const pixels = context.createImageData(width, height);
    const [red, green, blue] = channels(themeColour(variable));
    for (let i = 0; i < shares.length; ++i) pixels.data.set([red, green, blue, shares[i]], 4 * i);
    context.putImageData(pixels, 0, 0);
  };
  onTheme(paint);
  paint();
  return image;
}

/** Draws the ground of a map of `map.window`. */
export function groundLayer({ window: [x, y, width, height] }) {
  return (context, view) => {
    const [left, top] = view.at(x, y);
    context.fillStyle = themeColour("--free");
    context.fillRect(left, top, width * view.scale, height * view.scale);
  };
}

/** A place as a reader has it: cells, and metres where the map has a frame. */
export function placeText(map, [x, y]) {
  const cells = `x ${numberText(x, 2)}, y ${numberText(y, 2)}`;
  if (!map.to_world) return cells;
  const [a, b, c, d, e, f] = map.to_world;
  return `${cells} (${numberText(a * x + b * y + c, 3)} m, ${numberText(d * x + e * y + f, 3)} m)`;
}

async function layersOf(frames) {
  const size = frames.width * frames.height, layers = {};
  for (const name of ["trail", "tracks"]) {
    if (!frames[name]) continue;
    const list = framesOf(await unpacked(frames[name].frames), size);
    layers[name] = { scale: frames[name], frames: list, range: name === "trail" ? trailRange(list, frames[name]) : [1, 255] };
  }
  return layers;
}

/** A clearance as text, of values `step` apart, those from `most` on counted as that. */
function clearanceText({ step, values, most }, place, sheet) {
  const at = Math.min(place / (step || 1), values.length - 1), below = Math.floor(at);
  const here = values[below] + (values[Math.min(below + 1, values.length - 1)] - values[below]) * (at - below);
  return `${here >= most ? "at least " : ""}${sheet.length(here)}`;
}

export async function showBitmap(content) {
  const sheet = new Sheet(content);
  const { result, map, frames, curves } = content;
  content.length_unit = "cells";
  sheet.figures([
    ["length", sheet.length(result.length, 3) ?? "no path"],
    ["cost", isNumber(result.cost) ? numberText(result.cost, 3) : null],
    ["above the optimum", isNumber(result.optimum_gap) ? percentText(result.optimum_gap) : null],
    ["certified gap", isNumber(result.gap) ? percentText(result.gap) : null],
    ["iterations", result.iterations > 0 ? String(result.iterations) : null],
    ["time", `${numberText(result.elapsed_ms, 1)} ms`],
    ["map", `${map.width} × ${map.height} cells`],
  ]);
  const layers = frames ? await layersOf(frames) : {};
  const stage = new BitmapStage(sheet, layers);
  const charts = curvesOf(sheet, curves);
  stage.onFrame = (iteration) => charts.forEach((chart) => chart.cursor(iteration));
  charts.forEach((chart) => (chart.onPick = (x) => stage.toIteration(x)));
  await stage.begin();
  addProof(sheet);
  sheet.finish([["+ −", "zoom, with the focus on the map"]]);
}

/** How best path and bound came nearer to each other. */
function addProof(sheet) {
  const { frames, result } = sheet.content, best = result.cost ?? result.length;
  if (!frames?.proof.ms.length || !isNumber(result.lower_bound) || !isNumber(best)) return;
  const last = frames.proof.ms.at(-1), x = [...frames.proof.ms, Math.max(last, result.elapsed_ms)], steps = true, xLabel = "ms";
  const paths = [...frames.proof.best, best], bounds = [...frames.proof.bound, result.lower_bound], card = sheet.card("right", "Proof");
  const gaps = paths.map((path, i) => (bounds[i] > 0 ? 100 * Math.max(0, path / bounds[i] - 1) : null));
  new Curves(card, { title: "Best path and bound", xLabel, yLabel: isNumber(result.cost) ? "cost" : "length, cells",
    series: [{ name: "best path so far", x, y: paths, colour: "var(--best)", steps },
             { name: "no path is below", x, y: bounds, colour: "var(--tour-mean)", steps }] });
  new Curves(card, { title: "Certified gap", xLabel, yLabel: "%", logarithmic: gaps.every((gap) => gap !== 0), decimals: 4,
    series: [{ name: "best path above the bound, %", x, y: gaps, colour: "var(--best)", steps }] });
}

function curvesOf(sheet, curves) {
  if (!curves.best) return [];
  const { content } = sheet, scale = content.scale, unit = content.unit || "cells";
  const scaled = (values) => values?.map((value) => (isNumber(value) ? scale * value : null)) ?? [];
  const x = curves.iteration, { walk_cut, ants } = content.result.parameters;
  const level = (name, value, colour) => (isNumber(value) ? [{ name, value: scale * value, colour }] : []);
  const series = (name, values, colour, more = {}) => ({ name, x, y: scaled(values), colour: `var(${colour})`, ...more });
  const cut = walk_cut && walk_cut !== "none", several = ants !== 1;
  const card = sheet.card("right", "Convergence");
  // Names and colours are those of pictures (tools/bitmap/picture.cpp).
  return [
    new Curves(card, { title: "Best path so far", calm: true, xLabel: "iteration", yLabel: `length, ${unit}`,
                       levels: level("any-angle optimum", content.result.optimum, "var(--ink)"),
                       series: [series("best path so far", curves.best, "--best", { steps: true })] }),
    new Curves(card, { title: "Tours of the iteration", calm: true, xLabel: "iteration", yLabel: `length, ${unit}`,
                       levels: level("optimum of its own moves", content.result.grid_optimum, "var(--own-optimum)"),
                       series: [series(curves.raw_best ? "mean tour, as walked" : "mean of the population", curves.mean, "--tour-mean"),
                                series("shortest tour, as walked", several ? curves.raw_best : [], "--tour-raw"),
                                series("mean tour after the cut", cut ? curves.cut_mean : [], "--tour-mean-cut"),
                                series("shortest tour after the cut", cut && several ? curves.cut_best : [], "--tour-cut")] }),
  ];
}

class BitmapStage {
  constructor(sheet, layers) {
    const { content } = sheet, { clearance } = content;
    Object.assign(this, { sheet, content, layers, frame: 0, hovered: null, showPath: true });
    this.shown = layers.trail ? "trail" : layers.tracks ? "tracks" : "none";
    const { path, curve } = content.result;
    this.hover = new PathHover(curve ? pointsOf(curve) : path ?? [], { name: "path", place: (at) => placeText(content.map, at),
                                                           length: (value) => sheet.length(value), clearance: clearance && (({ length }) => clearanceText(clearance, length, sheet)) });
    [this.start, this.goal, this.end] = content.ends;  // the end: of a path short of the goal
    this.card = sheet.card("left");
    this.tools = element("div", { class: "row" });
    this.legend = element("div");
    this.readout = element("div", { class: "hover", role: "status" });
    this.host = element("div");
  }

  async begin() {
    const { content, card } = this;
    const names = { trail: content.frames?.trail?.name === "terminal index" ? "Terminal index" : "Trail", tracks: "Ants", none: "Map" };
    const options = Object.keys(names).filter((name) => name === "none" || this.layers[name]).map((name) => [name, names[name]]);
    if (options.length > 1)
      this.tools.append(choices("Layer", options, this.shown, (name) => { this.shown = name; this.repaint(); }));
    if (this.hover.path.length) {
      this.tools.append(checkBox("Path", true, (on) => { this.showPath = on; this.view.draw(); }));
      this.tools.append(element("button", { type: "button", onclick: () => this.savePath() }, "Path as CSV"));
    }
    this.tools.append(pictureButton("map.png", () => this.view));
    card.append(this.tools, this.host);
    const { window: [x, y, width, height] } = content.map;
    const ends = `from ${content.result.start} to ${content.result.goal}`;
    this.view = new MapView(this.host, { low: [x, y], high: [x + width, y + height], label: `Map with the path ${ends}`, tools: this.tools,
                                         onHover: (px, py) => this.pointed(px, py) });
    const { obstacles } = content.map, unknown = content.map.unknown && (await wallImage(content.map.unknown, "--no-data"));
    const walls = await wallImage(content.map.walls, obstacles ? "--grown" : "--wall");
    const weights = content.map.weights && (await wallImage(content.map.weights, "--cost"));
    const inner = obstacles && (await wallImage(obstacles));
    const heat = this.heat = content.frames ? new HeatMap(content.frames.width, content.frames.height) : null;
    this.view.layers = [
      groundLayer(content.map),
      (context, view) => {
        if (weights) view.image(context, weights, x, y, width, height, view.scale < 1);
        if (unknown && content.map.unknown_free) view.image(context, unknown, x, y, width, height, view.scale < 1);
        const side = content.frames?.cells_a_pixel;
        if (heat && this.shown !== "none") view.image(context, heat.image, 0, 0, side * heat.image.width, side * heat.image.height);
      },
      (context, view) => {
        for (const image of [walls, inner, !content.map.unknown_free && unknown]) if (image) view.image(context, image, x, y, width, height, view.scale < 1);
      },
      (context, view) => {
        for (const [ax, ay, bx, by] of content.map.level_lines ?? []) view.line(context, [[ax, ay], [bx, by]], themeColour("--level-line"), 1);
      },
      (context, view) => this.drawPath(context, view),
    ];
    card.append(this.readout, this.legend);
    if (content.frames) this.addPlayer();
    this.addKeys();
    onTheme(() => this.repaint());
    this.repaint();
  }

  addPlayer() {
    const { frames } = this.content, last = this.content.result.iterations;
    if (frames.iterations.length < 2) return;
    const name = last > 0 ? "iteration" : "improvement";
    const label = (i) => `${name} ${frames.iterations[i]} of ${last || frames.iterations.at(-1)}`;
    this.player = new Player(this.card, { count: frames.iterations.length, name, label,
                                          onChange: (i) => this.show(i) });
    this.player.show(frames.iterations.length - 1);
    const stride = frames.iterations[1] - frames.iterations[0];
    if (stride > 1)
      this.card.append(element("p", { class: "note" }, `The page holds one iteration in ${stride}, the curves have all.`));
  }

  addKeys() {
    const { radius, map, result, scale, unit } = this.content, unknown = `unknown, counted as ${map.unknown_free ? "free" : "blocked"}`;
    const told = unit ? `${numberText(Number((scale * radius).toFixed(6)))} ${unit}` : `${numberText(radius)} ${radius === 1 ? "cell" : "cells"}`;
    this.card.append(swatches([["start", "--start"], ["goal", "--goal"], ["blocked", "--wall"],
                               ...(map.unknown ? [[unknown, "--no-data"]] : []),
                               ...(map.weights ? [[`weight of a cell, from ${shortText(map.weights.least)} (clear) to ${shortText(map.weights.most)}`, "--cost"]] : []),
                               ...(map.level_lines ? [[`cost to the goal, where the proof looked, a line every ${shortText(map.lines_apart)}`, "--level-line", "line"]] : []),
                               ...(map.obstacles ? [[`no place for the centre: nearer than ${told} to that`, "--grown"]] : []), ["path", "--path", "line"],
                               ...(radius > 0 ? [["swept by the robot", "--swept"]] : []),
                               ...(result.way_out ? [["way out", "--start", "dot"]] : []), ...(this.end ? [["goal reached", "--goal", "dot"]] : [])]));
    const note = (text) => this.card.append(element("p", { class: "note" }, text));
    const leg = (a, [x, y]) => this.sheet.length(Math.hypot(a[0] - x, a[1] - y));
    if (result.way_out)
      note(`The robot stands too near to what is blocked: the path first leads ${leg(result.way_out, this.start)} out to ${placeText(map, result.way_out)}; the rest is planned from there.`);
    if (this.end)
      note(`The goal asked for, ${placeText(map, this.goal)}, cannot be reached: the path ends ${leg(this.end, this.goal)} from it, at ${placeText(map, this.end)}.`);
    if (radius > 0)
      this.card.append(element("p", { class: "note" }, `The robot is a disc with a radius of ${told}; clearance is measured from its centre to what is blocked.`));
    if (this.content.thinned)
      this.card.append(element("p", { class: "note" }, `The path is long: the page holds one vertex in ${this.content.thinned}.`));
  }

  toIteration(x) {
    if (!this.player) return;
    this.player.chosen(Math.max(0, indexAt(this.content.frames.iterations, x + 0.5)));
  }

  show(index) {
    this.frame = index;
    this.repaint();
    this.onFrame?.(this.content.frames.iterations[index]);
  }

  repaint() {
    if (!this.view) return;
    const layer = this.layers[this.shown];
    if (layer) {
      const ramp = rampOf(this.shown, layer.scale);
      this.heat.paint(layer.frames[this.frame], layer.range, ramp);
      const index = !layer.scale.logarithmic ? "clear: unknown; the longest 1% as the end of the scale" : "";
      const low = index || (layer.range[0] > 1 ? "clear: less than that" : "");
      const far = this.content.frames.reads_all ? "" : "clear: less than that, or far from all tracks";
      const note = this.shown === "trail" ? far || low : "";
      this.legend.replaceChildren(heatLegend(layer.scale, layer.range, ramp, note));
    } else this.legend.replaceChildren();
    if (!this.pointing) this.readout.textContent = this.frameText();
    this.view.draw();
  }

  frameText() {
    const { frames } = this.content;
    if (!frames) return "Point at the path for coordinates, length and clearance.";
    const ants = frames.ants[this.frame], arrived = frames.arrived[this.frame];
    const path = this.path(), length = path.length ? cumulated(path).at(-1) : null;
    const best = length == null ? "no path yet" : `best path ${this.sheet.length(length)}`;
    return ants > 0 ? `${arrived} of ${ants} ants arrive · ${best}` : best;
  }

  /** The best path at the frame shown; at the last one the result. */
  path() {
    const { frames } = this.content;
    if (!frames || this.frame === frames.iterations.length - 1) return this.hover.path;
    return frames.paths[frames.path_of[this.frame]] ?? [];
  }

  drawPath(context, view) {
    const { radius, result } = this.content, { curve } = result;
    const path = curve && this.path() === this.hover.path ? curve : this.path();
    if (this.showPath && radius > 0) {
      context.globalAlpha = 0.16;
      view.line(context, path, themeColour("--path"), 2 * radius * view.scale);
      context.globalAlpha = 1;
    }
    if (this.showPath) {
      view.line(context, path, themeColour("--path-rim"), 6);
      view.line(context, path, themeColour("--path"), 3);
    }
    view.ends(context, this.start, this.goal);
    const rim = themeColour("--mark-rim");
    if (result.way_out) view.disc(context, result.way_out, 5, themeColour("--start"), rim);
    if (this.end) view.disc(context, this.end, 5, themeColour("--goal"), rim);
    if (this.hovered) view.disc(context, this.hovered.at, 5, themeColour("--path"), themeColour("--mark-rim"));
  }

  pointed(x, y) {
    this.pointing = x != null;
    this.hovered = x == null || !this.showPath ? null : this.hover.near(x, y, 12 / this.view.scale);
    this.readout.textContent = this.hovered ? this.hover.text(this.hovered)
                               : x == null ? this.frameText() : placeText(this.content.map, [x, y]);
    this.view.draw();
  }

  savePath() {
    const { path, path_world: world } = this.content.result, sums = cumulated(path);
    const columns = ["x", "y", "length", ...(world ? ["x_m", "y_m"] : [])];
    const rows = path.map(([x, y], i) => [x, y, sums[i], ...(world ? world[i] : [])]);
    saveCsv("path.csv", columns, rows);
  }
}
