// Painting: a still canvas for the drawing and an overlay canvas for what is under the pen. The still canvas is
// repainted only where the drawing changed. When the view of a heavy drawing moves, the painted canvas is moved at
// once and repainted when the hand rests.

import { Cap, Flag, Join, Role, names } from '../engine/codes.js';
import { isPage, isWhole } from '../engine/frame.js';
import { boxOf, paintShape, shapedOf, shapeOf } from './shape.js';

/** @typedef {import('../engine/types.js').Frame} Frame */
/** @typedef {import('../engine/types.js').Item} Item */
/** @typedef {import('./theme.js').Theme} Theme */
/** @typedef {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D} Context */
/** @typedef {{ x: number, y: number, zoom: number, angle: number, originX: number, originY: number }} View */
/** @typedef {import('./shape.js').Look} Look */
/** heavy: the path itself, of which the shape is only the box. @typedef {{ version: number, shape: Path2D, heavy: Float32Array | null }} Shaped */
/** @typedef {{ item: Item, shape: Path2D, heavy: Float32Array | null, weight: number, corners: Float32Array }} Painted */

const FADE = 0.75; // opacity of the paper colour over a line that is about to change
const RULER_FONT = '10px "Batten-Inter", system-ui, sans-serif';
const LABEL_FONT = '500 13px "Batten-Inter", system-ui, sans-serif';

const CAPS = /** @type {CanvasLineCap[]} */ (names(Cap));
const JOINS = /** @type {CanvasLineJoin[]} */ (names(Join));

/** Numbers in paths that can be painted within a frame; a heavier view is moved first and repainted when idle. */
const LIGHT = 15000;
/** Numbers of a path that is not drawn over the drawing in every frame: its box is. */
const HEAVIEST = 200000;
const IDLE = 90; // milliseconds without a move
const HAIRLINE = 0.75; // view pixels: thinner lines are painted this wide, so that they stay visible

/**
 * The matrix from coordinates relative to the origin to device pixels, `ratio` per view pixel.
 * @param {View} view @param {number} ratio
 */
function matrixOf(view, ratio) {
  return new DOMMatrix().scale(view.zoom * ratio).rotate(view.angle)
    .translate(view.originX - view.x, view.originY - view.y);
}

/**
 * The axis-aligned bounds of a box transformed by the matrix.
 * @param {DOMMatrix} matrix @param {number[]} box x0 y0 x1 y1
 */
