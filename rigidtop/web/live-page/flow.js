/** The motion of a system from its state at t = 0: integrated forwards, sampled, and kept. */

import { measures, points, rates } from "./derived.js";
import { createSolver } from "./dop853.js";

/** What is kept of the past, and how much of it at most. */
const PER_STEP = 12;
const KEPT = 8000;
/** A first look, so many steps long, tells how fast and how far things move. */
const LOOK = 60;
const ROUGH = { rtol: 1e-6, atol: 1e-300 };
/** Of a step, on q and q̇ in units of the largest of either. */
const ACCURACY = { rtol: 2.5e-14, atol: 1e-14 };

/**
 * The motion; throws an Error with one sentence where it cannot start so.
 *
 * @param {SystemData} data
 * @param {readonly number[]} start
 * @param {readonly number[]} values of the parameters
 * @param {number} [beside] The timescale of another motion, at whose times it is sampled.
 * @returns {Flow}
 */
export function createFlow({ tableau, state: letters, sides, points: count, bodies, kept }, start,
  values, beside) {
  const half = letters.length / 2;
  const size = start.length;
  const seen = 3 * count + 9 * bodies.length;

  /** The largest of each of q and q̇. */
  const largest = Array.from(start, Math.abs);
  const quick = fastest();
  const trial = createSolver(
    tableau, (s, out) => rates(s, values, out), start, 0, quick / 1000, ROUGH);
  const look = new Float64Array(size);
  try {
    // What moves evenly has steps of any length.
    for (let k = 0; k < LOOK && trial.h < 100 * quick; k++) {
      trial.step();
      trial.at(trial.t, look);
      look.forEach((x, i) => (largest[i] = Math.max(largest[i], Math.abs(x))));
    }
  } catch {
    // What ends soon is seen as far as it goes.
  }
  const pace = trial.t > 0 ? trial.t / LOOK : 1;
  const timescale = beside ?? pace;
  const units = [0, half].flatMap((from) => {
    const most = Math.max(...largest.slice(from, from + half));
    return Array(half).fill(most > 0 ? most : 1);
  });
  if (size > 2 * half) units.push(1);

  const inside = new Float64Array(size);
  let solver = solverAt(start, 0, pace / 8);
  const first = momentAt(start, 0);
  if (!Number.isFinite(first.energy) || !Array.from(rateOf(start)).every(Number.isFinite)) {
    throw new Error("the accelerations cannot be computed there");
  }
  let now = first;
  let trail = [first];
  const beginning = measured(start);
  const sizes = kept.map((_, k) => Math.abs(beginning[2 + 2 * k]));
  const most = kept.map(() => 0);

  function rateOf(/** @type {ArrayLike<number>} */ state) {
    const out = new Float64Array(size);
    rates(state, values, out);
    return out;
  }

  /** The time in which q changes by itself at first, by its rate or from rest; 1 if it does not. */
  function fastest() {
    const made = rateOf(start);
    const sizeOf = (/** @type {ArrayLike<number>} */ of, /** @type {number} */ from) =>
      Math.hypot(...Array.from(of).slice(from, from + half));
    const [q, v, a] = [sizeOf(start, 0), sizeOf(start, half), sizeOf(made, half)];
    const times = q > 0 ? [q / v, Math.sqrt(q / a)] : [v / a];
    const found = times.filter((time) => Number.isFinite(time) && time > 0);
    return found.length > 0 ? Math.min(...found) : 1;
  }

  /** A solver in which q and q̇ have the size 1. */
  function solverAt(/** @type {ArrayLike<number>} */ state, /** @type {number} */ t,
    /** @type {number} */ h) {
    const scaled = Array.from(state, (x, k) => x / units[k]);
    return createSolver(tableau, (s, out) => {
      for (let k = 0; k < size; k++) inside[k] = s[k] * units[k];
      rates(inside, values, out);
      for (let k = 0; k < size; k++) out[k] /= units[k];
    }, scaled, t, h, ACCURACY);
  }

  function measured(/** @type {ArrayLike<number>} */ state) {
    const out = new Float64Array(1 + 2 * kept.length);
    measures(state, values, out);
    return out;
  }

  function momentAt(/** @type {ArrayLike<number>} */ state, /** @type {number} */ t) {
    const made = Float64Array.from(state);
    const places = new Float64Array(seen);
    points(made, values, places);
    return { t, state: made, points: places, energy: measured(made)[0] };
  }

  /** What the last step of a solver passed through. */
  function at(/** @type {Solver} */ from, /** @type {number} */ t) {
    const state = new Float64Array(size);
    from.at(t, state);
    return momentAt(state.map((x, k) => x * units[k]), t);
  }

  function check(/** @type {Moment} */ { state, t }) {
    for (const [k, sign] of sides) {
      if (state[k] * sign < 0) {
        const side = sign > 0 ? "positive" : "negative";
        throw new Error(`${letters[k].letter} was declared ${side}, and leaves that side`);
      }
    }
    measured(state).forEach((value, k, all) => {
      if (k === 0 || k % 2 === 0) return;
      const which = (k - 1) / 2;
      sizes[which] = Math.max(sizes[which], Math.abs(all[k + 1]));
      const strayed = Math.abs(value - (kept[which].startsWith("constraint") ? 0 : beginning[k]));
      most[which] = Math.max(most[which], strayed / (sizes[which] || 1));
    });
    if (!Number.isFinite(state[0])) throw new Error(`the motion ends at t = ${t}`);
  }

  /** From the last sample that is kept before t. */
  function goBack(/** @type {number} */ t) {
    while (trail.length > 1 && trail[trail.length - 1].t > t) trail.pop();
    // What was so long ago that it is forgotten is computed anew.
    if (trail[0].t > t) trail = [first];
    const last = trail[trail.length - 1];
    solver = solverAt(last.state, last.t, pace / 8);
    now = last;
  }

  /** The samples that are due until t, which lies in the solver's last step. */
  function record(/** @type {number} */ t) {
    for (;;) {
      const due = trail[trail.length - 1].t + timescale / PER_STEP;
      if (due > t) return;
      trail.push(at(solver, due));
      if (trail.length > 1.25 * KEPT) trail.splice(0, trail.length - KEPT);
    }
  }

  return {
    start: first,
    timescale,
    sizes: units.slice(0, 2 * half),
    get now() {
      return now;
    },
    get trail() {
      return trail;
    },
    reset() {
      goBack(0);
      most.fill(0);
    },
    /** Whether t is reached before the deadline; an Error where the motion ends before. */
    go(/** @type {number} */ t, deadline = Infinity) {
      if (t < now.t) goBack(t);
      record(Math.min(t, solver.t));
      while (solver.t < t && performance.now() <= deadline) {
        solver.step();
        check(at(solver, solver.t));
        record(Math.min(t, solver.t));
      }
      const reached = Math.min(t, solver.t);
      if (reached > now.t) now = at(solver, reached);
      return reached === t;
    },
    /** `count` moments from t = 0, as far as the motion goes. */
    ahead(/** @type {number} */ duration, /** @type {number} */ count) {
      const apart = solverAt(start, 0, pace / 8);
      const made = [first];
      try {
        for (let k = 1; k < count; k++) {
          const t = (duration * k) / (count - 1);
          while (apart.t < t) apart.step();
          made.push(at(apart, t));
        }
      } catch {
        // As far as it goes.
      }
      return made;
    },
    drift() {
      const here = measured(now.state);
      return kept.map((name, k) => {
        const zero = name.startsWith("constraint") ? 0 : beginning[1 + 2 * k];
        const strayed = Math.abs(here[1 + 2 * k] - zero) / (sizes[k] || 1);
        return { name, now: strayed, most: most[k], exact: false };
      });
    },
  };
}
