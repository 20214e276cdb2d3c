// What can be said of a motion before it moves: its regime, its turning points, and which spin a
// steady precession needs.

import {
  bodyConeRate,
  effectivePotential,
  firstIntegrals,
  nutationCubic,
  precessionNumerator,
  smallestSpin,
  steadyRates,
} from "./equations.js";
import { quantities } from "./motion.js";

/** @typedef {import("./types").Facts} Facts */
/** @typedef {import("./types").Motion} Motion */

/** What rounding of the initial state does to what decides the regime. */
const ROUNDING = 1e-11;
const BISECTIONS = 100;

/** What sleeping and waking are about (rad). */
const NEARLY_UPRIGHT = 0.1;

/** Of cos θ: a turning point that close to the vertical is the vertical. */
const NEAR_POLE = 1e-9;

/**
 * All that is known of a motion at its start.
 *
 * @param {Motion} motion
 * @returns {Facts}
 */
export function factsOf(motion) {
  const none = { turningPoints: null, smallestSpin: null, sleepingSpin: null, steady: null };
  if (motion.setup.kind === "free") return { ...none, ...freeFacts(motion) };
  if (!motion.symmetric) {
    const verdict =
      "Without symmetry about e₃ the spin ω₃ is not constant and θ has no effective potential: " +
      "only the energy and p_φ are conserved.";
    return { ...none, regime: "no symmetry", verdict };
  }
  const { regime, turningPoints } = regimeOf(motion);
  return { regime, turningPoints, ...steadyFacts(motion) };
}

/**
 * The potential in which θ moves, as a function of θ; of a symmetric body.
 *
 * @param {Motion} motion
 * @returns {(theta: number) => number}
 */
export function potentialOf(motion) {
  const { M, R, g, lambda1, lambda3, p_phi, p_psi } = quantities(motion.start, motion);
  return (theta) => effectivePotential({ M, R, g, lambda1, lambda3, p_phi, p_psi, theta });
}

/** @param {Motion} motion */
function regimeOf(motion) {
  const { start, weight } = motion;
  const { M, R, g, lambda1, lambda3, p_phi, p_psi } = quantities(start, motion);
  const u = start.e3[2];
  const sine = Math.hypot(start.e3[0], start.e3[1]);
  const atRest = sine === 0 && start.theta_dot === 0;
  const cubic = nutationCubic({ E: start.energy, M, R, g, lambda1, lambda3, p_phi, p_psi });
  const [low, high] = atRest ? [u, u] : cosines(cubic, u, sine, start.theta_dot);
  const turningPoints = /** @type {[number, number]} */ ([Math.acos(high), Math.acos(low)]);
  const found = (/** @type {string} */ regime) => ({ regime, turningPoints });
  if (weight[2] === 0) return found("free precession");
  if (atRest) return found(weight[2] * u > 0 ? "sleeping" : "hanging");
  if (high - low < ROUNDING * sine * sine) return found("steady precession");
  // φ̇ sin²θ = a + bu
  const [b, a] = precessionNumerator({ lambda1, p_phi, p_psi });
  const scale = Math.abs(a) + Math.abs(b);
  if (scale <= ROUNDING * Math.sqrt(Math.abs(cubic[0]))) return found("plane pendulum");
  // The axis can reach the vertical only where the momenta about ẑ and e₃ agree, or are opposite.
  const reached = Math.abs(a + b) < Math.abs(a - b) ? 1 - high : low + 1;
  if (Math.min(Math.abs(a + b), Math.abs(a - b)) <= ROUNDING * scale && reached < NEAR_POLE) {
    return found("through the vertical");
  }
  const [first, second] = [a + b * high, a + b * low];
  const size = Math.abs(first) + Math.abs(second) + Math.abs(b) * (high - low);
  if (Math.min(Math.abs(first), Math.abs(second)) <= ROUNDING * size) return found("cusps");
  return found(first * second < 0 ? "loops" : "waves");
}

