// A chart of curves over a common axis, as SVG, with a cursor.
//
//   chart = new Curves(host, {title, xLabel, yLabel, series, levels, logarithmic, calm, dots, decimals, span, onPick})
//     series  [{name, x, y, low, high, steps, dashed}]  x defaults to 1, 2, ...; null or NaN where
//             there is none; low and high make a band; steps: a value holds until the next, or until the
//             place where there is none
//     levels  [{name, value, colour}]                   dashed lines across
//     span    [from, to]                                of the axis, wherever the points lie
//     onPick(x)                                         a place on the axis was clicked
//   chart.cursor(x)   shows a line and the values there
//   chart.set(series) other values: of a run that is under way
//
//   calm   of curves with far larger values at first, what is above 8 times the spread of their second
//          half is left out of the axis
//   dots   points, not lines
// Clicks on a name in the legend hide a curve.

import { cutText, element, isNumber, numberText, shortText, svgElement } from "./dom.js";

export const kCurveColours = 8;
const kLeft = 56, kRight = 12, kTop = 10, kBottom = 38;

/** About `count` round numbers from low to high. */
export function ticks(low, high, count) {
  if (!(high - low > 1e-12 * Math.max(Math.abs(low), Math.abs(high)))) return [low]; // no numbers between
  const rough = (high - low) / Math.max(1, count), power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((f) => f * power).find((s) => s >= rough * 0.999) ?? rough;
  const list = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) list.push(Number((i * step).toPrecision(12)));
  return list;
}

function decades(low, high) {
  const list = [];
  for (let p = Math.floor(Math.log10(low)); p <= Math.ceil(Math.log10(high)); ++p)
    for (const f of high / low < 20 ? [1, 2, 5] : [1])
      if (f * 10 ** p >= low * 0.999 && f * 10 ** p <= high * 1.001) list.push(f * 10 ** p);
  return list.length > 1 ? list : ticks(low, high, 5);
}

/** The index of the last x that is not above `at`; -1: none. */
export function indexAt(x, at) {
  let low = -1, high = x.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (x[middle] <= at) low = middle;
    else high = middle - 1;
  }
  return low;
}

export class Curves {
  constructor(host, { title, xLabel, yLabel, series, levels = [], logarithmic = false, calm = false, dots = false, decimals = 2, span, onPick }) {
    Object.assign(this, { title, xLabel, yLabel, levels, logarithmic, calm, dots, decimals, span, onPick, hidden: new Set(), x: null });
    this.picture = svgElement("svg", { role: "img" });
    this.legend = element("div", { class: "keys" });
    this.frame = element("div", { class: "curves" }, title ? element("h3", {}, cutText(title, 300)) : null, this.picture, this.legend);
    host.append(this.frame);
    this.set(series);
    this.picture.addEventListener("pointermove", (event) => this.pointed(event, event.buttons > 0));
    this.picture.addEventListener("pointerdown", (event) => this.pointed(event, true));
    this.picture.addEventListener("pointerleave", () => this.mark(this.x));
    new ResizeObserver(() => this.draw()).observe(this.frame);
  }

  set(series) {
    this.series = series.filter((s) => s.y.some(isNumber)).map((s, i) => ({
      ...s, name: cutText(s.name), colour: s.colour ?? `var(--curve-${(i % kCurveColours) + 1})`, x: s.x ?? s.y.map((_, k) => k + 1) }));
    this.makeLegend();
    this.draw();
  }

  makeLegend() {
    const key = (name, colour, dashed, index) => {
      const value = element("span", { class: "key-value" });
      const line = element("span", { class: dashed ? "key-line dashed" : "key-line", style: `border-color:${colour}` });
      const button = element("button", { type: "button", class: "key", "aria-pressed": "true" }, line, name, value);
      button.addEventListener("click", () => {
        this.hidden.has(index) ? this.hidden.delete(index) : this.hidden.add(index);
        button.setAttribute("aria-pressed", String(!this.hidden.has(index)));
        this.draw();
      });
      return [button, value];
    };
    const keys = this.series.map((s, i) => key(s.name, s.colour, s.dashed, i));
    const levels = this.levels.map((l, i) => key(l.name, l.colour ?? "var(--muted)", true, this.series.length + i));
    this.values = keys.map(([, value]) => value);
    levels.forEach(([, value], i) => (value.textContent = numberText(this.levels[i].value, this.decimals)));
    this.legend.replaceChildren(...[...keys, ...levels].map(([button]) => button));
  }

