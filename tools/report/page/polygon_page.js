// The report of a plan among polygons.

import { Curves, indexAt } from "./curves.js";
import { element, isNumber, numberText, onTheme, themeColour } from "./dom.js";
import { pictureButton, saveCsv } from "./files.js";
import { MapView } from "./map_view.js";
import { PathHover } from "./path_hover.js";
import { Player } from "./player.js";
import { Sheet, checkBox, percentText, swatches } from "./sheet.js";
import { cumulated, nearestOn } from "./walk.js";

const thereAndBack = (line) => [...line, ...line.slice(1, -1).reverse()];

/** Distance from a point to the nearest edge of the free space. */
function clearanceTo(rings) {
  const closed = rings.map((ring) => [...ring, ring[0]]), sums = closed.map(cumulated);
  return ([x, y]) => Math.min(...closed.map((ring, i) => nearestOn(ring, sums[i], x, y).distance));
}

function fillRings(context, view, rings, colour) {
  context.beginPath();
  for (const ring of rings) {
    ring.forEach(([x, y], i) => context[i ? "lineTo" : "moveTo"](...view.at(x, y)));
    context.closePath();
  }
  context.fillStyle = colour;
  context.fill("evenodd");
}

function chartOf(sheet) {
  const { curves, result } = sheet.content;
  if (!(curves.best?.length > 1)) return null;
  const card = sheet.card("right", "Convergence");
  const levels = [["optimum", result.optimum], ["optimum of the lines crossed", result.maklink?.sequence_optimum]]
    .filter(([, value]) => isNumber(value)).map(([name, value]) => ({ name, value }));
  const mean = "ants" in result.parameters ? "mean tour of the ants" : "mean of the population";
  return new Curves(card, { title: "Length by iteration", xLabel: "iteration", yLabel: "length", decimals: 3, calm: true, levels,
                            series: [{ name: "best path so far", x: curves.iteration, y: curves.best, steps: true, colour: "var(--best)" },
                                     { name: mean, x: curves.iteration, y: curves.mean, colour: "var(--tour-mean)" }] });
}

export async function showPolygon(content) {
  const sheet = new Sheet(content), { result, world, frames } = content;
  sheet.figures([
    ["length", isNumber(result.length) ? numberText(result.length, 3) : "no path"],
    ["above the optimum", isNumber(result.optimum_gap) ? percentText(result.optimum_gap) : null],
    ["optimum", isNumber(result.optimum) ? numberText(result.optimum, 3) : null],
    ["iterations", result.iterations > 0 ? String(result.iterations) : null],
    ["time", `${numberText(result.elapsed_ms, 1)} ms`],
    ["obstacles, lines", `${world.obstacles.length}, ${result.maklink?.lines ?? world.lines.length}`],
  ]);
  const chart = chartOf(sheet), card = sheet.card("left");
  const tools = element("div", { class: "row" }), host = element("div"), readout = element("div", { class: "hover", role: "status" });
  card.append(tools, host, readout);
  const clearance = clearanceTo([...world.free.flat(), ...world.walls.map(thereAndBack)]);
  const place = ([x, y]) => `x ${numberText(x, 3)}, y ${numberText(y, 3)}`;
  const hover = new PathHover(result.path ?? [], { name: "path", place, length: (value) => numberText(value, 3),
                                                   clearance: (found) => numberText(clearance(found.at), 3) });
  const on = { path: true, lines: true, dijkstra: Boolean(content.dijkstra) };
  let frame = frames ? frames.iterations.length - 1 : 0, hovered = null;
  const path = () => (frames && frame < frames.iterations.length - 1 ? frames.paths[frames.path_of[frame]] : hover.path);
  const note = () => (path().length ? `path of length ${numberText(cumulated(path()).at(-1), 3)}` : "no path");
  const toggle = (name, text) => checkBox(text, on[name], (value) => { on[name] = value; view.draw(); });
  const savePath = () => saveCsv("path.csv", ["x", "y", "length"], hover.path.map(([x, y], i) => [x, y, hover.sums[i]]));
  if (hover.path.length) tools.append(toggle("path", "Path"));
  if (world.lines.length) tools.append(toggle("lines", "Free lines"));
  if (content.dijkstra) tools.append(toggle("dijkstra", "Dijkstra's path"));
  if (hover.path.length) tools.append(element("button", { type: "button", onclick: savePath }, "Path as CSV"));
  tools.append(pictureButton("world.png", () => view));
  const view = new MapView(host, {
    low: world.low, high: world.high, up: true, label: `World with the path from ${place(result.start)} to ${place(result.goal)}`, tools,
    onHover: (x, y) => {
      hovered = x == null ? null : hover.near(x, y, 12 / view.scale);
      readout.textContent = hovered ? hover.text(hovered) : x == null ? note() : place([x, y]);
      view.draw();
    } });
  view.layers = [(context) => {
    for (const rings of world.free) fillRings(context, view, rings, themeColour("--free"));
    for (const rings of world.obstacles) fillRings(context, view, rings, themeColour("--wall"));
    for (const wall of world.walls) view.line(context, wall, themeColour("--wall"), 2);
    if (on.lines) for (const line of world.lines) view.line(context, line, themeColour("--graph"), 1.2, [5, 4]);
    if (on.dijkstra) view.line(context, content.dijkstra, themeColour("--other"), 2.5);
    if (on.path) view.line(context, path(), themeColour("--path-rim"), 6);
    if (on.path) view.line(context, path(), themeColour("--path"), 3);
    view.ends(context, result.start, result.goal);
    if (hovered) view.disc(context, hovered.at, 5, themeColour("--path"), themeColour("--mark-rim"));
  }];
  readout.textContent = note();
  if (frames && frames.iterations.length > 1) {
    const player = new Player(card, { count: frames.iterations.length, name: "iteration", perSecond: 20,
                                      label: (i) => `iteration ${frames.iterations[i]} of ${result.iterations}`,
                                      onChange: (i) => {
                                        frame = i;
                                        chart?.cursor(frames.iterations[i]);
                                        readout.textContent = note();
                                        view.draw();
                                      } });
    player.show(frames.iterations.length - 1);
    if (chart) chart.onPick = (x) => player.chosen(Math.max(0, indexAt(frames.iterations, x + 0.5)));
  }
  const marks = [["start", "--start"], ["goal", "--goal"], ["obstacle", "--wall"], ["path", "--path", "line"]];
  if (world.margin > 0) marks.push([`nearer than ${numberText(world.margin)} to that, or outside`, "--outside"]);
  if (world.lines.length) marks.push(["free line", "--graph", "line"]);
  if (content.dijkstra) marks.push(["Dijkstra's path through midpoints", "--other", "line"]);
  card.append(swatches(marks));
  onTheme(() => view.draw());
  sheet.finish([["+ −", "zoom, with the focus on the picture"]]);
}
