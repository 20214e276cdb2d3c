/** Time: it runs either way, steps, or goes to a time far off in slices, frame by frame. */

/** The most that time moves on in one frame, in seconds; a page that was hidden does not jump. */
const LONGEST_FRAME = 1 / 20;
/** What a frame may spend on the motion while it plays, and on the way to a time far off, in ms. */
const FRAME = 8;
const SLICE = 14;
/** Frames that fell behind, net of those that did not, until one says so. */
const BEHIND = 30;

/**
 * @typedef {object} Course
 * @property {() => number} now
 * @property {(t: number, deadline: number) => boolean} go Towards t; whether it is reached.
 * @property {() => number} rate Units of time for each second that passes.
 * @property {() => void} [before] What is asked for meanwhile, before time moves in a frame.
 * @property {(frame: number) => void} draw
 * @property {(rests: boolean) => void} [moved] Time moved on, or rests.
 */

export function createClock(/** @type {Course} */ { now, go, rate, before, draw, moved }) {
  let playing = false;
  /** @type {1 | -1} */
  let direction = 1;
  /**
   * A time on the way to which it is, and where it set out.
   *
   * @type {[number, number] | null}
   */
  let goal = null;
  let behind = 0;
  let last = NaN;
  let asked = false;
  document.addEventListener("visibilitychange", () => (last = NaN));

  /** Ask for a frame, unless one is asked for. */
  function wake() {
    if (asked) return;
    asked = true;
    requestAnimationFrame(frame);
  }

  function frame(/** @type {number} */ time) {
    asked = false;
    const passed = Number.isNaN(last) || document.hidden ? 0 : (time - last) / 1000;
    last = time;
    before?.();
    if (goal) approach(goal[1]);
    else if (playing) moveOn(passed);
    draw(time);
    if (playing || goal) wake();
    else last = NaN;
  }

  /** A slice of the way to a time. */
  function approach(/** @type {number} */ t) {
    if (!go(t, performance.now() + SLICE)) return;
    goal = null;
    moved?.(!playing);
  }

  function moveOn(/** @type {number} */ seconds) {
    const shown = Math.min(seconds, LONGEST_FRAME);
    const t = Math.max(0, now() + direction * rate() * shown);
    const reached = go(t, performance.now() + FRAME) && shown === seconds;
    behind = Math.max(0, Math.min(2 * BEHIND, behind + (reached ? -1 : 1)));
    if (direction < 0 && t === 0) pause();
    else moved?.(false);
  }

  function pause() {
    playing = false;
    moved?.(true);
    wake();
  }

  return {
    get playing() {
      return playing;
    },
    get direction() {
      return direction;
    },
    /** Whether time moves. */
    get runs() {
      return playing || goal !== null;
    },
    wake,
    pause,
    /** Another motion, or the same from its start. */
    fresh() {
      goal = null;
      behind = 0;
      wake();
    },
    start(/** @type {boolean} */ plays) {
      playing = plays;
      direction = 1;
      wake();
    },
    /** Play that way, or pause if it does. */
    toggle(/** @type {1 | -1} */ way) {
      if (playing && direction === way) {
        pause();
        return;
      }
      if (way < 0 && now() <= 0) return;
      playing = true;
      direction = way;
      behind = 0;
      last = NaN;
      wake();
    },
    /** Go to a time, in several frames if it is far off. */
    setGoal(/** @type {number} */ t) {
      goal = [now(), t];
      behind = 0;
      wake();
    },
    /** A little on or back. */
    step(/** @type {number} */ by) {
      pause();
      this.setGoal(Math.max(0, now() + by));
    },
    /** What there is to say about time, or "". */
    note(/** @type {string} */ unit) {
      if (goal && goal[1] !== 0) {
        const [from, to] = goal;
        const done = Math.floor((100 * (now() - from)) / (to - from || 1));
        return `computing to t = ${Number(to.toPrecision(6))} ${unit}: ${done} %`;
      }
      return behind > BEHIND ? "runs slower than asked: this is all that the machine can do" : "";
    },
  };
}
