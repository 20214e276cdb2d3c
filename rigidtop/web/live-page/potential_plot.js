/** The effective potential, with the energy and the point that moves between the turning points. */

import { clipTo, createPaper, decimal, drawAlongAxis, drawUpAxis, line, scale, significant,
  withUnit, write } from "./axes.js";
import { drawDot } from "./curves.js";
import { factsOf, potentialOf } from "./facts.js";

/** @typedef {ReturnType<typeof landscapeOf>} Landscape */

const DEGREE = 180 / Math.PI;

/** U_eff(θ) with the energy, the turning points and the moving point. */
export function createPotentialPlot(/** @type {HTMLElement} */ container) {
  /** @type {Landscape | null} */
  let landscape = null;
  /** @type {Sample | null} */
  let last = null;
  container.classList.add("potential-plot");
  const paper = createPaper(container, drawOn);

  function drawOn(/** @type {Paper} */ sheet) {
    if (!landscape || !last) return;
    const { em, width, height } = sheet;
    const right = width - 0.8 * em;
    const box = { left: 4.4 * em, right, top: 2.1 * em, bottom: height - 1.8 * em };
    const step = box.right - box.left > 24 * em ? 30 : 60;
    drawForbidden(sheet, box, landscape);
    drawAlongAxis(sheet, box, ANGLES, "θ in °", step);
    drawUpAxis(sheet, box, landscape.range);
    write(sheet, `U_eff in ${landscape.unit}`, 0.2 * em, 0.8 * em);
    drawLandscape(sheet, box, landscape, last);
    paper.describe(`Effective potential against θ. ${describe(landscape, last)}`);
  }

  return {
    /** Another motion; hides the plot where there is no such potential. */
    setMotion(/** @type {Motion} */ motion) {
      last = null;
      container.hidden = motion.setup.kind === "free" || !motion.symmetric;
      landscape = container.hidden ? null : landscapeOf(motion);
    },
    /** One frame. */
    draw(/** @type {Sample} */ sample) {
      last = sample;
      paper.redrawSoon();
    },
    setColours: paper.setColours,
  };
}

/** @type {Span} */
const ANGLES = { low: 0, high: 180 };

/** Into how many steps the curve of the potential is cut. */
const STEPS = 720;

/** What of the potential stays the same as long as the motion does. */
function landscapeOf(/** @type {Motion} */ motion) {
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
 */
function rangeAround(/** @type {readonly number[]} */ heights, /** @type {number} */ energy) {
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
 * @param {Span} range
 * @param {number} kinetic the most of it
 */
function decimalsOf({ low, high }, kinetic) {
  return Math.max(0, 3 - Math.ceil(Math.log10(Math.max(kinetic, (high - low) / 1000))));
}

/** The energy at a sample in two parts: the height of the potential, and ½λ₁θ̇². */
function splitEnergy(/** @type {Landscape} */ landscape, /** @type {Sample} */ sample) {
  const height = landscape.potential(sample.theta);
  const kinetic = 0.5 * landscape.lambda1 * sample.theta_dot ** 2;
  return { height: Number.isFinite(height) ? height : landscape.energy - kinetic, kinetic };
}

/** Shade where θ may not be. */
function drawForbidden(
  /** @type {Paper} */ { ctx, em, colours }, /** @type {Box} */ box,
  /** @type {Landscape} */ { allowed },
) {
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

/** The curve, the energy, the turning points, and the point that moves between them. */
function drawLandscape(
  /** @type {Paper} */ sheet, /** @type {Box} */ box, /** @type {Landscape} */ landscape,
  /** @type {Sample} */ sample,
) {
  const { ctx, em, colours } = sheet;
  const { heights, energy, allowed, range } = landscape;
  const x = scale(ANGLES, box.left, box.right);
  const y = scale(range, box.bottom, box.top);
  const level = y(energy);
  const thick = (colours.highContrast ? 0.2 : 0.14) * em;

  clipTo(ctx, box);
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
  drawDot(sheet, at, y(height), colours.e3);
  ctx.clearRect(box.right - 1.5 * em, level - 1.4 * em, 1.3 * em, 1.2 * em);
  write(sheet, "E", box.right - 0.5 * em, level - 0.8 * em, "right");
  const text = `½λ₁θ̇² = ${withUnit(decimal(kinetic, landscape.digits), landscape.unit)}`;
  const width = write(sheet, text, box.right, 0.8 * em, "right");
  ctx.strokeStyle = colours.omega;
  line(ctx, box.right - width - 0.6 * em, 0.3 * em, box.right - width - 0.6 * em, 1.2 * em);
}

/** The plot in words. */
function describe(/** @type {Landscape} */ landscape, /** @type {Sample} */ sample) {
  const { height, kinetic } = splitEnergy(landscape, sample);
  const [potential, moving, energy] = [height, kinetic, landscape.energy]
    .map((value) => withUnit(significant(value), landscape.unit));
  const [least, largest] = landscape.allowed.map((angle) => `${decimal(angle * DEGREE, 1)}°`);
  return `Turning points ${least} and ${largest}; now θ = ${decimal(sample.theta * DEGREE, 1)}°, `
    + `U = ${potential}, kinetic part ${moving}, E = ${energy}.`;
}
