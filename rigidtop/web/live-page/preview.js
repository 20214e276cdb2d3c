/** What is to come, as the page shows it while it stands at t = 0. */

/** How long the page rests before it is computed, in ms. */
const DELAY = 120;

/**
 * @template {Timed} S
 * @param {() => S[][]} compute Of the motion and its ghost.
 * @param {() => void} computed
 */
export function createPreview(compute, computed) {
  /** @type {S[][] | null} */
  let ahead = null;
  /** @type {S[][]} */
  let mirrored = [];
  let timer = 0;
  return {
    forget() {
      clearTimeout(timer);
      timer = 0;
      ahead = null;
    },
    /** What is to come, and the same as if it were past; null until it is computed. */
    shown() {
      if (!ahead && !timer) {
        timer = window.setTimeout(() => {
          ahead = compute();
          mirrored = ahead.map((trail) =>
            trail.map((sample) => ({ ...sample, t: -sample.t })).reverse());
          computed();
        }, DELAY);
      }
      return ahead && { ahead, mirrored };
    },
  };
}