  shown() {
    return this.series.filter((_, i) => !this.hidden.has(i));
  }

  range() {
    let low = Infinity, high = -Infinity, later = -Infinity, from = Infinity, to = -Infinity;
    const levels = this.levels.filter((_, i) => !this.hidden.has(this.series.length + i));
    for (const { x, y, low: below, high: above } of this.shown()) {
      y.forEach((value, i) => {
        const least = isNumber(below?.[i]) ? below[i] : value, most = isNumber(above?.[i]) ? above[i] : value;
        if (!isNumber(value)) return;
        if (isNumber(least) && (!this.logarithmic || least > 0)) low = Math.min(low, least);
        high = Math.max(high, most);
        if (i >= y.length / 2) later = Math.max(later, most);
      });
      if (x.length) [from, to] = [Math.min(from, x[0]), Math.max(to, x[x.length - 1])];
    }
    for (const { value } of levels) [low, later, high] = [Math.min(low, value), Math.max(later, value), Math.max(high, value)];
    if (!(low <= high)) [low, high, later] = [0, 1, 1];
    if (this.calm && later > low) high = Math.min(high, low + 8 * (later - low));
    if (low === high) [low, high] = this.logarithmic ? [low / 2, high * 2] : [low - Math.max(1, 0.02 * Math.abs(low)), high + Math.max(1, 0.02 * Math.abs(high))];
    const room = this.logarithmic ? 0 : 0.05 * (high - low);
    if (this.span) [from, to] = this.span;
    if (!(from < to)) [from, to] = isNumber(from) ? [from - 1, to + 1] : [0, 1];
    return { from, to, low: low - (low >= 0 && low < room ? low : room), high: high + room, levels };
  }

  draw() {
    const width = this.frame.clientWidth;
    if (width === 0) return;
    const height = Math.round(Math.min(300, Math.max(180, 0.55 * width)));
    const { from, to, low, high, levels } = this.range();
    const place = this.logarithmic ? Math.log : (v) => v;
    this.px = (x) => kLeft + ((x - from) / (to - from)) * (width - kLeft - kRight);
    this.back = (px) => from + ((px - kLeft) / (width - kLeft - kRight)) * (to - from);
    this.py = (y) => height - kBottom - ((place(y) - place(low)) / (place(high) - place(low))) * (height - kTop - kBottom);
    this.height = height;
    const axis = svgElement("g", { class: "axis" });
    const text = (x, y, anchor, content, extra = {}) =>
      axis.append(svgElement("text", { x, y, "text-anchor": anchor, ...extra }, content));
    for (const y of this.logarithmic ? decades(low, high) : ticks(low, high, 5)) {
      if (y < low || y > high) continue;
      axis.append(svgElement("line", { x1: kLeft, x2: width - kRight, y1: this.py(y), y2: this.py(y) }));
      text(kLeft - 6, this.py(y) + 4, "end", shortText(y));
    }
    for (const x of ticks(from, to, Math.max(2, width / 110))) text(this.px(x), height - kBottom + 16, "middle", shortText(x));
    text(0.5 * (kLeft + width - kRight), height - 4, "middle", this.xLabel);
    text(0, 0, "middle", this.yLabel, { transform: `translate(12 ${0.5 * (kTop + height - kBottom)}) rotate(-90)` });
    const clip = `clip${Curves.count = (Curves.count ?? 0) + 1}`;
    const body = svgElement("g", { "clip-path": `url(#${clip})` });
    for (const { value, colour } of levels)
      body.append(svgElement("line", { class: "level", x1: kLeft, x2: width - kRight, y1: this.py(value), y2: this.py(value),
                                       style: colour ? `stroke:${colour}` : null }));
    for (const s of [...this.shown()].reverse()) {
      if (s.low) body.append(svgElement("path", { class: "band", d: this.bandPath(s), style: `fill:${s.colour}` }));
      if (this.dots) body.append(...this.points(s));
      else body.append(svgElement("path", { class: "curve", d: this.curvePath(s.x, s.y, s.steps), style: `stroke:${s.colour}`,
                                       "stroke-dasharray": s.dashed ? "5 4" : null }));
    }
    this.marks = svgElement("g", { class: "cursor" });
    this.picture.replaceChildren(
      svgElement("title", {}, this.summary()),
      svgElement("clipPath", { id: clip }, svgElement("rect", { x: kLeft - 4, y: kTop - 4, width: Math.max(0, width - kLeft - kRight + 8), height: height - kTop - kBottom + 8 })),
      axis, body, this.marks);
    this.picture.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.picture.setAttribute("height", height);
    this.mark(this.x);
  }

