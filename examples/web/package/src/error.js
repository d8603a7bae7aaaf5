// What can be wrong, by name.

const NAMES = [
  "ok", "null-pointer", "misaligned", "too-small", "not-a-world", "no-such-option", "full", "no-such-particle",
  "no-such-spring", "no-such-plane", "same-particle", "mass", "not-finite", "stiffness", "damping", "rest-length",
  "normal", "restitution", "time-step", "tolerance", "damped", "workspace", "non-finite", "length", "snapshot", "busy",
];

export const WORKSPACE = NAMES.indexOf("workspace");

// Those whose number is not a particle's.
const ABOUT = { "no-such-spring": "spring", stiffness: "spring", damping: "spring", "rest-length": "spring",
  "same-particle": "spring", "no-such-plane": "plane", normal: "plane", restitution: "plane" };

export class HookeError extends Error {
  /**
   * @param {string} code
   * @param {string} message
   * @param {{ particle?: number, spring?: number, plane?: number }} [about]
   */
  constructor(code, message, about = {}) {
    super(message);
    this.name = "HookeError";
    this.code = code;
    this.particle = about.particle;
    this.spring = about.spring;
    this.plane = about.plane;
  }
}

// The error of a code that a call came to, about what `number` tells, where it tells anything.
export function wrong(code, words, number, of) {
  const name = NAMES[code] ?? "unknown";
  if (number === 0xffffffff) return new HookeError(name, words);
  const what = of ?? ABOUT[name] ?? "particle";
  return new HookeError(name, `${what} ${number}: ${words}`, { [what]: number });
}
