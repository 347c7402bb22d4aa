// What the tool in hand can be told, in the middle of the bar; what has no room there is behind a button. And which paper the dark
// theme has, in the foot. Fetched after the page has been painted.

import { dress } from '../page/build.js';
import { loadIcons } from '../page/icons.js';
import { tell } from '../page/words.js';

/** The properties of each tool. @type {Record<string, string[]>} */
const OF = {
  sketch: ['stroke-meaning', 'many-strokes', 'stabiliser', 'pressure-width', 'on-extremes'],
  tangents: ['spline-mode'],
  rectangle: ['corner-radius'],
  polygon: ['polygon-sides'],
  smooth: ['brush-size', 'smooth-limit', 'keep-corners'],
  eraser: ['eraser-size'],
  select: ['scale-strokes'],
  levels: ['level-sketch'],
  surface: ['line-reach', 'line-ruling', 'look'],
};
/** What is asked beside the selection while it is done: the first part of its name, and the command. @type {Record<string, string>} */
const BESIDE = { array: 'array', offset: 'curve-offset' };

/** The command with which a property is shown; undefined: it is in the settings. @param {string} property */
export function homeOf(property) {
  const tool = Object.keys(OF).find((name) => OF[name].includes(property));
  return tool ? `tool-${tool}` : BESIDE[property.split('-')[0]];
}

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
  constructor({ tables, controls, buttons }) {
    this.tables = tables;
    this.controls = controls;
    this.tool = -1;
    /** The controls of each tool. @type {Map<number, HTMLElement[]>} */
    this.made = new Map();
    this.box = document.createElement('div');
    this.box.className = 'options';
    this.box.setAttribute('role', 'group');
    this.rest = tell(document.createElement('div'), { label: 'shell.options' });
    Object.assign(this.rest, { className: 'sheet', id: 'options', popover: 'auto' });
    this.rest.setAttribute('role', 'dialog');
    this.rest.addEventListener('toggle', () => controls.refresh());
    this.button = buttons.plain('options', 'shell.options');
    this.button.setAttribute('popovertarget', 'options');
    document.getElementById('tools')?.before(this.box);
    document.body.append(this.rest);
    new ResizeObserver(() => this.#fold()).observe(this.box);
  }

  /** @param {number} tool */
  #of(tool) {
    const names = OF[this.tables.tools[tool]?.name] ?? [];
    const made = this.made.get(tool) ?? names.flatMap((name) => this.tables.properties.filter((row) => row.name === name))
      .map((row) => this.controls.control(row, 'option'));
    this.made.set(tool, made);
    return made;
  }

  /** Puts behind the button what does not fit before it. */
  #fold() {
    const all = this.#of(this.tool);
    if (this.box.contains(document.activeElement) || this.rest.matches(':popover-open')) {
      return; // not under the hand
    }
    this.box.replaceChildren(...all);
    this.rest.replaceChildren();
    for (let i = all.length - 1; i >= 0 && this.box.scrollWidth > this.box.clientWidth; i--) {
      this.box.append(this.button);
      this.rest.prepend(all[i]);
    }
  }

  /** Lets the user change one. @param {string} property */
  reveal(property) {
    const field = /** @type {HTMLInputElement | null} */ (document.getElementById(`option-${property}`));
    if (field && this.rest.contains(field)) {
      this.rest.showPopover();
    }
    field?.focus();
    field?.select?.();
  }

  /** @param {import('../engine/types.js').Frame} frame */
  show(frame) {
    if (frame.tool !== this.tool) {
      this.tool = frame.tool;
      this.rest.hidePopover();
      this.box.hidden = this.#of(frame.tool).length === 0;
      tell(this.box, { label: `tool.${this.tables.tools[frame.tool].name}` });
      this.#fold();
      this.controls.refresh();
    }
  }
}
