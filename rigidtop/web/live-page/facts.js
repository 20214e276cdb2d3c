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
import { agm, nearestToMiddle, NEARLY_ALONG, polhodePeriod } from "./polhode.js";

/** What rounding of the initial state does to what decides the regime. */
const ROUNDING = 1e-11;
const BISECTIONS = 100;
const MIDPOINTS = 1000;

/** What sleeping and waking are about (rad). */
const NEARLY_UPRIGHT = 0.1;

/** A nutation by less is called hardly any (rad). */
const HARDLY_SEEN = 0.01;

/**
 * All that is known of a motion at its start.
 *
 * @returns {Facts}
 */
export function factsOf(/** @type {Motion} */ motion) {
  const none = { turningPoints: null, smallestSpin: null, sleepingSpin: null, steady: null };
  if (motion.setup.kind === "free") return { ...none, ...freeFacts(motion) };
  if (motion.setup.values.friction > 0) return { ...none, ...frictionFacts(motion) };
  if (!motion.symmetric) {
    const free = motion.weight[0] === 0 && motion.weight[1] === 0 && motion.weight[2] === 0;
    const verdict = free
      ? `Without a torque L is conserved, and the energy. ${freeFacts(motion).verdict}`
      : "Without symmetry about e₃ the spin ω₃ changes and θ has no effective potential: in " +
        "general only the energy and p_φ are conserved.";
    return { ...none, regime: "no symmetry", verdict };
  }
  const nutation = regimeOf(motion);
  const { regime, turningPoints, nutationPeriod } = nutation;
  const facts = steadyFacts(motion);
  const spins = Math.abs(motion.start.omega[2]) >= (facts.sleepingSpin ?? Infinity);
  const words = inWords(nutation, spins);
  return { regime, turningPoints, nutationPeriod, ...facts, verdict: `${words}${facts.verdict}` };
}

/**
 * The potential in which θ moves, as a function of θ; of a symmetric body.
 *
 * @returns {(theta: number) => number}
 */
export function potentialOf(/** @type {Motion} */ motion) {
  const { M, R, g, lambda1, lambda3, p_phi, p_psi } = quantities(motion.start, motion);
  return (theta) => effectivePotential({ M, R, g, lambda1, lambda3, p_phi, p_psi, theta });
}

/**
 * What θ and φ do, in a sentence; none where the verdict says it.
 *
 * @param {ReturnType<typeof regimeOf>} of
 * @param {boolean} asleep whether it spins fast enough to sleep upright
 */
function inWords({ regime, turningPoints, nutationPeriod, meanPrecession }, asleep) {
  const degrees = (/** @type {number} */ angle) => `${number((angle * 180) / Math.PI)}°`;
  const [least, most] = turningPoints.map(degrees);
  const size = turningPoints[1] - turningPoints[0];
  const every = Number.isFinite(nutationPeriod) ? ` every ${number(nutationPeriod)} s` : "";
  const rate = `${number(meanPrecession)} rad/s on average`;
  const swings = ["waves", "cusps", "loops"].includes(regime);
  if (swings && turningPoints[0] < NEARLY_UPRIGHT) {
    if (asleep && turningPoints[1] < 2 * NEARLY_UPRIGHT) {
      return `It sleeps: the axis stays within ${most} of the vertical. `;
    }
    return asleep
      ? `It nods down to ${most}, and comes back to ${least}${every}. `
      : `It wakes up: the axis falls to ${most}, and comes back to ${least}${every}. `;
  }
  if (swings && size < HARDLY_SEEN) {
    return `It precesses, and nods by no more than ${degrees(size)}${every} (${regime}): ${rate}. `;
  }
  const between =
    least === most
      ? `θ stays within ${degrees(size)} of ${least}`
      : `θ goes between ${least} and ${most}${every}`;
  /** @type {Record<string, string>} */
  const sentences = {
    "steady precession": `Steady precession: θ stays at ${least}. `,
    "plane pendulum": `A pendulum in a plane: ${between}. `,
    "through the vertical": `Through the vertical: ${between}. `,
    waves: `Waves: ${between}, and φ̇ keeps its sign: ${rate}. `,
    cusps: `Cusps: ${between}, and φ̇ vanishes at one end: ${rate}. `,
    loops: `Loops: ${between}, and φ̇ changes sign: ${rate}. `,
  };
  return sentences[regime] ?? "";
}

