// A small picture of an object, from what the page has painted of it.

import { Flag, Role } from '../engine/codes.js';

const SIZE = 20; // view pixels
const PATIENCE = 60; // frames that a picture may take to be fetched

/** What the page has painted of an object. @param {import('./panel.js').Panel} panel @param {number} id */
export const painted = ({ painter }, id) => painter?.list.find(({ item }) => item.id === id && (item.role === Role.OBJECT || item.role === Role.IMAGE));

/**
 * A placed picture, or a text, as soon as it is there.
 * @param {import('../stage/paint.js').Painter} painter @param {CanvasRenderingContext2D} context
 * @param {ReturnType<typeof painted>} entry @param {number} scale @param {number} [left] frames
 */
function paintPicture(painter, context, entry, scale, left = PATIENCE) {
  const { paints } = painter;
  const bitmap = entry && paints?.pictureOf(painter, entry.item.picture);
  if (entry && bitmap) {
    paints?.drawPicture(context, entry.item, entry.corners, bitmap, scale, painter.warp);
  } else if (left > 0) {
    requestAnimationFrame(() => paintPicture(painter, context, entry, scale, left - 1));
  }
}

/**
 * @param {import('./panel.js').Panel} panel
 * @param {number} id
 * @returns {HTMLCanvasElement} empty where nothing of it is painted
 */
export function thumbnail(panel, id) {
  const { theme } = panel;
  const canvas = document.createElement('canvas');
  canvas.className = 'thumbnail';
  canvas.ariaHidden = 'true';
  const ratio = Math.max(1, devicePixelRatio);
  canvas.width = canvas.height = Math.round(SIZE * ratio);
  const entry = painted(panel, id);
  const context = canvas.getContext('2d');
  if (!entry || !context || !theme) {
    return canvas;
  }
  const { item, shape } = entry;
  const span = Math.max(item.x1 - item.x0, item.y1 - item.y0, 1e-9);
  const scale = ((SIZE - 3) * ratio) / span;
  context.setTransform(scale, 0, 0, scale, canvas.width / 2 - (scale * (item.x0 + item.x1)) / 2,
    canvas.height / 2 - (scale * (item.y0 + item.y1)) / 2);
  if (item.role === Role.IMAGE && panel.painter) {
    paintPicture(panel.painter, context, entry, scale);
    return canvas;
  }
  if (item.flags & Flag.FILLED) {
    context.fillStyle = theme.colour(item.fill);
    context.fill(shape, item.flags & Flag.EVEN_ODD ? 'evenodd' : 'nonzero');
  }
  if (item.flags & Flag.STROKED) {
    context.strokeStyle = theme.colour(item.stroke);
    context.lineWidth = Math.max(ratio, Math.min(item.width * scale, 2.5 * ratio)) / scale;
    context.stroke(shape);
  }
  return canvas;
}
