// The page's width, height and unit, shown where nothing is selected. A page with something on it asks first: what is drawn
// is scaled with it, or keeps its size. The engine reads what is typed and does all of it.

import { Measure } from '../page/measure.js';
import { tell, word } from '../page/words.js';
import { PAPERS, SCREENS } from '../page/papers.js';

/** @typedef {import('./panel.js').Panel} Panel */
/** @typedef {import('../page/papers.js').Sides} Sides */

const SIDES = ['width', 'height'];
const UNITS = ['px', 'mm', 'in'];
const NONE = 'none'; // of the sizes
/** @type {Record<string, number>} */
const MILLIMETRES = { px: 25.4 / 96, mm: 1, in: 25.4 };
const ALIKE = 0.01; // millimetres between sizes that go by one name

/** @param {string} key @param {HTMLSelectElement} select @param {string} id */
function row(key, select, id) {
  const box = document.createElement('div');
  const label = tell(document.createElement('label'), { text: key });
  select.id = label.htmlFor = id;
  box.className = 'control choice';
  box.append(label, select);
  return box;
}

/** The name of a size. @param {number} short millimetres @param {number} long */
function named(short, long) {
  const is = (/** @type {Sides} */ size, /** @type {number} */ unit) => Math.abs(short - size[0] * unit) < ALIKE && Math.abs(long - size[1] * unit) < ALIKE;
  return Object.keys(PAPERS).find((name) => is(PAPERS[name], 1)) ?? Object.keys(SCREENS).find((name) => is(SCREENS[name], MILLIMETRES.px));
}

