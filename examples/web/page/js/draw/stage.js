// Draws the sides next to each other, all from one eye.

import { LOOKS, particleLooks } from "./looks.js";
import { add, direction, dot, subtract } from "./matrices.js";
import { CORNER, Program } from "./program.js";
import * as shaders from "./shaders.js";
import { Shadows } from "./shadows.js";
import { SideBuffers } from "./side-buffers.js";
import { StrainScale } from "./strain.js";

export class Stage {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    const gl = canvas.getContext("webgl2", { antialias: true, alpha: true, premultipliedAlpha: true, powerPreference: "high-performance" });
    if (!gl) throw new Error("this browser has no WebGL 2, which the picture needs");
    Object.assign(this, { canvas, gl, sides: [], looks: LOOKS.light, strain: new StrainScale() });
    Object.assign(this, { detail: 1, pace: 30, changed: performance.now() });
    this.spring = new Program(gl, shaders.spring.vertex, shaders.spring.fragment);
    this.springShadow = new Program(gl, shaders.spring.vertex, shaders.springShadow);
    this.ball = new Program(gl, shaders.ball.vertex, shaders.ball.fragment);
    this.ballShadow = new Program(gl, shaders.ball.vertex, shaders.ball.shadow);
    this.plane = new Program(gl, shaders.plane.vertex, shaders.plane.fragment);
    this.shadows = new Shadows(gl);
    this.square = gl.createVertexArray();
    gl.bindVertexArray(this.square);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(CORNER);
    gl.vertexAttribPointer(CORNER, 2, gl.FLOAT, false, 0, 0);
    gl.bindVertexArray(null);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  /** Another scene, to be drawn `count` times. */
  show(scene, extent, floors, count) {
    this.sides.forEach((side) => side.free());
    Object.assign(this, { scene, extent, floors, marked: -1 });
    const looks = particleLooks(this.looks, scene);
    this.sides = Array.from({ length: count }, () => new SideBuffers(this.gl, scene, looks));
    const tilt = Math.abs(extent.up[0]) < 0.9 ? [-0.35, -0.28, 0] : [0, -0.35, -0.28];
    this.light = direction(add(extent.up, tilt));
    this.strain = new StrainScale();
  }

  wear(theme) {
    this.looks = LOOKS[theme];
    if (this.scene) this.sides.forEach((side) => side.paint(particleLooks(this.looks, this.scene)));
  }

  /** Whether sides are one above the other: where the canvas is higher than wide. */
  get isStacked() {
    return this.canvas.height > this.canvas.width;
  }

  /** The part of the canvas that a side has, in its pixels from the lower left: side by side, or one above the other. */
  part(index) {
    const { width, height } = this.canvas;
    const count = this.sides.length;
    if (!this.isStacked) {
      const from = Math.round((index * width) / count);
      return { x: from, y: 0, width: Math.round(((index + 1) * width) / count) - from, height };
    }
    const from = Math.round(((count - 1 - index) * height) / count);
    return { x: 0, y: from, width, height: Math.round(((count - index) * height) / count) - from };
  }

  /** Fewer pixels where pictures take too long, more where there is time. */
  #settle(now) {
    const took = now - (this.last ?? now);
    this.last = now;
    this.pace = 0.9 * this.pace + 0.1 * Math.min(took, 200);
    if (now - this.changed < 1500) return;
    const better = this.pace > 45 ? this.detail * 0.7 : this.pace < 20 ? this.detail * 1.2 : this.detail;
    const within = Math.max(0.4, Math.min(1, better));
    if (within !== this.detail) Object.assign(this, { detail: within, changed: now });
  }

  fit() {
    const { canvas } = this;
    this.#settle(performance.now());
    const ratio = Math.min(window.devicePixelRatio || 1, 2) * this.detail;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((side) => Math.max(1, Math.round(side * ratio)));
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  }

  /** @param {Float32Array[]} positions of each side */
  draw(camera, positions) {
    const { gl, extent } = this;
    this.fit();
    positions.forEach((places, index) => this.sides[index]?.place(places));
    this.strain.follow(this.scene, positions);
    gl.disable(gl.SCISSOR_TEST);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.sides.forEach((side, index) => {
      const fromLight = this.shadows.aim(extent, this.light);
      this.shadows.begin();
      this.#things(side, fromLight, fromLight.halfPixel, true);
      this.shadows.end();
      const { x, y, width, height } = this.part(index);
      gl.viewport(x, y, width, height);
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(x, y, width, height);
      const sight = camera.see(width / height);
      gl.enable(gl.BLEND);
      this.#planes(camera, sight, fromLight);
      this.#things(side, sight, Math.tan(sight.angle / 2) / height, false);
      gl.disable(gl.BLEND);
    });
  }

  #things(side, { view, projection }, halfPixel, isShadow) {
    const { gl, looks, extent } = this;
    const inView = ([x, y, z]) => [0, 1, 2].map((row) => view[row] * x + view[4 + row] * y + view[8 + row] * z);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, side.texture);
    const common = {
      places: { int: 0 }, wide: { int: side.wide }, view, projection, halfPixel, fromLight: { int: isShadow ? 1 : 0 },
      light: inView(this.light), upward: inView(extent.up), sky: looks.sky, ground: looks.ground,
    };
    (isShadow ? this.springShadow : this.spring).use({
      ...common, radius: extent.rod, strainEnd: this.strain.end, squeezed: looks.squeezed, resting: looks.resting, stretched: looks.stretched,
    });
    side.drawRods();
    (isShadow ? this.ballShadow : this.ball).use({ ...common, radius: extent.ball, marked: { int: this.marked }, mark: looks.mark });
    side.drawBalls();
  }

  #planes(camera, sight, fromLight) {
    const { gl, looks } = this;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.shadows.texture);
    gl.bindVertexArray(this.square);
    for (const floor of this.floors) {
      // From behind, a plane only hints at itself.
      const isBehind = dot(subtract(camera.eye, floor.middle), floor.normal) < 0;
      gl.depthMask(!isBehind);
      this.plane.use({
        both: sight.both, toLight: fromLight.both, shadows: { int: 0 }, middle: floor.middle, along: floor.along, side: floor.side,
        others: floor.others, othersCount: floor.othersCount, origin: floor.origin, spacing: floor.spacing, even: looks.even, odd: looks.odd, shade: looks.shade, light: this.light,
        opacity: isBehind ? 0.12 : floor.isReal ? 1 : 0.75,
      });
      gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    }
    gl.depthMask(true);
  }

  /** The side at a place on the page, and where in it, −1 to 1 each way. */
  at(clientX, clientY) {
    const box = this.canvas.getBoundingClientRect();
    const ratio = this.canvas.width / box.width;
    const [px, py] = [(clientX - box.left) * ratio, (box.bottom - clientY) * ratio];
    for (let index = 0; index < this.sides.length; index++) {
      const { x, y, width, height } = this.part(index);
      if (px >= x && px < x + width && py >= y && py < y + height) {
        return { index, x: (2 * (px - x)) / width - 1, y: (2 * (py - y)) / height - 1, aspect: width / height, pixels: height / ratio };
      }
    }
    return undefined;
  }
}
