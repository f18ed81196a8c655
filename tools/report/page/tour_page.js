// The report of a tour on a bitmap: its legs robot by robot, and its stops by their places.

import { groundLayer, placeText, wallImage } from "./bitmap_page.js";
import { Curves } from "./curves.js";
import { element, isNumber, numberText, onTheme, themeColour } from "./dom.js";
import { pictureButton, saveCsv } from "./files.js";
import { MapView } from "./map_view.js";
import { PathHover } from "./path_hover.js";
import { Sheet, percentText, swatches } from "./sheet.js";
import { dataTable } from "./table.js";
import { VehicleMotion, kMotionKeys } from "./vehicle_motion.js";

const kMostNumbered = 150, kMostKeys = 8;
const kColours = ["--path", "--tour-mean", "--tour-mean-cut", "--tour-cut", "--tour-raw", "--own-optimum"];

const colourOf = (robot) => kColours[robot % kColours.length];

/** Where each stop is: as its legs have it, of others the middle of a cell, or the point. */
function placesOf({ stops, legs }) {
  const places = stops.map((place) => (place.every(Number.isInteger) ? place.map((v) => v + 0.5) : place));
  for (const { from, to, path } of legs ?? []) [places[from], places[to]] = [path[0], path.at(-1)];
  return places;
}

/** The tours of all robots; of one alone all that there is. */
function toursOf({ tours, order, legs, length }) {
  return tours ?? (order ? [{ order, legs: legs.map((_, i) => i), length }] : []);
}

/** A stop as a reader knows it: by its name, else its number. */
function nameOf({ names }, stop) {
  return names?.[stop] || `stop ${stop}`;
}

export async function showTour(content) {
  const sheet = new Sheet(content), { result, map } = content, tours = toursOf(result);
  content.length_unit = "cells";
  sheet.figures([
    ["length", sheet.length(result.order ? result.length : null, 3) ?? "no tour"],
    ["cost", isNumber(result.cost) ? numberText(result.cost, 3) : null],
    ["certified gap", isNumber(result.gap) ? percentText(result.gap) : null],
    ["stops", String(result.order?.length ?? 0)],
    ["robots", result.tours ? `${tours.filter(({ legs }) => legs.length).length} of ${tours.length}` : null],
    ["left out", result.left_out.length ? String(result.left_out.length) : null],
    ["duration", isNumber(result.duration) ? `${numberText(result.duration, 2)} s` : null],
    ["cusps", isNumber(result.cusps) ? String(result.cusps) : null],
    ["time", `${numberText(result.elapsed_ms, 1)} ms`],
  ]);
  await new TourStage(sheet, tours).begin();
  if (content.curves.best) courseOf(sheet, content.curves);
  tables(sheet, tours);
  sheet.finish([["+ −", "zoom, with the focus on the map"]]);
}

function courseOf(sheet, { iteration: x, best, mean }) {
  const { scale, unit } = sheet.content, scaled = (values) => values.map((value) => (isNumber(value) ? scale * value : null));
  new Curves(sheet.card("right", "Convergence"), { title: "Tours of the iteration", calm: true, xLabel: "iteration", yLabel: `length, ${unit || "cells"}`,
    series: [{ name: "best tour so far", x, y: scaled(best), colour: "var(--best)", steps: true },
             { name: "mean tour", x, y: scaled(mean), colour: "var(--tour-mean)" }] });
}

function tables(sheet, tours) {
  const { result } = sheet.content, several = Boolean(result.tours), { scale = 1, unit } = sheet.content;
  const rows = tours.flatMap(({ legs }, robot) => legs.map((i, place) => {
    const { from, to, length, cost } = result.legs[i];
    return [...(several ? [robot] : []), place + 1, nameOf(result, from), nameOf(result, to), numberText(scale * length, 3),
            ...(isNumber(cost) ? [numberText(cost, 3)] : [])];
  }));
  const columns = [...(several ? ["robot"] : []), "leg", "from", "to", `length, ${unit || "cells"}`, ...(isNumber(result.cost) ? ["cost"] : [])];
  if (rows.length)
    sheet.card("right", "Legs").append(element("div", { class: "row" }, element("button", { type: "button", onclick: () => saveCsv("legs.csv", columns, rows) }, "Legs as CSV")),
                                       dataTable(columns, rows, "The legs in their order"));
  if (result.left_out.length)
    sheet.card("rest", "Left out").append(...result.left_out.map(({ why }) => element("p", { class: "note" }, why)));
}

