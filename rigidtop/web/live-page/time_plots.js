/** What goes on: quantities against time, those of the ghost beside them, and θ against φ. */

import { createPaper, drawAlongAxis, drawUpAxis, line, nice, scale, significant,
  withUnit, write } from "./axes.js";
import { drawCurve, drawDot, drawPath } from "./curves.js";

/** The part of the window of time that fills before it scrolls. */
const FILLED = 0.9;

/** So many samples of the first window say how far the axes go. */
const LOOKS_AHEAD = 60;

const DEGREE = 180 / Math.PI;

/** @type {Span} */
export const UNIT = { low: 0, high: 1 };

/**
 * @template {Timed} S
 * @template {Moving<S>} M
 * @param {HTMLElement} container
 * @param {(motion: M, plot: string) => Plotted<S>} plottedOf
 */
export function createTimePlots(container, plottedOf) {
  /** @type {M | null} */
  let motion = null;
  /** @type {M | null} */
  let ghost = null;
  let plot = "";
  /** @type {Past<S> | null} */
  let last = null;
  /** @type {Past<S> | null} */
  let lastGhost = null;
  /** @type {Plotted<S>} */
  let plotted = { panels: [], across: "", clock: "s", duration: 1, apart: null };
  let apartRange = UNIT;
  container.classList.add("time-plots");
  const paper = createPaper(container, drawOn);

  function drawOn(/** @type {Paper} */ sheet) {
    if (!motion || !last) return;
    const { sample } = last;
    const { panels, across, clock, duration } = plotted;
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
    if (across) drawAcross(sheet, shown, sample, beside);
    else drawPanels(sheet, times, shown, sample, beside);
    const said = panels.map((panel) => panel.now(sample).replace(/_/g, "")).join(", ");
    const letters = panels.map(({ title }) => title.split(" ")[0]);
    paper.describe(
      `${across ? letters.join(" against ") : "Against time"}. ` +
        `At t = ${withUnit(significant(sample.t), clock)}: ${said}.`,
    );
  }

  /** The panels one above the other; of two the ghost's distance takes the place of the last. */
  function drawPanels(
    /** @type {Paper} */ sheet, /** @type {Span} */ times, /** @type {readonly S[]} */ shown,
    /** @type {S} */ sample, /** @type {Past<S> | null} */ beside,
  ) {
    const { panels, clock, apart: between } = plotted;
    const { em, width, height, colours } = sheet;
    const [left, right] = [room(panels) * em, width - 0.8 * em];
    const drawn = beside && between && panels.length === 2 ? panels.slice(0, 1) : panels;
    const count = drawn.length + (beside && between ? 1 : 0);
    const each = (height - 1.8 * em) / count - 2.2 * em;
    const frame = (/** @type {number} */ k, /** @type {Span} */ range, title = "", now = "") => {
      const top = 1.9 * em + k * (each + 2.2 * em);
      const box = { left, right, top, bottom: top + each };
      const label = k === count - 1 ? `t in ${clock}` : "";
      drawAlongAxis(sheet, box, times, label);
      drawUpAxis(sheet, box, range);
      write(sheet, title, 0.2 * em, top - 1.1 * em);
      write(sheet, now, width - 0.2 * em, top - 1.1 * em, "right");
      return box;
    };
    drawn.forEach((panel, k) => {
      const { range } = panel;
      const box = frame(k, range, panel.title, panel.now(sample));
      drawGuides(sheet, box, range, panel.guides);
      for (const [of, name] of panel.curves) {
        if (beside) {
          const { ctx } = sheet;
          ctx.globalAlpha = colours.highContrast ? 0.7 : 0.5;
          const colour = panel.curves.length > 1 ? colours[name] : colours.polhode;
          drawCurve(sheet, box, times, range, beside.trail, beside.sample, of, colour);
          ctx.globalAlpha = 1;
        }
        drawCurve(sheet, box, times, range, shown, sample, of, colours[name]);
      }
    });
    if (!beside || !between) return;
    const pairs = shown.flatMap((one, k) => {
      const other = beside.trail[k];
      return other?.t === one.t ? [{ t: one.t, angle: between(one, other) * DEGREE }] : [];
    });
    const angle = (/** @type {{ angle: number }} */ pair) => pair.angle;
    const now = { t: sample.t, angle: between(sample, beside.sample) * DEGREE };
    apartRange = fitted(apartRange, extent(pairs, [angle], [0, now.angle]), 0, 180);
    const box = frame(count - 1, apartRange, "apart in °", `${significant(now.angle)}°`);
    drawCurve(sheet, box, times, apartRange, pairs, now, angle, colours.polhode);
  }

  /** As θ over φ on the unrolled sphere, where the least θ is at the top, or upwards. */
  function drawAcross(
    /** @type {Paper} */ sheet, /** @type {readonly S[]} */ shown,
    /** @type {S} */ sample, /** @type {Past<S> | null} */ beside,
  ) {
    const { panels, across: way } = plotted;
    const { em, width, height, colours } = sheet;
    const box = { left: room(panels) * em, right: width - 0.8 * em, top: 1.9 * em,
      bottom: height - 1.8 * em };
    const [up, across] = panels.map(({ range }) => range);
    const turned = way === "down" ? { ...box, top: box.bottom, bottom: box.top } : box;
    drawAlongAxis(sheet, box, across, panels[1].title);
    drawUpAxis(sheet, turned, up);
    drawGuides(sheet, turned, up, panels[0].guides);
    write(sheet, panels[0].title + (way === "down" ? ", down" : ""), 0.2 * em, 0.8 * em);
    write(sheet, panels.map((panel) => panel.now(sample)).join("  "), box.right, 0.8 * em, "right");
    const [upwards, along] = panels.map(({ curves }) => curves[0][0]);
    const [x, y] = [scale(across, box.left, box.right), scale(up, turned.bottom, turned.top)];
    const one = /** @type {const} */ ([shown, sample, colours.trail]);
    const other = beside && /** @type {const} */ ([beside.trail, beside.sample, colours.polhode]);
    for (const [samples, now, colour] of other ? [other, one] : [one]) {
      const place = (/** @type {S} */ each) =>
        /** @type {[number, number]} */ ([x(along(each)), y(upwards(each))]);
      drawPath(sheet, box, samples, now, place, colour);
      drawDot(sheet, ...place(now), colour);
    }
  }

  return {
    /** Another motion, another ghost or another plot; the window of time fits the motion. */
    setMotion(/** @type {M} */ next, /** @type {M | null} */ beside, /** @type {string} */ chosen) {
      const before = plot === chosen ? plotted.panels : [];
      [motion, ghost, plot] = [next, beside, chosen];
      last = null;
      plotted = plottedOf(next, chosen);
      const { panels } = plotted;
      // An axis that still fits stays.
      if (before.length === panels.length) {
        panels.forEach((panel, k) => (panel.range = before[k].range));
      }
    },
    /** One frame. */
    draw(/** @type {Past<S>} */ now, /** @type {Past<S> | null} */ beside) {
      [last, lastGhost] = [now, beside];
      paper.redrawSoon();
    },
    setColours: paper.setColours,
    canvas: paper.canvas,
  };
}

