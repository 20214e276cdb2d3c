/** A motion that was computed before: its rows, between which it is interpolated. */

import { measures, points } from "./derived.js";

/** @typedef {import("./types").SystemData} SystemData */
/** @typedef {import("./types").Recording} Recording */
/** @typedef {import("./flow.js").Moment} Moment */
/** @typedef {import("./flow.js").Flow} Flow */

/** How many rows the trail keeps. */
const KEPT = 4000;

/**
 * What plays it, in the place of what computes a motion.
 *
 * @param {SystemData} data
 * @param {Recording} recording
 * @returns {Flow}
 */
export function createRecording({ points: count, bodies, state: letters }, { step, rows, ended }) {
  const last = step * (rows.length - 1);
  const first = at(0);
  let now = first;

  function at(/** @type {number} */ t) {
    const place = Math.min(t / step, rows.length - 1);
    const k = Math.min(Math.floor(place), Math.max(rows.length - 2, 0));
    const [before, after] = [rows[k], rows[Math.min(k + 1, rows.length - 1)]];
    const state = Float64Array.from(before, (x, i) => x + (place - k) * (after[i] - x));
    const seen = new Float64Array(3 * count + 9 * bodies.length);
    points(state, [], seen);
    const energy = new Float64Array(1);
    measures(state, [], energy);
    return { t, state, points: seen, energy: energy[0] };
  }

  const all = rows.map((_, k) => at(k * step));
  return {
    start: first,
    pace: 1,
    sizes: letters.map((_, k) => Math.max(...rows.map((row) => Math.abs(row[k]))) || 1),
    get now() {
      return now;
    },
    get trail() {
      const upTo = Math.floor(now.t / step) + 1;
      return all.slice(Math.max(0, upTo - KEPT), upTo);
    },
    reset() {
      now = first;
    },
    go(/** @type {number} */ t) {
      now = at(Math.min(t, last));
      if (t > last) throw new Error(ended);
      return true;
    },
    ahead: (/** @type {number} */ duration, /** @type {number} */ many) =>
      Array.from({ length: many }, (_, k) =>
        at(Math.min((duration * k) / (many - 1), last))),
    drift: () => [],
  };
}
