// The report of a plan of a vehicle: what its footprint sweeps, pose by pose, and its speed.

import { groundLayer, placeText, wallImage } from "./bitmap_page.js";
import { Curves, indexAt } from "./curves.js";
import { element, isNumber, numberText, onTheme, shortText, themeColour } from "./dom.js";
import { pictureButton, saveCsv } from "./files.js";
import { MapView } from "./map_view.js";
import { Player } from "./player.js";
import { Sheet, percentText, swatches } from "./sheet.js";
import { cumulated, nearestOn } from "./walk.js";

const degrees = (radians) => (180 * radians) / Math.PI;

/** The corners of a footprint at a pose. */
function cornersAt(footprint, [x, y, yaw]) {
  const cosine = Math.cos(yaw), sine = Math.sin(yaw);
  return footprint.map(([a, b]) => [x + cosine * a - sine * b, y + sine * a + cosine * b]);
}

function fill(context, view, corners, colour, alpha) {
  context.beginPath();
  corners.forEach((corner, i) => context[i ? "lineTo" : "moveTo"](...view.at(...corner)));
  context.closePath();
  Object.assign(context, { fillStyle: colour, globalAlpha: alpha });
  context.fill();
  context.globalAlpha = 1;
}

export async function showVehicle(content) {
  const sheet = new Sheet(content), { result, map } = content;
  content.length_unit = "cells";
  sheet.figures([
    ["length", sheet.length(result.length, 3) ?? "no path"],
    ["cost", isNumber(result.cost) ? numberText(result.cost, 3) : null],
    ["certified gap", isNumber(result.gap) ? percentText(result.gap) : null],
    ["duration", isNumber(result.duration) ? `${numberText(result.duration, 2)} s` : null],
    ["cusps", isNumber(result.cusps) ? String(result.cusps) : null],
    ["corners", isNumber(result.corners) ? String(result.corners) : null],
    ["time", `${numberText(result.elapsed_ms, 1)} ms`],
    ["map", `${map.width} × ${map.height} cells`],
  ]);
  await new VehicleStage(sheet).begin();
  sheet.finish([["+ −", "zoom, with the focus on the map"]]);
}

class VehicleStage {
  constructor(sheet) {
    const { content } = sheet, { poses } = content.vehicle;
    Object.assign(this, { sheet, content, poses, index: 0, card: sheet.card("left"), charts: [] });
    this.path = poses.map(([x, y]) => [x, y]);
    this.sums = cumulated(this.path);
    this.readout = element("div", { class: "hover", role: "status" });
  }

  async begin() {
    const { content, card, poses } = this, { map } = content, [x, y, width, height] = map.window;
    const tools = element("div", { class: "row" }), host = element("div"), names = ["x", "y", "yaw", "kappa", "v", "t", "gear"];
    if (poses.length) tools.append(element("button", { type: "button", onclick: () => saveCsv("poses.csv", names, poses) }, "Poses as CSV"));
    tools.append(pictureButton("vehicle.png", () => this.view));
    card.append(tools, host, this.readout);
    this.view = new MapView(host, { low: [x, y], high: [x + width, y + height], tools,
                                    label: `Map with the vehicle's path from ${content.result.start} to ${content.result.goal}`,
                                    onHover: (px, py) => this.pointed(px, py) });
    const weights = map.weights && (await wallImage(map.weights, "--cost"));
    const images = [weights, await wallImage(map.walls), map.unknown && (await wallImage(map.unknown, "--no-data"))];
    this.view.layers = [groundLayer(map), (context, view) => {
      for (const image of images) if (image) view.image(context, image, x, y, width, height, view.scale < 1);
    }, (context, view) => this.drawPath(context, view)];
    if (poses.length > 1) this.play();
    card.append(swatches([["start", "--start"], ["goal", "--goal"], ["blocked", "--wall"], ["swept by the footprint", "--swept"],
                          ["forwards", "--path", "line"], ["backwards", "--goal", "line"],
                          ...(map.weights ? [[`weight of a cell, from ${shortText(map.weights.least)} (clear) to ${shortText(map.weights.most)}`, "--cost"]] : [])]));
    onTheme(() => this.view.draw());
    this.pointed(null);
  }

  play() {
    const { content, poses, card } = this, { scale = 1, unit } = content, x = poses.map(([, , , , , t]) => t), xLabel = "seconds";
    const side = this.sheet.card("right", "Along the path");
    const chart = (title, yLabel, name, y, colour) => new Curves(side, { title, xLabel, yLabel, series: [{ name, x, y, colour }] });
    this.charts = [
      chart("Speed", `${unit || "cells"} a second`, "speed, below 0 backwards, in place radians a second",
            poses.map(([, , , , v, , gear]) => (gear < 0 ? -v : v) * (gear ? scale : 1)), "var(--best)"),
      chart("Heading", "degrees", "heading", poses.map(([, , yaw]) => degrees(yaw)), "var(--curve-2)"),
      chart("Curvature", `1 / ${unit || "cells"}`, "curvature", poses.map(([, , , kappa]) => kappa / scale), "var(--curve-3)")];
    const player = new Player(card, { count: poses.length, name: "pose", perSecond: 24,
                                      label: (i) => `${numberText(x[i], 2)} s of ${numberText(x.at(-1), 2)} s`,
                                      onChange: (i) => {
                                        this.index = i;
                                        this.charts.forEach((each) => each.cursor(x[i]));
                                        this.pointed(null);
                                      } });
    this.charts.forEach((each) => (each.onPick = (at) => player.chosen(Math.max(0, indexAt(x, at + 1e-9)))));
  }

  drawPath(context, view) {
    const { poses, content } = this, { footprint } = content.vehicle, swept = themeColour("--swept");
    for (const pose of poses) fill(context, view, cornersAt(footprint, pose), swept, 0.5);
    for (let i = 1; i < poses.length; ++i)
      view.line(context, [this.path[i - 1], this.path[i]], themeColour(poses[i][6] < 0 ? "--goal" : "--path"), 2.5);
    view.ends(context, content.result.start, content.result.goal);
    if (!poses.length) return;
    const corners = cornersAt(footprint, poses[this.index]);
    fill(context, view, corners, themeColour("--accent"), 0.55);
    view.disc(context, this.path[this.index], 3.5, themeColour("--accent"), themeColour("--mark-rim"));
  }

  poseText(i) {
    const [x, y, yaw, kappa, v, t, gear] = this.poses[i], { scale = 1, unit } = this.content;
    const speed = gear ? `${numberText(scale * v, 3)} ${unit || "cells"} a second` : `${numberText(v, 3)} radians a second`;
    const how = gear > 0 ? "forwards" : gear < 0 ? "backwards" : "in place";
    return `${placeText(this.content.map, [x, y])} · heading ${numberText(degrees(yaw), 1)}° · curvature ${numberText(kappa / scale, 4)} · ` +
           `${how} at ${speed} · ${numberText(t, 2)} s · ${this.sheet.length(this.sums[i])}`;
  }

  pointed(x, y) {
    const found = x == null || !this.poses.length ? null : nearestOn(this.path, this.sums, x, y);
    const near = found && found.distance <= 12 / this.view.scale ? Math.round(found.segment + found.part) : null;
    this.readout.textContent = near != null ? this.poseText(near) : x != null ? placeText(this.content.map, [x, y])
                               : this.poses.length ? this.poseText(this.index) : "There is no path.";
    this.view.draw();
  }
}
