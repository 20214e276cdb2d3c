/** The ghost: the same body beside itself, with one setting changed. */

/** @typedef {(values: Values, facts: Facts) => Record<string, number> | null} Change */

/** @type {(name: string, factor: number) => Change} */
const times = (name, factor) => (values) => ({ [name]: factor * values[name] });

/** Of the two steady rates the one that is farther from φ̇₀. */
/** @type {Change} */
const otherRate = ({ phi_dot: now }, { steady }) => {
  if (!steady) return null;
  const [slow, fast] = steady;
  return { theta_dot: 0, phi_dot: Math.abs(slow - now) < Math.abs(fast - now) ? fast : slow };
};

/** @type {Change} */
const nudged = ({ omega1, omega2, omega3 }) => ({
  omega1: omega1 + Math.hypot(omega1, omega2, omega3) / 100,
});

/** @type {readonly (readonly [string, string, Kind | null, Change])[]} */
const CHANGES = [
  ["other", "the other Ω±", "heavy-top", otherRate],
  ["spin", "ω₃ − 5 %", "heavy-top", times("omega3", 0.95)],
  ["nudge", "ω₁ + ω/100", "free", nudged],
  ["larger", "λ₂ + 1 %", null, times("lambda2", 1.01)],
  ["smaller", "λ₂ − 1 %", null, times("lambda2", 0.99)],
];

/**
 * The ghosts of a page, by their names in the address, with words.
 *
 * @returns {Choices}
 */
export function ghostsOf(/** @type {Kind} */ kind) {
  return CHANGES.filter(([, , of]) => of === null || of === kind).map(([name, words]) =>
    [name, words]);
}

/**
 * The values of a ghost; null where there is none, as of a rate that does not exist.
 *
 * @returns {Record<string, number> | null}
 */
export function ghostValues(
  /** @type {string} */ ghost, /** @type {Values} */ values, /** @type {Facts} */ facts,
) {
  const change = CHANGES.find(([name]) => name === ghost)?.[3](values, facts) ?? null;
  return change && { ...values, ...change };
}

/**
 * How far two bodies are apart, in radians: the angle between the axes e₃ of heavy ones, and of
 * free ones that of the turn from one attitude to the other.
 *
 * @returns {(one: Sample, other: Sample) => number}
 */
export function apart(/** @type {Kind} */ kind) {
  if (kind === "heavy-top") return (one, other) => angleBetween(one.e3, other.e3);
  return ({ q: a }, { q: b }) => {
    // Of the quaternions ±q that mean the same attitude, the nearer one.
    const [sum, difference] = [1, -1].map((sign) =>
      Math.hypot(...Array.from(a, (x, k) => x + sign * b[k])));
    return 4 * Math.atan2(Math.min(sum, difference), Math.max(sum, difference));
  };
}

/** Between two unit vectors. */
function angleBetween(/** @type {Numbers} */ a, /** @type {Numbers} */ b) {
  const [sum, difference] = [1, -1].map((sign) =>
    Math.hypot(a[0] + sign * b[0], a[1] + sign * b[1], a[2] + sign * b[2]));
  return 2 * Math.atan2(difference, sum);
}
