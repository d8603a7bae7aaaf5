// The textbook's semi-implicit Euler in JavaScript: one pass over the springs that scatters, one over the particles.
// In two layouts: a record of six numbers a particle, or an array a quantity; each in either precision.

/** Springs as arrays of `Reals`; particles as `state`, of which `place` tells where a coordinate of one is. */
export function textbook(model, Reals, interleaved) {
  return (interleaved ? records : columns)(model, Reals);
}

function springsOf({ springs }, Reals) {
  const of = (values) => Reals.from(values);
  return { between: Uint32Array.from(springs.between), k: of(springs.stiffness), c: of(springs.damping), rest: of(springs.restLength) };
}

function records({ particles, springs, gravity: [gx, gy, gz] }, Reals) {
  const count = particles.mass.length;
  const { between, k, c, rest } = springsOf({ springs }, Reals);
  const state = new Reals(6 * count);
  const force = new Reals(3 * count);
  const inverse = Reals.from(particles.mass, (mass, i) => (particles.hold[i] === -2 ? 0 : 1 / mass));
  for (let i = 0; i < count; i++) {
    for (let axis = 0; axis < 3; axis++) {
      state[6 * i + axis] = particles.position[3 * i + axis];
      state[6 * i + 3 + axis] = particles.velocity[3 * i + axis];
    }
  }
  const step = (dt) => {
    force.fill(0);
    for (let s = 0; s < k.length; s++) {
      const i = 6 * between[2 * s];
      const j = 6 * between[2 * s + 1];
      const x = state[j] - state[i];
      const y = state[j + 1] - state[i + 1];
      const z = state[j + 2] - state[i + 2];
      const l = Math.sqrt(x * x + y * y + z * z);
      const rate = ((state[j + 3] - state[i + 3]) * x + (state[j + 4] - state[i + 4]) * y + (state[j + 5] - state[i + 5]) * z) / l;
      const q = l === 0 ? 0 : (k[s] * (l - rest[s]) + c[s] * rate) / l;
      const f = i / 2;
      const g = j / 2;
      force[f] += q * x;
      force[f + 1] += q * y;
      force[f + 2] += q * z;
      force[g] -= q * x;
      force[g + 1] -= q * y;
      force[g + 2] -= q * z;
    }
    for (let i = 0, p = 0, f = 0; i < count; i++, p += 6, f += 3) {
      const w = inverse[i];
      if (w === 0) continue;
      state[p + 3] += dt * (gx + w * force[f]);
      state[p + 4] += dt * (gy + w * force[f + 1]);
      state[p + 5] += dt * (gz + w * force[f + 2]);
      state[p] += dt * state[p + 3];
      state[p + 1] += dt * state[p + 4];
      state[p + 2] += dt * state[p + 5];
    }
  };
  return { step, position: (i) => [state[6 * i], state[6 * i + 1], state[6 * i + 2]] };
}

function columns({ particles, springs, gravity: [gx, gy, gz] }, Reals) {
  const count = particles.mass.length;
  const { between, k, c, rest } = springsOf({ springs }, Reals);
  const first = Uint32Array.from(k, (_, s) => between[2 * s]);
  const second = Uint32Array.from(k, (_, s) => between[2 * s + 1]);
  const along = (vectors) => [0, 1, 2].map((axis) => Reals.from({ length: count }, (_, i) => vectors[3 * i + axis]));
  const [px, py, pz] = along(particles.position);
  const [vx, vy, vz] = along(particles.velocity);
  const [fx, fy, fz] = Array.from({ length: 3 }, () => new Reals(count));
  const inverse = Reals.from(particles.mass, (mass, i) => (particles.hold[i] === -2 ? 0 : 1 / mass));
  const step = (dt) => {
    fx.fill(0);
    fy.fill(0);
    fz.fill(0);
    for (let s = 0; s < k.length; s++) {
      const i = first[s];
      const j = second[s];
      const x = px[j] - px[i];
      const y = py[j] - py[i];
      const z = pz[j] - pz[i];
      const l = Math.sqrt(x * x + y * y + z * z);
      const rate = ((vx[j] - vx[i]) * x + (vy[j] - vy[i]) * y + (vz[j] - vz[i]) * z) / l;
      const q = l === 0 ? 0 : (k[s] * (l - rest[s]) + c[s] * rate) / l;
      fx[i] += q * x;
      fy[i] += q * y;
      fz[i] += q * z;
      fx[j] -= q * x;
      fy[j] -= q * y;
      fz[j] -= q * z;
    }
    for (let i = 0; i < count; i++) {
      const w = inverse[i];
      if (w === 0) continue;
      vx[i] += dt * (gx + w * fx[i]);
      vy[i] += dt * (gy + w * fy[i]);
      vz[i] += dt * (gz + w * fz[i]);
      px[i] += dt * vx[i];
      py[i] += dt * vy[i];
      pz[i] += dt * vz[i];
    }
  };
  return { step, position: (i) => [px[i], py[i], pz[i]] };
}