/**
 * The smallest and the largest u = cos θ, between which the cubic is positive.
 *
 * @param {readonly number[]} cubic
 * @param {number} u at the start
 * @param {number} sine
 * @param {number} thetaDot
 * @returns {[number, number]}
 */
function cosines([c3, c2, c1, c0], u, sine, thetaDot) {
  const f = (/** @type {number} */ x) => ((c3 * x + c2) * x + c1) * x + c0;
  if (thetaDot !== 0) return [boundary(f, u, -1), boundary(f, u, 1)];
  // At rest in θ, u is a root itself; what is left is the quadratic c₃x² + px + q.
  const p = c2 + u * c3;
  const q = c1 + u * p;
  const slope = (c3 * u + p) * u + q; // f′(u)
  const size = Math.abs(c3) + Math.abs(p) + Math.abs(q);
  if (Math.abs(slope) <= ROUNDING * size * sine * sine) return [u, u];
  const up = Math.sign(slope);
  // From u to the pole the quotient changes its sign once.
  const other = boundary((x) => up * ((c3 * x + p) * x + q), u, up);
  return up > 0 ? [u, other] : [other, u];
}

/** Where f, positive at `from`, becomes negative on the way to `end`; `end` if it does not. */
function boundary(
  /** @type {(x: number) => number} */ f,
  /** @type {number} */ from,
  /** @type {number} */ end,
) {
  if (f(end) > 0) return end;
  let [inside, outside] = [from, end];
  for (let k = 0; k < BISECTIONS; k++) {
    const middle = (inside + outside) / 2;
    if (f(middle) > 0) inside = middle;
    else outside = middle;
  }
  return inside;
}

/**
 * The slow and the fast rate of steady precession; null where there are none.
 *
 * @param {Motion} motion
 * @returns {[number, number] | null}
 */
function ratesOf(motion) {
  const { M, R, g, lambda1, lambda3, omega3 } = quantities(motion.start, motion);
  const { theta } = motion.start;
  const spin = { M, R, g, lambda1, lambda3, theta, omega3: Math.abs(omega3) };
  const [slow, fast] = steadyRates(spin);
  if (!Number.isFinite(slow) || !Number.isFinite(fast)) return null;
  return omega3 < 0 ? [-slow, -fast] : [slow, fast];
}

/** @param {Motion} motion */
function steadyFacts(motion) {
  const { M, R, g, lambda1, lambda3, omega3 } = quantities(motion.start, motion);
  const { theta } = motion.start;
  const nothing = { smallestSpin: null, sleepingSpin: null, steady: null };
  const spin = `ω₃ = ${number(omega3)} rad/s`;
  if (!(M * g * R > 0)) {
    return {
      ...nothing,
      verdict: "Without a torque e₃ turns steadily about L, whatever ω₃ is: free precession.",
    };
  }
  const needed = (/** @type {number} */ angle) =>
    smallestSpin({ M, R, g, lambda1, lambda3, theta: angle });
  const sleepingSpin = needed(0);
  const tilt = `θ₀ = ${number((theta * 180) / Math.PI)}°`;
  const steady = ratesOf(motion);
  const rates = steady
    ? `Ω₋ = ${number(steady[0])} rad/s and Ω₊ = ${number(steady[1])} rad/s`
    : "";
  if (theta === 0) {
    const stable = Math.abs(omega3) >= sleepingSpin;
    const verdict =
      `Upright, the top is stable from |ω₃| ≥ ${number(sleepingSpin)} rad/s on: with ${spin} it ` +
      (stable ? "sleeps." : "falls at the slightest push.");
    return { smallestSpin: sleepingSpin, sleepingSpin, steady, verdict };
  }
  if (Math.abs(Math.cos(theta)) < 1e-12) {
    const verdict =
      omega3 === 0
        ? `At ${tilt} steady precession needs a spin: |ω₃| > 0.`
        : `At ${tilt} steady precession needs |ω₃| > 0 and has one rate, ` +
          `MgR/(λ₃ω₃) = ${number((M * g * R) / (lambda3 * omega3))} rad/s.`;
    return { smallestSpin: 0, sleepingSpin, steady: null, verdict };
  }
  if (Math.cos(theta) < 0) {
    const verdict =
      `Below the horizontal, at ${tilt}, every spin has a steady precession: ${rates}.`;
    return { smallestSpin: 0, sleepingSpin, steady, verdict };
  }
  const least = needed(theta);
  const upright =
    theta < NEARLY_UPRIGHT
      ? ` Upright, it is stable from |ω₃| ≥ ${number(sleepingSpin)} rad/s on.`
      : "";
  const verdict =
    `Steady precession at ${tilt} needs |ω₃| ≥ ${number(least)} rad/s: ` +
    (steady ? `with ${spin} there are ${rates}.` : `with ${spin} there is none.`) +
    upright;
  return { smallestSpin: least, sleepingSpin, steady, verdict };
}