/** For the numbers beside the axes: more for those with a power of ten. */
function room(/** @type {readonly { range: Span }[]} */ panels) {
  const sizes = panels.map(({ range: { low, high } }) => Math.max(-low, high));
  return sizes.some((size) => size >= 1e5 || size < 1e-3) ? 6 : 4.4;
}

/**
 * The samples in a window of time, and one beyond each end.
 *
 * @template {Timed} S
 * @param {readonly S[]} trail
 * @param {Span} times
 */
function within(trail, { low, high }) {
  return trail.slice(Math.max(0, firstAfter(trail, low) - 1), firstAfter(trail, high) + 1);
}

/** The index of the first sample after t. */
function firstAfter(/** @type {readonly Timed[]} */ trail, /** @type {number} */ t) {
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
 * @param {Span} [known]
 * @returns {Span}
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
 * The range of an axis on which `seen` has room, within its ends: the old one as long as it does.
 *
 * @param {Span} old
 * @param {Span} seen
 * @param {number} least
 * @param {number} most
 * @param {number} [finest] What changes by less is drawn as if it rested.
 * @returns {Span}
 */
export function fitted(old, seen, least, most, finest = 0.005) {
  const still = seen.high - seen.low < finest;
  const size = still ? 400 * finest : seen.high - seen.low;
  if (seen.low >= old.low && seen.high <= old.high && old.high - old.low < 3 * size) return old;
  const middle = (seen.low + seen.high) / 2;
  const step = nice(size / 8);
  return {
    low: Math.max(least, Math.floor((middle - 0.56 * size) / step) * step),
    high: Math.min(most, Math.ceil((middle + 0.56 * size) / step) * step),
  };
}

/** Dashed lines at the turning points. */
function drawGuides(
  /** @type {Paper} */ { ctx, em, colours }, /** @type {Box} */ box, /** @type {Span} */ range,
  /** @type {readonly number[]} */ values,
) {
  const y = scale(range, box.bottom, box.top);
  ctx.strokeStyle = colours.muted;
  ctx.lineWidth = colours.highContrast ? 2 : 1;
  ctx.setLineDash([0.5 * em, 0.4 * em]);
  for (const value of values) {
    line(ctx, box.left, y(value), box.right, y(value));
  }
  ctx.setLineDash([]);
}
