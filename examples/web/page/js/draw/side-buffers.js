// What the graphics card keeps of one side: the places of its particles, and what never changes about it.

import { CORNER, ENDS, LOOK, REST } from "./program.js";

const WIDEST = 2048;

export class SideBuffers {
  constructor(gl, scene, looks) {
    this.gl = gl;
    this.particles = scene.particles;
    this.springs = scene.springs;
    this.wide = Math.max(1, Math.min(WIDEST, scene.particles));
    const rows = Math.max(1, Math.ceil(scene.particles / this.wide));
    this.texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGB32F, this.wide, rows);
    for (const [name, value] of [["MIN_FILTER", "NEAREST"], ["MAG_FILTER", "NEAREST"], ["WRAP_S", "CLAMP_TO_EDGE"], ["WRAP_T", "CLAMP_TO_EDGE"]]) {
      gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${name}`], gl[value]);
    }

    this.looks = this.#array(looks);
    const ends = this.#array(scene.between);
    const rests = this.#array(Float32Array.from(scene.restLength));
    const rod = this.#array(new Float32Array([0, -1, 1, -1, 0, 1, 1, 1]));
    const disc = this.#array(new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]));

    this.rods = gl.createVertexArray();
    gl.bindVertexArray(this.rods);
    this.#attribute(rod, CORNER, 2, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, ends);
    gl.enableVertexAttribArray(ENDS);
    gl.vertexAttribIPointer(ENDS, 2, gl.UNSIGNED_INT, 0, 0);
    gl.vertexAttribDivisor(ENDS, 1);
    this.#attribute(rests, REST, 1, 1);

    this.balls = gl.createVertexArray();
    gl.bindVertexArray(this.balls);
    this.#attribute(disc, CORNER, 2, 0);
    this.#attribute(this.looks, LOOK, 4, 1);
    gl.bindVertexArray(null);
    this.buffers = [this.looks, ends, rests, rod, disc];
  }

  #array(content) {
    const { gl } = this;
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, content, gl.STATIC_DRAW);
    return buffer;
  }

  #attribute(buffer, index, size, divisor) {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(index);
    gl.vertexAttribPointer(index, size, gl.FLOAT, false, 0, 0);
    gl.vertexAttribDivisor(index, divisor);
  }

  /** New colours and sizes. */
  paint(looks) {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.looks);
    gl.bufferData(gl.ARRAY_BUFFER, looks, gl.STATIC_DRAW);
  }

  /** Takes the positions straight from a world's memory. */
  place(positions) {
    const { gl, wide, particles } = this;
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    const rows = Math.floor(particles / wide);
    const rest = particles - rows * wide;
    if (rows > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, wide, rows, gl.RGB, gl.FLOAT, positions);
    if (rest > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, rows, rest, 1, gl.RGB, gl.FLOAT, positions, rows * wide * 3);
  }

  drawRods() {
    if (this.springs === 0) return;
    this.gl.bindVertexArray(this.rods);
    this.gl.drawArraysInstanced(this.gl.TRIANGLE_STRIP, 0, 4, this.springs);
  }

  drawBalls() {
    if (this.particles === 0) return;
    this.gl.bindVertexArray(this.balls);
    this.gl.drawArraysInstanced(this.gl.TRIANGLE_STRIP, 0, 4, this.particles);
  }

  free() {
    const { gl } = this;
    gl.deleteTexture(this.texture);
    this.buffers.forEach((buffer) => gl.deleteBuffer(buffer));
    gl.deleteVertexArray(this.rods);
    gl.deleteVertexArray(this.balls);
  }
}
