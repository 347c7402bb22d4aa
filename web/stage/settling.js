// A stroke settles: what was seen of it while it was drawn fades over the curve that it has become.

import { Role } from '../engine/codes.js';

/** @typedef {import('../main.js').Shell} Shell */
/** @typedef {import('../engine/types.js').Frame} Frame */

const SETTLES = 200; // milliseconds

export class Settling {
  /** @param {Shell} shell */
  constructor({ painter }) {
    this.overlay = painter.overlay;
    this.calm = matchMedia('(prefers-reduced-motion: reduce)');
    /** Of the last frame: its view, the drawing, and whether a stroke was under way. */
    this.view = '';
    this.revision = 0;
    this.drawing = false;
    this.layer = document.createElement('canvas');
    this.layer.className = 'layer';
    this.layer.ariaHidden = 'true';
    /** @type {Animation | undefined} */
    this.fade = undefined;
  }

  /** Before the frame is painted. @param {Frame} frame */
  show({ live, revision, x, y, zoom, angle, tilt }) {
    const view = `${x} ${y} ${zoom} ${angle} ${tilt}`;
    const drawing = live.some(({ role }) => role === Role.INK);
    if (view !== this.view || drawing) {
      this.#end();
    } else if (this.drawing && revision !== this.revision && !this.calm.matches) {
      this.#begin();
    }
    Object.assign(this, { view, revision, drawing });
  }

  #begin() {
    const { layer, overlay } = this;
    this.#end();
    layer.width = overlay.width; // which also clears it
    layer.height = overlay.height;
    layer.getContext('2d')?.drawImage(overlay, 0, 0);
    overlay.after(layer);
    this.fade = layer.animate({ opacity: [1, 0] }, SETTLES);
    this.fade.onfinish = () => layer.remove();
  }

  #end() {
    this.fade?.cancel();
    this.layer.remove();
  }
}
