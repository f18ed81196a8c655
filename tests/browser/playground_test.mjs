// The playground in a real browser, opened from disk: it draws, plans, copies the command, and the
// program gives the same path. LASIUS_PLAYGROUND is the page; with a folder LASIUS_PICTURES it is kept
// there as PNG, wide and narrow, light and dark.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";
import { after, test } from "node:test";

const page_file = process.env.LASIUS_PLAYGROUND, program = process.env.LASIUS_PROGRAM, pictures = process.env.LASIUS_PICTURES;
if (!existsSync(page_file)) {
  console.log(`SKIPPED: ${page_file} is missing; run tools/playground/build`);
  process.exit(77);
}
const { coveringButtons, end, faintTexts, folder, nameless, open, overflow, pixels } = await import("./browser.mjs");
const kWait = { timeout: 120000 };

/** A tab with what the tests do in it; nothing went wrong in it when it is closed. */
async function opened(options) {
  const { tab: page, faults, requests, close } = await open(page_file, options);
  const tools = {
    page,
    text: (selector) => page.locator(selector).innerText(),
    press: (name) => page.getByRole("button", { name, exact: true }).click(),
    tool: (name) => page.locator(".choices label", { hasText: new RegExp(`^${name}$`) }).click(),
    shown: () => pixels(page),
    told: (selector, pattern) =>
      page.waitForFunction(([where, source]) => new RegExp(source).test(document.querySelector(where).textContent), [selector, pattern.source], kWait),
    set: async (label, value) => {
      await page.getByLabel(label, { exact: true }).fill(String(value));
      await page.keyboard.press("Tab");
    },
    parameter: (name, value) => page.locator(`[data-parameter=${name}]`).fill(String(value)),
    choose: (algorithm) => page.getByLabel("Algorithm", { exact: true }).selectOption(algorithm),
    command: () => tools.text("[data-command]"),
  };
  tools.saved = async (button, name) => {
    const [download] = await Promise.all([page.waitForEvent("download"), tools.press(button)]);
    assert.equal(download.suggestedFilename(), name);
    await download.saveAs(path.join(folder, name));
    return readFileSync(path.join(folder, name), "utf8");
  };
  /** On a new sheet of 60 x 40 cells, from the top down to some way above the bottom. */
  tools.drawWall = async () => {
    await tools.set("Width, cells", 60);
    await tools.set("Height, cells", 40);
    await tools.press("Empty sheet");
    const before = await tools.shown(), box = await page.locator(".map canvas").boundingBox();
    await tools.tool("Draw walls");
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 2);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.7 * box.height, { steps: 8 });
    await page.mouse.up();
    assert.notEqual(await tools.shown(), before);
  };
  tools.run = async () => {
    await tools.press("Run");
    await tools.told(".state", /^(Solved|No path|Proven|Invalid)/);
  };
  tools.done = async () => {
    assert.deepEqual(faults, []);
    assert.deepEqual(requests, []);
    await close();
  };
  return tools;
}

/** The page's command, run as a reader would: its words, with the program's name replaced. */
function byProgram(command) {
  const script = command.replace(/^lasius /gm, `${program} `) + " --json";
  return JSON.parse(execFileSync("sh", ["-ec", script], { cwd: folder, encoding: "utf8", maxBuffer: 1 << 28 }));
}

async function sameByProgram({ text, saved }) {
  const rows = (await saved("Path as CSV", "path.csv")).trim().split("\n").slice(1).map((line) => line.split(",").map(Number));
  const native = byProgram(await text("[data-command]"));
  assert.equal(native.status, "solved");
  assert.deepEqual(rows.map(([x, y]) => [x, y]), native.path);
  assert.match(await text(".figures"), new RegExp(`length\\s+${native.length.toFixed(3).replace(/\.?0+$/, "")} cells`));
  return native;
}

