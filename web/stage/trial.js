// A colour that is tried: the selected objects are painted in it while it is chosen, and the drawing does not change.

import { chosenOf } from '../engine/chosen.js';
import { Role } from '../engine/codes.js';

/** The field of an item that a property is painted by. @type {Record<string, 'stroke' | 'fill'>} */
const FIELDS = { 'stroke-colour': 'stroke', 'fill-colour': 'fill' };

export class Trial {
  /** @param {import('../main.js').Shell} shell */
  constructor(shell) {
    this.shell = shell;
    /** What is painted otherwise, and how it was. @type {{ item: import('../engine/types.js').Item, field: 'stroke' | 'fill', was: number }[]} */
    this.items = [];
  }

  /** @param {string} property @param {number} colour 0xRRGGBBAA */
  show(property, colour) {
    const { engine, painter } = this.shell;
    if (!this.items.length) {
      const ids = new Set(chosenOf(engine).map(({ id }) => id));
      const field = FIELDS[property];
      this.items = painter.list.map(({ item }) => item).filter(({ id, role }) => role === Role.OBJECT && ids.has(id))
        .map((item) => ({ item, field, was: item[field] }));
    }
    for (const { item, field } of this.items) {
      item[field] = colour;
    }
    this.#paint();
  }

  /** All is painted as it is. */
  end() {
    for (const { item, field, was } of this.items) {
      item[field] = was;
    }
    if (this.items.length) {
      this.items = [];
      this.#paint();
    }
  }

  #paint() {
    this.shell.painter.retheme();
    this.shell.wake();
  }
}
