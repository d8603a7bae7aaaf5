// In a Worker, and a snapshot back out of it.

import assert from "node:assert/strict";
import { test } from "node:test";
import { Worker } from "node:worker_threads";
import { cloth } from "../bench/model.js";
import { load } from "../src/index.js";

test("a Worker steps to the same bits, and hands its state over as bytes", async () => {
  const model = cloth(8);
  const source = `
    import { parentPort, workerData } from "node:worker_threads";
    const { load } = await import(workerData.module);
    const world = (await load()).world(workerData.model);
    world.step(50);
    parentPort.postMessage({ digest: world.digest(), bytes: world.snapshot() });`;
  const worker = new Worker(new URL(`data:text/javascript,${encodeURIComponent(source)}`), {
    workerData: { model, module: new URL("../src/index.js", import.meta.url).href },
  });
  const told = await new Promise((resolve, reject) => worker.once("message", resolve).once("error", reject));
  await worker.terminate();
  const world = (await load()).world(model);
  assert.notEqual(world.digest(), told.digest);
  world.restore(told.bytes);
  assert.equal(world.digest(), told.digest);
  const other = (await load()).world(model);
  other.step(50);
  assert.equal(other.digest(), told.digest);
});