function around(matrix, [x0, y0, x1, y1]) {
  const corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(([x, y]) => matrix.transformPoint({ x, y }));
  const xs = corners.map((corner) => corner.x);
  const ys = corners.map((corner) => corner.y);
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

export class Painter {
  /**
   * @param {HTMLCanvasElement} still
   * @param {HTMLCanvasElement} overlay
   * @param {Theme} theme
   */
  constructor(still, overlay, theme) {
    this.still = still;
    this.overlay = overlay;
    this.theme = theme;
    this.stillContext = /** @type {CanvasRenderingContext2D} */ (still.getContext('2d'));
    this.overlayContext = /** @type {CanvasRenderingContext2D} */ (overlay.getContext('2d', { desynchronized: true }));
    this.width = 1;
    this.height = 1;
    this.ratio = 1;
    /** @type {Map<number, Shaped>} */
    this.cache = new Map();
    /** @type {Painted[]} */
    this.list = [];
    /** The view that the still canvas shows; null: nothing yet. @type {View | null} */
    this.painted = null;
    /** Pictures by number; null: still being decoded, or not decodable. @type {Map<number, ImageBitmap | HTMLImageElement | null>} */
    this.pictures = new Map();
    /** Called when a picture is needed that has not been decoded. @type {(picture: number) => void} */
    this.onpicture = () => {};
    this.overlayEmpty = true;
    this.stale = true;
    /** Only the page, fills and pictures are painted here; the rest has a depth (space.js). */
    this.flat = false;
    /** Paints a picture in perspective. @type {typeof import('./warp.js').warp | undefined} */
    this.warp = undefined;
    /** Paints objects with gradients, layers and pictures; null: being fetched. @type {typeof import('./gradients.js') | null | undefined} */
    this.paints = undefined;
    /** Paints paths that take long; null: being fetched. @type {import('./heavy.js').Heavy | null | undefined} */
    this.heavy = undefined;
    /** Called when a path takes too long to paint. */
    this.onlate = () => {};
    this.timer = 0;
    /** Requests another frame. */
    this.onidle = () => {};
    this.unseen = -1; // the id of the text that is being typed
    /** Counts for tests and measurements. */
    this.counts = { full: 0, part: 0, moved: 0 };
  }

  /**
   * @param {number} width view pixels
   * @param {number} height
   * @param {number} ratio
   */
  resize(width, height, ratio) {
    this.width = width;
    this.height = height;
    this.ratio = ratio;
    for (const canvas of [this.still, this.overlay]) {
      canvas.width = Math.max(1, Math.round(width * ratio));
      canvas.height = Math.max(1, Math.round(height * ratio));
    }
    this.stale = true;
    this.overlayEmpty = true;
  }

  /** Called when the theme's colours have changed. */
  retheme() {
    this.stale = true;
  }

  /** @param {Frame} frame */
  paint(frame) {
    if (frame.stillChanged) {
      this.#collect(frame.still);
    }
    this.#paintStill(frame);
    this.#paintOverlay(frame);
  }

  /** @param {Item[]} items */
  #collect(items) {
    /** @type {Map<number, Shaped>} */
    const kept = new Map();
    this.list = items.map((item) => {
      const known = this.cache.get(item.id);
      const { shape, heavy } = item.id !== 0 && known?.version === item.version ? known : shapedOf(item);
      if (item.id !== 0) {
        kept.set(item.id, { version: item.version, shape, heavy });
      }
      const corners = item.role === Role.IMAGE || item.role === Role.CLIP ? item.path.slice() : item.path;
      return { item, shape, heavy, weight: item.path.length, corners };
    });
    this.cache = kept;
    this.heavy?.keep(new Set(kept.keys()));
  }

  /** @param {Frame} frame */
  #paintStill(frame) {
    const dirty = frame.dirty[0] <= frame.dirty[2] && frame.dirty[1] <= frame.dirty[3];
    const was = this.painted;
    const moved = !was || was.x !== frame.x || was.y !== frame.y || was.zoom !== frame.zoom ||
      was.angle !== frame.angle || was.originX !== frame.originX || was.originY !== frame.originY;
    if (!moved && !this.stale) {
      if (dirty) {
        this.#repaint(frame, frame.dirty);
      }
      return;
    }
    if (was && !this.stale && !dirty && this.#weight(frame) > LIGHT) {
      this.#moveLayer(was, frame);
      return;
    }
    this.#repaint(frame, null);
  }

  /** The amount to paint: how many numbers are in the visible paths. @param {View} view */
  #weight(view) {
    const [x0, y0, x1, y1] = around(matrixOf(view, 1).inverse(), [0, 0, this.width, this.height]);
    let weight = 0;
    for (const { item, weight: numbers } of this.list) {
      if (item.x1 >= x0 && item.x0 <= x1 && item.y1 >= y0 && item.y0 <= y1) {
        weight += numbers;
      }
    }
    return weight;
  }

  /** Shows the painted canvas moved to the current view. @param {View} was @param {View} now */
  #moveLayer(was, now) {
    const { originX, originY } = now;
    this.still.style.transform = String(matrixOf(now, 1).multiply(matrixOf({ ...was, originX, originY }, 1).inverse()));
    this.counts.moved++;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      this.stale = true;
      this.onidle();
    }, IDLE);
  }

  /**
   * Repaints what lies in the box (relative to the origin), or everything.
   * @param {Frame} frame
   * @param {[number, number, number, number] | null} box
   */
  #repaint(frame, box) {
    const context = this.stillContext;
    const { width, height } = this.still;
    const matrix = matrixOf(frame, this.ratio);
    let [x0, y0, x1, y1] = [0, 0, width, height];
    if (box) {
      // Rounded out to device pixels plus one, so that no partly covered seam remains.
      const [left, top, right, bottom] = around(matrix, box);
      x0 = Math.max(0, Math.floor(left) - 2);
      y0 = Math.max(0, Math.floor(top) - 2);
      x1 = Math.min(width, Math.ceil(right) + 2);
      y1 = Math.min(height, Math.ceil(bottom) + 2);
      this.counts.part++;
    } else {
      clearTimeout(this.timer);
      this.still.style.transform = '';
      this.stale = false;
      const { x, y, zoom, angle, originX, originY } = frame;
      this.painted = { x, y, zoom, angle, originX, originY };
      this.counts.full++;
    }
    if (x0 >= x1 || y0 >= y1) {
      return;
    }
    context.save();
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.beginPath();
    context.rect(x0, y0, x1 - x0, y1 - y0);
    context.clip();
    context.clearRect(x0, y0, x1 - x0, y1 - y0);
    context.setTransform(matrix);
    const [left, top, right, bottom] = around(matrix.inverse(), [x0 - 2, y0 - 2, x1 + 2, y1 + 2]);
    this.#paintItems(context, 0, this.list.length, [left, top, right, bottom], frame.zoom);
    context.restore();
  }

  /**
   * Paints those of a stretch of the list that reach into the box (relative to the origin).
   * @param {Context} context @param {number} from @param {number} to @param {number[]} box @param {number} zoom
   */
  #paintItems(context, from, to, box, zoom) {
    const [left, top, right, bottom] = box;
    for (let i = from; i < to; i++) {
      const { item, shape, heavy, corners } = this.list[i];
      const first = i + 1; // of those held
      const held = item.role === Role.CLIP || item.role === Role.GROUP ? item.picture : 0;
      if (item.x1 < left || item.x0 > right || item.y1 < top || item.y0 > bottom) {
        i += held;
      } else if (item.role === Role.CLIP && item.fill) {
        this.#fetched()?.drawMasked(this, context, item, corners, box, zoom, (layer) => this.#paintItems(layer, first, first + held, box, zoom));
        i += held;
      } else if (item.role === Role.CLIP) {
        context.save();
        context.clip(shape, item.flags & Flag.EVEN_ODD ? 'evenodd' : 'nonzero');
        this.#paintItems(context, first, first + held, box, zoom);
        context.restore();
        i += held;
      } else if (held) {
        if (this.#fetched()) {
          this.paints?.drawLayer(context, item, box, (layer) => this.#paintItems(layer, first, first + held, box, zoom));
          i += held;
        }
      } else if (item.role === Role.IMAGE) {
        this.#drawPicture(context, item, corners, zoom);
      } else if (heavy) {
        this.#heavily()?.draw(context, item, heavy, this.#look(item, zoom));
      } else if ((item.paint || (item.opacity < 1 && isWhole(item))) && this.#fetched()) {
        this.paints?.drawPainted(context, item, shape, zoom, this.theme, this.flat);
      } else {
        paintShape(context, shape, this.#look(item, zoom));
      }
    }
  }

  /** What paints gradients and layers; null: it is being fetched. */
  #fetched() {
    if (this.paints === undefined) {
      this.paints = null;
      void import('./gradients.js').then((paints) => {
        this.paints = paints;
        paints.takeTilesFrom(this);
        this.stale = true;
        this.onidle();
      });
    }
    return this.paints;
  }

  /** @param {Context} context @param {Item} item @param {Float32Array} path @param {number} zoom */
  #drawPicture(context, item, path, zoom) {
    const bitmap = this.#fetched()?.pictureOf(this, item.picture);
    if (bitmap && item.id !== this.unseen) {
      this.paints?.drawPicture(context, item, path, bitmap, zoom, this.warp);
    }
  }

  /** @param {Frame} frame */
  #paintOverlay(frame) {
    const context = this.overlayContext;
    if (!this.overlayEmpty) {
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.clearRect(0, 0, this.overlay.width, this.overlay.height);
    }
    this.overlayEmpty = frame.live.length === 0 && frame.labels.length === 0;
    context.setTransform(matrixOf(frame, this.ratio));
    for (const item of frame.live) {
      const shape = item.path.length > HEAVIEST ? boxOf(item) : shapeOf(item.path);
      if (item.role === Role.STRETCH) {
        this.#fade(context, item, shape, frame.zoom);
      } else {
        paintShape(context, shape, this.#look(item, frame.zoom));
      }
    }
    this.#write(context, frame);
  }

  /**
   * Fades a line that is about to change, leaving a thin line for comparison.
   * @param {CanvasRenderingContext2D} context
   * @param {Item} item
   * @param {Path2D} shape
   * @param {number} zoom
   */
  #fade(context, item, shape, zoom) {
    const paged = isPage(this.list[0]?.item);
    context.setLineDash([]);
    context.lineJoin = 'round';
    context.lineCap = 'butt';
    context.lineWidth = item.width / zoom;
    context.strokeStyle = paged ? this.theme.paper : this.theme.ground;
    context.globalAlpha = FADE;
    context.stroke(shape);
    context.lineWidth = 1 / zoom;
    context.strokeStyle = this.theme.roles[Role.STRETCH].stroke;
    context.globalAlpha = 1;
    context.stroke(shape);
  }

  /**
   * Writes the labels, in view pixels, readable over anything.
   * @param {CanvasRenderingContext2D} context
   * @param {Frame} frame
   */
  #write(context, frame) {
    context.globalAlpha = 1;
    context.textBaseline = 'middle';
    context.textAlign = 'center';
    context.lineJoin = 'round';
    context.lineWidth = 4;
    context.setLineDash([]);
    const matrix = matrixOf(frame, 1);
    for (const label of frame.labels) {
      const look = this.theme.roles[label.role] ?? this.theme.roles[1];
      const at = matrix.transformPoint(label);
      context.font = label.role === Role.RULER ? RULER_FONT : LABEL_FONT;
      context.setTransform(new DOMMatrix().scale(this.ratio).translate(at.x + label.dx, at.y + label.dy).rotate(label.turn));
      if (label.role !== Role.RULER) {
        context.strokeStyle = look.fill;
        context.strokeText(label.text, 0, 0);
      }
      context.fillStyle = look.stroke;
      context.fillText(label.text, 0, 0);
    }
  }

  /** What paints heavy paths; null: it is being fetched. */
  #heavily() {
    if (this.heavy === undefined) {
      this.heavy = null;
      const ready = () => {
        this.stale = true;
        this.onidle();
      };
      void import('./heavy.js').then(({ Heavy }) => {
        this.heavy = new Heavy(ready, this.onlate);
        ready();
      });
    }
    return this.heavy;
  }

  /** @param {Item} item @param {number} zoom @returns {Look} */
  #look(item, zoom) {
    const own = item.role === Role.OBJECT || item.stroke > 0; // a line that is being drawn
    const role = this.theme.roles[item.role] ?? this.theme.roles[1];
    // The page is always filled, whatever the engine's flags for its border say.
    const filled = item.flags & Flag.FILLED || isPage(item);
    const stroked = item.flags & Flag.STROKED && !(own && item.id && this.flat);
    const width = item.flags & Flag.SCREEN_WIDTH ? item.width / zoom : item.width;
    return {
      fill: filled ? own ? this.theme.colour(item.fill) : role.fill : '',
      rule: item.flags & Flag.EVEN_ODD ? 'evenodd' : 'nonzero',
      stroke: stroked ? own ? this.theme.colour(item.stroke) : role.stroke : '',
      width: Math.max(width, HAIRLINE / zoom),
      cap: CAPS[item.cap] ?? 'round',
      join: JOINS[item.join] ?? 'round',
      miter: item.miterLimit > 0 ? item.miterLimit : 4,
      dashes: item.flags & Flag.DASHED ? [6 / zoom, 5 / zoom] : [],
      opacity: item.opacity,
    };
  }
}
