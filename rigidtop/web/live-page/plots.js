/** The angles of the figure axis against time, and the effective potential. */

import { atMostEvery, createPaper, decimal, drawAlongAxis, drawUpAxis, line, nice, scale,
  significant, withUnit, write } from "./axes.js";
import { factsOf, potentialOf } from "./facts.js";

/** @typedef {import("./types").Colours} Colours */
/** @typedef {import("./types").Motion} Motion */
/** @typedef {import("./types").Sample} Sample */
/** @typedef {import("./axes.js").Box} Box */
/** @typedef {import("./axes.js").Paper} Paper */
/** @typedef {import("./axes.js").Range} Range */
/** @typedef {"theta" | "phi"} Angle */
/** @typedef {ReturnType<typeof landscapeOf>} Landscape */

const DEGREE = 180 / Math.PI;

/** The part of the window of time that fills before it scrolls. */
const FILLED = 0.9;

/** Plots are drawn at most this often, in milliseconds: half as often as the scene is enough. */
const EVERY = 28;

/** The slowest motion that the window of time is made for, in times of the motion. */
const SLOWEST = 40;

/** So many samples of the first window say how large the angles will be. */
const LOOKS_AHEAD = 60;

/**
 * θ(t) and φ(t) of e₃ in degrees, one above the other.
 *
 * @param {HTMLElement} container
 * @param {Colours} colours
 */
