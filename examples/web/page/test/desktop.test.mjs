import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { mkdtempSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { get } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { desktop, launch, open, pictures, scenes, serve, view } from "./support.mjs";

let server, browser;
before(async () => {
  server = await serve();
  browser = await launch();
});
after(async () => {
  await browser?.close();
  server?.close();
});

const STEPS = 64;
// Powers of two: as many steps make the duration to the bit.
const STEP = 2 ** -10;

const digestHere = (page, scene, stepper, steps) =>
  page.evaluate(async ([scene, a, timeStep, steps]) => {
    await hookePage.open({ ...hookePage.chosen, scene, text: null, a, b: null, timeStep });
    hookePage.play(false);
    hookePage.reset();
    hookePage.step(steps);
    const [side] = hookePage.sides.list;
    return { digest: side.digest(), exploded: side.stopped?.particle };
  }, [scene, stepper, STEP, steps]);

const digestThere = (scene, stepper, steps) => {
  const ran = desktop(scenes, "run", scene, "--digest", "--precision", "f32", "--stepper", stepper, "--time-step", String(STEP), "--duration", String(STEP * steps), "--no-ledger");
  const exploded = /particle (\d+) became infinite/.exec(ran.stderr)?.[1];
  assert.equal(ran.status, exploded === undefined ? 0 : 1, ran.stderr);
  return { digest: ran.stdout.trim(), exploded: exploded && Number(exploded) };
};

/** What a browser is answered that was led here by a name. */
const statusFor = (url, host) => new Promise((found, failed) => get(url, { headers: { host } }, ({ statusCode }) => found(statusCode)).on("error", failed));

test("the scenes on the list are those in the folder, by their names", async () => {
  const { page, close } = await open(browser, server.url);
  const list = await page.evaluate(async () => (await import(new URL("js/shipped.js", location.href))).SHIPPED);
  const files = readdirSync(scenes).filter((file) => file.endsWith(".toml"));
  assert.deepEqual(list.map(({ file }) => file).sort(), files.sort());
  for (const { file, meshes } of list) {
    const named = [...readFileSync(join(scenes, file), "utf8").matchAll(/^file = "(.+)"/gm)].map(([, name]) => name);
    assert.deepEqual(meshes, named, file);
  }
  await close();
});

test("after as many steps the digest is the desktop's, for every scene", async (t) => {
  const { page, complaints, close } = await open(browser, server.url);
  for (const scene of readdirSync(scenes).filter((file) => file.endsWith(".toml"))) {
    const here = await digestHere(page, scene, "velocity-verlet", STEPS);
    // The stiff rope explodes: at the same particle, after the same step.
    assert.deepEqual(here, digestThere(scene, "velocity-verlet", STEPS), scene);
    // The control: a step more or less is another state.
    const other = here.exploded === undefined ? STEPS + 1 : 5;
    assert.notEqual(here.digest, digestThere(scene, "velocity-verlet", other).digest, scene);
    t.diagnostic(`${scene} ${here.digest}${here.exploded === undefined ? "" : `, exploded at particle ${here.exploded}`}`);
  }
  assert.deepEqual(complaints, []);
  await close();
});

test("and for every stepper", async (t) => {
  const { page, close } = await open(browser, server.url);
  const names = await page.evaluate(async () => (await import(new URL("js/steppers.js", location.href))).STEPPERS.map(({ name }) => name));
  for (const stepper of names) {
    // The one that knows no damping has a scene without any.
    const scene = stepper === "dormand-prince-rkn8" ? "vertical-spring.toml" : "slung-rope.toml";
    assert.deepEqual(await digestHere(page, scene, stepper, STEPS), digestThere(scene, stepper, STEPS), stepper);
    t.diagnostic(`${scene} ${stepper}`);
  }
  await close();
});

test("a scene that is refused is refused in the desktop's words", async () => {
  const { page, close } = await open(browser, server.url);
  const folder = mkdtempSync(join(tmpdir(), "hooke-"));
  const wrong = {
    "slip.toml": 'gravity = [0.0, 0.0, -9.81]\n[[particle]]\npostion = [0.0, 0.0, 1.0]\n',
    "mass.toml": "[[particle]]\nposition = [0.0, 0.0, 1.0]\nmass = -1.0\n",
    "text.toml": "gravity = [0.0, 0.0\n",
    "text.json": '{"gravity": [0, 0, -9.81], "duration": "long"}\n',
  };
  const refused = (name, text) =>
    page.evaluate(async ([name, text]) => {
      const { readScene } = await import(new URL("js/scene.js", location.href));
      return readScene(name, text).then(() => "", (error) => error.printed);
    }, [name, text]);
  for (const [name, text] of Object.entries(wrong)) {
    writeFileSync(join(folder, name), text);
    const ran = desktop(folder, "check", name);
    assert.equal(ran.status, 2);
    // Printed as a whole: place, value, lines of the file, remedy.
    assert.equal((await refused(name, text)).trim(), ran.stderr.trim(), name);
  }
  const sound = wrong["mass.toml"].replace("-1.0", "1.0");
  assert.equal(await refused("mass.toml", sound), "");
  // In the page: the words stand there, the scene stays.
  await page.keyboard.press("e");
  await page.locator("#text").fill(wrong["slip.toml"]);
  await page.locator("#run").click();
  assert.match(await page.locator("#refusal").innerText(), /postion[^]*position/);
  assert.equal(await page.evaluate(() => hookePage.scene.name), "hanging cloth");
  await page.locator("#text").fill(sound);
  await page.locator("#run").click();
  await page.waitForFunction(() => hookePage.scene.particles === 1);
  await close();
});

test("hooke view serves the page and its own run, and ends at Ctrl-C", async () => {
  const flags = ["--precision", "f32", "--duration", "0.5", "--time-step", "0.0009765625", "--stepper", "velocity-verlet"];
  const served = await view("slung-rope.toml", ...flags);
  const port = new URL(served.url).port;
  const taken = desktop(scenes, "view", "slung-rope.toml", "--no-open", "--port", port);
  assert.equal(taken.status, 1);
  assert.match(taken.stderr, new RegExp(`port ${port}[^]*--port`));
  const { page, complaints, close } = await open(browser, served.url);
  assert.equal(await page.locator("#stepper-a").inputValue(), "desktop");
  await page.waitForFunction(() => hookePage.sides.list[0].stopped, undefined, { timeout: 60_000 });
  await pictures(page, 1);
  const [last, words] = await page.evaluate(() => [[...hookePage.sides.list[0].positions], hookePage.sides.list[0].stopped.words]);
  assert.match(words, /at its end/);
  const table = desktop(scenes, "run", "slung-rope.toml", ...flags, "--out", "-").stdout.trim().split("\n").map((row) => row.split(","));
  const end = table.filter(([frame]) => frame === table.at(-1)[0]).flatMap((row) => row.slice(3, 6).map((x) => Math.fround(Number(x))));
  assert.deepEqual(last, end);
  // Beside it the page steps the same scene itself: after as many steps to the same bits.
  const own = await page.evaluate(() => {
    hookePage.play(false);
    hookePage.choose({ a: "velocity-verlet", timeStep: 2 ** -10 });
    hookePage.reset();
    hookePage.step(512);
    return [...hookePage.sides.list[0].positions];
  });
  assert.deepEqual(own, end);
  assert.deepEqual(complaints, []);
  // Only pages of this machine are answered.
  assert.equal(await statusFor(served.url, new URL(served.url).host), 200);
  assert.equal(await statusFor(served.url, "example.org"), 403);
  await close();
  assert.equal(await served.end(), 0);
});
