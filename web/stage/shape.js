// Paths as the browser takes them, and how one is painted: for the page, and for the worker that paints what takes long.

import { Path } from '../engine/codes.js';

/** @typedef {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D} Context */
/**
 * @typedef {object} Look
 * @property {string} fill '' for none @property {CanvasFillRule} rule
 * @property {string} stroke '' for none @property {number} width @property {CanvasLineCap} cap
 * @property {CanvasLineJoin} join @property {number} miter @property {number[]} dashes @property {number} opacity
 */

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
