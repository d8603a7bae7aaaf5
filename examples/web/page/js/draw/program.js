// A program for the graphics card, with its uniforms by name.

function shader(gl, kind, text) {
  const made = gl.createShader(kind);
  gl.shaderSource(made, text);
  gl.compileShader(made);
  if (!gl.getShaderParameter(made, gl.COMPILE_STATUS) && !gl.isContextLost()) {
    throw new Error(`a shader does not compile: ${gl.getShaderInfoLog(made)}`);
  }
  return made;
}

export class Program {
  #gl;
  #program;
  #places = new Map();

  constructor(gl, vertex, fragment) {
    this.#gl = gl;
    this.#program = gl.createProgram();
    gl.attachShader(this.#program, shader(gl, gl.VERTEX_SHADER, vertex));
    gl.attachShader(this.#program, shader(gl, gl.FRAGMENT_SHADER, fragment));
    // The same places everywhere, so that any program draws any array.
    ["corner", "ends", "rest", "look"].forEach((name, index) => gl.bindAttribLocation(this.#program, index, name));
    gl.linkProgram(this.#program);
    if (!gl.getProgramParameter(this.#program, gl.LINK_STATUS) && !gl.isContextLost()) {
      throw new Error(`a program does not link: ${gl.getProgramInfoLog(this.#program)}`);
    }
  }

  /**
   * Uses it, with these uniforms: an integer as `{ int: 3 }`, a float as 0.5, an array of
   * four-vectors as `{ fours }`, vectors and matrices as arrays.
   */
  use(uniforms) {
    const gl = this.#gl;
    gl.useProgram(this.#program);
    for (const [name, value] of Object.entries(uniforms)) {
      if (!this.#places.has(name)) this.#places.set(name, gl.getUniformLocation(this.#program, name));
      const place = this.#places.get(name);
      if (place === null) continue;
      if (typeof value === "number") gl.uniform1f(place, value);
      else if (value.int !== undefined) gl.uniform1i(place, value.int);
      else if (value.fours !== undefined) gl.uniform4fv(place, value.fours);
      else if (value.length === 2) gl.uniform2fv(place, value);
      else if (value.length === 3) gl.uniform3fv(place, value);
      else gl.uniformMatrix4fv(place, false, value);
    }
  }
}

export const CORNER = 0, ENDS = 1, REST = 2, LOOK = 3;
