// The page around a view: title, figures, two columns of cards, what every report tells.
//
//   sheet = new Sheet(content)               content: what the program wrote, see tools/report/report.h
//   sheet.figures([["length", "12 cells"]])
//   card = sheet.card("left" | "right" | "rest", heading)   an element to fill; rest is below left
//   sheet.finish()                           parameters, command line, keys, footer
//   choices(name, [["trail", "Trail"]], chosen, onChange), checkBox(text, on, onChange), swatches([[name, variable, "line"]])

import { cutText, element, isNumber, numberText, themeButton } from "./dom.js";
import { copyButton } from "./files.js";
import { factTable } from "./table.js";

const kStatus = {
  solved: "Solved", limit: "A limit ended the run", interrupted: "Interrupted", unreachable: "Proven unreachable",
  no_path: "No path found", invalid: "Invalid question" };

export function statusText(result) {
  return (kStatus[result.status] ?? result.status) + (result.error ? `: ${result.error}` : "");
}

export function percentText(share) {
  return isNumber(share) ? `${numberText(100 * share, 3)}%` : "none";
}

export function choices(name, options, chosen, onChange) {
  const labels = options.map(([value, text]) => element("label", {},
    element("input", { type: "radio", name, value, checked: value === chosen, onchange: () => onChange(value) }), text));
  return element("div", { class: "choices", role: "radiogroup", "aria-label": name }, ...labels);
}

export function checkBox(text, on, onChange) {
  const box = element("input", { type: "checkbox", checked: on, onchange: () => onChange(box.checked) });
  return element("label", { class: "check" }, box, text);
}

export function swatches(entries) {
  return element("div", { class: "swatches" }, ...entries.map(([name, variable, kind]) =>
    element("span", {}, element("i", { class: kind, style: kind === "line" ? `color:var(${variable})` : `background:var(${variable})` }), name)));
}

function text(value) {
  return Array.isArray(value) ? value.map(text).join(", ") || "none" : value === null ? "none" : String(value);
}

export class Sheet {
  constructor(content) {
    this.content = content;
    const { result, title } = content;
    this.root = document.getElementById("report");
    this.sides = Object.fromEntries(["left", "right", "rest"].map((side) => [side, element("div", { class: side })]));
    this.root.append(
      element("header", {}, element("div", {}, element("h1", {}, cutText(title, 300)),
                                    element("p", { class: "subtitle" }, result ? statusText(result) : content.subtitle ?? "")),
              themeButton()));
  }

  figures(list) {
    const shown = list.filter(([, value]) => value != null);
    this.root.append(element("dl", { class: "figures" },
                             ...shown.map(([name, value]) => element("div", {}, element("dt", {}, name), element("dd", {}, value)))));
    this.root.append(element("div", { class: "columns" }, ...Object.values(this.sides)));
  }

  card(side, heading) {
    const card = element("section", { class: "card" }, heading ? element("h2", {}, heading) : null);
    this.sides[side].append(card);
    return card;
  }

  /** The length of something in the result's unit, as shown. */
  length(value, decimals = 2) {
    if (!isNumber(value)) return null;
    const { scale = 1, unit, length_unit } = this.content;
    return `${numberText(scale * value, decimals)} ${unit || length_unit || ""}`.trim();
  }

  command() {
    const card = this.card("rest", "Command line");
    const called = this.content.command;
    const words = called.split(" ").flatMap((word) => [element("span", {}, word), " "]);
    card.append(element("div", { class: "command" }, element("pre", { tabindex: 0 }, ...words), copyButton(() => called)));
  }

  parameters() {
    const { result } = this.content;
    const { vehicle, speeds, ...others } = result.parameters;
    const facts = Object.entries({ algorithm: result.algorithm, seed: result.seed, threads: result.threads, ...others, ...vehicle, ...speeds })
      .filter(([, value]) => typeof value !== "object" || value === null || Array.isArray(value))
      .map(([name, value]) => [name.replaceAll("_", " "), text(value)]);
    this.card("rest", "Parameters").append(factTable(facts));
  }

  finish(keys = []) {
    const { result } = this.content;
    if (this.content.command) this.command();
    if (result?.parameters) this.parameters();
    const files = Object.entries(result ?? {}).filter(([, value]) => value?.hash)
      .map(([role, value]) => `${role} ${value.file} (hash ${value.hash})`);
    const play = [["space", "play or pause"], ["←", "step back"], ["→", "step forward"]];
    const known = [...(document.querySelector(".player") ? play : []), ...keys];
    const list = known.flatMap(([key, what]) => [element("kbd", {}, key), ` ${what}  `]);
    this.root.append(element("footer", {}, known.length ? element("p", {}, "Keys: ", ...list) : null,
                             element("p", {}, [`lasius ${result?.version ?? this.content.version ?? ""}`, ...files].join(" · "))));
  }
}
