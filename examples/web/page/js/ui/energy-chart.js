// The ledger of one side over time, as layers: together they are what there was at the start, as far as the stepper is honest.

import { short, withUnit } from "../words.js";
import { colour, sharp } from "./canvas.js";

export const LAYERS = [
  ["gravitational", "height"], ["kinetic", "motion"], ["elastic", "springs"], ["lostToDamping", "lost to damping"], ["lostInImpacts", "lost in impacts"],
];

/** s, what the axis of time shows at least. */
const SHORTEST = 0.5;

/** The axis that all sides share: what the first moments hold, with room above. */
export function energyScale(histories, scale) {
  // Ledgers that were opened anew begin with another height.
  const before = scale?.histories === histories ? scale : undefined;
  const rows = histories.flatMap((history) => history.rows);
  const sane = rows.filter((row) => Number.isFinite(row.total));
  const lowest = sane.reduce((low, row) => Math.min(low, row.gravitational), Infinity);
  const first = histories.map((history) => history.rows[0]).filter(Boolean);
  const base = Math.min(lowest, before?.floor ?? Infinity);
  const start = first.reduce((most, row) => Math.max(most, row.total - base + (row.lostToDamping + row.lostInImpacts)), 0);
  const typical = sane.map((row) => row.total - base + row.lostToDamping + row.lostInImpacts).sort((a, b) => a - b);
  const median = typical[typical.length >> 1] ?? 0;
  const want = 1.45 * Math.max(start, Math.min(median, 4 * start || median), 1e-12);
  // It follows slowly, so that one can watch something grow; but not what there was at the start, of which more comes to light as
  // things fall, nor from next to nothing.
  const isNear = before?.rows > 0 && before.most > want / 8;
  const most = isNear ? Math.max(before.most * 0.985, Math.min(want, before.most * 1.02), 1.45 * start) : want;
  return { floor: base, most: Math.abs(most / want - 1) < 0.02 ? want : most, rows: sane.length, histories };
}

export function drawEnergy(canvas, history, { floor, most }, mark) {
  const { context, width, height } = sharp(canvas);
  const { rows } = history;
  if (rows.length === 0) return;
  const span = Math.min(history.span, Math.max(SHORTEST, 1.2 * (rows.at(-1).time - rows[0].time)));
  const end = Math.max(rows.at(-1).time, rows[0].time + span);
  const x = (time) => width - ((end - time) / span) * width;
  const y = (energy) => height - 1 - (Math.max(-0.05, Math.min(1.2, energy / most)) * (height - 1));
  const sums = new Float64Array(rows.length);
  for (const [key] of LAYERS) {
    context.beginPath();
    rows.forEach((row, i) => context.lineTo(x(row.time), y(sums[i])));
    for (let i = rows.length - 1; i >= 0; i--) {
      sums[i] += Math.max(0, key === "gravitational" ? rows[i].gravitational - floor : rows[i][key]);
      context.lineTo(x(rows[i].time), y(sums[i]));
    }
    context.fillStyle = colour(`energy-${key}`);
    context.fill();
  }
  // The line that the top would be at if nothing were missing.
  const whole = (row) => row.total - floor + row.lostToDamping + row.lostInImpacts - row.remainder;
  context.setLineDash([4, 4]);
  context.strokeStyle = colour("ink");
  context.beginPath();
  rows.forEach((row) => context.lineTo(x(row.time), y(whole(row))));
  context.stroke();
  context.setLineDash([]);
  if (mark) {
    context.strokeStyle = colour("bad");
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(x(rows.at(-1).time), 0);
    context.lineTo(x(rows.at(-1).time), height);
    context.stroke();
    context.lineWidth = 1;
  }
}

/** What is missing from the balance, in words. */
export function remainderWords(row, floor) {
  if (!row) return "";
  const whole = Math.max(row.total - floor + row.lostToDamping + row.lostInImpacts - row.remainder, 1e-300);
  const part = row.remainder / whole;
  if (!Number.isFinite(part)) return "beyond all numbers";
  const sign = row.remainder < 0 ? "−" : "+";
  const size = Math.abs(part);
  const percent = size >= 10 ? `${short(size)} times all there was` : `${short(100 * size)} %`;
  return `${sign}${withUnit(Math.abs(row.remainder), "J")} (${percent})`;
}
