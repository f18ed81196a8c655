// The report of a drive: tick by tick what is there, what the robot knows, and its way.

import { Curves, indexAt } from "./curves.js";
import { groundLayer, placeText } from "./bitmap_page.js";
import { channels, element, isNumber, numberText, onTheme, themeColour } from "./dom.js";
import { pictureButton, saveCsv } from "./files.js";
import { MapView } from "./map_view.js";
import { framesOf, numbersOf, unpacked } from "./packed.js";
import { Player } from "./player.js";
import { Sheet, swatches } from "./sheet.js";
import { cumulated, nearestOn } from "./walk.js";

const kShades = 4, kWallKinds = 3, kFirstWall = 2;  // as tools/drive/ground.h has them

function mixed(below, above, share) {
  const to = channels(above);
  return channels(below).map((value, i) => Math.round(value + (to[i] - value) * share));
}

/** The colour of every code, for the theme at hand. */
function groundColours() {
  const free = ["--unseen", "--free"].map(themeColour), walls = ["--wall", "--unknown", "--believed"].map(themeColour);
  const colours = free.map((colour) => mixed(colour, colour, 0));
  for (const below of free)
    for (const wall of walls)
      for (let shade = 1; shade <= kShades; ++shade) colours[colours.length] = mixed(below, wall, shade / kShades);
  return colours.slice(0, kFirstWall + 2 * kWallKinds * kShades);
}

class Ground {
  constructor({ width, height }, frames) {
    this.frames = frames;
    this.image = element("canvas", { width, height });
    this.context = this.image.getContext("2d");
    this.pixels = this.context.createImageData(width, height);
    this.words = new Uint32Array(this.pixels.data.buffer);
  }

  paint(index) {
    const table = Uint32Array.from(groundColours(), ([red, green, blue]) => 0xff000000 | (blue << 16) | (green << 8) | red);
    const codes = this.frames[index];
    for (let i = 0; i < codes.length; ++i) this.words[i] = table[codes[i]];
    this.context.putImageData(this.pixels, 0, 0);
  }
}

/** The robot's clearance at a tick; of a long drive at one nearby that was kept, which is told. */
function robotClearance({ step, values, last, most }, tick, end, sheet) {
  const at = Math.min(Math.round(tick / step), values.length - 1);
  const [kept, value] = tick >= end ? [end, last] : [at * step, values[at]];
  const where = kept === tick ? "" : ` at tick ${kept}`;
  return `clearance of the robot${where} ${value >= most ? "at least " : ""}${sheet.length(value)}`;
}

function waysOf(numbers, lengths) {
  let at = 0;
  return lengths.map((length) => Array.from({ length }, () => [numbers[at++], numbers[at++]]));
}

function chartsOf(sheet) {
  const { result, scale, unit } = sheet.content;
  const { replans } = result;
  if (replans.length < 2) return [];
  const card = sheet.card("right", "Plans under way"), span = [0, result.ticks];
  const x = replans.map((replan) => replan.tick);
  // No length where no way was found; the last one is followed to the end.
  const lengths = replans.map(({ length }) => (isNumber(length) ? scale * length : null));
  return [
    new Curves(card, { title: "Way ahead when it was planned", xLabel: "tick", yLabel: `length, ${unit || "cells"}`, span,
                       series: [{ name: "length of the way", x: [...x, result.ticks], y: [...lengths, lengths.at(-1)], steps: true }] }),
    new Curves(card, { title: "Time to plan", xLabel: "tick", yLabel: "milliseconds", decimals: 3, dots: true, span,
                       series: [{ name: "time in the tick", x, y: replans.map((replan) => replan.ms), colour: "var(--curve-2)" }] }),
  ];
}

export async function showDrive(content) {
  content.length_unit = "cells";
  const sheet = new Sheet(content), { result, map } = content;
  sheet.figures([
    ["travelled", sheet.length(result.length, 2)],
    ["of the optimum at the start", isNumber(result.ratio) ? `${numberText(result.ratio, 3)} ×` : null],
    ["ticks", String(result.ticks)],
    ["plans", String(result.replans?.length ?? 0)],
    ["cells learned", String(result.seen)],
    ["sight", sheet.length(content.sense, 1)],
    ["map", `${map.width} × ${map.height} cells`],
  ]);
  if (content.frames) await stageOf(sheet);
  sheet.finish([["+ −", "zoom, with the focus on the map"]]);
}

