/** What is plotted of a top or a free body: its panels, and how much of time they show. */

import { decimal, nice, significant } from "./axes.js";
import { factsOf } from "./facts.js";
import { apart } from "./ghost.js";
import { fitted, UNIT } from "./time_plots.js";

/** The plots of a page, by their names in the address; the first is shown at first. */
const PLOTS = /** @type {const} */ ({
  "heavy-top": [["angles", "θ, φ"], ["path", "θ(φ)"],
    ["phase", "θ̇(θ)"], ["energy", "T, V, E"]],
  free: [["rates", "ω₁,₂,₃"], ["angles", "θ, φ"], ["path", "θ(φ)"]],
});

/** @returns {Choices} */
export function plotsOf(/** @type {Exclude<Kind, "system">} */ kind) {
  return PLOTS[kind];
}

const DEGREE = 180 / Math.PI;

/** The slowest motion that the window of time is made for, in times of the motion. */
const SLOWEST = 40;

/** At least so many nutations fill the window of time, unless they are this much slower. */
const NUTATIONS = 1.8;
const MUCH_SLOWER = 5;

/** @type {Quantity} */
const theta = (sample) => sample.theta * DEGREE;
/** @type {Quantity} */
const phi = (sample) => sample.phi * DEGREE;

/**
 * The panels of a motion, one above the other.
 *
 * @returns {Graph<Sample>[]}
 */
function panelsOf(/** @type {Motion} */ motion, /** @type {string} */ plot) {
  const { clock } = motion.setup;
  const usual = { guides: [], range: UNIT, expected: null };
  if (plot === "rates") {
    const rates = /** @type {const} */ (["e1", "e2", "e3"]).map((name, k) =>
      /** @type {const} */ ([(/** @type {Sample} */ sample) => sample.omega[k], name]));
    const now = (/** @type {Sample} */ { omega }) =>
      Array.from(omega, (w, k) => `ω_${k + 1} = ${decimal(w, 2)}`).join("  ");
    return [{ ...usual, title: `ω in rad/${clock}`, curves: rates, follow: around, guides: [0],
      now }];
  }
  if (plot === "energy") {
    const { weight } = motion;
    /** @type {Quantity} */
    const height = ({ rotation: R }) => R[6] * weight[0] + R[7] * weight[1] + R[8] * weight[2];
    const parts = /** @type {const} */ ([
      ["T", (/** @type {Sample} */ sample) => sample.energy - height(sample), "omega"],
      ["V", height, "torque"],
      ["E", (/** @type {Sample} */ sample) => sample.energy, "ink"],
    ]);
    return parts.map(([name, of, colour]) => ({
      ...usual,
      title: `${name} in J`,
      curves: [[of, colour]],
      follow: (old, seen) => fitted(old, seen, -Infinity, Infinity),
      now: (sample) => `${name} = ${significant(of(sample))}`,
    }));
  }
  if (plot === "phase") {
    return [
      { ...usual, title: `θ̇ in rad/${clock}`, curves: [[({ theta_dot: rate }) => rate, "e3"]],
        follow: around, now: ({ theta_dot: rate }) => `θ̇ = ${decimal(rate, 2)}` },
      { ...usual, title: "θ in °", curves: [[theta, "e3"]],
        follow: (old, seen) => fitted(old, seen, 0, 180),
        now: (sample) => `θ = ${decimal(theta(sample), 2)}°` },
    ];
  }
  const guides = (factsOf(motion).turningPoints ?? []).map((angle) => angle * DEGREE);
  return [
    {
      ...usual,
      title: "θ in °",
      curves: [[theta, "e3"]],
      follow: (old, seen) => fitted(old, seen, 0, 180),
      guides,
      now: (sample) => `θ = ${decimal(theta(sample), 2)}°`,
      range: { low: 0, high: 180 },
    },
    {
      ...usual,
      title: "φ in °",
      curves: [[phi, "e3"]],
      follow: followed,
      now: (sample) => `φ = ${decimal(phi(sample), 1)}°`,
    },
  ];
}

