// The algorithm and its parameters, with the ranges that the library gives.
//
//   card = new ColonyCard(host, {algorithms, formulas, onChange})
//     formulas(question)   -> promise of lines
//   card.question()        {algorithm, preset, seed, values}: values that are not the preset's
//   card.algorithm()       {name, summary, source, kind, parameters, presets}
//   card.valueOf(name)     as text; undefined: the algorithm has no such parameter

import { element } from "./dom.js";
import { field, numberField, selectField } from "./fields.js";

const kFirst = ["ants", "iterations", "population", "persistence", "alpha", "beta"];

export class ColonyCard {
  constructor(host, { algorithms, formulas, onChange }) {
    Object.assign(this, { algorithms, formulas, onChange, values: {}, preset: "usual" });
    this.name = selectField({ options: algorithms.map(({ name }) => name), value: algorithms.find(({ kind }) => kind === "colony").name, label: "Algorithm",
                              onChange: () => this.choose() });
    this.seed = numberField({ value: 1, min: 0, max: Number.MAX_SAFE_INTEGER, onChange: () => this.changed() });
    this.presets = element("span");
    this.about = element("p", { class: "note" });
    this.first = element("div", { class: "fields" });
    this.others = element("div", { class: "fields" });
    this.more = element("details", {}, element("summary", {}, "All parameters"), this.others);
    this.rules = element("pre", { tabindex: 0 });
    this.rulesBox = element("details", {}, element("summary", {}, "Formulas"), this.rules);
    host.append(element("div", { class: "fields" }, field("algorithm", this.name), this.presets, field("seed", this.seed)),
                this.about, this.first, this.more, this.rulesBox);
    this.choose();
  }

  algorithm() {
    return this.algorithms.find(({ name }) => name === this.name.value);
  }

  choose(preset = "usual") {
    const algorithm = this.algorithm();
    Object.assign(this, { preset, values: {} });
    const names = Object.keys(algorithm.presets);
    this.presets.replaceChildren(names.length > 1
      ? field("preset", selectField({ options: names, value: preset, onChange: (name) => this.choose(name) })) : "");
    this.about.textContent = `${algorithm.summary} (${algorithm.source})`;
    const isFirst = ({ name }) => kFirst.includes(name);
    this.first.replaceChildren(...algorithm.parameters.filter(isFirst).map((p) => this.control(p)));
    const rest = algorithm.parameters.filter((p) => !isFirst(p));
    this.others.replaceChildren(...rest.map((p) => this.control(p)));
    this.more.hidden = rest.length === 0;
    this.rulesBox.hidden = algorithm.kind !== "colony";
    this.changed();
  }

  control(parameter) {
    const { name, type, range, choices, least, most, summary } = parameter;
    const value = this.algorithm().presets[this.preset][name];
    const input = choices.length > 0
      ? selectField({ options: choices, value })
      : element("input", { type: "number", value, min: least, max: most, step: type === "integer" ? 1 : "any", required: true });
    input.title = `${summary}: ${range}`;
    input.dataset.parameter = name;
    input.addEventListener("change", () => this.set(name, input));
    return field(name.replaceAll("_", " "), input, choices.length > 0 ? null : range);
  }

  set(name, input) {
    if (!input.reportValidity()) return;
    if (input.value === this.algorithm().presets[this.preset][name]) delete this.values[name];
    else this.values[name] = input.value;
    this.changed();
  }

  valueOf(name) {
    return this.values[name] ?? this.algorithm().presets[this.preset][name];
  }

  question() {
    return { algorithm: this.name.value, preset: this.preset, seed: Number(this.seed.value), values: { ...this.values } };
  }

  /** False with a message at the field that is out of range. */
  valid() {
    return [this.first, this.others, this.seed.parentElement].every((part) =>
      [...part.querySelectorAll("input")].every((input) => {
        if (!input.checkValidity() && this.others.contains(input)) this.more.open = true;
        return input.reportValidity();
      }));
  }

  async changed() {
    this.onChange();
    if (this.rulesBox.hidden) return;
    const asked = this.asked = this.question();
    try {
      const lines = await this.formulas(asked);
      if (asked === this.asked) this.rules.textContent = lines.join("\n");
    } catch (error) {
      if (asked === this.asked) this.rules.textContent = error.message;
    }
  }
}
