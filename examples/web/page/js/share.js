// A link that carries a scene and everything chosen: JSON, deflated, in the letters that a link may have.

async function through(stream, bytes) {
  const blob = new Blob([bytes]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(blob).arrayBuffer());
}

/** @returns {Promise<string>} what comes behind the # of a link */
export async function pack(choices) {
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(JSON.stringify(choices)));
  let letters = "";
  for (let i = 0; i < bytes.length; i += 8192) letters += String.fromCharCode(...bytes.subarray(i, i + 8192));
  return `s=${btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

/**
 * @returns {Promise<object | undefined>} what was packed; nothing where there is nothing
 * @throws where the link is damaged
 */
export async function unpack(fragment) {
  const packed = /^#?s=(.+)$/.exec(fragment)?.[1];
  if (!packed) return undefined;
  try {
    const letters = atob(packed.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
    return JSON.parse(new TextDecoder().decode(await through(new DecompressionStream("deflate-raw"), bytes)));
  } catch (error) {
    throw new Error("the link is damaged: copy it again, whole", { cause: error });
  }
}
