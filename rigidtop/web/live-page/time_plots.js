/** What goes on against time: θ and φ of a heavy body, the components of ω of a free one. */

import { atMostEvery, createPaper, decimal, drawAlongAxis, drawUpAxis, line, nice, scale,
  significant, withUnit, write } from "./axes.js";
import { drawCurve } from "./curves.js";
import { factsOf } from "./facts.js";

/** @typedef {import("./types").Colours} Colours */
/** @typedef {import("./types").Motion} Motion */
/** @typedef {import("./types").Sample} Sample */
/** @typedef {import("./axes.js").Box} Box */
/** @typedef {import("./axes.js").Paper} Paper */
/** @typedef {import("./axes.js").Range} Range */
/** @typedef {import("./curves.js").Quantity} Quantity */

/**
 * A panel: what is drawn in it, where its axis goes, and what stands above it.
 *
 * @typedef {object} Panel
 * @property {string} title
 * @property {readonly (readonly [Quantity, "e1" | "e2" | "e3"])[]} curves With their colours.
 * @property {(old: Range, seen: Range) => Range} follow
 * @property {readonly number[]} guides Dashed lines.
 * @property {(sample: Sample) => string} now
 * @property {Range} range
 * @property {Range | null} expected What is seen of it in the first window of time.
 */

const DEGREE = 180 / Math.PI;

/** The part of the window of time that fills before it scrolls. */
const FILLED = 0.9;

/** Plots are drawn at most this often, in milliseconds: half as often as the scene is enough. */
const EVERY = 28;

/** The slowest motion that the window of time is made for, in times of the motion. */
const SLOWEST = 40;

/** So many samples of the first window say how far the axes go. */
const LOOKS_AHEAD = 60;

/** @type {Quantity} */
const theta = (sample) => sample.theta * DEGREE;
/** @type {Quantity} */
const phi = (sample) => sample.phi * DEGREE;

/**
 * The panels of a motion, one above the other.
 *
 * @param {Motion} motion
 * @returns {Panel[]}
 */
function panelsOf(motion) {
  const range = { low: 0, high: 1 };
  if (motion.setup.kind === "free") {
    const { clock } = motion.setup;
    const rates = /** @type {const} */ (["e1", "e2", "e3"]).map((name, k) =>
      /** @type {const} */ ([(/** @type {Sample} */ sample) => sample.omega[k], name]));
    const now = (/** @type {Sample} */ { omega }) =>
      Array.from(omega, (w, k) => `ω_${k + 1} = ${decimal(w, 2)}`).join("  ");
    const title = `ω in rad/${clock}`;
    return [{ title, curves: rates, follow: around, guides: [0], now, range, expected: null }];
  }
  const guides = (factsOf(motion).turningPoints ?? []).map((angle) => angle * DEGREE);
  return [
    {
      title: "θ in °",
      curves: [[theta, "e3"]],
      follow: fitted,
      guides,
      now: (sample) => `θ = ${decimal(theta(sample), 2)}°`,
      range: { low: 0, high: 180 },
      expected: null,
    },
    {
      title: "φ in °",
      curves: [[phi, "e3"]],
      follow: followed,
      guides: [],
      now: (sample) => `φ = ${decimal(phi(sample), 1)}°`,
      range,
      expected: null,
    },
  ];
}

/**
 * @param {HTMLElement} container
 * @param {Colours} colours
 */
export function createTimePlots(container, colours) {
  /** @type {Motion | null} */
  let motion = null;
  /** @type {{sample: Sample, trail: readonly Sample[]} | null} */
  let last = null;
  /** @type {Panel[]} */
  let panels = [];
  let duration = 1;
  container.classList.add("time-plots");
  const paper = createPaper(container, redraw);
  const drawSoon = atMostEvery(EVERY, redraw);

  function redraw() {
    const sheet = motion && last && paper.clear();
    if (!motion || !last || !sheet) return;
    const { sample, trail } = last;
    const start = Math.max(0, sample.t - FILLED * duration);
    const times = { low: start, high: start + duration };
    const first = Math.max(0, firstAfter(trail, start) - 1);
    const shown = trail.slice(first, firstAfter(trail, times.high) + 1);
    if (panels.some((panel) => panel.expected === null)) {
      const ahead = motion.ahead(duration, LOOKS_AHEAD);
      for (const panel of panels) panel.expected = extent(ahead, panel.curves, []);
    }
    const { em, width, height } = sheet;
    const { clock } = motion.setup;
    const [left, right] = [4.4 * em, width - 0.8 * em];
    const each = (height - 1.8 * em) / panels.length - 2.2 * em;
    panels.forEach((panel, k) => {
      const top = 1.9 * em + k * (each + 2.2 * em);
      const box = { left, right, top, bottom: top + each };
      const known = start === 0 ? panel.expected ?? undefined : undefined;
      const values = [...panel.curves.map(([of]) => of(sample)), ...panel.guides];
      panel.range = panel.follow(panel.range, extent(shown, panel.curves, values, known));
      drawAlongAxis(sheet, box, times, colours, k === panels.length - 1 ? `t in ${clock}` : "");
      drawUpAxis(sheet, box, panel.range, colours);
      drawGuides(sheet, box, panel.range, panel.guides, colours);
      for (const [of, colour] of panel.curves) {
        drawCurve(sheet, box, times, panel.range, shown, sample, of, colours, colours[colour]);
      }
      write(sheet, panel.title, 0.2 * em, top - 1.1 * em);
      write(sheet, panel.now(sample), right, top - 1.1 * em, "right");
    });
    const said = panels.map((panel) => panel.now(sample).replace(/_/g, "")).join(", ");
    paper.describe(`Against time. At t = ${withUnit(significant(sample.t), clock)}: ${said}.`);
  }

  return {
    /**
     * Another motion; the window of time fits it.
     *
     * @param {Motion} next
     */
    setMotion(next) {
      const before = panels;
      motion = next;
      last = null;
      panels = panelsOf(next);
      // An axis that still fits stays.
      if (before.length === panels.length) {
        panels.forEach((panel, k) => (panel.range = before[k].range));
      }
      duration = windowOf(next);
    },
    /**
     * One frame.
     *
     * @param {Sample} sample
     * @param {readonly Sample[]} trail
     */
    draw(sample, trail) {
      last = { sample, trail };
      drawSoon();
    },
    /**
     * Another theme.
     *
     * @param {Colours} next
     */
    setColours(next) {
      colours = next;
      redraw();
    },
  };
}

