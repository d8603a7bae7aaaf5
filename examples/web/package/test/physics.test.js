// Against closed forms.

import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "../src/index.js";

const hooke = await load();

/** A mass of 1 kg on a spring of 100 N/m along x, let go 0.1 m from rest: x = 0.1 cos(10 t). */
function oscillator(stepper, timeStep) {
  const world = hooke.world({
    particles: [{ position: [0, 0, 0], pinned: true }, { position: [1.1, 0, 0] }],
    springs: [{ between: [0, 1], stiffness: 100, restLength: 1 }],
  });
  Object.assign(world, { stepper, timeStep });
  return world;
}

function largestError(stepper, timeStep) {
  const world = oscillator(stepper, timeStep);
  let error = 0;
  for (let step = 1; step <= Math.round(1 / timeStep); step++) {
    world.step();
    error = Math.max(error, Math.abs(world.positions[3] - 1 - 0.1 * Math.cos(10 * world.time)));
  }
  world.free();
  return error;
}

// Errors of the rules themselves, to leading order in h = 10 dt over the phase 10 rad: amplitude 0.1 times
// h/2 (the semi-implicit method is half a step out of phase), h²/24 * 10 (Verlet's frequency) and less.
test("an oscillator: the semi-implicit Euler method is off by h/2 of its amplitude", () => {
  const [coarse, fine] = [largestError("semi-implicit-euler", 2 ** -8), largestError("semi-implicit-euler", 2 ** -9)];
  // First order, to the few per cent that the next order makes up.
  assert.ok(Math.abs(coarse / fine - 2) < 0.1, `${coarse / fine}`);
  assert.ok(Math.abs(coarse - 0.1 * 10 * 2 ** -9) < 0.1 * coarse, `${coarse}`);
});

test("an oscillator: velocity Verlet is of second order", () => {
  const [coarse, fine] = [largestError("velocity-verlet", 2 ** -6), largestError("velocity-verlet", 2 ** -7)];
  assert.ok(Math.abs(coarse / fine - 4) < 0.2, `${coarse / fine}`);
});

test("an oscillator: RK4 is right to the rounding of single precision", () => {
  // 256 roundings of numbers near 1, of 6e-8 each at most, add up like a random walk to 1e-6.
  assert.ok(largestError("rk4", 2 ** -8) < 2e-6);
  // The control: explicit Euler is not, by far.
  assert.ok(largestError("explicit-euler", 2 ** -8) > 1e-3);
});

test("a ball that bounces flies exactly", () => {
  const world = hooke.world({
    gravity: [0, 0, -10],
    particles: [{ position: [0, 0, 5] }],
    planes: [{ point: [0, 0, 0], normal: [0, 0, 3], restitution: 0.5 }],
  });
  world.timeStep = 0.01;
  const report = world.step(150);
  // It falls for 1 s, leaves at 5 m/s, and is at its top of 1.25 m at 1.5 s.
  assert.equal(report.hits, 1);
  assert.ok(Math.abs(world.positions[2] - 1.25) < 1e-6, `${world.positions[2]}`);
  assert.ok(Math.abs(world.velocities[2]) < 1e-5);
  assert.ok(Math.abs(world.time - 1.5) < 1e-12);
});

test("the ledger adds up: what damping takes is missing from the rest", () => {
  const world = hooke.world({
    particles: [{ position: [0, 0, 0], pinned: true }, { position: [1.1, 0, 0] }],
    springs: [{ between: [0, 1], stiffness: 100, damping: 2, restLength: 1 }],
  });
  Object.assign(world, { stepper: "rk4", timeStep: 1e-3 });
  const start = world.energy();
  // ½ k x²; positions near 1 m are off by 6e-8 m.
  assert.ok(Math.abs(start.elastic - 0.5) < 2e-6);
  world.step(3000);
  const end = world.energy();
  // The amplitude decays as exp(-t), its energy as exp(-2t), give or take ζ = 0.1 of it by where in a swing it is.
  const left = 0.5 * Math.exp(-6);
  assert.ok(Math.abs(end.total - left) < 0.11 * left, `${end.total}`);
  assert.ok(Math.abs(end.lostToDamping - (0.5 - end.total)) < 1e-4, JSON.stringify(end));
  assert.ok(Math.abs(end.remainder) < 1e-4);
  assert.ok(Math.abs(end.total + end.lostToDamping - end.openedWith - end.remainder) < 1e-12);
});

test("the longest stable step of one spring is 2/ω, and holds", () => {
  const world = oscillator("semi-implicit-euler", 0.2);
  assert.ok(Math.abs(world.stableStep() - 0.2) < 1e-12);
  assert.equal(world.stableStep("implicit-euler"), Infinity);
  const largest = (timeStep) => {
    const swings = oscillator("semi-implicit-euler", timeStep);
    let most = 0;
    for (let step = 0; step < 40; step++) {
      swings.step();
      most = Math.max(most, Math.abs(swings.positions[3] - 1));
    }
    swings.free();
    return most;
  };
  assert.ok(largest(0.198) < 2, "1 % below");
  assert.ok(largest(0.204) > 10, "2 % above");
});
