// The settings, in tabs and searched: the properties that are of no tool, no selection and no strip, and what the page itself can
// be told. Fetched when they are first opened.

import { dress, want } from '../page/build.js';
import { rescale, scale, SCALES } from '../page/scale.js';
import { tell, word } from '../page/words.js';
import { found } from './finder.js';
import { keyMap } from './key_map.js';
import { homeOf } from './options.js';

/** @typedef {import('./panel.js').Panel} Panel */
/** @typedef {import('../engine/types.js').PropertyRow} PropertyRow */

/** The tabs, by the words on them. */
const TABS = ['hands', 'draw', 'measure', 'view', 'animation', 'keys', 'general'];
/** The tab of a subject of properties, or of one property; the others are in the second. @type {Record<string, string>} */
const TAB_OF = {
  'shell.hands': 'hands', 'shell.seeing': 'view', 'shell.measure': 'measure', 'shell.page': 'general', 'hold-time': 'hands',
  'move-loop': 'animation', 'move-rate': 'animation', 'shake-amount': 'animation', 'shake-rate': 'animation',
};

/** @param {Panel} panel */
async function drawPressure({ engine, controls }) {
  const { PressureCurve } = await want(import('./pressure.js'));
  const box = /** @type {HTMLElement} */ (document.getElementById('setting-pressure-curve')).parentElement;
  const curve = new PressureCurve(engine, /** @type {Element} */ (box));
  controls.list.push(() => curve.show());
  curve.show();
}

/** A switch for the paper of the dark theme, which is the page's own. @param {Panel} panel */
function dimPaper({ theme, controls }) {
  const row = document.createElement('div');
  const label = tell(document.createElement('label'), { text: 'shell.dim-paper', help: 'shell.dim-paper.help' });
  const input = document.createElement('input');
  row.className = 'control switch';
  Object.assign(input, { type: 'checkbox', id: 'setting-dim-paper', checked: theme?.dim });
  label.htmlFor = input.id;
  input.addEventListener('change', () => theme?.dimPaper(input.checked));
  controls.list.push(() => { input.checked = theme?.dim ?? false; });
  row.append(label, input);
  return row;
}

/** The size of the controls, which is the page's own, too. */
function sizes() {
  const row = document.createElement('div');
  const label = tell(document.createElement('label'), { text: 'shell.scale' });
  const choice = document.createElement('select');
  row.className = 'control';
  choice.id = 'setting-scale';
  label.htmlFor = choice.id;
  choice.append(...SCALES.map((percent) => new Option(`${percent} %`, String(percent), false, percent === scale())));
  choice.addEventListener('change', () => rescale(Number(choice.value)));
  row.append(label, choice);
  return row;
}

/** The list of commands, where any key is bound. @param {Panel} panel */
function allKeys({ buttons }) {
  const button = buttons.word('shortcuts');
  button.className = 'all-keys';
  button.addEventListener('click', () => document.getElementById('settings')?.hidePopover());
  return button;
}

