// What the tilted view paints, in buffers of the graphics card: only what has moved is sent there again.

/** @typedef {import('./space.js').Picture} Picture */
/** @typedef {import('./space.js').Solid} Solid */
/** @typedef {{ version: number, array: WebGLVertexArrayObject, vertices: WebGLBuffer, indices: WebGLBuffer | null, used: boolean }} Kept */

const CORNER = 28; // bytes of a vertex of triangles: point, normal, curvature
const POINT = 16; // bytes of a point of a line: point, length so far
const FLOAT = 5126; // as WebGL numbers it

export class Buffers {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {import('../engine/engine.js').Engine} engine whose memory the vertices are in
   * @param {{ sent: number, whole: number }} counts bytes sent, surfaces sent whole
   */
  constructor(gl, engine, counts) {
    this.gl = gl;
    this.engine = engine;
    this.counts = counts;
    /** @type {Map<string, Kept>} */
    this.kept = new Map();
  }

  /** What belongs to an item of a picture. @param {Solid} solid */
  array({ kind, id }) {
    return this.kept.get(`${kind} ${id}`)?.array ?? null;
  }

  /** Brings the buffers up to date. @param {NonNullable<Picture>} picture @param {boolean} [more] those of the last picture stay */
  keep(picture, more = false) {
    for (const one of this.kept.values()) {
      one.used = more;
    }
    for (const solid of picture.items) {
      const name = `${solid.kind} ${solid.id}`;
      const kept = this.kept.get(name) ?? this.#make(solid, name);
      kept.used = true;
      if (kept.version !== solid.version) {
        this.#sendAll(kept, solid);
      } else if (solid.kind === 0 && solid.moved[0] < solid.moved[1]) {
        this.#sendMoved(kept, solid);
      }
    }
    const { gl } = this;
    for (const [name, one] of this.kept) {
      if (!one.used) {
        gl.deleteVertexArray(one.array);
        gl.deleteBuffer(one.vertices);
        gl.deleteBuffer(one.indices);
        this.kept.delete(name);
      }
    }
  }

  /** @param {Solid} solid @param {string} name @returns {Kept} */
  #make(solid, name) {
    const { gl } = this;
    const array = /** @type {WebGLVertexArrayObject} */ (gl.createVertexArray());
    const vertices = /** @type {WebGLBuffer} */ (gl.createBuffer());
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, vertices);
    let indices = null;
    if (solid.kind === 0) {
      indices = gl.createBuffer();
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
      [[3, 0], [3, 12], [1, 24]].forEach(([size, offset], i) => {
        gl.enableVertexAttribArray(i);
        gl.vertexAttribPointer(i, size, FLOAT, false, CORNER, offset);
      });
    } else { // a quadrangle for each piece of the line, which also sees the pieces beside it
      for (let i = 0; i < 4; i++) {
        gl.enableVertexAttribArray(i);
        gl.vertexAttribPointer(i, 4, FLOAT, false, POINT, POINT * i);
        gl.vertexAttribDivisor(i, 1);
      }
    }
    const kept = { version: 0, array, vertices, indices, used: true };
    this.kept.set(name, kept);
    return kept;
  }

  /** @param {Kept} kept @param {Solid} solid */
  #sendAll(kept, solid) {
    const { gl } = this;
    const bytes = solid.rows * solid.columns * (solid.kind === 0 ? CORNER : POINT);
    gl.bindVertexArray(kept.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, kept.vertices);
    gl.bufferData(gl.ARRAY_BUFFER, new Uint8Array(this.engine.wasm.memory.buffer, solid.vertices, bytes), gl.DYNAMIC_DRAW);
    if (kept.indices) {
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, solid.indices, gl.STATIC_DRAW);
      this.counts.whole++;
    }
    kept.version = solid.version;
    this.counts.sent += bytes + solid.indices.byteLength;
  }

  /** Rows that moved are sent in one piece; of columns, the piece of each row. @param {Kept} kept @param {Solid} solid */
  #sendMoved(kept, { columns, moved: [row, end, first, last], vertices }) {
    const { gl } = this;
    const { buffer } = this.engine.wasm.memory;
    const whole = first === 0 && last === columns;
    gl.bindBuffer(gl.ARRAY_BUFFER, kept.vertices);
    for (let i = row; i < end; i += whole ? end - row : 1) {
      const from = CORNER * (i * columns + first);
      const bytes = CORNER * (last - first) * (whole ? end - row : 1);
      gl.bufferSubData(gl.ARRAY_BUFFER, from, new Uint8Array(buffer, vertices + from, bytes));
      this.counts.sent += bytes;
    }
  }
}
