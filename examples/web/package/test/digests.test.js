// The bits are the desktop's, with and without 128-bit vectors.

import assert from "node:assert/strict";
import { test } from "node:test";
import { cloth } from "../bench/model.js";
import { load } from "../src/index.js";
import { desktopDigest } from "./scene.js";

const modules = [await load({ simd: false }), await load({ simd: true })];
// A power of two, so that the desktop counts just so many steps.
const timeStep = 2 ** -10;

function run(hooke, model, { stepper, collision, steps, tolerance }) {
  const world = hooke.world(model);
  Object.assign(world, { stepper, collision, tolerance, timeStep });
  world.step(steps);
  const digest = world.digest();
  world.free();
  return digest;
}

/** A cloth over a floor that it falls on, and free balls beside it. */
function scene(damping) {
  const model = cloth(12, { stiffness: 20, damping });
  const { position, velocity, mass, hold } = model.particles;
  const balls = Array.from({ length: 9 }, (_, i) => [2 + 0.3 * i, 0.1 * i, 1 + 0.05 * i]).flat();
  model.particles = {
    position: Float64Array.from([...position, ...balls]),
    velocity: Float64Array.from([...velocity, ...balls.map((_, i) => (i % 3 === 0 ? 0.5 : 0))]),
    mass: Float64Array.from([...mass, ...new Array(9).fill(0.2)]),
    hold: Int32Array.from([...hold, ...new Array(9).fill(-1)]),
  };
  model.planes = [{ point: [0, 0, 0.75], normal: [0.1, 0, 1], restitution: 0.6 }];
  return model;
}

const steppers = ["explicit-euler", "semi-implicit-euler", "implicit-euler", "implicit-euler-linearised", "velocity-verlet", "rk4",
  "blanes-moan-s6", "dop853", "dormand-prince-rkn8", "implicit-midpoint", "tr-bdf2", "auto"];

for (const stepper of steppers) {
  for (const collision of ["reflect", "project", "time-of-impact"]) {
    test(`${stepper}, ${collision}`, () => {
      const model = scene(stepper === "dormand-prince-rkn8" ? 0 : 0.02);
      const settings = { stepper, collision, timeStep, steps: 512, tolerance: 1e-6 };
      const desktop = desktopDigest(model, settings);
      assert.match(desktop, /^[0-9a-f]{16}$/);
      for (const hooke of modules) assert.equal(run(hooke, model, settings), desktop, `simd: ${hooke.simd}`);
    });
  }
}

test("a step more or a bit elsewhere is another digest", () => {
  const model = scene(0.02);
  const settings = { stepper: "rk4", collision: "reflect", timeStep, steps: 64, tolerance: 1e-6 };
  const digest = run(modules[0], model, settings);
  assert.notEqual(run(modules[0], model, { ...settings, steps: 65 }), digest);
  model.particles.position[17] *= 1 + 2 ** -22;
  assert.notEqual(run(modules[0], model, settings), digest);
});

test("a stiff cloth is solved by the same factor as on the desktop", () => {
  const model = cloth(16, { stiffness: 1e5, damping: 1 });
  const settings = { stepper: "implicit-euler", collision: "reflect", timeStep: 2 ** -6, steps: 20, tolerance: 1e-6 };
  const world = modules[1].world(model);
  Object.assign(world, settings);
  assert.ok(world.step(20).factorisations > 0);
  assert.equal(world.digest(), desktopDigest(model, settings));
});
