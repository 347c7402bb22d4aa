// The engine: the calls into batten.wasm, as a plain class. Its base class in instance.js looks after the module's
// memory and recovers from traps.

import { Anew, Refusal, word } from '../page/words.js';
import { readFrame } from './frame.js';
import { EVENTS, Instance, NO_MEMORY, OK, UNSUPPORTED } from './instance.js';
import { readLosses, writeLosses } from './losses.js';
import { readSvg } from './svg_reader.js';

/** @typedef {import('./types.js').Frame} Frame */
/** @typedef {import('./types.js').Pointer} Pointer */
/** @typedef {import('./types.js').Tables} Tables */

const decoder = new TextDecoder();

export class Engine extends Instance {
  /** Whether the document is read-only. @param {boolean} on */
  setReadOnly(on) {
    this.readOnly = on;
    this.guard(() => this.wasm.editor_read_only(this.editor, Number(on)), undefined);
  }

  // ---- input ----

  /**
   * @param {number} width view pixels
   * @param {number} height
   * @param {number} ratio device pixels per view pixel
   */
  resize(width, height, ratio) {
    this.size = [width, height, ratio];
    this.guard(() => this.wasm.editor_resize(this.editor, width, height, ratio), undefined);
  }

  /** @param {Pointer[]} pointers all at once: the engine puts the moves of a batch in order */
  pointer(pointers) {
    this.guard(() => {
      const count = pointers.length;
      const events = count > EVENTS ? this.alloc(count * this.layout['pointer.size']) : this.events;
      const view = this.view();
      pointers.forEach((pointer, i) => this.#writePointer(view, events + i * this.layout['pointer.size'], pointer));
      this.wasm.editor_pointer(this.editor, events, count);
      if (events !== this.events) {
        this.wasm.memory_free(events);
      }
    }, undefined, 'pointer');
  }

  /** @param {DataView} view @param {number} at @param {Pointer} pointer */
  #writePointer(view, at, pointer) {
    const place = this.layout;
    view.setUint32(at + place['pointer.phase'], pointer.phase, true);
    view.setUint32(at + place['pointer.device'], pointer.device, true);
    view.setUint32(at + place['pointer.contact'], pointer.contact, true);
    view.setUint32(at + place['pointer.buttons'], pointer.buttons, true);
    view.setUint32(at + place['pointer.modifiers'], pointer.modifiers, true);
    view.setFloat64(at + place['pointer.x'], pointer.x, true);
    view.setFloat64(at + place['pointer.y'], pointer.y, true);
    view.setFloat64(at + place['pointer.pressure'], pointer.pressure, true);
    view.setFloat64(at + place['pointer.tilt_x'], pointer.tiltX, true);
    view.setFloat64(at + place['pointer.tilt_y'], pointer.tiltY, true);
    view.setFloat64(at + place['pointer.twist'], pointer.twist, true);
    view.setFloat64(at + place['pointer.width'], pointer.width, true);
    view.setFloat64(at + place['pointer.height'], pointer.height, true);
    view.setFloat64(at + place['pointer.time'], pointer.time, true);
    view.setUint8(at + place['pointer.predicted'], pointer.predicted ? 1 : 0);
  }

  /**
   * @param {number} x
   * @param {number} y
   * @param {number} dx pixels
   * @param {number} dy
   * @param {number} modifiers
   * @param {number} time
   */
  wheel(x, y, dx, dy, modifiers, time) {
    this.guard(() => this.wasm.editor_wheel(this.editor, x, y, dx, dy, modifiers, time), undefined);
  }

  /** Shows the view on the way of its last jump. @param {number} share 0..1 */
  glide(share) {
    this.guard(() => this.wasm.editor_glide(this.editor, share), undefined);
  }

