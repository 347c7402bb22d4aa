// A modal question: its text, what helps to decide, and the answers. Loaded with the first question.

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
 * @param {HTMLButtonElement[]} answers the first is the harmless one
 * @returns {Promise<string>} the value of the answer, '' when dismissed
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
    event.stopPropagation(); // keep the event from the drawing
    if (event.ctrlKey || event.metaKey) {
      event.preventDefault(); // and the browser from saving the page
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