class TourStage {
  constructor(sheet, tours) {
    const { content } = sheet;
    Object.assign(this, { sheet, content, tours, hovered: null, places: placesOf(content.result), card: sheet.card("left") });
    this.hovers = tours.map(({ legs }) => {
      const path = legs.flatMap((i, place) => content.result.legs[i].path.slice(place ? 1 : 0));
      return new PathHover(path, { name: "tour", place: (at) => placeText(content.map, at), length: (value) => sheet.length(value) });
    });
    this.motion = content.vehicle && new VehicleMotion(sheet, this.card, () => this.pointed(null));
    this.readout = element("div", { class: "hover", role: "status" });
  }

  async begin() {
    const { content, card } = this, { map, result } = content, [x, y, width, height] = map.window;
    const tools = element("div", { class: "row" }, ...(this.motion?.buttons() ?? []), pictureButton("tour.png", () => this.view)), host = element("div");
    card.append(tools, host, this.readout);
    this.view = new MapView(host, { low: [x, y], high: [x + width, y + height], label: `Map with a tour of ${result.order?.length ?? 0} stops`, tools,
                                    onHover: (px, py) => this.pointed(px, py) });
    const unknown = map.unknown && (await wallImage(map.unknown, "--no-data"));
    const walls = await wallImage(map.walls, map.obstacles ? "--grown" : "--wall"), inner = map.obstacles && (await wallImage(map.obstacles));
    this.view.layers = [groundLayer(map), (context, view) => {
      const images = map.unknown_free ? [unknown, walls, inner] : [walls, inner, unknown];
      for (const image of images) if (image) view.image(context, image, x, y, width, height, view.scale < 1);
    }, (context, view) => this.drawTour(context, view)];
    const several = result.tours?.slice(0, kMostKeys).map((_, robot) => [`robot ${robot}`, colourOf(robot), "line"]);
    card.append(swatches([...(result.start || result.starts ? [["start", "--start"]] : []), ...(result.goal ? [["goal", "--goal"]] : []),
                          ["blocked", "--wall"], ...(several ?? (this.motion ? kMotionKeys : [["tour", "--path", "line"]])), ["stop", "--tour-mean", "dot"],
                          ...(result.left_out.length ? [["stop left out", "--no-data", "dot"]] : [])]));
    this.motion?.play();
    onTheme(() => this.view.draw());
    this.pointed(null);
  }

  drawTour(context, view) {
    const { result } = this.content, { names } = result, rim = themeColour("--mark-rim"), at = (stop) => this.places[stop];
    this.motion?.drawPath(context, view);
    if (!this.motion) this.tours.forEach(({ legs }, robot) => {
      for (const i of legs) {
        view.line(context, result.legs[i].path, themeColour("--path-rim"), 6);
        view.line(context, result.legs[i].path, themeColour(colourOf(robot)), 3);
      }
    });
    for (const { order } of this.tours) {
      if (result.start || result.starts) view.ends(context, at(order[0]), null);
      if (result.goal) view.ends(context, null, at(result.parameters.open || String(result.goal) !== String(result.start) ? order.at(-1) : order[0]));
    }
    for (const { stop } of result.left_out) view.disc(context, at(stop), 4, themeColour("--no-data"), rim);
    const few = (result.order?.length ?? 0) <= kMostNumbered;
    Object.assign(context, { font: "600 11px system-ui, sans-serif", textAlign: "left", textBaseline: "alphabetic" });
    for (const { order } of this.tours)
      order.forEach((stop) => {
        view.disc(context, at(stop), 4, themeColour("--tour-mean"), rim);
        if (!few) return;
        const [px, py] = view.at(...at(stop));
        context.fillStyle = themeColour("--ink");
        context.fillText(names?.[stop] || String(stop), px + 6, py - 5);
      });
    this.motion?.drawVehicle(context, view);
    if (this.hovered) view.disc(context, this.hovered.at, 5, themeColour(colourOf(this.hovered.robot)), rim);
  }

  pointed(x, y) {
    this.hovered = null;
    if (x != null)
      this.hovers.forEach((hover, robot) => {
        const near = hover.path.length > 1 && hover.near(x, y, 12 / this.view.scale);
        if (near && !(this.hovered?.distance <= near.distance)) this.hovered = { ...near, robot };
      });
    const pose = this.motion && (x == null ? this.motion.index : this.motion.near(x, y, 12 / this.view.scale));
    this.readout.textContent = pose != null ? this.motion.text(pose)
                               : this.hovered ? this.hovers[this.hovered.robot].text(this.hovered)
                               : x == null ? "Point at the tour for coordinates and length." : placeText(this.content.map, [x, y]);
    this.view.draw();
  }
}
