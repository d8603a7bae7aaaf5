// The desktop's own run, where `hooke view` serves this page: its scene, and the frames of its run as it makes them.

import { seconds } from "./words.js";

/** What the desktop serves; nothing where the page comes from elsewhere. */
export async function findDesktop() {
  if (!document.querySelector('meta[name="hooke-desktop"]')) return undefined;
  const response = await fetch("desktop/scene.json");
  if (!response.ok) throw new Error(`the desktop does not tell its scene: ${response.status}`);
  return { ...(await response.json()), frames: "desktop/frames" };
}

/** Of so many frames ahead of what is shown no more are asked for: the desktop then waits. */
const AHEAD = 240;

/** Frames of a run, in the order that they were made. */
class Frames {
  queue = [];
  ended;
  #waiting;

  constructor(url, particles) {
    this.bytes = 8 * 8 + particles * 12;
    this.abort = new AbortController();
    this.#read(url).catch((error) => {
      if (!this.abort.signal.aborted) this.ended = `the desktop is gone: ${error.message}`;
    });
  }

  async #read(url) {
    const response = await fetch(url, { signal: this.abort.signal });
    if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
    const reader = response.body.getReader();
    let chunks = [];
    let held = 0;
    for (;;) {
      if (this.queue.length >= AHEAD) await new Promise((go) => (this.#waiting = go));
      const { done, value } = await reader.read();
      if (done) break;
      chunks.push(value);
      held += value.length;
      if (held < this.bytes) continue;
      const all = new Uint8Array(held);
      chunks.reduce((at, chunk) => (all.set(chunk, at), at + chunk.length), 0);
      let from = 0;
      for (; from + this.bytes <= held; from += this.bytes) this.queue.push(frame(all.buffer, from, this.bytes));
      chunks = [all.slice(from)];
      held -= from;
    }
    this.ended = "the desktop's run is at its end";
  }

  /** The last frame that is not later than a time, if it is new. */
  upTo(time) {
    let last;
    while (this.queue.length > 0 && this.queue[0].time <= time + 1e-9 && !last?.early) last = this.queue.shift();
    if (this.queue.length < AHEAD) {
      this.#waiting?.();
      this.#waiting = undefined;
    }
    return last;
  }

  close() {
    this.abort.abort();
    this.#waiting?.();
  }
}

/** Eight numbers of 64 bits: time, then the ledger; then positions in 32 bits. Where the ledger is not known it is NaN. */
function frame(buffer, from, bytes) {
  const copy = buffer.slice(from, from + bytes);
  const [time, kinetic, elastic, gravitational, lostToDamping, lostInImpacts, remainder, total] = new Float64Array(copy, 0, 8);
  // A time that is no number says that the run ended early: at a particle, after a time.
  if (Number.isNaN(time)) return { time: elastic, early: { particle: kinetic < 0 ? undefined : kinetic, time: elastic } };
  return {
    time, positions: new Float32Array(copy, 64),
    ledger: { kinetic, elastic, gravitational, lostToDamping, lostInImpacts, remainder, total },
  };
}

export class DesktopSide {
  stepper = "desktop";
  stopped;
  steps = 0;
  ahead = 0;

  constructor(scene, desktop) {
    this.scene = scene;
    this.choices = { timeStep: 1 / 60 };
    this.frames = new Frames(desktop.frames, scene.particles);
    this.shown = { time: 0, positions: Float32Array.from(scene.position), ledger: NO_LEDGER };
    this.clock = 0;
  }

  change(choices) {
    this.choices = choices;
  }

  setStepper() {}

  /** Its frames are shown as they become due: it takes the steps that the desktop takes. */
  advance(count) {
    if (this.frames.queue.length === 0) {
      if (this.frames.ended) this.stopped = { words: this.frames.ended, time: this.shown.time };
      return 0;
    }
    this.steps += count;
    this.clock += count * this.choices.timeStep;
    const next = this.frames.upTo(this.clock);
    if (next?.early) this.#stop(next.early);
    else this.shown = next ?? this.shown;
    return count;
  }

  #stop({ particle, time }) {
    const exploded = particle !== undefined;
    const words = exploded
      ? `exploded at particle ${particle} in the step after ${seconds(time)}: its place would be no number.`
      : `the desktop's run did not go on after ${seconds(time)}: it has printed why.`;
    this.stopped = { particle, time, words, exploded };
  }

  get time() {
    return this.shown.time;
  }

  get positions() {
    return this.shown.positions;
  }

  energy() {
    return this.shown.ledger;
  }

  /** Nothing that is done here changes its run. */
  openLedger() {
    return false;
  }

  stableStep() {
    return Infinity;
  }

  digest() {
    return "told by hooke run";
  }

  hold() {}

  release() {}

  free() {
    this.frames.close();
  }
}

/** At the start nothing has been told yet. */
const NO_LEDGER = { total: NaN };
