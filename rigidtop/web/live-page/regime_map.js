/** The map of starts as a control: φ̇₀ across, ω₃ up, one point to drag. */

import { clipTo, createPaper, drawAlongAxis, drawUpAxis, listenToHand, nice, scale,
  significant, write } from "./axes.js";
import { drawDot } from "./curves.js";
import { smallestSpin, steadyRates } from "./equations.js";
import { quantities } from "./motion.js";
import { backwards } from "./regimes.js";

/** Cells of the map, across and up. */
const CELLS = /** @type {const} */ ([140, 100]);

/** How near the pointer has to come to a branch to be taken onto it, in em. */
const CATCH = 0.7;

export function createRegimeMap(
  /** @type {HTMLElement} */ container,
  /** @type {(phidot: number, omega3: number) => void} */ chosen,
) {
  /** @type {{ top: Top, theta: number, phidot: number, omega3: number, unit: string } | null} */
  let shown = null;
  /** @type {Span} */
  let across = { low: -1, high: 1 };
  /** @type {Span} */
  let up = { low: -1, high: 1 };
  /** @type {Box | null} */
  let box = null;
  let em = 16;
  /** The cells, and what they were made of. */
  const cells = document.createElement("canvas");
  [cells.width, cells.height] = CELLS;
  let made = "";

  container.classList.add("start-map");
  const paper = createPaper(container, drawOn);

  function drawOn(/** @type {Paper} */ sheet) {
    if (!shown) return;
    const { ctx, width, height } = sheet;
    em = sheet.em;
    box = { left: 3.6 * em, right: width - 0.8 * em, top: 2.2 * em, bottom: height - 1.9 * em };
    fill(shown.top, shown.theta, sheet.colours);
    ctx.imageSmoothingEnabled = true;
    ctx.drawImage(cells, box.left, box.top, box.right - box.left, box.bottom - box.top);
    drawAlongAxis(sheet, box, across, `φ̇₀ in ${shown.unit}`);
    drawUpAxis(sheet, box, up);
    write(sheet, width > 24 * em ? `ω₃ in ${shown.unit}` : "ω₃", 0.2 * em, 0.9 * em);
    key(sheet, box.right, 0.9 * em);
    branches(sheet, box);
    const [x, y] = [scale(across, box.left, box.right), scale(up, box.bottom, box.top)];
    drawDot(sheet, x(shown.phidot), y(shown.omega3), sheet.colours.ink, 1.4);
    paper.describe(
      `Motions by their start: loops where the map is coloured, waves elsewhere, cusps between. ` +
        `Now φ̇₀ = ${significant(shown.phidot)} and ω₃ = ${significant(shown.omega3)} ` +
        `${shown.unit}. The sliders above set the same.`,
    );
  }

  /** The cells where e₃ draws loops, if they are not drawn yet. */
  function fill(
    /** @type {Top} */ top, /** @type {number} */ theta,
    /** @type {Colours} */ colours,
  ) {
    const now = JSON.stringify([top, theta, across, up, colours.trail]);
    if (now === made) return;
    made = now;
    const ctx = cells.getContext("2d");
    if (!ctx) return;
    ctx.clearRect(0, 0, ...CELLS);
    ctx.fillStyle = colours.trail;
    ctx.globalAlpha = colours.highContrast ? 0.6 : 0.35;
    const [columns, rows] = CELLS;
    for (let j = 0; j < rows; j++) {
      const omega3 = up.high - ((j + 0.5) / rows) * (up.high - up.low);
      for (let i = 0; i < columns; i++) {
        const phidot = across.low + ((i + 0.5) / columns) * (across.high - across.low);
        if (backwards(top, theta, phidot, omega3) < 0) ctx.fillRect(i, j, 1, 1);
      }
    }
  }

  /** What the colours and lines mean, written from the right. */
  function key(
    /** @type {Paper} */ sheet, /** @type {number} */ right, /** @type {number} */ y,
  ) {
    const { ctx, colours } = sheet;
    const names = /** @type {const} */ ([
      ["loops", colours.trail], ["waves", colours.paper], ["Ω₊", colours.omega],
      ["Ω₋", colours.e3],
    ]);
    let at = right;
    for (const [name, colour] of names) {
      at -= write(sheet, name, at, y, "right") + 0.4 * em;
      ctx.fillStyle = colour;
      ctx.globalAlpha = name === "loops" && !colours.highContrast ? 0.5 : 1;
      const height = name.startsWith("Ω") ? 0.25 * em : 0.8 * em;
      ctx.fillRect(at - 1.1 * em, y - height / 2, 1.1 * em, height);
      ctx.globalAlpha = 1;
      ctx.strokeStyle = colours.muted;
      if (!name.startsWith("Ω")) ctx.strokeRect(at - 1.1 * em, y - height / 2, 1.1 * em, height);
      ctx.fillStyle = colours.ink;
      at -= 2.1 * em;
    }
  }

  /** Ω₋ and Ω₊ against ω₃, as far as there are any. */
  function branches(/** @type {Paper} */ { ctx, colours }, /** @type {Box} */ place) {
    const x = scale(across, place.left, place.right);
    const y = scale(up, place.bottom, place.top);
    clipTo(ctx, place);
    ctx.lineWidth = (colours.highContrast ? 0.22 : 0.15) * em;
    for (const k of [0, 1]) {
      for (const side of [1, -1]) {
        ctx.strokeStyle = k === 0 ? colours.e3 : colours.omega;
        ctx.beginPath();
        for (const spin of spins()) {
          const rate = steady(spin)[k];
          if (Number.isFinite(rate)) ctx.lineTo(x(side * rate), y(side * spin));
        }
        ctx.stroke();
      }
    }
    ctx.restore();
  }

  /** Spins from the least with a steady precession up, closer where the branches turn. */
  function spins() {
    if (!shown) return [];
    const { top, theta } = shown;
    const least = Math.cos(theta) > 0 ? smallestSpin({ ...top, theta }) : 0;
    const most = Math.max(up.high, -up.low);
    const from = least * (1 + 1e-12) || 1e-3 * most;
    return Array.from({ length: 161 }, (_, k) => from + (most - from) * (k / 160) ** 2);
  }

  /** Ω₋ and Ω₊ at a positive spin. */
  function steady(/** @type {number} */ omega3) {
    return shown ? steadyRates({ ...shown.top, theta: shown.theta, omega3 }) : [NaN, NaN];
  }

  /** Where the pointer is, on a branch if it is near one. */
  const dragging = listenToHand(container, (atX, atY, { shiftKey }) => {
    if (!box || !shown) return;
    const clip = (/** @type {number} */ value, /** @type {Span} */ { low, high }) =>
      Math.min(Math.max(value, low), high);
    const x = scale({ low: box.left, high: box.right }, across.low, across.high);
    const y = scale({ low: box.bottom, high: box.top }, up.low, up.high);
    const omega3 = Number(clip(y(atY), up).toPrecision(3));
    let phidot = Number(clip(x(atX), across).toPrecision(3));
    const reach = (CATCH * em * (across.high - across.low)) / (box.right - box.left);
    const side = omega3 < 0 ? -1 : 1;
    const marks = [0, ...steady(Math.abs(omega3)).map((rate) => side * rate)]
      .filter((rate) => Number.isFinite(rate) && Math.abs(rate - phidot) < reach)
      .sort((one, other) => Math.abs(one - phidot) - Math.abs(other - phidot));
    if (!shiftKey && marks.length > 0) [phidot] = marks;
    chosen(phidot, omega3);
  });

  return {
    /** Another motion; hides the map where θ₀ does not rest on a tilted symmetric top. */
    setMotion(/** @type {Motion} */ motion) {
      const { setup, start, symmetric } = motion;
      const tilted = Math.sin(start.theta) > 1e-6;
      const { M, R, g, lambda1, lambda3, phidot, omega3, theta } = quantities(start, motion);
      container.hidden = !(
        setup.kind !== "free" && symmetric && tilted && start.theta_dot === 0 && M * R * g > 0
      );
      shown = container.hidden
        ? null
        : { top: { M, R, g, lambda1, lambda3 }, theta, phidot, omega3, unit: `rad/${setup.clock}` };
      // While the point is dragged the map stays under it.
      if (shown && !dragging()) fit();
      paper.redrawSoon();
    },
    /** One frame: the start stays where it is. */
    draw() {},
    setColours: paper.setColours,
  };

  /** Ranges that hold the point, the least spin and both branches at the spin of the point. */
  function fit() {
    if (!shown) return;
    const { top, theta, phidot, omega3 } = shown;
    const least = smallestSpin({ ...top, theta: Math.min(theta, Math.PI - theta) });
    const spin = Math.max(Math.abs(omega3), 1.2 * least);
    const rates = steady(spin).filter((rate) => Math.abs(rate) < 20 * spin).map(Math.abs);
    const height = nice(1.1 * spin);
    const width = nice(1.15 * Math.max(Math.abs(phidot), ...rates));
    [up, across] = [{ low: -height, high: height }, { low: -width, high: width }];
  }
}
