// Reads what the engine hands over: structs in the module's memory, by the layout that the module itself reports.

import { Flag, Role } from './codes.js';

/** @typedef {import('./types.js').Frame} Frame */
/** @typedef {import('./types.js').Item} Item */
/** @typedef {import('./types.js').Label} Label */
/** @typedef {Record<string, number>} Layout */

const decoder = new TextDecoder();

/**
 * Reads a NUL-terminated string.
 * @param {WebAssembly.Memory} memory
 * @param {number} address
 */
export function readString(memory, address) {
  const bytes = new Uint8Array(memory.buffer);
  return decoder.decode(bytes.subarray(address, bytes.indexOf(0, address)));
}

/**
 * Reads the frame at an address. Paths are views into the memory, valid until the next call into the module.
 * @param {WebAssembly.Memory} memory
 * @param {Layout} place
 * @param {number} at
 * @param {number} knownVersion version of the static list
 * @param {Item[]} known that list, reused while its version is unchanged
 * @returns {Frame}
 */
export function readFrame(memory, place, at, knownVersion, known) {
  const view = new DataView(memory.buffer);
  const word = (/** @type {string} */ name) => view.getUint32(at + place[name], true);
  const double = (/** @type {string} */ name, index = 0) => view.getFloat64(at + place[name] + 8 * index, true);
  const single = (/** @type {string} */ name, index = 0) => view.getFloat32(at + place[name] + 4 * index, true);
  const text = (/** @type {string} */ name) => readString(memory, word(name));
  const stillVersion = word('frame.still_version');
  const stillChanged = stillVersion !== knownVersion;
  return {
    x: double('frame.view', 0),
    y: double('frame.view', 1),
    zoom: double('frame.view', 2),
    angle: double('frame.view', 3),
    jumps: word('frame.jumps'),
    tilt: double('frame.tilt'),
    surfaces: word('frame.surfaces') !== 0,
    originX: double('frame.origin', 0),
    originY: double('frame.origin', 1),
    stillVersion,
    stillChanged,
    still: stillChanged ? readItems(view, place, word('frame.still'), word('frame.still_count')) : known,
    dirty: [single('frame.dirty', 0), single('frame.dirty', 1), single('frame.dirty', 2), single('frame.dirty', 3)],
    live: readItems(view, place, word('frame.live'), word('frame.live_count')),
    labels: readLabels(memory, place, word('frame.labels'), word('frame.label_count')),
    cursor: word('frame.cursor'),
    requests: word('frame.requests'),
    unsaved: word('frame.unsaved') !== 0,
    canUndo: word('frame.can_undo') !== 0,
    canRedo: word('frame.can_redo') !== 0,
    tool: word('frame.tool'),
    knotsBefore: word('frame.knots_before'),
    knotsAfter: word('frame.knots_after'),
    pending: word('frame.pending'),
    busy: word('frame.busy') !== 0,
    error: double('frame.error'),
    tolerance: double('frame.tolerance'),
    hint: text('frame.hint'),
    notice: text('frame.notice'),
    noticeVersion: word('frame.notice_version'),
    offer: text('frame.offer'),
    name: text('frame.name'),
    revision: word('frame.revision'),
    selection: word('frame.selection'),
    selected: word('frame.selected'),
    layer: word('frame.layer'),
    readings: word('frame.readings'),
    levels: word('frame.levels'),
    moves: word('frame.moves'),
    lost: word('frame.lost'),
    first: word('frame.first'),
  };
}

/**
 * @param {DataView} view
 * @param {Layout} place
 * @param {number} first
 * @param {number} count
 * @returns {Item[]}
 */
function readItems(view, place, first, count) {
  /** @type {Item[]} */
  const items = [];
  for (let i = 0; i < count; i++) {
    const at = first + i * place['item.size'];
    const word = (/** @type {string} */ name) => view.getUint32(at + place[name], true);
    const single = (/** @type {string} */ name, index = 0) => view.getFloat32(at + place[name] + 4 * index, true);
    items.push({
      id: word('item.id'),
      version: word('item.version'),
      role: word('item.role'),
      flags: word('item.flags'),
      stroke: word('item.stroke'),
      fill: word('item.fill'),
      width: single('item.width'),
      opacity: single('item.opacity'),
      cap: word('item.cap'),
      join: word('item.join'),
      miterLimit: single('item.miter_limit'),
      x0: single('item.bounds', 0),
      y0: single('item.bounds', 1),
      x1: single('item.bounds', 2),
      y1: single('item.bounds', 3),
      path: new Float32Array(view.buffer, word('item.path'), word('item.path_count')),
      picture: word('item.picture'),
      paint: word('item.paint') ? new Float32Array(view.buffer, word('item.paint'), word('item.paint_count')).slice() : null,
    });
  }
  return items;
}

/**
 * @param {WebAssembly.Memory} memory
 * @param {Layout} place
 * @param {number} first
 * @param {number} count
 * @returns {Label[]}
 */
function readLabels(memory, place, first, count) {
  const view = new DataView(memory.buffer);
  return Array.from({ length: count }, (_, i) => {
    const at = first + i * place['label.size'];
    const single = (/** @type {string} */ name, index = 0) => view.getFloat32(at + place[name] + 4 * index, true);
    return {
      role: view.getUint32(at + place['label.role'], true),
      x: single('label.at', 0),
      y: single('label.at', 1),
      dx: single('label.offset', 0),
      dy: single('label.offset', 1),
      turn: single('label.turn'),
      text: readString(memory, view.getUint32(at + place['label.text'], true)),
    };
  });
}

/** @param {Item | undefined} item */
export const isPage = (item) => item?.role === Role.PAGE || item?.role === Role.PAGE_BACK;

/** Whether an object's fill lies under its stroke. @param {Item} item */
export const isWhole = ({ role, flags }) => role === Role.OBJECT && flags & Flag.FILLED && flags & Flag.STROKED;
