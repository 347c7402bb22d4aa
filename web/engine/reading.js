// Files of every format as the engine takes them.

/** @typedef {import('./engine.js').Engine} Engine */

/** What is read at once, while the page waits: so small that nothing in it takes long, and nothing repeats what it holds. */
const QUICK = 1 << 15; // bytes
const REPEATS = /<([\w-]+:)?(use|pattern|marker|mask|clipPath)\b|<!DOCTYPE/;
const GZIP = 0x8b1f;

/** @param {string} name */
export const isNative = (name) => name.toLowerCase().endsWith('.batten');

/** @param {Uint8Array} bytes */
export const isPacked = (bytes) => bytes.length > 1 && bytes[0] + 256 * bytes[1] === GZIP;

/**
 * The text of an XML file in whatever encoding it declares.
 * @param {Uint8Array} bytes
 */
function decodeXml(bytes) {
  const start = new TextDecoder('latin1').decode(bytes.subarray(0, 200));
  let label = /^<\?xml[^>]*encoding=["']([\w.:-]+)["']/.exec(start)?.[1] ?? 'utf-8';
  if (start.startsWith('\xff\xfe') || start.startsWith('\xfe\xff')) {
    label = start.startsWith('\xff') ? 'utf-16le' : 'utf-16be';
  }
  try {
    return new TextDecoder(label).decode(bytes);
  } catch {
    return new TextDecoder().decode(bytes);
  }
}

/** @param {string} text */
export const isQuickText = (text) => text.length <= QUICK && !REPEATS.test(text);

/** @param {Uint8Array} bytes */
export const isQuick = (bytes) => bytes.length <= QUICK && !isPacked(bytes) && isQuickText(decodeXml(bytes));

/** What only the whole module reads: what is no XML, Batten's own data, and what is rare in small drawings. */
const MORE = /^\s*[^<\s]|\bxmlns:batten=|<(\w+Gradient|style|text|image|symbol)\b|\btransform=/;

/** Whether the module's first part is enough to open it. @param {Uint8Array} bytes @param {string} name */
export const isPlain = (bytes, name) => !isNative(name) && isQuick(bytes) && !MORE.test(decodeXml(bytes));

/**
 * Opens the bytes of a file in an engine; throws its refusal.
 * @param {Engine} engine @param {Uint8Array} bytes @param {string} name @param {import('./svg_reader.js').Watch} [watch]
 */
export function readInto(engine, bytes, name, watch) {
  const first = decodeXml(bytes.subarray(0, 256)).trimStart()[0];
  const svg = /\.svgz?$/i.test(name);
  if (isNative(name) || (svg && first === '{')) {
    engine.openNative(bytes, name);
  } else if (svg || first === '<' || first === undefined) {
    engine.openSvg(decodeXml(bytes), name, watch);
  } else {
    engine.openFile(bytes, name);
  }
}

/**
 * Adds what a file holds to the drawing; throws its refusal.
 * @param {Engine} engine @param {Uint8Array} bytes @param {string} name @param {boolean} grouped as one group
 * @param {import('./svg_reader.js').Watch} [watch]
 */
export function addTo(engine, bytes, name, grouped, watch) {
  if (/\.svgz?$/i.test(name)) {
    engine.pasteSvg(decodeXml(bytes), watch);
  } else {
    engine.pasteFile(bytes, name);
  }
  if (grouped && engine.actions().includes('group')) { // more than one object
    engine.command('group');
  }
}
