// Curves as paths: SVG path data, and the calls of a Path2D or of a canvas.

/**
 * Calls moveTo, bezierCurveTo and closePath of a path for cubics in the plane, which follow each other.
 * @param {Float64Array} points 4 points for each cubic @param {number} dimension @param {boolean} closed @param {import('./index.js').PathLike} path
 */
export function trace(points, dimension, closed, path) {
  const at = (i) => [points[i * dimension], points[i * dimension + 1]];
  for (let i = 0; i + 3 < points.length / dimension; i += 4) {
    if (i === 0) {
      path.moveTo(...at(0));
    }
    path.bezierCurveTo(...at(i + 1), ...at(i + 2), ...at(i + 3));
  }
  if (closed) {
    path.closePath();
  }
  return path;
}

/** A path whose text is SVG path data, with so many decimals. @param {number} decimals */
export class PathText {
  #words = [];
  #decimals;

  constructor(decimals) {
    this.#decimals = decimals;
  }

  /** @param {string} letter @param {number[]} numbers */
  #add(letter, numbers) {
    this.#words.push(letter + numbers.map((one) => Number(one.toFixed(this.#decimals)) + 0).join(' '));
  }

  /** As of a Path2D. @param {...number} place */
  moveTo(...place) {
    this.#add('M', place);
  }

  /** As of a Path2D. @param {...number} places */
  bezierCurveTo(...places) {
    this.#add('C', places);
  }

  /** As of a Path2D. */
  closePath() {
    this.#words.push('Z');
  }

  /** SVG path data. @returns {string} */
  toString() {
    return this.#words.join('');
  }
}
