// Input: what the browser says about pens, mice, fingers, wheels and keys, told to the engine sample by sample.

import { Device, Modifier, Phase } from '../engine/codes.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */
/** @typedef {import('../engine/types.js').Pointer} Pointer */

const LINE = 16; // pixels that a wheel's line stands for
const TICK = 50; // milliseconds between two looks at what is down and says nothing
const SILENT = 3000; // milliseconds after which nobody asks any more whether it rests

/** @type {Record<string, number>} */
const DEVICES = { mouse: Device.MOUSE, pen: Device.PEN, touch: Device.TOUCH };

/** @param {PointerEvent | WheelEvent | KeyboardEvent} event */
function modifiersOf(event) {
  return (event.shiftKey ? Modifier.SHIFT : 0) | (event.ctrlKey ? Modifier.CTRL : 0) |
    (event.altKey ? Modifier.ALT : 0) | (event.metaKey ? Modifier.META : 0);
}

/** Whether a key belongs to the control that has the focus. @param {KeyboardEvent} event */
function belongsToControl(event) {
  const target = event.target instanceof Element ? event.target : null;
  if (!target) {
    return false;
  }
  if (/^F\d+$/.test(event.key)) {
    return false;
  }
  // The Tab key walks through the drawing only where that has the focus.
  if (event.key === 'Tab' && !target.closest('#stage')) {
    return true;
  }
  if (target.matches('input[type=range], input[type=radio], input[type=checkbox]')) {
    return [' ', 'Enter', 'Tab', 'Home', 'End', 'PageUp', 'PageDown'].includes(event.key) || event.key.startsWith('Arrow');
  }
  if (target.closest('input, select, textarea, dialog, [role=menu]')) {
    return true;
  }
  return target.closest('button, a, summary') !== null && [' ', 'Enter'].includes(event.key);
}

export class Input {
  /**
   * @param {HTMLElement} stage takes the events; its top left corner is the view's origin
   * @param {Engine} engine
   * @param {() => void} wake something was told: a frame is due
   */
  constructor(stage, engine, wake) {
    this.stage = stage;
    this.engine = engine;
    this.wake = wake;
    /** What is down: its last event, and for how long it has been silent. @type {Map<number, { event: PointerEvent, silent: number }>} */
    this.contacts = new Map();
    this.modifiers = 0; // as last told
    this.told = 0; // when
    this.ticking = 0;
    /** @type {Set<string>} */
    this.held = new Set();
    /** Events and time spent in the engine, for measurements. */
    this.cost = { samples: 0, milliseconds: 0 };
    this.#listen();
  }

