/** Poinsot's construction in numbers: the curves that ω runs through in a body without torque. */

import { firstIntegrals, polhode } from "./equations.js";

/** @typedef {import("./types").Numbers} Numbers */

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

/** The time in which ω goes once around its polhode: 4 K(k)/p; infinite on the separatrix. */
export function polhodePeriod(
  /** @type {Numbers} */ moments, /** @type {number} */ twiceEnergy, /** @type {number} */ squareL,
) {
  const k = enclosedAxis(moments, twiceEnergy, squareL);
  if (k < 0) return Infinity;
  const [a, b, c] = axesByMoment(moments);
  const other = moments[k === a ? c : a];
  const steep = (moments[k] - moments[b]) * (squareL - twiceEnergy * other);
  const flat = (moments[b] - other) * (twiceEnergy * moments[k] - squareL);
  const rate = Math.sqrt(steep / (moments[a] * moments[b] * moments[c]));
  // K by the arithmetic-geometric mean of 1 and the complementary modulus.
  const complement = Math.sqrt(Math.max(0, 1 - flat / steep));
  return complement > 0 ? (2 * Math.PI) / (agm(1, complement) * rate) : Infinity;
}

/** The arithmetic-geometric mean of two positive numbers, the larger first. */
export function agm(/** @type {number} */ x, /** @type {number} */ y) {
  while (x - y > 1e-14 * x) [x, y] = [(x + y) / 2, Math.sqrt(x * y)];
  return x;
}