async function stageOf(sheet) {
  const { content } = sheet, { frames, map, result } = content;
  const ground = new Ground(frames, framesOf(await unpacked(frames.codes), frames.width * frames.height));
  const ways = waysOf(await numbersOf(frames.ways), frames.way_lengths);
  const track = (result.track ?? []).map(([x, y]) => [x + 0.5, y + 0.5]), sums = cumulated(track);
  const stride = content.thinned ?? 1;
  const charts = chartsOf(sheet), card = sheet.card("left");
  const tools = element("div", { class: "row" }), host = element("div");
  const readout = element("div", { class: "hover", role: "status" });
  let frame = 0, hovered = null;
  const upTo = () => track.slice(0, Math.floor(frames.ticks[frame] / stride) + 1);
  const clearance = (tick) => robotClearance(frames.clearances, tick, result.ticks, sheet);
  const tickText = () => {
    const replans = result.replans.filter((replan) => replan.tick <= frames.ticks[frame]).length;
    const walked = upTo().length;
    return `travelled ${sheet.length(sums[Math.max(0, walked - 1)] ?? 0)} · ${replans} ${replans === 1 ? "plan" : "plans"} so far · ${clearance(frames.ticks[frame])}`;
  };
  const trackText = ({ at, length, segment, part }) => {
    const tick = Math.min(Math.round((segment + part) * stride), result.ticks);
    return `On the track: ${placeText(map, at)} · tick ${tick} · ${sheet.length(length)} travelled · ${clearance(tick)}`;
  };
  const { window: [x, y, width, height] } = map;
  const saveTrack = () => saveCsv("track.csv", ["tick", "x", "y", "length"],
    result.track.map(([cx, cy], i) => [i * stride, cx, cy, sums[i]]));
  tools.append(element("button", { type: "button", onclick: saveTrack }, "Track as CSV"),
               pictureButton("drive.png", () => view));
  const view = new MapView(host, {
    low: [x, y], high: [x + width, y + height], label: `Map with the robot's track from ${result.start} to ${result.goal}`, tools,
    onHover: (px, py) => {
      const found = px == null ? null : nearestOn(upTo(), sums, px, py);
      hovered = found && found.distance <= 12 / view.scale ? found : null;
      readout.textContent = px == null ? tickText() : hovered ? trackText(hovered) : placeText(map, [px, py]);
      view.draw();
    } });
  const show = (index) => {
    frame = index;
    ground.paint(index);
    charts.forEach((chart) => chart.cursor(frames.ticks[index]));
    readout.textContent = tickText();
    view.draw();
  };
  view.layers = [
    groundLayer(map),
    (context) => view.image(context, ground.image, 0, 0, map.width, map.height),
    (context) => {
      const moving = frames.obstacles[frame];
      context.fillStyle = themeColour("--mover");
      for (const [left, top, wide, high] of moving)
        context.fillRect(...view.at(left, top), Math.max(3, wide * view.scale), Math.max(3, high * view.scale));
      const [robotX, robotY] = frames.robots[frame], robot = [robotX + 0.5, robotY + 0.5];
      context.fillStyle = context.strokeStyle = themeColour("--accent");
      context.globalAlpha = 0.09;
      context.beginPath();
      context.arc(...view.at(...robot), content.sense * view.scale, 0, 2 * Math.PI);
      context.fill();
      context.globalAlpha = 1;
      view.line(context, ways[frame], themeColour("--way"), 2.5);
      view.line(context, upTo(), themeColour("--track"), 3.5);
      const goal = result.goal;
      view.ends(context, null, [goal[0] + 0.5, goal[1] + 0.5]);
      view.disc(context, robot, 7, themeColour("--path"), themeColour("--mark-rim"));
      if (hovered) view.disc(context, hovered.at, 4, themeColour("--track"), themeColour("--mark-rim"));
    },
  ];
  card.append(tools, host, readout);
  const player = new Player(card, { count: frames.ticks.length, name: "tick", perSecond: 12, onChange: show,
                                    label: (i) => `tick ${frames.ticks[i]} of ${result.ticks}` });
  charts.forEach((chart) => (chart.onPick = (at) => player.chosen(Math.max(0, indexAt(frames.ticks, at + 0.5)))));
  const step = frames.ticks.length > 1 ? frames.ticks[1] - frames.ticks[0] : 1;
  if (step > 1) card.append(element("p", { class: "note" }, `The page holds one tick in ${step}.`));
  card.append(swatches([["robot", "--path"], ["goal", "--goal"], ["track", "--track", "line"], ["way planned", "--way", "line"],
                        ["blocked and known", "--wall"], ["blocked, not known", "--unknown"], ["known as blocked, but free", "--believed"],
                        ["not seen yet", "--unseen"], ["moving obstacle", "--mover"]]));
  onTheme(() => show(frame));
}
