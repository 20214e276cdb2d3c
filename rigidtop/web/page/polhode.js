/** Poinsot's construction in numbers: the curves that ω runs through in a body without torque. */

/** @typedef {import("./types").Numbers} Numbers */

/** The axes 0, 1, 2 from the smallest moment to the largest. */
export function axesByMoment(/** @type {Numbers} */ moments) {
  return [0, 1, 2].sort((i, j) => moments[i] - moments[j]);
}

/** Twice the kinetic energy, and L², of ω in body components. */
export function invariants(/** @type {Numbers} */ moments, /** @type {Numbers} */ omega) {
  let twiceEnergy = 0;
  let squareL = 0;
  for (let k = 0; k < 3; k++) {
    twiceEnergy += moments[k] * omega[k] ** 2;
    squareL += (moments[k] * omega[k]) ** 2;
  }
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
 * The polhode around the axis k at the angle u.  With ω_k eliminated from 2T and L², what is left
 * is an ellipse: 2Tλ_k − L² = λ_i(λ_k − λ_i)ω_i² + λ_j(λ_k − λ_j)ω_j².
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
  const rest = twiceEnergy * moments[k] - squareL;
  const half = (/** @type {number} */ n) =>
    Math.sqrt(Math.max(0, rest / (moments[n] * (moments[k] - moments[n]))));
  out[i] = half(i) * Math.cos(u);
  out[j] = half(j) * Math.sin(u);
  const left = twiceEnergy - moments[i] * out[i] ** 2 - moments[j] * out[j] ** 2;
  out[k] = side * Math.sqrt(Math.max(0, left / moments[k]));
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
  let x = 1;
  let y = Math.sqrt(Math.max(0, 1 - flat / steep));
  if (!(y > 0)) return Infinity;
  while (x - y > 1e-14) [x, y] = [(x + y) / 2, Math.sqrt(x * y)];
  return (2 * Math.PI) / (x * rate);
}
