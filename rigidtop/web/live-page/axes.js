/** What the panels share: numbers as text, axes on a canvas, and doing things not too often. */

import { readColours } from "./theme.js";

const SUPERSCRIPTS = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷",
  8: "⁸", 9: "⁹" };
const THIN_SPACE = "\u202f";

/** An exponent of ten as superscript: −14 → "10⁻¹⁴". */
export function powerOfTen(/** @type {number} */ exponent) {
  const digits = /** @type {(keyof typeof SUPERSCRIPTS)[]} */ ([...String(exponent)]);
  return "10" + digits.map((digit) => SUPERSCRIPTS[digit]).join("");
}

/** `text` with the minus sign of mathematics. */
function withMinus(/** @type {string} */ text) {
  return text.replace(/^-/, "\u2212");
}

/** As "3·10⁻¹⁴", with so many digits. */
export function scientific(/** @type {number} */ value, digits = 1) {
  if (value === 0) return "0";
  if (!Number.isFinite(value)) return "—";
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
  return `${withMinus(mantissa)}·${powerOfTen(Number(exponent))}`;
}

/** With four significant digits, as "1.240", "−31.62" or "6.674·10⁻¹¹". */
export function significant(/** @type {number} */ value) {
  const size = Math.abs(value);
  if (value === 0) return "0";
  if (size < 1e-3 || size >= 99995) return scientific(value, 4);
  return withMinus(size >= 1000 ? value.toFixed(0) : value.toPrecision(4));
}

/** With so many decimals, and no minus before a zero. */
export function decimal(/** @type {number} */ value, /** @type {number} */ digits) {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace("-", "") : withMinus(text);
}

/** With so many decimals, or as "2.5·10⁻¹⁰" where that would be too long for an axis. */
function short(/** @type {number} */ value, /** @type {number} */ digits) {
  if (digits < 5 && Math.abs(value) < 1e5) return decimal(value, digits);
  return scientific(Math.abs(value) < 10 ** -digits / 2 ? 0 : value, 2);
}

/** A number and its unit, which a thin space keeps together. */
export function withUnit(/** @type {string} */ number, /** @type {string} */ unit) {
  return unit && number + THIN_SPACE + unit.replace(/ /g, THIN_SPACE) || number;
}

/** The smallest of 1, 2, 5 times a power of ten that is at least `size`. */
export function nice(/** @type {number} */ size) {
  const power = 10 ** Math.floor(Math.log10(size));
  const factor = [1, 2, 5].find((each) => each * power >= size * (1 - 1e-9));
  return (factor ?? 10) * power;
}

/** The multiples of a step in a range. */
function ticks(/** @type {Span} */ { low, high }, /** @type {number} */ step) {
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const values = [];
  for (let k = Math.ceil(low / step - 1e-6); k * step <= high + 1e-6 * step; k += 1) {
    values.push(k * step);
  }
  return { values, digits };
}

/** More lines of a grid than these are no help to the eye, however much room there is. */
const MOST_LINES = 12;

/** A nice step of which about `count` fit in a range. */
function niceStep(/** @type {Span} */ { low, high }, /** @type {number} */ count) {
  return nice((high - low) / Math.max(2, count));
}

/** The map of a range onto pixels. */
export function scale(
  /** @type {Span} */ { low, high }, /** @type {number} */ from, /** @type {number} */ to,
) {
  const factor = (to - from) / (high - low);
  return (/** @type {number} */ value) => from + (value - low) * factor;
}

/**
 * Tell `moved` where a finger or the mouse is, in pixels from the corner of the container, as long
 * as it is down; returns whether it is.
 *
 * @param {HTMLElement} container
 * @param {(x: number, y: number, event: PointerEvent) => void} moved
 */
