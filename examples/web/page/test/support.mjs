// A server of static files, a browser, and the desktop's own answers.

import { spawn, spawnSync } from "node:child_process";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { dirname, extname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const here = dirname(fileURLToPath(import.meta.url));
export const root = resolve(here, "../../../..");
export const scenes = join(root, "scenes");
const hooke = process.env.HOOKE ?? join(root, "target/debug/hooke");
const KINDS = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".wasm": "application/wasm" };

/** The page as any server of files would serve it. */
export async function serve(folder = resolve(here, "../dist")) {
  const server = createServer(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url, "http://here").pathname);
    const file = join(folder, path === "/" ? "index.html" : path);
    try {
      const bytes = await readFile(file);
      response.writeHead(200, { "content-type": KINDS[extname(file)] ?? "text/plain" }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
  return { url: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

export const launch = () =>
  chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking"],
  });

/** A page that has drawn its first picture, and what it complained of. */
export async function open(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 960, height: 500 }, ...options });
  const page = await context.newPage();
  const complaints = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(error.message));
  await page.goto(url);
  await page.waitForFunction(() => globalThis.hookePage?.frames > 0, undefined, { timeout: 60_000 });
  return { page, complaints, close: () => context.close() };
}

/** Pictures go by. */
export async function pictures(page, count = 3) {
  const before = await page.evaluate(() => hookePage.frames);
  await page.waitForFunction((frames) => hookePage.frames >= frames, before + count, { timeout: 60_000 });
}

/** What `hooke` answers in a folder. */
export function desktop(folder, ...flags) {
  const ran = spawnSync(hooke, flags, { cwd: folder, encoding: "utf8", maxBuffer: 1 << 28 });
  if (ran.error) throw ran.error;
  return ran;
}

/** `hooke view`, and where it serves. */
export async function view(...flags) {
  const child = spawn(hooke, ["view", ...flags, "--no-open"], { cwd: scenes });
  let said = "";
  child.stderr.setEncoding("utf8");
  const url = await new Promise((found, failed) => {
    child.stderr.on("data", (text) => {
      said += text;
      const address = /http:\/\/\S+/.exec(said);
      if (address) found(address[0]);
    });
    child.on("exit", (code) => failed(new Error(`hooke view ended with ${code}: ${said}`)));
  });
  const end = () =>
    new Promise((ended) => {
      child.removeAllListeners("exit");
      child.on("exit", (code) => ended(code));
      child.kill("SIGINT");
    });
  return { url, end };
}
