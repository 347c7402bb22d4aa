// Notices: one line about something that just happened, told to screen readers too.

const SHORT = 5000; // milliseconds that a notice stays when it asks for nothing

export class Notice {
  /** @param {string} id of its box */
  constructor(id = 'notice') {
    this.box = /** @type {HTMLElement} */ (document.getElementById(id));
    this.text = /** @type {HTMLElement} */ (document.getElementById(`${id}-text`));
    this.button = /** @type {HTMLButtonElement} */ (document.getElementById(`${id}-action`));
    this.timer = 0;
    this.button.addEventListener('click', () => {
      this.hide();
      this.action();
    });
    this.action = () => {};
  }

  /**
   * @param {string} text
   * @param {{ label: string, run: () => void }} [action] what can be done about it; the notice then stays
   */
  say(text, action) {
    clearTimeout(this.timer);
    this.text.textContent = text;
    this.button.hidden = !action;
    this.button.textContent = action?.label ?? '';
    this.action = action?.run ?? (() => {});
    this.box.hidden = false;
    if (!action) {
      this.timer = setTimeout(() => this.hide(), SHORT);
    }
  }

  hide() {
    this.box.hidden = true;
    this.text.textContent = '';
  }
}