  /**
   * @param {string} key as KeyboardEvent.key
   * @param {boolean} down
   * @param {number} modifiers
   * @param {number} time
   * @returns {boolean} whether the engine used it
   */
  key(key, down, modifiers, time) {
    const call = (/** @type {number} */ name) => !this.partial &&
      this.wasm.editor_key(this.editor, name, down ? 1 : 0, modifiers, time) !== 0;
    return this.guard(() => this.lend(key, call), false);
  }

  /** @param {string} name @returns {boolean} whether it could be done now */
  command(name) {
    return !this.partial && this.guard(() => this.lend(name, (text) => this.wasm.editor_command(this.editor, text)) === OK, false);
  }

  /** @param {string} property @param {number} value @returns {boolean} whether it was accepted */
  set(property, value) {
    return this.guard(() => this.lend(property, (text) => this.wasm.editor_set(this.editor, text, value)) === OK, false);
  }

  /** @param {string} property @returns {number} NaN when there is no such property */
  get(property) {
    return this.guard(() => this.lend(property, (text) => this.wasm.editor_get(this.editor, text)), NaN);
  }

  /** The share of a brush's reach that a pen pressure gives. @param {number} pressure @returns {number} */
  pressure(pressure) {
    return this.guard(() => this.wasm.editor_pressure(this.editor, pressure), 1);
  }

  /**
   * Enters a number of the selection, or a property, as text.
   * @param {string} name @param {string} text @returns {boolean} whether it was accepted
   */
  enter(name, text) {
    return this.guard(() => this.lend(name, (number) => this.lend(text, (words) =>
      this.wasm.editor_enter(this.editor, number, words))) === OK, false);
  }

  /** The value of that number in the current unit; '' when there is none. @param {string} name @returns {string} */
  number(name) {
    return this.guard(() => this.string(this.lend(name, (text) => this.wasm.editor_number(this.editor, text))), '');
  }

  /** The commands that apply to the selection. @returns {string[]} */
  actions() {
    return this.guard(() => this.string(this.wasm.editor_actions(this.editor)).split(' ').filter(Boolean), []);
  }

  /** The commands that cannot be done now, and why. @returns {Record<string, string>} */
  refused() {
    return this.guard(() => JSON.parse(this.string(this.wasm.editor_refused(this.editor))), {});
  }

  /** Moves a layer to the place of another. @param {number} id @param {number} target @returns {boolean} */
  placeLayer(id, target) {
    return this.act('editor_place_layer', id, target);
  }

  /** A text made by the engine. @param {string} name of the export @param {...number} numbers @returns {string} */
  ask(name, ...numbers) {
    return this.guard(() => {
      const address = this.wasm[name](this.editor, ...numbers);
      return address ? this.string(address) : '';
    }, '');
  }

  /** @param {string} name of the export @param {...number} numbers @returns {boolean} whether it could be done */
  act(name, ...numbers) {
    return this.guard(() => this.wasm[name](this.editor, ...numbers) === OK, false);
  }

  /** @returns {import('../sheets/layers.js').Layers} */
  layers() {
    return this.guard(() => JSON.parse(this.string(this.wasm.editor_layers(this.editor))), { layers: [], active: 0, loose: 0, pictures: 0 });
  }

  /** @returns {import('../stage/chips.js').Readings} */
  readings() {
    return this.guard(() => JSON.parse(this.string(this.wasm.editor_readings(this.editor))), { at: [0, 0], chosen: -1, amount: -1, words: [] });
  }

  /** @param {number} slider 0 or 1 @param {number} amount @param {boolean} done @returns {boolean} */
  refit(slider, amount, done) {
    return this.act(slider ? 'editor_refit_other' : 'editor_refit', amount, Number(done));
  }

  /** @param {number} reading @returns {boolean} */
  readAs(reading) {
    return this.act('editor_read_as', reading);
  }

  /** @returns {import('../sheets/levels.js').Levels} */
  levels() {
    return this.guard(() => JSON.parse(this.string(this.wasm.editor_levels(this.editor))), { rows: [], points: 0, apart: 0, copying: 0 });
  }

