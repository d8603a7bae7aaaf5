// node node.mjs MODULE.wasm [QUESTION]
import { readFileSync } from "node:fs";
import "./rows.js";

const [file, ...question] = process.argv.slice(2);
process.stdout.write(globalThis.rows(readFileSync(file), question.join(" ")));