test("a generated map: every kind of algorithm gives the program's path", async () => {
  const { page, run, ...tools } = await opened();
  for (const algorithm of ["fan2004", "acs", "exact"]) {
    await tools.choose(algorithm);
    if (algorithm === "acs") await tools.parameter("iterations", 30);
    await run();
    await sameByProgram(tools);
  }
  await tools.done();
});

test("a disc: the exact curve's polyline and a colony's path are the program's", async () => {
  const { run, ...tools } = await opened();
  await tools.drawWall();
  await tools.saved("Save as .map", "playground.map");
  await tools.set("Radius of the robot, cells", 1.5);
  assert.match(await tools.command(), /--radius 1.5 /);
  for (const algorithm of ["acs", "exact"]) {
    await tools.choose(algorithm);
    if (algorithm === "acs") await tools.parameter("iterations", 10);
    await run();
    const native = await sameByProgram(tools);
    if (algorithm === "exact") assert.ok(native.curve.some(({ turn }) => turn), "it goes around something");
  }
  await tools.done();
});

test("a drawn map is saved, and its command gives the same path", async () => {
  const { run, ...tools } = await opened();
  await tools.drawWall();
  await tools.parameter("iterations", 12);
  await tools.parameter("ants", 5);
  await run();
  const map = await tools.saved("Save as .map", "playground.map");
  assert.match(map, /^type octile\nheight 40\nwidth 60\nmap\n/);
  assert.ok(map.split("\n")[4 + 5].includes("@@@"), "the wall is in the file");
  const native = await sameByProgram(tools);
  assert.equal(native.iterations, 12);
  assert.equal(native.parameters.ants, 5);
  assert.ok(native.length > 56, "the wall is in the way");
  await tools.done();
});

test("keys draw, set the ends and play", async () => {
  const { page, run, ...tools } = await opened();
  await tools.press("Empty sheet");
  await tools.tool("Start");
  await page.locator(".map canvas").focus();
  await page.keyboard.press("Shift+ArrowLeft");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  assert.match(await tools.command(), /--start 110,69 /);
  await tools.set("Goal, column", 200);
  assert.match(await tools.command(), /--goal 200,\d+ /);
  await tools.tool("Draw walls");
  await page.locator(".map canvas").focus();
  await page.keyboard.press("Shift+ArrowRight");
  const before = await tools.shown();
  await page.keyboard.press(" ");
  assert.notEqual(await tools.shown(), before);
  await tools.tool("Look");
  await run();
  assert.equal(await tools.text(".state"), "Solved");
  await page.getByRole("button", { name: "Run", exact: true }).focus();
  await page.keyboard.press("Home");
  assert.match(await tools.text(".frame-text"), /^iteration 1 of 120$/);
  const first = await tools.shown();
  await page.keyboard.press("End");
  assert.match(await tools.text(".frame-text"), /^iteration 120 of 120$/);
  await page.keyboard.press("ArrowLeft");
  assert.match(await tools.text(".frame-text"), /^iteration 119 of 120$/);
  assert.notEqual(await tools.shown(), first);
  await page.keyboard.press("Home");
  await page.locator("h1").click();
  await page.keyboard.press(" ");
  await tools.told(".frame-text", /^iteration ([2-9]|\d\d)/);
  await tools.done();
});

test("a run is watched, stopped, and another begins", async () => {
  const { page, run, ...tools } = await opened();
  await tools.choose("mmas");
  await tools.parameter("iterations", 1000000);
  await tools.press("Run");
  await tools.told(".state", /^running: iteration/);
  assert.equal(await page.getByRole("button", { name: "Run", exact: true }).isDisabled(), true);
  await tools.press("Stop");
  await tools.told(".state", /^stopped after iteration \d+/);
  await tools.choose("fan2004");
  await run();
  assert.match(await tools.text(".figures"), /iterations\s+120/);
  await tools.done();
});

