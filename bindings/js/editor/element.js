// <batten-editor src="drawing.svg">: the editor in a frame of its own, because it is a whole page: it has its own keys, styles
// and policy, several can be on one page, and none can harm the page around it. The element gives it the drawing and
// takes it back, through a port that only the two hold. It also holds the journal of what was drawn: when the
// frame goes, because the element is removed or put elsewhere, the next frame goes on from there, undo and all.

const PATIENCE = 10000; // milliseconds from the frame's load until its silence is an error
const EMPTY = 'drawing.svg';
const SERVE = 'serve the folder "page" of batten-editor, and say where with the attribute page';
/** The page that the package has inside, for elements that name no other. @type {import('./inside.js').Inside | null} */
let inside = null;

/** The last part of an address, as the name of a file. */
function nameOf(address) {
  try {
    return decodeURIComponent(new URL(address, 'http://x/').pathname.split('/').pop()) || EMPTY;
  } catch {
    return EMPTY;
  }
}

/** Whether a frame of an editor shows a page that is none. Of frames of other origins that cannot be seen. */
function isAnother(frame) {
  const root = frame?.getRootNode();
  return root?.host?.localName === 'batten-editor' && Boolean(frame.contentDocument?.head) &&
    !frame.contentDocument.querySelector('meta[name="batten-embedded"]') && frame.contentDocument.URL !== 'about:blank';
}

