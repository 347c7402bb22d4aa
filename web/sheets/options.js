// What the tool in hand can be told, in the middle of the bar, and which paper the dark theme has, in the foot. Fetched
// after the page has been painted; on a narrow window all of it is in the settings.

import { dress } from '../page/build.js';
import { loadIcons } from '../page/icons.js';
import { tell } from '../page/words.js';

/** The properties of each tool. @type {Record<string, string[]>} */
const OF = {
  sketch: ['stroke-meaning', 'many-strokes', 'stabiliser', 'pressure-width'],
  tangents: ['spline-mode'],
  rectangle: ['corner-radius'],
  polygon: ['polygon-sides'],
  smooth: ['brush-size', 'smooth-limit', 'keep-corners'],
  eraser: ['eraser-size'],
  select: ['scale-strokes'],
  levels: ['level-sketch'],
  surface: ['line-reach', 'line-ruling', 'look'],
};

/** The button of the paper, in the room that the foot keeps for it. @param {import('./panel.js').Panel} panel */
function addPaper({ controls, buttons, theme }) {
  const paper = buttons.plain('paper', 'shell.dim-paper', { help: 'shell.dim-paper.help' });
  paper.addEventListener('click', () => theme?.dimPaper(!theme.dim));
  const look = () => {
    paper.hidden = !theme?.dark;
    paper.setAttribute('aria-pressed', String(theme?.dim));
  };
  look();
  controls.list.push(look);
  document.getElementById('readouts')?.after(paper);
}

export class Options {
  /** @param {import('./panel.js').Panel} panel @param {Promise<void>} faced when the type face is there, or will not come */
  static async make(panel, faced) {
    await Promise.all([dress('styles/options.css'), loadIcons('arrange')]);
    addPaper(panel);
    await faced;
    return new Options(panel);
  }

  /** @param {import('./panel.js').Panel} panel */
  constructor({ tables, controls }) {
    this.tables = tables;
    this.controls = controls;
    this.tool = -1;
    /** The controls of each tool. @type {Map<number, HTMLElement[]>} */
    this.made = new Map();
    this.box = document.createElement('div');
    this.box.className = 'options';
    this.box.setAttribute('role', 'group');
    document.getElementById('tools')?.before(this.box);
  }

  /** @param {number} tool */
  #of(tool) {
    const names = OF[this.tables.tools[tool]?.name] ?? [];
    const made = this.made.get(tool) ?? names.flatMap((name) => this.tables.properties.filter((row) => row.name === name))
      .map((row) => this.controls.control(row, 'option'));
    this.made.set(tool, made);
    return made;
  }

  /** @param {import('../engine/types.js').Frame} frame */
  show(frame) {
    if (frame.tool !== this.tool) {
      this.tool = frame.tool;
      const made = this.#of(frame.tool);
      this.box.hidden = made.length === 0;
      tell(this.box, { label: `tool.${this.tables.tools[frame.tool].name}` });
      this.box.replaceChildren(...made);
      this.controls.refresh();
    }
  }
}
