/** Poinsot's construction in numbers: the curves that ω runs through in a body without torque. */

import { firstIntegrals, polhode } from "./equations.js";

/** The axes 0, 1, 2 from the smallest moment to the largest. */
export function axesByMoment(/** @type {Numbers} */ moments) {
  return [0, 1, 2].sort((i, j) => moments[i] - moments[j]);
}

/** Twice the kinetic energy, and L², of ω in body components. */
export function invariants(/** @type {Numbers} */ moments, /** @type {Numbers} */ omega) {
  const [lambda1, lambda2, lambda3] = Array.from(moments);
  const [omega1, omega2, omega3] = Array.from(omega);
  const body = { lambda1, lambda2, lambda3 };
  const [twiceEnergy, squareL] = firstIntegrals({ ...body, omega1, omega2, omega3 });
  return { twiceEnergy, squareL };
}

/** Two moments that differ by less are taken as equal. */
const EQUAL = 1e-12;

function same(/** @type {number} */ a, /** @type {number} */ b) {
  return Math.abs(a - b) <= EQUAL * Math.max(a, b);
}

/** The axis that a polhode goes around, or −1 if all moments are equal: then every ω rests. */
export function enclosedAxis(
  /** @type {Numbers} */ moments, /** @type {number} */ twiceEnergy, /** @type {number} */ squareL,
) {
  const [a, b, c] = axesByMoment(moments);
  if (same(moments[a], moments[c])) return -1;
  if (same(moments[a], moments[b])) return c;
  if (same(moments[b], moments[c])) return a;
  return squareL > twiceEnergy * moments[b] ? c : a;
}

/**
 * The polhode around the axis k at the angle u: that around e₃, with the axes renamed in turn.
 *
 * @param {Numbers} moments
 * @param {number} twiceEnergy
 * @param {number} squareL
 * @param {number} k
 * @param {number} side 1 or −1, the sign of ω_k
 * @param {number} u
 * @param {number[]} out
 */
export function polhodePoint(moments, twiceEnergy, squareL, k, side, u, out) {
  const i = (k + 1) % 3;
  const j = (k + 2) % 3;
  const renamed = { lambda1: moments[i], lambda2: moments[j], lambda3: moments[k] };
  const integrals = { twice_T: twiceEnergy, L_squared: squareL };
  const point = polhode({ ...renamed, ...integrals, angle: u });
  // The root of what is zero but for rounding is zero.
  [out[i], out[j], out[k]] = point.map((w) => (Number.isNaN(w) ? 0 : w));
  out[k] *= side;
  return out;
}

/** A polhode around the axis k as points, of which the first comes again at its end. */
export function polhodeOf(
  /** @type {Numbers} */ moments, /** @type {number} */ twiceEnergy, /** @type {number} */ squareL,
  /** @type {number} */ k, /** @type {number} */ side, /** @type {number} */ count,
) {
  return Array.from({ length: count + 1 }, (_, n) =>
    polhodePoint(moments, twiceEnergy, squareL, k, side, (2 * Math.PI * n) / count, [0, 0, 0]));
}

/**
 * The polhodes of an energy: those at parts of the way from the separatrix to an outer axis, and
 * the separatrix.  Where two moments are equal all go around the third axis and nothing parts them.
 *
 * @param {Numbers} moments
 * @param {number} twiceEnergy
 * @param {readonly number[]} parts
 * @param {number} count points of each
 */
export function familyOf(moments, twiceEnergy, parts, count) {
  const [a, b, c] = axesByMoment(moments);
  const outer = [a, c].filter((k) => !same(moments[k], moments[b]));
  const both = (/** @type {number} */ moment, /** @type {number} */ k) => [1, -1].map((side) =>
    polhodeOf(moments, twiceEnergy, twiceEnergy * moment, k, side, count));
  return {
    others: outer.flatMap((k) => parts.flatMap((part) =>
      both(moments[b] + part * (moments[k] - moments[b]), k))),
    separatrix: outer.length === 2 ? both(moments[b], c) : [],
  };
}

/**
 * What the closed form of ω on its polhode is made of: the axis k that it goes around, the one of
 * the intermediate moment and the other outer one, the rate p, and 1 − k² of its modulus.
 */
