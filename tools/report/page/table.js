// Tables.
//
//   factTable([["seed", "1"], ...])                     names and values
//   dataTable(["name", "length"], rows, caption)        a click on a column's name sorts by it

import { element } from "./dom.js";

export function factTable(facts) {
  return element("dl", { class: "facts" }, ...facts.map(([name, value]) =>
    element("div", {}, element("dt", {}, name), element("dd", {}, String(value)))));
}

function compare(a, b) {
  const x = parseFloat(a), y = parseFloat(b);
  if (Number.isNaN(x) && Number.isNaN(y)) return String(a).localeCompare(String(b));
  return Number.isNaN(x) ? 1 : Number.isNaN(y) ? -1 : x - y;
}

export function dataTable(columns, rows, caption) {
  const body = element("tbody");
  let sorted = -1, direction = 1;
  const fill = () => {
    const order = sorted < 0 ? rows : [...rows].sort((a, b) => direction * compare(a[sorted], b[sorted]));
    body.replaceChildren(...order.map((row) => element("tr", {}, ...row.map((value) => {
      const numeric = value !== "" && !Number.isNaN(Number(String(value).replace(/[%,]/g, "")));
      return element("td", { class: numeric ? "number" : null }, String(value ?? ""));
    }))));
  };
  const heads = columns.map((name, i) => {
    const head = element("th", { scope: "col" });
    head.append(element("button", { type: "button", class: "sort", onclick: () => {
      direction = sorted === i ? -direction : 1;
      sorted = i;
      for (const other of heads) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", direction > 0 ? "ascending" : "descending");
      fill();
    } }, name));
    return head;
  });
  fill();
  return element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": caption },
                 element("table", { class: "data" }, element("caption", {}, caption),
                         element("thead", {}, element("tr", {}, ...heads)), body));
}
