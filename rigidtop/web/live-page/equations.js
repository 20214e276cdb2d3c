// Right-hand sides, momenta, energies and bounds of rigid-body motion, as derived.
//
// Written by `python -m rigidtop.web` from `rigidtop.theory`: do not edit.
//
// λ₁, λ₂, λ₃ are the moments of inertia about the pivot (of a free body, about its centre of mass),
// q₀ … q₃ is the unit quaternion, scalar first, that takes body components to space components, and
// ω₁, ω₂, ω₃ are components in the body frame.  SI units and radians.

/**
 * q̇₀ … q̇₃, ω̇₁, ω̇₂ of the symmetric top, in the frame that does not turn about e₃.
 *
 * The state is (q0, q1, q2, q3, omega1, omega2).
 *
 * @param {number} lambda1
 * @param {number} lambda3
 * @param {number} M
 * @param {number} g
 * @param {number} R
 * @param {number} omega3
 * @returns {(state: ArrayLike<number>, rates: Float64Array) => void}
 */
export function heavyTop(lambda1, lambda3, M, g, R, omega3) {
  const c0 = lambda3*omega3/lambda1;
  const c1 = 2*M*R*g/lambda1;
  return (state, rates) => {
    const q0 = state[0];
    const q1 = state[1];
    const q2 = state[2];
    const q3 = state[3];
    const omega1 = state[4];
    const omega2 = state[5];
    const x0 = omega1/2;
    const x1 = omega2/2;
    rates[0] = -q1*x0 - q2*x1;
    rates[1] = q0*x0 - q3*x1;
    rates[2] = q0*x1 + q3*x0;
    rates[3] = omega2*q1/2 - q2*x0;
    rates[4] = -c0*omega2 + c1*(q0*q1 + q2*q3);
    rates[5] = c0*omega1 + c1*(q0*q2 - q1*q3);
  };
}

/**
 * q̇₀ … q̇₃, ω̇₁, ω̇₂, ω̇₃ of a heavy body about a pivot, centre of mass anywhere in it.
 *
 * The state is (q0, q1, q2, q3, omega1, omega2, omega3).
 *
 * @param {number} lambda1
 * @param {number} lambda2
 * @param {number} lambda3
 * @param {number} M
 * @param {number} g
 * @param {number} R1
 * @param {number} R2
 * @param {number} R3
 * @returns {(state: ArrayLike<number>, rates: Float64Array) => void}
 */
export function heavyBody(lambda1, lambda2, lambda3, M, g, R1, R2, R3) {
  const c0 = (lambda2 - lambda3)/lambda1;
  const c1 = M*R2*g/lambda1;
  const c2 = 2*M*R3*g/lambda1;
  const c3 = M*R1*g/lambda2;
  const c4 = (lambda1 - lambda3)/lambda2;
  const c5 = 2*M*R3*g/lambda2;
  const c6 = (lambda1 - lambda2)/lambda3;
  const c7 = 2*M*R1*g/lambda3;
  const c8 = 2*M*R2*g/lambda3;
  return (state, rates) => {
    const q0 = state[0];
    const q1 = state[1];
    const q2 = state[2];
    const q3 = state[3];
    const omega1 = state[4];
    const omega2 = state[5];
    const omega3 = state[6];
    const x0 = omega1/2;
    const x1 = q2/2;
    const x2 = q3/2;
    const x3 = omega2/2;
    const x4 = omega3/2;
    const x5 = q0*q1 + q2*q3;
    const x6 = 2*q1*q1 + 2*q2*q2 - 1;
    const x7 = q0*q2 - q1*q3;
    rates[0] = -omega2*x1 - omega3*x2 - q1*x0;
    rates[1] = -omega2*x2 + omega3*x1 + q0*x0;
    rates[2] = q0*x3 - q1*x4 + q3*x0;
    rates[3] = q0*x4 + q1*x3 - q2*x0;
    rates[4] = c0*omega2*omega3 + c1*x6 + c2*x5;
    rates[5] = -c3*x6 - c4*omega1*omega3 + c5*x7;
    rates[6] = c6*omega1*omega2 - c7*x5 - c8*x7;
  };
}

/**
 * q̇₀ … q̇₃, ω̇₁, ω̇₂, ω̇₃ of a heavy body with friction −cω at its pivot, and what that takes.
 *
 * The state is (q0, q1, q2, q3, omega1, omega2, omega3, taken).
 *
 * @param {number} lambda1
 * @param {number} lambda2
 * @param {number} lambda3
 * @param {number} M
 * @param {number} g
 * @param {number} R1
 * @param {number} R2
 * @param {number} R3
 * @param {number} friction
 * @returns {(state: ArrayLike<number>, rates: Float64Array) => void}
 */
