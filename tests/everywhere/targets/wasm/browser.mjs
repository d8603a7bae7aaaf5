// node browser.mjs MODULE.wasm [QUESTION]: the same in headless Chromium, on a page that carries the module within it.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const [file, ...question] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "hooke-everywhere-"));
try {
  const page = join(folder, "page.html");
  const script = readFileSync(new URL("rows.js", import.meta.url), "utf8");
  const module = readFileSync(file).toString("base64");
  writeFileSync(page, `<!doctype html><meta charset="utf-8"><pre></pre><script>${script}
    let answer;
    try {
      const bytes = Uint8Array.from(atob("${module}"), (letter) => letter.charCodeAt(0));
      answer = "answer\\n" + rows(bytes, ${JSON.stringify(question.join(" "))});
    } catch (error) {
      answer = String(error);
    }
    document.querySelector("pre").textContent = answer;
  </script>`);
  const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking",
    "--disable-dev-shm-usage", `--user-data-dir=${join(folder, "profile")}`, "--timeout=300000", "--dump-dom"];
  const dom = execFileSync("chromium", [...flags, `file://${page}`], {
    encoding: "utf8", maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "ignore"],
  });
  const told = /<pre>([^<]*)<\/pre>/.exec(dom)?.[1] ?? "the page has not said anything";
  if (!told.startsWith("answer\n")) throw new Error(told);
  process.stdout.write(told.slice("answer\n".length));
} finally {
  rmSync(folder, { recursive: true, force: true });
}
