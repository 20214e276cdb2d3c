// The motion of a body from its state at t = 0, moved to any time.
//
// The attitude is a unit quaternion, so no attitude is a special place.  A body that is symmetric
// about e₃, with its centre of mass on e₃, is integrated in the frame that follows e₃ without
// turning about it; the turn about e₃, which is ω₃t exactly, is put back afterwards.  A fast spin
// then costs no steps and no accuracy.  The norm of the quaternion is conserved by the equations
// and not enforced while integrating; the attitudes that come out are normalised.

import { createSolver } from "./dop853.js";
import {
  angularMomentum,
  attitudeMatrix,
  dampedBody,
  energy,
  eulerRates,
  gravityTorque,
  heavyBody,
  heavyTop,
  omegaOfRates,
  quaternionOfAngles,
} from "./equations.js";
import { createMoving } from "./moving.js";

/** Of a step, on the components of the quaternion and of ω: near what rounding allows. */
export const ACCURACY = { rtol: 2.5e-14, atol: 1e-14 };

/** How many samples the trail takes for a radian of the fastest turning. */
const PER_RADIAN = 4;

/** The farthest that is computed ahead, in times of the motion: some hundredths of a second. */
const FARTHEST_AHEAD = 2000;

/** What rounding may leave of a triangle inequality that is an equality. */
const TOLERANCE = 1e-9;

/** Azimuths that change by more than this between two looks are looked at more closely (rad). */
const LARGE_TURN = 2;
const LOOKS = 40;

/**
 * The body and the initial state of a setup, complete and checked.
 *
 * @typedef {object} Start
 * @property {readonly [number, number, number]} moments
 * @property {number} M
 * @property {number} g
 * @property {readonly [number, number, number]} arm from the pivot to the centre of mass
 * @property {number} friction its torque over ω
 * @property {number[]} q
 * @property {number[]} omega body components
 * @property {number} phi
 * @property {number} psi
 */

/**
 * What a setup says, complete; an Error with one sentence if there is no such body.
 *
 * @returns {Start}
 */
export function startOf(/** @type {Setup} */ setup) {
  const { lambda1, lambda2, lambda3 } = setup.values;
  const moments = /** @type {[number, number, number]} */ ([lambda1, lambda2, lambda3]);
  const heavy = setup.kind === "heavy-top";
  const { M = 1, g = 0, R1 = 0, R2 = 0, R = 0, friction = 0 } = heavy ? setup.values : {};
  const arm = /** @type {[number, number, number]} */ ([R1, R2, R]);
  if (!(friction >= 0)) throw new Error("friction must not be negative");
  checkBody(moments, M, g, arm, setup.clock === "d" ? "" : " kg m²");
  if (heavy) {
    const { theta, theta_dot, phi, phi_dot, psi, omega3 } = setup.values;
    // The float nearest to π means π: a top that hangs straight down, exactly.
    const hanging = theta === Math.PI;
    const phidot = hanging ? 0 : phi_dot;
    const omega = omegaOfRates({ theta, psi, thetadot: theta_dot, phidot, psidot: 0 });
    const [q0, q1, q2, q3] = quaternionOfAngles({ phi, theta, psi });
    const q = hanging ? [0, q1, q2, 0] : [q0, q1, q2, q3];
    const rates = [omega[0], omega[1], omega3];
    return { moments, M, g, arm, friction, q, omega: rates, phi, psi };
  }
  const omega = [setup.values.omega1, setup.values.omega2, setup.values.omega3];
  const angles = attitudeAngles(setup, moments, omega);
  return { moments, M, g, arm, friction, q: quaternionOfAngles(angles), omega, ...angles };
}

/** θ, φ, ψ of a free body: as given, or those that put L along ẑ. */
function attitudeAngles(
  /** @type {Setup} */ setup, /** @type {readonly number[]} */ moments,
  /** @type {readonly number[]} */ omega,
) {
  const { theta, phi = 0, psi = 0 } = setup.values;
  if (theta !== undefined) return { theta, phi, psi };
  const [L1, L2, L3] = omega.map((w, k) => w * moments[k]);
  // The last row of R = Rz(φ) Ry(θ) Rz(ψ) is ẑ in the body: (−sin θ cos ψ, sin θ sin ψ, cos θ).
  return { theta: Math.atan2(Math.hypot(L1, L2), L3), phi: 0, psi: Math.atan2(L2, -L1) };
}

