// The desktop's answer: a scene is written down, run by the desktop's program, and its digest read.

import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../../../../", import.meta.url));
const program = process.env.HOOKE ?? join(root, "target/release/hooke");

const vector = (values) => `[${Array.from(values, number).join(", ")}]`;
// A number that TOML takes for a float, whatever it is; JavaScript's shortest text reads back to the same bits.
const number = (value) => (Number.isInteger(value) ? `${value}.0` : String(value));

/** A scene file of a flat model. */
export function sceneOf({ gravity, particles, springs, planes = [] }, settings) {
  const lines = Object.entries(settings).map(([key, value]) => `${key} = ${typeof value === "string" ? JSON.stringify(value) : number(value)}`);
  lines.push(`gravity = ${vector(gravity)}`);
  for (let i = 0; i < particles.mass.length; i++) {
    lines.push("[[particle]]", `position = ${vector(particles.position.slice(3 * i, 3 * i + 3))}`, `mass = ${number(particles.mass[i])}`);
    if (particles.hold[i] === -2) lines.push("pinned = true");
    else lines.push(`velocity = ${vector(particles.velocity.slice(3 * i, 3 * i + 3))}`);
  }
  for (let s = 0; s < springs.stiffness.length; s++) {
    lines.push("[[spring]]", `between = [${springs.between[2 * s]}, ${springs.between[2 * s + 1]}]`, `stiffness = ${number(springs.stiffness[s])}`,
      `damping = ${number(springs.damping[s])}`, `rest_length = ${number(springs.restLength[s])}`);
  }
  for (const { point, normal, restitution } of planes) {
    lines.push("[[plane]]", `point = ${vector(point)}`, `normal = ${vector(normal)}`, `restitution = ${number(restitution)}`);
  }
  return lines.join("\n");
}

/** The digest of the last state of a run on the desktop. */
export function desktopDigest(model, { stepper, collision, timeStep, steps, tolerance }) {
  const directory = mkdtempSync(join(tmpdir(), "hooke-"));
  try {
    const scene = join(directory, "scene.toml");
    writeFileSync(scene, sceneOf(model, { stepper, collision, tolerance, precision: "f32", time_step: timeStep, duration: steps * timeStep }));
    const told = execFileSync(program, ["run", scene, "--digest"], { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
    return told.trim().split(/\s+/).at(-1);
  } finally {
    rmSync(directory, { recursive: true });
  }
}
