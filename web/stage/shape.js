// Paths of the engine as shapes of a canvas, and how one is painted: on the page, and in a worker.

import { Path, Role } from '../engine/codes.js';

/** @typedef {import('../engine/types.js').Item} Item */
/** @typedef {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D} Context */
/**
 * @typedef {object} Look
 * @property {string} fill '' for none @property {CanvasFillRule} rule
 * @property {string} stroke '' for none @property {number} width @property {CanvasLineCap} cap
 * @property {CanvasLineJoin} join @property {number} miter @property {number[]} dashes @property {number} opacity
 */

/** Numbers of one path that is painted apart: what is filled may take time by the square of them. */
const HEAVY = 12000;

/**
 * @param {Float32Array} path commands and coordinates, as frame.h says
 * @returns {Path2D}
 */
export function shapeOf(path) {
  const shape = new Path2D();
  let i = 0;
  while (i < path.length) {
    switch (path[i]) {
      case Path.MOVE:
        shape.moveTo(path[i + 1], path[i + 2]);
        i += 3;
        break;
      case Path.LINE:
        shape.lineTo(path[i + 1], path[i + 2]);
        i += 3;
        break;
      case Path.CUBIC:
        shape.bezierCurveTo(path[i + 1], path[i + 2], path[i + 3], path[i + 4], path[i + 5], path[i + 6]);
        i += 7;
        break;
      default:
        shape.closePath();
        i += 1;
    }
  }
  return shape;
}

/** @param {Context} context @param {Path2D} shape @param {Look} look */
export function paintShape(context, shape, look) {
  context.globalAlpha = look.opacity;
  if (look.fill) {
    context.fillStyle = look.fill;
    context.fill(shape, look.rule);
  }
  if (look.stroke) {
    context.strokeStyle = look.stroke;
    context.lineWidth = look.width;
    context.lineCap = look.cap;
    context.lineJoin = look.join;
    context.miterLimit = look.miter;
    context.setLineDash(look.dashes);
    context.stroke(shape);
  }
}

/** @param {Item} item */
export function boxOf({ x0, y0, x1, y1 }) {
  const shape = new Path2D();
  shape.rect(x0, y0, x1 - x0, y1 - y0);
  return shape;
}

/** @param {Item} item */
export function shapedOf(item) {
  const heavy = item.role === Role.OBJECT && !item.paint && item.path.length > HEAVY;
  return { shape: heavy ? boxOf(item) : shapeOf(item.path), heavy: heavy ? item.path.slice() : null };
}
