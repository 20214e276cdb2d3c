/** A motion from its state at t = 0: integrated forwards, sampled, and kept. */

/** How many samples the trail keeps. */
const KEPT = 8000;

/**
 * The time of a motion; what is particular to it are solvers, samples and what is checked.
 *
 * @template {Timed & { readonly state: Float64Array }} S
 * @param {ArrayLike<number>} beginning
 * @param {number} spacing of the samples of the trail
 * @param {object} of
 * @param {(state: ArrayLike<number>, t: number) => Solver} of.solverAt
 * @param {(look: (t: number) => Float64Array, t: number, known: S | null) => S} of.sampleAt What
 *   turns is counted on from what is known; what is between the two can be looked at.
 * @param {(sample: S) => void} of.check After each step; an Error where the motion ends.
 * @param {() => void} of.forget What was seen of it so far.
 */
export function createMoving(beginning, spacing, { solverAt, sampleAt, check, forget }) {
  const at = (/** @type {Solver} */ from, /** @type {number} */ t, /** @type {S | null} */ known) =>
    sampleAt((time) => {
      const state = new Float64Array(beginning.length);
      from.at(time, state);
      return state;
    }, t, known);
  let solver = solverAt(beginning, 0);
  const start = at(solver, 0, null);
  let now = start;
  /** The newest that angles are counted on from, and the end of the solver's last step. */
  let [known, end] = [start, start];
  let trail = [start];
  /** Of what the trail has forgotten a sample here and there, to begin from. */
  let marks = [start];

  /** To the last sample that is kept before t. */
  function goBack(/** @type {number} */ t) {
    while (trail.length > 1 && trail[trail.length - 1].t > t) trail.pop();
    if (trail[0].t > t) {
      marks = marks.filter((mark) => mark.t <= t);
      trail = marks.slice(-1);
    }
    now = known = end = trail[trail.length - 1];
    solver = solverAt(now.state, now.t);
  }

  /** The samples that are due until t, which lies in the solver's last step. */
  function record(/** @type {number} */ t) {
    for (;;) {
      const due = trail[trail.length - 1].t + spacing;
      if (due > t) return;
      known = at(solver, due, known);
      trail.push(known);
      if (trail.length > 1.25 * KEPT) marks.push(trail.splice(0, trail.length - KEPT)[0]);
    }
  }

  return {
    start,
    get now() {
      return now;
    },
    get trail() {
      return trail;
    },
    reset() {
      goBack(0);
      forget();
    },
    /** Whether t is reached before the deadline; an Error where the motion ends before. */
    go(/** @type {number} */ t, deadline = Infinity) {
      if (!(t >= 0 && t < Infinity)) throw new Error("a time wants to be a number from 0 on");
      if (t < now.t) goBack(t);
      record(Math.min(t, solver.t));
      while (solver.t < t && performance.now() <= deadline) {
        known = end;
        solver.step();
        end = at(solver, solver.t, known);
        check(end);
        record(Math.min(t, solver.t));
      }
      const reached = Math.min(t, solver.t);
      if (reached > now.t) now = known = at(solver, reached, known);
      check(now);
      return reached === t;
    },
    /** `count` samples from t = 0, as far as the motion goes. */
    ahead(/** @type {number} */ duration, /** @type {number} */ count) {
      const apart = solverAt(beginning, 0);
      const made = [start];
      let last = start;
      try {
        for (let k = 1; k < count; k++) {
          const t = (duration * k) / (count - 1);
          while (apart.t < t) {
            last = at(apart, apart.t, last);
            apart.step();
          }
          last = at(apart, t, last);
          made.push(last);
        }
      } catch {
        // As far as it goes.
      }
      return made;
    },
  };
}
