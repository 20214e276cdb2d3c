/** Where a value stands on its slider: evenly, by its logarithm, or finer towards zero. */

import { nice } from "./axes.js";

const DEGREE = Math.PI / 180;

/** Steps of a slider from end to end, at least. */
const STEPS = 600;

/** How much finer a rate is near zero than at the ends: cosh of it. */
const FINER = 3.5;

/** A slider takes what it is meant to hit within this part of its length. */
const CATCH = 0.012;

/** With Shift a slider moves so much less than the hand. */
const SLOWER = 0.1;

/** The least and the largest position, the step, and the way there and back. */
export function trackOf(
  /** @type {Parameter} */ parameter, /** @type {number} */ least, /** @type {number} */ most,
) {
  const clip = (/** @type {number} */ value) => Math.min(Math.max(value, least), most);
  if (parameter.logarithmic || (least < 0 && !parameter.angle)) {
    const size = Math.max(-least, most);
    const there = parameter.logarithmic
      ? Math.log10
      : (/** @type {number} */ value) => Math.asinh((value * Math.sinh(FINER)) / size) / FINER;
    const back = parameter.logarithmic
      ? (/** @type {number} */ at) => 10 ** at
      : (/** @type {number} */ at) => (size * Math.sinh(FINER * at)) / Math.sinh(FINER);
    const [low, high] = [there(least), there(most)];
    return {
      low,
      high,
      step: (high - low) / STEPS,
      at: there,
      value: (/** @type {number} */ at) => clip(Number(back(at).toPrecision(3))),
    };
  }
  const unit = parameter.angle ? DEGREE : 1;
  const step = nice((most - least) / unit / (2 * STEPS));
  const end = (/** @type {number} */ count) => Number((count * step).toPrecision(12));
  return {
    low: end(Math.floor(least / unit / step)),
    high: end(Math.ceil(most / unit / step)),
    step,
    at: (/** @type {number} */ value) => value / unit,
    value: (/** @type {number} */ at) => clip(at * unit),
  };
}

/** @typedef {ReturnType<typeof trackOf>} Track */

/** The value that a hand on a slider means: the nearest of those that it may be meant to hit. */
export function caught(
  /** @type {Track} */ track, /** @type {number} */ at, /** @type {readonly number[]} */ marks,
) {
  const near = marks
    .filter((mark) => Math.abs(track.at(mark) - at) <= CATCH * (track.high - track.low))
    .sort((a, b) => Math.abs(track.at(a) - at) - Math.abs(track.at(b) - at));
  return near.length > 0 ? near[0] : track.value(at);
}

/**
 * Listen to a range input: `moved` is told each value.  A finger or a mouse is caught by the marks;
 * with Shift it moves the slider less far and is not caught.
 *
 * @param {HTMLInputElement} range
 * @param {() => { track: Track, marks: readonly number[], value: number }} now
 * @param {(value: number) => void} moved
 */
export function listen(range, now, moved) {
  let dragged = false;
  let shift = false;
  /** Where Shift was pressed: the hand there, and the slider. */
  let anchor = /** @type {[number, number] | null} */ (null);
  let hand = 0;
  range.addEventListener("pointerdown", () => {
    dragged = true;
    anchor = null;
    hand = Number(range.value);
  });
  for (const name of ["pointerup", "pointercancel", "blur"]) {
    range.addEventListener(name, () => (dragged = false));
  }
  range.addEventListener("pointermove", (event) => (shift = event.shiftKey));
  range.addEventListener("input", () => {
    const { track, marks, value } = now();
    hand = Number(range.value);
    if (!dragged) {
      moved(track.value(hand));
      return;
    }
    if (!shift) {
      anchor = null;
      moved(caught(track, hand, marks));
      return;
    }
    anchor ??= [hand, track.at(value)];
    moved(track.value(anchor[1] + SLOWER * (hand - anchor[0])));
  });
}
