/** The module that Python writes from a system: each function fills `out`. */

type Function = (s: ArrayLike<number>, p: ArrayLike<number>, out: Float64Array) => void;

/** What the state changes by. */
export const rates: Function;
/** x, y, z of each point, then the attitudes of bodies, row by row. */
export const points: Function;
/** Jacobi's integral, then of all that is kept the value and the size of its terms. */
export const measures: Function;