class Tabs {
  /** @param {HTMLElement} sheet */
  constructor(sheet) {
    this.search = document.createElement('input');
    Object.assign(this.search, { type: 'search', className: 'search', placeholder: ' ' });
    tell(this.search, { label: 'shell.settings-search' });
    this.search.addEventListener('input', () => this.#find());
    this.list = tell(document.createElement('div'), { label: 'shell.settings' });
    this.list.className = 'tabs';
    this.list.setAttribute('role', 'tablist');
    this.list.setAttribute('aria-orientation', 'vertical');
    this.list.addEventListener('keydown', (event) => this.#key(event));
    this.none = document.createElement('p');
    this.none.setAttribute('role', 'status');
    const body = document.createElement('div');
    body.className = 'tab-body';
    /** @type {[HTMLButtonElement, HTMLElement][]} */
    this.tabs = TABS.map((name) => this.#tab(name));
    body.append(...this.tabs.map(([, panel]) => panel), this.none);
    sheet.append(this.search, this.list, body);
    this.choose(0);
    sheet.addEventListener('toggle', (event) => {
      if (/** @type {ToggleEvent} */ (event).newState === 'closed' && this.search.value) {
        this.search.value = '';
        this.#find();
      }
    });
  }

  /** @param {string} name @returns {[HTMLButtonElement, HTMLElement]} */
  #tab(name) {
    const tab = tell(document.createElement('button'), { text: `shell.${name}` });
    Object.assign(tab, { type: 'button', id: `tab-${name}` });
    tab.setAttribute('role', 'tab');
    tab.setAttribute('aria-controls', `tab-${name}-panel`);
    tab.addEventListener('click', () => this.choose(TABS.indexOf(name)));
    const panel = document.createElement('section');
    panel.id = `tab-${name}-panel`;
    panel.setAttribute('role', 'tabpanel');
    panel.setAttribute('aria-labelledby', tab.id);
    panel.append(tell(document.createElement('h3'), { text: `shell.${name}` }));
    this.list.append(tab);
    return [tab, panel];
  }

  /** @param {number} at */
  choose(at) {
    this.at = at;
    this.tabs.forEach(([tab, panel], i) => {
      tab.setAttribute('aria-selected', String(i === at));
      tab.tabIndex = i === at ? 0 : -1;
      panel.hidden = i !== at;
    });
  }

  /** The tab of a control is shown. @param {Element} control */
  show(control) {
    this.search.value = '';
    this.#find();
    this.choose(this.tabs.findIndex(([, panel]) => panel.contains(control)));
  }

  /** @param {string} name @param {...Node} rows */
  add(name, ...rows) {
    this.tabs[TABS.indexOf(name)][1].append(...rows);
  }

  /** What is searched, from all tabs, below their names. */
  #find() {
    const search = this.search.value.trim();
    const rows = this.tabs.flatMap(([, panel]) => [.../** @type {NodeListOf<HTMLElement>} */ (panel.querySelectorAll(':scope > :not(h3)'))]);
    const all = rows.map((row) => ({ row, ...wordsOf(row) }));
    const hits = new Set(search ? found(all, search).map(({ row }) => row) : rows);
    rows.forEach((row) => { row.hidden = !hits.has(row); });
    this.list.hidden = search !== '';
    this.tabs.forEach(([, panel], i) => {
      panel.hidden = search ? ![...hits].some((row) => panel.contains(row)) : i !== this.at;
    });
    this.none.textContent = search && hits.size === 0 ? word('shell.found-nothing', search) : '';
  }

  /** Arrow keys go from tab to tab. @param {KeyboardEvent} event */
  #key(event) {
    const count = this.tabs.length;
    const at = this.at ?? 0;
    const to = { ArrowDown: at + 1, ArrowRight: at + 1, ArrowUp: at - 1, ArrowLeft: at - 1, Home: 0, End: -1 }[event.key];
    if (to !== undefined) {
      this.choose((to + count) % count);
      this.tabs[this.at ?? 0][0].focus();
      event.preventDefault();
    }
  }
}

/** What a row is found by. @param {HTMLElement} row @returns {import('./finder.js').Findable} */
function wordsOf(row) {
  const label = row.querySelector('label');
  const key = label?.dataset.text ?? '';
  return { label: (label ?? row).textContent?.toLowerCase() ?? '', words: word(`${key}.words`), more: word(`${key}.help`).toLowerCase() };
}

/** @param {Panel} panel @param {HTMLElement} sheet @returns {Promise<import('./panel.js').Filled>} */
export async function fill(panel, sheet) {
  await dress('styles/settings.css');
  sheet.append(tell(document.createElement('h2'), { text: 'shell.settings' }));
  const tabs = new Tabs(sheet);
  for (const row of panel.tables.properties) {
    if (row.group === '' && !homeOf(row.name)) { // else it is shown with the tool, or in another sheet
      tabs.add(TAB_OF[row.name] ?? TAB_OF[row.subject] ?? 'draw', panel.controls.control(row, 'setting'));
    }
  }
  tabs.add('view', dimPaper(panel));
  tabs.add('keys', keyMap(panel), allKeys(panel));
  tabs.add('general', sizes());
  void drawPressure(panel);
  return { show: () => {}, reveal: (/** @type {Element} */ control) => tabs.show(control) };
}