export function dampedBody(lambda1, lambda2, lambda3, M, g, R1, R2, R3, friction) {
  const c0 = friction/lambda1;
  const c1 = (lambda2 - lambda3)/lambda1;
  const c2 = M*R2*g/lambda1;
  const c3 = 2*M*R3*g/lambda1;
  const c4 = friction/lambda2;
  const c5 = M*R1*g/lambda2;
  const c6 = (lambda1 - lambda3)/lambda2;
  const c7 = 2*M*R3*g/lambda2;
  const c8 = friction/lambda3;
  const c9 = (lambda1 - lambda2)/lambda3;
  const c10 = 2*M*R1*g/lambda3;
  const c11 = 2*M*R2*g/lambda3;
  const c12 = friction;
  return (state, rates) => {
    const q0 = state[0];
    const q1 = state[1];
    const q2 = state[2];
    const q3 = state[3];
    const omega1 = state[4];
    const omega2 = state[5];
    const omega3 = state[6];
    const x0 = omega1/2;
    const x1 = q2/2;
    const x2 = q3/2;
    const x3 = omega2/2;
    const x4 = omega3/2;
    const x5 = q0*q1 + q2*q3;
    const x6 = 2*q1*q1 + 2*q2*q2 - 1;
    const x7 = q0*q2 - q1*q3;
    rates[0] = -omega2*x1 - omega3*x2 - q1*x0;
    rates[1] = -omega2*x2 + omega3*x1 + q0*x0;
    rates[2] = q0*x3 - q1*x4 + q3*x0;
    rates[3] = q0*x4 + q1*x3 - q2*x0;
    rates[4] = -c0*omega1 + c1*omega2*omega3 + c2*x6 + c3*x5;
    rates[5] = -c4*omega2 - c5*x6 - c6*omega1*omega3 + c7*x7;
    rates[6] = -c10*x5 - c11*x7 - c8*omega3 + c9*omega1*omega2;
    rates[7] = c12*(omega1*omega1 + omega2*omega2 + omega3*omega3);
  };
}

/**
 * R row by row, body to space.
 *
 * @param {{ q0: number, q1: number, q2: number, q3: number }} quantities
 */
export function attitudeMatrix({ q0, q1, q2, q3 }) {
  const x0 = 2*q2*q2;
  const x1 = 2*q3*q3 - 1;
  const x2 = 2*q0;
  const x3 = q3*x2;
  const x4 = q2*x2;
  const x5 = 2*q1;
  const x6 = 2*q1*q1;
  const x7 = q1*x2;
  return [
    -x0 - x1,
    2*q1*q2 - x3,
    q3*x5 + x4,
    q2*x5 + x3,
    -x1 - x6,
    2*q2*q3 - x7,
    2*q1*q3 - x4,
    2*q2*q3 + x7,
    -x0 - x6 + 1,
  ];
}

/**
 * The unit quaternion of R = Rz(φ) Ry(θ) Rz(ψ).
 *
 * @param {{ phi: number, psi: number, theta: number }} quantities
 */
export function quaternionOfAngles({ phi, psi, theta }) {
  const x0 = theta/2;
  const x1 = Math.cos(x0);
  const x2 = phi/2;
  const x3 = psi/2;
  const x4 = x2 + x3;
  const x5 = Math.sin(x0);
  const x6 = x2 - x3;
  return [
    x1*Math.cos(x4),
    -x5*Math.sin(x6),
    x5*Math.cos(x6),
    x1*Math.sin(x4),
  ];
}

/**
 * ω₁, ω₂, ω₃ from Euler angles and rates (3.41).
 *
 * @param {{ phidot: number, psi: number, psidot: number, theta: number, thetadot: number }}
 *   quantities
 */
export function omegaOfRates({ phidot, psi, psidot, theta, thetadot }) {
  const x0 = Math.sin(psi);
  const x1 = Math.cos(psi);
  const x2 = phidot*Math.sin(theta);
  return [
    thetadot*x0 - x1*x2,
    thetadot*x1 + x0*x2,
    phidot*Math.cos(theta) + psidot,
  ];
}