/**
 * How much of time to show: some periods of what e₃ does, which may be slower than the body spins.
 *
 * @param {Motion} motion
 */
function windowOf({ setup, moments, weight, start, timescale }) {
  if (setup.kind === "free") return nice(40 * timescale);
  const rate = length(start.momentum) / moments[0] + Math.sqrt(length(weight) / moments[0]);
  // What moves so slowly that it can't be computed ahead is shown as if it rested.
  return nice(40 * Math.min(Math.max(timescale, 1 / rate), SLOWEST * timescale));
}

/** @param {import("./types").Numbers} vector */
function length(vector) {
  return Math.hypot(vector[0], vector[1], vector[2]);
}

/**
 * The index of the first sample after t.
 *
 * @param {readonly Sample[]} trail
 * @param {number} t
 */
function firstAfter(trail, t) {
  let low = 0;
  let high = trail.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (trail[middle].t > t) high = middle;
    else low = middle + 1;
  }
  return low;
}

/**
 * The least and the largest of some quantities of samples, of more values, and of a range.
 *
 * @param {readonly Sample[]} samples
 * @param {Panel["curves"]} curves
 * @param {readonly number[]} more
 * @param {Range} [known]
 * @returns {Range}
 */
function extent(samples, curves, more, known = { low: Infinity, high: -Infinity }) {
  let low = Math.min(...more, known.low);
  let high = Math.max(...more, known.high);
  for (const sample of samples) {
    for (const [of] of curves) {
      const value = of(sample);
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return { low, high };
}

/**
 * The range of an axis of rates around zero; the old one as long as it serves.
 *
 * @param {Range} old
 * @param {Range} seen
 * @returns {Range}
 */
function around(old, seen) {
  const size = Math.max(-seen.low, seen.high) || 1;
  if (old.low === -old.high && size <= old.high && old.high < 2.6 * size) return old;
  const high = nice(size / 4) * Math.ceil((1.05 * size) / nice(size / 4));
  return { low: -high, high };
}

/**
 * The range of an axis of θ on which `seen` has room: the old one as long as it does.
 *
 * @param {Range} old
 * @param {Range} seen
 * @returns {Range}
 */
function fitted(old, seen) {
  const still = seen.high - seen.low < 0.005;
  const size = still ? 2 : seen.high - seen.low;
  if (seen.low >= old.low && seen.high <= old.high && old.high - old.low < 3 * size) return old;
  const middle = (seen.low + seen.high) / 2;
  const step = nice(size / 8);
  return {
    low: Math.max(0, Math.floor((middle - 0.56 * size) / step) * step),
    high: Math.min(180, Math.ceil((middle + 0.56 * size) / step) * step),
  };
}

/**
 * The range of an axis of φ, which `seen` pushes up or down, and widens where it is too small.
 *
 * @param {Range} old
 * @param {Range} seen
 * @returns {Range}
 */
function followed(old, seen) {
  const size = Math.max(1, seen.high - seen.low);
  const oldSpan = old.high - old.low;
  const kept = 1.04 * size < oldSpan && oldSpan < 4 * size;
  const span = kept ? oldSpan : nice(1.1 * size);
  const margin = 0.02 * span;
  const low = Math.min(Math.max(old.low, seen.high + margin - span), seen.low - margin);
  return { low, high: low + span };
}

/**
 * Dashed lines at the turning points.
 *
 * @param {Paper} sheet @param {Box} box @param {Range} range @param {readonly number[]} values
 * @param {Colours} colours
 */
function drawGuides({ ctx, em }, box, range, values, colours) {
  const y = scale(range, box.bottom, box.top);
  ctx.strokeStyle = colours.muted;
  ctx.lineWidth = colours.highContrast ? 2 : 1;
  ctx.setLineDash([0.5 * em, 0.4 * em]);
  for (const value of values) {
    line(ctx, box.left, y(value), box.right, y(value));
  }
  ctx.setLineDash([]);
}
