// Where the module comes from: the package has it inside, as text, so that no bundler, server or worker has to find a file.
import { BattenError } from './error.js';
import { Batten } from './library.js';

const MAGIC = 0x0061736d; // what a module begins with

/** What text in base64 holds, uncompressed. @param {string} text @returns {Promise<ArrayBuffer>} */
function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

/** Bytes at an address. @param {string | URL} address @returns {Promise<BufferSource>} */
async function fetched(address) {
  const { process, location } = globalThis;
  const url = new URL(address, location?.href ?? `file://${process?.cwd?.() ?? ''}/`);
  const files = url.protocol === 'file:' && process?.getBuiltinModule?.('node:fs/promises');
  const refuse = (why) => {
    throw new BattenError('state', `${url} ${why}. load({ wasm }) takes the address of batten.wasm, its bytes or a WebAssembly.Module; without it the module in the package is used`);
  };
  if (files) {
    return files.readFile(url).catch((error) => refuse(`cannot be read: ${error.message}`));
  }
  const response = await fetch(url).catch((error) => refuse(`cannot be fetched: ${error.message}`));
  if (!response.ok) {
    refuse(`is not there: ${response.status} ${response.statusText}`);
  }
  const bytes = await response.arrayBuffer();
  if (bytes.byteLength < 4 || new DataView(bytes).getUint32(0) !== MAGIC) {
    refuse(`is no WebAssembly but ${response.headers.get('content-type')}`);
  }
  return bytes;
}

/** @param {string | URL | BufferSource | WebAssembly.Module} source @returns {Promise<WebAssembly.Module>} */
async function moduleOf(source) {
  if (source instanceof WebAssembly.Module) {
    return source;
  }
  const isBytes = ArrayBuffer.isView(source) || source instanceof ArrayBuffer;
  return WebAssembly.compile(isBytes ? source : await fetched(source));
}

/**
 * Makes the function load() of a module.
 * @param {string | null} inside the module that the package has: gzip in base64; null: callers have to give one
 * @param {object} tables what the module can, which are to be in place
 */
export function loader(inside, tables) {
  /** @type {Promise<WebAssembly.Module> | null} */
  let own = null; // compiled once
  /** Loads the library. @param {{ wasm?: string | URL | BufferSource | WebAssembly.Module }} [options] @returns {Promise<Batten>} */
  return async function load({ wasm, ...others } = {}) {
    const [other] = Object.keys(others);
    if (other !== undefined) {
      throw new BattenError('argument', `load has no option ${other}`);
    }
    if (wasm === undefined && inside === null) {
      throw new BattenError('argument', "batten-core/bare has no module inside: load({ wasm }) says where it is, or import 'batten-core'");
    }
    if (wasm === undefined) {
      own ??= unpacked(inside).then((bytes) => WebAssembly.compile(bytes));
    }
    return new Batten(await WebAssembly.instantiate(await (wasm === undefined ? own : moduleOf(wasm)), {}), tables);
  };
}