/**
 * @param {readonly [number, number, number]} moments
 * @param {number} M
 * @param {number} g
 * @param {readonly [number, number, number]} arm
 * @param {string} unit of the moments
 */
function checkBody(moments, M, g, arm, unit) {
  const numbers = [...moments, M, g, ...arm];
  if (!numbers.every(Number.isFinite)) throw new Error("a body wants numbers that are finite");
  if (!(Math.min(...moments, M) > 0)) throw new Error("moments of inertia and M must be positive");
  if (g < 0) throw new Error("g must not be negative");
  const [x, y, z] = arm;
  const [l1, l2, l3] = moments;
  if (x === 0 && y === 0 && l1 === l2) {
    const least = M * z * z + l3 / 2;
    if (l1 < least - TOLERANCE * l1) {
      throw new Error(
        `λ₁ = ${short(l1)}${unit} is too small for λ₃ = ${short(l3)}${unit}: it must be at least ` +
          `${z === 0 ? "λ₃/2" : "MR² + λ₃/2"} = ${short(least)}${unit}`,
      );
    }
    return;
  }
  // Twice the second moments of the mass about its centre: no body has a negative one.
  const sum = l1 + l2 + l3;
  const second = moments.map((l, k) => sum - 2 * l - 2 * M * arm[k] * arm[k]);
  const slack = -TOLERANCE * Math.max(...moments);
  const mixed = [x * y, y * z, z * x].map((product) => -2 * M * product);
  const [a, b, c] = second;
  const [ab, bc, ca] = mixed;
  const determinant = a * (b * c - bc * bc) - ab * (ab * c - bc * ca) + ca * (ab * bc - b * ca);
  const size = Math.max(...moments);
  const positive =
    Math.min(a, b, c) >= slack &&
    Math.min(a * b - ab * ab, b * c - bc * bc, a * c - ca * ca) >= slack * size &&
    determinant >= slack * size * size;
  if (positive) return;
  const largest = moments.indexOf(size);
  const rest = sum - size;
  if (x === 0 && y === 0 && z === 0) {
    throw new Error(
      `λ${"₁₂₃"[largest]} = ${short(size)}${unit} exceeds the sum of the other two moments, ` +
        `${short(rest)}${unit}: no body has such moments`,
    );
  }
  throw new Error(
    "about the centre of mass the largest moment would exceed the sum of the other two: larger " +
      "moments about the pivot or a nearer centre of mass",
  );
}

const short = (/** @type {number} */ x) => String(Number(x.toPrecision(4)));

/**
 * The motion of a setup; throws an Error with one sentence where there is no such body.
 *
 * @param {Setup} setup
 * @param {Tableau} tableau
 * @param {number} [pace] The timescale of another motion, at whose times it is sampled.
 * @returns {Motion}
 */
