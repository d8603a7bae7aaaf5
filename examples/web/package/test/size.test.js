// What a page has to fetch.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { gzipSync } from "node:zlib";

// KiB. Twelve steppers, three forms of collision, exact flight and a sparse factorisation; hot loops are compiled for speed. The
// aim is 40.
const MOST = 72;
// KiB. Compilers lay code out in their own ways: with two of them sizes differ by less.
const ABOUT = 2;

const readme = readFileSync(new URL("../README.md", import.meta.url), "utf8");
const [, plain, simd] = readme.match(/(\d+) KiB gzipped without vectors, (\d+) KiB with/);

for (const [name, said] of [["hooke.wasm", plain], ["hooke-simd.wasm", simd]]) {
  test(`${name} is at most ${MOST} KiB, gzipped, and about as large as README.md says`, (context) => {
    const bytes = readFileSync(new URL(`../src/${name}`, import.meta.url));
    const zipped = gzipSync(bytes, { level: 9 }).length / 1024;
    context.diagnostic(`${name}: ${(bytes.length / 1024).toFixed(1)} KiB, ${zipped.toFixed(1)} KiB gzipped`);
    assert.ok(zipped <= MOST, `${zipped} KiB`);
    assert.ok(Math.abs(zipped - said) <= ABOUT, `${zipped} KiB, README.md says ${said}`);
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
