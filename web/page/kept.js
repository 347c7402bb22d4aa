// What is kept of the page's looks in this browser; where nothing can be kept, it is for this page only.

/** @param {string} name @returns {string} '' when nothing is kept */
export function kept(name) {
  try {
    return localStorage.getItem(name) ?? '';
  } catch {
    return '';
  }
}

/** @param {string} name @param {string} value */
export function keep(name, value) {
  try {
    localStorage.setItem(name, value);
  } catch {
    // It is for this page only then.
  }
}
