// The library in its worker.
//
//   engine = new Engine()                  begins to compile; calls wait for it
//   await engine.call("generate", {...})   what tools/playground/binding.cpp answers; an Error is
//                                          thrown for {error}
//   await engine.text(map)                 the bytes of its .map
//   await engine.plan(map, question, {most, onFrame})   frames: those of a KeyFrames of `most`
//   engine.stop()                          ends what is under way: its promise fails with Stopped
//
// A worker that plans hears nothing, so stopping ends it, and another begins with the same module.

import { unpacked } from "./packed.js";

export class Stopped extends Error {}

function embedded(id) {
  return document.getElementById(id).textContent;
}

export class Engine {
  constructor() {
    this.waiting = new Map();
    this.last = 0;
    const script = [embedded("lasius-module"), embedded("lasius-worker")].join("\n");
    this.address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
    this.module = unpacked(embedded("lasius-wasm").trim()).then((bytes) => WebAssembly.compile(bytes));
    this.begin();
  }

  begin() {
    const worker = this.worker = new Worker(this.address);
    this.ready = new Promise((done, failed) => {
      worker.onerror = (event) => {
        failed(new Error(event.message));
        this.fail(new Error(event.message));
      };
      worker.onmessage = ({ data }) => (data.ready ? done() : this.heard(data));
    });
    this.ready.catch(() => {});
    this.module.then((module) => worker.postMessage({ module }));
  }

  heard({ id, frame, answer }) {
    const asked = this.waiting.get(id);
    if (!asked) return;
    if (frame) return asked.onFrame(frame);
    this.waiting.delete(id);
    answer?.error ? asked.failed(new Error(answer.error)) : asked.done(answer);
  }

  fail(error) {
    for (const { failed } of this.waiting.values()) failed(error);
    this.waiting.clear();
  }

  async ask(message, onFrame) {
    const { worker, ready } = this;
    await ready;
    if (worker !== this.worker) throw new Stopped();
    return new Promise((done, failed) => {
      const id = ++this.last;
      this.waiting.set(id, { done, failed, onFrame });
      worker.postMessage({ id, ...message });
    });
  }

  call(name, ...words) {
    return this.ask({ name, words });
  }

  text(map) {
    return this.ask({ name: "text", map });
  }

  plan(map, question, { most = 0, onFrame } = {}) {
    return this.ask({ map, question, most }, onFrame);
  }

  stop() {
    this.worker.terminate();
    this.fail(new Stopped());
    this.begin();
  }
}
