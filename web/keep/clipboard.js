// The clipboard, through the browser's own events, which need no permission: the selection is copied as SVG that keeps
// its knots, and SVG or pictures from any program are pasted. Fetched once the page has loaded.

import { Ask } from '../engine/codes.js';
import { isQuickText } from '../engine/reading.js';
import { want } from '../page/build.js';
import { Refusal, word } from '../page/words.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */
/** @typedef {import('./files.js').Files} Files */
/** @typedef {import('../page/notice.js').Notices} Notices */

const TEXT = 'text/plain';
const SVG = 'image/svg+xml';
const PASTED = 'clipboard.svg';
const OPENING = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" ' +
  'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" ' +
  'xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd">';

/** Whether the event belongs to ordinary text, in a field or selected. @param {Event} event */
function isText(event) {
  const target = event.target instanceof Element ? event.target : null;
  return target?.closest('input, select, textarea, dialog') || String(getSelection()) !== '';
}

/** An SVG file, or one made of elements without a root or of bare path data. @param {string} text */
function fileOf(text) {
  const whole = text.trim();
  if (/^m[\s\d.+-]/i.test(whole) && /^[\s\dmlhvcsqtaze,.+-]*$/i.test(whole)) {
    return `${OPENING}<path d="${whole}"/></svg>`;
  }
  return /^<(\?xml|!|([\w-]+:)?svg[\s>])/.test(whole) ? whole : `${OPENING}${whole}</svg>`;
}

/** @param {string} text */
const looksLikeSvg = (text) => /^\s*<[?!\w]/.test(text) || /^\s*m[\s\d.+-][\s\dmlhvcsqtaze,.+-]+$/i.test(text);

export class Clipboard {
  /**
   * @param {Engine} engine
   * @param {Files} files
   * @param {Notices} notices
   * @param {() => void} wake
   */
  constructor(engine, files, notices, wake) {
    this.engine = engine;
    this.files = files;
    this.notices = notices;
    this.wake = wake;
    addEventListener('copy', (event) => this.#copy(event, false));
    addEventListener('cut', (event) => this.#copy(event, true));
    addEventListener('paste', (event) => this.#paste(event));
  }

  /** Runs a clipboard command from a menu or from another key. @param {number} requests */
  async ask(requests) {
    if (requests & (Ask.CUT | Ask.COPY)) {
      document.execCommand(requests & Ask.CUT ? 'cut' : 'copy');
    }
    if (requests & Ask.PASTE) {
      try {
        void this.#put(await navigator.clipboard.readText());
      } catch {
        this.notices.say(word('shell.press-paste'));
      }
    }
  }

  /** @param {ClipboardEvent} event @param {boolean} cut */
  #copy(event, cut) {
    if (isText(event)) {
      return;
    }
    const text = this.engine.copy(cut);
    this.wake();
    if (!text) {
      return;
    }
    event.preventDefault();
    event.clipboardData?.setData(TEXT, text);
    event.clipboardData?.setData(SVG, text);
    // SVG set on the event stays within the browser; other programs find this one, where the browser allows it.
    if (/** @type {any} */ (globalThis.ClipboardItem)?.supports?.(SVG)) {
      const parts = [TEXT, SVG].map((type) => [type, new Blob([text], { type })]);
      navigator.clipboard.write([new ClipboardItem(Object.fromEntries(parts))]).catch(() => {});
    }
  }

  /** @param {ClipboardEvent} event */
  #paste(event) {
    const data = event.clipboardData;
    if (!data || isText(event)) {
      return;
    }
    event.preventDefault();
    // When a program offers a picture as well as text, both show the same drawing.
    const text = [TEXT, SVG].map((type) => data.getData(type)).find(looksLikeSvg);
    const picture = [...data.files].find((file) => file.type.startsWith('image/'));
    if (text || !picture) {
      void this.#put(text ?? '');
    } else if (picture.type === SVG) {
      void picture.text().then((svg) => this.#put(svg));
    } else {
      void this.files.addPicture(picture);
    }
  }

  /** @param {string} text */
  async #put(text) {
    const file = fileOf(looksLikeSvg(text) ? text : '');
    try {
      if (isQuickText(file)) {
        this.engine.pasteSvg(file);
      } else {
        const { addApart } = await want(import('./apart.js'));
        await addApart(this.engine, new Blob([file]), PASTED, false);
      }
    } catch (error) {
      if (!(error instanceof Refusal)) {
        throw error;
      }
      this.notices.say(error.message);
    }
    this.wake();
  }
}
