// The report of an arm: it moves in space, and can be turned.

import { Curves, indexAt } from "./curves.js";
import { channels, element, isNumber, numberText, onTheme, themeColour } from "./dom.js";
import { pictureButton, saveCsv } from "./files.js";
import { numbersOf } from "./packed.js";
import { Player } from "./player.js";
import { Sheet, checkBox, percentText, swatches } from "./sheet.js";
import { SpaceView, moved, solidFaces } from "./space_view.js";
import { cumulated } from "./walk.js";

function rows(numbers, width) {
  return Array.from({ length: numbers.length / width }, (_, i) => numbers.subarray(i * width, (i + 1) * width));
}

/** The faces of each solid in the frame of its body. */
async function bodiesOf(solids) {
  const bodies = [];
  for (const solid of solids) {
    const triangles = solid.triangles ? await numbersOf(solid.triangles) : [];
    const faces = solidFaces({ ...solid, triangles });
    bodies.push({ body: solid.body, faces: faces.map((face) => face.map((point) => moved(solid.pose, point))) });
  }
  return bodies;
}

function rgb(variable) {
  return channels(themeColour(variable));
}

/** Some lines on the ground, a round number of units apart. */
function floorLines(low, high) {
  const span = Math.max(high[0] - low[0], high[1] - low[1]);
  const step = 10 ** Math.floor(Math.log10(span / 3)), lines = [];
  for (const axis of [0, 1])
    for (let at = Math.ceil(low[axis] / step) * step; at <= high[axis]; at += step) {
      const ends = [low, high].map((corner) => [corner[0], corner[1], low[2]]);
      ends[0][axis] = ends[1][axis] = at;
      lines.push(ends);
    }
  return lines;
}

function figuresOf(sheet) {
  const { result, unit } = sheet.content;
  return [
    [`length, ${unit}`, isNumber(result.length) ? numberText(result.length, 3) : "no path"],
    ["gap to what was learned", isNumber(result.gap) ? percentText(result.gap) : null],
    ["duration", isNumber(result.duration) ? `${numberText(result.duration, 2)} s` : null],
    ["iterations", String(result.iterations ?? 0)],
    ["time", `${numberText(result.elapsed_ms, 0)} ms`],
  ];
}

function motionCharts(sheet, motion, joints) {
  const { content } = sheet, charts = [];
  if (motion.times.length > 1) {
    const card = sheet.card("right", "Motion");
    const series = motion.names.map((name, k) => ({ name, x: motion.times, y: joints.map((q) => q[k]) }));
    charts.push(new Curves(card, { title: "Joints", xLabel: "time, s", yLabel: "value, rad or m", decimals: 3, series }));
  }
  const { curves, asked, unit } = content;
  if (curves.best?.length > 1) {
    const card = sheet.card("right", "Search");
    const levels = isNumber(content.result.lower_bound) ? [{ name: "lower bound", value: content.result.lower_bound }] : [];
    new Curves(card, { title: "Length by iteration", xLabel: "iteration", yLabel: `length, ${unit}`, decimals: 3, calm: true, levels,
                       series: [{ name: "best lattice path so far", x: curves.iteration, y: curves.best, steps: true, colour: "var(--best)" },
                                { name: "mean tour of the ants", x: curves.iteration, y: curves.mean, colour: "var(--tour-mean)" }] });
    if (asked.positions.length > 1)
      new Curves(card, { title: "Questions asked so far", xLabel: "iteration", yLabel: "questions", decimals: 0,
                         series: [{ name: "positions", y: asked.positions, steps: true, colour: "var(--curve-2)" },
                                  { name: "motions", y: asked.motions, steps: true, colour: "var(--curve-1)" }] });
  }
  return charts;
}

/** The place among `points` that is seen within reach of a pixel; null where there is none. */
function nearestOnScreen(view, points, x, y) {
  const look = view.look(), apart = points.map(look).map(([px, py]) => Math.hypot(px - x, py - y));
  const nearest = apart.indexOf(Math.min(...apart));
  return apart[nearest] <= 12 ? nearest : null;
}

