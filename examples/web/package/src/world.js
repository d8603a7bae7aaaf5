// A world: one block of the module's memory, and a workspace for what steps it.

import { HookeError, NOBODY, WORKSPACE, wrong } from "./error.js";
import { LINE } from "./memory.js";
import { distance, flatParticles, flatSprings, holdNumber, isCapacity } from "./model.js";
import { COLLISIONS, HOLDS, STEPPERS } from "./names.js";
import { LEDGER, REPORT, both, readLedger, readReport } from "./report.js";

const F32 = 0;
/** What models are handed over through, particles or springs at a time; and whatever is told. */
const AT_ONCE = 256;
const ROOM = AT_ONCE * 64;
const ENCODED = new TextDecoder();
/** Time within this part of a step of its end is its end. */
const SAME = 1e-9;

const numbered = (names, name, what) => {
  const number = names.indexOf(name);
  if (number < 0) throw new HookeError("no-such-option", `there is no ${what} ${name}: it is one of ${names.join(", ")}`);
  return number;
};

export class World {
  #call;
  #memory;
  /** Addresses: the world, what is told, the views. 0 once it has been freed. */
  #world = 0;
  #room = 0;
  #views = 0;
  #workspace = 0;
  #workspaceBytes = 0;
  #capacity;
  #particles = 0;
  #springs = 0;
  /** What springs were given, which factors are of. */
  #given = { stiffness: [], damping: [] };
  #stepper = "auto";
  #collision = "time-of-impact";
  #tolerance = 1e-6;
  #timeStep = 1e-3;
  #owed = 0;
  #follows = false;
  #buffer;
  #columns;

  constructor(exports, memory, model) {
    this.#call = exports;
    this.#memory = memory;
    const particles = isCapacity(model) ? undefined : flatParticles(model.particles);
    const springs = isCapacity(model) ? undefined : flatSprings(model.springs ?? [], particles.position);
    this.#capacity = particles
      ? [particles.mass.length, springs.stiffness.length, model.planes?.length ?? 0]
      : [model.particles, model.springs ?? 0, model.planes ?? 0];
    this.#create();
    try {
      this.#choose();
      if (particles) this.#fill(particles, springs, model);
    } catch (error) {
      this.free();
      throw error;
    }
  }