  /**
   * @param {number} act one of Act in codes.js
   * @param {number} level 0: the base
   * @param {number} value
   * @param {boolean} done whether the fader has been released
   * @returns {boolean}
   */
  level(act, level, value, done) {
    return this.act('editor_level', act, level, value, Number(done));
  }

  /** @param {number} id 0: none @returns {boolean} */
  activateLayer(id) {
    return this.act('editor_activate_layer', id);
  }

  /** @param {number} id @param {string} name @returns {boolean} */
  rename(id, name) {
    return this.guard(() => this.lend(name, (text) => this.wasm.editor_rename(this.editor, id, text)) === OK, false);
  }

  /** @param {number} id @param {boolean} hidden @param {boolean} locked @returns {boolean} */
  setState(id, hidden, locked) {
    return this.act('editor_set_state', id, Number(hidden), Number(locked));
  }

  /** @param {string} command @param {string | null} keys null: the default @returns {boolean} */
  bind(command, keys) {
    return this.guard(() => this.lend(command, (name) => (keys === null ?
      this.wasm.editor_bind(this.editor, name, 0) :
      this.lend(keys, (list) => this.wasm.editor_bind(this.editor, name, list)))) === OK, false);
  }

  /** @returns {Tables} */
  tables() {
    return JSON.parse(this.string(this.wasm.editor_tables(this.editor)));
  }

  // ---- pictures ----

  /** Places a picture to trace; if it is refused, a notice says so. @param {Uint8Array} bytes @param {string} name */
  addPicture(bytes, name) {
    this.guard(() => this.lend(bytes, (data, size) => this.lend(name, (title) =>
      this.wasm.editor_add_picture(this.editor, data, size, title))), undefined);
  }

  /**
   * The file of a picture, by the number that an item carries.
   * @param {number} picture @returns {Uint8Array<ArrayBuffer>}
   */
  picture(picture) {
    const at = this.wasm.editor_picture(this.editor, picture, this.scratch);
    const size = at ? this.view().getUint32(this.scratch, true) : 0;
    return new Uint8Array(this.wasm.memory.buffer).slice(at, at + size);
  }

  // ---- the clipboard ----

  /**
   * The selection as SVG with its knots.
   * @param {boolean} cut @returns {string} '' without a selection: a notice says so
   */
  copy(cut) {
    return this.guard(() => (this.wasm.editor_copy(this.editor, Number(cut), this.scratch) === OK ?
      decoder.decode(this.take()) : ''), '');
  }

