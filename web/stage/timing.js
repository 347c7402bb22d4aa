// What opens above the time strip: the graph of distance over time, which a stroke redraws, how long the move takes, how it begins
// and ends, and the levels of the path and of the gaze. The engine holds all its state.

import { word } from '../page/words.js';

/** @typedef {import('./time.js').Move} Move */
/** @typedef {{gain: number, muted: number, solo: number, active: number}} Row */

/** As bat_move_act (panels.h). */
const Do = Object.freeze({ GAIN: 0, MUTE: 1, SOLO: 2, DURATION: 3, EASE_IN: 4, EASE_OUT: 5, EASE: 6, CHOOSE: 7, JOINT: 8, ANGLE: 9 });
const LOUDEST = 2;  // upper end of a fader; the engine accepts more
const STILL = 4;    // px that a tap may travel
const LONGEST = 1e9; // seconds
const NUDGE = 0.02; // of the distance, by an arrow key
const ASIDE = 0.08; // of the time, to each side

/**
 * @template {keyof HTMLElementTagNameMap} T
 * @param {T} tag @param {string} name @returns {HTMLElementTagNameMap[T]}
 */
function make(tag, name) {
  const element = document.createElement(tag);
  element.className = name;
  return element;
}

/** @param {HTMLSelectElement} select @param {[string, string][]} values @param {string} chosen */
function options(select, values, chosen) {
  const key = JSON.stringify(values);
  if (select.dataset.values !== key) {
    select.dataset.values = key;
    select.replaceChildren(...values.map(([value, text]) => new Option(text, value)));
  }
  select.value = chosen;
}

export class Timing {
  /** @param {import('../main.js').Shell} shell @param {() => void} changed */
  constructor(shell, changed) {
    this.shell = shell;
    this.changed = changed;
    this.move = /** @type {Move | null} */ (null);
    /** @type {number[]} of the stroke: share of the time, share of the distance */
    this.stroke = [];
    this.box = make('div', 'timing');
    this.graph = make('div', 'timing-graph');
    this.graph.tabIndex = 0;
    this.graph.role = 'application';
    this.graph.innerHTML = '<svg viewBox="0 0 100 100" preserveAspectRatio="none" aria-hidden="true"><path class="even" d="M0 100L100 0"/><polyline/><line class="now" y1="0" y2="100"/></svg>';
    this.line = /** @type {SVGPolylineElement} */ (this.graph.querySelector('polyline'));
    this.now = /** @type {SVGLineElement} */ (this.graph.querySelector('.now'));
    this.ends = { in: this.#handle('ease-in'), out: this.#handle('ease-out'), width: this.#handle('ease-width') };
    this.speed = make('output', 'timing-speed');
    this.seconds = make('input', '');
    this.seconds.type = 'number';
    this.seconds.min = '0.01';
    this.seconds.step = 'any';
    this.seconds.addEventListener('change', () => this.#set(Do.DURATION, Math.min(this.seconds.valueAsNumber, LONGEST), true));
    const label = make('label', 'timing-seconds');
    this.word = make('span', '');
    label.append(this.word, this.seconds);
    this.ease = this.#command('move-ease');
    this.label = label;
    this.joint = make('select', 'timing-joint');
    this.joint.addEventListener('change', () => this.#set(Do.JOINT, 0, true, false, Number(this.joint.value)));
    this.angle = make('select', 'timing-angle');
    this.angle.addEventListener('change', () => this.#set(Do.ANGLE, 0, true, false, this.angle.selectedIndex));
    const row = make('div', 'timing-row');
    row.append(this.joint, this.angle, label, this.speed, this.ease);
    this.columns = { path: make('ul', 'timing-levels'), gaze: make('ul', 'timing-levels') };
    const levels = make('div', 'timing-columns');
    levels.append(this.columns.path, this.columns.gaze);
    const more = make('div', 'timing-row');
    this.shake = this.#command('shake-add');
    this.copy = this.#command('gaze-copy');
    more.append(this.shake, this.copy);
    this.box.append(this.graph, row, levels, more);
    this.#listen();
  }

  /** @param {string} name */
  #handle(name) {
    const handle = make('button', `timing-end ${name}`);
    handle.type = 'button';
    this.graph.append(handle);
    return handle;
  }

  /** @param {string} name */
  #command(name) {
    const button = make('button', '');
    button.type = 'button';
    button.dataset.command = name;
    button.addEventListener('click', () => {
      this.shell.engine.command(name);
      this.changed();
    });
    return button;
  }

  /** @param {number} act @param {number} value @param {boolean} done */
  #set(act, value, done, path = false, level = 0) {
    const { engine } = this.shell;
    if (Number.isFinite(value)) {
      engine.act('editor_move_set', act, Number(path), level, value, Number(done));
    }
    this.changed();
  }

  /** @param {number[]} points @param {boolean} done */
  #retime(points, done) {
    const { engine } = this.shell;
    const bytes = new Uint8Array(Float64Array.from(points).buffer);
    engine.guard(() => engine.lend(bytes, (/** @type {number} */ data) => engine.wasm.editor_retime(engine.editor, data, points.length / 2, Number(done))), 0);
    this.changed();
  }