  /** What a reader without eyes for it hears. */
  summary() {
    const parts = this.series.map(({ name, y }) => {
      const numbers = y.filter(isNumber);
      return `${name}: from ${numberText(numbers[0], this.decimals)} to ${numberText(numbers.at(-1), this.decimals)}`;
    });
    return `${this.title ?? this.yLabel} by ${this.xLabel}. ${parts.join("; ")}.`;
  }

  curvePath(x, y, steps) {
    let d = "", open = false;
    y.forEach((value, i) => {
      const px = this.px(x[i]).toFixed(1);
      if (!isNumber(value) || (this.logarithmic && value <= 0)) {
        if (open && steps) d += `H${px}`;
        return void (open = false);
      }
      const py = this.py(value).toFixed(1);
      d += open ? (steps ? `H${px}V${py}` : `L${px} ${py}`) : `M${px} ${py}`;
      if (!open && !isNumber(y[i + 1])) d += "h0.01";
      open = true;
    });
    return d;
  }

  points({ x, y, colour }) {
    return y.flatMap((value, i) => isNumber(value) && (!this.logarithmic || value > 0)
      ? [svgElement("circle", { cx: this.px(x[i]), cy: this.py(value), r: 3, style: `fill:${colour}` })] : []);
  }

  bandPath({ x, low, high }) {
    const points = (values) => values.map((v, i) => (isNumber(v) && (!this.logarithmic || v > 0) ? `${this.px(x[i]).toFixed(1)} ${this.py(v).toFixed(1)}` : null)).filter(Boolean);
    const above = points(high), below = points(low).reverse();
    return above.length ? `M${above.join("L")}L${below.join("L")}Z` : "";
  }

  pointed(event, picked) {
    const box = this.picture.getBoundingClientRect();
    const x = this.back(event.clientX - box.left);
    if (picked && this.onPick) this.onPick(x);
    else this.mark(x);
  }

  cursor(x) {
    this.x = x;
    this.mark(x);
  }

  mark(x) {
    if (!this.marks) return;
    this.marks.replaceChildren();
    this.series.forEach((s, i) => {
      const at = x == null ? s.y.length - 1 : indexAt(s.x, x + 1e-9), value = at < 0 ? null : s.y[at];
      this.values[i].textContent = isNumber(value) ? numberText(value, this.decimals) : "–";
      if (x == null || !isNumber(value) || this.hidden.has(i)) return;
      const py = this.py(value);
      if (py >= kTop - 4)
        this.marks.append(svgElement("circle", { cx: this.px(s.x[at]), cy: py, r: 4, style: `fill:${s.colour}` }));
    });
    if (x == null) return;
    const px = Math.min(Math.max(this.px(x), kLeft), this.frame.clientWidth - kRight);
    this.marks.prepend(svgElement("line", { x1: px, x2: px, y1: kTop, y2: this.height - kBottom }));
  }
}
