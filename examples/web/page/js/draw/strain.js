// How much strain the ends of the colour scale stand for: it widens and never narrows, as in the desktop's pictures.

const NARROWEST = 0.05, WIDEST = 2;
/** A sample of the springs tells it. */
const LOOKED_AT = 600;

export class StrainScale {
  end = NARROWEST;

  follow(scene, positions) {
    const every = Math.max(1, Math.floor(scene.springs / LOOKED_AT));
    // Where one side explodes the scale follows the other.
    const typical = Math.min(...positions.map((places) => this.#typical(scene, places, every)));
    if (typical > this.end && Number.isFinite(typical)) this.end = typical;
  }

  #typical(scene, places, every) {
    const strains = [];
    for (let s = 0; s < scene.springs; s += every) {
      const rest = scene.restLength[s];
      if (!(rest > 0)) continue;
      const [i, j] = [3 * scene.between[2 * s], 3 * scene.between[2 * s + 1]];
      const l = Math.hypot(places[j] - places[i], places[j + 1] - places[i + 1], places[j + 2] - places[i + 2]);
      strains.push(Math.min(Math.abs(l - rest) / rest, WIDEST));
    }
    // A few springs may go beyond it: some at a cloth's corners would make the rest grey.
    return strains.sort((a, b) => a - b)[Math.floor(strains.length * 0.97)] ?? 0;
  }
}
