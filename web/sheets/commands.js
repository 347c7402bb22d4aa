// The sheet of all commands, by sections: for running them and changing their keys, and for finding them, settings and formats
// by the words that one has. Fetched at the first sign of a user.

import { found } from './finder.js';
import { shortcutOf } from './keys.js';
import { made } from '../page/elements.js';
import { keyName, tell, word } from '../page/words.js';

/** @typedef {import('../engine/types.js').CommandRow} CommandRow */
/** @typedef {import('../page/words.js').Words} Words */
/** @typedef {import('../page/settings.js').Settings} Settings */
/** What can be found beside commands; own: of the drawing, found after all that is the editor's.
 * @typedef {{ name: string, label: string, of: string, words: string, help: string, own?: boolean, run: () => void }} Other */

/** @param {string} label @param {() => void} act @param {...(Node | string)} content */
function button(label, act, ...content) {
  const one = made('button', '', ...content);
  one.type = 'button';
  one.setAttribute('aria-label', label);
  one.title = label;
  one.addEventListener('click', act);
  return one;
}

/** A help text without its full stop, for a button. @param {string} key @param {string} [value] */
const brief = (key, value) => word(`shell.${key}.help`, value).replace(/[.。]$/, '');

const STORE = 'batten-commands'; // names of the commands that were last run from here, the latest first
const LAST = 5;

/** @returns {string[]} */
function lastUsed() {
  try {
    const names = JSON.parse(localStorage.getItem(STORE) ?? '[]');
    return Array.isArray(names) ? names : [];
  } catch {
    return []; // nothing is kept in this browser
  }
}

/** @param {string[]} names */
function remember(names) {
  try {
    localStorage.setItem(STORE, JSON.stringify(names));
  } catch {
    // It is for this page only then.
  }
}

