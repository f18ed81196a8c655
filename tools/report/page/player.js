// A slider over frames, with buttons and keys.
//
//   player = new Player(host, {count, name, label, perSecond, onChange})
//     name            what the slider is over: "iteration"
//     label(index)    text of a frame: "iteration 12 of 50"
//     onChange(index) called after every change, and once at the beginning
//   player.index; player.show(index); player.extend(count); player.play(); player.pause()
//
// Keys, wherever the focus is but in a field: space plays, left and right step, Home and End.

import { element } from "./dom.js";

const kSpeeds = [0.25, 0.5, 1, 2, 4, 8];

export class Player {
  constructor(host, { count, name, label, perSecond = 8, onChange }) {
    Object.assign(this, { count, label, perSecond, onChange, index: 0, timer: 0 });
    const button = (text, title, action) =>
      element("button", { type: "button", title, "aria-label": title, onclick: action }, text);
    this.slider = element("input", { type: "range", min: 0, step: 1, "aria-label": name,
                                     oninput: () => this.chosen(Number(this.slider.value)) });
    this.toggle = button("▶", "Play", () => (this.timer ? this.pause() : this.play()));
    this.toggle.classList.add("play");
    this.text = element("output", { class: "frame-text" });
    this.speed = element("select", { "aria-label": "Speed" },
                         ...kSpeeds.map((s) => element("option", { value: s, selected: s === 1 }, `${s} ×`)));
    host.append(element("div", { class: "player", role: "group", "aria-label": `Playback by ${name}` },
                        this.toggle, button("‹", "Step back", () => this.chosen(this.index - 1)),
                        button("›", "Step forward", () => this.chosen(this.index + 1)),
                        this.slider, this.text, this.speed));
    document.addEventListener("keydown", (event) => this.key(event));
    this.extend(count);
    this.show(0);
  }

  /** So many frames from now on: of a run that is under way. */
  extend(count) {
    this.count = count;
    this.slider.max = Math.max(0, count - 1);
    this.slider.disabled = this.toggle.disabled = count < 2;
  }

  show(index) {
    this.index = Math.min(Math.max(index, 0), this.count - 1);
    this.slider.value = this.index;
    this.slider.style.setProperty("--done", `${(100 * this.index) / Math.max(1, this.count - 1)}%`);
    const text = this.label(this.index);
    this.text.textContent = text;
    this.slider.setAttribute("aria-valuetext", text);
    this.onChange(this.index);
  }

  chosen(index) {
    this.pause();
    this.show(index);
  }

  play() {
    if (this.count < 2) return;
    if (this.index >= this.count - 1) this.show(0);
    this.mark(true);
    const step = () => {
      if (this.index >= this.count - 1) return this.pause();
      this.show(this.index + 1);
      this.timer = setTimeout(step, 1000 / (this.perSecond * Number(this.speed.value)));
    };
    this.timer = setTimeout(step, 0);
  }

  pause() {
    clearTimeout(this.timer);
    this.timer = 0;
    this.mark(false);
  }

  mark(playing) {
    this.toggle.textContent = playing ? "❚❚" : "▶";
    this.toggle.setAttribute("aria-label", playing ? "Pause" : "Play");
    this.toggle.title = playing ? "Pause" : "Play";
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    const at = event.target;
    if (at.matches?.("input, select, textarea, [data-keys]") && event.key !== " ") return;
    if (event.key === " " && at.matches?.("button, select, summary, a, textarea, [type=text], [type=checkbox], [type=radio]")) return;
    const steps = { ArrowLeft: this.index - 1, ArrowRight: this.index + 1, Home: 0, End: this.count - 1 };
    if (event.key === " ") this.timer ? this.pause() : this.play();
    else if (event.key in steps) this.chosen(steps[event.key]);
    else return;
    event.preventDefault();
  }
}
