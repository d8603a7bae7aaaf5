// Hooke: particles joined by springs, stepped in WebAssembly.

import { exportsOf, hasSimd } from "./load.js";
import { Memory } from "./memory.js";
import { World } from "./world.js";

export { HookeError } from "./error.js";
export { World } from "./world.js";

/** A module that has been loaded: what makes worlds. */
export class Hooke {
  #exports;
  #memory;

  constructor(exports, simd) {
    this.#exports = exports;
    this.#memory = new Memory(exports.memory, exports.__heap_base.value);
    this.simd = simd;
  }

  world(model) {
    return new World(this.#exports, this.#memory, model);
  }
}

export async function load({ url, bytes, simd = hasSimd() } = {}) {
  return new Hooke(await exportsOf({ url, bytes, simd }), simd);
}