export function createMotion(setup, tableau, pace) {
  const initial = startOf(setup);
  const { moments, M, g, arm, friction } = initial;
  const weight = arm.map((r) => M * g * r);
  const symmetric =
    moments[0] === moments[1] && weight[0] === 0 && weight[1] === 0 && friction === 0;
  const spin = symmetric ? initial.omega[2] : 0;
  const [lambda1, lambda2, lambda3] = moments;
  const rates = symmetric
    ? heavyTop(lambda1, lambda3, M, g, arm[2], spin)
    : friction > 0
      ? dampedBody(lambda1, lambda2, lambda3, M, g, arm[0], arm[1], arm[2], friction)
      : heavyBody(lambda1, lambda2, lambda3, M, g, arm[0], arm[1], arm[2]);
  const nothing = friction > 0 ? [0] : [];
  const beginning = [...initial.q, ...initial.omega.slice(0, symmetric ? 2 : 3), ...nothing];
  const turning =
    Math.hypot(...initial.omega) + Math.sqrt(Math.hypot(...weight) / Math.min(...moments));
  const timescale = pace ?? (turning > 0 ? 1 / turning : 1);
  /**
   * φ and ψ (without ω₃t) at the time t, continued from where they are known.
   *
   * @param {(t: number) => Float64Array} look
   * @param {Angles} known
   * @param {number} t
   * @returns {Angles}
   */
  const angles = (look, known, t, looks = LOOKS) => {
    const state = look(t);
    const sum = Math.atan2(state[3], state[0]);
    const difference = Math.atan2(-state[1], state[2]);
    const upright = state[1] === 0 && state[2] === 0;
    const hanging = state[0] === 0 && state[3] === 0;
    // At a pole only one of the two says anything; φ stays what it was.
    let phi = upright || hanging ? known.phi : nearest(sum + difference, known.phi);
    if (Math.abs(phi - known.phi) > LARGE_TURN && looks > 0) {
      const middle = angles(look, known, (known.t + t) / 2, looks - 1);
      return angles(look, middle, t, looks - 1);
    }
    // An axis that goes through a pole itself turns its azimuth by half a turn, either way.
    const turned = phi - known.phi;
    if (Math.abs(turned) > LARGE_TURN) {
      const otherWay = phi - 2 * Math.PI * Math.sign(turned);
      if (Math.abs(otherWay - initial.phi) < Math.abs(phi - initial.phi)) phi = otherWay;
    }
    let psi = nearest(sum - difference, known.psi);
    if (upright) psi = nearest(2 * sum - phi, known.psi);
    if (hanging) psi = nearest(phi - 2 * difference, known.psi);
    return { t, phi, psi };
  };

  const sampleAt = (
    /** @type {(t: number) => Float64Array} */ look, /** @type {number} */ t,
    /** @type {Sample | null} */ before,
  ) => {
    const from = before ?? { t: 0, phi: initial.phi, psi: initial.psi };
    const known = { t: from.t, phi: from.phi, psi: from.psi - spin * from.t };
    const { phi, psi } = angles(look, known, t);
    const state = look(t);
    const norm = Math.hypot(state[0], state[1], state[2], state[3]);
    let [q0, q1, q2, q3] = [state[0] / norm, state[1] / norm, state[2] / norm, state[3] / norm];
    let [omega1, omega2, omega3] = [state[4], state[5], symmetric ? spin : state[6]];
    const theta = 2 * Math.atan2(Math.hypot(q1, q2), Math.hypot(q0, q3));
    if (symmetric) {
      const half = (spin * t) / 2;
      const [c, s] = [Math.cos(half), Math.sin(half)];
      [q0, q1, q2, q3] = [q0 * c - q3 * s, q1 * c + q2 * s, q2 * c - q1 * s, q3 * c + q0 * s];
      const [cos, sin] = [c * c - s * s, 2 * s * c];
      [omega1, omega2] = [omega1 * cos + omega2 * sin, omega2 * cos - omega1 * sin];
    }
    const psiNow = psi + spin * t;
    const body = { lambda1, lambda2, lambda3, M, g, R1: arm[0], R2: arm[1], R3: arm[2] };
    const all = { q0, q1, q2, q3, omega1, omega2, omega3, ...body };
    const R = attitudeMatrix(all);
    const momentum = angularMomentum(all);
    const omega = [omega1, omega2, omega3];
    const [theta_dot, phi_dot, psi_dot] =
      R[2] === 0 && R[5] === 0
        ? [Math.hypot(omega1, omega2), NaN, NaN]
        : eulerRates({ theta, psi: psiNow, omega1, omega2, omega3 });
    return {
      t,
      state,
      q: [q0, q1, q2, q3],
      rotation: R,
      omega,
      omegaSpace: [0, 3, 6].map((k) => R[k] * omega1 + R[k + 1] * omega2 + R[k + 2] * omega3),
      momentum,
      torque: gravityTorque(all),
      e3: [R[2], R[5], R[8]],
      theta,
      phi,
      psi: psiNow,
      theta_dot,
      phi_dot,
      psi_dot,
      energy: energy(all),
      taken: friction > 0 ? state[7] : 0,
      p_phi: momentum[2],
      p_psi: lambda3 * omega3,
    };
  };

  const kinetic = (/** @type {number} */ count) =>
    moments.slice(0, count).reduce((sum, l, k) => sum + (l * initial.omega[k] ** 2) / 2, 0);
  const potential = Math.hypot(...weight);
  // Without the energy of a spin that is constant, beside which every error would look small.
  const changing = symmetric ? kinetic(2) + potential : 0;
  const energyScale = changing || kinetic(3) + potential || 1;
  const momentumScale =
    Math.sqrt(2 * Math.max(...moments)) * Math.sqrt(kinetic(3) + potential) || 1;
  const kept = /** @type {Drift["name"][]} */ (
    friction > 0 ? ["E + W"]
      : weight.every((w) => w === 0) ? ["E", "L"] : symmetric ? ["E", "p_phi", "p_psi"] : ["E", "p_phi"]
  );
  const most = kept.map(() => 0);
  const strayed = (/** @type {Sample} */ sample) =>
    kept.map((name) => {
      if (name === "E" || name === "E + W") {
        return Math.abs(sample.energy + sample.taken - start.energy) / energyScale;
      }
      if (name === "p_phi") return Math.abs(sample.p_phi - start.p_phi) / momentumScale;
      if (name === "p_psi") return Math.abs(sample.p_psi - start.p_psi) / momentumScale;
      return distance(sample.momentum, start.momentum) / momentumScale;
    });
  const moving = createMoving(beginning, timescale / PER_RADIAN, {
    solverAt: (from, t) => createSolver(tableau, rates, from, t, timescale / 8, ACCURACY),
    sampleAt,
    check: (sample) => strayed(sample).forEach((drift, k) => {
      most[k] = Math.max(most[k], drift);
    }),
    forget: () => most.fill(0),
  });
  const { ahead } = moving;
  const start = /** @type {Sample} */ (moving.start);
  return Object.assign(moving, {
    setup,
    moments,
    arm,
    weight,
    symmetric,
    timescale,
    ahead: (/** @type {number} */ duration, /** @type {number} */ count) =>
      ahead(Math.min(duration, FARTHEST_AHEAD * timescale), count),
    drift: () =>
      strayed(moving.now).map((drift, k) => ({
        name: kept[k],
        now: drift,
        most: most[k],
        exact: kept[k] === "p_psi",
      })),
  });
}