/** @param {Motion} motion */
function freeFacts(motion) {
  const moments = Array.from(motion.moments);
  const omega = Array.from(motion.start.omega);
  const L = omega.map((w, k) => w * moments[k]);
  const length = Math.hypot(...L);
  const per = motion.setup.clock === "d" ? "rad/d" : "rad/s";
  const order = [0, 1, 2].sort((i, k) => moments[i] - moments[k]);
  const [small, middle, large] = order;
  const axis = (/** @type {number} */ k) => `e${"₁₂₃"[k]}`;
  const across = (/** @type {number} */ k) =>
    Math.hypot(...L.filter((_, i) => i !== k)) / (length || 1);
  if (length === 0) return { regime: "rest", verdict: "The body is at rest." };
  for (const k of order) {
    if (across(k) > ROUNDING) continue;
    const stable = k !== middle || moments[small] === moments[middle] ||
      moments[middle] === moments[large];
    const why = stable ? "" : ", unstably: it is the axis of the intermediate moment";
    return { regime: "steady", verdict: `ω stays along the principal axis ${axis(k)}${why}.` };
  }
  const [lambda1, lambda2, lambda3] = moments;
  if (motion.symmetric) {
    if (lambda1 === lambda3) {
      return { regime: "steady", verdict: "All moments are equal: ω stays where it is." };
    }
    const body = bodyConeRate({ lambda1, lambda3, omega3: omega[2] });
    const verdict =
      `Two moments are equal: ω turns about e₃ in the body at Ω_b = ${number(body)} ${per}, and ` +
      `e₃ about L in space at Ω_s = L/λ₁ = ${number(length / lambda1)} ${per}.`;
    return { regime: "regular precession", verdict };
  }
  // L² − 2Tλ of the middle moment, over its largest value: the polhode goes round the other axes.
  const [omega1, omega2, omega3] = omega;
  const [twiceT, L2] = firstIntegrals({ lambda1, lambda2, lambda3, omega1, omega2, omega3 });
  const excess = L2 - twiceT * moments[middle];
  if (moments[small] === moments[middle] || moments[middle] === moments[large]) {
    const k = moments[small] === moments[middle] ? large : small;
    return {
      regime: "regular precession",
      verdict: `Two moments are equal: ω turns steadily about ${axis(k)}.`,
    };
  }
  if (Math.abs(excess) <= ROUNDING * length * length) {
    const verdict =
      `ω runs on the separatrix, L² = 2Tλ${"₁₂₃"[middle]}, towards the intermediate axis ` +
      `${axis(middle)}, which it never reaches.`;
    return { regime: "separatrix", verdict };
  }
  const k = excess > 0 ? large : small;
  const which = excess > 0 ? "largest" : "smallest";
  return {
    regime: excess > 0 ? "short axis" : "long axis",
    verdict:
      `ω goes round ${axis(k)}, the axis of the ${which} moment: ` +
      `L² ${excess > 0 ? ">" : "<"} 2Tλ${"₁₂₃"[middle]}.`,
  };
}

/** Four digits, with a minus sign. */
function number(/** @type {number} */ x) {
  const text = String(Number(x.toPrecision(4)));
  return text.replace("-", "−");
}
