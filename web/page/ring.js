// The ring around what has the focus: shown when a key has moved the focus there, and around the drawing only by Tab or
// F6. A key that means something else, pressed after a click, rings nothing.

const { dataset } = document.documentElement;
const MOVES = ['Tab', 'F6'];

let key = ''; // pressed last; '' when a pointer was down since

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
