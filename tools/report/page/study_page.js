// The report of a study: tables, and for each question its charts and best paths.

import { Curves, kCurveColours } from "./curves.js";
import { groundLayer, placeText, wallImage } from "./bitmap_page.js";
import { element, isNumber, numberText, onTheme, themeColour } from "./dom.js";
import { MapView } from "./map_view.js";
import { Sheet } from "./sheet.js";
import { dataTable } from "./table.js";

/** The map with the best path of every contender, the first on top. */
async function showMap(host, map, unit) {
  const { window: [x, y, width, height] } = map, walls = await wallImage(map.walls);
  const readout = element("div", { class: "hover", role: "status" });
  const view = new MapView(host, { low: [x, y], high: [x + width, y + height], label: "Map with the best path of each contender",
                                   onHover: (px, py) => { readout.textContent = px == null ? "" : placeText(map, [px, py]); } });
  const colour = (i) => themeColour(`--curve-${(i % kCurveColours) + 1}`);
  const hidden = new Set();
  view.layers = [groundLayer(map), (context) => view.image(context, walls, x, y, width, height, view.scale < 1), (context) => {
    for (let i = map.paths.length - 1; i >= 0; --i)
      if (map.paths[i].path && !hidden.has(i)) view.line(context, map.paths[i].path, colour(i), 2.5 + 1.5 * Math.min(i, 3));
    const middle = (cell) => cell.map((value) => value + 0.5);
    view.ends(context, middle(map.start), middle(map.goal));
  }];
  const keys = map.paths.map(({ name, length }, i) => {
    const key = element("button", { type: "button", class: "key", "aria-pressed": "true" },
      element("span", { class: "key-line", style: `border-color:var(--curve-${(i % kCurveColours) + 1})` }), name,
      element("span", { class: "key-value" }, isNumber(length) ? `${numberText(length, 2)} ${unit}` : "no path"));
    key.addEventListener("click", () => {
      hidden.has(i) ? hidden.delete(i) : hidden.add(i);
      key.setAttribute("aria-pressed", String(!hidden.has(i)));
      view.draw();
    });
    return key;
  });
  host.append(readout, element("div", { class: "keys" }, ...keys));
  onTheme(() => view.draw());
}

async function showView(host, view, unit) {
  host.replaceChildren();
  if (view.map) {
    const card = element("div", { class: "pane" });
    host.append(card);
    await showMap(card, view.map, unit);
  }
  for (const chart of view.charts) {
    const card = element("div", { class: "pane" });
    host.append(card);
    new Curves(card, { title: chart.title, xLabel: chart.x_label, yLabel: chart.y_label, calm: chart.calm, levels: chart.levels,
                       decimals: 3, series: chart.curves.map((curve) => ({ ...curve, low: curve.low.length ? curve.low : null,
                                                                           high: curve.high.length ? curve.high : null, steps: true })) });
  }
}

/** The card of an experiment, and what shows its first question. */
function experimentCard(sheet, { title, text, results, views }) {
  const card = element("section", { class: "card" }, element("h2", {}, title), text ? element("p", { class: "note" }, text) : null);
  sheet.root.append(card);
  if (results.rows.length) card.append(dataTable(results.header, results.rows, "Results"));
  if (!views.length) return async () => {};
  const host = element("div", { class: "panes" });
  const select = element("select", { "aria-label": `Question of ${title}`, onchange: () => showView(host, views[select.value], sheet.content.unit) },
                         ...views.map(({ name }, i) => element("option", { value: i }, name)));
  if (views.length > 1) card.append(element("label", { class: "row" }, "Shown: ", select));
  card.append(host);
  return () => showView(host, views[0], sheet.content.unit);
}

export async function showStudy(content) {
  const sheet = new Sheet(content);
  if (content.text) sheet.root.append(element("p", { class: "note lead" }, content.text));
  if (!content.whole) sheet.root.append(element("p", { class: "note lead" }, "The study was interrupted: this report is partial."));
  if (content.left_out)
    sheet.root.append(element("p", { class: "note lead" }, `${content.left_out} charts are left out to keep this page small; they are in the study's folder.`));
  if (content.claims.rows.length)
    sheet.root.append(element("section", { class: "card" }, element("h2", {}, "Claims"),
                              dataTable(content.claims.header, content.claims.rows, "What the source says, and what was found")));
  const [first, ...others] = content.experiments.map((experiment) => experimentCard(sheet, experiment));
  sheet.root.append(element("div", { class: "columns single" }, sheet.sides.rest));
  sheet.finish();
  await first?.();
  return async () => {
    for (const show of others) await show();
  };
}