/** @returns {Plotted<Sample>} */
export function plottedOf(/** @type {Motion} */ motion, /** @type {string} */ plot) {
  const { clock, kind } = motion.setup;
  return {
    panels: panelsOf(motion, plot),
    across: plot === "path" ? "down" : plot === "phase" ? "up" : "",
    clock,
    duration: windowOf(motion),
    apart: apart(kind),
  };
}

/**
 * How much of time to show: some periods of what e₃ does, which may be slower than the body spins.
 */
function windowOf(/** @type {Motion} */ motion) {
  const { setup, moments, weight, start, timescale } = motion;
  if (setup.kind === "free") return nice(30 * timescale);
  const rate = length(start.momentum) / moments[0] + Math.sqrt(length(weight) / moments[0]);
  // What moves so slowly that it can't be computed ahead is shown as if it rested.
  const most = 30 * SLOWEST * timescale;
  const usual = Math.min(30 * Math.max(timescale, 1 / rate), most);
  const { regime, nutationPeriod = Infinity } = factsOf(motion);
  const nutates = Number.isFinite(nutationPeriod) && regime !== "steady precession";
  return nice(nutates ? Math.min(NUTATIONS * nutationPeriod, MUCH_SLOWER * usual, most) : usual);
}

function length(/** @type {Numbers} */ vector) {
  return Math.hypot(vector[0], vector[1], vector[2]);
}

/** The range of an axis of rates around zero; the old one as long as it serves. */
function around(/** @type {Span} */ old, /** @type {Span} */ seen) {
  const size = Math.max(-seen.low, seen.high) || 1;
  if (old.low === -old.high && size <= old.high && old.high < 2.6 * size) return old;
  const high = nice(size / 4) * Math.ceil((1.05 * size) / nice(size / 4));
  return { low: -high, high };
}

/** The range of an axis of φ, which `seen` pushes up or down, and widens where it is too small. */
function followed(/** @type {Span} */ old, /** @type {Span} */ seen) {
  const size = Math.max(1, seen.high - seen.low);
  const oldSpan = old.high - old.low;
  const kept = 1.04 * size < oldSpan && oldSpan < 4 * size;
  const step = nice(size / 8);
  const span = kept ? oldSpan : Math.ceil((1.1 * size) / step) * step;
  const margin = 0.02 * span;
  const low = Math.min(Math.max(old.low, seen.high + margin - span), seen.low - margin);
  return { low, high: low + span };
}

/** Rows of the table. */
const ROWS = 1001;

/**
 * The columns of the table: their names as the Python package has them, with units.
 *
 * @type {readonly (readonly [string, (sample: Sample) => number])[]}
 */
const COLUMNS = [
  ["t", (s) => s.t],
  ["theta (rad)", (s) => s.theta],
  ["phi (rad)", (s) => s.phi],
  ["psi (rad)", (s) => s.psi],
  ["theta_dot", (s) => s.theta_dot],
  ["phi_dot", (s) => s.phi_dot],
  ["psi_dot", (s) => s.psi_dot],
  ["omega1", (s) => s.omega[0]],
  ["omega2", (s) => s.omega[1]],
  ["omega3", (s) => s.omega[2]],
  ["e3_x", (s) => s.e3[0]],
  ["e3_y", (s) => s.e3[1]],
  ["e3_z", (s) => s.e3[2]],
  ["energy (J)", (s) => s.energy],
];

/** The motion from t = 0 as a table. */
export function tableOf(/** @type {Motion} */ motion, /** @type {number} */ duration) {
  const { clock } = motion.setup;
  const names = COLUMNS.map(([name]) => {
    if (name === "t") return `t (${clock})`;
    if (/dot|omega/.test(name)) return `${name} (rad/${clock})`;
    return clock === "s" ? name : name.replace("J", `1/${clock}²`);
  });
  const rows = motion.ahead(duration, ROWS).map((sample) => COLUMNS.map(([, of]) => of(sample)));
  return { names, rows };
}
