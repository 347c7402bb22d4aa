// The files of this build. They stand in a folder named by their content: a page gets its own or none.

/** A file of this build cannot be had. */
export class Missing extends Error {}

/** @param {string} name a path in this folder @returns {string} */
export const addressOf = (name) => new URL(`../${name}`, import.meta.url).href;

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

let missed = false;
/** @type {() => void} */
let tell = () => {};

/** Something is missing: the user is told. @param {unknown} error */
export function miss(error) {
  console.error(error);
  missed = true;
  tell();
}

/** @param {() => void} run tells the user */
export function whenMissing(run) {
  tell = run;
  if (missed) {
    run();
  }
}

/**
 * What is fetched only when it is wanted. When it cannot be had the user is told, and what was to follow does not.
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

/** Gives the page a style sheet of this build. @param {string} name @returns {Promise<void>} it is there */
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
