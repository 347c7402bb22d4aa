/** The words of bat_status; the number of each is its place. */
export const STATUSES = ['ok', 'memory', 'argument', 'number', 'knots', 'count', 'degree', 'dimension', 'parameter',
  'tolerance', 'dot', 'far', 'syntax', 'singular', 'unsupported', 'state'];

/** What the library could not do, and why. */
export class BattenError extends Error {
  /**
   * @param {string} status a word of STATUSES
   * @param {string} message
   * @param {unknown} [best] with 'tolerance': the best result found
   */
  constructor(status, message, best) {
    super(message);
    this.name = 'BattenError';
    this.status = status;
    this.code = STATUSES.indexOf(status);
    this.best = best;
  }
}

/** A value that was not expected, in words. @param {unknown} value @returns {string} */
export function shown(value) {
  const many = /** @type {{ length?: unknown }} */ (value)?.length;
  if (typeof value === 'object' && value !== null) {
    const name = value.constructor?.name ?? 'Object';
    return `${/^[AEIO]/.test(name) ? 'an' : 'a'} ${name}${typeof many === 'number' ? ` of ${many}` : ''}`;
  }
  const text = typeof value === 'string' ? JSON.stringify(value) : typeof value === 'function' ? 'a function' : String(value);
  return text.length <= 40 ? text : `${text.slice(0, 40)}...`;
}

/** The error of an argument. @param {string} name @param {string} expected @param {string} found in words @param {string} [status] @returns {BattenError} */
export const wrong = (name, expected, found, status = 'argument') => new BattenError(status, `${name}: expected ${expected}, found ${found}`);
