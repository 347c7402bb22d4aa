// The keys of tools: by default those that most drawing programs have, or those that Batten had before. A choice binds the keys
// of the commands that differ, like one who binds them by hand; what was bound otherwise is a map of one's own.

import { tell } from '../page/words.js';

/** The keys of before of the commands whose keys tools have now. @type {Record<string, string>} */
const OTHERS = { range: 'R', isolate: 'I', outline: 'O' };
const MAPS = ['standard', 'earlier', 'own'];

/** The keys of before, where they were others: the sprite has those of the tools. @returns {[string, string][]} */
const earlierKeys = () => [.../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('symbol[data-earlier]'))]
  .map(({ id, dataset }) => /** @type {[string, string]} */ ([id.slice('icon-'.length), dataset.earlier ?? ''])).concat(Object.entries(OTHERS));

/** @param {Record<string, string>} bound the keys that were bound, by command @returns {string} one of MAPS */
function mapOf(bound) {
  const rows = earlierKeys();
  const earlier = rows.filter(([command, keys]) => bound[command] === keys).length;
  return rows.every(([command]) => bound[command] === undefined) ? 'standard' : earlier === rows.length ? 'earlier' : 'own';
}

/** A choice of the map. @param {import('./panel.js').Panel} panel */
export function keyMap({ settings, words, controls }) {
  const row = document.createElement('div');
  const label = tell(document.createElement('label'), { text: 'shell.key-map' });
  const choice = document.createElement('select');
  row.className = 'control choice';
  choice.id = 'setting-key-map';
  label.htmlFor = choice.id;
  choice.append(...MAPS.map((map) => tell(new Option('', map), { text: `key-map.${map}` })));
  const look = () => {
    choice.value = mapOf(settings?.kept.keys ?? {});
    /** @type {HTMLOptionElement} */ (choice.lastElementChild).disabled = choice.value !== 'own'; // it is made in the list of commands
  };
  choice.addEventListener('change', () => {
    for (const [command, keys] of earlierKeys()) {
      settings?.bind(command, choice.value === 'earlier' ? keys : null);
    }
    words?.retell();
    look();
  });
  controls.list.push(look);
  look();
  row.append(label, choice);
  return row;
}
