// The plot of the pressure curve, below its number in the settings: the share of a brush's reach that each pressure
// gives.

/** @typedef {import('../engine/engine.js').Engine} Engine */

const NAMESPACE = 'http://www.w3.org/2000/svg';
const STEPS = 40;

export class PressureCurve {
  /** @param {Engine} engine @param {Element} control of the property */
  constructor(engine, control) {
    this.engine = engine;
    const picture = document.createElementNS(NAMESPACE, 'svg');
    picture.setAttribute('class', 'pressure-curve');
    picture.setAttribute('viewBox', '-2 -2 84 44');
    picture.setAttribute('aria-hidden', 'true'); // the number says the same
    this.line = document.createElementNS(NAMESPACE, 'polyline');
    picture.append(this.line);
    control.after(picture);
  }

  show() {
    const points = Array.from({ length: STEPS + 1 }, (_, i) =>
      `${(80 * i) / STEPS},${40 * (1 - this.engine.pressure(i / STEPS))}`);
    this.line.setAttribute('points', points.join(' '));
  }
}
