// Changing, keeping and following a world.

import assert from "node:assert/strict";
import { test } from "node:test";
import { cloth } from "../bench/model.js";
import { HookeError, load } from "../src/index.js";

const hooke = await load();
const pendulum = { gravity: [0, 0, -9.81], particles: [{ position: [0, 0, 1], pinned: true }, { position: [0.3, 0, 1], mass: 0.1 }],
  springs: [{ between: [0, 1], stiffness: 50, damping: 0.1 }], planes: [{ point: [0, 0, 0], normal: [0, 0, 1], restitution: 0.5 }] };
const refuses = (task, code, about = {}) =>
  assert.throws(task, (error) => {
    assert.ok(error instanceof HookeError, String(error));
    assert.equal(error.code, code);
    for (const [what, number] of Object.entries(about)) assert.equal(error[what], number, what);
    return true;
  });

test("what is wrong is told, by code and by number", () => {
  const model = (changes) => ({ ...pendulum, ...changes });
  const particle = { position: [0, 0, 0] };
  refuses(() => hooke.world(model({ particles: [particle, { ...particle, mass: 0 }] })), "mass", { particle: 1 });
  refuses(() => hooke.world(model({ particles: [particle, { position: [0, NaN, 0] }] })), "not-finite", { particle: 1 });
  refuses(() => hooke.world(model({ particles: [particle, { position: [0, 1e39, 0] }] })), "not-finite", { particle: 1 });
  refuses(() => hooke.world(model({ particles: [{ position: [0, 0] }] })), "length");
  refuses(() => hooke.world(model({ springs: [{ between: [0, 2], stiffness: 1 }] })), "no-such-particle", { spring: 0 });
  refuses(() => hooke.world(model({ springs: [{ between: [1, 1], stiffness: 1 }] })), "same-particle", { spring: 0 });
  refuses(() => hooke.world(model({ springs: [{ between: [0, 1], stiffness: -1 }] })), "stiffness", { spring: 0 });
  refuses(() => hooke.world(model({ planes: [{ point: [0, 0, 0], normal: [0, 0, 0] }] })), "normal", { plane: 0 });
  refuses(() => hooke.world(model({ planes: [{ point: [0, 0, 0], normal: [0, 0, 1], restitution: 2 }] })), "restitution", { plane: 0 });
  const world = hooke.world(pendulum);
  refuses(() => { world.stepper = "leapfrog"; }, "no-such-option");
  refuses(() => { world.collision = "bounce"; }, "no-such-option");
  refuses(() => { world.timeStep = 0; }, "time-step");
  refuses(() => { world.tolerance = NaN; }, "tolerance");
  refuses(() => world.setPosition(7, [0, 0, 0]), "no-such-particle", { particle: 7 });
  refuses(() => world.setVelocity(0, [0, 0, Infinity]), "not-finite");
  refuses(() => world.setSpring(3, { stiffness: 1 }), "no-such-spring", { spring: 3 });
  refuses(() => world.setSpring(0, { damping: -1 }), "damping", { spring: 0 });
  refuses(() => world.setRestitution(5, 0.5), "no-such-plane", { plane: 5 });
  refuses(() => world.addParticle({ position: [0, 0, 0] }), "full");
  world.stepper = "dormand-prince-rkn8";
  refuses(() => world.step(), "damped");
  world.free();
  refuses(() => world.step(), "not-a-world");
});

test("a step that fails leaves the state, and names the particle", () => {
  const world = hooke.world({ ...pendulum, springs: [{ between: [0, 1], stiffness: 1e30, restLength: 0.1 }] });
  Object.assign(world, { stepper: "explicit-euler", timeStep: 1 });
  // The first step leads to a velocity of 1e31 m/s or so, the second one past all numbers.
  world.step();
  const before = world.digest();
  refuses(() => world.step(3), "non-finite", { particle: 1 });
  assert.equal(world.time, 1);
  assert.equal(world.digest(), before);
});

