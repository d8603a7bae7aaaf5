import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { mkdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { launch, open, pictures, serve } from "./support.mjs";

const shots = fileURLToPath(new URL("../shots/", import.meta.url));
let server, browser;
before(async () => {
  mkdirSync(shots, { recursive: true });
  server = await serve();
  browser = await launch();
});
after(async () => {
  await browser?.close();
  server?.close();
});

const positions = (page) => page.evaluate(() => [...hookePage.sides.list[0].positions]);
/** Where a particle is on the page. */
const placeOf = (page, particle) =>
  page.evaluate((i) => {
    const { stage, camera, sides } = hookePage;
    const part = stage.part(0);
    const { both } = camera.see(part.width / part.height);
    const [x, y, z] = sides.list[0].positions.subarray(3 * i, 3 * i + 3);
    const [cx, cy, , w] = [0, 1, 2, 3].map((r) => both[r] * x + both[4 + r] * y + both[8 + r] * z + both[12 + r]);
    const { x: left, width, top, height } = stage.canvas.getBoundingClientRect();
    return { x: left + ((cx / w + 1) / 2) * (width / sides.list.length), y: top + ((1 - cy / w) / 2) * height };
  }, particle);
const choose = (page, changes) => page.evaluate((changes) => hookePage.choose(changes), changes);
const scene = (page, file) => page.evaluate((scene) => hookePage.open({ ...hookePage.chosen, scene, text: null }), file);

test("it loads without a complaint, and the picture moves", async () => {
  const { page, complaints, close } = await open(browser, server.url);
  const [first, firstPicture] = [await positions(page), await page.locator("#stage").screenshot()];
  await pictures(page, 4);
  const [second, secondPicture] = [await positions(page), await page.locator("#stage").screenshot()];
  assert.ok(second.some((x, i) => x !== first[i]), "positions do not move");
  assert.ok(!firstPicture.equals(secondPicture), "the picture does not move");
  // The control: a pause stops both.
  await page.keyboard.press(" ");
  await pictures(page, 3);
  const [third, thirdPicture] = [await positions(page), await page.locator("#stage").screenshot()];
  await pictures(page, 3);
  assert.deepEqual(await positions(page), third);
  assert.ok(thirdPicture.equals(await page.locator("#stage").screenshot()), "a paused picture moves");
  assert.deepEqual(complaints, []);
  await close();
});

test("every shipped scene loads, steps, and is drawn in both themes", async () => {
  const { page, complaints, close } = await open(browser, server.url);
  const files = await page.evaluate(async () => (await import(new URL("js/shipped.js", location.href))).SHIPPED.map(({ file }) => file));
  assert.ok(files.length >= 10);
  for (const file of files) {
    await scene(page, file);
    await page.evaluate(() => (hookePage.play(false), hookePage.reset(), hookePage.step(20)));
    await pictures(page, 2);
    const steps = await page.evaluate(() => hookePage.sides.list[0].steps);
    assert.equal(steps, 20, file);
    await page.keyboard.press("t");
  }
  assert.deepEqual(complaints, []);
  await close();
});

test("a hand on a particle pulls it; beside one it turns the view", async () => {
  const { page, close } = await open(browser, server.url);
  await scene(page, "damped-pendulum.toml");
  await choose(page, { speed: 0.1 });
  const from = await placeOf(page, 1);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  assert.equal(await page.evaluate(() => hookePage.held?.particle), 1);
  await page.mouse.move(from.x - 60, from.y - 40, { steps: 4 });
  await pictures(page, 4);
  const now = await placeOf(page, 1);
  assert.ok(Math.hypot(now.x - from.x + 60, now.y - from.y + 40) < 3, `it is at ${now.x}, ${now.y}, not where the hand is`);
  await page.mouse.up();
  assert.equal(await page.evaluate(() => hookePage.held), undefined);
  await pictures(page, 3);
  const later = await placeOf(page, 1);
  assert.ok(Math.hypot(later.x - now.x, later.y - now.y) > 0.1, "it does not swing on");
  // The control: nothing is near here.
  await page.evaluate(() => hookePage.play(false));
  const [yaw, held] = [await page.evaluate(() => hookePage.camera.yaw), await positions(page)];
  await page.mouse.move(60, 150);
  await page.mouse.down();
  await page.mouse.move(160, 150, { steps: 3 });
  await page.mouse.up();
  assert.notEqual(await page.evaluate(() => hookePage.camera.yaw), yaw);
  assert.deepEqual(await positions(page), held);
  await close();
});

test("side by side explicit Euler explodes, says where and when, and the other goes on", async () => {
  const { page, complaints, close } = await open(browser, server.url);
  await choose(page, { a: "explicit-euler", b: "semi-implicit-euler", timeStep: 1e-3 });
  await page.evaluate(() => (hookePage.play(false), hookePage.reset(), hookePage.step(500)));
  await pictures(page, 2);
  const [first, second] = await page.evaluate(() => hookePage.sides.list.map(({ stopped, time, steps, positions }) => ({ stopped, time, steps, finite: positions.every(Number.isFinite) })));
  assert.match(first.stopped.words, /exploded at particle \d+ in the step after \d+ ms/);
  assert.ok(first.finite, "the state before is kept");
  assert.equal(first.stopped.time, first.time);
  assert.equal(second.steps, 500);
  assert.equal(second.stopped, undefined);
  assert.match(await page.locator("#labels .side-a").innerText(), /exploded at particle/);
  assert.match(await page.locator("#limit-words .side-a").innerText(), /times the limit/);
  assert.match(await page.locator("#limit-words .side-b").innerText(), /stable/);
  await page.screenshot({ path: `${shots}side-by-side.png` });
  // The control: within its limit it does not explode.
  await choose(page, { timeStep: 1e-4 });
  await page.evaluate(() => (hookePage.reset(), hookePage.step(500)));
  assert.equal(await page.evaluate(() => hookePage.sides.list[0].stopped), undefined);
  assert.deepEqual(complaints, []);
  await close();
});

test("what is changed live changes the motion and the limit", async () => {
  const { page, close } = await open(browser, server.url);
  await page.evaluate(() => hookePage.play(false));
  const limit = () => page.evaluate(() => hookePage.sides.list[0].stableStep());
  const soft = await limit();
  await choose(page, { stiffness: 4 });
  // Verlet's limit is 2/ω, and damping shortens it: ω doubles.
  const ratio = soft / (await limit());
  assert.ok(ratio > 1.7 && ratio < 2.05, `four times the stiffness divides the limit by ${ratio}`);
  await choose(page, { gravity: 0 });
  await page.evaluate(() => (hookePage.reset(), hookePage.step(10)));
  const still = await page.evaluate(() => hookePage.sides.list[0].energy().kinetic);
  await choose(page, { gravity: 1 });
  await page.evaluate(() => hookePage.step(10));
  assert.ok((await page.evaluate(() => hookePage.sides.list[0].energy().kinetic)) > 1e6 * still);
  await close();
});

test("all springs are changed at once, relative to what the scene made them", async () => {
  const { page, close } = await open(browser, server.url);
  const found = await page.evaluate(() => {
    hookePage.play(false);
    const { scene, sides } = hookePage;
    const { world } = sides.list[0];
    const calls = [];
    world.setSpring = (...told) => calls.push(told);
    hookePage.choose({ stiffness: 4, damping: 0 });
    const without = world.spring(0).damping;
    hookePage.choose({ stiffness: 2, damping: 3 });
    const ends = [0, scene.springs - 1];
    return {
      calls, without,
      are: ends.map((i) => [world.spring(i).stiffness, world.spring(i).damping]),
      // In single precision, as the world holds them.
      given: ends.map((i) => [Math.fround(2 * scene.stiffness[i]), Math.fround(3 * scene.damping[i])]),
    };
  });
  assert.deepEqual(found.calls, []);
  assert.equal(found.without, 0);
  assert.ok(found.given.flat().every((value) => value > 0), "the scene has no springs to tell it by");
  assert.deepEqual(found.are, found.given);
  await close();
});

test("what is changed from outside is no doing of the stepper", async () => {
  const { page, close } = await open(browser, server.url);
  await page.evaluate(() => (hookePage.play(false), hookePage.reset(), hookePage.step(20)));
  const ledger = () => page.evaluate(() => {
    const { sides } = hookePage;
    return { remainder: sides.list[0].energy().remainder, rows: sides.histories[0].rows.length, last: sides.histories[0].rows.at(-1).remainder };
  });
  for (const changes of [{ stiffness: 4 }, { gravity: 0.5 }]) {
    await page.evaluate(() => hookePage.step(2));
    await page.evaluate(() => hookePage.step(2));
    assert.ok((await ledger()).rows > 1);
    await choose(page, changes);
    assert.deepEqual(await ledger(), { remainder: 0, rows: 1, last: 0 }, JSON.stringify(changes));
  }
  // A hand that carries a particle off, and lets it go.
  const [held, away] = await page.evaluate(() => {
    const { sides } = hookePage;
    const [x, y, z] = sides.list[0].positions.subarray(30, 33);
    hookePage.hold(10, [x, y, z]);
    return [10, [x + 0.3, y, z + 0.3]];
  });
  await page.evaluate(([held, away]) => hookePage.hold(held, away), [held, away]);
  await pictures(page, 3);
  assert.deepEqual(await ledger(), { remainder: 0, rows: 1, last: 0 });
  await page.evaluate(() => hookePage.release());
  assert.deepEqual(await ledger(), { remainder: 0, rows: 1, last: 0 });
  // The control: what a stepper makes itself is told, and a change of what holds no energy leaves it.
  await choose(page, { a: "explicit-euler" });
  await page.evaluate(() => hookePage.step(40));
  const made = (await ledger()).remainder;
  assert.ok(made > 0, `explicit Euler makes ${made} J`);
  await choose(page, { timeStep: 1e-5 });
  assert.equal((await ledger()).remainder, made);
  await close();
});

test("the axis of energy holds what there was at the start, as far as things have fallen", async () => {
  const { page, close } = await open(browser, server.url);
  const [falls, grows] = await page.evaluate(async () => {
    const { energyScale } = await import(new URL("js/ui/energy-chart.js", location.href));
    const row = (gravitational, total) => ({ gravitational, total, lostToDamping: 0, lostInImpacts: 0 });
    const after = (...rows) => {
      const histories = [{ rows: [] }];
      return rows.reduce((scale, row) => (histories[0].rows.push(row), energyScale(histories, scale)), undefined).most;
    };
    // 10 J all along, of which 1 and then 6 show; and 10 J that become 60.
    return [after(row(10, 10), row(9, 10), row(4, 10)), after(row(0, 10), row(0, 60), row(0, 60))];
  });
  assert.ok(falls >= 6, `6 J do not fit on an axis of ${falls} J`);
  assert.ok(grows < 20, `one cannot see energy grow on an axis that is at ${grows} J at once`);
  await close();
});

test("a link carries the scene and everything chosen", async () => {
  const { page, close } = await open(browser, server.url);
  const text = 'name = "of the link"\ngravity = [0.0, 0.0, -1.0]\n[[rope]]\nfrom = [0.0, 0.0, 1.0]\nto = [1.0, 0.0, 1.0]\nparticles = 7\nstiffness = 50.0\npinned = ["first"]\n';
  const chosen = { scene: "mine.toml", text, a: "rk4", b: "tr-bdf2", timeStep: 2e-3, stiffness: 3, damping: 0, gravity: 0.5, speed: 0.25 };
  await page.evaluate(async (chosen) => {
    await hookePage.open({ ...hookePage.chosen, ...chosen });
    hookePage.play(false);
    hookePage.reset();
    hookePage.step(50);
  }, chosen);
  const link = await page.evaluate(() => hookePage.link());
  const digests = (page) => page.evaluate(() => hookePage.sides.list.map((side) => side.digest()));
  const there = await open(browser, link);
  const found = await there.page.evaluate(() => hookePage.chosen);
  for (const [key, value] of Object.entries(chosen)) assert.deepEqual(found[key], value, key);
  await there.page.evaluate(() => (hookePage.play(false), hookePage.reset(), hookePage.step(50)));
  assert.deepEqual(await digests(there.page), await digests(page));
  await there.page.evaluate(() => hookePage.step(1));
  assert.notDeepEqual(await digests(there.page), await digests(page));
  await there.close();
  // The control: a link that lost its end says so, and the page is there all the same.
  const damaged = await open(browser, link.slice(0, -9));
  assert.match(await damaged.page.locator("#toast").innerText(), /link is damaged/);
  await damaged.close();
  await close();
});

test("what the reader takes and single precision refuses leaves the scene before, and says why", async () => {
  const { page, complaints, close } = await open(browser, server.url);
  const light = (mass) => `[[particle]]\nposition = [0.0, 0.0, 1.0]\nmass = ${mass}\n`;
  const goesOn = async () => {
    const before = await page.evaluate(() => [hookePage.scene.name, hookePage.chosen.scene, hookePage.sides.list[0].steps]);
    await page.waitForFunction((steps) => hookePage.sides.list[0].steps > steps, before[2]);
    assert.deepEqual(before.slice(0, 2), ["hanging cloth", "hanging-cloth.toml"]);
  };
  await page.keyboard.press("e");
  await page.locator("#text").fill(light("1e-50"));
  await page.locator("#run").click();
  await page.waitForFunction(() => document.getElementById("refusal").textContent !== "");
  assert.match(await page.locator("#refusal").innerText(), /single precision: particle 0: .*mass/);
  await goesOn();
  await page.evaluate(() => document.getElementById("editor").close());
  // The same by a link, on a page that is there and on one that begins with it.
  const link = await page.evaluate(async (text) => {
    const { pack } = await import(new URL("js/share.js", location.href));
    return `#${await pack({ scene: "light.toml", text })}`;
  }, light("1e-50"));
  await page.evaluate((link) => (location.hash = link), link);
  await page.waitForFunction(() => /particle 0: .*mass/.test(document.getElementById("toast").textContent));
  await goesOn();
  const there = await open(browser, server.url + link);
  assert.match(await there.page.locator("#toast").innerText(), /particle 0: .*mass/);
  assert.equal(await there.page.evaluate(() => hookePage.scene.name), "hanging cloth");
  assert.deepEqual(there.complaints, []);
  await there.close();
  // The control: what single precision holds is taken.
  await page.keyboard.press("e");
  await page.locator("#text").fill(light("1e-30"));
  await page.locator("#run").click();
  await page.waitForFunction(() => hookePage.scene.particles === 1);
  assert.deepEqual(complaints, []);
  await close();
});

test("keys pause, step, reset, compare", async () => {
  const { page, close } = await open(browser, server.url);
  await page.keyboard.press(" ");
  assert.equal(await page.evaluate(() => hookePage.playing), false);
  await page.keyboard.press("r");
  await page.keyboard.press(".");
  await page.keyboard.press(".");
  assert.equal(await page.evaluate(() => hookePage.sides.list[0].steps), 2);
  await page.keyboard.press("]");
  assert.equal(await page.evaluate(() => hookePage.sides.timeStep), 6.25e-4);
  await page.keyboard.press("c");
  assert.equal(await page.evaluate(() => hookePage.sides.list.length), 2);
  await page.keyboard.press("?");
  assert.ok(await page.locator("#help").isVisible());
  await page.keyboard.press("Escape");
  const unnamed = await page.evaluate(() =>
    [...document.querySelectorAll("button, select, input, textarea, canvas")]
      .filter((part) => !(part.getAttribute("aria-label") || part.labels?.length || part.textContent.trim()))
      .map((part) => part.outerHTML));
  assert.deepEqual(unnamed, []);
  await close();
});

test("on a phone all of it is there, and a finger pulls", async () => {
  const { page, complaints, close } = await open(browser, server.url, { viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true });
  await scene(page, "damped-pendulum.toml");
  await choose(page, { b: "implicit-euler", speed: 0.1 });
  await pictures(page, 2);
  const widths = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  assert.ok(widths[0] <= widths[1], `the page is ${widths[0]} wide on a screen of ${widths[1]}`);
  for (const id of ["#play", "#step", "#reset", "#scene", "#link"]) {
    const box = await page.locator(id).boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= 390 && box.height >= 32, `${id} is out of reach`);
  }
  // One above the other.
  const parts = await page.evaluate(() => [hookePage.stage.part(0), hookePage.stage.part(1)]);
  assert.ok(parts[0].y > parts[1].y && parts[0].x === parts[1].x);
  await page.screenshot({ path: `${shots}phone.png` });
  await choose(page, { b: null });
  await pictures(page, 2);
  const at = await placeOf(page, 1);
  const client = await page.context().newCDPSession(page);
  const touch = (type, x, y) => client.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x, y }] });
  await touch("touchStart", at.x, at.y);
  assert.equal(await page.evaluate(() => hookePage.held?.particle), 1);
  await touch("touchMove", at.x + 40, at.y + 30);
  await pictures(page, 3);
  const now = await placeOf(page, 1);
  assert.ok(Math.hypot(now.x - at.x - 40, now.y - at.y - 30) < 3);
  await touch("touchEnd");
  assert.equal(await page.evaluate(() => hookePage.held), undefined);
  assert.deepEqual(complaints, []);
  await close();
});
