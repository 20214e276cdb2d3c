/** Curves against time on a canvas, and the dot that moves on them. */

import { clipTo, line, scale } from "./axes.js";

/**
 * A quantity against time, with the present as a thin line and a dot.
 *
 * Samples that are still to come, as the page has them while it stands at t = 0, make a thin line.
 * Of the samples that share a column of pixels it takes the first, the last, the least and the
 * largest: the picture is the same, and there are never more points than the canvas can show.
 *
 * @template {{ t: number }} S
 * @param {Paper} sheet @param {Box} box @param {Span} times @param {Span} range
 * @param {readonly S[]} samples @param {S} now @param {(sample: S) => number} of
 * @param {string} colour
 */
export function drawCurve(sheet, box, times, range, samples, now, of, colour) {
  const { ctx, em, colours } = sheet;
  const x = scale(times, box.left, box.right);
  const y = scale(range, box.bottom, box.top);
  const present = { x: x(now.t), y: y(of(now)) };

  ctx.strokeStyle = colours.muted;
  ctx.lineWidth = 1;
  line(ctx, present.x, box.top, present.x, box.bottom);

  clipTo(ctx, box);
  const toCome = samples.length > 0 && samples[samples.length - 1].t > now.t;
  ctx.strokeStyle = colour;
  ctx.lineWidth = (toCome ? 0.06 : 0.14) * em * (colours.highContrast ? 1.4 : 1);
  ctx.beginPath();
  let column = -1;
  let firstY = 0;
  let least = 0;
  let largest = 0;
  let lastX = 0;
  let lastY = 0;
  for (const sample of samples) {
    const atX = x(sample.t);
    const atY = y(of(sample));
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
  drawDot(sheet, present.x, present.y, colour);

  function finishColumn() {
    if (least < Math.min(firstY, lastY)) ctx.lineTo(lastX, least);
    if (largest > Math.max(firstY, lastY)) ctx.lineTo(lastX, largest);
    ctx.lineTo(lastX, lastY);
  }
}

/**
 * A curve through places, with the newest of them last; thin if it is still to come.
 *
 * @template {{ t: number }} S
 * @param {Paper} sheet @param {Box} box @param {readonly S[]} samples @param {S} now
 * @param {(sample: S) => [number, number]} place @param {string} colour
 */
export function drawPath({ ctx, em, colours }, box, samples, now, place, colour) {
  const toCome = samples.length > 0 && samples[samples.length - 1].t > now.t;
  clipTo(ctx, box);
  ctx.strokeStyle = colour;
  ctx.lineWidth = (toCome ? 0.08 : 0.14) * em * (colours.highContrast ? 1.4 : 1);
  ctx.beginPath();
  for (const sample of samples) ctx.lineTo(...place(sample));
  if (!toCome) ctx.lineTo(...place(now));
  ctx.stroke();
  ctx.restore();
}

/**
 * Where the top is now.
 *
 * @param {Paper} sheet @param {number} x @param {number} y @param {string} colour
 * @param {number} size times the usual one
 */
export function drawDot({ ctx, em, colours }, x, y, colour, size = 1) {
  ctx.beginPath();
  ctx.arc(x, y, 0.36 * size * em, 0, 2 * Math.PI);
  ctx.fillStyle = colour;
  ctx.fill();
  ctx.strokeStyle = colours.paper;
  ctx.lineWidth = 1.5;
  ctx.stroke();
  ctx.fillStyle = colours.ink;
}
