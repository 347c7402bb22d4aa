// The focus ring: shown where a key has moved the focus, and around the drawing only after Tab or F6. Any other key
// pressed after a click shows no ring.

const { dataset } = document.documentElement;
const MOVES = ['Tab', 'F6'];

let key = ''; // the last key pressed; '' once a pointer has been down since

addEventListener('keydown', (event) => { key = event.key; }, true);
addEventListener('pointerdown', () => {
  key = '';
  delete dataset.ring;
}, true);
addEventListener('focusin', ({ target }) => {
  if (MOVES.includes(key) || (key && target instanceof Element && target.id !== 'stage')) {
    dataset.ring = 'yes';
  } else {
    delete dataset.ring;
  }
});
