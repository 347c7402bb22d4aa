// The files of this build. Their folder is named after their content, so a page gets its own files or none.

/** A file of this build is not available. */
export class Missing extends Error {}

const here = import.meta.url; // apart from the URL, or Vite's dev server takes the line for a list of all files

/** @param {string} name a path in this folder @returns {string} */
export const addressOf = (name) => new URL(`../${name}`, here).href;

const [, scope, build] = /^(.*\/)([^/]*)\/$/.exec(addressOf('')) ?? [];
/** Held as long as this page lives: so long the service worker keeps the files of its build, whatever comes after it. */
async function hold() {
  await navigator.locks?.request(`batten ${scope} ${build}`, { mode: 'shared' }, () => new Promise(() => {}));
}
hold().catch(() => {}); // the browser may not allow it; then it keeps no files either

/** @param {string} name @returns {Promise<Response>} */
export async function get(name) {
  const response = await fetch(addressOf(name)).catch((error) => {
    throw new Missing(`${name}: ${error}`);
  });
  if (!response.ok) {
    throw new Missing(`${name}: ${response.status} ${response.statusText}`);
  }
  return response;
}

const LEAVING = 100; // milliseconds in which a page that is being left is gone

let missed = false;
/** @type {() => void} */
let tell = () => {};

/** Tells the user that something is missing; not when it is because the page is being left. @param {unknown} error */
export function miss(error) {
  setTimeout(() => {
    console.error(error);
    missed = true;
    tell();
  }, LEAVING);
}

/** @param {() => void} run called to tell the user */
export function whenMissing(run) {
  tell = run;
  if (missed) {
    run();
  }
}

/**
 * Waits for a part that is fetched on demand. If it is not available, the user is told and the promise never settles.
 * @template T
 * @param {Promise<T>} part
 * @returns {Promise<T>}
 */
export function want(part) {
  return part.catch((error) => {
    miss(error);
    return new Promise(() => {});
  });
}

/** Adds a style sheet of this build to the page. @param {string} name @returns {Promise<void>} when it has loaded */
export function dress(name) {
  const sheet = document.createElement('link');
  sheet.rel = 'stylesheet';
  sheet.href = addressOf(name);
  document.head.append(sheet);
  return want(new Promise((resolve, reject) => {
    sheet.addEventListener('load', () => resolve());
    sheet.addEventListener('error', () => reject(new Missing(name)));
  }));
}

/**
 * Puts a box over the drawing once its style sheet is there: unstyled it would push the drawing aside. A frame follows, since what
 * is painted in the box could not be before.
 * @param {HTMLElement} box @param {string} name of the style sheet @param {{ stage: HTMLElement, wake: () => void }} shell
 */
export async function stand(box, name, { stage, wake }) {
  await dress(name);
  stage.after(box);
  wake();
}
