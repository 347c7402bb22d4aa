// The sheet of the drawings kept in the browser, for opening and deleting them, and of the files that were opened from
// the disk. Loaded on demand.

import { forget, recent } from '../keep/recent.js';
import { want } from '../page/build.js';
import { tell, word } from '../page/words.js';

/** @typedef {import('../keep/keep.js').Kept} Kept */
/** @typedef {{ keeper: import('../keep/keep.js').Keeper, files: import('../keep/files.js').Files, wake: () => void,
 * drawings: import('../keep/drawings.js').Drawings }} Shell */

/** @param {() => void} act @param {...(Node | string)} content */
function button(act, ...content) {
  const one = document.createElement('button');
  one.type = 'button';
  one.append(...content);
  one.addEventListener('click', act);
  return one;
}

/** @param {string} name @param {string} date */
function titled(name, date) {
  const title = document.createElement('bdi');
  const time = document.createElement('time');
  title.textContent = name;
  time.textContent = date;
  return [title, ' ', time];
}

/** @param {...Node} content */
function entry(...content) {
  const item = document.createElement('li');
  const row = document.createElement('div');
  row.className = 'command';
  row.append(...content);
  item.append(row);
  return item;
}

export class KeptSheet {
  /** @param {Shell} shell */
  constructor(shell) {
    this.shell = shell;
    this.sheet = tell(document.createElement('div'), { label: 'command.open-kept' });
    Object.assign(this.sheet, { id: 'kept', className: 'sheet', popover: 'auto' });
    this.sheet.setAttribute('role', 'dialog');
    this.sheet.addEventListener('keydown', (event) => event.stopPropagation()); // keep the event from the drawing
    this.list = document.createElement('ul');
    this.list.className = 'commands';
    this.recent = document.createElement('ul');
    this.recent.className = 'commands';
    this.recentTitle = tell(document.createElement('h2'), { text: 'shell.recent' });
    this.sheet.append(tell(document.createElement('h2'), { text: 'command.open-kept' }), this.list, this.recentTitle, this.recent);
    document.body.append(this.sheet);
  }

  async show() {
    await this.#fill();
    this.sheet.showPopover();
    this.#focus(0);
  }

  /** @param {number} row */
  #focus(row) {
    const all = this.list.querySelectorAll('button:first-child');
    /** @type {HTMLElement} */ (all[Math.min(row, all.length - 1)]).focus();
  }

  async #fill() {
    await this.shell.keeper.settled();
    const format = new Intl.DateTimeFormat(document.documentElement.lang, { dateStyle: 'medium', timeStyle: 'short' });
    const rows = await this.shell.keeper.list();
    const fresh = tell(button(() => this.#go(this.shell.drawings.openNew())), { text: 'shell.new' });
    this.list.replaceChildren(...rows.map((kept, index) => this.#row(kept, format.format(kept.time), index)), entry(fresh));
    const files = await recent();
    this.recentTitle.hidden = this.recent.hidden = files.length === 0;
    this.recent.replaceChildren(...files.map((file) => this.#file(file, format.format(file.time))));
  }

  /** A file on the disk. @param {import('../keep/recent.js').Recent} file @param {string} date */
  #file({ handle }, date) {
    const remover = button(async () => {
      await forget(handle);
      await this.#fill();
      this.#focus(0);
    }, '✕');
    remover.className = 'keys';
    remover.ariaLabel = remover.title = word('shell.recent-forget.help', handle.name).slice(0, -1);
    return entry(button(() => this.#go(this.#reopen(handle)), ...titled(handle.name, date)), remover);
  }

  /** Opens it once more; the browser may ask first. @param {import('../keep/disk.js').Handle} handle */
  async #reopen(handle) {
    const { files } = this.shell;
    const { again } = await want(import('../keep/disk.js'));
    const arrival = await again(handle);
    if (arrival) {
      await files.arrive([arrival]);
    } else {
      files.notices.say(word('shell.recent-gone.help', handle.name));
    }
  }

  /** @param {Promise<void>} way */
  #go(way) {
    this.sheet.hidePopover();
    return way;
  }

  /** @param {Kept} kept @param {string} date @param {number} index */
  #row({ name }, date, index) {
    const own = name === this.shell.files.name;
    const opener = button(() => (own ? this.sheet.hidePopover() : this.#go(this.shell.drawings.openKept(name))), ...titled(name, date));
    opener.ariaCurrent = String(own);
    return entry(opener, ...(own ? [] : [this.#remover(name, index)]));
  }

  /** A button that deletes when pressed twice. @param {string} name @param {number} index */
  #remover(name, index) {
    let sure = false;
    const say = (/** @type {string} */ key) => {
      one.ariaLabel = one.title = word(`shell.${key}.help`, name).slice(0, -1); // without its full stop
    };
    const one = button(async () => {
      if (!sure) {
        sure = true;
        say('kept-sure');
        one.textContent = one.title.split(':')[0];
        return;
      }
      this.shell.keeper.drop(name);
      this.shell.wake(); // the open drawing is kept again
      await this.#fill();
      this.#focus(index);
    }, '✕');
    one.className = 'keys';
    say('kept-delete');
    return one;
  }
}
