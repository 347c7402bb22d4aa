// The button that changes the look of surfaces, and the colours of curvature with their range.

import { stand } from '../page/build.js';
import { word } from '../page/words.js';

const CURVATURES = [2, 3];

/** Two digits, and a power of ten where there would be many noughts. @param {number} value above 0 */
function brief(value) {
  const [digits, power] = value.toExponential(1).split('e');
  if (Number(power) >= -3 && Number(power) < 4) {
    return Number(value.toPrecision(2)).toString();
  }
  return `${Number(digits)} · 10${[...power.replace('+', '')].map((one) => (one === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(one)])).join('')}`;
}

export class Legend {
  /** @param {import('../main.js').Shell} shell */
  constructor({ engine, stage, wake }) {
    this.box = document.createElement('div');
    this.box.className = 'looks';
    this.box.hidden = true;
    this.button = document.createElement('button');
    this.button.type = 'button';
    this.button.addEventListener('click', () => {
      engine.command('look-next');
      wake();
    });
    this.scale = document.createElement('div');
    this.scale.className = 'scale';
    this.scale.append(document.createElement('i'), ...['', '', ''].map(() => document.createElement('span')));
    this.box.append(this.button, this.scale);
    void stand(this.box, 'styles/space.css', { stage, wake });
  }

  /** The look's name on its button, and the range of curvature. @param {NonNullable<import('./space.js').Picture>} picture */
  show({ look, range, legend, items }) {
    const name = word(`look.${['matte', 'zebra', 'gauss', 'mean', 'lines'][look]}`);
    this.box.hidden = !items.some(({ kind }) => kind === 0);
    const curved = CURVATURES.includes(look);
    const told = [name, range, word('command.look-next')].join('\n');
    if (told === this.box.dataset.told) {
      return;
    }
    this.box.dataset.told = told;
    this.button.textContent = name;
    this.button.title = word('command.look-next');
    this.scale.hidden = !curved;
    const end = brief(range);
    const [bar, ...marks] = /** @type {HTMLElement[]} */ ([...this.scale.children]);
    [`−${end}`, '0', `+${end}`].forEach((text, i) => {
      marks[i].textContent = text;
    });
    bar.style.background = `linear-gradient(to right, ${legend.map((rgba) => `#${rgba.toString(16).padStart(8, '0')}`).join()})`;
  }

  hide() {
    this.box.hidden = true;
  }
}
