// The one or two sides of a page: made, paced and kept in step with each other.

import { DesktopSide } from "./desktop.js";
import { History } from "./history.js";
import { Side } from "./side.js";
import { chooseTimeStep } from "./choices.js";
import { DESKTOP } from "./steppers.js";

const SPAN = 6;

export class Sides {
  list = [];
  histories = [];
  /** Steps that are due and not yet taken: less than 1. */
  due = 0;
  /** Steps that each side has taken, or waits to take. */
  target = 0;
  slowness = 1;

  constructor(hooke) {
    this.hooke = hooke;
  }

  /** Begins anew; where a world is refused everything stays as it was. */
  build(scene, names, given, { desktop } = {}) {
    const timeStep = given.timeStep ?? this.#chosenStep(scene, given);
    const choices = { ...given, timeStep };
    const list = [];
    try {
      for (const name of names) list.push(name === DESKTOP ? new DesktopSide(scene, desktop) : new Side(this.hooke, scene, name, choices));
    } catch (error) {
      list.forEach((side) => side.free());
      throw error;
    }
    this.list.forEach((side) => side.free());
    Object.assign(this, { scene, timeStep, choices, list, due: 0, target: 0, slowness: 1 });
    this.histories = this.list.map(() => new History(SPAN));
    this.record();
  }

  #chosenStep(scene, choices) {
    const probe = new Side(this.hooke, scene, "velocity-verlet", { ...choices, timeStep: LONGEST_STEP });
    try {
      return chooseTimeStep(probe.stableStep(), scene.duration);
    } finally {
      probe.free();
    }
  }

  /** The same state, other choices. */
  change(choices) {
    const { choices: before } = this;
    this.timeStep = choices.timeStep ?? this.#chosenStep(this.scene, choices);
    this.choices = { ...choices, timeStep: this.timeStep };
    this.list.forEach((side) => {
      if (side.stopped) this.#revive(side);
      side.change(this.choices);
    });
    this.due = 0;
    if (["stiffness", "damping", "gravity"].some((key) => String(choices[key]) !== String(before[key]))) this.#openLedgers();
  }

  /** A hand puts a particle at a place, whence it moves with that velocity. */
  hold(particle, place, velocity) {
    this.list.forEach((side) => side.hold(particle, place, velocity));
    const told = String([particle, place, velocity]);
    if (told !== this.told) this.#openLedgers();
    this.told = told;
  }

  /** The hand lets it go with that velocity. */
  release(particle, velocity) {
    this.list.forEach((side) => side.release(particle, velocity));
    this.told = undefined;
    this.#openLedgers();
  }

  /** After a change from outside: what comes from here on is each stepper's own. */
  #openLedgers() {
    this.histories = this.list.map((side, i) => {
      if (!side.openLedger()) return this.histories[i];
      side.isRecorded = false;
      return new History(SPAN);
    });
    this.record();
  }

  /** Another stepper for a side, from where it is. */
  setStepper(index, name) {
    const side = this.list[index];
    if (side.stopped) this.#revive(side);
    side.setStepper(name);
  }

  get time() {
    return Math.max(0, ...this.list.map((side) => side.time));
  }

  /** Steps what falls into that many seconds of the clock. */
  advance(elapsed, speed, held) {
    this.due += (elapsed * speed) / this.timeStep;
    const count = Math.floor(this.due + 1e-9);
    this.due -= count;
    this.#stepTo(this.target + count, { held });
    const going = this.list.filter((side) => !side.stopped);
    // Where one cannot keep up, the other waits for it: they are to be compared at the same time.
    const reached = Math.min(...going.map((side) => side.steps + side.ahead), this.target + count);
    const rate = count > 0 && going.length > 0 ? Math.max(0, reached - this.target) / count : 1;
    this.slowness = 0.9 * this.slowness + 0.1 * rate;
    this.target = reached;
    if (count > 0) this.record();
  }

  /** Takes one step, or as many as are asked for, however long that takes. */
  step(count = 1) {
    this.target += count;
    this.#stepTo(this.target, { hurry: false });
    this.due = 0;
    this.record();
  }

  #stepTo(target, options) {
    for (const side of this.list) {
      const left = target - (side.steps + side.ahead);
      if (!side.stopped && left > 0) side.advance(left, options);
    }
  }

  /** Lets those that stand still go on from where they are. */
  #revive(side) {
    side.ahead = this.target - side.steps;
  }

  record() {
    this.list.forEach((side, i) => {
      if (side.stopped && side.isRecorded) return;
      this.histories[i].add(side.time, side.energy());
      side.isRecorded = Boolean(side.stopped);
    });
  }
}

const LONGEST_STEP = 0.01;
