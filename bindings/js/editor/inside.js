// The editor's page as this package has it inside: its files become objects that only this document can address.

/** Files of a document, by name. */
export class Inside {
  #packed;
  /** @type {Promise<string> | null} */
  #address = null;

  /** @param {string} packed gzip in base64, of lines: a name, a media type and a length; after an empty line the files, one after the other */
  constructor(packed) {
    this.#packed = packed;
  }

  /** The page's address. @returns {Promise<string>} */
  address() {
    this.#address ??= this.#unpack();
    return this.#address;
  }

  /** Makes an object of each file, and the page's address. @returns {Promise<string>} */
  async #unpack() {
    const letters = Uint8Array.from(atob(this.#packed), (letter) => letter.charCodeAt(0));
    const bytes = new Uint8Array(await new Response(new Blob([letters]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer());
    const head = new TextDecoder().decode(bytes.subarray(0, 1 << 16)).split('\n\n', 1)[0];
    let at = head.length + 2;
    const addresses = {};
    const make = (part, type) => URL.createObjectURL(new Blob(part, { type }));
    for (const [name, type, length] of head.split('\n').map((line) => line.split(' '))) {
      const part = bytes.subarray(at, at += Number(length));
      if (name === 'index.html') { // the last: it names others
        const text = new TextDecoder().decode(part).replace('%ADDRESSES%', JSON.stringify(addresses));
        return make([text.replace(/%([\w./-]+)%/g, (_, other) => addresses[other])], type);
      }
      // A script that stands alone, of a worker, has no document to read the addresses in.
      addresses[name] = make(/worker\.js$/.test(name) ? [`globalThis.battenAddresses=${JSON.stringify(addresses)};`, part] : [part], type);
    }
    throw new Error('batten-editor has no page inside');
  }
}
