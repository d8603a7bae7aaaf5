// Loading the module, in a page, a Worker or Node.

/** A module with one instruction on 128-bit vectors: what does not know those does not validate it. */
const SIMD = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0,
  253, 15, 253, 98, 11]);

export const hasSimd = () => WebAssembly.validate(SIMD);

/** The exports of the module, from its bytes, from where they are, or from beside this file. */
export async function exportsOf({ url, bytes, simd }) {
  if (bytes !== undefined) return (await WebAssembly.instantiate(bytes)).instance.exports;
  // Spelled out, as bundlers look for it.
  const beside = simd ? new URL("./hooke-simd.wasm", import.meta.url) : new URL("./hooke.wasm", import.meta.url);
  const place = url === undefined ? beside : new URL(url, globalThis.location?.href ?? import.meta.url);
  if (place.protocol === "file:") {
    // A name that bundlers for pages do not follow.
    const files = "node:fs/promises";
    const { readFile } = await import(/* @vite-ignore */ files);
    return (await WebAssembly.instantiate(await readFile(place))).instance.exports;
  }
  const response = await fetch(place);
  if (!response.ok) throw new Error(`${place} cannot be loaded: ${response.status} ${response.statusText}`);
  const isTyped = response.headers.get("content-type")?.startsWith("application/wasm");
  const source = isTyped
    ? await WebAssembly.instantiateStreaming(response)
    : await WebAssembly.instantiate(await response.arrayBuffer());
  return source.instance.exports;
}
