// An eye that turns round a target, and is never upside down.

import { add, across, cross, direction, dot, length, lookAt, multiply, perspective, scale, subtract } from "./matrices.js";

const STEEPEST = 1.55;
/** Room for what lies over the picture at its edges. */
const ROOM = 1.2;
/** This part of a scene's radius is within the picture, however narrow. */
const WITHIN = 0.85;

export class Camera {
  /** Sees all of a scene, from where the scene says if it does. */
  constructor({ middle, radius, up, chosen }) {
    this.radius = radius;
    this.up = chosen?.up ? direction(chosen.up) : up;
    this.angle = ((chosen?.field_of_view ?? 38) * Math.PI) / 180;
    this.target = chosen?.target ?? middle;
    const back = chosen?.position ? subtract(chosen.position, this.target) : this.#threeQuarters();
    this.#from(back);
    this.distance = chosen?.position ? ROOM * this.distance : (ROOM * radius) / Math.sin(this.angle / 2);
    this.home = { target: this.target, yaw: this.yaw, pitch: this.pitch, distance: this.distance };
  }

  #axes() {
    const ahead = direction(cross(this.up, [1, 0, 0]), across(this.up));
    return [direction(cross(ahead, this.up)), ahead];
  }

  #threeQuarters() {
    const [right, ahead] = this.#axes();
    return add(add(scale(right, 0.45), scale(ahead, -0.85)), scale(this.up, 0.32));
  }

  #from(back) {
    const [right, ahead] = this.#axes();
    this.distance = length(back);
    const unit = direction(back);
    this.pitch = Math.asin(Math.max(-1, Math.min(1, dot(unit, this.up))));
    this.yaw = Math.atan2(dot(unit, right), -dot(unit, ahead));
  }

  get back() {
    const [right, ahead] = this.#axes();
    const level = add(scale(right, Math.sin(this.yaw)), scale(ahead, -Math.cos(this.yaw)));
    return add(scale(level, Math.cos(this.pitch)), scale(this.up, Math.sin(this.pitch)));
  }

  get eye() {
    return add(this.target, scale(this.back, this.distance));
  }

  orbit(yaw, pitch) {
    this.yaw -= yaw;
    this.pitch = Math.max(-STEEPEST, Math.min(STEEPEST, this.pitch + pitch));
  }

  /** @param {number} factor of the distance */
  zoom(factor) {
    this.distance = Math.max(this.radius * 0.05, Math.min(this.radius * 60, this.distance * factor));
  }

  /** By parts of the picture's height. */
  pan(x, y) {
    const size = 2 * this.distance * Math.tan(this.angle / 2);
    const right = direction(cross(this.up, this.back));
    const above = cross(this.back, right);
    this.target = add(this.target, add(scale(right, -x * size), scale(above, y * size)));
  }

  goHome() {
    Object.assign(this, this.home);
  }

  /** The matrices for a picture of that width over height; narrow pictures are seen from farther away. */
  see(aspect) {
    const half = Math.tan(this.angle / 2);
    const wide = (WITHIN * this.radius) / (this.home.distance * Math.min(aspect, 1));
    const angle = 2 * Math.atan(Math.min(Math.max(half, wide), 2));
    const view = lookAt(this.eye, this.target, this.up);
    const far = this.distance + 40 * this.radius;
    const projection = perspective(angle, aspect, Math.max(far * 1e-4, this.distance * 0.01), far);
    return { view, projection, both: multiply(projection, view), angle };
  }
}
