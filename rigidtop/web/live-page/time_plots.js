/** What goes on: quantities against time, those of the ghost beside them, and θ against φ. */

import { atMostEvery, createPaper, decimal, drawAlongAxis, drawUpAxis, line, nice, scale,
  significant, withUnit, write } from "./axes.js";
import { drawCurve, drawDot, drawPath } from "./curves.js";
import { factsOf } from "./facts.js";
import { apart } from "./ghost.js";

/** @typedef {import("./types").Colours} Colours */
/** @typedef {import("./types").Kind} Kind */
/** @typedef {import("./types").Motion} Motion */
/** @typedef {import("./types").Sample} Sample */
/** @typedef {import("./axes.js").Box} Box */
/** @typedef {import("./axes.js").Paper} Paper */
/** @typedef {import("./axes.js").Range} Range */
/** @typedef {import("./curves.js").Quantity} Quantity */
/** @typedef {"e1" | "e2" | "e3" | "omega" | "L" | "torque" | "ink"} Colour */

/**
 * A panel: what is drawn in it, where its axis goes, and what stands above it.
 *
 * @typedef {object} Panel
 * @property {string} title
 * @property {readonly (readonly [Quantity, Colour])[]} curves
 * @property {(old: Range, seen: Range) => Range} follow
 * @property {readonly number[]} guides Dashed lines.
 * @property {(sample: Sample) => string} now
 * @property {Range} range
 * @property {Range | null} expected What is seen of it in the first window of time.
 */

/**
 * The motion and its ghost at the same times: what is drawn now, and until now.
 *
 * @typedef {{ sample: Sample, trail: readonly Sample[] }} Past
 */

/** The plots of a page, by their names in the address; the first is shown at first. */
const PLOTS = /** @type {const} */ ({
  "heavy-top": [["angles", "θ, φ"], ["path", "θ(φ)"], ["energy", "T, V, E"]],
  free: [["rates", "ω₁,₂,₃"], ["angles", "θ, φ"], ["path", "θ(φ)"]],
});

/**
 * @param {Kind} kind
 * @returns {readonly (readonly [string, string])[]}
 */
export function plotsOf(kind) {
  return PLOTS[kind];
}

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

/** @type {Range} */
const UNIT = { low: 0, high: 1 };

/**
 * The panels of a motion, one above the other.
 *
 * @param {Motion} motion
 * @param {string} plot
 * @returns {Panel[]}
 */