export function createTimePlots(container, colours) {
  /** @type {Motion | null} */
  let motion = null;
  /** @type {{sample: Sample, trail: readonly Sample[]} | null} */
  let last = null;
  /** @type {readonly number[]} */
  let turningPoints = [];
  let duration = 1;
  /**
   * The angles in the first window of time, so that the axes need not change on the way.
   *
   * @type {Record<Angle, Range> | null}
   */
  let expected = null;
  /** @type {Range} */
  let thetas = { low: 0, high: 180 };
  /** @type {Range} */
  let phis = { low: 0, high: 1 };
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
    expected ??= foreseen(motion, duration);
    const known = start === 0 ? expected : null;
    thetas = fitted(thetas,
      extent(shown, "theta", [sample.theta, ...turningPoints], known?.theta));
    phis = followed(phis, extent(shown, "phi", [sample.phi], known?.phi));

    const { em, width, height } = sheet;
    const left = 4.4 * em;
    const right = width - 0.8 * em;
    const each = (height - 6.2 * em) / 2;
    const upper = { left, right, top: 1.9 * em, bottom: 1.9 * em + each };
    const lower = { left, right, top: upper.bottom + 2.5 * em, bottom: height - 1.8 * em };
    const { clock } = motion.setup;
    const theta = `θ = ${decimal(sample.theta * DEGREE, 2)}°`;
    const phi = `φ = ${decimal(sample.phi * DEGREE, 1)}°`;

    drawAlongAxis(sheet, upper, times, colours, "");
    drawUpAxis(sheet, upper, thetas, colours);
    drawGuides(sheet, upper, thetas, turningPoints, colours);
    drawCurve(sheet, upper, times, thetas, shown, sample, "theta", colours);
    write(sheet, "θ in °", 0.2 * em, 0.8 * em);
    write(sheet, theta, right, 0.8 * em, "right");

    drawAlongAxis(sheet, lower, times, colours, `t in ${clock}`);
    drawUpAxis(sheet, lower, phis, colours);
    drawCurve(sheet, lower, times, phis, shown, sample, "phi", colours);
    write(sheet, "φ in °", 0.2 * em, lower.top - 1.1 * em);
    write(sheet, phi, right, lower.top - 1.1 * em, "right");

    paper.describe(
      `θ and φ against time. At t = ${withUnit(significant(sample.t), clock)}: ${theta}, ${phi}.`);
  }

  return {
    /**
     * Another motion; the window of time fits it.
     *
     * @param {Motion} next
     */
    setMotion(next) {
      motion = next;
      last = null;
      turningPoints = factsOf(next).turningPoints ?? [];
      duration = windowOf(next);
      expected = null;
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
 * The ranges of θ and φ in the first window of time.
 *
 * @param {Motion} motion
 * @param {number} duration
 */
function foreseen(motion, duration) {
  const samples = motion.ahead(duration, LOOKS_AHEAD);
  return { theta: extent(samples, "theta", []), phi: extent(samples, "phi", []) };
}

/**
 * The least and the largest angle of samples, of some more, and of a range; in degrees.
 *
 * @param {readonly Sample[]} samples
 * @param {Angle} angle
 * @param {readonly number[]} more
 * @param {Range} [known]
 * @returns {Range}
 */
function extent(samples, angle, more, known = { low: Infinity, high: -Infinity }) {
  let low = Math.min(...more, known.low / DEGREE);
  let high = Math.max(...more, known.high / DEGREE);
  for (const { [angle]: value } of samples) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return { low: low * DEGREE, high: high * DEGREE };
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
 * @param {Paper} sheet @param {Box} box @param {Range} range @param {readonly number[]} angles
 * @param {Colours} colours
 */
function drawGuides({ ctx, em }, box, range, angles, colours) {
  const y = scale(range, box.bottom, box.top);
  ctx.strokeStyle = colours.muted;
  ctx.lineWidth = colours.highContrast ? 2 : 1;
  ctx.setLineDash([0.5 * em, 0.4 * em]);
  for (const angle of angles) {
    line(ctx, box.left, y(angle * DEGREE), box.right, y(angle * DEGREE));
  }
  ctx.setLineDash([]);
}

/**
 * An angle against time, with the present as a thin line and a dot.
 *
 * Samples that are still to come, as the page has them while it stands at t = 0, make a thin line.
 * Of the samples that share a column of pixels it takes the first, the last, the least and the
 * largest: the picture is the same, and there are never more points than the canvas can show.
 *
 * @param {Paper} sheet @param {Box} box @param {Range} times @param {Range} range
 * @param {readonly Sample[]} samples @param {Sample} now @param {Angle} angle
 * @param {Colours} colours
 */
function drawCurve({ ctx, em }, box, times, range, samples, now, angle, colours) {
  const x = scale(times, box.left, box.right);
  const y = scale(range, box.bottom, box.top);
  const present = { x: x(now.t), y: y(now[angle] * DEGREE) };

  ctx.strokeStyle = colours.muted;
  ctx.lineWidth = 1;
  line(ctx, present.x, box.top, present.x, box.bottom);

  ctx.save();
  ctx.beginPath();
  ctx.rect(box.left, box.top, box.right - box.left, box.bottom - box.top);
  ctx.clip();
  const toCome = samples.length > 0 && samples[samples.length - 1].t > now.t;
  ctx.strokeStyle = colours.e3;
  ctx.lineWidth = (toCome ? 0.06 : 0.14) * em * (colours.highContrast ? 1.4 : 1);
  ctx.beginPath();
  let column = -1;
  let firstY = 0;
  let least = 0;
  let largest = 0;
  let lastX = 0;
  let lastY = 0;
  for (const { t, [angle]: value } of samples) {
    const atX = x(t);
    const atY = y(value * DEGREE);
    const atColumn = Math.floor(atX);
    if (atColumn === column) {
      least = Math.min(least, atY);
      largest = Math.max(largest, atY);
    } else {
      if (column >= 0) finishColumn();
      ctx.lineTo(atX, atY);
      column = atColumn;
      firstY = atY;
      least = atY;
      largest = atY;
    }
    lastX = atX;
    lastY = atY;
  }
  if (column >= 0) finishColumn();
  if (!toCome) ctx.lineTo(present.x, present.y);
  ctx.stroke();
  ctx.restore();
  drawDot(ctx, present.x, present.y, em, colours);

  function finishColumn() {
    if (least < Math.min(firstY, lastY)) ctx.lineTo(lastX, least);
    if (largest > Math.max(firstY, lastY)) ctx.lineTo(lastX, largest);
    ctx.lineTo(lastX, lastY);
  }
}

/**
 * Where the top is now.
 *
 * @param {CanvasRenderingContext2D} ctx @param {number} x @param {number} y @param {number} em
 * @param {Colours} colours
 */
function drawDot(ctx, x, y, em, colours) {
  ctx.beginPath();
  ctx.arc(x, y, 0.36 * em, 0, 2 * Math.PI);
  ctx.fillStyle = colours.e3;
  ctx.fill();
  ctx.strokeStyle = colours.paper;
  ctx.lineWidth = 1.5;
  ctx.stroke();
  ctx.fillStyle = colours.ink;
}

/**
 * U_eff(θ) with the energy, the turning points and the moving point.
 *
 * @param {HTMLElement} container
 * @param {Colours} colours
 */
export function createPotentialPlot(container, colours) {
  /** @type {Landscape | null} */
  let landscape = null;
  /** @type {Sample | null} */
  let last = null;
  container.classList.add("potential-plot");
  const paper = createPaper(container, redraw);
  const drawSoon = atMostEvery(EVERY, redraw);

  function redraw() {
    const sheet = landscape && last && paper.clear();
    if (!landscape || !last || !sheet) return;
    const { em, width, height } = sheet;
    const right = width - 0.8 * em;
    const box = { left: 4.4 * em, right, top: 2.1 * em, bottom: height - 1.8 * em };
    const step = box.right - box.left > 24 * em ? 30 : 60;
    drawForbidden(sheet, box, landscape, colours);
    drawAlongAxis(sheet, box, ANGLES, colours, "θ in °", step);
    drawUpAxis(sheet, box, landscape.range, colours);
    write(sheet, `U_eff in ${landscape.unit}`, 0.2 * em, 0.8 * em);
    drawLandscape(sheet, box, landscape, last, colours);
    paper.describe(`Effective potential against θ. ${describe(landscape, last)}`);
  }

  return {
    /**
     * Another motion; hides the plot where there is no such potential.
     *
     * @param {Motion} motion
     */
    setMotion(motion) {
      last = null;
      container.hidden = motion.setup.kind === "free" || !motion.symmetric;
      landscape = container.hidden ? null : landscapeOf(motion);
    },
    /**
     * One frame.
     *
     * @param {Sample} sample
     */
    draw(sample) {
      last = sample;
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

/** @type {Range} */
const ANGLES = { low: 0, high: 180 };

/** Into how many steps the curve of the potential is cut. */
const STEPS = 720;

/**
 * What of the potential stays the same as long as the motion does.
 *
 * @param {Motion} motion
 */
function landscapeOf(motion) {
  const { setup, start, moments } = motion;
  const { energy } = start;
  const potential = potentialOf(motion);
  const heights = Array.from({ length: STEPS }, (_, k) => potential((k + 0.5) * Math.PI / STEPS));
  const range = rangeAround(heights, energy);
  return {
    energy,
    potential,
    heights,
    lambda1: moments[0],
    allowed: factsOf(motion).turningPoints ?? [start.theta, start.theta],
    range,
    digits: decimalsOf(range, energy - Math.min(...heights)),
    unit: setup.clock === "s" ? "J" : `1/${setup.clock}²`,
  };
}

/**
 * The part of the potential to show: its least value, the energy, and so much of the walls on both
 * sides that they are seen to be walls.
 *
 * @param {readonly number[]} heights
 * @param {number} energy
 * @returns {Range}
 */
function rangeAround(heights, energy) {
  const low = Math.min(...heights);
  const bottom = heights.indexOf(low);
  const reach = STEPS / 6;
  const walls = [bottom - reach, bottom + reach]
    .map((k) => heights[Math.round(k)] ?? Infinity)
    .filter(Number.isFinite);
  const wall = Math.min(...walls) - low;
  const kinetic = energy - low;
  // Without weight and momenta the potential is flat.
  const depth = Math.max(2 * kinetic, Math.min(wall, Math.max(5 * kinetic, 0.4 * wall))) || 1;
  return { low: low - 0.12 * depth, high: low + 1.1 * depth };
}

/**
 * Decimals that show the kinetic part, if it is not too small to be seen.
 *
 * @param {Range} range
 * @param {number} kinetic the most of it
 */
function decimalsOf({ low, high }, kinetic) {
  return Math.max(0, 3 - Math.ceil(Math.log10(Math.max(kinetic, (high - low) / 1000))));
}

/**
 * The energy at a sample in two parts: the height of the potential, and ½λ₁θ̇².
 *
 * @param {Landscape} landscape
 * @param {Sample} sample
 */
function splitEnergy(landscape, sample) {
  const height = landscape.potential(sample.theta);
  const kinetic = 0.5 * landscape.lambda1 * sample.theta_dot ** 2;
  return { height: Number.isFinite(height) ? height : landscape.energy - kinetic, kinetic };
}

/**
 * Shade where θ may not be.
 *
 * @param {Paper} sheet @param {Box} box @param {Landscape} landscape @param {Colours} colours
 */
function drawForbidden({ ctx, em }, box, { allowed }, colours) {
  const x = scale(ANGLES, box.left, box.right);
  const [least, largest] = allowed.map((angle) => x(angle * DEGREE));
  const height = box.bottom - box.top;
  const gap = (colours.highContrast ? 1.6 : 0.6) * em;
  ctx.save();
  ctx.beginPath();
  ctx.rect(box.left, box.top, least - box.left, height);
  ctx.rect(largest, box.top, box.right - largest, height);
  ctx.clip();
  ctx.strokeStyle = colours.rule;
  ctx.lineWidth = 1;
  for (let at = box.left - height; at < box.right; at += gap) {
    line(ctx, at, box.bottom, at + height, box.top);
  }
  ctx.restore();
}

/**
 * The curve, the energy, the turning points, and the point that moves between them.
 *
 * @param {Paper} sheet @param {Box} box @param {Landscape} landscape @param {Sample} sample
 * @param {Colours} colours
 */
function drawLandscape(sheet, box, landscape, sample, colours) {
  const { ctx, em } = sheet;
  const { heights, energy, allowed, range } = landscape;
  const x = scale(ANGLES, box.left, box.right);
  const y = scale(range, box.bottom, box.top);
  const level = y(energy);
  const thick = (colours.highContrast ? 0.2 : 0.14) * em;

  ctx.save();
  ctx.beginPath();
  ctx.rect(box.left, box.top, box.right - box.left, box.bottom - box.top);
  ctx.clip();
  ctx.beginPath();
  heights.forEach((height, k) => {
    ctx.lineTo(x((k + 0.5) * 180 / STEPS), Math.max(y(height), box.top - 100));
  });
  ctx.strokeStyle = colours.ink;
  ctx.lineWidth = thick;
  ctx.stroke();
  ctx.restore();

  ctx.strokeStyle = colours.polhode;
  ctx.lineWidth = thick;
  line(ctx, box.left, level, box.right, level);
  ctx.strokeStyle = colours.muted;
  ctx.lineWidth = colours.highContrast ? 2 : 1;
  ctx.setLineDash([0.5 * em, 0.4 * em]);
  for (const angle of allowed) {
    line(ctx, x(angle * DEGREE), box.top, x(angle * DEGREE), box.bottom);
  }
  ctx.setLineDash([]);

  const { height, kinetic } = splitEnergy(landscape, sample);
  const at = x(sample.theta * DEGREE);
  ctx.strokeStyle = colours.omega;
  ctx.lineWidth = 2 * thick;
  line(ctx, at, level, at, y(height));
  drawDot(ctx, at, y(height), em, colours);
  ctx.clearRect(box.right - 1.5 * em, level - 1.4 * em, 1.3 * em, 1.2 * em);
  write(sheet, "E", box.right - 0.5 * em, level - 0.8 * em, "right");
  const text = `½λ₁θ̇² = ${withUnit(decimal(kinetic, landscape.digits), landscape.unit)}`;
  const width = write(sheet, text, box.right, 0.8 * em, "right");
  ctx.strokeStyle = colours.omega;
  line(ctx, box.right - width - 0.6 * em, 0.3 * em, box.right - width - 0.6 * em, 1.2 * em);
}

/**
 * The plot in words.
 *
 * @param {Landscape} landscape
 * @param {Sample} sample
 */
function describe(landscape, sample) {
  const { height, kinetic } = splitEnergy(landscape, sample);
  const [potential, moving, energy] = [height, kinetic, landscape.energy]
    .map((value) => withUnit(significant(value), landscape.unit));
  const [least, largest] = landscape.allowed.map((angle) => `${decimal(angle * DEGREE, 1)}°`);
  return `Turning points ${least} and ${largest}; now θ = ${decimal(sample.theta * DEGREE, 1)}°, `
    + `U = ${potential}, kinetic part ${moving}, E = ${energy}.`;
}
