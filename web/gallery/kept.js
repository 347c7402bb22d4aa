// My drawings: a gallery of the drawings that this browser keeps, and a list of the files that were opened from the disk. Loaded on demand.

import { duplicate, isNamed, nameFrom, rename } from '../keep/copies.js';
import { keyOf } from '../keep/drawings.js';
import { keepOnly } from '../keep/pictures.js';
import { forget, recent } from '../keep/recent.js';
import { dress, want } from '../page/build.js';
import { made } from '../page/elements.js';
import { tell, word } from '../page/words.js';
import { Card, timeOf } from './card.js';
import { Menu } from '../sheets/menu.js';
import { pictureOpen, Pictured } from './pictured.js';
import { roomLeft } from './room_left.js';

/** @typedef {import('../main.js').Shell} Shell */
/** @typedef {import('../sheets/menu.js').Act} Act */

const FEW = 8; // drawings that need no search

/** @param {() => void} act @param {...(Node | string)} content */
function button(act, ...content) {
  const one = made('button', '', ...content);
  one.type = 'button';
  one.addEventListener('click', act);
  return one;
}

/** As names are compared. @param {string} text */
const plain = (text) => text.normalize('NFKC').toLocaleLowerCase();

export class KeptSheet {
  /** @param {Shell} shell */
  static async make(shell) {
    await Promise.all([dress('styles/gallery.css'), Menu.dressed(), shell.engine.words ?? shell.words.load()]);
    return new KeptSheet(shell);
  }

  /** @param {Shell} shell */
  constructor(shell) {
    this.shell = shell;
    /** @type {Card[]} */
    this.cards = [];
    /** How the last deletion is undone. @type {(() => void) | null} */
    this.undo = null;
    this.sheet = tell(made('div', 'sheet'), { label: 'command.open-kept' });
    Object.assign(this.sheet, { id: 'kept', popover: 'auto' });
    this.sheet.setAttribute('role', 'dialog');
    this.pictured = new Pictured(shell, this.sheet);
    this.search = made('input', 'search');
    this.search.type = 'search';
    this.list = made('ul', 'gallery');
    this.list.setAttribute('role', 'list');
    this.none = tell(made('p', 'none'), { text: 'shell.kept-none.help' });
    this.said = made('div', 'said');
    this.said.role = 'status';
    this.room = made('p', 'room-left');
    this.recent = made('ul', 'commands');
    this.recentTitle = tell(made('h2', ''), { text: 'shell.recent' });
    this.menu = new Menu(shell, 'kept-menu', 'shell.further');
    this.sheet.append(this.#head(), this.list, this.none, this.said, this.room, this.recentTitle, this.recent, this.menu.box);
    this.#listen();
    document.body.append(this.sheet);
  }

  #head() {
    const fresh = tell(button(() => this.#go(this.shell.drawings.openNew())), { text: 'shell.new' });
    fresh.classList.add('fresh');
    const close = button(() => this.sheet.hidePopover(), '✕');
    close.className = 'close';
    return made('div', 'head', tell(made('h2', ''), { text: 'command.open-kept' }), this.search, fresh, tell(close, { label: 'step.close' }));
  }

  #listen() {
    this.search.addEventListener('input', () => this.#sift());
    this.sheet.addEventListener('keydown', (event) => {
      this.#key(event);
      event.stopPropagation(); // keep the event from the drawing
    });
    this.list.addEventListener('focusin', ({ target }) => this.#reach(this.#cardOf(target)));
    this.sheet.addEventListener('toggle', (event) => {
      if (/** @type {ToggleEvent} */ (event).newState === 'closed') {
        this.#closed();
      }
    });
  }

  async show() {
    this.search.value = '';
    await this.#fill();
    if (!this.sheet.matches(':popover-open')) { // it may have been asked for twice
      this.sheet.showPopover();
    }
    this.pictured.watch(this.cards);
    const open = this.cards.find(({ own }) => own);
    this.#focus(open ?? this.cards[0]);
    void roomLeft(this.room);
    void pictureOpen(this.shell).then((blob) => blob && open?.show(blob), () => {}); // a picture fewer
    void keepOnly(new Set(this.cards.map(({ kept }) => kept.id)));
  }

  #closed() {
    const { undo } = this;
    this.pictured.rest();
    if (undo) { // it can still be undone
      this.shell.notices.say(this.said.firstChild?.textContent ?? '', { label: word('command.undo'), run: undo });
    }
    this.#say('');
    this.cards.forEach((card) => card.leave());
  }

  async #fill() {
    const { drawings, keeper } = this.shell;
    await keeper.settled();
    const [rows, files] = await Promise.all([drawings.list(), recent()]);
    this.cards = (rows ?? []).map((kept) => new Card(kept, kept.id === keeper.id, {
      open: (card) => this.#open(card), more: (card, x, y) => this.#more(card, x, y) }));
    this.list.replaceChildren(...this.cards.map(({ item }) => item));
    this.search.hidden = this.cards.length <= FEW;
    this.search.placeholder = this.search.ariaLabel = word('shell.kept-search.help').slice(0, -1);
    this.#sift();
    this.recentTitle.hidden = this.recent.hidden = files.length === 0;
    this.recent.replaceChildren(...files.map((file) => this.#file(file)));
  }

  /** After a change: shows the list anew. @param {string} id of the drawing that has the focus then @param {number} index of its place if it is not there */
  async #refill(id, index = 0) {
    if (this.sheet.matches(':popover-open')) {
      await this.#fill();
      this.pictured.watch(this.cards);
      this.#focus(this.cards.find(({ kept }) => kept.id === id) ?? this.#shown()[Math.min(index, this.#shown().length - 1)]);
    }
  }

  // ---- which are shown, and which has the focus ----

  #shown() {
    return this.cards.filter(({ item }) => !item.hidden);
  }

  /** Shows those that are searched for. */
  #sift() {
    const words = plain(this.search.hidden ? '' : this.search.value).split(/\s+/);
    for (const { item, name } of this.cards) {
      item.hidden = !words.every((one) => plain(name).includes(one));
    }
    this.none.hidden = this.cards.length === 0 || this.#shown().length > 0;
    this.#reach(this.#shown()[0]);
  }

  /** @param {EventTarget | null} target */
  #cardOf(target) {
    return this.cards.find(({ item }) => item.contains(/** @type {Node} */ (target)));
  }

  /** Makes it the card that Tab comes to. @param {Card | undefined} card */
  #reach(card) {
    for (const one of card ? this.cards : []) {
      one.reached = one === card;
    }
  }

  /** @param {Card | undefined} card */
  #focus(card) {
    (card?.open ?? /** @type {HTMLElement} */ (this.sheet.querySelector('.fresh'))).focus();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const { key, ctrlKey, metaKey, target } = event;
    const card = this.#cardOf(target);
    if (target === this.search && key === 'Escape' && this.search.value) {
      this.search.value = '';
      this.#sift();
      event.preventDefault();
    } else if ((ctrlKey || metaKey) && key === 'z' && this.undo) {
      this.undo();
      event.preventDefault();
    } else if ((ctrlKey || metaKey) && key === 'f' && !this.search.hidden) {
      this.search.select();
      event.preventDefault();
    } else if (card) {
      this.#keyAt(event, card);
    } else if (key === 'ArrowDown' && target === this.search) {
      this.#focus(this.#shown()[0]);
      event.preventDefault();
    }
  }