function regimeOf(/** @type {Motion} */ motion) {
  const { start, weight } = motion;
  const { M, R, g, lambda1, lambda3, p_phi, p_psi } = quantities(start, motion);
  const u = start.e3[2];
  const sine = Math.hypot(start.e3[0], start.e3[1]);
  const resting = start.theta_dot === 0;
  const cubic = nutationCubic({ E: start.energy, M, R, g, lambda1, lambda3, p_phi, p_psi });
  // φ̇ sin²θ = a + bu
  const [b, a] = precessionNumerator({ lambda1, p_phi, p_psi });
  const scale = Math.abs(a) + Math.abs(b) + Math.sqrt(Math.max(...cubic.map(Math.abs)));
  // Where the momenta about ẑ and e₃ agree, or are opposite, the vertical is a root of the cubic.
  const poles = [1, -1].filter((pole) => Math.abs(a + b * pole) <= ROUNDING * scale);
  const [low, high] =
    sine === 0 && resting ? [u, u] : cosines(cubic, poles, u, sine, resting);
  const turningPoints = /** @type {[number, number]} */ ([Math.acos(high), Math.acos(low)]);
  const nutationPeriod = periodBetween(cubic, low, high);
  const meanPrecession = meanRate(cubic, [b, a], low, high);
  const found = (/** @type {string} */ regime) =>
    ({ regime, turningPoints, nutationPeriod, meanPrecession });
  if (weight[2] === 0) return found("free precession");
  if (sine === 0 && resting) return found(weight[2] * u > 0 ? "sleeping" : "hanging");
  if (high - low < ROUNDING * sine * sine) return found("steady precession");
  if (Math.abs(a) + Math.abs(b) <= ROUNDING * scale) return found("plane pendulum");
  if (high === 1 || low === -1) return found("through the vertical");
  if (resting && start.phi_dot === 0) return found("cusps");
  const [first, second] = [a + b * high, a + b * low];
  const size = Math.abs(first) + Math.abs(second) + Math.abs(b) * (high - low);
  if (Math.min(Math.abs(first), Math.abs(second)) <= ROUNDING * size) return found("cusps");
  return found(first * second < 0 ? "loops" : "waves");
}

/**
 * The time in which cos θ goes from one root of the cubic to the other and back:
 * 4K(k)/√(c(u₃ − u₁)) with k² = (u₂ − u₁)/(u₃ − u₁); infinite where the upper root is double.
 */
function periodBetween(
  /** @type {readonly number[]} */ [c3, c2], /** @type {number} */ low, /** @type {number} */ high,
) {
  if (!(high > low) || c3 === 0) return Infinity;
  const third = -c2 / c3 - low - high;
  // Of a body whose centre of mass is on the other side of the pivot the third root is below.
  const [far, near] = c3 > 0 ? [third - low, third - high] : [high - third, low - third];
  if (!(near > ROUNDING * far)) return Infinity;
  return (2 * Math.PI) / (agm(1, Math.sqrt(near / far)) * Math.sqrt(Math.abs(c3) * far));
}

/**
 * φ̇ on average over a nutation.  With u = cos θ = m − h cos s between its turning points φ̇ and
 * dt/ds are smooth and periodic in s, where the sums of the midpoint rule converge geometrically.
 * Near the vertical φ̇ sin²θ/(1 − u²) is steep: the poles at u = ±1 are taken out, each of which
 * turns φ by half a turn, since (a + bu)² is minus the cubic there.
 *
 * @param {readonly number[]} cubic
 * @param {readonly number[]} linear coefficients of u and 1 in φ̇ sin²θ
 * @param {number} low
 * @param {number} high
 */
function meanRate([c3, c2], [b, a], low, high) {
  const third = -c2 / c3 - low - high;
  const poles = [1, -1].map((pole) => {
    const numerator = a + b * pole;
    const way = Math.sign(numerator);
    return { pole, numerator, way, root: way * Math.sqrt((1 - pole * low) * (1 - pole * high)) };
  });
  let [turned, passed] = [0, 0];
  for (let k = 0; k < MIDPOINTS; k++) {
    const s = ((k + 0.5) * Math.PI) / MIDPOINTS;
    const u = (low + high - (high - low) * Math.cos(s)) / 2;
    const time = 1 / Math.sqrt(Math.abs(c3 * (third - u)));
    passed += time;
    for (const { pole, numerator, way, root } of poles) {
      turned += way / 2 + (numerator * time - root) / (2 * (1 - pole * u));
    }
  }
  return turned / passed;
}

