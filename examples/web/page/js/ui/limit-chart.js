// The time step on a line from short to long, with how far each stepper is stable.

import { STEPPERS, stepperOf } from "../steppers.js";
import { seconds, short } from "../words.js";
import { colour, sharp } from "./canvas.js";

const SHORTEST = 1e-5, LONGEST = 0.1;

/** @param {Map<string, number>} limits the largest stable step of every stepper, s */
export function drawLimits(canvas, { limits, names, timeStep }) {
  const { context, width, height } = sharp(canvas);
  const [left, right] = [6, width - 6];
  const x = (step) => left + ((right - left) * Math.log(Math.max(step, SHORTEST) / SHORTEST)) / Math.log(LONGEST / SHORTEST);
  const bar = 9;
  const top = 16;
  names.forEach((name, side) => {
    const limit = limits.get(name) ?? Infinity;
    const y = top + side * (bar + 5);
    const end = limit > 0 ? Math.min(right, Math.max(left, x(limit))) : left;
    context.fillStyle = colour("bad-soft");
    round(context, left, y, right - left, bar);
    context.fillStyle = colour(side === 0 ? "side-a" : "side-b");
    if (end > left) round(context, left, y, end - left, bar);
  });
  const below = top + names.length * (bar + 5);
  context.strokeStyle = colour("faint");
  context.fillStyle = colour("dim");
  context.textAlign = "center";
  for (const [step, words] of [[1e-5, "10 µs"], [1e-4, "0.1 ms"], [1e-3, "1 ms"], [1e-2, "10 ms"], [1e-1, "0.1 s"]]) {
    context.textAlign = step === SHORTEST ? "left" : step === LONGEST ? "right" : "center";
    context.fillText(words, x(step), height - 3);
    line(context, x(step), below, x(step), height - 15);
  }
  // The others, as ticks.
  context.strokeStyle = colour("dim");
  for (const { name } of STEPPERS) {
    const limit = limits.get(name);
    if (!names.includes(name) && limit > SHORTEST && limit < LONGEST) line(context, x(limit), below - 1, x(limit), below + 5);
  }
  const here = Math.min(right, Math.max(left, x(timeStep)));
  context.strokeStyle = context.fillStyle = colour("ink");
  context.lineWidth = 2;
  line(context, here, top - 3, here, below + 2);
  context.beginPath();
  context.moveTo(here, top - 2);
  context.lineTo(here - 4.5, top - 9);
  context.lineTo(here + 4.5, top - 9);
  context.fill();
  context.lineWidth = 1;
}

function round(context, x, y, width, height) {
  context.beginPath();
  context.roundRect(x, y, width, height, height / 2);
  context.fill();
}

function line(context, x0, y0, x1, y1) {
  context.beginPath();
  context.moveTo(x0, y0);
  context.lineTo(x1, y1);
  context.stroke();
}

/** What a time step means for a stepper: a sentence, and whether it is well. */
export function limitWords(name, limit, timeStep) {
  const { title, kind, dampsByItself, undampedOnly } = stepperOf(name);
  if (kind === "desktop") return { words: "The desktop steps it; what it prints tells how.", state: "well" };
  if (kind === "auto") return { words: `auto takes whatever is stable at ${seconds(timeStep)}.`, state: "well" };
  if (kind === "implicit") {
    const cost = dampsByItself ? "the longer it is, the more motion it damps away by itself" : "it damps nothing by itself";
    return { words: `${title}: stable at any time step; ${cost}.`, state: "well" };
  }
  if (limit === Infinity) return { words: `${title}: nothing here limits its time step.`, state: "well" };
  if (!(limit > 0)) {
    return { words: `${title}: stable at no time step, for something here is undamped. At ${seconds(timeStep)} its energy grows.`, state: "wrong" };
  }
  const part = timeStep / limit;
  const only = undampedOnly ? " It is for scenes without damping." : "";
  if (part <= 1) return { words: `${title}: ${seconds(timeStep)} is ${short(part)} of the limit of ${seconds(limit)}: stable.${only}`, state: part > 0.8 ? "near" : "well" };
  return { words: `${title}: ${seconds(timeStep)} is ${short(part)} times the limit of ${seconds(limit)}: expect it to explode.${only}`, state: "wrong" };
}