  /** @param {PointerEvent} event @returns {[number, number]} shares of the time and the distance */
  #place(event) {
    const { left, top, width, height } = this.graph.getBoundingClientRect();
    return [Math.min(Math.max((event.clientX - left) / width, 0), 1), Math.min(Math.max(1 - (event.clientY - top) / height, 0), 1)];
  }

  #listen() {
    const graph = this.graph;
    graph.addEventListener('pointerdown', (event) => {
      if (event.target instanceof HTMLButtonElement || event.button !== 0) {
        return;
      }
      event.preventDefault();
      graph.focus();
      graph.setPointerCapture(event.pointerId);
      this.stroke = this.#place(event);
    });
    graph.addEventListener('pointermove', (event) => {
      if (!this.stroke.length || !graph.hasPointerCapture(event.pointerId)) {
        return;
      }
      const all = event.getCoalescedEvents(); // all that the pen said since the last frame
      this.stroke.push(...(all.length ? all : [event]).flatMap((one) => this.#place(one)));
      this.#retime(this.stroke, false);
    });
    graph.addEventListener('pointerup', () => {
      const stroke = this.stroke;
      this.stroke = [];
      if (stroke.length > 2) {
        this.#retime(stroke, true);
      }
    });
    graph.addEventListener('pointercancel', () => this.#drop());
    graph.addEventListener('keydown', (event) => this.#key(event));
    this.#drag(this.ends.in, (share) => this.#ease(Do.EASE_IN, share));
    this.#drag(this.ends.out, (share) => this.#ease(Do.EASE_OUT, 1 - share));
    this.#drag(this.ends.width, (share, start) => [Do.DURATION, Math.max(start * share, 0.05)]);
  }

  /** @param {number} act @param {number} share @returns {[number, number]} */
  #ease(act, share) {
    return [act, Math.max(share, 0) * (this.move?.duration ?? 0)];
  }

  #drop() {
    this.stroke = [];
    this.shell.engine.command('cancel');
    this.changed();
  }

  /**
   * A handle at an end: dragged it sets a value, tapped it eases both ends.
   * @param {HTMLButtonElement} handle
   * @param {(share: number, start: number) => [number, number]} value
   */
  #drag(handle, value) {
    let at = NaN;
    let start = 0;
    let width = 1;
    let moved = false;
    const share = (/** @type {PointerEvent} */ event) => {
      const { left } = this.graph.getBoundingClientRect();
      return (event.clientX - left) / width;
    };
    handle.addEventListener('pointerdown', (event) => {
      handle.setPointerCapture(event.pointerId);
      at = event.clientX;
      start = this.move?.duration ?? 0;
      width = this.graph.getBoundingClientRect().width;
      moved = false;
      event.stopPropagation();
    });
    handle.addEventListener('pointermove', (event) => {
      if (!handle.hasPointerCapture(event.pointerId) || (!moved && Math.abs(event.clientX - at) <= STILL)) {
        return;
      }
      moved = true;
      const [act, number] = value(share(event), start);
      this.#set(act, number, false);
    });
    handle.addEventListener('pointerup', (event) => {
      if (moved) {
        const [act, number] = value(share(event), start);
        this.#set(act, number, true);
      }
      event.stopPropagation();
    });
    handle.addEventListener('pointercancel', () => this.#drop());
    handle.addEventListener('click', () => {
      if (!moved && handle !== this.ends.width) {
        this.shell.engine.command('move-ease');
        this.changed();
      }
      moved = false;
    });
  }

  /** Arrow keys: left and right move the playhead, up and down the distance there. @param {KeyboardEvent} event */
  #key(event) {
    const move = this.move;
    const way = { ArrowUp: NUDGE, ArrowDown: -NUDGE }[event.key];
    if (!move || event.target !== this.graph) {
      return;
    }
    if (event.key === 'ArrowLeft' || event.key === 'ArrowRight') {
      this.shell.engine.command(event.key === 'ArrowLeft' ? 'move-previous' : 'move-next');
      this.changed();
    } else if (way && move.graph.length) {
      const t = move.at / move.duration;
      const at = (/** @type {number} */ share) => move.graph[Math.round(Math.min(Math.max(share, 0), 1) * (move.graph.length - 1))];
      this.#retime([t - ASIDE, at(t - ASIDE), t, at(t) + way, t + ASIDE, at(t + ASIDE)], true);
    } else if (event.key === 'Escape' && this.stroke.length) {
      this.#drop();
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  }

  /** @param {Move} move */
  show(move) {
    this.move = move;
    const { graph, at, duration, length } = move;
    const last = Math.max(graph.length - 1, 1);
    this.graph.hidden = !graph.length;
    this.line.setAttribute('points', graph.map((y, i) => `${(100 * i) / last},${100 - 100 * y}`).join(' '));
    const x = String((100 * at) / (duration || 1));
    this.now.setAttribute('x1', x);
    this.now.setAttribute('x2', x);
    const i = Math.min(Math.floor((at / (duration || 1)) * last), last - 1);
    const slope = graph.length ? ((graph[i + 1] - graph[i]) * last * length) / duration : 0;
    this.speed.textContent = graph.length ? word('moves.speed', slope.toFixed(slope < 100 ? 1 : 0)) : '';
    if (document.activeElement !== this.seconds) {
      this.seconds.value = String(duration);
    }
    this.word.textContent = word('moves.duration');
    this.graph.ariaLabel = word('moves.graph');
    this.ends.in.ariaLabel = this.ends.out.ariaLabel = word('command.move-ease');
    this.ends.width.ariaLabel = word('moves.duration');
    for (const button of [this.ease, this.shake, this.copy]) {
      button.textContent = word(`command.${button.dataset.command}`);
    }
    this.ease.hidden = !graph.length || !move.sees;
    this.label.hidden = this.shake.hidden = !move.sees;
    this.#body(move);
    this.copy.hidden = move.cameras < 2;
    this.#fill(this.columns.path, move.path, word('moves.path'), true);
    this.#fill(this.columns.gaze, move.gaze, move.sees ? word('moves.gaze') : word('moves.joint'), false);
  }

  /** What is said of a skeleton instead of a camera: its joints, and the angle that the graph shows. @param {Move} move */
  #body({ sees, joints = [], joint = -1, angles = [], angle = 0, degrees = 0 }) {
    const chosen = joints.find(({ id }) => id === joint);
    this.joint.hidden = Boolean(sees);
    this.angle.hidden = Boolean(sees) || angles.length < 2;
    for (const end of Object.values(this.ends)) {
      end.hidden = !sees;
    }
    this.graph.classList.toggle('body', !sees);
    if (sees) {
      return;
    }
    options(this.joint, joints.map(({ id, name }) => [String(id), name]), String(joint));
    options(this.angle, angles.map((axis, i) => [String(i), axis]), String(angle));
    this.joint.ariaLabel = word('moves.joint');
    this.angle.ariaLabel = this.graph.ariaLabel = word('moves.angle', `${chosen?.name ?? ''} ${angles[angle] ?? ''}`);
    this.speed.textContent = chosen ? word('moves.degrees', degrees.toFixed(1)) : '';
  }

  /** @param {HTMLUListElement} list @param {Row[]} rows @param {string} name @param {boolean} path */
  #fill(list, rows, name, path) {
    list.ariaLabel = name;
    list.hidden = rows.length < 2;
    while (list.children.length > rows.length) {
      list.firstElementChild?.remove(); // the finest comes first
    }
    while (list.children.length < rows.length) {
      list.prepend(this.#row(list.children.length, path));
    }
    rows.forEach((row, level) => {
      const item = list.children[rows.length - 1 - level];
      const [choose, mute, solo] = /** @type {NodeListOf<HTMLButtonElement>} */ (item.querySelectorAll('button'));
      const fader = item.querySelector('input');
      choose.textContent = `${name} ${level}`;
      choose.ariaPressed = String(row.active !== 0);
      if (fader && document.activeElement !== fader) {
        fader.value = String(row.gain);
      }
      if (fader) {
        fader.ariaLabel = `${name}: ${word('levels.gain', String(level))}`;
      }
      mute.ariaPressed = String(row.muted !== 0);
      solo.ariaPressed = String(row.solo !== 0);
      mute.textContent = word('levels.mute-short');
      solo.textContent = word('levels.solo-short');
      mute.title = mute.ariaLabel = `${name}: ${word('levels.mute', String(level))}`;
      solo.title = solo.ariaLabel = `${name}: ${word('levels.solo', String(level))}`;
    });
  }

  /** @param {number} level @param {boolean} path */
  #row(level, path) {
    const item = make('li', 'timing-level');
    const fader = make('input', '');
    const choose = make('button', 'timing-choose');
    const mute = make('button', '');
    const solo = make('button', '');
    fader.type = 'range';
    fader.min = '0';
    fader.max = String(LOUDEST);
    fader.step = '0.01';
    fader.addEventListener('input', () => this.#set(Do.GAIN, fader.valueAsNumber, false, path, level));
    fader.addEventListener('change', () => this.#set(Do.GAIN, fader.valueAsNumber, true, path, level));
    choose.type = mute.type = solo.type = 'button';
    choose.addEventListener('click', () => this.#set(Do.CHOOSE, 0, true, path, level));
    mute.addEventListener('click', () => this.#set(Do.MUTE, Number(mute.ariaPressed !== 'true'), true, path, level));
    solo.addEventListener('click', () => this.#set(Do.SOLO, 0, true, path, level));
    item.append(choose);
    if (level > 0) {
      item.append(fader);
    } else {
      mute.hidden = true;
    }
    item.append(mute, solo);
    return item;
  }
}
