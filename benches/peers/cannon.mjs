// cannon-es: a body without rotation for each particle, its `Spring` for each spring; f64.
// A worker as `worker.py` is: `node cannon.mjs SCENE`.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { createInterface } from "node:readline";

const require = createRequire(new URL("./target/node/", import.meta.url));
const { Body, Broadphase, ContactMaterial, Material, Particle, Plane, Quaternion, Spring, Vec3, World } =
  require("cannon-es");
const scene = JSON.parse(readFileSync(process.argv[2], "utf8"));
const vector = (flat, index) => new Vec3(...flat.slice(3 * index, 3 * index + 3));

// Particles meet planes and nothing else; those that come with cannon-es test every particle with every other.
class PlanesOnly extends Broadphase {
  collisionPairs(world, first, second) {
    const planes = world.bodies.slice(0, scene.planes.length);
    for (const body of world.bodies.slice(scene.planes.length)) {
      for (const plane of planes) {
        this.intersectionTest(plane, body, first, second);
      }
    }
  }
}

function build() {
  const world = new World({ gravity: new Vec3(...scene.gravity), broadphase: new PlanesOnly() });
  const material = new Material();
  for (const plane of scene.planes) {
    world.addContactMaterial(
      new ContactMaterial(material, material, { friction: 0, restitution: plane.restitution }),
    );
    const turned = new Quaternion();
    turned.setFromVectors(new Vec3(0, 0, 1), new Vec3(...plane.normal));
    const position = new Vec3(...plane.point);
    world.addBody(new Body({ mass: 0, shape: new Plane(), material, position, quaternion: turned }));
  }
  const pinned = new Set(scene.pinned);
  const bodies = scene.mass.map((mass, index) => {
    const body = new Body({
      mass: pinned.has(index) ? 0 : mass,
      position: vector(scene.position, index),
      velocity: vector(scene.velocity, index),
      linearDamping: 0,
      fixedRotation: true,
      material,
    });
    if (scene.planes.length > 0) body.addShape(new Particle());
    world.addBody(body);
    return body;
  });
  const springs = scene.stiffness.map((stiffness, index) => {
    const [i, j] = [scene.between[2 * index], scene.between[2 * index + 1]];
    const [restLength, damping] = [scene.rest_length[index], scene.damping[index]];
    return new Spring(bodies[i], bodies[j], { restLength, stiffness, damping });
  });
  // After gravity, before the velocities are updated: so it is the scheme of the textbook.
  world.addEventListener("preStep", () => springs.forEach((spring) => spring.applyForce()));
  return { world, bodies };
}

function run({ setting, duration, state }) {
  const { world, bodies } = build();
  const steps = Math.round(duration / setting);
  const start = process.cpuUsage();
  for (let step = 0; step < steps; step += 1) world.step(setting);
  const { user, system } = process.cpuUsage(start);
  const position = state ? bodies.flatMap((body) => body.position.toArray()) : [];
  return { cpu: (user + system) * 1e-6, position };
}

process.on("uncaughtException", (error) => {
  console.error(String(error));
  process.exit(1);
});
const answer = (values) => process.stdout.write(`${JSON.stringify(values)}\n`);
// Long enough for the compiler to have seen what it needs.
const steps = Math.max(2, Math.min(200, Math.round(2e5 / scene.mass.length)));
run({ setting: 1e-4, duration: steps * 1e-4 });
answer({ ready: true });
for await (const line of createInterface({ input: process.stdin })) {
  try {
    answer(run(JSON.parse(line)));
  } catch (error) {
    answer({ error: String(error) });
  }
}
