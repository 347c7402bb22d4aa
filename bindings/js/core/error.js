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
