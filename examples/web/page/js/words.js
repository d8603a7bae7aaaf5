// Numbers as people read them.

const PREFIXES = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"]];

/** Three digits, without zeros at the end. */
export function short(value) {
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "no number";
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e5 || size < 1e-3)) return value.toExponential(1).replace("e+", "e");
  return String(Number(value.toPrecision(3)));
}

/** `1.5 ms` */
export function withUnit(value, unit) {
  if (value === 0 || !Number.isFinite(value)) return `${short(value)} ${unit}`;
  const size = Math.abs(value);
  const [factor, prefix] = PREFIXES.find(([factor]) => size >= factor * 0.9995) ?? PREFIXES.at(-1);
  return size > 1e12 ? `${value.toExponential(1)} ${unit}` : `${short(value / factor)} ${prefix}${unit}`;
}

export const seconds = (value) => withUnit(value, "s");
export const counted = (count, what) => `${count.toLocaleString("en").replaceAll(",", " ")} ${what}${count === 1 ? "" : "s"}`;
