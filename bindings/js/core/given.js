// What callers give, as C takes it: numbers in a row from arrays of all kinds, text as bytes, numbers, truths and words.
import { BattenError, shown, wrong } from './error.js';
import { Numbers } from './memory.js';

const MOST = 0x7fffffff; // of whole numbers

/** @param {unknown} value @returns {boolean} whether it is an array of any kind */
const isRow = (value) => Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
/** @param {unknown} value @returns {boolean} whether it is an array of points */
const isNested = (value) => Array.isArray(value) && value.length > 0 && typeof value.find((one) => one !== null) === 'object';

/** @param {unknown} value @returns {boolean} whether it can be numbers in a row */
export const isNumbers = (value) => value instanceof Numbers || isRow(value);

/** @param {Numbers | ArrayLike<unknown>} value @returns {unknown[]} */
export const listOf = (value) => Array.from(value instanceof Numbers ? value.values : value);

/** The dimension that points show by themselves; undefined when they are flat. */
export function dimensionOf(points) {
  const first = isNested(points) ? points.find((one) => one !== null) : undefined;
  return first === undefined ? undefined : isRow(first) ? first.length : 'z' in first ? 3 : 2;
}

/** The coordinates of one point; zeros where there is none. @param {number[] | { x: number, y: number, z?: number } | null} point @param {number} dimension @param {string} name */
function coordinates(point, dimension, name) {
  const row = point === null ? new Array(dimension).fill(0) : isRow(point) ? point : [point?.x, point?.y, point?.z].slice(0, dimension);
  if (row.length !== dimension) {
    throw wrong(name, `${dimension} coordinates`, `${row.length}`, 'dimension');
  }
  return Array.from(row);
}

/** @returns {ArrayLike<number> | Numbers} */
export function numbersOf(value, dimension, name) {
  if (typeof value === 'object' && value !== null && 'x' in value && 'y' in value) {
    return numbersOf(coordinates(value, dimension, name), dimension, name); // one point
  }
  if (!isNumbers(value)) {
    throw wrong(name, 'an array of numbers', shown(value));
  }
  const flat = isNested(value) ? value.flatMap((point, i) => coordinates(point, dimension, `${name}[${i}]`)) : value;
  for (let i = 0; i < flat.length && !(flat instanceof Numbers); i++) {
    if (!Number.isFinite(flat[i])) {
      const place = isNested(value) ? `${Math.floor(i / dimension)}][${i % dimension}` : i;
      const isNumber = typeof flat[i] === 'number';
      throw wrong(`${name}[${place}]`, isNumber ? 'a finite number' : 'a number', shown(flat[i]), isNumber ? 'number' : 'argument');
    }
  }
  return flat;
}

/** The options of a call, which stand behind its arguments. @param {unknown[]} given @param {string[]} names of the arguments
 * @param {Iterable<string>} known the options that there are @param {string} call @returns {Record<string, unknown>} */
export function optionsOf(given, names, known, call) {
  const options = given[names.length] ?? {};
  if (given.length > names.length + 1 || typeof options !== 'object' || isNumbers(options)) {
    throw wrong(call, `(${[...names, 'options'].join(', ')})`, given.length > names.length + 1 ? `${given.length} arguments` : `${shown(options)} as options`);
  }
  const all = [...known];
  const other = Object.keys(options).find((name) => !all.includes(name));
  if (other !== undefined) {
    throw new BattenError('argument', `${call} has no option ${other}, but ${all.join(', ')}`);
  }
  return options;
}

/** All curves that regions are made of, each with its place. @param {unknown} value @param {string} place @returns {[string, import('./library.js').Curve][]} */
export function curvesOf(value, place) {
  if (Array.isArray(value)) {
    return value.flatMap((one, i) => curvesOf(one, `${place}[${i}]`));
  }
  return value?.kind_ === 'Curve' ? [[place, value]] : value?.curves ? curvesOf(value.curves, `${place}.curves`) : [];
}

/** What is in a row, or in rows, one after the other. @param {unknown} value @param {string} name @returns {unknown[]} */
export function rowOf(value, name) {
  if (!isNumbers(value)) {
    throw wrong(name, 'an array', shown(value));
  }
  return listOf(value).flat();
}

/** Text as UTF-8; bytes as they are. @param {unknown} value @param {string} name @param {boolean} whole whether a NUL may be in it @returns {Uint8Array} */
export function bytesOf(value, name, whole) {
  const bytes = value instanceof ArrayBuffer ? new Uint8Array(value) : ArrayBuffer.isView(value)
    ? new Uint8Array(value.buffer, value.byteOffset, value.byteLength) : typeof value === 'string' ? new TextEncoder().encode(value) : null;
  if (!bytes) {
    throw wrong(name, 'text or bytes', shown(value));
  }
  if (!whole && bytes.includes(0)) {
    throw wrong(name, 'text without NUL', shown(value));
  }
  return bytes;
}

/** A number, truth or word, as C takes it.
 * @param {{ enums: Record<string, Record<string, number>>, rules: { within: Record<string, number[]> } }} tables
 * @param {string} type @param {unknown} value @param {string} name for errors @param {string} [key] what limits stand under, beside the name
 * @returns {number} */
export function converted({ enums, rules: { within } }, type, value, name, key) {
  if (type in enums) {
    if (typeof value !== 'string' || !Object.hasOwn(enums[type], value)) {
      throw wrong(name, `one of ${Object.keys(enums[type]).join(', ')}`, shown(value));
    }
    return enums[type][value];
  }
  if (type === 'bool') {
    if (typeof value !== 'boolean') {
      throw wrong(name, 'true or false', shown(value));
    }
    return Number(value);
  }
  const number = typeof value === 'bigint' ? Number(value) : value;
  if (typeof number !== 'number') {
    throw wrong(name, 'a number', shown(value));
  }
  if (!Number.isFinite(number)) {
    throw wrong(name, 'a finite number', shown(value), 'number');
  }
  if (type === 'double') {
    return number;
  }
  const last = snake(name.slice(name.lastIndexOf('.') + 1));
  const [low, high] = within[key] ?? within[last] ?? within[type] ?? [type === 'size_t' ? 0 : -MOST, MOST];
  if (!Number.isInteger(number) || number < low || number > high) {
    throw wrong(name, `a whole number from ${low} to ${high}`, shown(value), last === 'degree' || last === 'dimension' ? last : type === 'size_t' ? 'count' : 'argument');
  }
  return number;
}

/** maxError as C has it: max_error. @param {string} name @returns {string} */
export const snake = (name) => name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);

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
