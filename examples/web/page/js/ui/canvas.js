// A 2D canvas as sharp as the screen, in the page's colours.

export function sharp(canvas) {
  const ratio = Math.min(devicePixelRatio || 1, 3);
  const { clientWidth: width, clientHeight: height } = canvas;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.font = "11px system-ui, sans-serif";
  return { context, width, height };
}

let [known, theme] = [new Map(), undefined];

/** A colour of the style sheet, by the name of its variable. */
export function colour(name) {
  const root = document.documentElement;
  if (theme !== root.dataset.theme) [known, theme] = [new Map(), root.dataset.theme];
  if (!known.has(name)) known.set(name, getComputedStyle(root).getPropertyValue(`--${name}`).trim());
  return known.get(name);
}
