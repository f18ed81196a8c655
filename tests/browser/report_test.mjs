// Reports (-o FILE.html) of every kind in a real browser.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, readFileSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { checkTheChecks, coveringButtons, end, faintTexts, folder, nameless, open, overflow, pixels } from "./browser.mjs";

const maps = process.env.LASIUS_MAPS_DIR;
const map = (name) => path.join(maps, name);
const kFan = [map("fan400x200.map"), "--start", "14,14", "--goal", "380,179"];
const kChanges = "5 30 20 1 40 blocked\n10 move 6 6 0.5 150 60 150 120\n20 200 60 3 60 blocked\n90 200 60 3 30 free\n";
const kStops = "x\ty\tname\n20\t20\tdoor\n100\t30\tshelf\n200\t100\tdesk\n300\t150\t\n0\t17\tclosed\n";
const kCar = { footprint: [[-1, -1], [2, -1], [2, 1], [-1, 1]], turning_radius: 3, units: "cells" };
const kPoses = [[20, 18, 0], [97, 32, 1.5], [61, 82, 3]];
const kWithArm = process.env.LASIUS_WITH_ARM === "1", kWithPolygon = process.env.LASIUS_WITH_POLYGON === "1";

const kReports = {
  colony: ["plan", ...kFan, "--algorithm", "fan2004", "--iterations", "40", "--gap"],
  exact: ["plan", ...kFan],
  genetic: ["plan", map("grid20a.map"), "--start", "0,0", "--goal", "19,19", "--algorithm", "grid-ga", "--iterations", "20"],
  none: ["plan", map("fan400x200.map"), "--start", "14,14", "--goal", "0,17", "--algorithm", "acs", "--iterations", "2"],
  drive: ["drive", ...kFan, "--changes", "changes.txt"],
  tour: ["tour", map("fan400x200.map"), "--stops", "stops.tsv", "--start", "14,14", "--start", "380,179"],
  ants: ["tour", map("fan400x200.map"), "--stops", "stops.tsv", "--algorithm", "mmas", "--iterations", "5"],
  rounds: ["tour", map("fan400x200.map"), "--stops", "poses.json", "--vehicle", "car.json", "--open"],
  ...(kWithPolygon ? { polygon: ["plan", map("maklink200.geojson"), "--algorithm", "maklink-acs", "--iterations", "50"] } : {}),
  ...(kWithArm ? { arm: ["arm", map("arms/industrial6.json"), "--scene", map("arms/cell.json"), "--start", "-0.9,0.3,0.4,0,0.4,0",
                         "--goal", "0.45,0.4,0.5"] } : {}),
  study: ["study", "terminal-index", "--seeds", "1", "--maps", maps],
};
const kPlayed = Object.keys(kReports).filter((kind) => !["exact", "none", "study", "tour", "ants"].includes(kind));
const kLooks = [[1280, "light"], [1280, "dark"], [390, "light"], [390, "dark"]];
const file = (kind) => path.join(folder, `${kind}.html`);

