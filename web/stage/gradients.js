// Painting objects with gradients, dashes and uneven pens, those that are translucent as a whole, and pictures. Fetched with a
// drawing's first such object.

import { Cap, Flag, Join, names } from '../engine/codes.js';

/** @typedef {import('../engine/types.js').Item} Item */
/** @typedef {import('./theme.js').Theme} Theme */
/** @typedef {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D} Context */
/** @typedef {{ radial: boolean, tile: number | null, spread: number, circles: number[], matrix: DOMMatrix, stops: number[][] }} Gradient */
/** @typedef {{ pen: DOMMatrix | null, offset: number, dashes: number[], gradients: (Gradient | undefined)[] }} Paint */

const CAPS = /** @type {CanvasLineCap[]} */ (names(Cap));
const JOINS = /** @type {CanvasLineJoin[]} */ (names(Join));
const PERIODS = 256; // at most so often is a gradient repeated
const HAIRLINE = 0.75; // as in paint.js
const [PAD, REFLECT] = [0, 1]; // bat_spread
const CORNERS = 13; // numbers in the path around a picture
const PATTERN = 2; // in the place of `radial`
const TILE = 2048; // pixels of the side of a pattern's picture, at most

/** @typedef {{ pictures: Map<number, ImageBitmap | HTMLImageElement | null>, onpicture: (picture: number) => void, theme: Theme }} Album */

/**
 * A decoded picture; null as long as it is being fetched, or cannot be decoded. A drawing of another program is fetched anew when
 * the theme turns colours over, or no longer does.
 * @param {Album} album @param {number} picture its number
 */
export function pictureOf(album, picture) {
  const bitmap = album.pictures.get(picture);
  if (bitmap === undefined || (bitmap && 'dataset' in bitmap && bitmap.dataset.turned !== String(album.theme.turned))) {
    album.pictures.set(picture, null);
    album.onpicture(picture);
  }
  return bitmap ?? null;
}

/** Has what patterns repeat. @type {Album} */
let album = { pictures: new Map(), onpicture: () => {}, theme: /** @type {any} */ (null) };

/** @param {Album} painter */
export function takeTilesFrom(painter) {
  album = painter;
}

/** The pictures of patterns as they were last painted. @type {WeakMap<ImageBitmap | HTMLImageElement, OffscreenCanvas>} */
const tiles = new WeakMap();

/** @type {WeakMap<Float32Array, Paint>} */
const known = new WeakMap();

/** @param {Float32Array} floats as bat_item says @returns {Paint} */
function parse(floats) {
  let at = 0;
  const take = (/** @type {number} */ count) => [...floats.subarray(at, at += count)];
  const pen = take(4);
  const [offset, count] = take(2);
  /** @type {Paint} */
  const paint = { pen: `${pen}` === '1,0,0,1' ? null : new DOMMatrix([...pen, 0, 0]), offset, dashes: take(count), gradients: [] };
  while (at < floats.length) {
    const [stroke, radial, spread] = take(3);
    const circles = take(6);
    const matrix = new DOMMatrix(take(6));
    const stops = Array.from({ length: take(1)[0] }, () => take(3));
    const tile = radial === PATTERN ? circles[0] * 65536 + circles[1] : null;
    paint.gradients[stroke] = { radial: radial === 1, tile, spread, circles, matrix, stops };
  }
  return paint;
}

/**
 * How often a gradient has to be repeated, from and to, so that it covers the corners of a box.
 * @param {Gradient} gradient @param {DOMPoint[]} corners in the gradient's units
 */
function periods({ radial, circles: [x0, y0, r0, x1, y1, r1] }, corners) {
  const [dx, dy] = [x1 - x0, y1 - y0];
  if (!radial) {
    const places = corners.map(({ x, y }) => ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy));
    const first = Math.floor(Math.min(...places));
    return [first, Math.min(Math.max(Math.ceil(Math.max(...places)), first + 1), first + PERIODS)];
  }
  let last = 1;
  while (last < PERIODS && corners.some(({ x, y }) =>
    Math.hypot(x - x0 - last * dx, y - y0 - last * dy) > r0 + last * (r1 - r0))) {
    last++;
  }
  return [r1 > r0 ? -Math.floor(r0 / (r1 - r0)) : 0, last];
}

