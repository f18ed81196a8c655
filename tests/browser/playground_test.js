// The playground in a real Chromium, opened from disk: tests/browser/playground_test.js PAGE PROGRAM
// [PICTURES]. It draws, plans, copies the command, and the program gives the same path. With a
// folder PICTURES the page is kept there as PNG, wide and narrow, light and dark.
"use strict";
const assert = require("node:assert/strict");
const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");

const root = path.resolve(__dirname, "../..");
const { chromium } = require(path.join(root, "build/browser/node_modules/playwright-core"));

const [page_file, program, pictures] = process.argv.slice(2).map((name) => path.resolve(name));
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "playground-"));
const kWait = { timeout: 120000 };
const kArguments = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
                    "--disable-component-update", "--disable-sync"];

/** A page with what it did wrong. */
async function opened(browser, options) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, acceptDownloads: true, ...options });
  const page = await context.newPage(), faults = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && faults.push(message.text()));
  page.on("pageerror", (error) => faults.push(error.stack));
  page.on("request", (request) => /^(file|blob|data):/.test(request.url()) || faults.push(`asked for ${request.url()}`));
  await page.goto(`file://${page_file}`);
  await page.waitForSelector("html[data-ready]", kWait);
  const tools = {
    page, context, faults,
    text: (selector) => page.locator(selector).innerText(),
    press: (name) => page.getByRole("button", { name, exact: true }).click(),
    tool: (name) => page.locator(".choices label", { hasText: new RegExp(`^${name}$`) }).click(),
    shown: () => page.locator(".map canvas").evaluate((canvas) => canvas.toDataURL()),
    state: (pattern) => page.waitForFunction((source) => new RegExp(source).test(document.querySelector(".state").textContent), pattern.source, kWait),
    set: async (label, value) => { await page.getByLabel(label, { exact: true }).fill(String(value)); await page.keyboard.press("Tab"); },
    problem: (pattern) => page.waitForFunction((source) => new RegExp(source).test(document.querySelector(".problem").textContent), pattern.source, kWait),
  };
  tools.frameText = () => tools.text(".frame-text");
  tools.saved = async (button, name) => {
    const [download] = await Promise.all([page.waitForEvent("download"), tools.press(button)]);
    assert.equal(download.suggestedFilename(), name);
    await download.saveAs(path.join(folder, name));
    return fs.readFileSync(path.join(folder, name), "utf8");
  };
  tools.run = async () => {
    await tools.press("Run");
    await tools.state(/^(Solved|No path|Proven|Invalid)/);
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

const tests = {
  async "a generated map: every kind of algorithm gives the program's path"(browser) {
    const { page, run, faults, ...tools } = await opened(browser);
    for (const algorithm of ["fan2004", "acs", "exact"]) {
      await page.getByLabel("Algorithm", { exact: true }).selectOption(algorithm);
      if (algorithm === "acs") await page.locator("[data-parameter=iterations]").fill("30");
      await run();
      await sameByProgram(tools);
    }
    assert.deepEqual(faults, []);
  },

  async "a drawn map is saved, and its command gives the same path"(browser) {
    const { page, run, faults, ...tools } = await opened(browser);
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
    await page.locator("[data-parameter=iterations]").fill("12");
    await page.locator("[data-parameter=ants]").fill("5");
    await run();
    const map = await tools.saved("Save as .map", "playground.map");
    assert.match(map, /^type octile\nheight 40\nwidth 60\nmap\n/);
    assert.ok(map.split("\n")[4 + 5].includes("@@@"), "the wall is in the file");
    const native = await sameByProgram(tools);
    assert.equal(native.iterations, 12);
    assert.equal(native.parameters.ants, 5);
    assert.ok(native.length > 56, "the wall is in the way");
    assert.deepEqual(faults, []);
  },

  async "keys draw, set the ends and play"(browser) {
    const { page, run, faults, ...tools } = await opened(browser);
    await tools.press("Empty sheet");
    await tools.tool("Start");
    await page.locator(".map canvas").focus();
    await page.keyboard.press("Shift+ArrowLeft");
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("Enter");
    assert.match(await tools.text("[data-command]"), /--start 110,69 /);
    await tools.set("Goal, column", 200);
    assert.match(await tools.text("[data-command]"), /--goal 200,\d+ /);
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
    assert.match(await tools.frameText(), /^iteration 1 of 120$/);
    const first = await tools.shown();
    await page.keyboard.press("End");
    assert.match(await tools.frameText(), /^iteration 120 of 120$/);
    await page.keyboard.press("ArrowLeft");
    assert.match(await tools.frameText(), /^iteration 119 of 120$/);
    assert.notEqual(await tools.shown(), first);
    await page.keyboard.press("Home");
    await page.locator("h1").click();
    await page.keyboard.press(" ");
    await page.waitForFunction(() => /^iteration ([2-9]|\d\d)/.test(document.querySelector(".frame-text").textContent), null, kWait);
    assert.deepEqual(faults, []);
  },

  async "a run is watched, stopped, and another begins"(browser) {
    const { page, run, faults, ...tools } = await opened(browser);
    await page.getByLabel("Algorithm", { exact: true }).selectOption("mmas");
    await page.locator("[data-parameter=iterations]").fill("1000000");
    await tools.press("Run");
    await page.waitForFunction(() => /^running: iteration/.test(document.querySelector(".state").textContent), null, kWait);
    assert.equal(await page.getByRole("button", { name: "Run", exact: true }).isDisabled(), true);
    await tools.press("Stop");
    await tools.state(/^stopped after iteration \d+/);
    await page.getByLabel("Algorithm", { exact: true }).selectOption("fan2004");
    await run();
    assert.match(await tools.text(".figures"), /iterations\s+120/);
    assert.deepEqual(faults, []);
  },

  async "the command is copied"(browser) {
    const { page, faults, ...tools } = await opened(browser);
    await page.locator("[data-parameter=alpha]").fill("3.5");
    await page.keyboard.press("Tab");
    await tools.press("Copy");
    await page.getByRole("button", { name: "Copied", exact: true }).waitFor(kWait);
    await page.evaluate(() => document.body.append(Object.assign(document.createElement("textarea"), { id: "paste" })));
    await page.locator("#paste").focus();
    await page.keyboard.press("Control+V");
    const pasted = await page.locator("#paste").inputValue();
    assert.equal(pasted, await tools.text("[data-command]"));
    assert.match(pasted, / --algorithm fan2004 --seed 1 --set alpha=3.5$/);
    assert.deepEqual(faults, []);
  },

  async "files: PBM and PGM are read, a broken one is told"(browser) {
    const { page, run, faults, ...tools } = await opened(browser);
    const give = (name, content) => page.setInputFiles("#map-file", { name, mimeType: "application/octet-stream", buffer: Buffer.from(content) });
    await give("a b.pbm", "P1\n6 3\n0 0 0 0 0 0\n0 1 1 1 1 0\n0 0 0 0 0 0\n");
    await page.waitForFunction(() => document.querySelector("[data-command]").textContent.includes("a b.pbm"), null, kWait);
    fs.writeFileSync(path.join(folder, "a b.pbm"), "P1\n6 3\n0 0 0 0 0 0\n0 1 1 1 1 0\n0 0 0 0 0 0\n");
    await run();
    await sameByProgram(tools);
    await give("grey.pgm", "P2\n2 1\n255\n255 255\n");
    await page.waitForFunction(() => document.querySelector("[data-command]").textContent.includes("grey.pgm"), null, kWait);
    await give("broken.map", "type octile\nheight 2\nwidth 2\nmap\n..\n");
    await tools.problem(/broken\.map/);
    await give("wide.pbm", `P1\n2049 1\n${"0".repeat(2049)}\n`);
    await tools.problem(/2049 × 1 cells/);
    assert.match(await tools.text("[data-command]"), /grey\.pgm/, "what could not be read changed nothing");
    assert.deepEqual(faults, []);
  },

  async "questions without an answer, and values out of range"(browser) {
    const { page, run, faults, ...tools } = await opened(browser);
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
    await page.locator("[data-parameter=ants]").fill("0");
    await tools.press("Run");
    assert.match(await tools.text(".state"), /^Invalid question/, "no run with a value out of range");
    assert.equal(await page.locator("[data-parameter=ants]").evaluate((input) => input.validity.rangeUnderflow), true);
    assert.deepEqual(faults, []);
  },

  async "wide and narrow, light and dark"(browser) {
    for (const width of [1280, 390]) {
      const seen = new Set();
      for (const colorScheme of ["light", "dark"]) {
        const { page, run, shown, faults } = await opened(browser, { viewport: { width, height: 844 }, colorScheme });
        await run();
        await page.getByRole("button", { name: "Run", exact: true }).focus();
        await page.keyboard.press("End");
        const beyond = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        assert.ok(beyond <= 0, `${width}, ${colorScheme}: ${beyond} pixels too wide`);
        seen.add(await shown());
        if (pictures) await page.screenshot({ path: path.join(pictures, `playground-${width}-${colorScheme}.png`), fullPage: true });
        const unnamed = await page.evaluate(() => [...document.querySelectorAll("button, input, select, canvas")]
          .filter((each) => !each.hidden && !(each.labels?.length || each.ariaLabel || each.textContent.trim())).map((each) => each.outerHTML));
        assert.deepEqual(unnamed, [], "every control has a name");
        assert.deepEqual(faults, []);
        await page.close();
      }
      assert.equal(seen.size, 2, "dark is not light");
    }
  },
};

async function main() {
  assert.ok(fs.statSync(page_file).size < 3e6, "the page is below 3 MB");
  if (pictures) fs.mkdirSync(pictures, { recursive: true });
  const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: kArguments });
  let failed = 0;
  for (const [name, test] of Object.entries(tests)) {
    try {
      await test(browser);
      console.log(`ok      ${name}`);
    } catch (error) {
      ++failed;
      console.log(`FAILED  ${name}\n${error.stack}`);
    }
  }
  const { page } = await opened(browser);
  console.log(`interactive after ${await page.evaluate(() => document.documentElement.dataset.ready)} ms`);
  await browser.close();
  fs.rmSync(folder, { recursive: true });
  process.exitCode = failed === 0 ? 0 : 1;
}

main();
