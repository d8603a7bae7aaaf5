// The cloth of the benchmarks, as a scene's generator makes it: held at two corners, springs to neighbours of three kinds.

/** Of n x n particles, with a side of 1 m. */
export function cloth(n, { stiffness = 100, damping = 0.05 } = {}) {
  const spacing = 1 / (n - 1);
  const position = new Float64Array(3 * n * n);
  const hold = new Int32Array(n * n).fill(-1);
  for (let v = 0; v < n; v++) {
    for (let u = 0; u < n; u++) position.set([u * spacing, v * spacing, 2], 3 * (v * n + u));
  }
  hold[0] = -2;
  hold[n - 1] = -2;
  const between = [];
  const restLength = [];
  // Structural, shear, bend.
  for (const [du, dv] of [[1, 0], [0, 1], [1, 1], [-1, 1], [2, 0], [0, 2]]) {
    for (let v = 0; v + dv < n; v++) {
      for (let u = Math.max(0, -du); u + Math.max(0, du) < n; u++) {
        between.push(v * n + u, (v + dv) * n + u + du);
        restLength.push(spacing * Math.sqrt(du * du + dv * dv));
      }
    }
  }
  const springs = restLength.length;
  return {
    gravity: [0, 0, -9.81],
    particles: { position, hold, mass: new Float64Array(n * n).fill(0.01), velocity: new Float64Array(3 * n * n) },
    springs: {
      between: Uint32Array.from(between),
      stiffness: new Float64Array(springs).fill(stiffness),
      damping: new Float64Array(springs).fill(damping),
      restLength: Float64Array.from(restLength),
    },
  };
}