export async function showArm(content) {
  const sheet = new Sheet(content), { motion } = content;
  sheet.figures(figuresOf(sheet));
  const joints = rows(await numbersOf(motion.joints), motion.names.length);
  const tips = rows(await numbersOf(motion.tips), 3);
  const distances = await numbersOf(motion.distances);
  const poses = rows(await numbersOf(motion.poses), 12 * (motion.names.length + 1));
  const charts = motionCharts(sheet, motion, joints);
  const bodies = await bodiesOf(content.solids);
  const card = sheet.card("left"), tools = element("div", { class: "row" }), host = element("div");
  const readout = element("div", { class: "hover", role: "status" });
  card.append(tools, host, readout);
  const on = { way: true, lattice: content.lattice.length > 1, ends: tips.length > 1 };
  const toggle = (name, text) => checkBox(text, on[name], (value) => { on[name] = value; hovered = null; show(frame); });
  const columns = ["t", ...motion.names, "x", "y", "z"];
  const saveMotion = () => saveCsv("motion.csv", columns, motion.times.map((t, i) =>
    [t, ...joints[i], ...tips[i]].map((value) => Number(value.toPrecision(7)))));
  if (tips.length > 1) tools.append(toggle("way", "Way of the tip"), toggle("ends", "Start and end"));
  if (content.lattice.length > 1) tools.append(toggle("lattice", "Lattice path"));
  tools.append(element("button", { type: "button", onclick: saveMotion }, "Path as CSV"),
               pictureButton("arm.png", () => view));
  const view = new SpaceView(host, { low: content.low, high: content.high, label: "The arm among its obstacles", tools });
  const sums = cumulated(tips);
  let frame = 0, hovered = null;

  const stateText = (index) => {
    const place = Array.from(tips[index], (value) => numberText(value, 3)).join(", ");
    const clear = distances[index] < motion.far_away ? ` · clearance of the arm ${numberText(distances[index], 3)} m` : "";
    const at = index === frame ? "Tip" : `After ${numberText(motion.times[index], 2)} s: tip`;
    return `${at} at ${place} m · ${numberText(sums[index], 3)} m of ${numberText(sums.at(-1), 3)} m travelled${clear}`;
  };
  const placed = (index, variable, opacity) => bodies.filter(({ body }) => body > 0).flatMap(({ body, faces }) => {
    const pose = poses[index].subarray(12 * body, 12 * body + 12), colour = rgb(variable);
    return faces.map((face) => ({ points: face.map((point) => moved(pose, point)), colour, opacity }));
  });
  const still = () => bodies.filter(({ body }) => body <= 0).flatMap(({ body, faces }) =>
    faces.map((points) => ({ points, colour: rgb(body < 0 ? "--obstacle" : "--base"), opacity: body < 0 ? 0.55 : 1 })));
  const show = (index) => {
    frame = index;
    view.faces = [...still(), ...placed(index, "--arm", 1)];
    if (on.ends) view.faces.push(...placed(0, "--start", 0.13), ...placed(tips.length - 1, "--goal", 0.13));
    view.lines = floorLines(content.low, content.high).map((points) => ({ points, colour: themeColour("--rim"), width: 1 }));
    if (on.way && tips.length > 1) view.lines.push({ points: tips, colour: themeColour("--path"), width: 2.5 });
    if (on.lattice) view.lines.push({ points: content.lattice, colour: themeColour("--other"), width: 1.5 });
    view.dots = [{ at: tips[0], colour: themeColour("--start"), radius: 5 },
                 ...content.goals.map((at) => ({ at, colour: themeColour("--goal"), radius: 6 })),
                 { at: tips[index], colour: themeColour("--path"), radius: 5 }];
    if (hovered != null) view.dots.push({ at: tips[hovered], colour: themeColour("--path"), radius: 4 });
    charts.forEach((chart) => chart.cursor(motion.times[index]));
    readout.textContent = stateText(hovered ?? index);
    view.draw();
  };
  view.onHover = (x, y) => {
    const before = hovered;
    hovered = x == null || !on.way || tips.length < 2 ? null : nearestOnScreen(view, tips, x, y);
    if (hovered !== before) show(frame);
  };
  if (tips.length > 1) {
    const total = motion.times.at(-1);
    const player = new Player(card, { count: tips.length, name: "time", perSecond: (tips.length - 1) / total, onChange: show,
                                      label: (i) => `${numberText(motion.times[i], 2)} of ${numberText(total, 2)} s` });
    charts.forEach((chart) => (chart.onPick = (x) => player.chosen(Math.max(0, indexAt(motion.times, x)))));
  } else show(0);
  const marks = [["arm", "--arm"], ["base", "--base"], ["obstacle", "--obstacle"], ["tip at the start", "--start"], ["goal", "--goal"]];
  if (tips.length > 1) marks.push(["way of the tip", "--path", "line"]);
  if (content.lattice.length > 1) marks.push(["lattice path", "--other", "line"]);
  card.append(swatches(marks), element("p", { class: "note" }, "Drag to turn. Lines on the ground are round steps apart."));
  onTheme(() => show(frame));
  sheet.finish([["arrows", "turn, with the focus on the picture"], ["+ −", "zoom there"]]);
}