/**
 * A pattern, in a context whose units are the pixels of its picture, painted with about as many pixels as are seen of it; null as
 * long as the picture is not there.
 * @param {Context} context @param {Gradient} gradient
 */
function patternOf(context, { tile }) {
  const bitmap = pictureOf(album, /** @type {number} */ (tile));
  if (!bitmap) {
    return null;
  }
  const { a, b, c, d } = context.getTransform();
  const scale = 2 ** Math.ceil(Math.log2(Math.max(Math.hypot(a, b), Math.hypot(c, d), 1e-6)));
  const side = (/** @type {number} */ length) => Math.min(TILE, Math.max(1, Math.round(length * scale)));
  const [width, height] = [side(bitmap.width), side(bitmap.height)];
  let canvas = tiles.get(bitmap);
  if (!canvas || canvas.width !== width || canvas.height !== height) {
    canvas = new OffscreenCanvas(width, height);
    canvas.getContext('2d')?.drawImage(bitmap, 0, 0, width, height);
    tiles.set(bitmap, canvas);
  }
  const pattern = context.createPattern(canvas, 'repeat');
  pattern?.setTransform(new DOMMatrix().scale(bitmap.width / width, bitmap.height / height));
  return pattern;
}

/**
 * @param {Context} context @param {Gradient} gradient @param {Item} item @param {Theme} theme
 * @param {number[]} [line] its ends in other units (linear)
 */
function styleOf(context, gradient, item, theme, line) {
  const { radial, spread, circles, matrix, stops } = gradient;
  const back = matrix.inverse();
  const corners = [[item.x0, item.y0], [item.x1, item.y0], [item.x1, item.y1], [item.x0, item.y1]]
    .map(([x, y]) => back.transformPoint({ x, y }));
  const [first, last] = spread === PAD ? [0, 1] : periods(gradient, corners);
  const [x0, y0, r0, x1, y1, r1] = line ? [line[0], line[1], 0, line[2], line[3], 0] : circles;
  const at = (/** @type {number} */ k) => [x0 + k * (x1 - x0), y0 + k * (y1 - y0), Math.max(0, r0 + k * (r1 - r0))];
  const [a, b] = [at(first), at(last)];
  const style = radial ? context.createRadialGradient(a[0], a[1], a[2], b[0], b[1], b[2])
    : context.createLinearGradient(a[0], a[1], b[0], b[1]);
  for (let k = first; k < last; k++) {
    const turned = spread === REFLECT && k % 2 !== 0;
    for (const [place, colour, alpha] of turned ? [...stops].reverse() : stops) {
      const share = (k - first + (turned ? 1 - place : place)) / (last - first);
      style.addColorStop(Math.min(1, Math.max(0, share)), theme.colour((colour * 256 + alpha) >>> 0));
    }
  }
  return style;
}

/** @param {Context} context @param {Gradient} gradient @param {Item} item @param {Theme} theme */
function setFill(context, gradient, item, theme) {
  const pattern = gradient.tile === null ? null : patternOf(context, gradient);
  context.globalAlpha *= pattern ? gradient.stops[0][2] / 255 : 1; // a gradient's stops are painted themselves
  context.fillStyle = pattern ?? styleOf(context, gradient, item, theme);
}

/**
 * The ends of a linear gradient without its matrix: its lines of one colour stay across it.
 * @param {Gradient} gradient @param {DOMMatrix} matrix
 */
function straighten({ circles: [x0, y0, , x1, y1] }, matrix) {
  const a = matrix.transformPoint({ x: x0, y: y0 });
  const b = matrix.transformPoint({ x: x1, y: y1 });
  const c = matrix.transformPoint({ x: x0 - (y1 - y0), y: y0 + (x1 - x0) });
  const [x, y] = [c.y - a.y, a.x - c.x]; // across the lines
  const share = ((b.x - a.x) * x + (b.y - a.y) * y) / (x * x + y * y);
  return [a.x, a.y, a.x + share * x, a.y + share * y];
}

/** @param {Path2D} shape @param {DOMMatrix} matrix */
function mapped(shape, matrix) {
  const made = new Path2D();
  made.addPath(shape, matrix);
  return made;
}

