// Pictures and prints of an SVG file: the browser paints it, isolated as an image, so that nothing in it runs or is fetched.

import { isolated } from '../stage/pictures.js';
import { Refusal, word } from '../page/words.js';

const MOST = 16384; // pixels a side
const AREA = 1 << 28;
/** Up to so many pixels a picture is painted four times as large and averaged: browsers paint small circles with a few straight lines. */
const SMALL = 1 << 20;

/** @param {CanvasImageSource} source @param {number[]} size */
function painted(source, [width, height]) {
  const canvas = new OffscreenCanvas(width, height);
  canvas.getContext('2d')?.drawImage(source, 0, 0, width, height); // half as large: each pixel is the middle of four
  return canvas;
}

/**
 * A picture of it. @param {Uint8Array} svg
 * @param {{ width: number, scale: number, white: boolean }} how width: pixels; 0: `scale` for each unit
 * @param {string} type of the picture
 * @returns {Promise<Blob>}
 */
export async function pictureOf(svg, { width, scale: each, white }, type) {
  const image = await isolated(svg);
  const scale = width ? width / image.width : each;
  const size = [image.width, image.height].map((side) => Math.max(1, Math.round(side * scale)));
  if (!(image.width > 0 && image.height > 0) || Math.max(...size) > MOST || size[0] * size[1] > AREA) {
    throw new Refusal(word('shell.too-large', `${size[0]} × ${size[1]}`));
  }
  let times = size[0] * size[1] <= SMALL ? 4 : 1;
  let canvas = painted(image, size.map((side) => side * times));
  for (; times > 1; times /= 2) {
    canvas = painted(canvas, size.map((side) => side * times / 2));
  }
  const context = canvas.getContext('2d');
  if (context && white) {
    context.globalCompositeOperation = 'destination-over';
    context.fillStyle = '#fff';
    context.fillRect(0, 0, size[0], size[1]);
  }
  const blob = await canvas.convertToBlob({ type, quality: 1 });
  if (blob.type !== type) { // browsers make a PNG of what they do not know
    throw new Refusal(word('shell.not-written'));
  }
  return blob;
}

/** Opens the browser's print window with it alone, on a page of its size. @param {Uint8Array} svg */
export async function print(svg) {
  const image = await isolated(svg);
  printAlone(image, `@page { size: ${image.width}px ${image.height}px; margin: 0 }
    @media print { #print { width: ${image.width}px; height: ${image.height}px } }`);
}

/** Opens the browser's print window with that element alone, as `#print`. @param {HTMLElement} element @param {string} css of the print */
export function printAlone(element, css) {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(`${css}
    @media print { body > :not(#print) { display: none !important } html, body { overflow: visible !important; background: #fff !important } #print { display: block } }
    @media screen { #print { display: none } }`);
  element.id = 'print';
  document.body.append(element);
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
  window.addEventListener('afterprint', () => {
    element.remove();
    document.adoptedStyleSheets = document.adoptedStyleSheets.filter((other) => other !== sheet);
  }, { once: true });
  window.print();
}
