// Elements, numbers as text, themes.
//
//   element("p", {class: "note"}, "text", child)  text is always a text node: nothing is parsed
//   svgElement("path", {d: "..."})                the same for SVG
//   numberText(12.3456, 2)                        "12.35"; "none" for what is no number
//   cutText("a name ...")                         its first 100 letters, "…" in place of more
//   themeColour("--path")                         "#d62728", the variable as the theme has it
//   channels("#d62728")                           [214, 39, 40]
//   paintSoon(view)                               view.paint() at the next frame of the screen
//   onTheme(callback)                             called after every change of light and dark
//   themeButton()                                 the button that changes it

function filled(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) node.addEventListener(name.slice(2), value);
    else if (value === true) node.setAttribute(name, "");
    else if (value !== false && value != null) node.setAttribute(name, value);
  }
  node.append(...children.filter((child) => child != null));
  return node;
}

export function element(name, attributes = {}, ...children) {
  return filled(document.createElement(name), attributes, children);
}

export function svgElement(name, attributes = {}, ...children) {
  return filled(document.createElementNS("http://www.w3.org/2000/svg", name), attributes, children);
}

/** However often it is asked; not before the view has a width. */
export function paintSoon(view) {
  if (view.pending || !view.width) return;
  view.pending = true;
  requestAnimationFrame(() => {
    view.pending = false;
    view.paint();
  });
}

export function isNumber(value) {
  return typeof value === "number" && Number.isFinite(value);
}

export function numberText(value, decimals = 2) {
  if (!isNumber(value)) return "none";
  const size = Math.abs(value) < 1e-9 ? 0 : Math.abs(value);
  if (size === 0) return "0";
  if (size >= 1e7 || size < 0.5 * 10 ** -decimals) return value.toPrecision(3);
  return value.toFixed(decimals).replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "");
}

export function cutText(text, most = 100) {
  const letters = [...(text ?? "")];
  return letters.length > most ? letters.slice(0, most - 1).join("") + "…" : text;
}

/** A plain number in as many digits as a label has room for. */
export function shortText(value) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) return value.toExponential(size >= 1e5 ? 1 : 0).replace("e+", "e");
  return String(Number(value.toPrecision(4)));
}

const themeListeners = new Set();

export function onTheme(callback) {
  themeListeners.add(callback);
}

function themeChanged() {
  for (const callback of themeListeners) callback();
}

const prefersDark = matchMedia("(prefers-color-scheme: dark)");
const root = document.documentElement;

function follow() {
  root.dataset.theme = prefersDark.matches ? "dark" : "light";
  themeChanged();
}

prefersDark.addEventListener("change", follow);
follow();

export function isDark() {
  return root.dataset.theme === "dark";
}

export function themeColour(name) {
  return getComputedStyle(root).getPropertyValue(name).trim();
}

/** Red, green and blue of "#d62728". */
export function channels(colour) {
  return [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
}

export function themeButton() {
  const text = () => (isDark() ? "Light" : "Dark");
  const button = element("button", { type: "button", class: "quiet" }, text());
  const label = () => {
    button.textContent = text();
    button.setAttribute("aria-label", `Change to ${text().toLowerCase()} colours`);
  };
  button.addEventListener("click", () => {
    root.dataset.theme = isDark() ? "light" : "dark";
    themeChanged();
  });
  onTheme(label);
  label();
  return button;
}