/**
 * The numbers that the functions of `equations.js` take, by SymPy's names.
 *
 * @returns {Record<string, number>}
 */
export function quantities(/** @type {Sample} */ sample, /** @type {Motion} */ motion) {
  const { M = 1, g = 0, R1 = 0, R2 = 0, R = 0, friction = 0 } = motion.setup.values;
  const [lambda1, lambda2, lambda3] = Array.from(motion.moments);
  const [omega1, omega2, omega3] = Array.from(sample.omega);
  const [q0, q1, q2, q3] = Array.from(sample.q);
  const { theta, phi, psi, p_phi, p_psi } = sample;
  const rates = { thetadot: sample.theta_dot, phidot: sample.phi_dot, psidot: sample.psi_dot };
  const body = { lambda1, lambda2, lambda3, M, g, R, R1, R2, R3: R, friction };
  const state = { omega1, omega2, omega3, q0, q1, q2, q3, theta, phi, psi, p_phi, p_psi };
  return { ...body, ...state, ...rates };
}

/**
 * Where φ and ψ (without ω₃t) are known.
 *
 * @typedef {{ t: number, phi: number, psi: number }} Angles
 */

/** Between two vectors. */
function distance(/** @type {Numbers} */ a, /** @type {Numbers} */ b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** The angle that differs from `angle` by whole turns and is nearest to `to`. */
function nearest(/** @type {number} */ angle, /** @type {number} */ to) {
  return angle - 2 * Math.PI * Math.round((angle - to) / (2 * Math.PI));
}
