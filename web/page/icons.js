// Icons: symbols of a sprite that is part of the page, so that they take the colour of the surrounding text.

import { get } from './build.js';

const NAMESPACE = 'http://www.w3.org/2000/svg';
/** @type {Map<string, Promise<void>>} */
const sprites = new Map();

/** Adds the icons of a sprite to the page, once. */
export function loadIcons(sprite = 'sprite') {
  const fetched = sprites.get(sprite) ?? get(`icons/${sprite}.svg`).then(async (response) => {
    const root = new DOMParser().parseFromString(await response.text(), 'image/svg+xml').documentElement;
    root.setAttribute('hidden', '');
    document.body.append(root);
  });
  sprites.set(sprite, fetched);
  return fetched;
}

/** @param {string} name @returns {SVGSVGElement | null} null when no loaded sprite has it */
export function icon(name) {
  if (!document.getElementById(`icon-${name}`)) {
    return null;
  }
  const picture = document.createElementNS(NAMESPACE, 'svg');
  picture.setAttribute('class', 'icon');
  picture.setAttribute('aria-hidden', 'true');
  const use = document.createElementNS(NAMESPACE, 'use');
  use.setAttribute('href', `#icon-${name}`);
  picture.append(use);
  return picture;
}