  #listen() {
    const stage = this.stage;
    stage.addEventListener('pointerdown', (event) => this.#down(event));
    stage.addEventListener('pointermove', (event) => this.#move(event));
    stage.addEventListener('pointerup', (event) => this.#end(event, Phase.UP));
    stage.addEventListener('pointercancel', (event) => this.#end(event, Phase.CANCEL));
    stage.addEventListener('lostpointercapture', (event) => this.#end(event, Phase.CANCEL));
    stage.addEventListener('pointerleave', (event) => {
      if (!this.contacts.has(event.pointerId)) {
        this.#tell([this.#sample(event, Phase.LEAVE)]);
      }
    });
    stage.addEventListener('contextmenu', (event) => event.preventDefault());
    stage.addEventListener('wheel', (event) => this.#wheel(event), { passive: false });
    // Safari and some touch screens start a gesture of their own unless the touch itself is refused.
    stage.addEventListener('touchstart', (event) => event.preventDefault(), { passive: false });
    addEventListener('keydown', (event) => this.#key(event, true));
    addEventListener('keyup', (event) => this.#key(event, false));
    addEventListener('blur', () => this.#releaseKeys());
  }

  /**
   * @param {PointerEvent} event
   * @param {number} phase
   * @returns {Pointer}
   */
  #sample(event, phase, predicted = false) {
    const box = this.stage.getBoundingClientRect();
    return {
      phase,
      device: DEVICES[event.pointerType] ?? Device.MOUSE,
      contact: event.pointerId,
      buttons: event.buttons,
      modifiers: modifiersOf(event),
      x: event.clientX - box.left,
      y: event.clientY - box.top,
      pressure: event.pressure,
      tiltX: event.tiltX,
      tiltY: event.tiltY,
      twist: event.twist,
      width: event.width,
      height: event.height,
      time: event.timeStamp,
      predicted,
    };
  }

  /**
   * A hand that rests sends nothing: its last event is told again, with the time. A page that was busy meanwhile may have
   * events to come, so one look counts little.
   */
  #tick() {
    const repeated = [];
    for (const contact of this.contacts.values()) {
      contact.silent += TICK;
      if (contact.silent > TICK && contact.silent < SILENT) {
        const time = Math.max(this.told, contact.event.timeStamp + contact.silent - TICK);
        repeated.push({ ...this.#sample(contact.event, Phase.MOVE), modifiers: this.modifiers, time });
      }
    }
    if (repeated.length > 0) {
      this.#tell(repeated);
    }
  }

  /** @param {PointerEvent} event */
  #keep(event) {
    this.contacts.set(event.pointerId, { event, silent: 0 });
    this.ticking ||= setInterval(() => this.#tick(), TICK);
  }

  /** @param {PointerEvent} event whether it was down */
  #drop(event) {
    const was = this.contacts.delete(event.pointerId);
    if (this.contacts.size === 0) {
      clearInterval(this.ticking);
      this.ticking = 0;
    }
    return was;
  }

  /** @param {Pointer[]} samples */
  #tell(samples) {
    const before = performance.now();
    ({ modifiers: this.modifiers, time: this.told } = samples[samples.length - 1]);
    this.engine.pointer(samples);
    this.cost.milliseconds += performance.now() - before;
    this.cost.samples += samples.length;
    this.wake();
  }

  /** @param {PointerEvent} event */
  #down(event) {
    // Drawing takes the keyboard back from a field or a button, without showing a focus ring.
    const focused = document.activeElement;
    if (focused instanceof HTMLElement && focused !== this.stage) {
      focused.blur();
    }
    try {
      this.stage.setPointerCapture(event.pointerId);
    } catch {
      // The contact is already gone; its end will be told as well.
    }
    this.#keep(event);
    this.#tell([this.#sample(event, Phase.DOWN)]);
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const phase = this.contacts.has(event.pointerId) ? Phase.MOVE : Phase.HOVER;
    const whole = event.getCoalescedEvents?.() ?? [];
    const samples = (whole.length > 0 ? whole : [event]).map((part) => this.#sample(part, phase));
    if (phase === Phase.MOVE) {
      this.#keep(event);
      for (const guess of event.getPredictedEvents?.() ?? []) {
        samples.push(this.#sample(guess, phase, true));
      }
    }
    this.#tell(samples);
  }

  /**
   * @param {PointerEvent} event
   * @param {number} phase
   */
  #end(event, phase) {
    if (this.#drop(event)) {
      this.#tell([this.#sample(event, phase)]);
    }
  }

  /** @param {WheelEvent} event */
  #wheel(event) {
    event.preventDefault();
    const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? LINE :
      event.deltaMode === WheelEvent.DOM_DELTA_PAGE ? this.stage.clientHeight : 1;
    const box = this.stage.getBoundingClientRect();
    this.engine.wheel(event.clientX - box.left, event.clientY - box.top, event.deltaX * unit, event.deltaY * unit,
      modifiersOf(event), event.timeStamp);
    this.wake();
  }

  /**
   * @param {KeyboardEvent} event
   * @param {boolean} down
   */
  #key(event, down) {
    if (event.isComposing || (down && belongsToControl(event))) {
      return;
    }
    // A shortcut's letter is where it is on a Latin keyboard, whatever script is being typed. AltGr types a sign.
    const key = /^Key[A-Z]$/.test(event.code) && (event.key > '~' || event.key === 'Process') ? event.code[3] : event.key;
    if (down) {
      this.held.add(key);
    } else {
      this.held.delete(key);
    }
    const modifiers = event.getModifierState('AltGraph') ? modifiersOf(event) & ~(Modifier.CTRL | Modifier.ALT) :
      modifiersOf(event);
    this.modifiers = modifiers;
    const used = this.engine.key(key, down, modifiers, event.timeStamp);
    if (used || key === 'Alt') { // Alt alone would open the browser's menu
      event.preventDefault();
    }
    this.wake();
  }

  /** Keys let go while another window had the focus are never told. */
  #releaseKeys() {
    for (const key of this.held) {
      this.engine.key(key, false, 0, performance.now());
    }
    this.held.clear();
    this.wake();
  }
}
