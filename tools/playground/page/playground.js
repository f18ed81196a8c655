// The playground: a map, a colony, a run that is watched, the exact path beside it, and the command.

import { ColonyCard } from "./colony_card.js";
import { commandOf, mapFileOf } from "./command.js";
import { Curves } from "./curves.js";
import { element, isNumber, numberText, themeButton } from "./dom.js";
import { Engine, Stopped } from "./engine.js";
import { field, numberField } from "./fields.js";
import { copyButton, saveCsv, saveFile } from "./files.js";
import { checkBox, percentText, statusText } from "./sheet.js";
import { Stage, pairs } from "./stage.js";
import { cumulated } from "./walk.js";
import { WorldCard, checkSize } from "./world_card.js";

const kFrameBytes = 96 << 20;  // of all frames of a run
const kMostFrames = 500;

class Playground {
  constructor(engine) {
    Object.assign(this, { engine, running: false, comparing: true, maps: 0, radius: 0 });
    this.problem = element("p", { class: "problem", role: "alert" });
    this.figures = element("dl", { class: "figures" });
    this.left = element("div");
    this.right = element("div");
    this.bar = element("div", { class: "row bar" });
    document.getElementById("playground").append(
      element("header", {}, element("div", {}, element("h1", {}, "lasius playground"),
        element("p", { class: "subtitle" }, "Colonies and the exact planner on a map of your own. All of it runs in this page.")), themeButton()),
      this.bar, this.problem, this.figures, element("div", { class: "columns" }, this.left, this.right));
  }

  card(side, heading) {
    const card = element("section", { class: "card" }, heading ? element("h2", {}, heading) : null);
    side.append(card);
    return card;
  }

  async begin() {
    const [algorithms, kinds, version] = await Promise.all(["algorithms", "kinds", "version"].map((name) => this.engine.call(name)));
    this.stage = new Stage(this.card(this.left, "Map"), {
      onCells: () => this.drawn(), onStart: (cell) => this.setEnds(cell, this.goal), onGoal: (cell) => this.setEnds(this.start, cell),
      onFrame: (frame) => frame && this.charts?.forEach((chart) => chart.cursor(frame.iteration)) });
    this.addRunBar();
    this.addCharts();
    this.world = new WorldCard(this.card(this.right, "World"), {
      kinds, make: (wish) => this.try(() => this.generate(wish)), read: (file) => this.try(() => this.read(file)),
      empty: (width, height) => this.try(() => this.empty(width, height)), save: () => this.try(() => this.saveMap()) });
    this.addEndsCard();
    this.addCommandCard();
    this.colony = new ColonyCard(this.card(this.right, "Colony"), {
      algorithms, formulas: (question) => this.engine.call("formulas", question), onChange: () => this.tellCommand() });
    document.getElementById("playground").append(element("footer", {}, element("p", {}, `lasius ${version}, compiled to WebAssembly, one thread. Keys: `,
      ...[["space", "play or pause"], ["← →", "step"], ["+ −", "zoom, with the focus on the map"], ["arrows, enter", "draw, with a tool chosen"]]
        .flatMap(([key, what]) => [element("kbd", {}, key), ` ${what}  `]))));
    await this.generate(this.world.wish());
  }

  addRunBar() {
    this.run = element("button", { type: "button", class: "main", onclick: () => this.try(() => this.plan()) }, "Run");
    this.stop = element("button", { type: "button", disabled: true, onclick: () => this.engine.stop() }, "Stop");
    this.state = element("span", { role: "status", class: "state" });
    this.save = element("button", { type: "button", disabled: true, onclick: () => this.savePath() }, "Path as CSV");
    this.bar.append(this.run, this.stop, checkBox("Compare with exact", true, (on) => (this.comparing = on)), this.save, this.state);
  }

  addEndsCard() {
    const coordinate = (label, put) => numberField({ value: 0, min: 0, max: 0, label, onChange: put });
    this.ends = {
      start: [coordinate("Start, column", (x) => this.setEnds({ ...this.start, x }, this.goal)), coordinate("Start, row", (y) => this.setEnds({ ...this.start, y }, this.goal))],
      goal: [coordinate("Goal, column", (x) => this.setEnds(this.start, { ...this.goal, x })), coordinate("Goal, row", (y) => this.setEnds(this.start, { ...this.goal, y }))] };
    const radius = numberField({ value: 0, min: 0, max: 54, step: "any", label: "Radius of the robot, cells", onChange: (value) => this.setRadius(value) });
    this.card(this.right, "Robot, start and goal").append(element("div", { class: "fields" },
      ...Object.entries(this.ends).flatMap(([name, [x, y]]) => [field(`${name} x`, x), field(`${name} y`, y)]),
      field("radius", radius, "of a disc, 0: a point")));
  }

