// Shortcuts as they are pressed. Fetched with the sheet of commands.

/**
 * The shortcut that was pressed, as written in the tables; '' when it is none by itself. Only letters and named keys
 * include Shift: whether a sign needs Shift depends on the keyboard layout.
 * @param {KeyboardEvent} event
 */
export function shortcutOf(event) {
  const latin = /^Key[A-Z]$/.test(event.code) && (event.key > '~' || event.altKey);
  const key = latin ? event.code[3] : event.key === ' ' ? 'Space' : event.key;
  if (/^(Shift|Control|Alt|AltGraph|Meta|CapsLock|Dead|Process|Unidentified|Tab|Escape)$/.test(key)) {
    return '';
  }
  const letter = /^[a-z]$/i.test(key);
  const typed = event.getModifierState('AltGraph'); // AltGr types a sign; it is not Ctrl and Alt
  return [(event.ctrlKey || event.metaKey) && !typed && 'Ctrl', event.shiftKey && (letter || key.length > 1) && 'Shift',
    event.altKey && !typed && 'Alt', letter ? key.toUpperCase() : key].filter(Boolean).join('+');
}
