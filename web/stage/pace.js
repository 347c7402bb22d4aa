// How sharp a picture is that takes long to paint: while it moves it has fewer pixels rather than fewer frames, and at rest all of
// them.

const SLOW = 28; // milliseconds between two frames of a movement that are too many
const APART = 250; // two that are further apart belong to no movement, unless the second was long due
const LEAST = 0.35; // of the pixels along a side
const COARSER = 0.75;
const REST = 150; // milliseconds without a frame, or twice as long as the last one took, but no longer than
const LATEST = 1500;

export class Pace {
  /** @param {() => void} rested paints the picture with all its pixels @param {typeof setTimeout} [later] */
  constructor(rested, later = setTimeout) {
    this.rested = rested;
    this.later = later;
    this.share = 1; // of the pixels along a side
    this.last = -Infinity;
    this.slow = false;
    this.timer = /** @type {ReturnType<typeof setTimeout> | undefined} */ (undefined);
  }

  /**
   * The picture has moved and is about to be painted.
   * @param {number} now milliseconds @param {number} [waited] since this frame was asked for: the last one was being painted
   */
  moved(now, waited = 0) {
    const took = now - this.last;
    this.last = now;
    const slow = took > SLOW && (took < APART || waited > SLOW);
    if (slow && this.slow) {
      this.share = Math.max(LEAST, this.share * COARSER);
    }
    this.slow = slow;
    if (this.share < 1) {
      clearTimeout(this.timer);
      this.timer = this.later(() => {
        this.share = 1;
        this.slow = false;
        this.rested();
      }, slow ? Math.min(Math.max(REST, 2 * took), LATEST) : REST);
    }
  }
}
