// For what is not of the editor itself and comes beside it: the front page, a film that plays over it.

/** Waits until the editor is there. @returns {Promise<import('../main.js').Shell>} */
export function ready() {
  const root = document.documentElement;
  return new Promise((resolve) => {
    const look = () => root.dataset.ready === 'yes' && resolve(/** @type {any} */ (globalThis).batten);
    new MutationObserver(look).observe(root, { attributeFilter: ['data-ready'] });
    look();
  });
}
