// batten.wasm in its two parts. The first is enough to show and view a drawing; the second is fetched when the page has
// loaded, and at the latest when one of its functions is called. The two import from each other under the name of
// their build, so that parts of different builds are never joined.

import { addressOf, get, Missing } from '../page/build.js';

const FIRST = 'batten.wasm';
const LATER = 'batten-later.wasm';

/** Fetches a part; also from a server that does not know what a .wasm file is. @param {string} name */
async function compiled(name) {
  const response = await get(name);
  return response.headers.get('content-type') === 'application/wasm' ? WebAssembly.compileStreaming(response) :
    WebAssembly.compile(await response.arrayBuffer());
}

/** Fetches the second part synchronously: an engine in the middle of a call cannot be left. */
function compileNow() {
  const request = new XMLHttpRequest();
  request.open('GET', addressOf(LATER), false);
  request.overrideMimeType('text/plain; charset=x-user-defined'); // one byte per character, in its low eight bits
  request.send();
  if (request.status !== 200) {
    throw new Error(`${request.status} ${request.statusText}`);
  }
  return new WebAssembly.Module(Uint8Array.from(request.responseText, (c) => c.charCodeAt(0)));
}

export class Module {
  /** @param {WebAssembly.Module} first */
  constructor(first) {
    this.first = first;
    this.build = WebAssembly.Module.imports(first).find(({ module }) => module !== 'host')?.module ?? '';
    /** @type {WebAssembly.Module | null} */
    this.second = null;
    /** @type {Promise<void> | null} */
    this.coming = null;
    /** Instances that the second part has not joined yet. @type {Set<WebAssembly.Exports>} */
    this.waiting = new Set();
  }

  static async load() {
    return new Module(await compiled(FIRST));
  }

  /** Fetches the second part. @returns {Promise<void>} */
  complete() {
    this.coming ??= compiled(LATER).then((second) => {
      this.#take(second);
      this.waiting.forEach((primary) => this.#join(primary)); // the texts in it are shown before anything of it is called
    }).catch((error) => {
      this.coming = null;
      throw new Missing(`${LATER}: ${error}`);
    });
    return this.coming;
  }

  /** @param {WebAssembly.Module} second */
  #take(second) {
    if (WebAssembly.Module.imports(second).some(({ module }) => module !== this.build)) {
      throw new Error('of another build');
    }
    this.second = second;
  }

  /** Joins the second part to an instance of the first. @param {WebAssembly.Exports} primary */
  #join(primary) {
    try {
      if (!this.second) {
        this.#take(compileNow());
      }
    } catch (error) {
      throw new Missing(`${LATER}: ${error}`);
    }
    new WebAssembly.Instance(/** @type {WebAssembly.Module} */ (this.second), { [this.build]: primary });
    this.waiting.delete(primary);
  }

  /**
   * Makes a new instance. The second part joins it when it comes, and at the latest when one of its functions, for which the
   * table has placeholders, is called; if it is missing, the call throws an error that says so.
   * @param {WebAssembly.ModuleImports} host
   */
  instantiate(host) {
    const placeholders = new Proxy({}, {
      get: (_, slot) => (/** @type {unknown[]} */ ...values) => {
        this.#join(instance.exports);
        return table.get(Number(slot))(...values);
      },
    });
    const instance = new WebAssembly.Instance(this.first, { host, [this.build]: placeholders });
    const table = /** @type {WebAssembly.Table} */ (
      Object.values(instance.exports).find((value) => value instanceof WebAssembly.Table));
    this.waiting.add(instance.exports);
    if (this.second) {
      this.#join(instance.exports);
    }
    return instance;
  }
}