  /** @param {string} text of an SVG file @param {import('./svg_reader.js').Watch} [watch] */
  pasteSvg(text, watch) {
    this.#done(this.guard(() => readSvg(this, text, false, (reader) =>
      this.wasm.svg_paste(reader, this.editor, this.scratch), watch), -1));
  }

  /** Of another format. @param {Uint8Array} bytes @param {string} name */
  pasteFile(bytes, name) {
    this.#done(this.guard(() => this.lend(bytes, (text, size) => this.lend(name, (title) =>
      this.wasm.editor_paste_file(this.editor, text, size, title, this.scratch))), -1));
  }

  // ---- files ----

  /** A native document. @param {Uint8Array} bytes @param {string} name */
  openNative(bytes, name) {
    this.#openBytes('editor_open_native', bytes, name);
  }

  /** A file of another format that is not XML. @param {Uint8Array} bytes @param {string} name */
  openFile(bytes, name) {
    this.#openBytes('editor_open_file', bytes, name);
  }

  /** @param {string} reader name of the export @param {Uint8Array} bytes @param {string} name */
  #openBytes(reader, bytes, name) {
    this.#open(() => this.lend(bytes, (text, size) => this.lend(name, (title) =>
      this.wasm[reader](this.editor, text, size, title, this.scratch))));
  }

  /** @param {string} text of an SVG file @param {string} name @param {import('./svg_reader.js').Watch} [watch] */
  openSvg(text, name, watch) {
    this.#open(() => readSvg(this, text, true, (reader) => this.lend(name, (title) =>
      this.wasm.svg_finish(reader, this.editor, title, this.scratch)), watch));
  }

  /** The drawing keeps the file that it was opened from: saving loses nothing of it. */
  get keeps() {
    return this.guard(() => this.wasm.editor_keeps(this.editor) !== 0, false);
  }

  /** How many things look otherwise than in the file, where it is kept; else how many overwriting it would lose. */
  get lost() {
    return this.guard(() => this.wasm.editor_lost(this.editor), 0);
  }

  /** What the file contains and the drawing does not: overwriting the file would lose it, unless it `keeps` it. */
  get losses() {
    return readLosses(this);
  }

  set losses(losses) {
    writeLosses(this, losses);
  }

  /** Opens a document. @param {() => number} work returns a status */
  #open(work) {
    this.#done(this.guard(() => {
      const status = work();
      return this.afresh(status, status === OK);
    }, -1));
  }

  /** Throws the reader's message if the status is an error. @param {number} status */
  #done(status) {
    if (status === OK) {
      return;
    }
    if (status < 0) {
      throw new Refusal(word(this.scarce ? 'shell.no-memory' : 'shell.broke'));
    }
    const place = this.string(this.scratch + this.layout['problem.place']);
    const message = this.string(this.scratch + this.layout['problem.message']);
    throw new Refusal([place, message || this.string(this.wasm.status_message(status))].filter(Boolean).join(': '));
  }

  /**
   * The document as the bytes of a file.
   * @param {boolean} native native format; otherwise SVG
   * @param {boolean} [kept] throws Anew where the file that the drawing was read from would have to be written anew
   * @returns {Uint8Array}
   */
  save(native, kept = false) {
    const bytes = this.#write(native, kept) ?? this.#salvage(native);
    if (!bytes) {
      throw new Refusal(word(this.dead ? 'shell.no-copy' : 'shell.not-written'));
    }
    return bytes;
  }

  /** @param {boolean} native @param {boolean} kept @returns {Uint8Array | null} null: the module broke, or has no memory left */
  #write(native, kept) {
    return this.guard(() => {
      const status = this.wasm.editor_save(this.editor, native ? 1 : 0, kept ? 1 : 0, this.scratch);
      if (kept && status === UNSUPPORTED) {
        throw new Anew();
      }
      if (status !== OK && status !== NO_MEMORY) {
        throw new Refusal(this.string(this.wasm.status_message(status)));
      }
      return status === OK ? this.take() : null;
    }, /** @type {Uint8Array | null} */ (null));
  }

  /** The drawing as written by another instance, from the journal. @param {boolean} native */
  #salvage(native) {
    try {
      const other = new Engine(this.module);
      return other.replay(this.journal) ? other.#write(native, false) : null;
    } catch (error) {
      console.error(error);
      return null;
    }
  }

  /** The host has saved: the document is clean. */
  saved() {
    this.guard(() => this.wasm.editor_saved(this.editor), undefined);
  }

  /** A 64-bit digest of the document. @returns {string} */
  digest() {
    return BigInt.asUintN(64, this.wasm.editor_digest(this.editor)).toString(16).padStart(16, '0');
  }

  /** The invariant that does not hold; '' when all hold. @returns {string} */
  check() {
    const address = this.wasm.editor_check(this.editor);
    return address ? this.string(address) : '';
  }

  // ---- output ----

  /**
   * What to paint and say now. Paths are views into the module's memory: use them before the next call.
   * @returns {Frame | null} null after a trap; the next frame is complete again
   */
  frame() {
    return this.guard(() => {
      this.keepJournal();
      const at = this.wasm.editor_frame(this.editor);
      const frame = readFrame(this.wasm.memory, this.layout, at, this.stillVersion, this.still);
      this.still = frame.still;
      this.stillVersion = frame.stillVersion;
      return frame;
    }, null, 'frame');
  }
}
