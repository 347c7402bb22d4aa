// The user's settings, kept in the browser: properties other than style, and shortcuts, by their names in the engine's
// tables.

import { keep, kept } from './kept.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */

const STORE = 'batten-settings';
const SOON = 300; // milliseconds after a frame

/** @typedef {{ values: Record<string, number>, keys: Record<string, string> }} Kept */

export class Settings {
  /** Whether there are any to restore, for which the module's second part is needed. */
  static get any() {
    return /:[{]"/.test(kept(STORE));
  }

  /** @param {Engine} engine */
  constructor(engine) {
    this.engine = engine;
    this.properties = engine.tables().properties.filter((row) => row.group === '');
    /** @type {Kept} */
    this.kept = { values: {}, keys: {} };
    this.timer = 0;
    try {
      const { values, keys } = JSON.parse(kept(STORE) || '{}');
      this.kept = { values: { ...values }, keys: { ...keys } };
    } catch {
      // Corrupt: use the defaults.
    }
    this.restore();
    addEventListener('pagehide', () => this.#write());
  }

  /** Applies the settings to the engine, for instance to a new one. */
  restore() {
    for (const [name, value] of Object.entries(this.kept.values)) {
      this.engine.set(name, Number(value));
    }
    for (const [name, keys] of Object.entries(this.kept.keys)) {
      this.engine.bind(name, String(keys));
    }
  }

  /** Sets the shortcuts of a command; null: the default. @param {string} command @param {string | null} keys */
  bind(command, keys) {
    if (!this.engine.bind(command, keys)) {
      return false;
    }
    if (keys === null) {
      delete this.kept.keys[command];
    } else {
      this.kept.keys[command] = keys;
    }
    this.note();
    return true;
  }

  /** Called at every frame: a setting may have changed. */
  note() {
    this.timer ||= setTimeout(() => this.#write(), SOON);
  }

  #write() {
    this.timer = 0;
    const set = this.properties.filter((row) => this.engine.get(row.name) !== row.default);
    this.kept.values = Object.fromEntries(set.map((row) => [row.name, this.engine.get(row.name)]));
    keep(STORE, JSON.stringify(this.kept));
  }
}
