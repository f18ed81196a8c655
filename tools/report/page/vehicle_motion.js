// A vehicle along its poses: what it sweeps, where it is, its speed, heading and curvature over time.
//
//   motion = new VehicleMotion(sheet, card, onChange)  poses of content.vehicle; a player in the card where it moves
//   motion.buttons()                   what a card's tools have of it
//   motion.play()                      the player, and the curves in a card of their own
//   motion.drawPath(context, view), motion.drawVehicle(context, view)
//   motion.near(x, y, reach)           the index of the pose there, or null
//   motion.text(index)                 what a reader learns of a pose, else of where the vehicle is

import { placeText } from "./bitmap_page.js";
import { Curves, indexAt } from "./curves.js";
import { element, numberText, themeColour } from "./dom.js";
import { saveCsv } from "./files.js";
import { Player } from "./player.js";
import { cumulated, nearestOn } from "./walk.js";

/** Names and colours of what it draws, as swatches take them. */
export const kMotionKeys = [["swept by the footprint", "--swept"], ["forwards", "--path", "line"], ["backwards", "--goal", "line"]];

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

/** Degrees of poses, without the whole turns by which the legs of a tour are told anew. */
function headings(poses) {
  let turns = 0;
  return poses.map(([, , yaw], i) => {
    if (i) turns -= Math.round((yaw - poses[i - 1][2]) / (2 * Math.PI));
    return degrees(yaw) + 360 * turns;
  });
}

export class VehicleMotion {
  constructor(sheet, card, onChange) {
    const { footprint, poses } = sheet.content.vehicle;
    Object.assign(this, { sheet, card, onChange, footprint, poses, index: 0, charts: [], path: poses.map(([x, y]) => [x, y]) });
    this.sums = cumulated(this.path);
  }

  buttons() {
    const names = ["x", "y", "yaw", "kappa", "v", "t", "gear"];
    return this.poses.length ? [element("button", { type: "button", onclick: () => saveCsv("poses.csv", names, this.poses) }, "Poses as CSV")] : [];
  }

  play() {
    if (this.poses.length < 2) return;
    const { poses } = this, { scale = 1, unit } = this.sheet.content, x = poses.map(([, , , , , t]) => t), xLabel = "seconds";
    const side = this.sheet.card("right", "Along the path");
    const chart = (title, yLabel, name, y, colour) => new Curves(side, { title, xLabel, yLabel, series: [{ name, x, y, colour }] });
    this.charts = [
      chart("Speed", `${unit || "cells"} a second`, "speed, below 0 backwards, in place radians a second",
            poses.map(([, , , , v, , gear]) => (gear < 0 ? -v : v) * (gear ? scale : 1)), "var(--best)"),
      chart("Heading", "degrees", "heading", headings(poses), "var(--curve-2)"),
      chart("Curvature", `1 / ${unit || "cells"}`, "curvature", poses.map(([, , , kappa]) => kappa / scale), "var(--curve-3)")];
    const player = new Player(this.card, { count: poses.length, name: "pose", perSecond: 24,
                                      label: (i) => `${numberText(x[i], 2)} s of ${numberText(x.at(-1), 2)} s`,
                                      onChange: (i) => {
                                        this.index = i;
                                        this.charts.forEach((each) => each.cursor(x[i]));
                                        this.onChange();
                                      } });
    this.charts.forEach((each) => (each.onPick = (at) => player.chosen(Math.max(0, indexAt(x, at + 1e-9)))));
  }

  drawPath(context, view) {
    const swept = themeColour("--swept");
    for (const pose of this.poses) fill(context, view, cornersAt(this.footprint, pose), swept, 0.5);
    for (let i = 1; i < this.poses.length; ++i)
      view.line(context, [this.path[i - 1], this.path[i]], themeColour(this.poses[i][6] < 0 ? "--goal" : "--path"), 2.5);
  }

  drawVehicle(context, view) {
    if (!this.poses.length) return;
    fill(context, view, cornersAt(this.footprint, this.poses[this.index]), themeColour("--accent"), 0.55);
    view.disc(context, this.path[this.index], 3.5, themeColour("--accent"), themeColour("--mark-rim"));
  }

  near(x, y, reach) {
    const found = nearestOn(this.path, this.sums, x, y);
    return found.distance <= reach ? Math.round(found.segment + found.part) : null;
  }

  text(i = this.index) {
    if (!this.poses.length) return "There is no path.";
    const [x, y, yaw, kappa, v, t, gear] = this.poses[i], { scale = 1, unit } = this.sheet.content;
    const speed = gear ? `${numberText(scale * v, 3)} ${unit || "cells"} a second` : `${numberText(v, 3)} radians a second`;
    const how = gear > 0 ? "forwards" : gear < 0 ? "backwards" : "in place";
    return `${placeText(this.sheet.content.map, [x, y])} · heading ${numberText(degrees(yaw), 1)}° · curvature ${numberText(kappa / scale, 4)} · ` +
           `${how} at ${speed} · ${numberText(t, 2)} s · ${this.sheet.length(this.sums[i])}`;
  }
}
