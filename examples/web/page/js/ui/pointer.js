// Mouse and touch: on a particle they pull it, beside it they turn the view; two fingers zoom and pan, so do the wheel and
// the right button.

import { add, cross, direction, dot, scale, subtract } from "../draw/matrices.js";

/** How near to a particle counts as on it, in pixels of the page. */
const NEAR = { mouse: 18, touch: 34, pen: 22 };

export class Pointer {
  #touches = new Map();

  constructor(app) {
    this.app = app;
    this.canvas = app.stage.canvas;
    const on = (name, does, options) => this.canvas.addEventListener(name, does, options);
    on("pointerdown", (event) => this.#down(event));
    on("pointermove", (event) => this.#move(event));
    on("pointerup", (event) => this.#up(event));
    on("pointercancel", (event) => this.#up(event));
    on("contextmenu", (event) => event.preventDefault());
    on("wheel", (event) => this.#wheel(event), { passive: false });
    on("dblclick", () => app.camera.goHome());
  }

  #down(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.focus({ preventScroll: true });
    this.#touches.set(event.pointerId, [event.clientX, event.clientY]);
    if (this.#touches.size > 1) return this.app.release();
    if (event.button !== 0 || event.shiftKey) return;
    const found = this.#find(event);
    if (!found) return;
    this.grip = { ...found, id: event.pointerId };
    this.app.hold(found.particle, found.place);
  }

  /** The particle under a pointer, and where it is. */
  #find(event) {
    const { stage, sides, camera } = this.app;
    const spot = stage.at(event.clientX, event.clientY);
    const positions = spot && sides.list[spot.index]?.positions;
    if (!positions) return undefined;
    const { both } = camera.see(spot.aspect);
    const near = (2 * (NEAR[event.pointerType] ?? NEAR.mouse)) / spot.pixels;
    let best;
    for (let i = 0; i < positions.length; i += 3) {
      const [px, py, pz] = [positions[i], positions[i + 1], positions[i + 2]];
      const w = both[3] * px + both[7] * py + both[11] * pz + both[15];
      if (!(w > 0)) continue;
      const x = (both[0] * px + both[4] * py + both[8] * pz + both[12]) / w - spot.x;
      const y = (both[1] * px + both[5] * py + both[9] * pz + both[13]) / w - spot.y;
      const away = Math.hypot(x * spot.aspect, y);
      if (!(away < near)) continue;
      // Among those under the pointer the nearest to the eye.
      const badness = away / near + (0.3 * w) / camera.distance;
      if (!best || badness < best.badness) best = { particle: i / 3, place: [px, py, pz], badness };
    }
    return best;
  }

  #move(event) {
    const before = this.#touches.get(event.pointerId);
    if (!before) {
      this.canvas.classList.toggle("near", event.pointerType === "mouse" && Boolean(this.#find(event)));
      return;
    }
    const now = [event.clientX, event.clientY];
    const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
    if (this.#touches.size > 1) this.#pinch(event.pointerId, before, now);
    this.#touches.set(event.pointerId, now);
    if (this.#touches.size > 1) return;
    const { camera, stage, held } = this.app;
    const height = this.canvas.clientHeight;
    if (held && this.grip?.id === event.pointerId) this.app.hold(held.particle, this.#onPlane(event));
    else if (event.buttons & 2 || event.shiftKey) camera.pan(dx / height, dy / height);
    else camera.orbit((4.5 * dx) / stage.canvas.clientWidth, (3.2 * dy) / height);
  }

  /** Where a pointer is on the plane through the particle that was gripped, across the line of sight. */
  #onPlane(event) {
    const { camera, stage } = this.app;
    const spot = stage.at(event.clientX, event.clientY) ?? stage.at(this.grip.x, this.grip.y);
    if (!spot) return this.app.held.target;
    Object.assign(this.grip, { x: event.clientX, y: event.clientY });
    const { angle } = camera.see(spot.aspect);
    const { back } = camera;
    const right = direction(cross(camera.up, back));
    const above = cross(back, right);
    const half = Math.tan(angle / 2);
    const ray = subtract(add(scale(right, spot.x * half * spot.aspect), scale(above, spot.y * half)), back);
    const depth = dot(subtract(this.grip.place, camera.eye), back) / dot(ray, back);
    const place = add(camera.eye, scale(ray, depth));
    // A hand does not pull a particle through a plane.
    for (const plane of this.app.scene.planes) {
      const below = dot(subtract(place, plane.point), plane.normal);
      if (below < 0) place.splice(0, 3, ...subtract(place, scale(plane.normal, below)));
    }
    return place;
  }

  #pinch(id, before, now) {
    const [other] = [...this.#touches.entries()].filter(([key]) => key !== id).map(([, place]) => place);
    const apart = (a) => Math.hypot(a[0] - other[0], a[1] - other[1]);
    const { camera } = this.app;
    camera.zoom(apart(before) / Math.max(apart(now), 1));
    const height = this.canvas.clientHeight;
    camera.pan((now[0] - before[0]) / 2 / height, (now[1] - before[1]) / 2 / height);
  }

  #up(event) {
    this.#touches.delete(event.pointerId);
    if (this.grip?.id === event.pointerId) {
      this.app.release();
      this.app.stage.marked = -1;
      this.grip = undefined;
    }
  }

  #wheel(event) {
    event.preventDefault();
    this.app.camera.zoom(Math.exp(0.0012 * event.deltaY * (event.deltaMode === 1 ? 16 : 1)));
  }
}
