// Where the map comes from: made from a seed, an empty sheet, a file.
//
//   card = new WorldCard(host, {kinds, make, read, empty, save})
//     kinds           [{name, max_density}]
//     make(wish)      called with {kind, width, height, density, seed}; density -1: the kind's own
//     read(file)      called with a File
//     empty(w, h), save()

import { element } from "./dom.js";
import { field, numberField, selectField } from "./fields.js";

const kMostSide = 2048;

export class WorldCard {
  constructor(host, { kinds, make, read, empty, save }) {
    const side = (value, label) => numberField({ value, min: 1, max: kMostSide, label });
    this.kind = selectField({ options: kinds.map(({ name }) => name), value: "blobs", onChange: () => this.limitDensity() });
    this.kinds = kinds;
    this.width = side(240, "Width, cells");
    this.height = side(140, "Height, cells");
    this.density = element("input", { type: "number", min: 0, step: 0.01, placeholder: "usual" });
    this.seed = numberField({ value: 61, min: 0, max: Number.MAX_SAFE_INTEGER });
    const file = element("input", { type: "file", class: "hidden", accept: ".map,.pbm,.pgm", id: "map-file", "aria-label": "Map file", onchange: () => {
      if (file.files.length) read(file.files[0]);
      file.value = "";
    } });
    const button = (text, action, kind = null) => element("button", { type: "button", class: kind, onclick: action }, text);
    const form = element("form", { class: "fields", onsubmit: (event) => {
      event.preventDefault();
      if (form.reportValidity()) make(this.wish());
    } },
      field("kind", this.kind), field("width", this.width), field("height", this.height),
      field("density", this.density), field("seed", this.seed),
      element("div", { class: "row wide" }, element("button", { class: "main" }, "Make map"),
              button("Another seed", () => this.another(form)),
              button("Empty sheet", () => form.reportValidity() && empty(Number(this.width.value), Number(this.height.value)))));
    host.append(form, element("div", { class: "row" },
      button("Load file …", () => file.click()), file, button("Save as .map", save)),
      element("p", { class: "note" }, "Files: MovingAI .map, PBM, PGM, up to ", String(kMostSide), " cells a side. They can be dropped on the page."));
    document.addEventListener("dragover", (event) => event.preventDefault());
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      if (event.dataTransfer.files.length) read(event.dataTransfer.files[0]);
    });
    this.limitDensity();
  }

  limitDensity() {
    this.density.max = this.kinds.find(({ name }) => name === this.kind.value).max_density;
  }

  another(form) {
    this.seed.value = Number(this.seed.value) + 1;
    form.requestSubmit();
  }

  wish() {
    return { kind: this.kind.value, width: Number(this.width.value), height: Number(this.height.value),
             density: this.density.value === "" ? -1 : Number(this.density.value), seed: Number(this.seed.value) };
  }
}

export function checkSize({ width, height }) {
  if (Math.max(width, height) > kMostSide)
    throw new Error(`the map has ${width} × ${height} cells: the page takes up to ${kMostSide} a side, the program more`);
}
