// Fields of a form.
//
//   field("seed", input)                           a label over it
//   numberField({value, min, max, step, label, onChange})  an input; onChange is called with a number
//   selectField({options, value, label, onChange}) options: names, or [name, text] each

import { element } from "./dom.js";

export function field(name, control, note = null) {
  return element("label", { class: "field" }, element("span", {}, name), control,
                 note ? element("span", { class: "note" }, note) : null);
}

export function numberField({ value, min, max, step = 1, label = null, onChange = () => {} }) {
  const input = element("input", { type: "number", value, min, max, step, "aria-label": label, required: true });
  input.addEventListener("change", () => input.checkValidity() && onChange(Number(input.value)));
  return input;
}

export function selectField({ options, value, label = null, onChange = () => {} }) {
  const entries = options.map((option) => (Array.isArray(option) ? option : [option, option]));
  return element("select", { "aria-label": label, onchange: (event) => onChange(event.target.value) },
                 ...entries.map(([name, text]) => element("option", { value: name, selected: name === value }, text)));
}
