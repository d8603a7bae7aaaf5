// The colours of what is drawn, the desktop's own in the light.

const colour = (...bytes) => bytes.map((byte) => byte / 255);

const BALLS = [[240, 158, 30], [38, 160, 164], [146, 98, 200], [226, 96, 112], [66, 128, 220], [120, 174, 64]].map(
  (ball) => colour(...ball),
);

export const LOOKS = {
  light: {
    squeezed: colour(22, 84, 224), resting: colour(146, 154, 170), stretched: colour(222, 38, 30),
    joint: colour(88, 98, 118), pinned: colour(30, 36, 48), track: colour(20, 140, 110), mark: colour(255, 170, 0),
    balls: BALLS,
    even: colour(240, 242, 247), odd: colour(222, 226, 235), shade: colour(120, 128, 152),
    sky: [0.62, 0.63, 0.66], ground: [0.36, 0.35, 0.36],
  },
  dark: {
    squeezed: colour(58, 134, 255), resting: colour(124, 134, 158), stretched: colour(255, 76, 54),
    joint: colour(150, 160, 184), pinned: colour(238, 240, 248), track: colour(60, 214, 170), mark: colour(255, 196, 40),
    balls: BALLS,
    even: colour(30, 35, 48), odd: colour(39, 46, 62), shade: colour(8, 10, 15),
    sky: [0.50, 0.52, 0.58], ground: [0.22, 0.22, 0.27],
  },
};

/** For each particle red, green, blue and how large it is beside a joint. */
export function particleLooks(looks, scene) {
  const pulled = new Uint8Array(scene.particles);
  for (const end of scene.between) pulled[end] = 1;
  const out = new Float32Array(scene.particles * 4);
  for (let i = 0; i < scene.particles; i++) {
    const hold = scene.hold[i];
    const [own, size] =
      hold === -2 ? [looks.pinned, 1.6]
      : hold >= 0 ? [looks.track, 1.7]
      : pulled[i] ? [looks.joint, 1]
      : [looks.balls[i % looks.balls.length], 1];
    out.set([...own, size], i * 4);
  }
  return out;
}
