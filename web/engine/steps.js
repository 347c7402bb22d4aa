// The lines of a journal, run one by one into a new editor. A line at which the module trapped twice is left out, and so
// is one that cannot be run without it; all others are run, and an undo of a step that was left out with it.

/** @typedef {(line: Uint8Array, first: boolean) => boolean} Run runs a line; false: it was refused */

const TWICE = 2;
const LF = 10;

/** @param {Uint8Array} line @param {string} start */
const begins = (line, start) => line.length > start.length && [...start].every((c, i) => line[i] === c.charCodeAt(0));

export class Steps {
  /** @param {Uint8Array} journal */
  constructor(journal) {
    this.journal = journal;
    /** How often the module trapped at each line, by where it begins. @type {Map<number, number>} */
    this.traps = new Map();
    /** Where the line that is being run begins. */
    this.at = -1;
    /** The lines left out by the last run, with their line breaks. @type {Uint8Array[]} */
    this.left = [];
    /** Steps that can be undone and redone: whether each was run. @type {boolean[]} */
    this.done = [];
    /** @type {boolean[]} */
    this.undone = [];
  }

  /** The module trapped at the line that was being run. */
  trapped() {
    this.traps.set(this.at, (this.traps.get(this.at) ?? 0) + 1);
    this.at = -1; // a trap before the next run's first line is no line's
  }

  /** @param {Run} run @returns {boolean} false: the first line cannot be run, and so none can */
  play(run) {
    [this.left, this.done, this.undone] = [[], [], []];
    for (let from = 0, to = 0; from < this.journal.length; from = to) {
      const end = this.journal.indexOf(LF, from);
      to = end < 0 ? this.journal.length : end + 1;
      this.at = from;
      const line = this.journal.subarray(from, end < 0 ? to : end);
      if (line.length > 0 && !this.#one(line, run)) {
        this.left.push(this.journal.slice(from, to));
        if (from === 0) {
          return false;
        }
      }
    }
    return true;
  }

  /** @param {Uint8Array} line @param {Run} run @returns {boolean} false: it is left out */
  #one(line, run) {
    const undo = begins(line, '{"do":"undo"');
    if (undo || begins(line, '{"do":"redo"')) {
      return undo ? this.#turn(this.done, this.undone, line, run) : this.#turn(this.undone, this.done, line, run);
    }
    const ran = this.#run(line, run);
    if (begins(line, '{"do":')) {
      this.done.push(ran);
      this.undone = [];
    }
    return ran;
  }

  /**
   * Undo or redo: of a step that was left out there is nothing to take back.
   * @param {boolean[]} from @param {boolean[]} to @param {Uint8Array} line @param {Run} run
   */
  #turn(from, to, line, run) {
    if (from.at(-1) !== false && !this.#run(line, run)) {
      return false;
    }
    to.push(from.pop() ?? true);
    return true;
  }

  /** @param {Uint8Array} line @param {Run} run */
  #run(line, run) {
    const first = this.at === 0; // without it there is nothing to go on from: it is tried for as long as any is
    return (first || (this.traps.get(this.at) ?? 0) < TWICE) && run(line, first);
  }
}