/**
 * Strokes a gradient that only a matrix makes, which must not change the pen: in a layer of its own.
 * @param {Context} context @param {Path2D} shape @param {Gradient} gradient @param {DOMMatrix} matrix
 * @param {Item} item @param {Theme} theme
 */
function strokeLayer(context, shape, gradient, matrix, item, theme) {
  const { width, height } = context.canvas;
  const layer = new OffscreenCanvas(width, height);
  const to = /** @type {OffscreenCanvasRenderingContext2D} */ (layer.getContext('2d'));
  to.setTransform(context.getTransform());
  to.lineWidth = context.lineWidth;
  to.lineCap = context.lineCap;
  to.lineJoin = context.lineJoin;
  to.miterLimit = context.miterLimit;
  to.setLineDash(context.getLineDash());
  to.lineDashOffset = context.lineDashOffset;
  to.stroke(shape);
  to.globalCompositeOperation = 'source-in';
  const whole = new Path2D();
  whole.rect(0, 0, width, height);
  const all = to.getTransform().multiply(matrix);
  to.setTransform(all);
  setFill(to, gradient, item, theme);
  to.fill(mapped(whole, all.inverse()));
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.drawImage(layer, 0, 0);
}

/** @type {Paint} */
const PLAIN = { pen: null, offset: 0, dashes: [], gradients: [] };

/** @param {Item} item @returns {Paint} */
function paintOf({ paint: floats }) {
  if (!floats) {
    return PLAIN;
  }
  const paint = known.get(floats) ?? parse(floats);
  known.set(floats, paint);
  return paint;
}

/**
 * @param {Context} context @param {Item} item @param {Path2D} shape @param {Theme} theme @param {Gradient | undefined} fill
 */
function drawFill(context, item, shape, theme, fill) {
  const rule = item.flags & Flag.EVEN_ODD ? 'evenodd' : 'nonzero';
  if (fill) {
    context.save();
    context.transform(...components(fill.matrix));
    setFill(context, fill, item, theme);
    context.fill(mapped(shape, fill.matrix.inverse()), rule);
    context.restore();
  } else {
    context.fillStyle = theme.colour(item.fill);
    context.fill(shape, rule);
  }
}

/**
 * @param {Context} context @param {Item} item @param {Path2D} shape @param {number} zoom @param {Theme} theme
 * @param {ReturnType<typeof paintOf>} paint
 */
function drawStroke(context, item, shape, zoom, theme, paint) {
  const { pen, gradients: [, stroke] } = paint;
  const own = pen ?? new DOMMatrix();
  context.save();
  context.transform(...components(own));
  context.lineWidth = Math.max(item.flags & Flag.SCREEN_WIDTH ? item.width / zoom : item.width, HAIRLINE / zoom);
  context.lineCap = CAPS[item.cap] ?? 'round';
  context.lineJoin = JOINS[item.join] ?? 'round';
  context.miterLimit = item.miterLimit > 0 ? item.miterLimit : 4;
  context.setLineDash(item.flags & Flag.DASHED ? [6 / zoom, 5 / zoom] : paint.dashes);
  context.lineDashOffset = paint.offset;
  const line = pen ? mapped(shape, own.inverse()) : shape;
  const matrix = stroke && own.inverse().multiply(stroke.matrix);
  if ((stroke?.radial || stroke?.tile != null) && matrix) {
    strokeLayer(context, line, stroke, matrix, item, theme);
  } else {
    context.strokeStyle = stroke && matrix ? styleOf(context, stroke, item, theme, straighten(stroke, matrix))
      : theme.colour(item.stroke);
    context.stroke(line);
  }
  context.restore();
}

/**
 * @param {Context} context @param {Item} item @param {Path2D} shape @param {number} zoom @param {Theme} theme
 * @param {boolean} flat without its stroke @param {number} opacity
 */
function drawAll(context, item, shape, zoom, theme, flat, opacity) {
  const paint = paintOf(item);
  const line = item.flags & Flag.STROKED && !flat;
  context.save();
  context.globalAlpha = opacity;
  if (line && item.flags & Flag.STROKE_FIRST) {
    drawStroke(context, item, shape, zoom, theme, paint);
  }
  if (item.flags & Flag.FILLED) {
    drawFill(context, item, shape, theme, paint.gradients[0]);
  }
  if (line && !(item.flags & Flag.STROKE_FIRST)) {
    drawStroke(context, item, shape, zoom, theme, paint);
  }
  context.restore();
}

