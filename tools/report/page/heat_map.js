// A raster of values as colours, and the scale that says which.
//
// Values are codes of one byte: 0 is nothing, 1 .. 255 go from scale.least to scale.most, evenly in
// the value or, with scale.logarithmic, in its logarithm.
//
//   scale = {name, least, most, logarithmic}
//   codesOf(values, scale)                        any array of numbers -> Uint8Array of codes
//   trailRange(frames, scale)                     the codes [low, high] that tell cells apart, as
//                                                 pictures have it (trail_scale in tools/bitmap/picture.cpp)
//   heat = new HeatMap(width, height)
//   heat.paint(codes, [low, high], ramp)          codes below low are clear; heat.image to draw
//   heatLegend(scale, [low, high], ramp, note)    an element
//   rampOf("trail" | "tracks", scale)             for the theme at hand

import { channels, element, isDark, shortText } from "./dom.js";

const kRamps = {
  light: {
    trail: ["#fffad9", "#ffcc59", "#de521a", "#45001a"],
    tracks: ["#bdd9f2", "#4291c7", "#082961"],
    index: ["#450054", "#21738f", "#5ec961", "#fce624"],
  },
  dark: {
    trail: ["#3a1c1f", "#7d2a1c", "#cc5a1a", "#f6ab3b", "#fff6cf"],
    tracks: ["#16293f", "#1f5c8f", "#4ba0d8", "#d3ecff"],
    index: ["#6b1a80", "#21738f", "#5ec961", "#fce624"],
  },
};

export function rampOf(shown, { logarithmic }) {
  return kRamps[isDark() ? "dark" : "light"][shown === "trail" && !logarithmic ? "index" : shown];
}

/** Red, green and blue of a share of a ramp, 0 .. 1. */
export function rampColour(ramp, share) {
  const at = Math.min(Math.max(share, 0), 1) * (ramp.length - 1);
  const below = Math.min(Math.floor(at), ramp.length - 2);
  const from = channels(ramp[below]), to = channels(ramp[below + 1]);
  return from.map((value, i) => Math.round(value + (to[i] - value) * (at - below)));
}

export function codesOf(values, { least, most, logarithmic }) {
  const place = logarithmic ? Math.log : (value) => value;
  const low = place(least), span = place(most) - low;
  return Uint8Array.from(values, (value) => {
    if (!(logarithmic ? value > 0 : value >= 0)) return 0;
    const share = span > 0 ? (place(value) - low) / span : 1;
    return 1 + Math.round(254 * Math.min(Math.max(share, 0), 1));
  });
}

export function valueOf(code, { least, most, logarithmic }) {
  const share = (code - 1) / 254;
  return logarithmic ? least * (most / least) ** share : least + share * (most - least);
}

function countsOf(frames) {
  const counts = new Float64Array(256);
  for (const codes of frames) for (const code of codes) ++counts[code];
  return counts;
}

/** The code at a place of all above 0, the largest first. */
function fromAbove(counts, place) {
  for (let code = 255, seen = 0; code > 1; --code) if ((seen += counts[code]) > place) return code;
  return 1;
}

const sumOf = (counts, from, to = 256) => counts.subarray(from, to).reduce((all, count) => all + count, 0);

/** Where at last all is on one way: the frames before say more. */
function rangeOfAll(frames) {
  const stride = Math.ceil(frames.length / 16);  // some say enough
  const counts = countsOf(frames.filter((_, i) => (frames.length - 1 - i) % stride === 0)), total = sumOf(counts, 1);
  if (total === 0) return [1, 255];
  const high = fromAbove(counts, 0.001 * total);
  // What most cells have, the trail where no ant has been, is left clear where it is the least.
  const usual = counts.indexOf(Math.max(...counts.subarray(1)));
  const low = Math.max(fromAbove(counts, 0.95 * total), usual < high && counts[usual] > 0.3 * total ? usual + 1 : 1);
  return low < high ? [low, high] : [1, Math.max(high, 2)];
}

export function trailRange(frames, scale) {
  const last = countsOf(frames.slice(-1)), total = sumOf(last, 1);
  // Of an index all that is known, the longest 1% as one colour.
  if (!scale.logarithmic) return [1, Math.max(2, fromAbove(last, Math.floor(total / 100)))];
  // Start and goal, where all ants meet, do not take the end of the scale for themselves.
  const high = fromAbove(last, Math.min(16, Math.floor(total / 100)));
  const decades = Math.log10(scale.most / scale.least), least = Math.max(1, Math.ceil(high - (254 * 4) / (decades || 1)));
  const matter = sumOf(last, least), usual = fromAbove(last, Math.floor(0.95 * matter));
  const low = usual < high ? usual : fromAbove(last, matter - 1);
  return total > 0 && low < high ? [low, high] : rangeOfAll(frames);
}

export class HeatMap {
  constructor(width, height) {
    this.image = element("canvas", { width, height });
    this.context = this.image.getContext("2d");
    this.pixels = this.context.createImageData(width, height);
    this.words = new Uint32Array(this.pixels.data.buffer);
  }

  paint(codes, [low, high], ramp) {
    const table = new Uint32Array(256);
    for (let code = Math.max(low, 1); code < 256; ++code) {
      const [red, green, blue] = rampColour(ramp, high > low ? (code - low) / (high - low) : 1);
      table[code] = 0xff000000 | (blue << 16) | (green << 8) | red;
    }
    for (let i = 0; i < codes.length; ++i) this.words[i] = table[codes[i]];
    this.context.putImageData(this.pixels, 0, 0);
  }
}

export function heatLegend(scale, [low, high], ramp, note = "") {
  const stops = [0, 0.25, 0.5, 0.75, 1];
  const colours = stops.map((share) => `rgb(${rampColour(ramp, share).join(" ")})`);
  const labels = stops.map((share) => {
    const value = shortText(Number(valueOf(low + share * (high - low), scale).toPrecision(2)));
    return element("span", {}, value);
  });
  const name = scale.name + (scale.logarithmic ? ", logarithmic" : "");
  return element("div", { class: "legend", role: "img",
                          "aria-label": `Scale: ${name}, ${labels[0].textContent} to ${labels[4].textContent}` },
                 element("div", { class: "legend-name" }, name),
                 element("div", { class: "legend-bar", style: `background:linear-gradient(90deg,${colours})` }),
                 element("div", { class: "legend-ticks" }, ...labels),
                 note ? element("div", { class: "legend-note" }, note) : null);
}
