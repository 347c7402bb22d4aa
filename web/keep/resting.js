// The gallery's picture of the open drawing is made when the hand rests after drawing, and when the page is hidden. Fetched at the first
// sign of a user.

const REST = 3000; // milliseconds without input

/** @param {import('../main.js').Shell} shell */
export function pictureAtRest(shell) {
  const { engine, keeper } = shell;
  const soon = globalThis.requestIdleCallback ?? ((/** @type {() => void} */ run) => setTimeout(run)); // Safari has none
  let [timer, seen] = [0, ''];
  const take = async () => {
    const now = `${keeper.id} ${engine.session} ${engine.journal.length}`;
    if (now !== seen && keeper.begun) {
      seen = now;
      await import('../gallery/pictured.js').then(({ pictureOpen }) => pictureOpen(shell)).catch(() => {}); // a picture fewer
    }
  };
  for (const event of ['pointerup', 'keyup']) {
    addEventListener(event, () => {
      clearTimeout(timer);
      timer = setTimeout(() => soon(() => void take()), REST);
    }, { passive: true });
  }
  document.addEventListener('visibilitychange', () => void (document.hidden && take()));
}
