// Sizes by their names: of paper, upright, in millimetres, for the page and for what is printed; and of screens, in pixels.

/** Width and height. @typedef {[number, number]} Sides */

/** @type {Record<string, Sides>} */
export const PAPERS = { A5: [148, 210], A4: [210, 297], A3: [297, 420], Letter: [215.9, 279.4], Legal: [215.9, 355.6] };

/** Pixels: an icon, a post. @type {Record<string, Sides>} */
export const SCREENS = { '24 × 24 px': [24, 24], '1080 × 1080 px': [1080, 1080] };
