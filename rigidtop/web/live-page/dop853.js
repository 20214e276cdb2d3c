// Dormand and Prince's method of order 8 with dense output of order 7, as in Hairer, Nørsett and
// Wanner, "Solving Ordinary Differential Equations I", II.5 and II.6, with SciPy's coefficients and
// step control.  The tableau comes from Python: `scipy.integrate.DOP853`.

const SAFETY = 0.9;
const LEAST_FACTOR = 0.2;
const MOST_FACTOR = 10;
const EXPONENT = -1 / 8;

/**
 * A solver of ẋ = rates(x) from `start` at the time t on; `h` is the first step to try, negative
 * to go back.  A step is as long as the errors allow: rtol |x| + atol for each component.
 *
 * @returns {Solver}
 */
export function createSolver(
  /** @type {Tableau} */ tableau,
  /** @type {(state: ArrayLike<number>, rates: Float64Array) => void} */ rates,
  /** @type {ArrayLike<number>} */ start, /** @type {number} */ t, /** @type {number} */ h,
  /** @type {{ rtol: number, atol: number }} */ { rtol, atol },
) {
  const { A, B, E3, E5, D, A_EXTRA } = tableau;
  const n = start.length;
  const stages = B.length;
  const vector = () => new Float64Array(n);
  const K = Array.from({ length: stages + 1 + A_EXTRA.length }, vector);
  const weights = D.length + 3;
  const F = Array.from({ length: weights }, vector);
  let from = Float64Array.from(start);
  let to = Float64Array.from(start);
  const trial = vector();
  let dense = false;
  rates(from, K[stages]);

  /** trial = from + h Σ weights[j] K[j] */
  const move = (/** @type {readonly number[]} */ row, /** @type {number} */ count) => {
    trial.fill(0);
    for (let j = 0; j < count; j++) {
      if (row[j] === 0) continue;
      for (let i = 0; i < n; i++) trial[i] += row[j] * K[j][i];
    }
    for (let i = 0; i < n; i++) trial[i] = from[i] + solver.h * trial[i];
  };

  /** Of the last trial, 1 where it is just good enough. */
  const error = () => {
    let third = 0;
    let fifth = 0;
    for (let i = 0; i < n; i++) {
      const scale = atol + rtol * Math.max(Math.abs(from[i]), Math.abs(to[i]));
      let e3 = 0;
      let e5 = 0;
      for (let j = 0; j <= stages; j++) {
        e3 += E3[j] * K[j][i];
        e5 += E5[j] * K[j][i];
      }
      third += (e3 / scale) ** 2;
      fifth += (e5 / scale) ** 2;
    }
    if (third === 0 && fifth === 0) return 0;
    return (Math.abs(solver.h) * fifth) / Math.sqrt((fifth + 0.01 * third) * n);
  };

  const step = () => {
    [from, to] = [to, from];
    K[0].set(K[stages]);
    let most = MOST_FACTOR;
    for (;;) {
      for (let s = 1; s < stages; s++) {
        move(A[s], s);
        rates(trial, K[s]);
      }
      move(B, stages);
      to.set(trial);
      rates(to, K[stages]);
      const size = error();
      if (size < 1) {
        solver.before = solver.t;
        solver.t += solver.h;
        taken = solver.h;
        solver.h *= size === 0 ? most : Math.min(most, SAFETY * size ** EXPONENT);
        dense = false;
        return;
      }
      if (!(Math.abs(solver.h) > 1e-14 * Math.abs(solver.t))) {
        throw new Error(`the integration is stuck at t = ${solver.t}`);
      }
      // What overflows has no error that could be compared.
      const factor = Number.isFinite(size) ? SAFETY * size ** EXPONENT : 0;
      solver.h *= Math.max(LEAST_FACTOR, factor);
      most = 1;
    }
  };

  /** The coefficients of the polynomial of the last step. */
  const prepare = () => {
    const h = solver.h;
    solver.h = taken;
    for (let s = 0; s < A_EXTRA.length; s++) {
      move(A_EXTRA[s], stages + 1 + s);
      rates(trial, K[stages + 1 + s]);
    }
    solver.h = h;
    for (let i = 0; i < n; i++) {
      const change = to[i] - from[i];
      F[0][i] = change;
      F[1][i] = taken * K[0][i] - change;
      F[2][i] = 2 * change - taken * (K[stages][i] + K[0][i]);
      for (let row = 0; row < D.length; row++) {
        let sum = 0;
        for (let j = 0; j < K.length; j++) sum += D[row][j] * K[j][i];
        F[3 + row][i] = taken * sum;
      }
    }
    dense = true;
  };

  const at = (/** @type {number} */ time, /** @type {Float64Array} */ state) => {
    if (solver.before === solver.t || time === solver.t) {
      state.set(to);
      return;
    }
    if (!dense) prepare();
    const x = (time - solver.before) / taken;
    state.fill(0);
    for (let row = weights - 1; row >= 0; row--) {
      const factor = (weights - 1 - row) % 2 === 0 ? x : 1 - x;
      for (let i = 0; i < n; i++) state[i] = (state[i] + F[row][i]) * factor;
    }
    for (let i = 0; i < n; i++) state[i] += from[i];
  };

  let taken = h;
  const solver = { t, before: t, h, step, at };
  return solver;
}
