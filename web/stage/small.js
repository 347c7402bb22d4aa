// A small picture of a drawing, on white paper whatever the theme: the page as a whole, or all that is drawn where there is none. On the
// page and in a worker.

import { Role } from '../engine/codes.js';
import { isPage } from '../engine/frame.js';
import { Painter } from './paint.js';
import { paintShape, shapeOf } from './shape.js';

/** @typedef {import('../engine/types.js').Item} Item */

const WIDTH = 320; // pixels, at most
const HEIGHT = 240;
const LEAST = 8;
const MARGIN = 0.05; // of what is drawn, where there is no page
const MOST = 200000; // numbers of a path that is painted
const QUALITIES = [0.85, 0.5]; // the second where the first is too large

const NOTHING = { stroke: 'transparent', fill: 'transparent' };
/** What a frame takes the colours from: paper is white, guides and grids are not painted. @type {any} */
export const THEME = {
  ground: '#fff',
  paper: '#fff',
  turned: false,
  roles: Object.values(Role).map((role) => (role === Role.PAGE || role === Role.PAGE_BACK ? { stroke: 'transparent', fill: '#fff' } : NOTHING)),
  colour: (/** @type {number} */ rgba) => `rgb(${rgba >>> 24} ${(rgba >>> 16) & 255} ${(rgba >>> 8) & 255} / ${(rgba & 255) / 255})`,
};

/** Paints paths that take long at once, or not at all. @type {any} */
const HEAVY = {
  keep() {},
  /** @param {any} context @param {Item} _item @param {Float32Array} path @param {import('./shape.js').Look} look */
  draw(context, _item, path, look) {
    if (path.length < MOST) {
      paintShape(context, shapeOf(path), look);
    }
  },
};

/** Where it is painted. @returns {any} */
const canvas = () => Object.assign(new OffscreenCanvas(1, 1), { style: {} });

/** What is to be seen: the page, or all with room around it in the proportions of a picture. null: nothing is drawn. @param {Item[]} items */
function boxOf(items) {
  const page = items.find(isPage);
  const seen = page ? [page] : items.filter(({ role, x0, x1 }) => (role === Role.OBJECT || role === Role.IMAGE) && x0 <= x1);
  const least = (/** @type {(item: Item) => number} */ of) => seen.reduce((low, item) => Math.min(low, of(item)), Infinity);
  const box = [least((item) => item.x0), least((item) => item.y0), -least((item) => -item.x1), -least((item) => -item.y1)];
  const [wide, high] = [box[2] - box[0], box[3] - box[1]];
  if (!Number.isFinite(wide + high) || Math.min(wide, high) < 0 || Math.max(wide, high) === 0) {
    return null;
  }
  const unit = (1 + 2 * MARGIN) * Math.max(wide / WIDTH, high / HEIGHT);
  const [width, height] = page ? [wide, high] : [unit * WIDTH, unit * HEIGHT];
  return { x: (box[0] + box[2] - width) / 2, y: (box[1] + box[3] - height) / 2, width, height };
}

/** @returns {Painter} that paints small pictures */
export function smallPainter() {
  return Object.assign(new Painter(canvas(), canvas(), THEME), { heavy: HEAVY });
}

/**
 * Paints the painter's list, or `still` in place of it. @param {Painter} painter @param {Item[]} [still]
 * @returns {boolean} whether there was anything to paint
 */
export function paintSmall(painter, still) {
  const box = boxOf(still ?? painter.list.map(({ item }) => item));
  if (!box) {
    return false;
  }
  const zoom = Math.min(WIDTH / box.width, HEIGHT / box.height); // a side of 0 leaves the other
  painter.resize(Math.max(LEAST, Math.round(box.width * zoom)), Math.max(LEAST, Math.round(box.height * zoom)), 1);
  painter.paint(/** @type {any} */ ({ x: box.x, y: box.y, zoom, angle: 0, originX: 0, originY: 0, still: still ?? [], stillChanged: still !== undefined,
    dirty: [1, 1, 0, 0], live: [], labels: [] }));
  return true;
}

/** What has been painted. @param {Painter} painter @param {number} largest bytes @returns {Promise<Blob | null>} null: it would be larger */
export async function encoded(painter, largest) {
  for (const quality of QUALITIES) {
    const blob = await /** @type {any} */ (painter.still).convertToBlob({ type: 'image/webp', quality });
    if (blob.size <= largest) {
      return blob;
    }
  }
  return null;
}
