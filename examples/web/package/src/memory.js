// The memory of a module above what its compiler has laid out: blocks for worlds and their workspaces, first fit.

import { HookeError } from "./error.js";

const PAGE = 65536;
/** Of the cache, bytes: what blocks start on, and the least that one has. */
export const LINE = 64;
const roundUp = (bytes, multiple) => Math.ceil(bytes / multiple) * multiple;

export class Memory {
  #memory;
  /** What is free: starts and ends, ascending, apart. */
  #free;
  #taken = new Map();

  constructor(memory, start) {
    this.#memory = memory;
    const first = roundUp(start, LINE);
    this.#free = first < memory.buffer.byteLength ? [[first, memory.buffer.byteLength]] : [];
  }

  get buffer() {
    return this.#memory.buffer;
  }

  /** The address of so many bytes, on a line of the cache. */
  take(bytes) {
    const size = Math.max(LINE, roundUp(bytes, LINE));
    let place = this.#free.findIndex(([start, end]) => end - start >= size);
    if (place < 0) place = this.#grow(size);
    const range = this.#free[place];
    const address = range[0];
    range[0] += size;
    if (range[0] === range[1]) this.#free.splice(place, 1);
    this.#taken.set(address, size);
    return address;
  }

  give(address) {
    const size = this.#taken.get(address);
    if (size === undefined) return;
    this.#taken.delete(address);
    const after = this.#free.findIndex(([start]) => start > address);
    const place = after < 0 ? this.#free.length : after;
    this.#free.splice(place, 0, [address, address + size]);
    this.#join(place);
    this.#join(place - 1);
  }

  #join(place) {
    const [left, right] = [this.#free[place], this.#free[place + 1]];
    if (left && right && left[1] === right[0]) {
      left[1] = right[1];
      this.#free.splice(place + 1, 1);
    }
  }

  #grow(size) {
    const end = this.#memory.buffer.byteLength;
    const last = this.#free.at(-1);
    const reaches = last !== undefined && last[1] === end;
    const missing = size - (reaches ? last[1] - last[0] : 0);
    try {
      this.#memory.grow(Math.ceil(missing / PAGE));
    } catch {
      throw new HookeError("memory", `there is no memory for another ${missing} bytes`);
    }
    const newEnd = this.#memory.buffer.byteLength;
    if (reaches) last[1] = newEnd;
    else this.#free.push([roundUp(end, LINE), newEnd]);
    return this.#free.length - 1;
  }
}
