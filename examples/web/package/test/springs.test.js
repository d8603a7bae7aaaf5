// Changing all springs at once.

import assert from "node:assert/strict";
import { performance } from "node:perf_hooks";
import { test } from "node:test";
import { cloth } from "../bench/model.js";
import { HookeError, load } from "../src/index.js";

const hooke = await load();
const model = cloth(8);
const count = model.springs.stiffness.length;
const columns = {
  stiffness: Float64Array.from({ length: count }, (_, spring) => 80 + 0.25 * spring),
  damping: Float64Array.from({ length: count }, (_, spring) => 0.01 + 0.001 * spring),
  restLength: model.springs.restLength.map((length) => 0.9 * length),
};
const made = (springs) => hooke.world({ ...model, springs: { ...model.springs, ...springs } });
const reached = (world) => {
  world.step(40);
  return world.digest();
};

test("springs that are changed are those of a world that is made with them", () => {
  const digest = reached(made(columns));
  const world = hooke.world(model);
  world.setSprings(columns);
  assert.equal(reached(world), digest);
  // Column by column, and what is left out stays.
  const other = hooke.world(model);
  for (const [name, column] of Object.entries(columns)) other.setSprings({ [name]: column });
  assert.equal(reached(other), digest);
  const { stiffness, damping } = columns;
  assert.equal(reached(made({ stiffness, damping })), (() => {
    const part = hooke.world(model);
    part.setSprings({ stiffness, damping });
    return reached(part);
  })());
  // The control.
  assert.notEqual(reached(hooke.world(model)), digest);
});

test("factors are of what was given, not of what earlier factors made of it", () => {
  const scaled = (given, factor) => given.map((number) => factor * number);
  const world = hooke.world(model);
  world.scaleSprings({ stiffness: 7, damping: 0 });
  world.scaleSprings({ stiffness: 0.3 });
  world.scaleSprings({ damping: 1.7 });
  const { stiffness, damping } = model.springs;
  assert.equal(reached(world), reached(made({ stiffness: scaled(stiffness, 0.3), damping: scaled(damping, 1.7) })));
  // What is given later is what counts from then on: of all springs, of one, and of one that is added.
  const later = hooke.world(model);
  later.scaleSprings({ stiffness: 5 });
  later.setSprings(columns);
  later.setSpring(3, { damping: 0.5 });
  later.scaleSprings({ stiffness: 2, damping: 3 });
  const expected = { ...columns, stiffness: scaled(columns.stiffness, 2), damping: scaled(columns.damping, 3) };
  expected.damping[3] = 1.5;
  assert.equal(reached(later), reached(made(expected)));
  const small = hooke.world({ particles: 2, springs: 1 });
  for (const x of [0, 1]) small.addParticle({ position: [x, 0, 0] });
  small.addSpring({ between: [0, 1], stiffness: 3, damping: 0.5 });
  for (const factor of [4, 2]) small.scaleSprings({ stiffness: factor, damping: factor });
  assert.deepEqual(small.spring(0), { stiffness: 6, damping: 1, restLength: 1 });
});

test("where one is refused it is named, and none is changed", () => {
  const [world, other] = [hooke.world(model), hooke.world(model)];
  const refuses = (task, code, spring) => assert.throws(task, (error) => {
    assert.ok(error instanceof HookeError, String(error));
    assert.deepEqual([error.code, error.spring], [code, spring]);
    return true;
  });
  const wrong = columns.stiffness.map((stiffness, spring) => spring === 5 || spring === 9 ? -stiffness : stiffness);
  refuses(() => world.setSprings({ ...columns, stiffness: wrong }), "stiffness", 5);
  refuses(() => world.setSprings({ restLength: columns.restLength.map(() => NaN) }), "rest-length", 0);
  refuses(() => world.setSprings({ damping: [1, 2] }), "length", undefined);
  refuses(() => world.scaleSprings({ damping: -1 }), "damping", 0);
  world.scaleSprings({ stiffness: 1, damping: 1 });
  assert.equal(reached(world), reached(other));
  world.free();
  refuses(() => world.scaleSprings({ stiffness: 2 }), "not-a-world", undefined);
});

test("all springs are changed in about the time of one", () => {
  const large = hooke.world(cloth(64));
  const seconds = (task) => {
    const start = performance.now();
    task();
    return (performance.now() - start) / 1e3;
  };
  const fastest = (task) => Math.min(...Array.from({ length: 9 }, () => seconds(task)));
  const one = fastest(() => large.setSpring(1, { stiffness: 50 }));
  const all = fastest(() => large.scaleSprings({ stiffness: 2, damping: 2 }));
  // One by one it would be 23,938 times as long; what is copied on the way in is a few times the work of the change.
  assert.ok(large.springs === 23938 && all < 200 * one, `${all} s for all, ${one} s for one`);
});
