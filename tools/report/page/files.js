// What a reader takes away: files and text.
//
//   saveFile("path.csv", blob)
//   saveCsv("path.csv", ["x", "y"], [[0.5, 0.5], ...])   numbers round-trip
//   pictureButton("map.png", () => view)     a button that saves what a view shows
//   copyButton(() => text)                   a button that copies, and says so

import { element } from "./dom.js";

export function saveFile(name, blob) {
  const link = element("a", { href: URL.createObjectURL(blob), download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

export function saveCsv(name, columns, rows) {
  const cell = (value) => (value == null || Number.isNaN(value) ? "" : String(value));
  const text = [columns, ...rows].map((row) => row.map(cell).join(",") + "\n").join("");
  saveFile(name, new Blob([text], { type: "text/csv" }));
}

export function pictureButton(name, view) {
  return element("button", { type: "button", onclick: async () => saveFile(name, await view().toBlob()) }, "Picture as PNG");
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
