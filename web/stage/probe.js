// The eyedropper over the page: the drawing is shown in its own colours, and a press takes the one under it. With a lens that stands
// above the pointer; by keys a pixel at a time.

import { dress } from '../page/build.js';
import { tell } from '../page/words.js';

/** @typedef {import('../main.js').Shell} Shell */

const LENS = 11; // pixels across that the lens shows
const STEP = [1, 10]; // view pixels by an arrow key, and with Shift

/** The drawing as it is seen, in its own colours, on white. @param {Shell} shell @returns {Promise<HTMLCanvasElement>} */
async function pictureOf({ theme, painter, loop, wake }) {
  const canvas = document.createElement('canvas');
  const { roles, paper, ground, turned } = theme;
  const paint = () => {
    theme.colours.clear();
    painter.retheme();
    wake();
    return new Promise((resolve) => { requestAnimationFrame(resolve); }); // after the frame that was asked for
  };
  Object.assign(theme, { turned: false, paper: '#fff', ground: '#fff', roles: roles.map((role) => (role.fill === paper ? { ...role, fill: '#fff' } : role)) });
  await paint();
  Object.assign(canvas, { width: painter.still.width, height: painter.still.height });
  const context = canvas.getContext('2d', { willReadFrequently: true });
  context?.drawImage(painter.still, 0, 0);
  if (loop.space && !loop.space.canvas.hidden) {
    context?.drawImage(loop.space.canvas, 0, 0, canvas.width, canvas.height);
  }
  Object.assign(theme, { turned, paper, ground, roles });
  await paint();
  return canvas;
}

/** Lets a colour of the page be taken. @param {Shell} shell @returns {Promise<number | null>} 0xRRGGBBAA, opaque; null: cancelled */
export async function probe(shell) {
  const [canvas] = await Promise.all([pictureOf(shell), dress('styles/picker.css')]);
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  const box = tell(document.createElement('div'), { label: 'shell.picker-hint.help' });
  const lens = document.createElement('canvas');
  Object.assign(lens, { width: LENS, height: LENS, className: 'lens-colour' });
  box.className = 'probe';
  box.id = 'probe';
  box.tabIndex = 0;
  box.setAttribute('role', 'application');
  box.append(canvas, lens);
  shell.stage.after(box);
  box.focus();
  const size = () => box.getBoundingClientRect();
  let at = [size().width / 2, size().height / 2];

  /** Of the canvas. @returns {[number, number]} */
  const pixel = () => [Math.floor(at[0] * canvas.width / size().width), Math.floor(at[1] * canvas.height / size().height)];
  const colour = () => {
    const [red, green, blue] = context.getImageData(...pixel(), 1, 1).data;
    return ((red * 256 + green) * 256 + blue) * 256 + 255;
  };
  const show = () => {
    const [x, y] = pixel();
    const half = (LENS - 1) / 2;
    const paint = /** @type {CanvasRenderingContext2D} */ (lens.getContext('2d'));
    paint.clearRect(0, 0, LENS, LENS);
    paint.drawImage(canvas, x - half, y - half, LENS, LENS, 0, 0, LENS, LENS);
    box.style.setProperty('--x', `${at[0]}px`);
    box.style.setProperty('--y', `${at[1]}px`);
    box.style.setProperty('--colour', `#${(colour() >>> 8).toString(16).padStart(6, '0')}`);
  };
  const move = (/** @type {number} */ x, /** @type {number} */ y) => {
    at = [Math.min(size().width - 1, Math.max(0, x)), Math.min(size().height - 1, Math.max(0, y))];
    show();
  };
  show();
  return new Promise((resolve) => {
    const end = (/** @type {number | null} */ found) => {
      box.remove();
      resolve(found);
    };
    const follow = (/** @type {PointerEvent} */ event) => {
      event.stopPropagation(); // from the drawing
      move(event.clientX - size().left, event.clientY - size().top);
    };
    box.addEventListener('pointerdown', follow);
    box.addEventListener('pointermove', follow);
    box.addEventListener('pointerup', (event) => {
      follow(event);
      end(event.button === 0 ? colour() : null);
    });
    box.addEventListener('pointercancel', () => end(null));
    box.addEventListener('contextmenu', (event) => event.preventDefault());
    box.addEventListener('keydown', (event) => {
      const step = STEP[Number(event.shiftKey)];
      const by = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] }[event.key];
      if (by) {
        move(at[0] + by[0], at[1] + by[1]);
      } else if (event.key === 'Enter' || event.key === 'Escape') {
        end(event.key === 'Enter' ? colour() : null);
      }
      event.preventDefault();
      event.stopPropagation();
    });
  });
}
