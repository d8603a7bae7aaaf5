// Particles that follow prescribed positions, as the desktop drives them, operation by operation.

/** The keys around a time: the last at or before it, the first after it. */
function around(track, time) {
  let after = 0;
  while (after < track.length && track[after].time <= time) after++;
  return [track[after - 1], track[after]];
}

function position(track, time) {
  const [before, after] = around(track, time);
  if (!before || !after) return (before ?? after).place;
  const s = (time - before.time) / (after.time - before.time);
  return before.place.map((a, axis) => a + s * (after.place[axis] - a));
}

function velocity(track, time) {
  const [before, after] = around(track, time);
  if (!before || !after) return [0, 0, 0];
  return after.place.map((x, axis) => (x - before.place[axis]) / (after.time - before.time));
}

export class Tracks {
  constructor(scene) {
    this.followers = [];
    scene.hold.forEach((hold, particle) => {
      if (hold >= 0) this.followers.push({ particle, track: scene.tracks[hold] });
    });
  }

  get any() {
    return this.followers.length > 0;
  }

  /** The times after `from` and up to `to` at which a step has to end: those of keys in between, and `to`. */
  stops(from, to) {
    // A key that is only rounding away from an end of the step is that end.
    const margin = 1e-9 * (to - from);
    const keys = this.followers.flatMap(({ track }) => track.map((key) => key.time));
    const within = keys.filter((time) => time > from + margin && time < to - margin);
    return [...new Set(within)].sort((a, b) => a - b).concat(to);
  }

  /** Puts every follower where it is at `from`, moving to where it is at `to`; but for what a hand holds. */
  drive(world, from, to, held) {
    for (const { particle, track } of this.followers) {
      if (particle !== held) world.drive(particle, position(track, from), velocity(track, 0.5 * (from + to)));
    }
  }
}