/**
 * The smallest and the largest u = cos θ, between which the cubic is positive.
 *
 * Known roots are divided out, for what rounding leaves of them must not be taken for a sign: the
 * poles that are roots, and u itself if θ rests there.
 *
 * @param {readonly number[]} cubic
 * @param {readonly number[]} poles
 * @param {number} u at the start
 * @param {number} sine
 * @param {boolean} resting
 * @returns {[number, number]}
 */
function cosines(cubic, poles, u, sine, resting) {
  let rest = cubic;
  for (const pole of poles) {
    // (1 − u) and (1 + u) are positive between the poles.
    rest = without(rest, pole).map((c) => -pole * c);
  }
  const f = (/** @type {number} */ x) => rest.reduce((sum, c) => sum * x + c, 0);
  if (!resting) return [boundary(f, u, -1), boundary(f, u, 1)];
  const quotient = without(rest, u);
  const q = (/** @type {number} */ x) => quotient.reduce((sum, c) => sum * x + c, 0);
  const slope = q(u);
  const size = quotient.reduce((sum, c) => sum + Math.abs(c), 0);
  if (Math.abs(slope) <= ROUNDING * size * (poles.length > 0 ? 1 : sine * sine)) return [u, u];
  const up = Math.sign(slope);
  const other = boundary((x) => up * q(x), u, up);
  return up > 0 ? [u, other] : [other, u];
}

