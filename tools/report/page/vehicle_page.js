// The report of a plan of a vehicle.

import { groundLayer, placeText, wallImage } from "./bitmap_page.js";
import { element, isNumber, numberText, onTheme, shortText } from "./dom.js";
import { pictureButton } from "./files.js";
import { MapView } from "./map_view.js";
import { Sheet, percentText, swatches } from "./sheet.js";
import { VehicleMotion, kMotionKeys } from "./vehicle_motion.js";

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
    Object.assign(this, { sheet, content: sheet.content, card: sheet.card("left") });
    this.motion = new VehicleMotion(sheet, this.card, () => this.pointed(null));
    this.readout = element("div", { class: "hover", role: "status" });
  }

  async begin() {
    const { content, card } = this, { map } = content, [x, y, width, height] = map.window, host = element("div");
    const tools = element("div", { class: "row" }, ...this.motion.buttons(), pictureButton("vehicle.png", () => this.view));
    card.append(tools, host, this.readout);
    this.view = new MapView(host, { low: [x, y], high: [x + width, y + height], tools,
                                    label: `Map with the vehicle's path from ${content.result.start} to ${content.result.goal}`,
                                    onHover: (px, py) => this.pointed(px, py) });
    const weights = map.weights && (await wallImage(map.weights, "--cost"));
    const images = [weights, await wallImage(map.walls), map.unknown && (await wallImage(map.unknown, "--no-data"))];
    this.view.layers = [groundLayer(map), (context, view) => {
      for (const image of images) if (image) view.image(context, image, x, y, width, height, view.scale < 1);
    }, (context, view) => this.draw(context, view)];
    this.motion.play();
    card.append(swatches([["start", "--start"], ["goal", "--goal"], ["blocked", "--wall"], ...kMotionKeys,
                          ...(map.weights ? [[`weight of a cell, from ${shortText(map.weights.least)} (clear) to ${shortText(map.weights.most)}`, "--cost"]] : [])]));
    onTheme(() => this.view.draw());
    this.pointed(null);
  }

  draw(context, view) {
    this.motion.drawPath(context, view);
    view.ends(context, this.content.result.start, this.content.result.goal);
    this.motion.drawVehicle(context, view);
  }

  pointed(x, y) {
    const near = x == null ? null : this.motion.near(x, y, 12 / this.view.scale);
    this.readout.textContent = x != null && near == null ? placeText(this.content.map, [x, y]) : this.motion.text(near ?? undefined);
    this.view.draw();
  }
}