/**
 * θ̇, φ̇, ψ̇ from ω; not finite where sin θ = 0 (rad/s).
 *
 * @param {{ omega1: number, omega2: number, omega3: number, psi: number, theta: number }}
 *   quantities
 */
export function eulerRates({ omega1, omega2, omega3, psi, theta }) {
  const x0 = Math.sin(psi);
  const x1 = Math.cos(psi);
  const x2 = omega1*x1;
  const x3 = 1/Math.tan(theta);
  return [
    omega1*x0 + omega2*x1,
    (omega2*x0 - x2)/Math.sin(theta),
    -omega2*x0*x3 + omega3 + x2*x3,
  ];
}

/**
 * L in space components (J s).
 *
 * @param {{ lambda1: number, lambda2: number, lambda3: number, omega1: number, omega2: number,
 *   omega3: number, q0: number, q1: number, q2: number, q3: number }} quantities
 */
export function angularMomentum({ lambda1, lambda2, lambda3, omega1, omega2, omega3, q0, q1, q2,
    q3 }) {
  const x0 = 2*q0;
  const x1 = q3*x0;
  const x2 = lambda2*omega2;
  const x3 = q2*x0;
  const x4 = 2*q1;
  const x5 = lambda3*omega3;
  const x6 = 2*q2*q2;
  const x7 = 2*q3*q3 - 1;
  const x8 = lambda1*omega1;
  const x9 = q1*x0;
  const x10 = 2*q1*q1;
  return [
    x2*(2*q1*q2 - x1) + x5*(q3*x4 + x3) + x8*(-x6 - x7),
    x2*(-x10 - x7) + x5*(2*q2*q3 - x9) + x8*(q2*x4 + x1),
    x2*(2*q2*q3 + x9) + x5*(-x10 - x6 + 1) + x8*(2*q1*q3 - x3),
  ];
}

/**
 * R_CM × Mg in space components (N m).
 *
 * @param {{ M: number, R1: number, R2: number, R3: number, g: number, q0: number, q1: number, q2:
 *   number, q3: number }} quantities
 */
export function gravityTorque({ M, R1, R2, R3, g, q0, q1, q2, q3 }) {
  const x0 = 2*q0;
  const x1 = q3*x0;
  const x2 = 2*q3*q3 - 1;
  const x3 = M*g;
  return [
    -x3*(R1*(2*q1*q2 + x1) + R2*(-2*q1*q1 - x2) + R3*(-q1*x0 + 2*q2*q3)),
    x3*(R1*(-2*q2*q2 - x2) + R2*(2*q1*q2 - x1) + R3*(2*q1*q3 + q2*x0)),
    0,
  ];
}

/**
 * Kinetic and potential energy (J).
 *
 * @param {{ M: number, R1: number, R2: number, R3: number, g: number, lambda1: number, lambda2:
 *   number, lambda3: number, omega1: number, omega2: number, omega3: number, q0: number, q1:
 *   number, q2: number, q3: number }} quantities
 */
export function energy({ M, R1, R2, R3, g, lambda1, lambda2, lambda3, omega1, omega2, omega3, q0,
    q1, q2, q3 }) {
  const x0 = 2*q0;
  return M*g*(R1*(2*q1*q3 - q2*x0) + R2*(q1*x0 + 2*q2*q3) + R3*(-2*q1*q1 - 2*q2*q2 + 1)) + lambda1*
      omega1*omega1/2 + lambda2*omega2*omega2/2 + lambda3*omega3*omega3/2;
}

/**
 * (p_φ − p_ψ cos θ)²/(2λ₁ sin²θ) + p_ψ²/(2λ₃) + MgR cos θ of the symmetric top (J).
 *
 * @param {{ M: number, R: number, g: number, lambda1: number, lambda3: number, p_phi: number,
 *   p_psi: number, theta: number }} quantities
 */
export function effectivePotential({ M, R, g, lambda1, lambda3, p_phi, p_psi, theta }) {
  const x0 = Math.cos(theta);
  const x1 = Math.sin(theta);
  const x2 = p_phi - p_psi*x0;
  return M*R*g*x0 + p_psi*p_psi/(2*lambda3) + x2*x2/(2*lambda1*x1*x1);
}

/**
 * The smallest ω₃ > 0 with a steady precession at θ, where cos θ > 0 (rad/s).
 *
 * @param {{ M: number, R: number, g: number, lambda1: number, lambda3: number, theta: number }}
 *   quantities
 */
