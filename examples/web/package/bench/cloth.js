// The damped cloth of 64 x 64 by semi-implicit Euler: WebAssembly beside the textbook's loop in JavaScript, in turns in
// one process; of each the fastest round counts. Fails where WebAssembly with vectors is less than three times faster.

import { load } from "../src/index.js";
import { cloth } from "./model.js";

const STEPS = 5;
const ROUNDS = 200;
const DT = 1e-4;
const WANTED = 3;

const model = cloth(64);
const springs = model.springs.stiffness.length;

// All begin in full motion: before that, the first disturbances cross the cloth as numbers next to 0, which processors
// take a hundred times as long for, in any language.
const before = (await load()).world(model);
before.stepper = "semi-implicit-euler";
before.timeStep = DT;
before.step(5000);
model.particles.position = Float64Array.from(before.positions);
model.particles.velocity = Float64Array.from(before.velocities);
const contenders = [];
for (const [Reals, precision] of [[Float32Array, "f32"], [Float64Array, "f64"]]) {
  for (const interleaved of [true, false]) {
    // A module of its own for each: else one compiled loop serves arrays of both kinds, and is slow with either.
    const { textbook } = await import(`./textbook.js?${precision}-${interleaved}`);
    const loop = textbook(model, Reals, interleaved);
    const run = () => { for (let step = 0; step < STEPS; step++) loop.step(DT); };
    contenders.push({ name: `JavaScript, ${interleaved ? "records" : "columns"}, ${precision}`, run, is: "textbook", position: loop.position });
  }
}
for (const simd of [false, true]) {
  const world = (await load({ simd })).world(model);
  world.stepper = "semi-implicit-euler";
  world.timeStep = DT;
  const position = (i) => Array.from(world.positions.subarray(3 * i, 3 * i + 3));
  contenders.push({ name: `WebAssembly${simd ? ", 128-bit vectors" : ""}`, run: () => world.step(STEPS), is: simd ? "simd" : "plain", position });
}
for (const contender of contenders) contender.best = Infinity;
for (let round = 0; round < ROUNDS; round++) {
  for (const contender of contenders) {
    const start = performance.now();
    contender.run();
    contender.best = Math.min(contender.best, performance.now() - start);
  }
}

// All of them have followed the same motion: else their times are of different things.
const middle = 64 * 32 + 32;
const heights = contenders.map(({ position }) => position(middle)[2]);
const spread = Math.max(...heights) - Math.min(...heights);
// Rounding alone, amplified by the cloth, parts f32 from f64 by micrometres in so many steps.
if (!(spread < 1e-4)) throw new Error(`the middle of the cloth is at heights that differ by ${spread} m`);

const per = (best) => (best * 1e6) / (STEPS * springs);
for (const { name, best } of contenders) console.log(`${name.padEnd(34)} ${per(best).toFixed(2)} ns per spring and step`);
const fastest = (kind) => Math.min(...contenders.filter(({ is }) => is === kind).map(({ best }) => best));
const ratio = fastest("textbook") / fastest("simd");
console.log(`WebAssembly with vectors takes ${ratio.toFixed(2)} times less than the fastest loop in JavaScript`);
if (ratio < WANTED) process.exitCode = 1;
