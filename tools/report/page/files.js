// What a reader takes away: files and text.
//
//   saveFile("path.csv", blob)
//   csvOf(["x", "y"], [[0.5, 0.5], ...])     -> text; numbers round-trip
//   copyButton(() => text)                   a button that copies, and says so

import { element } from "./dom.js";

export function saveFile(name, blob) {
  const link = element("a", { href: URL.createObjectURL(blob), download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

export function csvOf(columns, rows) {
  const cell = (value) => (value == null || Number.isNaN(value) ? "" : String(value));
  return [columns, ...rows].map((row) => row.map(cell).join(",") + "\n").join("");
}

async function copied(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = element("textarea", { class: "hidden" });
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }
}

export function copyButton(text) {
  const button = element("button", { type: "button" }, "Copy");
  button.addEventListener("click", async () => {
    button.textContent = (await copied(text())) ? "Copied" : "Not allowed";
    setTimeout(() => (button.textContent = "Copy"), 2000);
  });
  return button;
}