export class CommandSheet {
  /**
   * @param {HTMLElement} sheet
   * @param {Words} words
   * @param {Settings} settings
   * @param {(command: string) => void} run
   * @param {() => Other[]} others what else can be found
   * @param {() => Record<string, string>} refused the commands that cannot be done now, and why
   */
  constructor(sheet, words, settings, run, others, refused) {
    this.sheet = sheet;
    this.words = words;
    this.settings = settings;
    this.run = run;
    this.others = others;
    /** Why what cannot be done now cannot, by the command's name. */
    this.refused = refused;
    /** @type {Record<string, string>} */
    this.why = {};
    this.commands = words.tables.commands;
    /** The command whose keys are being changed. */
    this.editing = '';
    /** The last key pressed: it is unusable, or other commands use it too. */
    this.pressed = '';
    this.unusable = false;
    this.last = lastUsed();
    this.search = made('input', 'search');
    this.search.type = 'search';
    this.search.addEventListener('input', () => this.fill());
    this.body = made('div', 'command-list');
    sheet.replaceChildren(tell(made('h2', ''), { text: 'shell.menu' }), this.search, this.body);
    /** Whether it is shown: it is built for that, and for nothing else. */
    this.open = sheet.matches(':popover-open');
    sheet.addEventListener('beforetoggle', (event) => {
      this.open = /** @type {ToggleEvent} */ (event).newState === 'open';
      if (!this.open) {
        this.editing = '';
        this.search.value = '';
        this.body.replaceChildren();
      }
      this.fill();
    });
    sheet.addEventListener('keydown', (event) => this.#key(event));
    this.fill();
  }

  /** Rebuilds the sheet when texts or keys have changed, or something else is searched. */
  fill() {
    if (!this.open) {
      return;
    }
    const focus = document.activeElement instanceof HTMLElement && this.body.contains(document.activeElement) ?
      document.activeElement.dataset.focus : undefined;
    this.commands = this.words.tables.commands;
    this.why = this.refused();
    this.body.replaceChildren(...this.search.value.trim() ? this.#found() : this.#all());
    this.search.placeholder = brief('search');
    this.search.setAttribute('aria-label', brief('search'));
    const again = focus && this.body.querySelector(`[data-focus="${focus}"]`);
    if (again instanceof HTMLElement) {
      again.focus();
    }
  }

  /** All commands by their sections, after those that were last used. */
  #all() {
    const last = this.last.flatMap((name) => this.commands.filter((row) => row.name === name));
    /** @type {HTMLElement[]} */
    const parts = last.length > 0 ? [made('h3', '', word('shell.last-used')), made('ul', 'commands last', ...last.map((row) => this.#row(row)))] : [];
    let section = '';
    for (const row of this.commands) {
      if (row.section !== section) {
        section = row.section;
        parts.push(made('h3', '', word(section)), made('ul', 'commands'));
      }
      parts[parts.length - 1].append(this.#row(row));
    }
    if (Object.keys(this.settings.kept.keys).length > 0) {
      const all = button(brief('keys-default'), () => this.#bind(this.commands.map((row) => [row.name, null])),
        brief('keys-default'));
      parts.push(all);
    }
    return parts;
  }

  /** What fits the search, the best first: Enter runs that. */
  #found() {
    const commands = this.commands.map((row) => ({ label: row.label, words: word(`command.${row.name}.words`),
      help: [word(`command.${row.name}.help`), ...row.keys, ...row.keys.map(keyName)].join(' '), make: () => this.#row(row) }));
    const others = this.others().map((other) => ({ ...other, make: () => this.#other(other) }));
    const all = [...commands, ...others].map((one) => ({ own: false, ...one, label: one.label.toLowerCase(), more: one.help.toLowerCase() }));
    const entries = [false, true].flatMap((own) => found(all.filter((one) => one.own === own), this.search.value)).map((one) => one.make());
    entries[0]?.classList.add('best');
    return entries.length > 0 ? [made('ul', 'commands', ...entries)] : [made('p', 'none', word('shell.found-nothing', this.search.value.trim()))];
  }

  /** Leaves the sheet, and what has the focus in it: or the next key is the hidden sheet's. */
  #leave() {
    this.sheet.hidePopover();
    if (document.activeElement instanceof HTMLElement && this.sheet.contains(document.activeElement)) {
      document.activeElement.blur();
    }
  }

  /** @param {Other} other */
  #other(other) {
    const label = button(other.label, () => {
      this.#leave();
      other.run();
    }, other.label, made('small', '', other.of));
    label.title = other.help;
    label.dataset.command = other.name;
    return made('li', '', made('div', 'command', label));
  }

  /** @param {CommandRow} row */
  #row(row) {
    const label = button(row.label, () => {
      this.last = [row.name, ...this.last.filter((name) => name !== row.name)].slice(0, LAST);
      remember(this.last);
      this.#leave();
      this.run(row.name);
    }, row.label);
    const help = word(`command.${row.name}.help`);
    label.title = help;
    label.dataset.command = row.name;
    const why = this.why[row.name];
    if (why) { // it may be pressed all the same, and says so again
      label.setAttribute('aria-disabled', 'true');
      label.setAttribute('aria-label', `${row.label} ${why}`);
      label.append(' ', made('small', '', why));
    }
    const editing = row.name === this.editing;
    const names = row.keys.map(keyName);
    const caps = names.flatMap((name) => [made('kbd', '', name), ' ']);
    const keys = button(`${names.join(' ')} ${brief(editing ? 'press' : 'rebind', row.label)}`, () => {
      this.editing = editing ? '' : row.name;
      this.pressed = '';
      this.fill();
    }, ...(caps.length > 0 ? caps : ['+']));
    keys.className = 'keys';
    keys.dataset.focus = row.name;
    keys.setAttribute('aria-pressed', String(editing));
    const entry = made('li', '', made('div', 'command', label, keys));
    if (editing) {
      entry.append(this.#editor(row));
    }
    return entry;
  }

  /** The editor of a command's keys, with the outcome of the last key pressed. @param {CommandRow} row */
  #editor(row) {
    const box = made('div', 'rebinding', made('p', '', word('shell.press.help', row.label)));
    const status = made('p', 'told');
    status.setAttribute('role', 'status');
    box.append(status);
    if (this.unusable) {
      status.textContent = word('shell.key-refused.help', keyName(this.pressed));
    }
    const others = this.unusable ? [] : this.#others(row, this.pressed);
    if (others.length > 0) {
      status.textContent = word('shell.key-also.help', others.map((other) => other.label).join(', '));
      box.append(button(brief('key-only'), () => this.#bind(others.map((other) => [other.name,
        other.keys.filter((key) => key !== this.pressed).join(' ')])), brief('key-only')));
    }
    for (const key of row.keys) {
      const cross = made('span', '', '✕');
      cross.ariaHidden = 'true';
      box.append(button(brief('key-remove', keyName(key)), () => {
        this.pressed = '';
        this.#bind([[row.name, row.keys.filter((other) => other !== key).join(' ')]]);
      }, made('kbd', '', keyName(key)), ' ', cross));
    }
    if (row.name in this.settings.kept.keys) {
      box.append(button(brief('key-default'), () => {
        this.pressed = '';
        this.#bind([[row.name, null]]);
      }, brief('key-default')));
    }
    return box;
  }

  /** Other commands that use a key. @param {CommandRow} row @param {string} key */
  #others(row, key) {
    return this.commands.filter((other) => other !== row && other.name !== row.name && other.keys.includes(key));
  }

  /** @param {[string, string | null][]} changes command and keys; null: the default */
  #bind(changes) {
    this.unusable = changes.filter(([command, keys]) => !this.settings.bind(command, keys)).length > 0;
    const { editing } = this;
    this.words.retell();
    /** @type {HTMLElement | null} */ (this.body.querySelector(`[data-focus="${editing}"]`))?.focus();
  }

  /** Arrows go through what was found, from the marked one on; Enter in the search runs that. @param {KeyboardEvent} event */
  #walk(event) {
    const by = event.key === 'ArrowDown' ? 1 : event.key === 'ArrowUp' ? -1 : 0;
    const first = event.key === 'Enter' && event.target === this.search && !event.isComposing;
    if (!by && !first) {
      return;
    }
    event.preventDefault();
    /** @type {HTMLElement[]} */
    const all = [this.search, .../** @type {NodeListOf<HTMLElement>} */ (this.body.querySelectorAll('li [data-command]'))];
    const best = this.body.querySelector('.best') && by > 0 && document.activeElement === this.search && all.length > 2;
    const at = best ? 1 : all.indexOf(/** @type {HTMLElement} */ (document.activeElement));
    if (first) {
      /** @type {HTMLElement | null} */ (this.body.querySelector('.best [data-command]'))?.click();
    } else {
      all[Math.min(Math.max(at + by, 0), all.length - 1)].focus();
    }
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    event.stopPropagation(); // keep the event from the drawing
    const row = this.commands.find((one) => one.name === this.editing);
    if (!row || event.target === this.search) {
      this.#walk(event);
      return;
    }
    if (event.key === 'Escape') {
      event.preventDefault();
      this.editing = '';
      this.fill();
      return;
    }
    // On the other buttons Enter and Space keep their usual meaning.
    const onKeys = event.target instanceof HTMLElement && event.target.dataset.focus === this.editing;
    const key = onKeys ? shortcutOf(event) : '';
    if (key) {
      event.preventDefault();
      this.pressed = key;
      this.#bind([[row.name, [...row.keys.filter((other) => other !== key), key].join(' ')]]);
    }
  }
}
