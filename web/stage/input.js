// Input: passes the browser's events of pens, mice, fingers, wheels and keys to the engine, sample by sample.

import { Device, Modifier, Phase } from '../engine/codes.js';

/** @typedef {import('../engine/engine.js').Engine} Engine */
/** @typedef {import('../engine/types.js').Pointer} Pointer */

const LINE = 16; // pixels per line of a wheel
const TICK = 50; // milliseconds between checks of contacts that are down but silent
const SILENT = 3000; // milliseconds after which a silent contact is no longer checked
const LONG = 550; // milliseconds of a long press
const STILL = 5; // pixels that a click or a long press may move
const STILL_MOUSE = 3; // the same for a mouse: further, and the view turns (src/editor/input/orbit.c)

/** @type {Record<string, number>} */
const DEVICES = { mouse: Device.MOUSE, pen: Device.PEN, touch: Device.TOUCH };

/** @param {PointerEvent | WheelEvent | KeyboardEvent} event */
function modifiersOf(event) {
  return (event.shiftKey ? Modifier.SHIFT : 0) | (event.ctrlKey ? Modifier.CTRL : 0) |
    (event.altKey ? Modifier.ALT : 0) | (event.metaKey ? Modifier.META : 0);
}

/**
 * Whether a contact that counts as down can not be, because another comes down. A palm beside the pen ends nothing.
 * @param {PointerEvent} held its last event @param {PointerEvent} event
 */
function isLost(held, event) {
  const finger = event.pointerType === 'touch';
  if (held.pointerId === event.pointerId) {
    return true;
  }
  if (held.pointerType === 'touch') {
    return finger && event.isPrimary; // no other finger is down
  }
  return !finger || event.timeStamp - held.timeStamp > SILENT;
}

