// One world, stepped by one stepper, with what became of it.

import { stepperOf } from "./steppers.js";
import { Tracks } from "./tracks.js";
import { seconds } from "./words.js";

/** A page must stay usable: a side that takes longer than this in a picture is shown in slow motion. */
const LONGEST_MILLISECONDS = 14;

export class Side {
  /** Why it stands still: `{ particle, time, words }`; nothing while it goes on. */
  stopped;
  steps = 0;
  /** How many steps more its partner had taken when this one went on again. */
  ahead = 0;

  /** @param {import("../hooke/index.js").Hooke} hooke */
  constructor(hooke, scene, stepper, choices) {
    Object.assign(this, { scene, stepper, choices, tracks: new Tracks(scene) });
    const { restitution } = choices;
    const world = hooke.world({
      gravity: choices.gravity,
      particles: { position: scene.position, velocity: scene.velocity, mass: scene.mass, hold: scene.hold },
      springs: { between: scene.between, restLength: scene.restLength, stiffness: scene.stiffness, damping: scene.damping },
      planes: scene.planes.map((plane) => ({ ...plane, restitution: restitution ?? plane.restitution })),
    });
    this.world = world;
    try {
      this.#scaleSprings(choices);
      this.#pace(choices);
      world.stepper = stepper;
      // The ledger opens here, before the first step.
      world.energy();
    } catch (error) {
      world.free();
      throw error;
    }
  }

  #pace({ timeStep, tolerance, collision }) {
    const { world } = this;
    world.collision = collision;
    world.tolerance = tolerance;
    world.timeStep = timeStep;
    // Times are whole numbers of steps from the last change on: sums of steps would drift away from those.
    this.since = { time: world.time, steps: this.steps };
  }

  /** All springs at once, relative to what the scene made them. */
  #scaleSprings({ stiffness, damping }) {
    this.world.scaleSprings({ stiffness, damping });
  }

  get time() {
    return this.world.time;
  }

  /** What of the choices changed, done to the world as it is. */
  change(choices) {
    const { world, scene, choices: before } = this;
    const changed = (...keys) => keys.some((key) => String(choices[key]) !== String(before[key]));
    this.choices = choices;
    if (changed("timeStep", "tolerance", "collision")) this.#pace(choices);
    if (changed("gravity")) world.setGravity(choices.gravity);
    if (changed("restitution")) scene.planes.forEach((plane, i) => world.setRestitution(i, choices.restitution ?? plane.restitution));
    if (changed("stiffness", "damping")) this.#scaleSprings(choices);
    this.stopped = undefined;
  }

  setStepper(stepper) {
    this.stepper = stepper;
    this.world.stepper = stepper;
    this.stopped = undefined;
  }

  /**
   * Takes that many steps, or as many as there is time for in one picture.
   * @returns {number} how many were taken
   */
  advance(count, { hurry = true, held } = {}) {
    const began = performance.now();
    let taken = 0;
    try {
      while (taken < count && !this.stopped) {
        const many = this.tracks.any || held ? 1 : Math.min(count - taken, this.chunk ?? 4);
        if (this.tracks.any) this.#stepOnTracks(held);
        else this.world.step(many);
        this.steps += many;
        taken += many;
        const spent = performance.now() - began;
        this.chunk = Math.max(1, Math.min(256, Math.ceil((taken * 2) / Math.max(spent, 0.05))));
        if (hurry && spent > LONGEST_MILLISECONDS) break;
      }
    } catch (error) {
      // Of several steps those before the one that failed were taken.
      const { since, choices: { timeStep } } = this;
      this.steps = since.steps + Math.round((this.world.time - since.time) / timeStep);
      this.#stop(error);
    }
    this.milliseconds = performance.now() - began;
    return taken;
  }

  #stepOnTracks(held) {
    const { world, tracks, choices: { timeStep }, since } = this;
    const done = this.steps - since.steps;
    let from = since.time + done * timeStep;
    const to = since.time + (done + 1) * timeStep;
    const stops = tracks.stops(from, to);
    for (const stop of stops) {
      tracks.drive(world, from, stop, held);
      world.timeStep = stops.length > 1 ? stop - from : timeStep;
      world.step(1);
      from = stop;
    }
    world.timeStep = timeStep;
  }

  #stop(error) {
    if (error?.code === undefined) throw error;
    const time = this.world.time;
    const { title } = stepperOf(this.stepper);
    const nonFinite = error.particle !== undefined && error.particle !== null;
    const words = nonFinite
      ? `exploded at particle ${error.particle} in the step after ${seconds(time)}: its place would be no number. The state before is kept.`
      : `${title} does not go on after ${seconds(time)}: ${error.message}`;
    this.stopped = { particle: nonFinite ? error.particle : undefined, time, words, exploded: nonFinite };
  }

  get positions() {
    return this.world.positions;
  }

  energy() {
    return this.world.energy();
  }

  /** Begins the balance anew: what was changed from outside is no doing of the stepper. */
  openLedger() {
    this.world.openLedger();
    return true;
  }

  stableStep(stepper = this.stepper) {
    return this.world.stableStep(stepper);
  }

  digest() {
    return this.world.digest();
  }

  /** Takes hold of a particle at a place; it moves with that velocity until told otherwise. */
  hold(particle, place, velocity) {
    this.world.drive(particle, place, velocity);
    this.stopped = undefined;
  }

  /** Lets it go as the scene has it: free, with the velocity of the hand, or held where it is. */
  release(particle, velocity) {
    const { world } = this;
    if (this.scene.hold[particle] === -1) {
      world.setHold(particle, "free");
      world.setVelocity(particle, velocity);
    } else if (this.scene.hold[particle] === -2) {
      world.setHold(particle, "pinned");
    }
  }

  free() {
    this.world.free();
  }
}
