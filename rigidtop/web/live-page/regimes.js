/** Which start makes which motion: the plane of φ̇₀ and ω₃ of a symmetric top let go at θ₀. */

import {
  effectivePotential,
  nutationCubic,
  pPhiTerms,
  pPsiTerms,
  precessionNumerator,
} from "./equations.js";

/**
 * How much of the other end of the swing goes backwards: above 0 for waves, below for loops, 0 for
 * cusps, as a part of what φ̇ sin²θ is there at most.
 *
 * θ rests at the start, so that cos θ₀ is one root of the cubic; dividing it out leaves a
 * quadratic, whose one root between −1 and 1 is the other end.
 */
export function backwards(
  /** @type {Top} */ top, /** @type {number} */ theta, /** @type {number} */ phidot,
  /** @type {number} */ omega3,
) {
  const u = Math.cos(theta);
  const { lambda1, lambda3 } = top;
  const rates = { phidot, psidot: omega3 - phidot * u, theta };
  const [, lean, spin] = pPhiTerms({ lambda1, lambda3, p_phi: 0, ...rates });
  const [, p_psi] = pPsiTerms({ lambda3, p_psi: 0, ...rates });
  const momenta = { p_phi: lean + spin, p_psi };
  const E = effectivePotential({ ...top, ...momenta, theta });
  const [c3, c2, c1] = nutationCubic({ ...top, ...momenta, E });
  const [b, a] = precessionNumerator({ lambda1, ...momenta });
  const end = otherEnd(c3, c2 + c3 * u, c1 + (c2 + c3 * u) * u);
  const [here, there] = [a + b * u, a + b * end];
  const size = Math.abs(here) * Math.abs(there) || 1;
  return (here * there) / size;
}

/** The one root of a quadratic between −1 and 1; the nearer end if rounding hides it. */
function otherEnd(
  /** @type {number} */ a, /** @type {number} */ b, /** @type {number} */ c,
) {
  // (u − u₁)(u − u₃) with u₁ inside and u₃ ≥ 1.
  const root = Math.sqrt(Math.max(0, b * b - 4 * a * c));
  const far = b > 0 ? -b - root : -b + root;
  const roots = a === 0 ? [-c / b] : [(2 * c) / far, far / (2 * a)];
  const inside = roots.filter((u) => u >= -1 - 1e-9 && u <= 1 + 1e-9);
  return Math.min(1, Math.max(-1, inside.length > 0 ? Math.min(...inside) : 1));
}
