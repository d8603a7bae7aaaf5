// Models made flat: typed arrays, whatever they were given as.

import { HookeError } from "./error.js";

const ORIGIN = [0, 0, 0];
// As in the flat model of a scene: what is neither is the number of a track.
const FREE = -1;
const PINNED = -2;

/** Whether it says how many there may be, not what there is. */
export const isCapacity = (model) => typeof model.particles === "number";

const check = (isSound, words) => {
  if (!isSound) throw new HookeError("length", words);
};

export function flatParticles(given) {
  if (!Array.isArray(given)) return checkedParticles(given);
  const count = given.length;
  const flat = { position: new Float64Array(3 * count), velocity: new Float64Array(3 * count),
    mass: new Float64Array(count), hold: new Int32Array(count) };
  given.forEach(({ position, velocity = ORIGIN, mass = 1, pinned = false }, particle) => {
    check(position?.length === 3 && velocity.length === 3, `particle ${particle}: a vector has three components`);
    flat.position.set(position, 3 * particle);
    flat.velocity.set(velocity, 3 * particle);
    flat.mass[particle] = mass;
    flat.hold[particle] = pinned ? PINNED : FREE;
  });
  return flat;
}

function checkedParticles({ position, velocity, mass, hold }) {
  const count = position.length / 3;
  check(Number.isInteger(count), "particles.position is three numbers a particle");
  check(velocity === undefined || velocity.length === 3 * count, "particles.velocity is as long as particles.position");
  check(mass === undefined || mass.length === count, "particles.mass is one number a particle");
  check(hold === undefined || hold.length === count, "particles.hold is one number a particle");
  return {
    position,
    velocity: velocity ?? new Float64Array(3 * count),
    mass: mass ?? new Float64Array(count).fill(1),
    hold: hold ?? new Int32Array(count).fill(FREE),
  };
}

/** The number of a hold in the interface of the module. */
export const holdNumber = (hold) => (hold === FREE ? 0 : hold === PINNED ? 1 : 2);

export function flatSprings(given, position) {
  if (!Array.isArray(given)) return checkedSprings(given, position);
  const count = given.length;
  const flat = { between: new Uint32Array(2 * count), stiffness: new Float64Array(count),
    damping: new Float64Array(count), restLength: new Float64Array(count) };
  given.forEach(({ between, stiffness, damping = 0, restLength }, spring) => {
    check(between?.length === 2, `spring ${spring}: between names two particles`);
    flat.between.set(between, 2 * spring);
    flat.stiffness[spring] = stiffness;
    flat.damping[spring] = damping;
    flat.restLength[spring] = restLength ?? distance(position, between);
  });
  return flat;
}

function checkedSprings({ between, stiffness, damping, restLength }, position) {
  const count = between.length / 2;
  check(Number.isInteger(count), "springs.between is two numbers a spring");
  check(stiffness?.length === count, "springs.stiffness is one number a spring");
  check(damping === undefined || damping.length === count, "springs.damping is one number a spring");
  check(restLength === undefined || restLength.length === count, "springs.restLength is one number a spring");
  return {
    between,
    stiffness,
    damping: damping ?? new Float64Array(count),
    restLength: restLength
      ?? Float64Array.from({ length: count }, (_, spring) => distance(position, between.slice(2 * spring, 2 * spring + 2))),
  };
}

/** How far apart two particles are, m; 0 where one does not exist, which whoever adds the spring refuses. */
export function distance(position, [first, second]) {
  const [x, y, z] = [0, 1, 2].map((axis) => position[3 * second + axis] - position[3 * first + axis]);
  const length = Math.sqrt(x * x + y * y + z * z);
  return Number.isNaN(length) ? 0 : length;
}
