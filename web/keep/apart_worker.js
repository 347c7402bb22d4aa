// The worker that reads a file, or adds it to the drawing, in a copy of the page's engine: the page goes on meanwhile, and takes
// what the copy has become. It ends with its answer, or when the page ends it.

import { Engine } from '../engine/engine.js';
import { beyond, LIMITS } from '../engine/limits.js';
import { Module } from '../engine/module.js';
import { addTo, readInto } from '../engine/reading.js';
import '../engine/xml_types.js';
import { speakAs } from '../page/words.js';
import { bytesOf } from './gzip.js';

/** @typedef {import('./apart.js').Order} Order */
/** @typedef {import('./apart.js').Answer} Answer */

const OFTEN = 50; // milliseconds between two words of progress
const UNPACKED = 0.3; // of the progress

const SEGMENT = 7; // numbers of a curve's segment in a painted path

let told = 0;

/** @param {number} share how much has been read; 1: the drawing is being made of it */
function tell(share) {
  const now = performance.now();
  if (share === 1 || now - told > OFTEN) {
    told = now;
    postMessage({ share });
  }
}

/** What the first frame needs is made here; refuses what could not be painted. @param {Engine} engine */
function prepare(engine) {
  const frame = engine.frame();
  const numbers = (frame?.still ?? []).reduce((sum, { path }) => sum + path.length, 0);
  if (numbers / SEGMENT > LIMITS.segments) {
    throw beyond('segments');
  }
}

/** @param {Order} order @returns {Promise<Answer>} */
async function read({ first, second, image, texts, file, name, how, asked }) {
  speakAs(texts);
  const module = new Module(first);
  module.second = second;
  const engine = new Engine(module);
  [engine.size, engine.readOnly] = [image.size, image.readOnly];
  engine.adopt(image, false);
  const bytes = await bytesOf(file, (share) => tell(UNPACKED * share));
  const watch = (/** @type {number} */ share) => tell(UNPACKED + (1 - UNPACKED) * share);
  if (how === 'open') {
    readInto(engine, bytes, name, watch);
  } else {
    addTo(engine, bytes, name, how === 'add', watch);
  }
  prepare(engine);
  const content = asked ? { svg: engine.save(false), holds: JSON.parse(engine.ask('editor_holds')), losses: engine.losses,
    keeps: engine.keeps } : null;
  return { image: engine.image(), bytes, content };
}

addEventListener('message', async ({ data }) => {
  try {
    const answer = await read(data);
    postMessage({ answer }, { transfer: [answer.image.memory.buffer, answer.bytes.buffer] });
  } catch (error) {
    postMessage({ refused: error instanceof Error ? error.message : String(error) });
  }
});
