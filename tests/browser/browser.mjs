// A real Chromium for tests of pages: Debian's, driven by playwright-core from build/browser
// (tools/setup browser). Where one of them is missing a test ends at once, skipped, and says why.
import assert from "node:assert/strict";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";

const kSkipped = 77;  // SKIP_RETURN_CODE of ctest
const kChromium = process.env.LASIUS_CHROMIUM || "/usr/bin/chromium";
const kDriver = process.env.LASIUS_BROWSER_DRIVER;

function missing(what) {
  console.log(`SKIPPED: ${what} is missing; run tools/setup browser`);
  process.exit(kSkipped);
}

if (!existsSync(kChromium)) missing(kChromium);
if (!existsSync(path.join(kDriver, "node_modules/playwright-core"))) missing("playwright-core");

const { chromium } = createRequire(path.join(kDriver, "x.js"))("playwright-core");
const kFlags = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
                "--disable-component-update", "--disable-sync", "--force-color-profile=srgb"];

export const folder = mkdtempSync(path.join(tmpdir(), "lasius-page-"));

let browser = null;

/** A tab on a file, offline. faults: whatever went wrong in it; requests: all but the page itself. */
export async function open(file, { width = 1280, scheme = "light" } = {}) {
  browser ??= await chromium.launch({ executablePath: kChromium, args: kFlags });
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme: scheme, offline: true,
                                             acceptDownloads: true });
  const tab = await context.newPage(), faults = [], requests = [], url = pathToFileURL(file).href;
  tab.on("console", (message) => ["error", "warning"].includes(message.type()) && faults.push(message.text()));
  tab.on("pageerror", (fault) => faults.push(String(fault)));
  tab.on("dialog", (dialog) => { faults.push(`dialog: ${dialog.message()}`); dialog.dismiss(); });
  tab.on("request", (request) => request.url() !== url && !request.url().startsWith("blob:") && requests.push(request.url()));
  const load = async () => {
    await tab.goto(url);
    await tab.waitForFunction(() => document.documentElement.dataset.whole, null, { timeout: 60000 });
  };
  await load();
  /** Loads the page anew in a window of another width and colour scheme. */
  const again = async (changed) => {
    await tab.setViewportSize({ width: changed.width, height: 900 });
    await tab.emulateMedia({ colorScheme: changed.scheme });
    await load();
  };
  return { tab, faults, requests, again, close: () => context.close() };
}

export async function end() {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
}

/** What a canvas shows once it has been drawn: equal texts are equal pictures. */
export function pixels(tab, selector = ".map canvas") {
  return tab.evaluate((where) => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() =>
    done(document.querySelector(where).toDataURL())))), selector);
}

/** Pixels by which the page is wider than the window. */
export function overflow(tab) {
  return tab.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
}

/** Texts whose contrast to what is behind them is below `least`, by WCAG 2: [text, contrast]. */
export function faintTexts(tab, least = 4.5) {
  return tab.evaluate((limit) => {
    const parse = (colour) => (colour.match(/[\d.]+/g) ?? [0, 0, 0, 0]).map(Number);
    const luminance = (rgb) => rgb.slice(0, 3).map((v) => v / 255)
      .map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4))
      .reduce((sum, v, i) => sum + [0.2126, 0.7152, 0.0722][i] * v, 0);
    const behind = (node) => {
      for (; node; node = node.parentElement) {
        const colour = parse(getComputedStyle(node).backgroundColor);
        if (colour.length < 4 || colour[3] > 0.99) return colour;
      }
      return [255, 255, 255];
    };
    const faint = [], walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    let count = 0;
    for (let text = walker.nextNode(); text; text = walker.nextNode()) {
      const node = text.parentElement, style = getComputedStyle(node);
      if (!text.data.trim() || !node.getClientRects().length || node.closest("script, style, noscript, title")) continue;
      const colour = parse(node.namespaceURI.endsWith("svg") ? style.fill : style.color);
      const [a, b] = [luminance(colour), luminance(behind(node))].sort((x, y) => y - x);
      ++count;
      if ((a + 0.05) / (b + 0.05) < limit) faint.push([text.data.trim().slice(0, 40), (a + 0.05) / (b + 0.05)]);
    }
    return { faint, count };
  }, least);
}

/** Buttons that lie on a map or a scene. */
export function coveringButtons(tab) {
  return tab.evaluate(() => [...document.querySelectorAll("canvas")].flatMap((canvas) => {
    const map = canvas.getBoundingClientRect();
    return [...document.querySelectorAll("button")].filter((button) => {
      const { left, right, top, bottom } = button.getBoundingClientRect();
      return left < map.right && right > map.left && top < map.bottom && bottom > map.top;
    }).map((button) => button.getAttribute("aria-label") ?? button.textContent);
  }));
}

/** What has no name for a screen reader: controls, pictures. */
export function nameless(tab) {
  return tab.evaluate(() => [...document.querySelectorAll("button, input, select, canvas, svg[role=img], [role=img], [role=region]")]
    .filter((node) => document.contains(node) && node.getClientRects().length)
    .filter((node) => !(node.getAttribute("aria-label") || node.textContent.trim() || node.labels?.[0]?.textContent.trim()))
    .map((node) => node.outerHTML.slice(0, 120)));
}

/** Whether a colour that the tests know to be faint is found: the checks above check something. */
export async function checkTheChecks() {
  const { tab, close } = await open(process.env.LASIUS_FAINT_PAGE);
  const { faint } = await faintTexts(tab);
  assert.deepEqual(faint.map(([text]) => text), ["faint"]);
  assert.ok((await overflow(tab)) > 0);
  assert.equal((await nameless(tab)).length, 1);
  await close();
}