  /** A key on a card. @param {KeyboardEvent} event @param {Card} card */
  #keyAt(event, card) {
    const shown = this.#shown();
    const at = shown.indexOf(card);
    const across = shown.filter(({ item }) => item.offsetTop === shown[0].item.offsetTop).length;
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, ArrowDown: at + across, ArrowUp: at - across, Home: 0, End: shown.length - 1 }[event.key];
    const act = { F2: () => this.#rename(card), Delete: () => void this.#delete(card) }[event.key];
    if (to !== undefined) {
      shown[to]?.open.focus();
      event.preventDefault();
    } else if (act) {
      act();
      event.preventDefault();
    }
  }

  // ---- what is done to one ----

  /** @param {Promise<void>} way */
  #go(way) {
    this.sheet.hidePopover();
    return way;
  }

  /** @param {Card} card */
  #open({ kept, own, name }) {
    void (own ? this.sheet.hidePopover() : this.#go(this.shell.drawings.openKept(kept, name)));
  }

  /** @param {Card} card @param {number} x of the window @param {number} y */
  #more(card, x, y) {
    /** @type {Act[]} */
    const first = [{ name: 'open', key: 'command.open', run: () => this.#open(card) }];
    if (isNamed(this.shell, card.kept)) {
      first.push({ name: 'rename', key: 'step.rename', run: () => this.#rename(card) });
    }
    if (!card.kept.broken) {
      first.push({ name: 'duplicate', key: 'command.duplicate', run: () => void this.#duplicate(card) });
    }
    this.menu.opener = card.more;
    this.menu.open([first, ...(card.own ? [] : [[{ name: 'delete', key: 'command.delete', run: () => void this.#delete(card) }]])], x, y);
  }

  /** @param {Card} card */
  #rename(card) {
    if (isNamed(this.shell, card.kept)) {
      card.rename(async (typed) => {
        const name = nameFrom(typed);
        if (name && name !== card.name && await rename({ ...this.shell, notices: this.#notices }, { ...card.kept, name: card.name }, name)) {
          card.call(name);
        }
      });
    }
  }

  /** @param {Card} card */
  async #duplicate(card) {
    const copy = await duplicate({ ...this.shell, notices: this.#notices }, { ...card.kept, name: card.name });
    await this.#refill(copy?.id ?? card.kept.id);
  }

  /** Deletes a drawing, which can be brought back. @param {Card} card */
  async #delete({ kept: { id, place }, own, name }) {
    const { keeper, tabs } = this.shell;
    if (own || await tabs.isElsewhere(keyOf(id, place))) {
      this.#say(own ? '' : word('shell.kept-not.help', name));
      return;
    }
    const index = this.#shown().findIndex(({ kept }) => kept.id === id);
    keeper.setGone(id, true);
    this.#say(word('shell.kept-gone', name), () => {
      keeper.setGone(id, false);
      this.#say('');
      void this.#refill(id);
    });
    await this.#refill('', index);
  }

  /** Says what has happened, within the sheet. @param {string} text @param {(() => void) | null} [undo] */
  #say(text, undo = null) {
    this.undo = undo;
    this.said.replaceChildren(...(text ? [made('span', '', text)] : []), ...(undo ? [button(undo, word('command.undo'))] : []));
  }

  /** Says within the sheet what others say in notices. */
  get #notices() {
    return /** @type {any} */ ({ say: (/** @type {string} */ text) => this.#say(text) });
  }

  // ---- files on the disk ----

  /** @param {import('../keep/recent.js').Recent} file */
  #file({ handle, time }) {
    const remover = button(async () => {
      await forget(handle);
      await this.#refill('');
    }, '✕');
    remover.className = 'keys';
    remover.ariaLabel = remover.title = word('shell.recent-forget.help', handle.name).slice(0, -1);
    const opener = button(() => this.#go(this.#reopen(handle)), made('bdi', '', handle.name), ' ', timeOf(time));
    return made('li', '', made('div', 'command', opener, remover));
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
}
