// The worker of keep.js, which reads and writes what is kept, one job after the other.

import { Opfs } from './opfs.js';
import { Cleared, Full, Store } from './store.js';

/** A call of the store, or of manage.js. @typedef {{ call: 'list' | 'take' | 'begin' | 'append' | 'release' | 'remove' | 'mark' | 'purge' | 'rename' | 'copy',
 * with: any[] }} Job */
/** @typedef {{ value?: unknown, fault: import('./keep.js').Fault | '', why?: string }} Answer */

const EARLIER = 'journals'; // the folder of earlier versions

async function start() {
  const opfs = await Opfs.find().catch(() => null);
  const store = new Store(opfs ?? await (await import('./database.js')).Database.find());
  const folders = await opfs?.root.getDirectoryHandle(EARLIER).catch(() => null);
  if (folders) {
    await (await import('./earlier.js')).takeOver(store, folders).catch(() => {});
  }
  await store.purge().catch(() => {});
  return store;
}

/** What the page says of a failure. @type {Record<string, import('./keep.js').Fault>} */
const FAULTS = { QuotaExceededError: 'no-room', NotFoundError: 'cleared' };

/** @param {unknown} error @returns {import('./keep.js').Fault} */
const faultOf = (error) => (error instanceof Full ? 'no-room' : error instanceof Cleared ? 'cleared' :
  FAULTS[error instanceof DOMException ? error.name : ''] ?? 'not-kept');

/** @param {Promise<Store>} store @param {Job} job @returns {Promise<Answer>} */
async function answer(store, job) {
  try {
    const work = /** @type {any} */ (await store);
    const more = /** @type {any} */ (work[job.call] ? null : await import('./manage.js'));
    return { value: await (more ? more[job.call](work, ...job.with) : work[job.call](...job.with)), fault: '' };
  } catch (error) {
    return { fault: faultOf(error), why: String(error) };
  }
}

/** Jobs run one after the other; before them the worker reports that it runs. */
const store = start();
let last = store.then(() => {}, () => {});
postMessage('ready');
onmessage = ({ data }) => {
  last = last.then(() => answer(store, data)).then((told) => postMessage(told));
};
