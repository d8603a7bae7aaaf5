// Everything that can be chosen, and what a scene makes of what is not.

const PART_OF_BOUND = 0.25, LONGEST = 0.01;

export const NOTHING_CHOSEN = Object.freeze({
  scene: "hanging-cloth.toml", text: null, meshes: {},
  a: null, b: null, timeStep: null, stiffness: 1, damping: 1, restitution: null, gravity: 1, collision: null, speed: 1,
});

/** What a link carries: only what differs from what a scene says. */
export function toShare(chosen) {
  return Object.fromEntries(
    Object.entries(chosen).filter(([key, value]) => JSON.stringify(value) !== JSON.stringify(NOTHING_CHOSEN[key]) || key === "scene"),
  );
}

/** What came with a link, as far as it is known here and of the right kind. */
export function fromShare(shared) {
  const kinds = {
    scene: "string", text: "string", meshes: "object", a: "string", b: "string", timeStep: "number", stiffness: "number",
    damping: "number", restitution: "number", gravity: "number", collision: "string", speed: "number",
  };
  const known = Object.entries(shared ?? {}).filter(([key, value]) => {
    if (typeof value !== kinds[key] || value === null) return false;
    return typeof value !== "number" || Number.isFinite(value);
  });
  return { ...NOTHING_CHOSEN, ...Object.fromEntries(known) };
}

/** What worlds take, where the scene says what is left open; `limit` is Verlet's largest stable step, s. */
export function settle(chosen, scene) {
  const down = scene.gravity.some((g) => g !== 0) ? scene.gravity : [0, 0, -9.81];
  const weightless = scene.gravity.every((g) => g === 0);
  const strength = weightless ? chosen.gravity - 1 : chosen.gravity;
  return {
    gravity: down.map((g) => g * strength),
    stiffness: chosen.stiffness, damping: chosen.damping, restitution: chosen.restitution,
    timeStep: chosen.timeStep ?? (scene.timeStep === "auto" ? undefined : scene.timeStep),
    tolerance: scene.tolerance, collision: chosen.collision ?? scene.collision,
  };
}

/**
 * The time step (s) of a scene that leaves it open: a quarter of Verlet's largest stable one, in two digits. All sides take it,
 * whatever their steppers, so that they can be compared; `hooke run` goes by the scene's own stepper, and where a scene leaves
 * that open too it looks for both in short runs.
 */
export function chooseTimeStep(limit, duration) {
  const longest = Math.min(LONGEST, duration);
  const part = PART_OF_BOUND * limit;
  if (!(part < longest)) return longest;
  const exponent = Math.floor(Math.log10(part)) - 1;
  return Number(`${Math.max(10, Math.floor(part / 10 ** exponent))}e${exponent}`);
}