/**
 * An object whose fill must not be seen through its stroke is painted in a layer, which then is translucent as a whole.
 * @param {Context} context @param {Item} item @param {Path2D} shape @param {number} zoom
 * @param {Theme} theme @param {boolean} flat without its stroke
 */
export function drawPainted(context, item, shape, zoom, theme, flat) {
  if (flat || !(item.opacity < 1 && item.flags & Flag.FILLED && item.flags & Flag.STROKED)) {
    drawAll(context, item, shape, zoom, theme, flat, item.opacity);
    return;
  }
  drawLayer(context, item, [item.x0, item.y0, item.x1, item.y1], (layer) => drawAll(layer, item, shape, zoom, theme, flat, 1));
}

/**
 * What is painted in a layer is then translucent as a whole.
 * @param {Context} context @param {Item} item @param {number[]} box what of its bounds is wanted @param {(layer: Context) => void} draw
 */
export function drawLayer(context, item, box, draw) {
  const matrix = context.getTransform();
  const [x0, y0] = [Math.max(item.x0, box[0]), Math.max(item.y0, box[1])];
  const [x1, y1] = [Math.min(item.x1, box[2]), Math.min(item.y1, box[3])];
  const corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(([x, y]) => matrix.transformPoint({ x, y }));
  const [xs, ys] = [corners.map(({ x }) => x), corners.map(({ y }) => y)];
  const [left, top] = [Math.max(0, Math.floor(Math.min(...xs)) - 1), Math.max(0, Math.floor(Math.min(...ys)) - 1)];
  const width = Math.min(context.canvas.width, Math.ceil(Math.max(...xs)) + 1) - left;
  const height = Math.min(context.canvas.height, Math.ceil(Math.max(...ys)) + 1) - top;
  if (!(width > 0 && height > 0)) {
    return;
  }
  const layer = new OffscreenCanvas(width, height);
  const to = /** @type {OffscreenCanvasRenderingContext2D} */ (layer.getContext('2d'));
  to.setTransform(new DOMMatrix().translate(-left, -top).multiply(matrix));
  draw(to);
  context.save();
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.globalAlpha = item.opacity;
  context.drawImage(layer, left, top);
  context.restore();
}

/**
 * Draws a picture between its corners.
 * @param {Context} context @param {Item} item @param {Float32Array} path around the corners: command, x, y each
 * @param {ImageBitmap | HTMLImageElement} bitmap @param {number} zoom
 * @param {typeof import('./warp.js').warp | undefined} warp paints it in perspective
 */
export function drawPicture(context, item, path, bitmap, zoom, warp) {
  const [, x, y, , xRight, yRight, , xFar, yFar, , xDown, yDown] = path;
  const { width, height } = bitmap;
  context.save();
  context.globalAlpha = item.opacity;
  if (warp && (path.length !== CORNERS || Math.hypot(x - xRight + xFar - xDown, y - yRight + yFar - yDown) > 0.1 / zoom)) {
    if (path.length === CORNERS) { // else it reaches behind the eye
      warp(context, bitmap, [[x, y], [xRight, yRight], [xFar, yFar], [xDown, yDown]]);
    }
    context.restore();
    return;
  }
  context.transform((xRight - x) / width, (yRight - y) / width, (xDown - x) / height, (yDown - y) / height, x, y);
  context.drawImage(bitmap, 0, 0);
  context.restore();
}

/**
 * What is painted in a layer is then seen as far as the picture of a mask covers it.
 * @param {Album} album @param {Context} context @param {Item} item @param {Float32Array} corners @param {number[]} box
 * @param {number} zoom @param {(layer: Context) => void} draw
 */
export function drawMasked(album, context, item, corners, box, zoom, draw) {
  const mask = pictureOf(album, item.fill);
  if (mask) {
    drawLayer(context, item, box, (layer) => {
      draw(layer);
      layer.globalCompositeOperation = 'destination-in';
      drawPicture(layer, item, corners, mask, zoom, undefined);
    });
  }
}

/** @param {DOMMatrix} m @returns {[number, number, number, number, number, number]} */
const components = ({ a, b, c, d, e, f }) => [a, b, c, d, e, f];
