// Vite finds the modules without a plugin, and what it builds runs.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { build } from "vite";

test("a bundle that Vite makes steps in Node, from a server of static files", async () => {
  const folder = mkdtempSync(join(tmpdir(), "hooke-vite-"));
  const server = createServer((request, response) => {
    const type = { ".wasm": "application/wasm", ".js": "text/javascript" }[extname(request.url)] ?? "text/html";
    response.writeHead(200, { "content-type": type }).end(readFileSync(join(folder, "dist", request.url)));
  });
  try {
    const source = fileURLToPath(new URL("../src/index.js", import.meta.url));
    writeFileSync(join(folder, "main.js"), `export { load } from ${JSON.stringify(source)};`);
    await build({
      root: folder,
      logLevel: "error",
      base: "./",
      build: { target: "es2022", rollupOptions: { input: join(folder, "main.js"), preserveEntrySignatures: "strict" } },
    });
    const assets = readdirSync(join(folder, "dist/assets"));
    const modules = assets.filter((name) => name.endsWith(".wasm"));
    assert.equal(modules.length, 2, assets.join(", "));
    const bundle = assets.find((name) => name.endsWith(".js"));
    await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
    const origin = `http://127.0.0.1:${server.address().port}`;
    const { load } = await import(join(folder, "dist/assets", bundle));
    for (const name of modules) {
      const hooke = await load({ url: `${origin}/assets/${name}` });
      const world = hooke.world({ gravity: [0, 0, -8], particles: [{ position: [0, 0, 0] }] });
      world.timeStep = 0.5;
      world.step();
      assert.equal(world.positions[2], -1);
    }
    // Where the bundle looks by itself.
    assert.equal(typeof (await load()).simd, "boolean");
  } finally {
    server.close();
    rmSync(folder, { recursive: true });
  }
});