export function smallestSpin({ M, R, g, lambda1, lambda3, theta }) {
  return 2*Math.sqrt(M)*Math.sqrt(R)*Math.sqrt(g)*Math.sqrt(lambda1)*Math.sqrt(Math.cos(theta))/
      lambda3;
}

/**
 * Ω₋ and Ω₊, the roots of (3.57), for ω₃ > 0; not finite where there are none (rad/s).
 *
 * @param {{ M: number, R: number, g: number, lambda1: number, lambda3: number, omega3: number,
 *   theta: number }} quantities
 */
export function steadyRates({ M, R, g, lambda1, lambda3, omega3, theta }) {
  const x0 = Math.cos(theta);
  const x1 = M*R*g;
  const x2 = lambda3*omega3 + Math.sqrt(-4*lambda1*x0*x1 + lambda3*lambda3*omega3*omega3);
  return [
    2*x1/x2,
    x2/(2*lambda1*x0),
  ];
}

/**
 * Coefficients of u³, u², u and 1 in θ̇² sin²θ, where u = cos θ and E is the energy.
 *
 * @param {{ E: number, M: number, R: number, g: number, lambda1: number, lambda3: number, p_phi:
 *   number, p_psi: number }} quantities
 */
export function nutationCubic({ E, M, R, g, lambda1, lambda3, p_phi, p_psi }) {
  const x0 = M*R*g;
  const x1 = p_psi*p_psi;
  const x2 = 2*E*lambda1*lambda3;
  const x3 = lambda1*x1;
  const x4 = 1/(lambda1*lambda1);
  const x5 = x4/lambda3;
  return [
    2*x0/lambda1,
    x5*(-lambda3*x1 - x2 + x3),
    2*x4*(-lambda1*x0 + p_phi*p_psi),
    x5*(-lambda3*p_phi*p_phi + x2 - x3),
  ];
}

/**
 * Coefficients of u and 1 in φ̇ sin²θ, where u = cos θ.
 *
 * @param {{ lambda1: number, p_phi: number, p_psi: number }} quantities
 */
export function precessionNumerator({ lambda1, p_phi, p_psi }) {
  const x0 = 1/lambda1;
  return [
    -p_psi*x0,
    p_phi*x0,
  ];
}

/**
 * Ω_b of (3.37), for λ₂ = λ₁ (rad/s).
 *
 * @param {{ lambda1: number, lambda3: number, omega3: number }} quantities
 */
export function bodyConeRate({ lambda1, lambda3, omega3 }) {
  return omega3*(lambda1 - lambda3)/lambda1;
}

/**
 * 2T and L² (J, J² s²).
 *
 * @param {{ lambda1: number, lambda2: number, lambda3: number, omega1: number, omega2: number,
 *   omega3: number }} quantities
 */
export function firstIntegrals({ lambda1, lambda2, lambda3, omega1, omega2, omega3 }) {
  const x0 = omega1*omega1;
  const x1 = omega2*omega2;
  const x2 = omega3*omega3;
  return [
    lambda1*x0 + lambda2*x1 + lambda3*x2,
    lambda1*lambda1*x0 + lambda2*lambda2*x1 + lambda3*lambda3*x2,
  ];
}

/**
 * ω on the polhode round e₃, ω₃ > 0, with given 2T and L², at an angle on it (rad/s).
 *
 * @param {{ L_squared: number, angle: number, lambda1: number, lambda2: number, lambda3: number,
 *   twice_T: number }} quantities
 */
export function polhode({ L_squared, angle, lambda1, lambda2, lambda3, twice_T }) {
  const x0 = Math.cos(angle);
  const x1 = -L_squared + lambda3*twice_T;
  const x2 = -lambda3;
  const x3 = x1/(lambda1 + x2);
  const x4 = Math.sin(angle);
  const x5 = x1/(lambda2 + x2);
  const x6 = 1/lambda3;
  return [
    x0*Math.sqrt(-x3)/Math.sqrt(lambda1),
    x4*Math.sqrt(-x5)/Math.sqrt(lambda2),
    Math.sqrt(twice_T*x6 + x0*x0*x3*x6 + x4*x4*x5*x6),
  ];
}

/**
 * The terms of λ₁θ̈ = λ₁φ̇² sin θ cos θ − λ₃(ψ̇ + φ̇ cos θ)φ̇ sin θ + MgR sin θ.
 *
 * @param {{ M: number, R: number, g: number, lambda1: number, lambda3: number, phidot: number,
 *   psidot: number, theta: number }} quantities
 */