export function listenToHand(container, moved) {
  let down = false;
  const tell = (/** @type {PointerEvent} */ event) => {
    const frame = container.getBoundingClientRect();
    moved(event.clientX - frame.left, event.clientY - frame.top, event);
  };
  container.addEventListener("pointerdown", (event) => {
    down = true;
    container.setPointerCapture(event.pointerId);
    tell(event);
  });
  container.addEventListener("pointermove", (event) => down && tell(event));
  for (const name of ["pointerup", "pointercancel"]) {
    container.addEventListener(name, () => (down = false));
  }
  return () => down;
}

/** Plots are drawn at most this often, in milliseconds: half as often as the scene is enough. */
const EVERY = 28;

/**
 * A canvas that fills its container, in device pixels, and is drawn anew when its size changes.
 *
 * @param {HTMLElement} container
 * @param {(sheet: Paper) => void} onto draws on an empty sheet
 */
export function createPaper(container, onto) {
  const canvas = document.createElement("canvas");
  canvas.setAttribute("role", "img");
  container.append(canvas);
  // Drawn by the processor: where there is no graphics card that is several times as fast.
  const ctx = /** @type {CanvasRenderingContext2D} */ (
    canvas.getContext("2d", { willReadFrequently: true }));
  let width = 0;
  let height = 0;
  let em = 16;
  let seen = true;
  let colours = readColours();
  // What is scrolled out of sight is not drawn.
  new IntersectionObserver((entries) => {
    const before = seen;
    seen = entries[entries.length - 1].isIntersecting;
    if (seen && !before) redraw();
  }).observe(canvas);

  new ResizeObserver(() => {
    width = canvas.clientWidth;
    height = canvas.clientHeight;
    em = parseFloat(getComputedStyle(canvas).fontSize);
    redraw();
  }).observe(canvas);

  const describe = atMostEvery(1000, (/** @type {string} */ text) => {
    canvas.setAttribute("aria-label", text);
  });

  /** Now, unless there is no room or none of it is in sight. */
  function redraw() {
    if (!seen || width === 0 || height === 0) return;
    const ratio = window.devicePixelRatio;
    const columns = Math.round(width * ratio);
    const rows = Math.round(height * ratio);
    if (canvas.width !== columns || canvas.height !== rows) {
      canvas.width = columns;
      canvas.height = rows;
    }
    ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
    ctx.clearRect(0, 0, width, height);
    ctx.lineJoin = "round";
    ctx.textBaseline = "middle";
    ctx.font = font(em);
    onto({ ctx, width, height, em, colours });
  }

  return {
    canvas,
    describe,
    redraw,
    redrawSoon: atMostEvery(EVERY, redraw),
    /** Another theme. */
    setColours(/** @type {Colours} */ next) {
      colours = next;
      redraw();
    },
  };
}

/**
 * The font of all that is written on a canvas.
 *
 * @param {number} size in pixels
 */
function font(size) {
  return `${size}px system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif`;
}

/**
 * Write text of which what follows "_" in a word is set as an index; returns its width.
 *
 * @param {Paper} paper
 * @param {string} text
 * @param {number} x
 * @param {number} y the middle of the line
 * @param {"left" | "right" | "center"} align
 */
export function write({ ctx, em }, text, x, y, align = "left") {
  const parts = text.split(/(_[^\s_]+)/).filter(Boolean).map((part) => {
    const index = part.startsWith("_");
    ctx.font = font(index ? 0.75 * em : em);
    const letters = index ? part.slice(1) : part;
    return { letters, index, width: ctx.measureText(letters).width };
  });
  const width = parts.reduce((sum, part) => sum + part.width, 0);
  let at = align === "left" ? x : align === "right" ? x - width : x - width / 2;
  for (const part of parts) {
    ctx.font = font(part.index ? 0.75 * em : em);
    ctx.fillText(part.letters, at, y + (part.index ? 0.3 * em : 0));
    at += part.width;
  }
  ctx.font = font(em);
  return width;
}