function closedForm(
  /** @type {Numbers} */ moments, /** @type {number} */ twiceEnergy, /** @type {number} */ squareL,
) {
  const k = enclosedAxis(moments, twiceEnergy, squareL);
  const [a, middle, c] = axesByMoment(moments);
  const other = k === a ? c : a;
  const steep = (moments[k] - moments[middle]) * (squareL - twiceEnergy * moments[other]);
  const flat = (moments[middle] - moments[other]) * (twiceEnergy * moments[k] - squareL);
  const rate = Math.sqrt(steep / (moments[a] * moments[middle] * moments[c]));
  return { k, middle, other, rate, complement: Math.max(0, 1 - flat / steep) };
}

/** The time in which ω goes once around its polhode: 4 K(k)/p; infinite on the separatrix. */
export function polhodePeriod(
  /** @type {Numbers} */ moments, /** @type {number} */ twiceEnergy, /** @type {number} */ squareL,
) {
  if (enclosedAxis(moments, twiceEnergy, squareL) < 0) return Infinity;
  const { rate, complement } = closedForm(moments, twiceEnergy, squareL);
  // K by the arithmetic-geometric mean of 1 and the complementary modulus.
  return complement > 0 ? (2 * Math.PI) / (agm(1, Math.sqrt(complement)) * rate) : Infinity;
}

/**
 * The time until ω has next no component along the axis of the intermediate moment, of which a
 * body that flips turns over: that component is B sin φ, and φ runs through F(φ, k) = p t.
 * Infinite where there is no such time.
 */
export function untilFlip(/** @type {Numbers} */ moments, /** @type {Numbers} */ omega) {
  const { twiceEnergy, squareL } = invariants(moments, omega);
  const half = polhodePeriod(moments, twiceEnergy, squareL) / 2;
  if (!Number.isFinite(half)) return Infinity;
  const { k, middle, other, rate, complement } = closedForm(moments, twiceEnergy, squareL);
  const [across, along] = [middle, other].map((i) => {
    const angle = i === (k + 1) % 3 ? 0 : Math.PI / 2;
    return omega[i] / polhodePoint(moments, twiceEnergy, squareL, k, 1, angle, [0, 0, 0])[i];
  });
  if (Number.isNaN(across + along)) return Infinity;
  const [next, last] = [moments[(middle + 1) % 3], moments[(middle + 2) % 3]];
  // sin φ, with φ turned by half a turn where that brings it between −π/2 and π/2, running up.
  const sine = (across * Math.sign(along || 1) * Math.sign((next - last) * omega[k])) /
    Math.hypot(across, along);
  const square = sine * sine;
  const passed =
    (Math.abs(sine) * carlson(1 - square, 1 - (1 - complement) * square, 1)) / rate;
  return sine < 0 ? passed : half - passed;
}

/** So near the intermediate axis a body is thought to spin about it (rad). */
export const NEARLY_ALONG = 0.45;

/** How near L comes to the axis of the intermediate moment (rad). */
export function nearestToMiddle(/** @type {Numbers} */ moments, /** @type {Numbers} */ omega) {
  const { twiceEnergy, squareL } = invariants(moments, omega);
  const [a, b, c] = axesByMoment(moments);
  const [small, middle, large] = [a, b, c].map((k) => moments[k]);
  if (same(small, middle) || same(middle, large)) return Math.PI / 2;
  // The larger of L_b² with L_a = 0 and with L_c = 0, whichever the polhode has.
  const outer = squareL > twiceEnergy * middle ? large : small;
  const part = ((twiceEnergy * outer - squareL) * middle) / (squareL * (outer - middle));
  return Math.acos(Math.sqrt(Math.min(1, Math.max(0, part))));
}

/** Carlson's R_F(x, y, z), at most one of them 0: by duplication, then five terms of its series. */
function carlson(/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ z) {
  for (;;) {
    const mean = (x + y + z) / 3;
    const [u, v, w] = [x, y, z].map((each) => 1 - each / mean);
    if (Math.max(Math.abs(u), Math.abs(v), Math.abs(w)) < 2e-3) {
      const [e2, e3] = [u * v + v * w + w * u, u * v * w];
      return (1 - e2 / 10 + e3 / 14 + (e2 * e2) / 24 - (3 * e2 * e3) / 44) / Math.sqrt(mean);
    }
    const sum = Math.sqrt(x * y) + Math.sqrt(y * z) + Math.sqrt(z * x);
    [x, y, z] = [(x + sum) / 4, (y + sum) / 4, (z + sum) / 4];
  }
}

/** The arithmetic-geometric mean of two positive numbers, the larger first. */
export function agm(/** @type {number} */ x, /** @type {number} */ y) {
  while (x - y > 1e-14 * x) [x, y] = [(x + y) / 2, Math.sqrt(x * y)];
  return x;
}
