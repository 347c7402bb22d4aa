// What callers give, as numbers in a row: flat arrays, points as arrays or as objects with x and y.
import { BattenError } from './error.js';
import { Numbers } from './memory.js';

/** @param {unknown} value @returns {boolean} whether it is an array of any kind */
const isRow = (value) => Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
/** @param {unknown} value @returns {boolean} whether it is an array of points */
const isNested = (value) => Array.isArray(value) && value.length > 0 && typeof value.find((one) => one !== null) === 'object';

/** @param {unknown} value @returns {boolean} whether it can be numbers in a row */
export const isNumbers = (value) => value instanceof Numbers || isRow(value);

/** The dimension that points show by themselves; undefined when they are flat. */
export function dimensionOf(points) {
  const first = isNested(points) ? points.find((one) => one !== null) : undefined;
  return first === undefined ? undefined : isRow(first) ? first.length : 'z' in first ? 3 : 2;
}

/** The coordinates of one point; zeros where there is none. @param {number[] | { x: number, y: number, z?: number } | null} point @param {number} dimension @param {string} name */
function coordinates(point, dimension, name) {
  const row = point === null ? new Array(dimension).fill(0) : isRow(point) ? point : [point.x, point.y, point.z].slice(0, dimension);
  if (row.length !== dimension) {
    throw new BattenError('dimension', `${name} differ in dimension`);
  }
  return row;
}

/** @returns {ArrayLike<number> | Numbers} */
export function numbersOf(value, dimension, name) {
  if (!isNumbers(value)) {
    throw new BattenError('argument', `${name} is not an array`);
  }
  const flat = isNested(value) ? value.flatMap((point) => Array.from(coordinates(point, dimension, name))) : value;
  if (Array.isArray(flat) && flat.some((one) => typeof one !== 'number')) {
    throw new BattenError('argument', `${name} holds something other than numbers`);
  }
  return flat;
}

/** The value of a formula of calls.txt, such as (order+1)*dim. @param {(name: string) => number} look */
export function evaluate(formula, look) {
  const words = formula.match(/[#\w]+|[-+*/()]/g) ?? [];
  let at = 0;
  const atom = () => {
    const word = words[at++];
    if (word !== '(') {
      return /^\d/.test(word) ? Number(word) : look(word);
    }
    const inner = sum();
    at++;
    return inner;
  };
  const product = () => {
    let value = atom();
    while (words[at] === '*' || words[at] === '/') {
      value = words[at++] === '*' ? value * atom() : value / atom();
    }
    return value;
  };
  const sum = () => {
    let value = product();
    while (words[at] === '+' || words[at] === '-') {
      value += words[at++] === '+' ? product() : -product();
    }
    return value;
  };
  return sum();
}
