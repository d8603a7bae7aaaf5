// What is shown: a scene, its sides, and everything chosen. Whoever changes it is told by `onChange` what is new.

import { NOTHING_CHOSEN, settle, toShare } from "./choices.js";
import { Camera } from "./draw/camera.js";
import { extentOf, floorsOf } from "./draw/extent.js";
import { readScene } from "./scene.js";
import { pack } from "./share.js";
import { textOf } from "./shipped.js";
import { Sides } from "./sides.js";
import { DESKTOP } from "./steppers.js";

export class App extends EventTarget {
  playing = true;
  held = undefined;
  frames = 0;

  constructor(hooke, stage, desktop) {
    super();
    Object.assign(this, { hooke, stage, desktop, sides: new Sides(hooke), chosen: NOTHING_CHOSEN });
  }

  #tell(what) {
    this.dispatchEvent(new CustomEvent(what));
  }

  /** Shows what was chosen, from the start; if its scene is refused everything stays as it was. */
  async open(chosen) {
    const { text, meshes } = chosen.text === null ? await textOf(chosen.scene) : chosen;
    const scene = await readScene(chosen.scene, text, meshes);
    // Single precision may refuse what the reader takes: until its worlds stand nothing is changed.
    this.#begin(chosen, scene);
    const isOther = this.text !== text;
    Object.assign(this, { chosen, scene, text, meshes });
    this.extent = extentOf(scene);
    if (isOther || !this.camera) this.camera = new Camera({ ...this.extent, chosen: scene.camera });
    this.#show();
    this.#tell("scene");
  }

  /** The stepper of each side. */
  get names() {
    return this.#namesOf(this.chosen, this.scene);
  }

  #namesOf(chosen, scene) {
    const a = chosen.a ?? (scene.stepper === "auto" ? "velocity-verlet" : scene.stepper);
    const first = a === DESKTOP && !this.desktop ? "velocity-verlet" : a;
    return chosen.b ? [first, chosen.b] : [first];
  }

  reset() {
    this.#begin(this.chosen, this.scene);
    this.#show();
  }

  #begin(chosen, scene) {
    this.sides.build(scene, this.#namesOf(chosen, scene), settle(chosen, scene), { desktop: this.desktop });
    // What a hand held has gone with the worlds before.
    this.held = undefined;
  }

  #show() {
    this.stage.show(this.scene, this.extent, floorsOf(this.scene, this.extent), this.sides.list.length);
    this.#tell("built");
  }

  /** Other choices, for the world as it is; only another number of sides begins anew. */
  choose(changes) {
    const before = this.chosen;
    this.chosen = { ...before, ...changes };
    const isOther = (key) => key in changes && changes[key] !== before[key];
    const desktopIn = [before.a, this.chosen.a].includes(DESKTOP) && isOther("a");
    if (desktopIn || (isOther("b") && (before.b === null || this.chosen.b === null))) this.reset();
    else {
      if (isOther("a")) this.sides.setStepper(0, this.names[0]);
      if (isOther("b")) this.sides.setStepper(1, this.names[1]);
      this.sides.change(settle(this.chosen, this.scene));
    }
    this.#tell("choice");
  }

  play(playing) {
    this.playing = playing;
    this.#tell("play");
  }

  step(count = 1) {
    this.play(false);
    this.sides.step(count);
  }

  /** A hand that holds a particle at a place. */
  hold(particle, place) {
    if (!this.held) this.held = { particle, place, target: place, velocity: [0, 0, 0] };
    this.held.target = place;
    this.stage.marked = particle;
  }

  release() {
    const { held } = this;
    if (!held) return;
    this.held = undefined;
    this.sides.release(held.particle, held.velocity);
  }

  /** Moves what is held towards where the hand is, within one picture. */
  #pull(elapsed) {
    const { held } = this;
    if (!held) return;
    const seconds = this.playing ? elapsed * this.chosen.speed : 0;
    const velocity = held.place.map((x, axis) => (seconds > 0 ? (held.target[axis] - x) / seconds : 0));
    // What a throw is worth is what the hand did over several pictures.
    held.velocity = held.velocity.map((v, axis) => 0.7 * v + 0.3 * velocity[axis]);
    const from = seconds > 0 ? held.place : held.target;
    this.sides.hold(held.particle, from, velocity);
    held.place = held.target;
  }

  /** The link to all this. */
  async link() {
    return `${location.origin}${location.pathname}#${await pack(toShare(this.chosen))}`;
  }

  run() {
    let last = performance.now();
    const picture = (now) => {
      // A page that was hidden does not catch up.
      const elapsed = Math.min((now - last) / 1000, 1 / 20);
      last = now;
      this.#pull(elapsed);
      if (this.playing) this.sides.advance(elapsed, this.chosen.speed, this.held?.particle);
      this.stage.draw(this.camera, this.sides.list.map((side) => side.positions));
      this.frames += 1;
      this.#tell("picture");
      requestAnimationFrame(picture);
    };
    requestAnimationFrame(picture);
  }
}