/** A polynomial, largest power first, divided by x − root, of which it has a factor. */
function without(/** @type {readonly number[]} */ polynomial, /** @type {number} */ root) {
  let carried = 0;
  return polynomial.slice(0, -1).map((c) => (carried = carried * root + c));
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
 * @returns {[number, number] | null}
 */
function ratesOf(/** @type {Motion} */ motion) {
  const { M, R, g, lambda1, lambda3, omega3 } = quantities(motion.start, motion);
  const { theta } = motion.start;
  const spin = { M, R, g, lambda1, lambda3, theta, omega3: Math.abs(omega3) };
  const [slow, fast] = steadyRates(spin);
  if (!Number.isFinite(slow) || !Number.isFinite(fast)) return null;
  return omega3 < 0 ? [-slow, -fast] : [slow, fast];
}

function steadyFacts(/** @type {Motion} */ motion) {
  const { M, R, g, lambda1, lambda3, omega3 } = quantities(motion.start, motion);
  const { theta } = motion.start;
  const nothing = { smallestSpin: null, sleepingSpin: null, steady: null };
  const spin = `ω₃ = ${number(omega3)} rad/s`;
  if (M * g * R === 0) {
    const across = Math.hypot(motion.start.omega[0], motion.start.omega[1]);
    const e3 = across > 0 ? "e₃ turns steadily about L" : "e₃ stays where it is";
    return { ...nothing, verdict: `Without a torque ${e3}, whatever ω₃ is.` };
  }
  // Turned upside down, a body whose centre of mass is on the other side of the pivot is the same.
  const cosine = Math.sign(R) * Math.cos(theta);
  const needed = (/** @type {number} */ angle) =>
    smallestSpin({ M, R: Math.abs(R), g, lambda1, lambda3, theta: angle });
  const sleepingSpin = needed(0);
  const known = { ...nothing, sleepingSpin };
  if (Math.sin(theta) === 0 || theta === Math.PI) {
    if (cosine < 0) {
      return { ...known, verdict: "Hanging straight down, it is stable with any spin." };
    }
    const stable = Math.abs(omega3) >= sleepingSpin;
    const verdict =
      `With the centre of mass straight above the pivot it is stable from |ω₃| ≥ ` +
      `${number(sleepingSpin)} rad/s on: with ${spin} it ` +
      (stable ? "sleeps." : "falls at the slightest push.");
    return { ...known, smallestSpin: sleepingSpin, verdict };
  }
  const tilt = `θ₀ = ${number((theta * 180) / Math.PI)}°`;
  const steady = ratesOf(motion);
  const rates = steady
    ? `Ω₋ = ${number(steady[0])} rad/s and Ω₊ = ${number(steady[1])} rad/s`
    : "";
  if (Math.abs(cosine) < 1e-12) {
    const verdict =
      omega3 === 0
        ? `At ${tilt} steady precession needs a spin: |ω₃| > 0.`
        : `At ${tilt} steady precession needs |ω₃| > 0 and has one rate, ` +
          `MgR/(λ₃ω₃) = ${number((M * g * R) / (lambda3 * omega3))} rad/s.`;
    return { ...known, smallestSpin: 0, verdict };
  }
  if (cosine < 0) {
    const verdict =
      `With the centre of mass below the pivot, as at ${tilt}, every spin has a steady ` +
      `precession: ${rates}.`;
    return { ...known, smallestSpin: 0, steady, verdict };
  }
  const least = needed(Math.acos(cosine));
  const upright =
    Math.acos(cosine) < NEARLY_UPRIGHT
      ? ` Upright, it is stable from |ω₃| ≥ ${number(sleepingSpin)} rad/s on.`
      : "";
  const verdict =
    `Steady precession at ${tilt} needs |ω₃| ≥ ${number(least)} rad/s: ` +
    (steady ? `with ${spin} there are ${rates}.` : `with ${spin} there is none.`) +
    upright;
  return { ...known, smallestSpin: least, steady, verdict };
}

/** How fast friction takes the spin, and from when on it is too slow to sleep. */
function frictionFacts(/** @type {Motion} */ { setup, moments, arm, start }) {
  const { M, g, friction } = setup.values;
  const [lambda1, lambda2, lambda3] = Array.from(moments);
  if (lambda1 !== lambda2 || arm[0] !== 0 || arm[1] !== 0) {
    return { regime: "friction", verdict: "Friction takes energy, at the rate cω²." };
  }
  // Gravity has no torque along e₃, so that λ₃ω̇₃ = −cω₃.
  const time = lambda3 / friction;
  const R = Math.abs(arm[2]);
  const sleepingSpin = smallestSpin({ M, R, g, lambda1, lambda3, theta: 0 });
  const spins = Math.abs(start.omega[2]) / sleepingSpin;
  const awake = spins > 1 && Number.isFinite(spins)
    ? ` From t = ${number(time * Math.log(spins))} s on it is too slow to sleep upright.`
    : "";
  const verdict = `Friction takes the spin: ω₃ halves every ${number(time * Math.LN2)} s.${awake}`;
  return { regime: "running down", sleepingSpin, verdict };
}

function freeFacts(/** @type {Motion} */ motion) {
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
  if (parallel(omega, L)) {
    const verdict =
      "ω stays where it is: its moments are equal, and every axis between is a principal axis.";
    return { regime: "steady", verdict };
  }
  const [lambda1, lambda2, lambda3] = moments;
  if (motion.symmetric) {
    const body = bodyConeRate({ lambda1, lambda3, omega3: omega[2] });
    const way = body > 0 ? "clockwise" : "anticlockwise";
    const verdict =
      `Two moments are equal: seen from the tip of e₃, ω turns ${way} about it in the body, with ` +
      `Ω_b = (λ₁ − λ₃)ω₃/λ₁ = ${number(body)} ${per}; in space e₃ turns about L at Ω_s = L/λ₁ = ` +
      `${number(length / lambda1)} ${per}.`;
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
  const time = motion.setup.clock === "d" ? "days" : "s";
  const period = polhodePeriod(motion.moments, twiceT, L2);
  const flips =
    nearestToMiddle(motion.moments, omega) < NEARLY_ALONG
      ? `It flips: it spins about ${axis(middle)}, the axis of the intermediate moment, and ` +
        `turns over every ${number(period / 2)} ${time}. `
      : "";
  return {
    regime: excess > 0 ? "short axis" : "long axis",
    verdict:
      `${flips}ω goes round ${axis(k)}, the axis of the ${which} moment, in ${number(period)} ` +
      `${time}: L² ${excess > 0 ? ">" : "<"} 2Tλ${"₁₂₃"[middle]}.`,
  };
}

/** Whether two vectors are parallel, to rounding. */
function parallel(/** @type {readonly number[]} */ a, /** @type {readonly number[]} */ b) {
  const product = [0, 1, 2].map((k) => {
    const [i, j] = [(k + 1) % 3, (k + 2) % 3];
    return a[i] * b[j] - a[j] * b[i];
  });
  return Math.hypot(...product) <= ROUNDING * Math.hypot(...a) * Math.hypot(...b);
}

/** Four digits, with a minus sign. */
function number(/** @type {number} */ x) {
  const text = String(Number(x.toPrecision(4)));
  return text.replace("-", "−");
}