  addCommandCard() {
    this.command = element("pre", { tabindex: 0, "data-command": true });
    this.commandNote = element("p", { class: "note" });
    this.card(this.left, "The same run by the program").append(
      element("div", { class: "command" }, this.command, copyButton(() => this.command.textContent)), this.commandNote);
  }

  addCharts() {
    const card = this.card(this.left, "Convergence");
    const chart = (title) => new Curves(card, { title, xLabel: "iteration", yLabel: "length, cells", series: [],
                                                onPick: (x) => this.stage.toIteration(x) });
    this.charts = [chart("Best path so far"), chart("Tours of the iteration")];
  }

  tell(problem) {
    this.problem.textContent = problem;
  }

  /** What goes wrong is told on the page. */
  async try(action) {
    this.tell("");
    try {
      await action();
    } catch (error) {
      if (!(error instanceof Stopped)) this.tell(error.message);
    }
  }

  setMap({ width, height, cells }, source) {
    checkSize({ width, height });
    this.map = { width, height, cells, source, number: ++this.maps };
    [this.start, this.goal] = [this.corner(1), this.corner(-1)];
    this.stage.setMap(this.map, this.start, this.goal);
    this.endsChanged();
  }

  /** The free cell nearest to the top left corner (1) or the bottom right one (-1), some cells in. */
  corner(sign) {
    const { width, height, cells } = this.map, inset = 0.04;
    const x = sign > 0 ? inset * width : (1 - inset) * width, y = sign > 0 ? inset * height : (1 - inset) * height;
    let best = { x: sign > 0 ? 0 : width - 1, y: sign > 0 ? 0 : height - 1 }, least = Infinity;
    for (let i = 0; i < cells.length; ++i) {
      if (cells[i]) continue;
      const far = (i % width - x) ** 2 + (Math.floor(i / width) - y) ** 2;
      if (far < least) [least, best] = [far, { x: i % width, y: Math.floor(i / width) }];
    }
    return best;
  }

  setEnds(start, goal) {
    Object.assign(this, { start, goal });
    this.stage.setEnds(start, goal);
    this.endsChanged();
  }

  setRadius(radius) {
    this.radius = radius;
    this.setEnds(this.start, this.goal);
  }

  endsChanged() {
    this.halt();
    for (const [name, [x, y]] of Object.entries(this.ends)) {
      Object.assign(x, { value: this[name].x, max: this.map.width - 1 });
      Object.assign(y, { value: this[name].y, max: this.map.height - 1 });
    }
    this.figures.replaceChildren();
    this.state.textContent = "";
    this.save.disabled = true;
    this.charts.forEach((chart) => chart.set([]));
    this.tellCommand();
  }

  /** A run on a map that has changed means nothing any more. */
  halt() {
    if (this.running) this.engine.stop();
  }

  drawn() {
    this.map.source = { kind: "drawn" };
    this.map.number = ++this.maps;
    this.stage.clear();
    this.endsChanged();
  }

  async generate(wish) {
    this.halt();
    this.setMap(await this.engine.call("generate", wish), { kind: "generated", wish });
  }

  async read(file) {
    this.halt();
    const bytes = new Uint8Array(await file.arrayBuffer());
    this.setMap(await this.engine.call("read", file.name, bytes), { kind: "file", name: file.name });
  }

  empty(width, height) {
    this.setMap({ width, height, cells: new Uint8Array(width * height) }, { kind: "drawn" });
  }

  async saveMap() {
    const name = `${mapFileOf(this.map).replace(/\.\w+$/, "")}.map`;
    saveFile(name, new Blob([await this.engine.text(this.map)]));
  }

  savePath() {
    const points = pairs(this.answer.path), sums = cumulated(points);
    saveCsv("path.csv", ["x", "y", "length"], points.map(([x, y], i) => [x, y, sums[i]]));
  }

  question() {
    return { ...this.colony.question(), start: this.start, goal: this.goal, radius: this.radius };
  }

  tellCommand() {
    if (!this.map) return;
    this.command.textContent = commandOf(this.map, this.question());
    const { kind } = this.map.source;
    this.commandNote.textContent = kind === "drawn" ? `The map was drawn here: save it as ${mapFileOf(this.map)} first.`
                                 : kind === "file" ? "In the folder of the file." : "";
  }

