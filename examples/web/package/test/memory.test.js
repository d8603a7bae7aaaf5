// A module whose memory cannot grow, and then can.

import assert from "node:assert/strict";
import { test } from "node:test";
import { cloth } from "../bench/model.js";
import { World } from "../src/index.js";
import { exportsOf } from "../src/load.js";
import { Memory } from "../src/memory.js";

/** A module's memory, which grows while `mayGrow` says so. */
class Limited {
  mayGrow = true;
  #memory;

  constructor(memory) {
    this.#memory = memory;
  }

  get buffer() {
    return this.#memory.buffer;
  }

  grow(pages) {
    if (!this.mayGrow) throw new RangeError("no more pages");
    return this.#memory.grow(pages);
  }
}

const model = cloth(16);

/** Steps of 20 ms: for implicit Euler a factor is less work then, and what room it needs turns out when it is made. */
async function limited() {
  const exports = await exportsOf({ simd: false });
  const memory = new Limited(exports.memory);
  const world = new World(exports, new Memory(memory, exports.__heap_base.value), model);
  Object.assign(world, { stepper: "semi-implicit-euler", timeStep: 0.02 });
  world.step();
  return { memory, world };
}

test("without memory for another workspace a world says so every time, and goes on with the one that it has", async () => {
  const { memory, world } = await limited();
  const { world: other } = await limited();
  const before = world.digest();
  memory.mayGrow = false;
  world.stepper = "implicit-euler";
  for (let time = 0; time < 3; time++) assert.throws(() => world.step(), { code: "memory" });
  assert.equal(world.digest(), before);
  // What needs no more than there is steps, as where nothing was wanted in between.
  for (const each of [world, other]) {
    each.stepper = "dop853";
    each.step();
  }
  assert.equal(world.digest(), other.digest());
  // With memory again, the stepper that was wanted.
  memory.mayGrow = true;
  for (const each of [world, other]) {
    each.stepper = "implicit-euler";
    each.step();
  }
  assert.notEqual(world.digest(), before);
  assert.equal(world.digest(), other.digest());
});
