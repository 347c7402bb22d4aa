// A colour beside the selection: of its line or of its fill, as it is seen; a press lets another be chosen.

import { tell } from '../page/words.js';
import { choose, hexOf } from './swatches.js';

export class Dot {
  /**
   * @param {import('./panel.js').Panel} panel
   * @param {string} colour property
   * @param {string} shown property: whether there is such a colour
   */
  constructor(panel, colour, shown) {
    this.engine = panel.engine;
    this.colour = colour;
    this.shown = shown;
    this.button = tell(document.createElement('button'), { label: `property.${colour}` });
    this.button.type = 'button';
    this.button.className = 'tool';
    this.button.dataset.name = colour;
    this.mark = document.createElement('i');
    this.button.append(this.mark);
    this.box = document.createElement('span');
    this.box.className = `dot ${shown}`;
    this.box.append(this.button);
    this.button.addEventListener('click', () => void choose(panel, colour, this.button));
  }

  /** @returns {boolean} whether what is selected has such a colour */
  show() {
    const value = this.engine.get(this.colour);
    this.mark.style.setProperty('--colour', hexOf(value));
    return this.engine.get(this.shown) !== 0;
  }
}
