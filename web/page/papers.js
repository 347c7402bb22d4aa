// Sizes of paper by their names, upright, in millimetres: for the page, and for what is printed.

/** Width and height. @typedef {[number, number]} Sides */

/** @type {Record<string, Sides>} */
export const PAPERS = { A5: [148, 210], A4: [210, 297], A3: [297, 420], Letter: [215.9, 279.4], Legal: [215.9, 355.6] };