/** @param {Uint8Array[]} parts */
function joined(parts) {
  const whole = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

/** Saves text as a file in the browser's folder of downloads. */
function download(document, text, name, type) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** The element <batten-editor>. */
export class BattenEditor extends (globalThis.HTMLElement ?? class {}) {
  static observedAttributes = ['src', 'page', 'title'];

  #root;
  #slot; // what the element contains is shown until the frame answers
  #frame = null;
  #window = null; // where the frame's word is heard
  #met = false; // the frame has answered
  #patience = 0;
  #port = null;
  #number = 0;
  #calls = new Map(); // by number: what the frame has to answer
  #ready = false; // the frame shows a drawing
  #busy = false; // it is opening one, or asks the user whether to
  #queue = []; // what to open, in this order
  #asked = null; // the last src that was fetched
  #fetching = 0; // its number; 0: it is there
  #base = null; // the file that was opened last, in whatever frame
  #name = EMPTY;
  #journal = []; // what was done to it, in parts
  #svg = '';
  #unsaved = false;

  constructor() {
    super();
    this.#root = this.attachShadow({ mode: 'open', delegatesFocus: true });
    const sheet = new CSSStyleSheet(); // allowed where a policy forbids inline styles
    sheet.replaceSync(`:host { display: block; block-size: 30rem } :host([hidden]), .away { display: none }
      iframe { border: 0; inline-size: 100%; block-size: 100%; display: block }`);
    this.#root.adoptedStyleSheets = [sheet];
    this.#slot = this.ownerDocument.createElement('slot');
    this.#root.append(this.#slot);
  }

  /** Address of the drawing. @returns {string} */
  get src() {
    return this.getAttribute('src') ?? '';
  }

  /** Opens the drawing at an address. @param {string} address */
  set src(address) {
    this.setAttribute('src', address);
  }

  /** Address of the editor's page; '': the one inside the package. @returns {string} */
  get page() {
    return this.getAttribute('page') ?? '';
  }

  /** @param {string} address */
  set page(address) {
    this.setAttribute('page', address);
  }

  /** The drawing as of the last event `ready` or `change`. @returns {string} */
  get svg() {
    return this.#svg;
  }

  /** Whether anything was drawn since the drawing was opened or saved. @returns {boolean} */
  get unsaved() {
    return this.#unsaved;
  }

  /** The drawing as it is now. @returns {Promise<string>} */
  async read() {
    await this.#call({});
    return this.#svg;
  }

  /** Saves as the editor's command does: the event `save` follows. */
  async save() {
    await this.#call({ save: true });
  }

  /** Opens a drawing. @param {string | Uint8Array | ArrayBuffer} content @param {string} [name] @returns {Promise<boolean>} whether it is open */
  load(content, name = EMPTY) {
    this.#asked = this.src; // what it still brings comes too late
    this.#fetching = 0;
    return this.#open(typeof content === 'string' ? new TextEncoder().encode(content) : new Uint8Array(content), name);
  }

  /** The element is in a page now: a frame of the editor is begun. */
  connectedCallback() {
    const document = this.ownerDocument;
    this.#window = document.defaultView;
    this.#window.addEventListener('message', this.#hear);
    const frame = document.createElement('iframe');
    frame.title = this.title || 'Batten';
    frame.allow = 'clipboard-read; clipboard-write; fullscreen';
    this.#frame = frame;
    if (isAnother(this.#window.frameElement)) {
      return; // this page is shown by such an element by mistake
    }
    const { page } = this;
    if (page) {
      const address = new URL('index.html', new URL(page.replace(/\/?$/, '/'), document.baseURI)).href;
      this.#show(frame, address, `No editor at ${address}: ${SERVE}`);
    } else if (inside) {
      inside.address().then((address) => this.#show(frame, address, `The editor did not start. Where a policy forbids frames and scripts from blob:, ${SERVE}`))
        .catch((error) => this.#tell('error', { message: `The editor could not be unpacked: ${error}` }));
    } else {
      this.#tell('error', { message: `batten-editor/bare has no editor inside: ${SERVE}` });
    }
    this.#fetch();
  }

  /** Shows the editor at an address. @param {HTMLIFrameElement} frame @param {string} address @param {string} none what is told when none is there */
  #show(frame, address, none) {
    if (this.#frame !== frame) {
      return; // the element has gone meanwhile
    }
    frame.addEventListener('load', () => {
      if (isAnother(frame)) {
        frame.remove(); // such as the page that has this element, which servers send in place of what they lack
        this.#tell('error', { message: none });
      } else if (!this.#met) {
        this.#patience = setTimeout(() => this.#tell('error', { message: none }), PATIENCE);
      }
    });
    frame.src = address;
    this.#root.append(frame);
  }

  /** The frame is gone. Its port stays open until there is another: what it said last is on its way. */
  disconnectedCallback() {
    this.#window?.removeEventListener('message', this.#hear);
    clearTimeout(this.#patience);
    this.#frame?.remove();
    this.#frame = this.#window = null;
    this.#met = false;
    this.#slot.className = '';
    this.#gone();
  }

  /** Nothing that was asked of the frame will be answered. */
  #gone() {
    this.#ready = this.#busy = false;
    for (const done of this.#calls.values()) {
      done({ gone: true });
    }
    this.#calls.clear();
  }

  /** Moved without leaving the page: the frame stays. */
  connectedMoveCallback() {}

  /** @param {string} name @param {string | null} before @param {string | null} value */
  attributeChangedCallback(name, before, value) {
    if (!this.#frame || before === value) {
      return;
    }
    if (name === 'src') {
      this.#fetch();
    } else if (name === 'title') {
      this.#frame.title = value || 'Batten';
    } else {
      this.disconnectedCallback();
      this.connectedCallback();
    }
  }

  /** Sends an event. @param {string} type @param {object} detail @param {EventInit} options @returns {boolean} whether nobody prevented what follows */
  #tell(type, detail, options = {}) {
    return this.dispatchEvent(new CustomEvent(type, { detail, ...options }));
  }

  /** The frame's first word, also after it was loaded anew. */
  #hear = ({ source, data }) => {
    if (!source || source !== this.#frame?.contentWindow || data !== 'batten-editor') {
      return;
    }
    clearTimeout(this.#patience);
    this.#port?.close();
    this.#gone();
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = (event) => this.#take(port1, event.data);
    this.#port = port1;
    this.#met = true;
    this.#slot.className = 'away';
    source.postMessage('batten-editor', new URL(this.#frame.src).origin, [port2]);
    this.#next();
  };

  /** What the frame says. */
  #take(port, { answered, keep, more, name, told, unsaved, byUser, id, save, type, ...rest }) {
    if (answered) {
      this.#calls.get(answered)?.(rest);
      this.#calls.delete(answered);
    } else if (keep) {
      this.#journal = more ? [...this.#journal, keep] : [keep];
      this.#name = name;
    } else if (told !== undefined) {
      this.#svg = told;
      this.#unsaved = unsaved;
      if (byUser) {
        this.#tell('change', { svg: told });
      }
    } else if (save !== undefined) {
      void this.#store({ text: save, name, type }).then((why) => port.postMessage({ answered: id, why }));
    }
  }

  /** @returns {Promise<string>} why it could not be saved */
  async #store({ text, name, type }) {
    const stored = [];
    let taken = false;
    const waitUntil = (promise) => {
      taken = true;
      stored.push(promise);
    };
    if (this.#tell('save', { text, name, type, waitUntil }, { cancelable: true }) && !taken) {
      download(this.ownerDocument, text, name, type);
    }
    try {
      await Promise.all(stored);
      return '';
    } catch (error) {
      return error instanceof Error ? error.message : String(error);
    }
  }

  /** Sends something to a frame that shows a drawing, and waits for its answer. */
  #call(message) {
    return this.#ready ? this.#send(message) : Promise.resolve({});
  }

  /** Sends something to the frame, and waits for its answer. @param {object} message @returns {Promise<{ opened?: boolean, why?: string, gone?: boolean }>} */
  #send(message) {
    const id = ++this.#number;
    return new Promise((resolve) => {
      this.#calls.set(id, resolve);
      this.#port.postMessage({ ...message, id });
    });
  }

  /** Opens a file when those before it are open. @param {Uint8Array} bytes @param {string} name @param {string} [why] it could not be got, for this reason @returns {Promise<boolean>} */
  #open(bytes, name, why = '') {
    return new Promise((resolve) => {
      this.#queue.push({ bytes, name, why, done: resolve });
      this.#next();
    });
  }

  /** Gives the frame what it opens next: first what was open in the frame before it. */
  async #next() {
    if (!this.#met || this.#busy) {
      return;
    }
    const first = !this.#ready;
    const goOn = first && this.#base !== null;
    if (!goOn && !this.#queue.length && (!first || this.#fetching)) {
      return;
    }
    const asked = goOn ? { ...this.#base, name: this.#name, journal: joined(this.#journal), unsaved: this.#unsaved } :
      this.#queue[0] ?? { bytes: new Uint8Array(0), name: EMPTY };
    const { done, ...open } = asked;
    this.#busy = true;
    const { opened, why, gone } = await this.#send({ open: { ...open, first } });
    if (gone) {
      return; // it is still in the queue
    }
    this.#busy = false;
    this.#ready = true;
    if (!goOn) {
      this.#queue = this.#queue.filter((one) => one !== asked);
      if (opened || this.#base === null) {
        this.#base = opened ? { bytes: open.bytes } : { bytes: new Uint8Array(0) };
      }
    }
    done?.(opened === true);
    if (why) {
      this.#tell('error', { message: why });
    }
    if (first) {
      this.#tell('ready', { svg: this.#svg });
    }
    await this.#next();
  }

  /** Fetches the drawing at src, once; of several, the one asked for last. */
  async #fetch() {
    const { src } = this;
    if (src === this.#asked || !src) {
      return;
    }
    this.#asked = src;
    const number = ++this.#number;
    this.#fetching = number;
    let [bytes, why] = [new Uint8Array(0), ''];
    try {
      const response = await fetch(new URL(src, this.ownerDocument.baseURI));
      why = response.ok ? '' : `${response.status} ${response.statusText}`.trim();
      bytes = why ? bytes : new Uint8Array(await response.arrayBuffer());
    } catch (error) {
      why = String(error);
    }
    if (this.#fetching === number) {
      this.#fetching = 0;
      this.#asked = why ? null : src;
      await this.#open(bytes, why ? src : nameOf(src), why);
    }
  }
}

/** Makes <batten-editor> known, once. @param {import('./inside.js').Inside | null} page what elements show that name no other */
export function define(page) {
  inside ??= page;
  if (globalThis.customElements && !customElements.get('batten-editor')) {
    customElements.define('batten-editor', BattenEditor);
  }
}
