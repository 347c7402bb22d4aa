// The sheet of the drawings kept in the browser, for opening and deleting them, and of the files that were opened from
// the disk. Loaded on demand.

import { keyOf } from '../keep/drawings.js';
import { forget, recent } from '../keep/recent.js';
import { want } from '../page/build.js';
import { tell, word } from '../page/words.js';

/** @typedef {import('../keep/keep.js').Listed} Listed */
/** @typedef {{ keeper: import('../keep/keep.js').Keeper, files: import('../keep/files.js').Files, notices: import('../page/notice.js').Notices,
 * tabs: import('../keep/tabs.js').Tabs, drawings: import('../keep/drawings.js').Drawings }} Shell */

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
    const rows = await this.shell.drawings.list() ?? [];
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

  /** @param {Listed} kept @param {string} date @param {number} index */
  #row(kept, date, index) {
    const { shell } = this;
    const own = kept.id === shell.keeper.id;
    const name = kept.name || word('shell.nameless');
    const opener = button(() => (own ? this.sheet.hidePopover() : this.#go(shell.drawings.openKept(kept, name))), ...titled(name, date));
    if (kept.aside || kept.broken) {
      const note = document.createElement('small');
      note.textContent = word(kept.broken ? 'shell.kept-broken' : 'shell.kept-aside');
      opener.append(' ', note);
    }
    opener.ariaCurrent = String(own);
    return entry(opener, ...(own ? [] : [this.#remover(kept, name, index)]));
  }

  /** A button that deletes; what it deletes can be brought back. @param {Listed} kept @param {string} name @param {number} index */
  #remover({ id, place }, name, index) {
    const { keeper, notices, tabs } = this.shell;
    const one = button(async () => {
      if (await tabs.isElsewhere(keyOf(id, place))) {
        notices.say(word('shell.kept-not.help', name));
        return;
      }
      keeper.setGone(id, true);
      notices.say(word('shell.kept-gone', name), { label: word('command.undo'), run: () => {
        keeper.setGone(id, false);
        void this.#refill(index);
      } });
      await this.#refill(index);
    }, '✕');
    one.className = 'keys';
    one.ariaLabel = one.title = word('shell.kept-delete.help', name).slice(0, -1); // without its full stop
    return one;
  }

  /** After a change, if it is still open. @param {number} index of the row that has the focus then */
  async #refill(index) {
    if (this.sheet.matches(':popover-open')) {
      await this.#fill();
      this.#focus(index);
    }
  }
}