/** Whether a key belongs to the control that has the focus. @param {KeyboardEvent} event */
export function belongsToControl(event) {
  const target = event.target instanceof Element ? event.target : null;
  if (!target) {
    return false;
  }
  if (/^F\d+$/.test(event.key)) {
    return false;
  }
  // The Tab key steps through the drawing only while the drawing has the focus.
  if (event.key === 'Tab' && target.id !== 'stage') {
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
   * @param {() => void} wake called after input: a frame is due
   */
  constructor(stage, engine, wake) {
    this.stage = stage;
    this.engine = engine;
    this.wake = wake;
    /**
     * Contacts that are down: the last event, and the time of silence since.
     * @type {Map<number, { event: PointerEvent, silent: number }>}
     */
    this.contacts = new Map();
    this.modifiers = 0; // as last passed on
    this.told = 0; // time of the last samples
    this.ticking = 0;
    /** A press that has not moved. @type {{ event: PointerEvent, timer: number } | null} */
    this.press = null;
    /** Asks for the menu of what fits there. @type {(x: number, y: number, there: boolean) => void} */
    this.onpress = () => {};
    /** Called when a pointer comes down. */
    this.onbegin = () => {};
    /** Called when a pointer was lifted. */
    this.onlift = () => {};
    /** @type {Set<string>} */
    this.held = new Set();
    /** Number of samples and time spent in the engine, for measurements. */
    this.cost = { samples: 0, milliseconds: 0 };
    this.#listen();
    if (matchMedia('(pointer: coarse)').matches) { // hints speak to fingers, even before the first touch
      this.#tell([this.#sample(new PointerEvent('pointermove', { pointerType: 'touch' }), Phase.HOVER)]);
    }
  }

  #listen() {
    const stage = this.stage;
    // What lies in the stage, such as buttons of the empty page, is no drawing (over.js).
    stage.addEventListener('pointerdown', (event) => event.target === stage && this.#down(event));
    stage.addEventListener('pointermove', (event) => event.target === stage && this.#move(event));
    stage.addEventListener('pointerup', (event) => this.#end(event, Phase.UP));
    stage.addEventListener('pointercancel', (event) => this.#end(event, Phase.CANCEL));
    stage.addEventListener('lostpointercapture', (event) => this.#liftThat(event)); // alone: neither an end nor a cancel came
    stage.addEventListener('pointerleave', (event) => {
      if (!this.contacts.has(event.pointerId)) {
        this.#tell([this.#sample(event, Phase.LEAVE)]);
      }
    });
    stage.addEventListener('contextmenu', (event) => this.#menu(event));
    stage.addEventListener('wheel', (event) => this.#wheel(event), { passive: false });
    // Safari and some touch screens start a gesture of their own unless touchstart is cancelled.
    stage.addEventListener('touchstart', (event) => event.preventDefault(), { passive: false });
    addEventListener('keydown', (event) => this.#key(event, true));
    addEventListener('keyup', (event) => this.#key(event, false));
    addEventListener('blur', () => {
      this.#releaseKeys();
      this.#lift();
    });
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
   * A resting hand sends no events: its last event is repeated, with the current time. A page that was busy may still
   * have events queued, so each check counts for no more than its interval.
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

  /** Removes a contact; gives whether it was down. @param {PointerEvent} event */
  #drop(event) {
    const was = this.contacts.delete(event.pointerId);
    if (this.contacts.size === 0) {
      clearInterval(this.ticking);
      this.ticking = 0;
    }
    return was;
  }

  /**
   * Ends contacts whose end the system has lost: as if they had been lifted where they were last seen down.
   * @param {(event: PointerEvent) => boolean} [lost] tells which, by their last events
   */
  #lift(lost = () => true) {
    for (const { event } of [...this.contacts.values()].filter((contact) => lost(contact.event))) {
      this.#drop(event);
      if (this.press?.event.pointerId === event.pointerId) {
        clearTimeout(this.press.timer);
        this.press = null;
      }
      this.#tell([{ ...this.#sample(event, Phase.UP), buttons: 0, modifiers: this.modifiers,
        time: Math.max(this.told, event.timeStamp) }]);
      if (this.stage.hasPointerCapture(event.pointerId)) {
        this.stage.releasePointerCapture(event.pointerId);
      }
    }
  }

  /** @param {PointerEvent} event of the contact */
  #liftThat(event) {
    this.#lift(({ pointerId }) => pointerId === event.pointerId);
  }

  /** The menu key; a right click is seen when it ends: it may become a drag. @param {MouseEvent} event */
  #menu(event) {
    event.preventDefault();
    if (event.button !== 2 && !(/** @type {PointerEvent} */ (event).pointerType)) {
      const box = this.stage.getBoundingClientRect();
      this.onpress(box.left + box.width / 2, box.top + box.height / 3, false);
    }
  }

  /**
   * A press begins: of a finger or a pen it may become a long one, if a frame after that time it is still there: a page that was
   * busy hears only then of moves and of an end that came in time.
   * @param {PointerEvent} event
   */
  #press(event) {
    clearTimeout(this.press?.timer);
    const alone = this.contacts.size === 0;
    const long = event.pointerType !== 'mouse' && event.buttons === 1;
    const late = () => requestAnimationFrame(() => this.press?.event === event && this.#pressed(event));
    this.press = alone && (long || event.button === 2) ? { event, timer: long ? setTimeout(late, LONG) : 0 } : null;
  }

  /** It was long: it is taken back as a stroke. @param {PointerEvent} event */
  #pressed(event) {
    this.press = null;
    this.#drop(event);
    this.#tell([this.#sample(event, Phase.CANCEL)]);
    this.onpress(event.clientX, event.clientY, true);
  }

  /** What was pressed beside the drawing turns out to be a stroke. @param {PointerEvent[]} events so far */
  begin([down, ...moves]) {
    this.#down(down);
    moves.forEach((event) => this.#move(event));
  }

  /** A press goes on. @param {PointerEvent} event */
  #pressing(event) {
    const from = this.press?.event;
    const still = event.pointerType === 'mouse' ? STILL_MOUSE : STILL;
    if (from && (from.pointerId !== event.pointerId || Math.hypot(event.clientX - from.clientX, event.clientY - from.clientY) > still)) {
      clearTimeout(this.press?.timer);
      this.press = null;
    }
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
    this.#lift((held) => isLost(held, event));
    // Drawing takes the focus back from a field or a button, without showing a focus ring.
    const focused = document.activeElement;
    if (focused instanceof HTMLElement && focused !== this.stage) {
      focused.blur();
    }
    try {
      this.stage.setPointerCapture(event.pointerId);
    } catch {
      // The contact is already gone; its end follows as an event.
    }
    this.onbegin();
    this.#press(event);
    this.#keep(event);
    this.#tell([this.#sample(event, Phase.DOWN)]);
  }

  /** @param {PointerEvent} event */
  #move(event) {
    if (event.buttons === 0) {
      this.#liftThat(event);
    }
    const phase = this.contacts.has(event.pointerId) ? Phase.MOVE : Phase.HOVER;
    const whole = event.getCoalescedEvents?.() ?? [];
    const samples = (whole.length > 0 ? whole : [event]).map((part) => this.#sample(part, phase));
    if (phase === Phase.MOVE) {
      this.#pressing(event);
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
    const press = this.press;
    clearTimeout(press?.timer);
    this.press = null;
    if (this.#drop(event)) {
      this.#tell([this.#sample(event, phase)]);
      this.onlift();
      if (phase === Phase.UP && press?.event.pointerId === event.pointerId && press.event.button === 2) {
        this.onpress(event.clientX, event.clientY, true);
      }
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
    // Shortcut letters go by their position on a Latin keyboard, whatever script is being typed. AltGr types a sign.
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
    if (down && key === 'Escape') {
      this.#lift(); // the engine has dropped the stroke
    }
    // Alt alone would open the browser's menu. The release of a key is left alone: Space presses a button with it.
    if ((used && down) || key === 'Alt') {
      event.preventDefault();
    }
    this.wake();
  }

  /** Releases all keys: releases while another window has the focus are not reported. */
  #releaseKeys() {
    for (const key of this.held) {
      this.engine.key(key, false, 0, performance.now());
    }
    this.held.clear();
    this.wake();
  }
}