export class PageSize {
  /** @param {Panel} panel */
  constructor(panel) {
    this.panel = panel;
    this.engine = panel.engine;
    this.asking = false;
    this.box = document.createElement('div');
    this.box.className = 'page-size';
    this.fields = SIDES.map((side, i) => this.#field(side, 'WH'[i]));
    this.unit = document.createElement('select');
    this.unit.append(...UNITS.map((name) => tell(new Option('', name), { text: `unit.${name}` })));
    this.unit.addEventListener('change', () => this.#say(this.unit.value));
    this.sizes = document.createElement('select');
    this.sizes.append(tell(new Option('', ''), { text: 'shell.own-size' }), ...Object.keys({ ...PAPERS, ...SCREENS }).map((name) => new Option(name)),
      tell(new Option('', NONE), { text: 'command.page-none' }));
    this.sizes.addEventListener('change', () => (this.sizes.value === NONE ? this.#run('page-none') : this.#take(this.sizes.value)));
    this.turn = panel.buttons.plain('page-turn', 'command.page-turn', { help: 'command.page-turn.help', shortcut: 'page-turn' });
    this.turn.addEventListener('click', () => this.#run('page-turn'));
    const sizes = row('step.page', this.sizes, 'page-sizes');
    sizes.append(this.turn);
    this.question = this.#question();
    this.box.append(tell(document.createElement('h3'), { text: 'shell.the-page' }), sizes,
      ...this.fields.map(({ box }) => box), row('property.unit', this.unit, 'page-unit'), this.question);
    this.box.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') {
        if (this.asking) {
          event.preventDefault(); // the question is what it ends
          this.fields[0].input.focus();
        }
        this.#end();
      }
    });
  }

  /** @param {string} side @param {string} sign */
  #field(side, sign) {
    const box = document.createElement('div');
    const input = document.createElement('input');
    const label = tell(document.createElement('label'), { text: `number.${side}` });
    box.className = 'control number pair';
    input.type = 'text';
    input.autocomplete = 'off';
    input.id = label.htmlFor = `page-${side}`;
    label.dataset.sign = sign;
    const measure = new Measure(input);
    input.addEventListener('focus', () => input.select());
    input.addEventListener('change', () => this.#typed());
    input.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') {
        event.preventDefault(); // it is no answer yet
        this.#typed();
        if (this.asking) {
          this.question.querySelector('button')?.focus();
        } else {
          input.select();
        }
      }
    });
    box.append(label, measure.box);
    return { side, box, input, measure };
  }

  #question() {
    const box = document.createElement('div');
    this.text = document.createElement('p');
    this.text.id = 'page-asks';
    this.text.setAttribute('role', 'status');
    box.setAttribute('role', 'group');
    box.setAttribute('aria-labelledby', this.text.id);
    box.className = 'page-asks';
    box.hidden = true;
    const answers = ['shell.page-scale', 'shell.page-keep', 'command.cancel'].map((key, i) => {
      const button = tell(document.createElement('button'), { text: key });
      button.type = 'button';
      button.addEventListener('click', () => {
        if (i < 2) {
          this.#enter(i ? 'page-keep' : 'page-scale');
        }
        this.#end();
        this.fields[0].input.focus();
      });
      return button;
    });
    box.append(this.text, ...answers);
    return box;
  }

  /** What the fields say, each with its unit. */
  #sides() {
    return this.fields.map(({ input, measure }) => input.value + (measure.unit.hidden ? '' : ` ${measure.unit.textContent}`).trimEnd());
  }

  /** A size was typed: it is taken, or asked about. */
  #typed() {
    const size = this.#sides().join(' × ');
    if (this.fields.some(({ input }) => !input.value.trim()) || this.fields.every(({ input, measure }) => input.value === measure.shown)) {
      this.#end(false);
      return;
    }
    this.asking = this.engine.number(`page-asks ${size}`) !== '';
    this.question.hidden = !this.asking;
    if (this.asking) {
      /** @type {HTMLElement} */ (this.text).textContent = word('shell.page-asks', size.replace(/(\d)([a-z])/g, '$1 $2'));
      this.#mark(false);
    } else {
      this.#enter('page-keep');
    }
  }

  /** @param {string} way */
  #enter(way) {
    const taken = this.engine.enter(way, this.#sides().join(' × '));
    this.#mark(!taken);
    if (taken) {
      this.#end();
    }
    this.panel.wake();
  }

  /** @param {boolean} wrong */
  #mark(wrong) {
    this.fields.forEach(({ measure }) => measure.judge(wrong));
  }

  /** No question any more. @param {boolean} [anew] the fields say what is there */
  #end(anew = true) {
    this.asking = false;
    this.question.hidden = true;
    if (anew) {
      this.#mark(false);
      this.#fill();
    }
  }

  /** The engine's own way, which asks nothing. @param {string} command */
  #run(command) {
    this.#end();
    this.engine.command(command);
    this.#fill();
    this.panel.wake();
  }

  /** A size by its name, lying as the page does. @param {string} name */
  #take(name) {
    const [width, height] = this.#millimetres();
    const size = PAPERS[name] ?? SCREENS[name];
    if (!size) {
      this.fields[0].input.focus();
      return;
    }
    (width > height ? [...size].reverse() : size).forEach((value, i) => {
      const { input } = this.fields[i];
      input.value = `${value}${name in PAPERS ? 'mm' : 'px'}`;
      input.dispatchEvent(new Event('input'));
    });
    this.#typed();
  }

  /** The unit alone: nothing that is drawn changes. @param {string} unit */
  #say(unit) {
    this.#end();
    this.engine.enter('page-unit', unit);
    this.#fill();
    this.panel.controls.refresh();
    this.panel.wake();
  }

  /** @returns {number[]} of the page as it is */
  #millimetres() {
    return SIDES.map((side) => {
      const [value, unit] = this.engine.number(`page-${side}`).split(' ');
      return Number(value) * (MILLIMETRES[unit] ?? 0);
    });
  }

  #fill() {
    const [width, height] = this.#millimetres();
    for (const { side, measure } of this.fields) {
      measure.show(this.engine.number(`page-${side}`));
    }
    this.unit.value = this.engine.number('page-unit');
    this.turn.disabled = !(width > 0);
    this.sizes.value = !(width > 0) ? NONE : named(Math.min(width, height), Math.max(width, height)) ?? '';
  }

  /** Called when the drawing may have changed. */
  show() {
    if (!this.asking && !this.box.contains(document.activeElement)) {
      this.#mark(false);
      this.#fill();
    }
  }
}
