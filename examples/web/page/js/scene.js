// Scenes, as the desktop reads them: its own reader, built for the web, fetched when the first scene is read.

/** Why a text is no scene: the whole message as the desktop prints it, and its parts. */
export class SceneRefused extends Error {
  constructor({ message, remedy, printed, bytes }, text) {
    super(message);
    this.name = "SceneRefused";
    Object.assign(this, { remedy, printed });
    if (bytes) {
      const encoded = new TextEncoder().encode(text);
      const characters = (end) => new TextDecoder().decode(encoded.subarray(0, end)).length;
      this.range = [characters(bytes[0]), characters(bytes[0] + bytes[1])];
    }
  }
}

let reader;

/** @returns {Promise<WebAssembly.Exports>} */
function load() {
  reader ??= (async () => {
    const response = await fetch(new URL("../wasm/scene.wasm", import.meta.url));
    if (!response.ok) throw new Error(`the reader of scenes cannot be fetched: ${response.status} ${response.statusText}`);
    const { instance } = await WebAssembly.instantiate(await response.arrayBuffer(), {});
    return instance.exports;
  })();
  reader.catch(() => (reader = undefined));
  return reader;
}

/**
 * @param {string} name of the file: its ending says the format
 * @param {string} text
 * @param {Record<string, string>} meshes texts of mesh files, by the names that the scene has for them
 * @throws {SceneRefused}
 */
export async function readScene(name, text, meshes = {}) {
  const wasm = await load();
  const request = new TextEncoder().encode(JSON.stringify({ name, text, meshes }));
  const room = wasm.room(request.length);
  new Uint8Array(wasm.memory.buffer, room, request.length).set(request);
  const isScene = wasm.read() === 1;
  const start = wasm.answer();
  const answer = wasm.memory.buffer.slice(start, start + wasm.answer_length());
  if (isScene) return unfold(answer);
  throw new SceneRefused(JSON.parse(new TextDecoder().decode(answer)), text);
}

/** The header, and views over the arrays behind it. */
function unfold(buffer) {
  const length = new DataView(buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  let offset = 4 + length;
  const take = (Kind, count) => {
    const view = new Kind(buffer, offset, count);
    offset += view.byteLength;
    return view;
  };
  const { particles, springs } = header;
  const scene = {
    ...header,
    position: take(Float64Array, 3 * particles),
    velocity: take(Float64Array, 3 * particles),
    mass: take(Float64Array, particles),
    stiffness: take(Float64Array, springs),
    damping: take(Float64Array, springs),
    restLength: take(Float64Array, springs),
  };
  const seven = take(Float64Array, 7 * header.planes);
  scene.planes = Array.from({ length: header.planes }, (_, i) => ({
    point: [...seven.subarray(7 * i, 7 * i + 3)],
    normal: [...seven.subarray(7 * i + 3, 7 * i + 6)],
    restitution: seven[7 * i + 6],
  }));
  scene.tracks = header.tracks.map((keys) =>
    Array.from({ length: keys }, () => {
      const [time, x, y, z] = take(Float64Array, 4);
      return { time, place: [x, y, z] };
    }),
  );
  scene.between = take(Uint32Array, 2 * springs);
  scene.hold = take(Int32Array, particles);
  return scene;
}