for (const stepper of ["semi-implicit-euler", "implicit-euler", "velocity-verlet", "dop853", "auto"]) {
  test(`a snapshot goes on to the bit: ${stepper}`, () => {
    const world = hooke.world(pendulum);
    Object.assign(world, { stepper, collision: "reflect", tolerance: 1e-5, timeStep: 1e-3 });
    world.energy();
    world.step(137);
    const kept = world.snapshot();
    const reached = [world.digest(), world.time];
    world.step(900);
    const [digest, energy] = [world.digest(), world.energy()];
    world.restore(kept);
    assert.deepEqual([world.digest(), world.time], reached);
    world.step(900);
    assert.equal(world.digest(), digest);
    assert.deepEqual(world.energy(), energy);
    // In another world of the same model, which stands elsewhere and is changed.
    const other = hooke.world(pendulum);
    other.timeStep = 1e-3;
    other.step(5);
    other.setSpring(0, { stiffness: 1 });
    other.setHold(1, "pinned");
    Object.assign(other, { stepper: "rk4", collision: "project", tolerance: 1e-3 });
    other.restore(kept);
    assert.deepEqual([other.stepper, other.collision, other.tolerance], [stepper, "reflect", 1e-5]);
    other.step(900);
    assert.equal(other.digest(), digest);
    // The ledger goes on as well.
    assert.deepEqual(other.energy(), energy);
    // One choice leaves the others.
    other.restore(kept);
    other.tolerance = 1e-5;
    other.step(900);
    assert.equal(other.digest(), digest);
    // The control.
    other.restore(kept);
    other.step(899);
    assert.notEqual(other.digest(), digest);
  });
}

test("a snapshot of a world without a ledger closes the one that there is, and finds room for its stepper", () => {
  const model = cloth(16);
  const [world, other] = [hooke.world(model), hooke.world(model)];
  for (const each of [world, other]) Object.assign(each, { stepper: "semi-implicit-euler", timeStep: 1e-3 });
  other.energy();
  world.stepper = "dop853";
  world.step(5);
  other.restore(world.snapshot());
  for (const each of [world, other]) each.step(5);
  assert.equal(other.stepper, "dop853");
  assert.equal(other.digest(), world.digest());
  // Opened by this call, with what there is now.
  const { openedWith, total } = other.energy();
  assert.equal(openedWith, total);
});

test("bytes that are no snapshot of this model change nothing", () => {
  const world = hooke.world(pendulum);
  world.step(10);
  const kept = world.snapshot();
  const spoilt = (change) => {
    const bytes = kept.slice();
    change(new DataView(bytes.buffer), bytes);
    return bytes;
  };
  refuses(() => world.restore(new Uint8Array(0)), "snapshot");
  refuses(() => world.restore(kept.slice(1)), "snapshot");
  refuses(() => world.restore(spoilt((view) => view.setUint8(0, 0))), "snapshot");
  refuses(() => world.restore(spoilt((view) => view.setUint32(12, 3, true))), "snapshot");
  // Every byte past the counts, made NaN's or a huge number, which single precision does not hold: refused as a whole, or
  // taken, but never a crash.
  for (const wrong of [NaN, 1e300]) {
    for (let place = 28; place + 8 <= kept.length; place += 4) {
      // Elsewhere, so that what is half put back shows.
      world.restore(kept);
      world.step(3);
      const before = world.snapshot();
      try {
        world.restore(spoilt((view) => view.setFloat64(place, wrong, true)));
      } catch (error) {
        assert.ok(error instanceof HookeError && error.code === "snapshot", String(error));
        assert.deepEqual(world.snapshot(), before);
      }
    }
  }
});

test("parameters are changed live", () => {
  const world = hooke.world(pendulum);
  world.scaleSprings({ stiffness: 2, damping: 0.5 });
  const { stiffness, damping } = world.spring(0);
  assert.equal(stiffness, 100);
  assert.equal(damping, Math.fround(0.1) / 2);
  world.setSpring(0, { restLength: 0.25 });
  assert.deepEqual(world.spring(0), { stiffness, damping, restLength: 0.25 });
  // As a world that is made so.
  const made = hooke.world({ ...pendulum, springs: [{ between: [0, 1], stiffness, damping, restLength: 0.25 }], gravity: [0, 0, -1.62],
    planes: [{ ...pendulum.planes[0], restitution: 0.9 }] });
  world.setGravity([0, 0, -1.62]);
  world.setRestitution("all", 0.9);
  for (const each of [world, made]) each.step(3000);
  assert.equal(world.digest(), made.digest());
  assert.notEqual(world.digest(), (() => { const other = hooke.world(pendulum); other.step(3000); return other.digest(); })());
});

