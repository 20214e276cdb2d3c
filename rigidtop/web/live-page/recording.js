/** A motion that was computed before: its rows, between which it is interpolated. */

import { measures, points } from "./derived.js";

/** How many rows the trail keeps. */
const KEPT = 4000;

/**
 * What plays it, in the place of what computes a motion.
 *
 * @param {SystemData} data
 * @param {Recording} recording
 * @returns {Flow}
 */
export function createRecording({ points: count, bodies }, { step, width, rows, ended }) {
  const bytes = Uint8Array.from(atob(rows), (letter) => letter.charCodeAt(0));
  const numbers = new Float32Array(bytes.buffer);
  const most = numbers.length / width - 1;
  const last = step * most;
  const first = at(0);
  let now = first;

  function at(/** @type {number} */ t) {
    const place = Math.min(t / step, most);
    const k = Math.floor(place);
    const next = Math.min(k + 1, most);
    const state = Float64Array.from(numbers.subarray(k * width, (k + 1) * width), (x, i) =>
      x + (place - k) * (numbers[next * width + i] - x));
    const seen = new Float64Array(3 * count + 9 * bodies.length);
    points(state, [], seen);
    const energy = new Float64Array(1);
    measures(state, [], energy);
    return { t, state, points: seen, energy: energy[0] };
  }

  const all = Array.from({ length: most + 1 }, (_, k) => at(k * step));
  return {
    start: first,
    timescale: 50 * step,
    sizes: Array.from({ length: width }, (_, i) =>
      Math.max(...all.map(({ state }) => Math.abs(state[i]))) || 1),
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
      Array.from({ length: many }, (_, k) => at(Math.min((duration * k) / (many - 1), last))),
    drift: () => [],
  };
}
