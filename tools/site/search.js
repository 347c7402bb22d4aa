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

  // What people type and what is written here: another spelling, or another program's word.
  const SAME = { color: 'colour', mirror: 'flip', mirrored: 'flipped', center: 'centre', gray: 'grey', autosave: 'unsaved', hotkeys: 'keys', offline: 'network', hotkey: 'key', shortcut: 'key', shortcuts: 'keys',
    cli: 'shell', terminal: 'shell' };
  const EMPTY = new Set(['a', 'an', 'and', 'can', 'do', 'does', 'for', 'how', 'i', 'in', 'is', 'it', 'my', 'of', 'on', 'or', 'the', 'to', 'what', 'where', 'with']);

  /** The words of a question that say something; all of them where none does. */
  function wordsOf(question) {
    const all = question.toLowerCase().split(/[\s?!,;]+/).filter(Boolean);
    const said = all.filter((word) => !EMPTY.has(word));
    return (said.length ? said : all).map((word) => SAME[word] ?? word).map((word) => (word.length > 4 ? word.replace(/s$/, '') : word));
  }

  /** How well a text holds a word: as a word of its own, at the beginning of one, anywhere, not at all. */
  function held(text, word) {
    const at = text.indexOf(word);
    if (at < 0) {
      return 0;
    }
    const words = text.split(/[^\p{L}\p{N}+#.-]+/u);
    return words.some((one) => one === word || one === `${word}s`) ? 3 : words.some((one) => one.startsWith(word)) ? 2 : 1;
  }

  /** How well a row answers: titles before pages before text, what one does in the editor before what is for programmers. */
  function worth([page, title, address, text, rank], words) {
    const [inTitle, inPage, inText] = [title, page, text].map((part) => part.toLowerCase());
    const name = address.includes('#') ? '' : address.replace(/^.*\/|\.html$/g, ''); // of a whole page
    let [sum, hits] = [0, 0];
    for (const word of words) {
      const one = 4 * held(inTitle, word) + 1.5 * held(inPage, word) + 2 * held(inText, word) + 8 * (held(name, word) > 1);
      sum += one;
      hits += one > 0;
    }
    // A title that says the question and nothing else; of a long text a word says less.
    const more = inTitle.split(/\s+/).length - words.length;
    const exact = words.every((word) => held(inTitle, word) === 3) && more < 2 ? 1.5 - 0.5 * more : 0;
    return hits === 0 ? 0 : (sum + 6 * exact) * (1 + 0.5 * rank) * (hits / words.length) ** 3;
  }

  /** The rows that answer a question, the best first. */
  function ranked(rows, question) {
    const words = wordsOf(question);
    return rows.map((row) => [worth(row, words), row]).filter(([sum]) => sum > 0).sort((a, b) => b[0] - a[0]).slice(0, MOST).map(([, row]) => row);
  }

  /** A piece of the text around the word. */
  function around(text, word) {
    const at = Math.max(text.toLowerCase().indexOf(word) - 60, 0);
    return `${at ? '…' : ''}${text.slice(at, at + 180)}…`;
  }

  async function search() {
    const question = field.value.trim();
    found.hidden = !question;
    if (!question) {
      return;
    }
    const rows = ranked(await fetched(), question);
    const words = wordsOf(question);
    found.replaceChildren(...rows.map(([page, title, address, text]) => {
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

  globalThis.manualSearch = async (question) => ranked(await fetched(), question).map((row) => row[2]); // for tests
  field.addEventListener('input', search);
  field.addEventListener('focus', fetched);
})();