test("a particle is dragged, and let go", () => {
  const world = hooke.world({ particles: [{ position: [0, 0, 0] }] });
  world.timeStep = 0.125;
  world.drive(0, [1, 2, 3], [0, 8, 0]);
  world.step();
  assert.deepEqual([...world.positions], [1, 3, 3]);
  world.setGravity([0, 0, -8]);
  world.step();
  assert.deepEqual([...world.positions], [1, 4, 3]);
  world.setHold(0, "free");
  world.step();
  // x + dt v + dt² a / 2: in free flight exactly.
  assert.deepEqual([...world.positions], [1, 5, 3 - 0.0625]);
});

test("time is kept by an accumulator, and what is between steps is interpolated", () => {
  const world = hooke.world({ particles: [{ position: [0, 0, 0], velocity: [8, 0, 0] }] });
  world.timeStep = 0.25;
  assert.equal(world.advance(0.125).steps, 0);
  assert.equal(world.interpolated[0], 0);
  assert.equal(world.advance(0.25).steps, 1);
  // 0.125 s past the step at 0.25 s: half way to it from the start.
  assert.deepEqual([world.positions[0], world.interpolated[0]], [2, 1]);
  assert.equal(world.advance(0.5).steps, 2);
  assert.deepEqual([world.positions[0], world.interpolated[0]], [6, 5]);
  // What is past the most that may be taken is dropped.
  assert.equal(world.advance(100, 3).steps, 3);
  assert.equal(world.advance(0.2).steps, 0);
  // However time is cut up, the steps are the same ones.
  const [one, other] = [hooke.world(pendulum), hooke.world(pendulum)];
  for (let frame = 0; frame < 60; frame++) one.advance(1 / 60);
  other.advance(1);
  assert.equal(one.digest(), other.digest());
  assert.equal(one.time, 1);
});

test("memory grows under worlds that are there, and is used again", async () => {
  const own = await load();
  const small = own.world(pendulum);
  const digest = small.digest();
  const view = small.positions;
  const large = own.world(cloth(80));
  assert.equal(view.length, 0, "the memory has grown, and the old view is empty");
  assert.equal(small.positions.length, 6);
  assert.equal(small.digest(), digest);
  large.stepper = "dop853";
  large.step(2);
  const bytes = large.positions.buffer.byteLength;
  large.free();
  for (let round = 0; round < 20; round++) {
    const again = own.world(cloth(80));
    again.stepper = "dop853";
    again.step(1);
    again.free();
  }
  assert.equal(small.positions.buffer.byteLength, bytes);
  small.step(10);
  assert.notEqual(small.digest(), digest);
});

test("a world may be filled piece by piece", () => {
  const world = hooke.world({ particles: 2, springs: 1, planes: 1 });
  pendulum.particles.forEach((particle) => world.addParticle(particle));
  world.step(3);
  const fresh = hooke.world({ particles: 2, springs: 1, planes: 1 });
  assert.equal(fresh.addParticle(pendulum.particles[0]), 0);
  assert.equal(fresh.addParticle(pendulum.particles[1]), 1);
  assert.equal(fresh.addSpring({ ...pendulum.springs[0], restLength: 0.3 }), 0);
  assert.equal(fresh.addPlane(pendulum.planes[0]), 0);
  fresh.setGravity(pendulum.gravity);
  const whole = hooke.world({ ...pendulum, springs: [{ ...pendulum.springs[0], restLength: 0.3 }] });
  for (const each of [fresh, whole]) each.step(500);
  assert.equal(fresh.digest(), whole.digest());
  assert.deepEqual([fresh.particles, fresh.springs, fresh.planes], [2, 1, 1]);
});
