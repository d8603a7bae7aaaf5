// How large a scene is, which way is up in it, and where its floor is.

import { across, direction, dot, length, scale, subtract } from "./matrices.js";

/** Planes that another one is cut by, as many as the program for them takes. */
const MOST_OTHERS = 8;

const place = (array, i) => [array[3 * i], array[3 * i + 1], array[3 * i + 2]];

/** The middle and the radius of what is to be seen, m; up; how thick particles and springs are. */
export function extentOf(scene) {
  const up = direction(scale(scene.gravity, -1), [0, 0, 1]);
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  const see = (p) => p.forEach((x, axis) => {
    least[axis] = Math.min(least[axis], x);
    most[axis] = Math.max(most[axis], x);
  });
  for (let i = 0; i < scene.particles; i++) see(place(scene.position, i));
  for (const track of scene.tracks) for (const key of track) see(key.place);
  if (scene.particles === 0) see([0, 0, 0]);
  // What hangs will swing below what holds it; what falls will reach the planes below it.
  const held = [...scene.hold.keys()].filter((i) => scene.hold[i] !== -1);
  if (held.length > 0 && scene.springs > 0 && length(scene.gravity) > 0) {
    let reach = 0;
    const from = held.slice(0, 64).map((i) => place(scene.position, i));
    for (let i = 0; i < scene.particles; i++) {
      const p = place(scene.position, i);
      reach = Math.max(reach, Math.min(...from.map((f) => length(subtract(f, p)))));
    }
    from.forEach((f) => see(subtract(f, scale(up, 1.2 * reach))));
  }
  for (const plane of scene.planes) {
    const middle = least.map((x, axis) => (x + most[axis]) / 2);
    const above = dot(subtract(middle, plane.point), plane.normal);
    const towards = dot(plane.normal, up);
    if (above > 0 && towards > 0.2 && length(scene.gravity) > 0) see(subtract(middle, scale(up, above / towards)));
  }
  const middle = least.map((x, axis) => (x + most[axis]) / 2);
  const radius = Math.max(length(subtract(most, least)) / 2, 1e-9) || 1;
  return { up, middle, radius: scene.particles < 2 && radius < 1e-6 ? 1 : radius, least, most, ...thickness(scene, radius) };
}

function thickness(scene, radius) {
  if (scene.springs === 0) return { ball: Math.min(radius * 0.05, (radius * 0.35) / Math.cbrt(scene.particles + 1)), rod: 0 };
  const lengths = Float64Array.from(scene.restLength).sort();
  const typical = lengths[lengths.length >> 1] || radius * 0.1;
  // A few springs are drawn thick enough to be seen from where the whole scene is.
  const [leastBall, leastRod] = scene.springs < 300 ? [0.012, 0.0055] : [0.004, 0.0012];
  const ball = Math.min((scene.springs < 40 ? 0.09 : 0.16) * typical, 0.06 * radius);
  return { ball: Math.max(ball, leastBall * radius), rod: Math.max(Math.min(0.06 * typical, 0.012 * radius), leastRod * radius) };
}

/** The planes as they are drawn: those that all but coincide once, and a floor to cast shadows on where there is none. */
export function floorsOf(scene, { up, middle, radius, least, most, ball }) {
  const drawn = [];
  for (const { point, normal } of scene.planes) {
    const near = drawn.some((other) => dot(other.normal, normal) > 0.9999 && Math.abs(dot(subtract(point, other.point), normal)) < 0.01 * radius);
    // A particle has no size, the ball that shows it has: what it lies on is drawn so much lower.
    if (!near) drawn.push({ point: subtract(point, scale(normal, ball)), normal, isReal: true });
  }
  if (drawn.length === 0 && length(scene.gravity) > 0) {
    const corners = [0, 1, 2].map((axis) => (up[axis] > 0 ? least[axis] : most[axis]));
    const low = dot(corners, up) - 0.12 * radius;
    drawn.push({ point: scale(up, low), normal: up, isReal: false });
  }
  const spacing = niceBelow(radius / 2.5);
  return drawn.map(({ point, normal, isReal }, index) => {
    const others = drawn.filter((_, other) => other !== index).slice(0, MOST_OTHERS);
    const centre = subtract(middle, scale(normal, dot(subtract(middle, point), normal)));
    const along = across(normal);
    const side = direction([
      normal[1] * along[2] - normal[2] * along[1],
      normal[2] * along[0] - normal[0] * along[2],
      normal[0] * along[1] - normal[1] * along[0],
    ]);
    const size = (drawn.length > 1 ? 3.5 : 6) * radius;
    return {
      middle: centre, normal, along: scale(along, size), side: scale(side, size), spacing, isReal,
      others: { fours: new Float32Array(4 * MOST_OTHERS).fill(0).map((_, i) => fourth(others[i >> 2], i & 3, radius)) },
      othersCount: { int: others.length },
      origin: [dot(centre, along) % (2 * spacing), dot(centre, side) % (2 * spacing)],
    };
  });
}

/** Direction and offset of a plane, one number at a time. */
function fourth(plane, place, radius) {
  if (!plane) return 0;
  return place < 3 ? plane.normal[place] : dot(plane.point, plane.normal) - 1e-4 * radius;
}

function niceBelow(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [5, 2, 1].map((n) => n * power).find((n) => n <= value) ?? power;
}

