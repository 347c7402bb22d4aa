// The selected objects and everything in them, from the outline that the engine tells in pages.

/** root: it is selected itself. @typedef {{ id: number, name: string, level: number, selected: boolean, words: string, root: boolean }} Row */

const ROWS = 500; // that the engine tells at once

/** @param {import('./engine.js').Engine} engine @returns {Row[]} back to front */
export function chosenOf(engine) {
  /** @type {Row[]} */
  const found = [];
  let above = Infinity; // the level of the selected object that the rows are in
  for (let first = 0, total = 1; first < total; first += ROWS) {
    const outline = JSON.parse(engine.ask('editor_outline', first, ROWS) || '{"total":0,"rows":[]}');
    total = outline.total;
    for (const row of /** @type {Row[]} */ (outline.rows)) {
      above = row.level <= above ? Infinity : above;
      const root = above === Infinity && row.selected;
      above = root ? row.level : above;
      if (above !== Infinity) {
        found.push({ ...row, root });
      }
    }
  }
  return found;
}