export function thetaTerms({ M, R, g, lambda1, lambda3, phidot, psidot, theta }) {
  const x0 = Math.sin(theta);
  const x1 = Math.cos(theta);
  const x2 = phidot*phidot*x0*x1;
  const x3 = 1/lambda1;
  const x4 = M*R*g*x0;
  const x5 = lambda3*phidot*x0*(phidot*x1 + psidot);
  return [
    lambda1*(x2 + x3*x4 - x3*x5),
    lambda1*x2,
    -x5,
    x4,
  ];
}

/**
 * The terms of p_φ = λ₁φ̇ sin² θ + λ₃(ψ̇ + φ̇ cos θ) cos θ = const.
 *
 * @param {{ lambda1: number, lambda3: number, p_phi: number, phidot: number, psidot: number, theta:
 *   number }} quantities
 */
export function pPhiTerms({ lambda1, lambda3, p_phi, phidot, psidot, theta }) {
  const x0 = Math.sin(theta);
  const x1 = Math.cos(theta);
  return [
    p_phi,
    lambda1*phidot*x0*x0,
    lambda3*x1*(phidot*x1 + psidot),
  ];
}

/**
 * The terms of p_ψ = λ₃(ψ̇ + φ̇ cos θ) = const.
 *
 * @param {{ lambda3: number, p_psi: number, phidot: number, psidot: number, theta: number }}
 *   quantities
 */
export function pPsiTerms({ lambda3, p_psi, phidot, psidot, theta }) {
  return [
    p_psi,
    lambda3*(phidot*Math.cos(theta) + psidot),
  ];
}

/**
 * The terms of λ₁ω̇₁ = (λ₂ − λ₃)ω₂ω₃ + N₁.
 *
 * @param {{ M: number, R2: number, R3: number, friction: number, g: number, lambda1: number,
 *   lambda2: number, lambda3: number, omega1: number, omega2: number, omega3: number, q0: number,
 *   q1: number, q2: number, q3: number }} quantities
 */
export function euler1({ M, R2, R3, friction, g, lambda1, lambda2, lambda3, omega1, omega2, omega3,
    q0, q1, q2, q3 }) {
  const x0 = 1/lambda1;
  const x1 = omega2*omega3*(lambda2 - lambda3);
  const x2 = -M*R2*g*(-2*q1*q1 - 2*q2*q2 + 1) + M*R3*g*(2*q0*q1 + 2*q2*q3) - friction*omega1;
  return [
    lambda1*(x0*x1 + x0*x2),
    x1,
    x2,
  ];
}

/**
 * The terms of λ₂ω̇₂ = (λ₃ − λ₁)ω₃ω₁ + N₂.
 *
 * @param {{ M: number, R1: number, R3: number, friction: number, g: number, lambda1: number,
 *   lambda2: number, lambda3: number, omega1: number, omega2: number, omega3: number, q0: number,
 *   q1: number, q2: number, q3: number }} quantities
 */
export function euler2({ M, R1, R3, friction, g, lambda1, lambda2, lambda3, omega1, omega2, omega3,
    q0, q1, q2, q3 }) {
  const x0 = 1/lambda2;
  const x1 = lambda1 - lambda3;
  const x2 = omega1*omega3;
  const x3 = M*R1*g*(-2*q1*q1 - 2*q2*q2 + 1) - M*R3*g*(-2*q0*q2 + 2*q1*q3) - friction*omega2;
  return [
    lambda2*(-x0*x1*x2 + x0*x3),
    -x1*x2,
    x3,
  ];
}

/**
 * The terms of λ₃ω̇₃ = (λ₁ − λ₂)ω₁ω₂ + N₃.
 *
 * @param {{ M: number, R1: number, R2: number, friction: number, g: number, lambda1: number,
 *   lambda2: number, lambda3: number, omega1: number, omega2: number, omega3: number, q0: number,
 *   q1: number, q2: number, q3: number }} quantities
 */
export function euler3({ M, R1, R2, friction, g, lambda1, lambda2, lambda3, omega1, omega2, omega3,
    q0, q1, q2, q3 }) {
  const x0 = 1/lambda3;
  const x1 = omega1*omega2*(lambda1 - lambda2);
  const x2 = 2*q0;
  const x3 = -M*R1*g*(q1*x2 + 2*q2*q3) + M*R2*g*(2*q1*q3 - q2*x2) - friction*omega3;
  return [
    lambda3*(x0*x1 + x0*x3),
    x1,
    x3,
  ];
}
