// Numbers changed by dragging their labels. The field shows what it would be; it is entered when the pointer is lifted, so
// that a drag is one step of undo.

const PIXELS = 2; // of the pointer a step
const SLACK = 3; // pixels that a click may move

/** @param {HTMLElement} box whose labels are dragged */
export function scrub(box) {
  box.addEventListener('pointerover', ({ target }) => {
    const label = target instanceof Element ? target.closest('label') : null;
    label?.classList.toggle('scrub', label.control instanceof HTMLInputElement && ['text', 'number'].includes(label.control.type));
  });
  box.addEventListener('pointerdown', (event) => {
    const label = event.target instanceof Element ? event.target.closest('label') : null;
    const input = label?.control;
    if (!label?.classList.contains('scrub') || !(input instanceof HTMLInputElement) || event.button !== 0) {
      return;
    }
    const before = input.value;
    const from = Number.parseFloat(before);
    if (!Number.isFinite(from)) {
      return;
    }
    const span = Number(input.max) - Number(input.min);
    const step = input.max && span <= 2 ? 0.01 : 1;
    let moved = false;
    const done = new AbortController();
    const { signal } = done;
    /** @param {string} value */
    const end = (value) => {
      done.abort();
      if (moved) {
        input.value = value;
        label.addEventListener('click', (click) => click.preventDefault(), { once: true });
        if (value !== before) {
          input.dispatchEvent(new Event('change'));
        }
      }
    };
    label.setPointerCapture(event.pointerId);
    label.addEventListener('pointermove', (move) => {
      const away = move.clientX - event.clientX;
      moved ||= Math.abs(away) > SLACK;
      if (moved) {
        const by = Math.trunc(away / PIXELS) * step * (move.shiftKey ? 10 : 1);
        input.value = String(Number((from + by).toFixed(3)));
      }
    }, { signal });
    label.addEventListener('pointerup', () => end(input.value), { signal });
    label.addEventListener('pointercancel', () => end(before), { signal });
    addEventListener('keydown', (key) => {
      if (key.key === 'Escape') {
        key.preventDefault();
        key.stopPropagation();
        end(before);
      }
    }, { signal, capture: true });
  });
}