function panelsOf(motion, plot) {
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

/**
 * @param {HTMLElement} container
 * @param {Colours} colours
 */
export function createTimePlots(container, colours) {
  /** @type {Motion | null} */
  let motion = null;
  /** @type {Motion | null} */
  let ghost = null;
  let plot = "";
  /** @type {Past | null} */
  let last = null;
  /** @type {Past | null} */
  let lastGhost = null;
  /** @type {Panel[]} */
  let panels = [];
  let apartRange = UNIT;
  let duration = 1;
  container.classList.add("time-plots");
  const paper = createPaper(container, redraw);
  const drawSoon = atMostEvery(EVERY, redraw);

  function redraw() {
    const sheet = motion && last && paper.clear();
    if (!motion || !last || !sheet) return;
    const { sample } = last;
    const { clock } = motion.setup;
    const start = Math.max(0, sample.t - FILLED * duration);
    const times = { low: start, high: start + duration };
    const shown = within(last.trail, times);
    const beside = lastGhost && { ...lastGhost, trail: within(lastGhost.trail, times) };
    if (panels.some((panel) => panel.expected === null)) {
      const ahead = motion.ahead(duration, LOOKS_AHEAD);
      const ghosts = ghost?.ahead(duration, LOOKS_AHEAD) ?? [];
      for (const panel of panels) {
        panel.expected = extent([...ahead, ...ghosts], panel.curves.map(([of]) => of), []);
      }
    }
    for (const panel of panels) {
      const known = start === 0 ? panel.expected ?? undefined : undefined;
      const of = panel.curves.map(([each]) => each);
      const values = [...of.map((each) => each(sample)), ...panel.guides];
      const seen = extent(beside ? [...shown, ...beside.trail] : shown, of, values, known);
      panel.range = panel.follow(panel.range, seen);
    }
    if (plot === "path") drawAcross(sheet, shown, sample, beside);
    else drawPanels(sheet, times, shown, sample, beside);
    const said = panels.map((panel) => panel.now(sample).replace(/_/g, "")).join(", ");
    paper.describe(
      `${plot === "path" ? "θ against φ" : "Against time"}. ` +
        `At t = ${withUnit(significant(sample.t), clock)}: ${said}.`,
    );
  }

  /** The panels one above the other; of two the ghost's distance takes the place of the last. */
  function drawPanels(
    /** @type {Paper} */ sheet, /** @type {Range} */ times, /** @type {readonly Sample[]} */ shown,
    /** @type {Sample} */ sample, /** @type {Past | null} */ beside,
  ) {
    const { em, width, height } = sheet;
    const [left, right] = [4.4 * em, width - 0.8 * em];
    const drawn = beside && panels.length === 2 ? panels.slice(0, 1) : panels;
    const count = drawn.length + (beside ? 1 : 0);
    const each = (height - 1.8 * em) / count - 2.2 * em;
    const frame = (/** @type {number} */ k, /** @type {Range} */ range, title = "", now = "") => {
      const top = 1.9 * em + k * (each + 2.2 * em);
      const box = { left, right, top, bottom: top + each };
      const label = k === count - 1 ? `t in ${motion?.setup.clock}` : "";
      drawAlongAxis(sheet, box, times, colours, label);
      drawUpAxis(sheet, box, range, colours);
      write(sheet, title, 0.2 * em, top - 1.1 * em);
      write(sheet, now, right, top - 1.1 * em, "right");
      return box;
    };
    drawn.forEach((panel, k) => {
      const { range } = panel;
      const box = frame(k, range, panel.title, panel.now(sample));
      drawGuides(sheet, box, range, panel.guides, colours);
      for (const [of, name] of panel.curves) {
        if (beside) {
          const { ctx } = sheet;
          ctx.globalAlpha = colours.highContrast ? 0.7 : 0.5;
          const colour = panel.curves.length > 1 ? colours[name] : colours.polhode;
          drawCurve(sheet, box, times, range, beside.trail, beside.sample, of, colours, colour);
          ctx.globalAlpha = 1;
        }
        drawCurve(sheet, box, times, range, shown, sample, of, colours, colours[name]);
      }
    });
    if (!beside || !motion) return;
    const between = apart(motion.setup.kind);
    const pairs = shown.flatMap((one, k) => {
      const other = beside.trail[k];
      return other?.t === one.t ? [{ t: one.t, angle: between(one, other) * DEGREE }] : [];
    });
    const angle = (/** @type {{ angle: number }} */ pair) => pair.angle;
    const now = { t: sample.t, angle: between(sample, beside.sample) * DEGREE };
    apartRange = fitted(apartRange, extent(pairs, [angle], [0, now.angle]), 0, 180);
    const box = frame(count - 1, apartRange, "apart in °", `${significant(now.angle)}°`);
    drawCurve(sheet, box, times, apartRange, pairs, now, angle, colours, colours.polhode);
  }

  /** θ over φ, as on the unrolled sphere: the least θ is at the top. */
  function drawAcross(
    /** @type {Paper} */ sheet, /** @type {readonly Sample[]} */ shown,
    /** @type {Sample} */ sample, /** @type {Past | null} */ beside,
  ) {
    const { em, width, height } = sheet;
    const box = { left: 4.4 * em, right: width - 0.8 * em, top: 1.9 * em,
      bottom: height - 1.8 * em };
    const [up, across] = panels.map(({ range }) => range);
    // Upside down: θ = 0 is the vertical.
    const turned = { ...box, top: box.bottom, bottom: box.top };
    drawAlongAxis(sheet, box, across, colours, "φ in °");
    drawUpAxis(sheet, turned, up, colours);
    drawGuides(sheet, turned, up, panels[0].guides, colours);
    write(sheet, "θ in °, down", 0.2 * em, 0.8 * em);
    write(sheet, panels.map((panel) => panel.now(sample)).join("  "), box.right, 0.8 * em, "right");
    const [x, y] = [scale(across, box.left, box.right), scale(up, box.top, box.bottom)];
    const one = /** @type {const} */ ([shown, sample, colours.trail]);
    const other = beside && /** @type {const} */ ([beside.trail, beside.sample, colours.polhode]);
    for (const [samples, now, colour] of other ? [other, one] : [one]) {
      const place = (/** @type {Sample} */ each) =>
        /** @type {[number, number]} */ ([x(phi(each)), y(theta(each))]);
      drawPath(sheet, box, samples, now, place, colours, colour);
      drawDot(sheet.ctx, ...place(now), em, colours, colour);
    }
  }

  return {
    /**
     * Another motion, another ghost or another plot; the window of time fits the motion.
     *
     * @param {Motion} next
     * @param {Motion | null} beside
     * @param {string} chosen
     */
    setMotion(next, beside, chosen) {
      const before = plot === chosen ? panels : [];
      [motion, ghost, plot] = [next, beside, chosen];
      last = null;
      panels = panelsOf(next, chosen);
      // An axis that still fits stays.
      if (before.length === panels.length) {
        panels.forEach((panel, k) => (panel.range = before[k].range));
      }
      duration = windowOf(next);
    },
    /**
     * One frame.
     *
     * @param {Past} now
     * @param {Past | null} beside
     */
    draw(now, beside) {
      [last, lastGhost] = [now, beside];
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
 * The samples in a window of time, and one beyond each end.
 *
 * @param {readonly Sample[]} trail
 * @param {Range} times
 */
function within(trail, { low, high }) {
  return trail.slice(Math.max(0, firstAfter(trail, low) - 1), firstAfter(trail, high) + 1);
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
 * @template S
 * @param {readonly S[]} samples
 * @param {readonly ((sample: S) => number)[]} quantities
 * @param {readonly number[]} more
 * @param {Range} [known]
 * @returns {Range}
 */
function extent(samples, quantities, more, known = { low: Infinity, high: -Infinity }) {
  let low = Math.min(...more, known.low);
  let high = Math.max(...more, known.high);
  for (const sample of samples) {
    for (const of of quantities) {
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
 * The range of an axis on which `seen` has room, within its ends: the old one as long as it does.
 *
 * @param {Range} old
 * @param {Range} seen
 * @param {number} least
 * @param {number} most
 * @returns {Range}
 */
function fitted(old, seen, least, most) {
  const still = seen.high - seen.low < 0.005;
  const size = still ? 2 : seen.high - seen.low;
  if (seen.low >= old.low && seen.high <= old.high && old.high - old.low < 3 * size) return old;
  const middle = (seen.low + seen.high) / 2;
  const step = nice(size / 8);
  return {
    low: Math.max(least, Math.floor((middle - 0.56 * size) / step) * step),
    high: Math.min(most, Math.ceil((middle + 0.56 * size) / step) * step),
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