/** From now on, until `ctx.restore()`, nothing is drawn outside of the box. */
export function clipTo(
  /** @type {CanvasRenderingContext2D} */ ctx, /** @type {Box} */ { left, right, top, bottom },
) {
  ctx.save();
  ctx.beginPath();
  ctx.rect(left, top, right - left, bottom - top);
  ctx.clip();
}

/** A straight line. */
export function line(
  /** @type {CanvasRenderingContext2D} */ ctx, /** @type {number} */ x1, /** @type {number} */ y1,
  /** @type {number} */ x2, /** @type {number} */ y2,
) {
  ctx.beginPath();
  ctx.moveTo(x1, y1);
  ctx.lineTo(x2, y2);
  ctx.stroke();
}

/** Lines of a grid, or in high contrast marks, and numbers at the left of a box. */
export function drawUpAxis(
  /** @type {Paper} */ paper, /** @type {Box} */ box, /** @type {Span} */ range,
) {
  const { ctx, em, colours } = paper;
  const room = Math.min(MOST_LINES, Math.abs(box.bottom - box.top) / (1.6 * em));
  const { values, digits } = ticks(range, niceStep(range, room));
  const y = scale(range, box.bottom, box.top);
  ctx.strokeStyle = colours.rule;
  ctx.fillStyle = colours.ink;
  ctx.lineWidth = 1;
  const end = colours.highContrast ? box.left + 0.5 * em : box.right;
  line(ctx, box.left + 0.5, box.top, box.left + 0.5, box.bottom);
  for (const value of values) {
    const at = Math.round(y(value)) + 0.5;
    line(ctx, box.left, at, end, at);
    write(paper, short(value, digits), box.left - 0.5 * em, at, "right");
  }
}

/**
 * Lines of a grid, or in high contrast marks, and, where there is a label, numbers below a box with
 * the label after them.
 *
 * @param {Paper} paper @param {Box} box @param {Span} range @param {string} label
 * @param {number} step between the lines, instead of a nice one
 */
export function drawAlongAxis(paper, box, range, label, step = 0) {
  const { ctx, em, colours } = paper;
  const x = scale(range, box.left, box.right);
  const below = box.bottom + em;
  const apart = step || niceStep(range, (box.right - box.left) / (3.2 * em));
  let { values, digits } = ticks(range, apart);
  const widest = ctx.measureText(short(range.high, digits)).width;
  if (x(apart) - x(0) < widest + em) ({ values, digits } = ticks(range, nice(1.01 * apart)));
  ctx.strokeStyle = colours.rule;
  ctx.fillStyle = colours.ink;
  ctx.lineWidth = 1;
  const end = box.right - write(paper, label, box.right, below, "right") - 0.6 * em;
  const top = colours.highContrast ? box.bottom - 0.5 * em : box.top;
  line(ctx, box.left, Math.round(box.bottom) + 0.5, box.right, Math.round(box.bottom) + 0.5);
  for (const value of values) {
    const at = Math.round(x(value)) + 0.5;
    line(ctx, at, top, at, box.bottom);
    const text = short(value, digits);
    const half = ctx.measureText(text).width / 2;
    // The first is not to touch the numbers of the other axis.
    const place = Math.max(at, box.left + half - 0.4 * em);
    if (label && place + half < end) write(paper, text, place, below, "center");
  }
}

/**
 * `act`, at once where it has rested so many milliseconds, else with the last arguments when it
 * has.
 *
 * @template {unknown[]} A
 * @param {number} rest
 * @param {(...args: A) => void} act
 * @returns {(...args: A) => void}
 */
export function atMostEvery(rest, act) {
  let ready = -Infinity;
  /** @type {A | null} */
  let waiting = null;
  const run = () => {
    if (!waiting) return;
    const args = waiting;
    waiting = null;
    ready = performance.now() + rest;
    act(...args);
  };
  return (...args) => {
    const idle = waiting === null;
    waiting = args;
    if (performance.now() >= ready) run();
    else if (idle) setTimeout(run, ready - performance.now());
  };
}