test("the command is copied", async () => {
  const { page, ...tools } = await opened();
  await tools.parameter("alpha", 3.5);
  await page.keyboard.press("Tab");
  await tools.press("Copy");
  await page.getByRole("button", { name: "Copied", exact: true }).waitFor(kWait);
  await page.evaluate(() => document.body.append(Object.assign(document.createElement("textarea"), { id: "paste" })));
  await page.locator("#paste").focus();
  await page.keyboard.press("Control+V");
  const pasted = await page.locator("#paste").inputValue();
  assert.equal(pasted, await tools.command());
  assert.match(pasted, / --algorithm fan2004 --seed 1 --set alpha=3.5$/);
  await tools.done();
});

test("files: PBM and PGM are read, a broken one is told", async () => {
  const { page, run, ...tools } = await opened();
  const give = (name, content) => page.setInputFiles("#map-file", { name, mimeType: "application/octet-stream", buffer: Buffer.from(content) });
  await give("a b.pbm", "P1\n6 3\n0 0 0 0 0 0\n0 1 1 1 1 0\n0 0 0 0 0 0\n");
  await tools.told("[data-command]", /a b\.pbm/);
  writeFileSync(path.join(folder, "a b.pbm"), "P1\n6 3\n0 0 0 0 0 0\n0 1 1 1 1 0\n0 0 0 0 0 0\n");
  await run();
  await sameByProgram(tools);
  await give("grey.pgm", "P2\n2 1\n255\n255 255\n");
  await tools.told("[data-command]", /grey\.pgm/);
  await give("broken.map", "type octile\nheight 2\nwidth 2\nmap\n..\n");
  await tools.told(".problem", /broken\.map/);
  await give("wide.pbm", `P1\n2049 1\n${"0".repeat(2049)}\n`);
  await tools.told(".problem", /2049 × 1 cells/);
  assert.match(await tools.command(), /grey\.pgm/, "what could not be read changed nothing");
  await tools.done();
});

test("questions without an answer, and values out of range", async () => {
  const { page, run, ...tools } = await opened();
  await tools.set("Width, cells", 21);
  await tools.set("Height, cells", 9);
  await tools.press("Empty sheet");
  await tools.tool("Draw walls");
  const box = await page.locator(".map canvas").boundingBox();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + box.height - 2, { steps: 8 });
  await page.mouse.up();
  await run();
  assert.match(await tools.text(".state"), /^Proven unreachable/);
  await tools.set("Goal, column", 10);
  await run();
  assert.match(await tools.text(".state"), /^Invalid question/);
  await tools.parameter("ants", 0);
  await tools.press("Run");
  assert.match(await tools.text(".state"), /^Invalid question/, "no run with a value out of range");
  assert.equal(await page.locator("[data-parameter=ants]").evaluate((input) => input.validity.rangeUnderflow), true);
  await tools.done();
});

test("wide and narrow, light and dark", async () => {
  if (pictures) mkdirSync(pictures, { recursive: true });
  for (const width of [1280, 390]) {
    const seen = new Set();
    for (const scheme of ["light", "dark"]) {
      const { page, run, shown, done } = await opened({ width, scheme });
      await run();
      await page.getByRole("button", { name: "Run", exact: true }).focus();
      await page.keyboard.press("End");
      await page.locator("summary", { hasText: "All parameters" }).click();
      await page.locator("summary", { hasText: "Formulas" }).click();
      assert.ok((await overflow(page)) <= 0, `${width}, ${scheme}: too wide`);
      assert.deepEqual(await nameless(page), []);
      assert.deepEqual(await coveringButtons(page), []);
      assert.deepEqual((await faintTexts(page)).faint, []);
      seen.add(await shown());
      if (pictures) await page.screenshot({ path: path.join(pictures, `playground-${width}-${scheme}.png`), fullPage: true });
      await done();
    }
    assert.equal(seen.size, 2, "dark is not light");
  }
});

test("one small page", async (context) => {
  assert.ok(statSync(page_file).size < 3e6);
  const { page, done } = await opened();
  context.diagnostic(`interactive after ${await page.evaluate(() => document.documentElement.dataset.ready)} ms`);
  await done();
});

after(end);
