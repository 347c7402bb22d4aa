// A colour beside the selection: of its line or of its fill, as it is seen; a press lets another be chosen.

import { tell } from '../page/words.js';
import { hexOf } from './swatches.js';

export class Dot {
  /**
   * @param {import('./panel.js').Panel} panel
   * @param {string} colour property
   * @param {string} shown property: whether there is such a colour
   */
  constructor({ engine, wake }, colour, shown) {
    this.engine = engine;
    this.colour = colour;
    this.shown = shown;
    this.button = tell(document.createElement('button'), { label: `property.${colour}` });
    this.button.type = 'button';
    this.button.className = 'tool';
    this.button.dataset.name = colour;
    this.input = document.createElement('input');
    Object.assign(this.input, { type: 'color', tabIndex: -1, ariaHidden: 'true' });
    this.mark = document.createElement('i');
    this.button.append(this.mark);
    this.box = document.createElement('span');
    this.box.className = `dot ${shown}`;
    this.box.append(this.button, this.input);
    this.button.addEventListener('click', () => this.input.showPicker());
    this.input.addEventListener('change', () => {
      engine.set(colour, Number.parseInt(this.input.value.slice(1), 16) * 256 + (engine.get(colour) & 255 || 255));
      this.show();
      wake();
      document.getElementById('stage')?.focus(); // keys mean the drawing again
    });
  }

  /** @returns {boolean} whether what is selected has such a colour */
  show() {
    const value = this.engine.get(this.colour);
    this.input.value = hexOf(value | 255);
    this.mark.style.setProperty('--colour', hexOf(value));
    return this.engine.get(this.shown) !== 0;
  }
}