  #create() {
    const bytes = this.#call.hooke_size_of(F32, ...this.#capacity) >>> 0;
    const views = 4 * 3 * 4 * this.#capacity[0];
    const block = this.#memory.take(bytes + ROOM + views + 128);
    this.#world = block;
    this.#views = block + Math.ceil(bytes / 64) * 64;
    this.#room = this.#views + Math.ceil(views / 64) * 64;
    const address = this.#room;
    this.#check(this.#call.hooke_create(block, bytes, F32, ...this.#capacity, address));
  }

  // What models are made of.

  #fill({ position, velocity, mass, hold }, springs, { planes = [], gravity }) {
    const numbers = (at, count) => new Float64Array(this.#memory.buffer, this.#room + at, count);
    const words = (at, count) => new Uint32Array(this.#memory.buffer, this.#room + at, count);
    for (let first = 0; first < mass.length; first += AT_ONCE) {
      const count = Math.min(AT_ONCE, mass.length - first);
      const [x, v, m, h] = [0, 24 * AT_ONCE, 48 * AT_ONCE, 56 * AT_ONCE];
      numbers(x, 3 * count).set(position.slice(3 * first, 3 * (first + count)));
      numbers(v, 3 * count).set(velocity.slice(3 * first, 3 * (first + count)));
      numbers(m, count).set(mass.slice(first, first + count));
      words(h, count).set(Array.from(hold.slice(first, first + count), holdNumber));
      this.#check(this.#call.hooke_add_particles(this.#world, count, ...[x, v, m, h].map((at) => this.#room + at)),
        "particle", first);
    }
    for (let first = 0; first < springs.stiffness.length; first += AT_ONCE) {
      const count = Math.min(AT_ONCE, springs.stiffness.length - first);
      const [b, k, d, l] = [0, 8 * AT_ONCE, 16 * AT_ONCE, 24 * AT_ONCE];
      words(b, 2 * count).set(springs.between.slice(2 * first, 2 * (first + count)));
      numbers(k, count).set(springs.stiffness.slice(first, first + count));
      numbers(d, count).set(springs.damping.slice(first, first + count));
      numbers(l, count).set(springs.restLength.slice(first, first + count));
      this.#check(this.#call.hooke_add_springs(this.#world, count, ...[b, k, d, l].map((at) => this.#room + at)),
        "spring", first);
    }
    this.#given = { stiffness: Array.from(springs.stiffness), damping: Array.from(springs.damping) };
    planes.forEach(({ point, normal, restitution = 1 }, plane) => {
      this.#check(this.#call.hooke_add_plane(this.#world, ...point, ...normal, restitution, 0), "plane", plane);
    });
    if (gravity) this.setGravity(gravity);
    this.#count();
  }

  addParticle({ position, velocity = [0, 0, 0], mass = 1, pinned = false }) {
    const hold = pinned ? HOLDS.indexOf("pinned") : HOLDS.indexOf("free");
    this.#check(this.#call.hooke_add_particle(this.#alive(), ...position, ...velocity, mass, hold, this.#room));
    this.#count();
    return this.#particles - 1;
  }

  addSpring({ between, stiffness, damping = 0, restLength = distance(this.positions, between) }) {
    this.#check(this.#call.hooke_add_spring(this.#alive(), ...between, stiffness, damping, restLength, this.#room));
    this.#given.stiffness.push(stiffness);
    this.#given.damping.push(damping);
    this.#count();
    return this.#springs - 1;
  }

  addPlane({ point, normal, restitution = 1 }) {
    this.#check(this.#call.hooke_add_plane(this.#alive(), ...point, ...normal, restitution, this.#room));
    return new DataView(this.#memory.buffer).getUint32(this.#room, true);
  }

  #count() {
    this.#check(this.#call.hooke_counts(this.#alive(), this.#room, this.#room + 4, 0));
    const view = new DataView(this.#memory.buffer, this.#room);
    this.#particles = view.getUint32(0, true);
    this.#springs = view.getUint32(4, true);
    this.#columns = undefined;
    this.#placed();
  }

  // What is chosen.

  get stepper() { return this.#stepper; }
  set stepper(name) {
    numbered(STEPPERS, name, "stepper");
    this.#stepper = name;
    this.#choose();
  }

  get collision() { return this.#collision; }
  set collision(name) {
    numbered(COLLISIONS, name, "form of collision");
    this.#collision = name;
    this.#choose();
  }

  get tolerance() { return this.#tolerance; }
  set tolerance(tolerance) {
    if (!(tolerance > 0 && Number.isFinite(tolerance))) throw new HookeError("tolerance", "the tolerance is not positive and finite");
    this.#tolerance = tolerance;
    this.#choose();
  }

  get timeStep() { return this.#timeStep; }
  set timeStep(seconds) {
    if (!(seconds > 0 && Number.isFinite(seconds))) throw new HookeError("time-step", "the time step is not positive and finite");
    this.#timeStep = seconds;
    this.#owed = Math.min(this.#owed, seconds);
  }

  #choose() {
    const [stepper, collision] = [STEPPERS.indexOf(this.#stepper), COLLISIONS.indexOf(this.#collision)];
    this.#check(this.#call.hooke_set_stepper(this.#alive(), stepper, this.#tolerance));
    this.#check(this.#call.hooke_set_collision(this.#world, collision));
    const bytes = this.#call.hooke_workspace_size(F32, stepper, collision, ...this.#capacity, 0) >>> 0;
    if (bytes > this.#workspaceBytes) this.#widen(bytes);
  }

  /** Another workspace; the stepper begins anew. Without memory for it there is still the one before. */
  #widen(bytes) {
    const workspace = this.#memory.take(bytes);
    this.#check(this.#call.hooke_set_workspace(this.#world, workspace, bytes, 0));
    this.#memory.give(this.#workspace);
    this.#workspace = workspace;
    this.#workspaceBytes = bytes;
  }

  // What is told.

  get particles() { return this.#particles; }
  get springs() { return this.#springs; }
  get time() { return this.#call.hooke_time(this.#alive()); }
  get positions() { return this.#seen()[0]; }
  get velocities() { return this.#seen()[1]; }
  get interpolated() { return this.#seen()[2]; }

  /** Positions, velocities, what is between, and where everything was before the last step. */
  #seen() {
    this.#alive();
    if (this.#columns === undefined || this.#buffer !== this.#memory.buffer) {
      this.#buffer = this.#memory.buffer;
      const length = 3 * this.#particles;
      const stride = 12 * this.#capacity[0];
      this.#columns = [0, 1, 2, 3].map((view) => new Float32Array(this.#buffer, this.#views + view * stride, length));
    }
    return this.#columns;
  }

  #read() {
    const stride = 12 * this.#capacity[0];
    this.#check(this.#call.hooke_read_single(this.#world, this.#views, this.#views + stride, 3 * this.#particles));
  }

  /** Something has been put somewhere: nothing is between that and where it was. */
  #placed() {
    this.#read();
    const [positions, , between, before] = this.#seen();
    before.set(positions);
    between.set(positions);
  }

  // Stepping.

  step(count = 1) {
    this.#owed = 0;
    const report = this.#steps(count);
    const [positions, , between] = this.#seen();
    between.set(positions);
    return report;
  }

  advance(seconds, maxSteps = Infinity) {
    if (!(seconds >= 0 && Number.isFinite(seconds))) throw new HookeError("time-step", "the time is not finite and 0 or more");
    const dt = this.#timeStep;
    const due = Math.floor((this.#owed + seconds) / dt + SAME);
    const count = Math.min(due, maxSteps);
    const owed = count < due ? 0 : Math.max(0, this.#owed + seconds - count * dt);
    const report = this.#steps(count);
    this.#owed = owed;
    const part = Math.min(1, owed / dt);
    const [positions, , between, before] = this.#seen();
    for (let place = 0; place < positions.length; place++) {
      between[place] = before[place] + part * (positions[place] - before[place]);
    }
    return report;
  }

  /** So many steps; what was before the last of them is kept. */
  #steps(count) {
    let report;
    if (count > 1) report = this.#run(count - 1);
    if (count > 0) {
      if (count > 1) this.#read();
      const [positions, , , before] = this.#seen();
      before.set(positions);
      report = both(report, this.#run(1));
      this.#read();
    }
    return report ?? this.#run(0);
  }

  #run(count) {
    let report;
    let left = count;
    for (;;) {
      const code = this.#call.hooke_step(this.#alive(), this.#timeStep, left, this.#room);
      const taken = readReport(this.#memory.buffer, this.#room);
      report = both(report, taken);
      left -= taken.steps;
      if (code === WORKSPACE) {
        // How large a factor is turns out when it is made: then the step has not been taken.
        this.#widen(Math.max(2 * this.#workspaceBytes, LINE));
        continue;
      }
      if (code !== 0) this.#read();
      this.#check(code);
      return report;
    }
  }

  // Changing what there is.

  setGravity([x, y, z]) {
    this.#check(this.#call.hooke_set_gravity(this.#alive(), x, y, z));
  }

  setPosition(particle, [x, y, z]) {
    this.#check(this.#call.hooke_set_position(this.#alive(), particle, x, y, z));
    this.#placed();
  }

  setVelocity(particle, [x, y, z]) {
    this.#check(this.#call.hooke_set_velocity(this.#alive(), particle, x, y, z));
    this.#read();
  }

  setHold(particle, hold) {
    this.#check(this.#call.hooke_set_hold(this.#alive(), particle, numbered(HOLDS, hold, "hold")));
    this.#read();
  }

  drive(particle, [x, y, z], [u, v, w]) {
    this.#check(this.#call.hooke_drive(this.#alive(), particle, x, y, z, u, v, w));
    this.#read();
  }

  spring(number) {
    const room = this.#room;
    this.#check(this.#call.hooke_spring(this.#alive(), number, room, room + 8, room + 16));
    const [stiffness, damping, restLength] = new Float64Array(this.#memory.buffer, room, 3);
    return { stiffness, damping, restLength };
  }

  setSpring(number, changes) {
    const { stiffness, damping, restLength } = { ...this.spring(number), ...changes };
    this.#check(this.#call.hooke_set_spring(this.#world, number, stiffness, damping, restLength));
    for (const [name, given] of Object.entries(this.#given)) given[number] = changes[name] ?? given[number];
  }

  setSprings({ stiffness, damping, restLength }) {
    this.#setColumns({ stiffness, damping, restLength });
    for (const [name, column] of Object.entries({ stiffness, damping })) {
      if (column !== undefined) this.#given[name] = Array.from(column);
    }
  }

  scaleSprings(factors) {
    const scaled = (name) => factors[name] === undefined ? undefined : this.#given[name].map((given) => given * factors[name]);
    this.#setColumns({ stiffness: scaled("stiffness"), damping: scaled("damping") });
  }

  /** Parameters of all springs, by number; those that are left out stay as they are. */
  #setColumns({ stiffness, damping, restLength }) {
    this.#alive();
    const count = this.#springs;
    for (const [name, column] of Object.entries({ stiffness, damping, restLength })) {
      if (column !== undefined && column.length !== count) throw new HookeError("length", `${name} is one number a spring`);
    }
    const block = this.#memory.take(3 * 8 * count);
    try {
      const addresses = [stiffness, damping, restLength].map((column, place) => {
        if (column === undefined) return 0;
        const address = block + place * 8 * count;
        new Float64Array(this.#memory.buffer, address, count).set(column);
        return address;
      });
      this.#check(this.#call.hooke_set_springs(this.#world, count, ...addresses));
    } finally {
      this.#memory.give(block);
    }
  }

  setRestitution(plane, restitution) {
    const planes = plane === "all" ? Array.from({ length: this.planes }, (_, number) => number) : [plane];
    for (const number of planes) {
      this.#check(this.#call.hooke_set_restitution(this.#alive(), number, restitution), "plane", number);
    }
  }

  get planes() {
    this.#check(this.#call.hooke_counts(this.#alive(), 0, 0, this.#room));
    return new DataView(this.#memory.buffer).getUint32(this.#room, true);
  }

  // Looking closer.

  openLedger() {
    this.#check(this.#call.hooke_open_ledger(this.#alive()));
    this.#follows = true;
  }

  energy() {
    if (!this.#follows) this.openLedger();
    this.#check(this.#call.hooke_read_ledger(this.#alive(), this.#room));
    return readLedger(this.#memory.buffer, this.#room);
  }

  stableStep(stepper = this.#stepper) {
    this.#check(this.#call.hooke_stable_step(this.#alive(), numbered(STEPPERS, stepper, "stepper"), this.#room));
    return new DataView(this.#memory.buffer).getFloat64(this.#room, true);
  }

  snapshot() {
    const size = this.#call.hooke_snapshot_size(this.#alive()) >>> 0;
    const address = this.#memory.take(size);
    try {
      this.#check(this.#call.hooke_snapshot(this.#world, address, size));
      return new Uint8Array(this.#memory.buffer, address, size).slice();
    } finally {
      this.#memory.give(address);
    }
  }

  restore(bytes) {
    const address = this.#memory.take(bytes.length);
    try {
      new Uint8Array(this.#memory.buffer, address, bytes.length).set(bytes);
      this.#check(this.#call.hooke_restore(this.#alive(), address, bytes.length));
    } finally {
      this.#memory.give(address);
    }
    this.#owed = 0;
    this.#placed();
    this.#learn();
  }

  /** What has been chosen is that of the snapshot, and may need another workspace. */
  #learn() {
    const room = this.#room;
    this.#check(this.#call.hooke_choices(this.#world, room, room + 8, room + 16, room + 20));
    const view = new DataView(this.#memory.buffer, room);
    this.#stepper = STEPPERS[view.getUint32(0, true)];
    this.#tolerance = view.getFloat64(8, true);
    this.#collision = COLLISIONS[view.getUint32(16, true)];
    this.#follows = view.getUint32(20, true) === 1;
    this.#choose();
  }

  digest() {
    this.#check(this.#call.hooke_digest(this.#alive(), this.#room));
    return new DataView(this.#memory.buffer).getBigUint64(this.#room, true).toString(16).padStart(16, "0");
  }

  free() {
    if (this.#world === 0) return;
    this.#memory.give(this.#workspace);
    this.#memory.give(this.#world);
    this.#world = 0;
  }

  #alive() {
    if (this.#world === 0) throw new HookeError("not-a-world", "the world has been freed");
    return this.#world;
  }

  #check(code, of, first = 0) {
    if (code === 0) return;
    const bytes = new Uint8Array(this.#memory.buffer);
    const start = this.#call.hooke_message(code) >>> 0;
    const words = ENCODED.decode(bytes.subarray(start, bytes.indexOf(0, start)));
    const culprit = this.#call.hooke_culprit(this.#world) >>> 0;
    // Planes are handed over one by one: which one it is nobody in there knows.
    const number = of === "plane" ? first : culprit === NOBODY ? culprit : first + culprit;
    throw wrong(code, words, number, of);
  }
}
