// batten.wasm in its two parts. The first has what shows a drawing and draws on it; the second is fetched when
// somebody is there, and at the latest when something in it is called.

/** @param {string} url */
async function compile(url) {
  const response = await fetch(url);
  if (!response.ok) {
    throw new Error(`${url}: ${response.status} ${response.statusText}`);
  }
  return WebAssembly.compileStreaming(response);
}

/** The same while the caller waits: an engine in the midst of a call cannot be left. @param {string} url */
function compileNow(url) {
  const request = new XMLHttpRequest();
  request.open('GET', url, false);
  request.overrideMimeType('text/plain; charset=x-user-defined'); // a byte a character, in its lower half
  request.send();
  if (request.status !== 200) {
    throw new Error(`${url}: ${request.status} ${request.statusText}`);
  }
  return new WebAssembly.Module(Uint8Array.from(request.responseText, (c) => c.charCodeAt(0)));
}

export class Module {
  /** @param {WebAssembly.Module} first @param {string} later */
  constructor(first, later) {
    this.first = first;
    this.later = later;
    /** @type {WebAssembly.Module | null} */
    this.second = null;
  }

  /** @param {string} first @param {string} later */
  static async load(first, later) {
    return new Module(await compile(first), later);
  }

  /** Fetches the second part. */
  async complete() {
    this.second ??= await compile(this.later);
  }

  /**
   * A new instance. The second part joins it when one of its functions, for which placeholders stand in the table, is
   * called.
   * @param {WebAssembly.ModuleImports} host
   */
  instantiate(host) {
    const placeholder = new Proxy({}, {
      get: (_, slot) => (/** @type {unknown[]} */ ...values) => {
        this.second ??= compileNow(this.later);
        new WebAssembly.Instance(this.second, { primary: instance.exports });
        return table.get(Number(slot))(...values);
      },
    });
    const instance = new WebAssembly.Instance(this.first, { host, placeholder });
    const table = /** @type {WebAssembly.Table} */ (
      Object.values(instance.exports).find((value) => value instanceof WebAssembly.Table));
    return instance;
  }
}
