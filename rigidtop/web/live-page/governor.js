/** Frames slower than this, in milliseconds, are too slow; faster than `FAST`, there is time. */
const SLOW = 21;
const FAST = 17.6;
/** The lowest resolution, and the factor from one to the next. */
const LEAST = 0.6;
const STEP = 0.8;

/**
 * Lowers the resolution when frames come too slowly, and raises it again when they come in time.
 * Where a lower resolution does not help, as on a screen of 30 frames a second, it goes back.
 */
export function createGovernor(/** @type {(quality: number) => void} */ apply) {
  let quality = 1;
  let last = NaN;
  let total = 0;
  let count = 0;
  /** How long frames took before the last lowering. */
  let before = NaN;
  /** Frames to wait before the resolution may be raised; twice as many after each failure. */
  let patience = 180;
  let calm = 0;
  let rest = 0;

  function change(/** @type {number} */ next) {
    quality = next;
    calm = 0;
    apply(quality);
  }

  function judge(/** @type {number} */ mean) {
    if (rest > 0) {
      rest -= 1;
      return;
    }
    if (mean > SLOW) {
      if (quality <= LEAST) {
        if (mean > 0.93 * before) {
          before = NaN;
          rest = 60;
          change(1);
        }
        return;
      }
      if (calm > 0 && quality < 1) patience = Math.min(4 * 60 * 60, 2 * patience);
      if (Number.isNaN(before)) before = mean;
      change(Math.max(LEAST, STEP * quality));
    } else if (mean < FAST && quality < 1) {
      calm += 20;
      if (calm >= patience) {
        before = NaN;
        change(Math.min(1, quality / STEP));
        calm = 1;
      }
    }
  }

  return {
    /** To be called at each frame. */
    tick(/** @type {number} */ now) {
      const took = now - last;
      last = now;
      // A pause says nothing about speed.
      if (!(took < 200)) {
        total = 0;
        count = 0;
        return;
      }
      total += took;
      count += 1;
      if (count < 20) return;
      const mean = total / count;
      total = 0;
      count = 0;
      judge(mean);
    },
  };
}
