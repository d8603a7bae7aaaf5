// What a page has to fetch.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { gzipSync } from "node:zlib";

// KiB. Twelve steppers, three forms of collision and a sparse factorisation, with loops for springs on diagonals and off
// them, damped and not. The aim is 40; where the bytes are is told in README.md.
const MOST = 150;

for (const name of ["hooke.wasm", "hooke-simd.wasm"]) {
  test(`${name} is at most ${MOST} KiB, gzipped`, (context) => {
    const bytes = readFileSync(new URL(`../src/${name}`, import.meta.url));
    const zipped = gzipSync(bytes, { level: 9 }).length;
    context.diagnostic(`${name}: ${(bytes.length / 1024).toFixed(1)} KiB, ${(zipped / 1024).toFixed(1)} KiB gzipped`);
    assert.ok(zipped <= MOST * 1024, `${zipped} bytes`);
  });
}

test("the modules export the interface, and nothing of their inside", async () => {
  for (const name of ["hooke.wasm", "hooke-simd.wasm"]) {
    const module = await WebAssembly.compile(readFileSync(new URL(`../src/${name}`, import.meta.url)));
    assert.deepEqual(WebAssembly.Module.imports(module), []);
    const other = WebAssembly.Module.exports(module).filter((item) => !item.name.startsWith("hooke_"));
    assert.deepEqual(other.map((item) => item.name).sort(), ["__data_end", "__heap_base", "memory"]);
  }
});
