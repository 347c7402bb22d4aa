// A picture to trace, seen in perspective: it is painted in cells, each of which is a parallelogram.

const CELLS = 24; // along each side

/**
 * @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D} context in drawing coordinates
 * @param {ImageBitmap | HTMLImageElement} bitmap
 * @param {number[][]} corners of the picture as it is seen, around
 */
export function warp(context, bitmap, [[x0, y0], [x1, y1], [x2, y2], [x3, y3]]) {
  // From the unit square: (a s + b t + x0, d s + e t + y0) / (g s + h t + 1).
  const [ax, ay, bx, by] = [x1 - x2, y1 - y2, x3 - x2, y3 - y2];
  const [cx, cy] = [x0 - x1 + x2 - x3, y0 - y1 + y2 - y3];
  const whole = ax * by - bx * ay;
  const [g, h] = [(cx * by - bx * cy) / whole, (ax * cy - cx * ay) / whole];
  const at = (/** @type {number} */ s, /** @type {number} */ t) => {
    const deep = g * s + h * t + 1;
    return [((x1 - x0 + g * x1) * s + (x3 - x0 + h * x3) * t + x0) / deep,
      ((y1 - y0 + g * y1) * s + (y3 - y0 + h * y3) * t + y0) / deep];
  };
  const [wide, high] = [bitmap.width / CELLS, bitmap.height / CELLS];
  const over = 1.03; // cells overlap a little: there is no seam between them
  for (let i = 0; i < CELLS; i++) {
    for (let j = 0; j < CELLS; j++) {
      const [x, y] = at(i / CELLS, j / CELLS);
      const [right, rightY] = at((i + 1) / CELLS, j / CELLS);
      const [downX, down] = at(i / CELLS, (j + 1) / CELLS);
      context.save();
      context.transform(right - x, rightY - y, downX - x, down - y, x, y);
      const [w, v] = [i + 1 < CELLS ? over : 1, j + 1 < CELLS ? over : 1];
      context.drawImage(bitmap, i * wide, j * high, w * wide, v * high, 0, 0, w, v);
      context.restore();
    }
  }
}
