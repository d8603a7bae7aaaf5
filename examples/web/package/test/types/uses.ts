// What the types allow and refuse: checked by `npm run types`, never run.
import { Hooke, HookeError, load, type Energy, type Model, type Report } from "hooke";

const hooke: Hooke = await load({ simd: true, url: new URL("https://example.org/hooke.wasm") });
const model: Model = {
  gravity: [0, 0, -9.81],
  particles: { position: new Float64Array(6), hold: new Int32Array(2) },
  springs: [{ between: [0, 1], stiffness: 40 }],
};
const world = hooke.world(model);
hooke.world({ particles: [{ position: [0, 0, 0] }], springs: { between: new Uint32Array(0), stiffness: [], restLength: [] } });
hooke.world({ particles: 4, springs: 2 }).addPlane({ point: [0, 0, 0], normal: [0, 0, 1] });
world.stepper = "tr-bdf2";
world.collision = "project";
const report: Report = world.advance(1 / 60, 8);
const positions: Float32Array = world.positions;
const energy: Energy = world.energy();
const bytes: Uint8Array = world.snapshot();
world.restore(bytes);
world.setSprings({ stiffness: new Float32Array(1), damping: [0.1] });
world.scaleSprings({ stiffness: 2 });
world.setRestitution("all", report.hits + positions.length + energy.remainder);
try {
  world.step();
} catch (error) {
  if (error instanceof HookeError) console.log(error.code, error.particle);
}

// @ts-expect-error there is no such stepper
world.stepper = "leapfrog";
// @ts-expect-error worlds are made by a loaded module
new Hooke();
// @ts-expect-error a vector has three components
world.setGravity([0, 1]);
// @ts-expect-error it is told, not set
world.time = 1;
// @ts-expect-error springs have a stiffness
hooke.world({ particles: [], springs: [{ between: [0, 1] }] });