  /** The corners that paths may squeeze past are those of the colony. */
  exactQuestion() {
    const corners = this.colony.valueOf("corners");
    const exact = this.colony.algorithms.find(({ kind }) => kind === "exact");
    const values = corners && exact.parameters.some(({ name }) => name === "corners") ? { corners } : {};
    return { algorithm: exact.name, preset: "usual", seed: 1, values, start: this.start, goal: this.goal, radius: this.radius };
  }

  async plan() {
    if (!this.colony.valid()) return;
    this.busy(true);
    try {
      await this.planned();
    } catch (error) {
      if (error instanceof Stopped) this.stopped();
      else this.state.textContent = "";
      throw error;
    } finally {
      this.busy(false);
      this.stage.endRun();
    }
  }

  busy(running) {
    this.running = running;
    this.run.disabled = running;
    this.stop.disabled = !running;
    this.left.setAttribute("aria-busy", String(running));
    if (!running) return;
    this.save.disabled = true;
    this.state.textContent = "running …";
  }

  async planned() {
    const { kind } = this.colony.algorithm(), question = this.question();
    const iterations = Number(this.colony.valueOf("iterations") ?? 1);
    const most = this.mostFrames();
    this.stage.beginRun({ iterations, most, index: this.colony.valueOf("update") === "terminal-index" });
    const curves = { best: [], mean: [] };
    this.tellFigures(null);
    this.exact = null;
    if (this.comparing && kind !== "exact") {
      this.exact = await this.engine.plan(this.map, this.exactQuestion());
      this.stage.showExact(pairs(this.exact.path));
    }
    this.charts[0].levels = isNumber(this.exact?.length) ? [{ name: "exact", value: this.exact.length }] : [];
    const onFrame = (frame) => {
      this.stage.addFrame(frame);
      [curves.best[frame.iteration - 1], curves.mean[frame.iteration - 1]] = [frame.best, frame.mean];
      this.state.textContent = `running: iteration ${frame.iteration} of ${iterations}`;
      this.drawChart(curves);
    };
    this.finished(await this.engine.plan(this.map, question, { most: kind === "exact" ? 0 : most, onFrame }), kind);
  }

  /** So many frames of the map are kept. */
  mostFrames() {
    const side = Math.ceil(Math.max(this.map.width, this.map.height) / 400);
    const bytes = 8 * Math.ceil(this.map.width / side) * Math.ceil(this.map.height / side);
    return Math.floor(Math.max(8, Math.min(kMostFrames, kFrameBytes / bytes)));
  }

  drawChart({ best, mean }) {
    const points = (list) => {
      const x = [], y = [];
      list.forEach((value, i) => isNumber(value) && (x.push(i + 1), y.push(value)));
      return { x, y };
    };
    this.charts[0].set([{ name: "best path so far", steps: true, colour: "var(--best)", ...points(Array.from(best)) }]);
    this.charts[1].set([{ name: "mean tour, as walked", colour: "var(--tour-mean)", ...points(Array.from(mean)) }]);
  }

  finished(answer, kind) {
    this.answer = answer;
    this.save.disabled = answer.path.length === 0;
    if (answer.path.length) this.stage.showPath(pairs(answer.path));
    if (kind !== "exact") this.drawChart(answer);
    this.state.textContent = statusText({ status: answer.status, error: answer.message });
    this.tellFigures(answer);
  }

  stopped() {
    const last = this.stage.frames.at(-1);
    if (!last) return void (this.state.textContent = "stopped");
    this.state.textContent = `stopped after iteration ${last.iteration}: the best path so far is shown, the command runs all of it`;
    this.tellFigures({ length: last.best, iterations: last.iteration });
  }

  tellFigures(answer) {
    const { exact } = this;
    const gap = answer && exact && exact.length > 0 ? answer.length / exact.length - 1 : null;
    const list = answer ? [
      ["length", isNumber(answer.length) ? `${numberText(answer.length, 3)} cells` : "no path"],
      ["exact", exact && (isNumber(exact.length) ? `${numberText(exact.length, 3)} cells` : "no path")],
      ["above exact", isNumber(gap) ? percentText(gap) : null],
      ["iterations", answer.iterations > 0 ? String(answer.iterations) : null],
      ["time", isNumber(answer.elapsed_ms) ? `${numberText(answer.elapsed_ms, 1)} ms` : null],
    ] : [];
    this.figures.replaceChildren(...list.filter(([, value]) => value != null)
      .map(([name, value]) => element("div", {}, element("dt", {}, name), element("dd", {}, value))));
  }
}

async function openPlayground() {
  const playground = new Playground(new Engine());
  await playground.try(() => playground.begin());
  const told = document.documentElement.dataset;
  told.ready = String(Math.round(performance.now()));
  told.whole = "yes";  // as pages of reports tell it
}

openPlayground();