function run(...words) {
  try {
    return execFileSync(process.env.LASIUS_PROGRAM, words, { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
  } catch (fault) {
    if ([4, 5, 6].includes(fault.status)) return fault.stdout;  // no path: a report all the same
    throw fault;
  }
}

function contentOf(kind) {
  const text = readFileSync(file(kind), "utf8");
  return JSON.parse(/<script type="application\/json" id="content">(.*?)<\/script>/s.exec(text)[1]);
}

async function downloaded(tab, name) {
  const [download] = await Promise.all([tab.waitForEvent("download"), tab.getByRole("button", { name }).click()]);
  return readFileSync(await download.path());
}

const slider = (tab) => tab.locator("input[type=range]");
const position = async (tab) => Number(await slider(tab).inputValue());

before(() => {
  writeFileSync(path.join(folder, "changes.txt"), kChanges);
  writeFileSync(path.join(folder, "stops.tsv"), kStops);
  writeFileSync(path.join(folder, "car.json"), JSON.stringify(kCar));
  writeFileSync(path.join(folder, "poses.json"), JSON.stringify(kPoses));
  for (const [kind, words] of Object.entries(kReports)) run(...words, "-q", "-o", file(kind));
});
after(end);

test("the checks find what they are for", checkTheChecks);

for (const kind of Object.keys(kReports)) {
  test(`${kind}: one small file without network, faults, faint or nameless things, narrow and wide`, async () => {
    assert.ok(statSync(file(kind)).size < 5e6);
    const { tab, faults, requests, again, close } = await open(file(kind));
    const all = kind === "colony" || process.env.LASIUS_ALL_LOOKS;  // .ci/nightly
    for (const [width, scheme] of all ? kLooks : [kLooks[0], kLooks.at(-1)]) {
      if (width !== 1280 || scheme !== "light") await again({ width, scheme });
      const where = `${kind} at ${width}, ${scheme}`;
      assert.deepEqual(faults, [], where);
      assert.deepEqual(requests, [], where);
      assert.equal(await overflow(tab), 0, where);
      const { faint, count } = await faintTexts(tab);
      assert.deepEqual(faint, [], where);
      assert.ok(count > 15, `${where}: ${count} texts`);
      assert.deepEqual(await nameless(tab), [], where);
      assert.deepEqual(await coveringButtons(tab), [], where);
      assert.equal(await tab.evaluate(() => document.documentElement.dataset.theme), scheme);
      const content = contentOf(kind);
      assert.equal(await tab.locator("h1").textContent(), content.title);
      assert.equal((await tab.locator("pre").textContent()).trim(), content.command);
      if (width === 1280 && scheme === "light")
        console.log(`${kind}: ${statSync(file(kind)).size} bytes, ready after ${await tab.evaluate(() => document.documentElement.dataset.ready)} ms`);
    }
    await close();
  });
}

for (const kind of kPlayed) {
  test(`${kind}: slider, keys and the play button change the picture`, async () => {
    const { tab, faults, close } = await open(file(kind));
    await tab.keyboard.press("Home");
    const first = await pixels(tab), said = await slider(tab).getAttribute("aria-valuetext");
    assert.equal(await position(tab), 0);
    await tab.keyboard.press("End");
    const last = Number(await slider(tab).getAttribute("max"));
    assert.ok(last > 5);
    assert.equal(await position(tab), last);
    assert.notEqual(await pixels(tab), first);
    assert.notEqual(await slider(tab).getAttribute("aria-valuetext"), said);
    await tab.keyboard.press("ArrowLeft");
    assert.equal(await position(tab), last - 1);
    await slider(tab).fill("0");
    assert.equal(await pixels(tab), first);
    await slider(tab).focus();
    await tab.keyboard.press("ArrowRight");
    assert.equal(await position(tab), 1, "one step, though the slider has the focus");
    await tab.keyboard.press("Home");
    await tab.keyboard.press(" ");
    await tab.waitForFunction(() => Number(document.querySelector("input[type=range]").value) >= 2);
    await tab.keyboard.press(" ");
    await tab.getByRole("button", { name: "Play" }).waitFor();
    await slider(tab).fill(String(Math.max(0, last - 40)));
    await tab.getByRole("combobox", { name: "Speed" }).selectOption("8");
    await tab.getByRole("button", { name: "Play" }).click();
    await tab.waitForFunction((most) => Number(document.querySelector("input[type=range]").value) === most, last);
    await tab.getByRole("button", { name: "Play" }).waitFor();
    assert.deepEqual(faults, []);
    await close();
  });
}

test("colony: curves and slider move each other", async () => {
  const { tab, close } = await open(file("colony"));
  const cursor = () => tab.locator(".curves .cursor line").first().getAttribute("x1").then(Number);
  await tab.keyboard.press("Home");
  const left = await cursor();
  await tab.keyboard.press("End");
  assert.ok((await cursor()) > left + 100);
  const { content, best } = { content: contentOf("colony"), best: tab.locator(".curves .key-value").first() };
  await tab.keyboard.press("Home");
  assert.equal(Number(await best.textContent()).toFixed(2), content.curves.best[0].toFixed(2));
  const box = await tab.locator(".curves svg").first().boundingBox();
  await tab.mouse.click(box.x + 0.6 * box.width, box.y + 0.5 * box.height);
  const at = await position(tab);
  assert.ok(at > 10 && at < 30, `clicked in the middle, at ${at}`);
  await close();
});

test("colony: names, colours and the trail's scale are those of the picture", async () => {
  run(...kReports.colony, "-q", "-o", "colony.svg");
  const words = /<desc>(.*?)<\/desc>/s.exec(readFileSync(path.join(folder, "colony.svg"), "utf8"))[1].replaceAll("\n", " ");
  const { tab, close } = await open(file("colony"));
  const keys = await tab.locator(".key").evaluateAll((list) => list.map((key) => [key.firstChild.nextSibling.textContent,
    getComputedStyle(key.querySelector(".key-line")).borderTopColor]));
  const colours = { "best path so far": "204, 38, 38", "any-angle optimum": "28, 32, 38", "mean tour, as walked": "64, 115, 179",
                    "shortest tour, as walked": "140, 77, 26", "mean tour after the cut": "0, 158, 115", "shortest tour after the cut": "204, 120, 166",
                    "optimum of its own moves": "140, 64, 153" };
  assert.deepEqual(Object.fromEntries(keys), Object.fromEntries(Object.entries(colours).map(([name, rgb]) => [name, `rgb(${rgb})`])));
  for (const name of Object.keys(colours)) if (name !== "shortest tour, as walked") assert.ok(words.includes(name), name);
  await tab.keyboard.press("Home");
  const values = Object.fromEntries(await tab.locator(".key").evaluateAll((list) =>
    list.map((key) => [key.firstChild.nextSibling.textContent, Number(key.lastChild.textContent)])));
  for (const what of [", as walked", " after the cut"]) assert.ok(values[`mean tour${what}`] > values[`shortest tour${what}`], what);
  for (const what of ["mean", "shortest"]) assert.ok(values[`${what} tour, as walked`] > values[`${what} tour after the cut`], what);
  const shown = Number(await tab.locator(".legend-ticks span").first().textContent()), drawn = Number(/white: less than ([\d.e-]+)/.exec(words)[1]);
  assert.ok(Math.abs(shown / drawn - 1) < 0.1, `${shown} on the page, ${drawn} in the picture`);
  await close();
});

test("grown obstacles are paler than those of the map", async () => {
  run("plan", map("grid20a.map"), "--start", "0,0", "--goal", "19,19", "--radius", "1", "-q", "-o", file("radius"));
  const { tab, close } = await open(file("radius"));
  await pixels(tab);
  const seen = await tab.evaluate(() => {
    const canvas = document.querySelector(".map canvas"), { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    const colours = new Set();
    for (let i = 0; i < data.length; i += 4) colours.add(data.slice(i, i + 3).join());
    return ["148,154,163", "211,214,218", "255,255,255"].map((colour) => colours.has(colour));
  });
  assert.deepEqual(seen, [true, true, true]);
  await tab.getByText("no place for the centre: nearer than 1 cell to that", { exact: true }).waitFor();
  await close();
  const image = path.join(folder, "room.pgm"), room = path.join(folder, "room.yaml");
  writeFileSync(image, `P2 20 20 255\n${"255 ".repeat(210)}0 ${"255 ".repeat(189)}\n`);
  writeFileSync(room, `image: ${image}\nresolution: 0.05\norigin: [0, 0, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.2\nnegate: 0\n`);
  run("plan", room, "--frame", "world", "--start", "0.2,0.2", "--goal", "0.8,0.2", "--radius", "0.07", "-q", "-o", file("metres"));
  const metres = await open(file("metres"));
  await metres.tab.getByText("no place for the centre: nearer than 0.07 m to that", { exact: true }).waitFor();
  await metres.close();
});

test("over costs the weights lie under the path, and path and bound meet", async () => {
  run("plan", map("grid20a.map"), "--start", "0,0", "--goal", "19,19", "--inflation", "4,0.5,3", "-q", "-o", file("costs"));
  const { tab, close } = await open(file("costs"));
  await pixels(tab);
  const pale = await tab.evaluate(() => {
    const canvas = document.querySelector(".map canvas"), { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    const colours = new Set();
    for (let i = 0; i < data.length; i += 4) if (data[i] > data[i + 1] && data[i + 1] > data[i + 2] + 20) colours.add(data.slice(i, i + 3).join());
    return colours.size;
  });
  assert.ok(pale > 5, `${pale} tones of weights`);
  await tab.getByText(/^weight of a cell, from 1/).waitFor();
  await tab.getByText(/^cost to the goal, where the proof looked, a line every/).waitFor();
  await tab.getByText("no path is below").first().waitFor({ state: "attached" });
  await tab.getByRole("heading", { name: "Certified gap" }).waitFor();
  assert.match(await tab.locator(".curves", { hasText: "Certified gap" }).locator("title").textContent(), /above the bound, %: from [\d.]+ to [\d.]+/);
  await close();
});

test("drive: charts go to the last tick, and tell no length where no way was found", async () => {
  writeFileSync(path.join(folder, "lane.map"), `type octile\nheight 3\nwidth 20\nmap\n${"@".repeat(20)}\n${".".repeat(20)}\n${"@".repeat(20)}\n`);
  writeFileSync(path.join(folder, "lane.txt"), "3 10 1 blocked\n14 10 1 free\n");
  run("drive", "lane.map", "--start", "0,1", "--goal", "19,1", "--changes", "lane.txt", "--sense", "4", "-q", "-o", file("lane"));
  const { tab, close } = await open(file("lane"));
  const [start, stuck, on] = contentOf("lane").result.replans, chart = tab.locator(".curves").first();
  assert.deepEqual([start.length > 0, stuck.length, on.length > 0], [true, null, true]);
  const at = async (tick) => {
    await slider(tab).fill(String(tick));
    return [await chart.locator(".key-value").textContent(), Number(await chart.locator(".cursor line").getAttribute("x1"))];
  };
  const ends = [stuck.tick - 1, stuck.tick, on.tick - 1, on.tick, contentOf("lane").result.ticks];
  const told = [];
  for (const tick of ends) told.push(await at(tick));
  assert.deepEqual(told.map(([value]) => value), [start.length, "–", "–", on.length, on.length].map(String));
  for (let i = 1; i < told.length; ++i) assert.ok(told[i][1] > told[i - 1][1], "the cursor moves to the end");
  const { line, clip } = await chart.evaluate((frame) => {
    const clip = frame.querySelector("clipPath rect"), [x, width] = ["x", "width"].map((name) => Number(clip.getAttribute(name)));
    const line = frame.querySelector(".curve").getBBox();
    return { line: { x: line.x, width: line.width }, clip: { x, width } };
  });
  assert.ok(line.x >= clip.x + 3 && line.x + line.width <= clip.x + clip.width - 3, "no point is cut in half");
  assert.equal((await chart.locator(".curve").getAttribute("d")).match(/M/g).length, 2);
  await close();
});

test("colony: layers differ, the theme's button changes the picture, zoom too", async () => {
  const { tab, faults, close } = await open(file("colony"));
  const seen = new Set([await pixels(tab)]);
  for (const layer of ["Ants", "Map"]) {
    await tab.getByText(layer, { exact: true }).click();
    seen.add(await pixels(tab));
  }
  await tab.getByRole("checkbox", { name: "Path" }).uncheck();
  seen.add(await pixels(tab));
  await tab.getByRole("button", { name: /Change to dark/ }).click();
  seen.add(await pixels(tab));
  await tab.locator(".map canvas").focus();
  await tab.keyboard.press("+");
  seen.add(await pixels(tab));
  await tab.keyboard.press("ArrowRight");
  seen.add(await pixels(tab));
  assert.equal(seen.size, 7);
  await tab.keyboard.press("0");
  assert.ok(seen.has(await pixels(tab)), "0 shows all again");
  assert.deepEqual(faults, []);
  await close();
});

test("colony: the path tells coordinates, length and clearance", async () => {
  const { tab, close } = await open(file("colony"));
  const { result, map: shown } = contentOf("colony"), canvas = tab.locator(".map canvas");
  const box = await canvas.boundingBox(), [left, top, width, height] = shown.window;
  const scale = Math.min(box.width / width, box.height / height), [x, y] = result.path[1];
  await canvas.hover({ position: { x: 0.5 * box.width + scale * (x - left - 0.5 * width),
                                   y: 0.5 * box.height + scale * (y - top - 0.5 * height) } });
  const text = await tab.locator(".hover").textContent();
  const [, px, py, walked, total, clearance] =
    /x ([\d.]+), y ([\d.]+) · ([\d.]+) cells of ([\d.]+) cells · clearance ([\d.]+) cells/.exec(text) ?? assert.fail(text);
  assert.ok(Math.hypot(px - x, py - y) < 1, text);
  assert.ok(Math.abs(walked - Math.hypot(x - result.path[0][0], y - result.path[0][1])) < 1, text);
  assert.ok(Math.abs(total - result.length) < 0.01, text);
  assert.ok(clearance < 5, `a corner of the path is near a wall: ${text}`);
  await canvas.hover({ position: { x: 3, y: 3 } });
  assert.doesNotMatch(await tab.locator(".hover").textContent(), /clearance/);
  await close();
});

test("colony: path and picture can be taken away", async () => {
  const { tab, close } = await open(file("colony"));
  const { result } = contentOf("colony");
  const [header, ...rows] = String(await downloaded(tab, "Path as CSV")).trim().split("\n").map((line) => line.split(","));
  assert.deepEqual(header, ["x", "y", "length"]);
  assert.deepEqual(rows.map(([x, y]) => [Number(x), Number(y)]), result.path);
  assert.ok(Math.abs(Number(rows.at(-1)[2]) - result.length) < 1e-9 * result.length);
  const png = await downloaded(tab, "Picture as PNG");
  assert.deepEqual([...png.subarray(0, 8)], [137, 80, 78, 71, 13, 10, 26, 10]);
  assert.equal(png.readUInt32BE(16), await tab.evaluate(() => document.querySelector(".map canvas").width));
  await close();
});

test("drive: the track can be taken away, a cell a tick", async () => {
  const { tab, close } = await open(file("drive"));
  const { result } = contentOf("drive");
  const rows = String(await downloaded(tab, "Track as CSV")).trim().split("\n").slice(1).map((line) => line.split(",").map(Number));
  assert.deepEqual(rows.map(([, x, y]) => [x, y]), result.track);
  assert.deepEqual(rows.map(([tick]) => tick), result.track.map((_, tick) => tick));
  await close();
});

test("drive: the track tells coordinates, tick, length and clearance", async () => {
  const { tab, close } = await open(file("drive"));
  await tab.keyboard.press("End");
  const { result, frames, map: shown } = contentOf("drive"), canvas = tab.locator(".map canvas");
  const box = await canvas.boundingBox(), [left, top, width, height] = shown.window;
  const scale = Math.min(box.width / width, box.height / height), tick = Math.floor(result.ticks / 2), [x, y] = result.track[tick];
  await canvas.hover({ position: { x: 0.5 * box.width + scale * (x + 0.5 - left - 0.5 * width),
                                   y: 0.5 * box.height + scale * (y + 0.5 - top - 0.5 * height) } });
  const text = await tab.locator(".hover").textContent();
  const [, px, py, at, clearance] =
    /x ([\d.]+), y ([\d.]+) · tick (\d+) · [\d.]+ cells travelled · clearance of the robot (?:at least )?([\d.]+) cells/.exec(text) ?? assert.fail(text);
  assert.ok(Math.hypot(px - x - 0.5, py - y - 0.5) < 2 && Math.abs(at - tick) < 3, text);
  assert.ok(Math.abs(clearance - frames.clearances.values[at]) < 0.01, text);
  await close();
});

test("polygon: the path can be taken away", { skip: !kWithPolygon }, async () => {
  const { tab, close } = await open(file("polygon"));
  const rows = String(await downloaded(tab, "Path as CSV")).trim().split("\n").slice(1).map((line) => line.split(",").map(Number));
  assert.deepEqual(rows.map(([x, y]) => [x, y]), contentOf("polygon").result.path);
  await close();
});

test("arm: it can be turned, by hand and by keys, and its motion taken away", { skip: !kWithArm }, async () => {
  const { tab, faults, close } = await open(file("arm"));
  const before = await pixels(tab), box = await tab.locator(".map canvas").boundingBox();
  await tab.mouse.move(box.x + 100, box.y + 100);
  await tab.mouse.down();
  await tab.mouse.move(box.x + 200, box.y + 130);
  await tab.mouse.up();
  const dragged = await pixels(tab);
  assert.notEqual(dragged, before);
  const at = await position(tab);
  await tab.keyboard.press("Tab");
  await tab.locator(".map canvas").focus();
  await tab.keyboard.press("ArrowLeft");
  assert.notEqual(await pixels(tab), dragged);
  assert.equal(await position(tab), at, "keys of the picture are not the player's");
  await tab.keyboard.press("0");
  assert.equal(await pixels(tab), before);
  const rows = String(await downloaded(tab, "Path as CSV")).trim().split("\n");
  const { motion, result } = contentOf("arm");
  assert.deepEqual(rows[0].split(","), ["t", ...motion.names, "x", "y", "z"]);
  assert.equal(rows.length, motion.times.length + 1);
  const tip = rows.at(-1).split(",").slice(-3).map(Number);
  tip.forEach((value, axis) => assert.ok(Math.abs(value - result.goal[axis]) < 1e-4));
  assert.deepEqual(faults, []);
  await close();
});

test("arm: the way of the tip tells place, length and clearance", { skip: !kWithArm }, async () => {
  const { tab, faults, close } = await open(file("arm"));
  await tab.keyboard.press("Home");
  const first = await tab.locator(".hover").textContent();
  assert.match(first, /^Tip at .* m · 0 m of [\d.]+ m travelled · clearance of the arm [\d.]+ m$/);
  const box = await tab.locator(".map canvas").boundingBox();
  const found = await tab.evaluate(() => {  // a pixel near the way, beyond the first tip
    const canvas = document.querySelector(".map canvas"), { left, top, right, bottom } = canvas.getBoundingClientRect();
    for (let y = top + 5; y < bottom; y += 10)
      for (let x = left + 5; x < right - 60; x += 10) {
        canvas.dispatchEvent(new PointerEvent("pointermove", { clientX: x, clientY: y }));
        if (document.querySelector(".hover").textContent.startsWith("After")) return [x, y];
      }
    return null;
  });
  await tab.mouse.move(...found);
  const told = await tab.locator(".hover").textContent();
  assert.match(told, /^After [\d.]+ s: tip at .* m travelled · clearance of the arm [\d.]+ m$/);
  assert.equal(await position(tab), 0, "the slider stays");
  await tab.mouse.move(box.x + 2, box.y + 2);
  assert.equal(await tab.locator(".hover").textContent(), first);
  assert.deepEqual(faults, []);
  await close();
});

test("study: a click on a column sorts by it; another question is shown", async () => {
  const { tab, faults, close } = await open(file("study"));
  const head = tab.locator("th", { hasText: "median" }).first();
  await head.getByRole("button").click();
  assert.equal(await head.getAttribute("aria-sort"), "ascending");
  const column = (await tab.locator("table").filter({ has: head }).first().locator("thead th").allTextContents()).indexOf("median");
  const values = (await tab.locator("table").filter({ has: head }).first().locator("tbody tr").all());
  const numbers = [];
  for (const row of values) numbers.push(Number(await row.locator("td").nth(column).textContent()));
  const finite = numbers.filter((value) => Number.isFinite(value) && value > 0);
  assert.ok(finite.length > 2);
  assert.deepEqual(finite, [...finite].sort((a, b) => a - b));
  const card = tab.locator("section").filter({ has: tab.getByRole("combobox") }).first();
  const name = await card.getByRole("combobox").locator("option").nth(1).textContent();
  await card.getByRole("combobox").selectOption({ index: 1 });
  await card.locator(".panes h3").filter({ hasText: name }).first().waitFor();
  assert.deepEqual(faults, []);
  await close();
});

test("text from outside stays text", async () => {
  const hostile = `</script><img src=x onerror=alert(1)>&"'.map`.replaceAll("/", "\u2215");
  copyFileSync(map("grid20a.map"), path.join(folder, hostile));
  run("plan", hostile, "--start", "0,0", "--goal", "19,19", "-q", "-o", file("hostile"));
  const { tab, faults, close } = await open(file("hostile"));
  assert.match(await tab.locator("h1").textContent(), /<img src=x onerror=alert\(1\)>&"'\.map/);
  assert.match(await tab.title(), /<img src=x onerror=alert\(1\)>&"'\.map/);
  assert.equal(await tab.locator("img").count(), 0);
  assert.deepEqual(faults, []);
  await close();
});
