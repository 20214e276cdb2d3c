/** The motion of a system from its state at t = 0: integrated forwards, sampled, and kept. */

import { measures, points, rates } from "./derived.js";
import { createSolver } from "./dop853.js";
import { createMoving } from "./moving.js";

/** How many samples the trail takes for the time of a step. */
const PER_STEP = 12;
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
  if (!Number.isFinite(measured(start)[0]) || !Array.from(rateOf(start)).every(Number.isFinite)) {
    throw new Error("the accelerations cannot be computed there");
  }
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
  function solverAt(/** @type {ArrayLike<number>} */ state, /** @type {number} */ t) {
    const scaled = Array.from(state, (x, k) => x / units[k]);
    return createSolver(tableau, (s, out) => {
      for (let k = 0; k < size; k++) inside[k] = s[k] * units[k];
      rates(inside, values, out);
      for (let k = 0; k < size; k++) out[k] /= units[k];
    }, scaled, t, pace / 8, ACCURACY);
  }

  function measured(/** @type {ArrayLike<number>} */ state) {
    const out = new Float64Array(1 + 2 * kept.length);
    measures(state, values, out);
    return out;
  }

  function sampleAt(/** @type {(t: number) => Float64Array} */ look, /** @type {number} */ t) {
    const state = t === 0 ? Float64Array.from(start) : look(t).map((x, k) => x * units[k]);
    const places = new Float64Array(seen);
    points(state, values, places);
    return { t, state, points: places, energy: measured(state)[0] };
  }

  function check(/** @type {Moment} */ { state, t }) {
    for (const [k, sign] of sides) {
      if (state[k] * sign < 0) {
        const side = sign > 0 ? "positive" : "negative";
        throw new Error(`${letters[k].letter} was declared ${side}, and leaves that side`);
      }
    }
    const here = measured(state);
    kept.forEach((_, k) => (sizes[k] = Math.max(sizes[k], Math.abs(here[2 + 2 * k]))));
    strayed(here).forEach((drift, k) => (most[k] = Math.max(most[k], drift)));
    if (!Number.isFinite(state[0])) throw new Error(`the motion ends at t = ${t}`);
  }

  /** By how much each of what is kept has strayed, as measured at a state. */
  function strayed(/** @type {Float64Array} */ here) {
    return kept.map((name, k) => {
      const usual = name.startsWith("constraint") ? 0 : beginning[1 + 2 * k];
      return Math.abs(here[1 + 2 * k] - usual) / (sizes[k] || 1);
    });
  }

  const moving = createMoving(start, timescale / PER_STEP, {
    solverAt, sampleAt, check, forget: () => most.fill(0),
  });
  return Object.assign(moving, {
    timescale,
    sizes: units.slice(0, 2 * half),
    drift() {
      const now = strayed(measured(moving.now.state));
      return kept.map((name, k) => ({ name, now: now[k], most: most[k], exact: false }));
    },
  });
}
