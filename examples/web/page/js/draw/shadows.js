// A picture of depths, from where the light is.

import { add, lookAt, multiply, orthographic, scale } from "./matrices.js";

const SIDE = 1024;

export class Shadows {
  constructor(gl) {
    this.gl = gl;
    this.texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, SIDE, SIDE);
    const set = (name, value) => gl.texParameteri(gl.TEXTURE_2D, name, value);
    set(gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    set(gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    set(gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    set(gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    set(gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
    set(gl.TEXTURE_COMPARE_FUNC, gl.LEQUAL);
    this.frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, this.texture, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /** The light that shines from `towards` on everything within a ball. */
  aim({ middle, radius, up }, towards) {
    const wide = 1.9 * radius;
    const view = lookAt(add(middle, scale(towards, 4 * radius)), middle, up);
    const projection = orthographic(wide, 0.1 * radius, 9 * radius);
    return { view, projection, both: multiply(projection, view), halfPixel: (1.2 * wide) / SIDE };
  }

  begin() {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    gl.viewport(0, 0, SIDE, SIDE);
    gl.disable(gl.SCISSOR_TEST);
    gl.clear(gl.DEPTH_BUFFER_BIT);
  }

  end() {
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, null);
  }
}
