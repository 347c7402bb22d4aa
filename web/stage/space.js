// The tilted view with a depth: WebGL 2, two programs, one for surfaces and one for lines. The engine owns all that is
// painted; here it is kept in buffers of the graphics card, and only what has moved is sent there again. Without WebGL 2
// the drawing stays on the still canvas, as lines.

import { stand } from '../page/build.js';
import { word } from '../page/words.js';
import { Buffers } from './buffers.js';
import { Legend } from './legend.js';
import { Pace } from './pace.js';
import { LINES, SURFACES } from './shaders.js';
import { TimeStrip } from './time.js';
import { warp } from './warp.js';

/** @typedef {import('../engine/types.js').Frame} Frame */
/** @typedef {ReturnType<Space['read']>} Picture */
/** @typedef {NonNullable<Picture>['items'][number]} Solid */

const LINE_LOOK = 4;
const OBJECT = 0x7fffffff; // of an id: without what says that the lines are the outline of a surface
const THINNEST = 0.75; // view pixels: as on the still canvas
const HIDDEN = { fainter: 0.4, thinner: 0.7 };
const RIM = { wider: 2.5, colour: 0x20242bb0 }; // px of both sides together

export class Space {
  /** @param {import('../main.js').Shell} shell */
  constructor(shell) {
    this.shell = shell;
    this.canvas = document.createElement('canvas');
    this.canvas.className = 'layer';
    this.canvas.id = 'space';
    this.canvas.ariaHidden = 'true';
    this.canvas.hidden = true;
    this.shown = '';
    this.docked = '';
    this.middle = [0, 0];
    this.time = new TimeStrip(shell);
    this.pace = new Pace(() => shell.wake());
    this.ratio = 1; // pixels of the canvas per view pixel
    this.clip = '';
    /** For tests and measurements: pictures painted, bytes sent. */
    this.counts = { painted: 0, sent: 0, whole: 0 };
    shell.painter.warp = warp;
    this.#switch();
    this.gl = this.canvas.getContext('webgl2', { antialias: true, alpha: true, premultipliedAlpha: true });
    if (!this.gl) {
      shell.notices.say(word('shell.no-depth'));
      return;
    }
    this.canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault(); // it may be restored
      this.#leave();
      shell.wake();
    });
    this.canvas.addEventListener('webglcontextrestored', () => {
      this.#prepare();
      shell.wake();
    });
    this.#prepare();
    shell.painter.still.after(this.canvas);
    this.legend = new Legend(shell);
  }

  /** Programs and buffers, for a new context. */
  #prepare() {
    const gl = /** @type {WebGL2RenderingContext} */ (this.gl);
    const constants = this.shell.engine.guard(() => this.shell.engine.string(this.shell.engine.wasm.space_constants()), '');
    this.buffers = new Buffers(gl, this.shell.engine, this.counts);
    this.shown = '';
    this.docked = '';
    this.surfaces = this.#program(SURFACES.vertex, constants + SURFACES.fragment);
    this.lines = this.#program(LINES.vertex, LINES.fragment);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.polygonOffset(1.5, 1);
  }

  /** @param {string} vertex @param {string} fragment */
  #program(vertex, fragment) {
    const gl = /** @type {WebGL2RenderingContext} */ (this.gl);
    const program = /** @type {WebGLProgram} */ (gl.createProgram());
    for (const [type, text] of /** @type {[number, string][]} */ ([[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]])) {
      const shader = /** @type {WebGLShader} */ (gl.createShader(type));
      gl.shaderSource(shader, `#version 300 es\nprecision highp float;\n${text}`);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
      const shaders = gl.getAttachedShaders(program) ?? [];
      throw new Error([gl.getProgramInfoLog(program), ...shaders.map((shader) => gl.getShaderInfoLog(shader))].join('\n'));
    }
    /** @type {Record<string, WebGLUniformLocation | null>} */
    const at = {};
    for (let i = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) - 1; i >= 0; i--) {
      const { name } = /** @type {WebGLActiveInfo} */ (gl.getActiveUniform(program, i));
      at[name] = gl.getUniformLocation(program, name);
    }
    return { program, at };
  }

  /** Beside the dial: perspective or not. */
  #switch() {
    const { engine, wake } = this.shell;
    this.deep = document.createElement('button');
    this.deep.type = 'button';
    this.deep.className = 'deep';
    this.deep.dataset.command = 'perspective';
    this.deep.hidden = true;
    this.deep.innerHTML = '<svg viewBox="0 0 24 24" aria-hidden="true"><path d="M2 19h20L16 6H8zM12 6v13M5.5 12h13"/></svg>';
    this.deep.addEventListener('click', () => {
      engine.command('perspective');
      wake();
    });
    void stand(this.deep, 'styles/space.css', this.shell);
  }

  /** @param {Frame} frame */
  #tellDeep({ tilt }) {
    const button = /** @type {HTMLButtonElement} */ (this.deep);
    button.hidden = !tilt;
    if (tilt) {
      button.ariaPressed = String(this.shell.engine.get('perspective') !== 0);
      button.title = button.ariaLabel = word('command.perspective');
    }
  }

  /** The drawing is painted as lines, on the still canvas. */
  #leave() {
    const { painter } = this.shell;
    this.shown = '';
    this.canvas.hidden = true;
    this.legend?.hide();
    if (painter.flat) {
      painter.flat = false;
      painter.retheme();
      return true;
    }
    return false;
  }

  /**
   * Paints a tilted view. Called before the still canvas is painted, which then leaves lines and surfaces out.
   * @param {Frame} frame @param {number} waited milliseconds since it was asked for
   */
  show(frame, waited) {
    const { painter } = this.shell;
    this.#tellDeep(frame);
    this.time.show(frame);
    if (!this.gl || this.gl.isContextLost()) {
      return;
    }
    const picture = frame.tilt || this.time.move.through ? this.read() : null;
    this.#size(picture, waited);
    if (!picture) {
      this.#leave();
      this.#paintLens(false);
      return;
    }
    if (!painter.flat) {
      painter.flat = true;
      painter.retheme();
    }
    this.canvas.hidden = false;
    this.buffers?.keep(picture);
    this.#paintLens(true);
    const shown = this.#look(picture);
    if (shown !== this.shown || picture.items.some(({ kind, moved }) => kind === 0 && moved[0] < moved[1])) {
      this.shown = shown;
      this.#paint(picture, this.canvas);
    }
    this.legend?.show(picture);
    if (picture.waits) {
      this.shell.wake();
    }
  }

  /** As large as the still canvas, or coarser while a heavy picture moves. @param {Picture} picture @param {number} waited */
  #size(picture, waited) {
    const { still, ratio } = this.shell.painter;
    const clip = picture ? picture.clip.join() : '';
    if (clip && this.clip && clip !== this.clip && this.time.lens.box.hidden) {
      this.pace.moved(performance.now(), waited);
    }
    this.clip = clip;
    const [width, height] = [still.width, still.height].map((side) => Math.max(1, Math.round(side * this.pace.share)));
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
      this.shown = '';
    }
    this.ratio = ratio * this.pace.share;
  }

  /** What tells two pictures apart, but for what moved within surfaces. @param {NonNullable<Picture>} picture */
  #look({ look, clip, items }) {
    return [look, this.ratio, this.shell.theme.turned, ...clip,
      ...items.map(({ id, kind, version, colour, opacity, width, cap }) => [id, kind, version, colour, opacity, width, cap])].join();
  }

  /**
   * The docked view, if it is seen: painted before the room, in the same canvas, and taken from there.
   * @param {boolean} more whether the buffers of another picture are to be kept
   */
  #paintLens(more) {
    const { lens } = this.time;
    const { width, height, wide, tall } = lens.size;
    if (lens.box.hidden || !width || !height || height > this.canvas.height || width > this.canvas.width) {
      this.docked = '';
      return;
    }
    const { engine } = this.shell;
    const picture = this.read(engine.guard(() => engine.wasm.editor_lens(engine.editor, wide, tall), 0));
    if (!picture) {
      return;
    }
    this.buffers?.keep(picture, more);
    const docked = [width, height, this.#look(picture)].join();
    if (docked === this.docked && !picture.items.some(({ kind, moved }) => kind === 0 && moved[0] < moved[1])) {
      return;
    }
    this.docked = docked;
    this.#paint(picture, lens.size);
    lens.copy(this.canvas);
    this.shown = ''; // the room is to be painted over it
  }

  /** What the engine has to paint. The vertices and indices of its items are in the engine's memory, valid until the next call. */
  read(at = this.shell.engine.guard(() => this.shell.engine.wasm.editor_space(this.shell.engine.editor), 0)) {
    const { engine } = this.shell;
    if (!at) {
      return null;
    }
    const { layout } = engine;
    const view = engine.view();
    const buffer = engine.wasm.memory.buffer;
    const place = (/** @type {number} */ base, /** @type {string} */ name) => base + layout[name];
    const word32 = (/** @type {number} */ base, /** @type {string} */ name) => view.getUint32(place(base, name), true);
    const single = (/** @type {number} */ base, /** @type {string} */ name) => view.getFloat32(place(base, name), true);
    const first = word32(at, 'space.items');
    return {
      clip: new Float32Array(buffer, place(at, 'space.clip'), 16).slice(),
      eye: new Float32Array(buffer, place(at, 'space.eye'), 16).slice(),
      before: new Float32Array(buffer, place(at, 'space.before'), 2).slice(),
      scale: single(at, 'space.scale'),
      perspective: word32(at, 'space.perspective'),
      look: word32(at, 'space.look'),
      range: view.getFloat64(place(at, 'space.range'), true),
      legend: [...new Uint32Array(buffer, place(at, 'space.legend'), 3)],
      waits: word32(at, 'space.waits'),
      items: Array.from({ length: word32(at, 'space.count') }, (_, i) => {
        const item = first + i * layout['solid.size'];
        const get = (/** @type {string} */ name) => word32(item, `solid.${name}`);
        return {
          id: get('id'),
          version: get('version'),
          kind: get('kind'),
          colour: get('colour'),
          width: single(item, 'solid.width'),
          opacity: single(item, 'solid.opacity'),
          cap: get('cap'),
          rows: get('rows'),
          columns: get('columns'),
          count: get('index_count'),
          indices: new Uint32Array(buffer, get('indices'), get('index_count')),
          vertices: get('vertices'),
          moved: [...new Uint32Array(buffer, place(item, 'solid.moved'), 4)],
        };
      }),
    };
  }

  /** @param {NonNullable<Picture>} picture @param {{ width: number, height: number }} size in pixels of the canvas */
  #paint(picture, size) {
    const gl = /** @type {WebGL2RenderingContext} */ (this.gl);
    this.middle = [size.width / 2, size.height / 2];
    gl.viewport(0, 0, size.width, size.height);
    gl.depthMask(true);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const solid = picture.items.filter(({ kind }) => kind === 0);
    const opaque = solid.filter(({ opacity }) => opacity >= 1);
    const lines = picture.items.filter(({ kind }) => kind === 1);
    const paper = picture.look === LINE_LOOK; // only hides what is behind it
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.colorMask(!paper, !paper, !paper, !paper);
    this.#paintSurfaces(picture, paper ? solid : opaque);
    gl.colorMask(true, true, true, true);
    gl.disable(gl.POLYGON_OFFSET_FILL);
    gl.depthMask(false);
    gl.depthFunc(gl.GREATER);
    // Shaded surfaces are light in both themes: what is seen on them or through them has the ink of paper, and a light
    // line that passes before them a dark rim.
    const edged = new Set(paper ? [] : solid.filter(({ colour }) => !colour).map(({ id }) => id));
    const over = (/** @type {Solid} */ { id }) => edged.has(id & OBJECT);
    this.#paintLines(picture, lines, true, edged.size ? () => true : over);
    gl.depthFunc(gl.LEQUAL);
    if (edged.size && this.shell.theme.turned) {
      this.#paintLines(picture, lines.filter((line) => !over(line) && this.#light(line)), false, over, RIM);
    }
    this.#paintLines(picture, lines, false, over);
    if (!paper) {
      this.#paintSurfaces(picture, solid.filter((one) => !opaque.includes(one)));
    }
    gl.bindVertexArray(null);
    this.counts.painted++;
  }

  /** Whether a line is too light to be read on a surface. @param {Solid} line */
  #light({ colour }) {
    const [red, green, blue] = this.#colour(colour, 1);
    return 0.3 * red + 0.59 * green + 0.11 * blue > 0.5;
  }

  /** A colour of the drawing as paper shows it. @param {number} rgba @param {number} opacity */
  #ink(rgba, opacity) {
    return [rgba >>> 24, (rgba >>> 16) & 255, (rgba >>> 8) & 255].map((value) => value / 255).concat(((rgba & 255) / 255) * opacity);
  }

  /** A colour of the drawing as the theme shows it. @param {number} rgba @param {number} opacity */
  #colour(rgba, opacity) {
    const [red, green, blue, alpha] = (this.shell.theme.colour(rgba).match(/[\d.]+/g) ?? []).map(Number);
    return [red / 255, green / 255, blue / 255, alpha * opacity];
  }

  /** @param {NonNullable<Picture>} picture @param {Solid[]} solids */
  #paintSurfaces({ clip, eye, perspective, look, range }, solids) {
    const gl = /** @type {WebGL2RenderingContext} */ (this.gl);
    const { program, at } = /** @type {NonNullable<typeof this.surfaces>} */ (this.surfaces);
    gl.useProgram(program);
    gl.uniformMatrix4fv(at.clip, false, clip);
    gl.uniformMatrix4fv(at.eye, false, eye);
    gl.uniform1f(at.deep, perspective);
    gl.uniform1i(at.look, look);
    gl.uniform1f(at.range, range);
    for (const solid of solids) {
      const { colour, opacity, count } = solid;
      gl.uniform4fv(at.colour, colour ? this.#colour(colour, opacity) : [-1, 0, 0, opacity]);
      gl.bindVertexArray(this.buffers?.array(solid) ?? null);
      gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
    }
  }

  /**
   * @param {NonNullable<Picture>} picture
   * @param {Solid[]} lines
   * @param {boolean} hidden the parts that are
   * @param {(line: Solid) => boolean} inked which ones have the ink of paper
   * @param {{ wider: number, colour: number } | null} rim in place of the lines: what stands out behind them
   */
  #paintLines({ clip, before, scale }, lines, hidden, inked, rim = null) {
    const gl = /** @type {WebGL2RenderingContext} */ (this.gl);
    const { ratio } = this;
    const { program, at } = /** @type {NonNullable<typeof this.lines>} */ (this.lines);
    gl.useProgram(program);
    gl.uniformMatrix4fv(at.clip, false, clip);
    gl.uniform2fv(at.before, before);
    gl.uniform2fv(at.middle, this.middle);
    gl.uniform1f(at.dash, hidden ? scale / 11 : 0);
    for (const line of lines) {
      const { colour, opacity, width, cap, rows } = line;
      const faint = opacity * (hidden ? HIDDEN.fainter : 1);
      gl.uniform1i(at.cap, cap);
      gl.uniform4fv(at.colour, rim || inked(line) ? this.#ink(rim?.colour ?? colour, faint) : this.#colour(colour, faint));
      gl.uniform1f(at.wide, (Math.max(width, THINNEST) + (rim?.wider ?? 0)) * ratio * 0.5 * (hidden ? HIDDEN.thinner : 1));
      gl.bindVertexArray(this.buffers?.array(line) ?? null);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, rows - 3);
    }
  }
}
