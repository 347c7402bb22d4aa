// Search without a server: the words of all pages are one script, fetched when the field is first used.
(() => {
  const MOST = 12;
  const field = document.getElementById('search');
  const found = document.getElementById('found');
  const depth = document.body.dataset.depth;
  let coming = null;

  const fetched = () => coming ??= new Promise((resolve) => {
    const script = document.createElement('script');
    script.src = `${depth}words.js`;
    script.addEventListener('load', () => resolve(globalThis.manualWords));
    document.head.append(script);
  });

  /** How well a row holds all the words; 0: not at all. */
  function worth([page, title, , text], words) {
    let sum = 0;
    for (const word of words) {
      const [inTitle, inPage, inText] = [title, page, text].map((part) => part.toLowerCase().includes(word));
      if (!inTitle && !inPage && !inText) {
        return 0;
      }
      sum += 6 * inTitle + 2 * inPage + 1 * inText + 6 * (title.toLowerCase() === word);
    }
    return sum;
  }

  /** A piece of the text around the word. */
  function around(text, word) {
    const at = Math.max(text.toLowerCase().indexOf(word) - 60, 0);
    return `${at ? '…' : ''}${text.slice(at, at + 180)}…`;
  }

  async function search() {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    found.hidden = words.length === 0;
    if (!words.length) {
      return;
    }
    const rows = (await fetched()).map((row) => [worth(row, words), row]).filter(([sum]) => sum > 0)
      .sort((a, b) => b[0] - a[0]).slice(0, MOST);
    found.replaceChildren(...rows.map(([, [page, title, address, text]]) => {
      const item = document.createElement('li');
      const link = document.createElement('a');
      link.href = depth + address;
      link.textContent = title && title !== page ? `${page}: ${title}` : page;
      const piece = document.createElement('p');
      piece.textContent = around(text, words[0]);
      item.append(link, piece);
      return item;
    }));
    if (!rows.length) {
      found.textContent = 'Nothing found.';
    }
  }

  field.addEventListener('input', search);
  field.addEventListener('focus', fetched);
})();
