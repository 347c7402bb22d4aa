// The worker that reads a file, or adds it to the drawing, in a copy of the page's engine: the page goes on meanwhile, and takes
// what the copy has become. Or it writes the drawing. It ends with its answer, or when the page ends it.

import { Engine } from '../engine/engine.js';
import { adopt, imageOf } from '../engine/image.js';
import { beyond, LIMITS } from '../engine/limits.js';
import { Module } from '../engine/module.js';
import { addTo, readInto } from '../engine/reading.js';
import { XmlBomb } from '../engine/xml.js';
import '../engine/xml_types.js';
import { Anew, speakAs } from '../page/words.js';
import { bytesOf } from './gzip.js';

/** @typedef {import('./apart.js').Order} Order */
/** @typedef {import('./apart.js').Answer} Answer */

const OFTEN = 50; // milliseconds between two words of progress
const UNPACKED = 0.3; // of the progress

const SEGMENT = 7; // numbers of a curve's segment in a painted path

let lately = 0;

/** @param {number} share how much has been read; 1: the drawing is being made of it */
function tell(share) {
  const now = performance.now();
  if (share === 1 || now - lately > OFTEN) {
    lately = now;
    postMessage({ share });
  }
}

/** How many numbers path data or a list of points has, at least. @param {string} text */
function numbersIn(text) {
  let [count, within] = [0, false];
  for (let i = 0; i < text.length; i++) {
    const code = text.charCodeAt(i);
    const digit = (code >= 48 && code < 58) || code === 46;
    count += Number(digit && !within);
    within = digit;
  }
  return count;
}

/** Follows the reading of an SVG file, and refuses what is too much. @returns {import('../engine/svg_reader.js').Watch} */
function watch() {
  let [count, numbers] = [0, 0];
  return { expanded: LIMITS.expanded, see: (share, attributes) => {
    if (++count > LIMITS.elements) {
      throw beyond('elements');
    }
    for (let i = 0; i < attributes.length; i += 2) {
      numbers += attributes[i] === 'd' || attributes[i] === 'points' ? numbersIn(attributes[i + 1]) : 0;
    }
    if (numbers > 6 * LIMITS.segments) { // even if all are of cubics
      throw beyond('segments');
    }
    tell(share < 1 ? UNPACKED + (1 - UNPACKED) * share : 1);
  } };
}

/** What the first frame needs is made here; refuses what could not be painted. @param {Engine} engine */
function prepare(engine) {
  const frame = engine.frame();
  const numbers = (frame?.still ?? []).reduce((sum, { path }) => sum + path.length, 0);
  if (numbers / SEGMENT > LIMITS.segments) {
    throw beyond('segments');
  }
}

/** The page's engine. @param {Order} order */
function copied({ first, second, image, texts }) {
  speakAs(texts);
  const module = new Module(first);
  module.second = second;
  const engine = new Engine(module);
  [engine.size, engine.readOnly] = [image.size, image.readOnly];
  adopt(engine, image, false);
  return engine;
}

/** @param {Order} order @param {boolean} native @param {boolean} kept */
function write(order, native, kept) {
  const engine = copied(order);
  engine.onrecovery = (_, error) => { throw error; }; // the page has the journal
  return engine.save(native, kept);
}

/** @param {Order} order @returns {Promise<Answer>} */
async function read(order) {
  const { file, name, how, asked } = order;
  const engine = copied(order);
  const bytes = await bytesOf(file, (share) => tell(UNPACKED * share));
  if (how === 'open') {
    readInto(engine, bytes, name, watch());
  } else {
    addTo(engine, bytes, name, how === 'add', watch());
  }
  prepare(engine);
  const content = asked ? { svg: engine.save(false), holds: JSON.parse(engine.ask('editor_holds')), losses: engine.losses,
    lost: engine.lost, keeps: engine.keeps } : null;
  return { image: imageOf(engine), bytes, content };
}

addEventListener('message', async ({ data }) => {
  try {
    if (data.native !== undefined) {
      const written = write(data, data.native, data.kept);
      postMessage({ written }, { transfer: [written.buffer] });
      return;
    }
    const answer = await read(data);
    postMessage({ answer }, { transfer: [answer.image.memory.buffer, answer.bytes.buffer] });
  } catch (error) {
    if (error instanceof Anew) {
      postMessage({ anew: true });
      return;
    }
    const told = error instanceof XmlBomb ? beyond('expanded') : error;
    postMessage({ refused: told instanceof Error ? told.message : String(told) });
  }
});
