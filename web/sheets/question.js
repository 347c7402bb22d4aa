// A question that is to be answered before anything else: its text, what helps to decide, and the answers. Loaded with the
// first one.

/** @param {string} value @param {string} text */
export function answer(value, text) {
  const button = document.createElement('button');
  button.value = value;
  button.textContent = text;
  return button;
}

/**
 * @param {string} id of the dialog
 * @param {string} words
 * @param {HTMLElement[]} shown
 * @param {HTMLButtonElement[]} answers the first is the one that does no harm
 * @returns {Promise<string>} the value of the answer, '' when it was sent away
 */
export function question(id, words, shown, answers) {
  const dialog = document.createElement('dialog');
  const form = document.createElement('form');
  const text = document.createElement('p');
  const row = document.createElement('div');
  Object.assign(dialog, { id, className: 'question' });
  dialog.setAttribute('aria-labelledby', `${id}-text`);
  text.id = `${id}-text`;
  text.textContent = words;
  form.method = 'dialog';
  row.className = 'answers';
  answers[0].className = 'strong';
  answers[0].autofocus = true;
  row.append(...answers);
  form.append(text, ...shown, row);
  dialog.append(form);
  document.body.append(dialog);
  dialog.addEventListener('keydown', (event) => {
    event.stopPropagation(); // nothing of it is for the drawing
    if (event.ctrlKey || event.metaKey) {
      event.preventDefault(); // nor does the browser save the page
    }
  });
  dialog.showModal();
  return new Promise((resolve) => {
    dialog.addEventListener('close', () => {
      dialog.remove();
      resolve(dialog.returnValue);
    }, { once: true });
  });
}
