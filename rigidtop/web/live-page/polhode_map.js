/**
 * The polhodes as a control: the ellipsoid of one energy, drawn as a sphere, and ω on it to drag.
 *
 * In u_k = ω_k √(λ_k/2T) the ellipsoid is the unit sphere, and the separatrix L² = 2Tλ of the
 * intermediate moment is two great circles through its axis.
 */

import { createPaper, line, listenToHand, significant, withUnit,
  write } from "./axes.js";
import { drawDot } from "./curves.js";
import { axesByMoment, enclosedAxis, familyOf, invariants, nearestToMiddle, NEARLY_ALONG,
  polhodeOf, untilFlip } from "./polhode.js";

/** Seen from here, along the axes of the smallest, the intermediate and the largest moment. */
const FROM = unit([0.52, 0.74, 0.42]);
/** Cells of the coloured sphere, across and up. */
const CELLS = 160;
/** Polhodes that are drawn on each side: parts of the way from the separatrix to an outer axis. */
const NEIGHBOURS = [0.1, 0.3, 0.55, 0.8, 0.95];
const POINTS = 96;
/** How near the pointer has to come to the separatrix or an axis to be taken onto it (rad). */
const CATCH = 0.035;

export function createPolhodeMap(
  /** @type {HTMLElement} */ container, /** @type {(omega: number[]) => void} */ chosen,
) {
  /** @type {Motion | null} */
  let motion = null;
  /** @type {Sample | null} */
  let last = null;
  /** Rows: the unit vectors to the right, upwards and to the reader, along e₁, e₂, e₃. */
  let view = viewOf([1, 2, 3], [1, 1, 1]);
  let centre = { x: 0, y: 0, radius: 1 };
  const cells = document.createElement("canvas");
  cells.width = cells.height = CELLS;
  let made = "";

  container.classList.add("start-map");
  const paper = createPaper(container, drawOn);
  const dragging = listenToHand(container, (x, y, { shiftKey }) => {
    if (!motion) return;
    const { moments, start } = motion;
    const [right, up] = [(x - centre.x) / centre.radius, (centre.y - y) / centre.radius];
    const size = Math.max(1, Math.hypot(right, up));
    const front = Math.sqrt(Math.max(0, 1 - (right * right + up * up) / (size * size)));
    const there = [0, 1, 2].map(
      (k) => (right * view[0][k] + up * view[1][k]) / size + front * view[2][k],
    );
    const { twiceEnergy } = invariants(moments, start.omega);
    const caught = shiftKey ? there : onto(moments, there);
    chosen(caught.map((u, k) => u * Math.sqrt(twiceEnergy / moments[k])));
  });

  function drawOn(/** @type {Paper} */ sheet) {
    if (!motion || !last) return;
    const { ctx, width, height, em, colours } = sheet;
    const { moments, start } = motion;
    const radius = Math.min(width / 2 - 2 * em, height / 2 - 1.9 * em);
    centre = { x: width / 2, y: height / 2 + 0.3 * em, radius };
    const { twiceEnergy, squareL } = invariants(moments, start.omega);
    fill(moments, colours);
    ctx.drawImage(cells, centre.x - radius, centre.y - radius, 2 * radius, 2 * radius);

    const axes = axesByMoment(moments);
    const [small, , large] = axes;
    const { others, separatrix } = familyOf(moments, twiceEnergy, NEIGHBOURS, POINTS);
    for (const each of others) curve(sheet, each, colours.muted, 0.06 * em);
    for (const each of separatrix) curve(sheet, each, colours.ink, 0.14 * em);
    const apart = separatrix.length > 0;
    const k = enclosedAxis(moments, twiceEnergy, squareL);
    const side = Math.sign(start.omega[k]) || 1;
    const own = polhodeOf(moments, twiceEnergy, squareL, k, side, POINTS);
    curve(sheet, own, colours.polhode, (colours.highContrast ? 0.3 : 0.22) * em, true);
    ctx.strokeStyle = colours.muted;
    ctx.lineWidth = 1;
    ctx.beginPath();
    ctx.arc(centre.x, centre.y, radius, 0, 2 * Math.PI);
    ctx.stroke();

    const [startX, startY] = placeOf(start.omega, twiceEnergy);
    drawDot(sheet, startX, startY, colours.ink, 1.5);
    const [x, y] = placeOf(last.omega, twiceEnergy);
    drawDot(sheet, x, y, colours.omega);
    for (const i of axes) tip(sheet, i);
    if (apart) legend(sheet, small, large);
    const said = apart ? future(motion, last) : "";
    write(sheet, said, width / 2, height - 0.7 * em, "center");
    paper.describe(
      `Polhodes on the ellipsoid of this energy, with the separatrix. ω = ` +
        `${Array.from(last.omega, significant).join(", ")} goes round e${k + 1}. ` +
        `${said.replace(/_/g, "").replace(/.$/, "$&. ")}The sliders above set its start.`,
    );
  }

  /** Where ω lies on the picture, and how far to the front. */
  function placeOf(/** @type {Numbers} */ omega, /** @type {number} */ twiceEnergy) {
    const { moments } = /** @type {Motion} */ (motion);
    const scaled = [0, 1, 2].map((k) => omega[k] * Math.sqrt(moments[k] / twiceEnergy));
    const [right, up, front] = view.map((row) => dot(row, scaled));
    return /** @type {[number, number, number]} */ (
      [centre.x + centre.radius * right, centre.y - centre.radius * up, front]
    );
  }

  /** A curve on the sphere, as far as it lies in front; what is behind is dashed where asked. */
  function curve(
    /** @type {Paper} */ { ctx }, /** @type {number[][]} */ omegas,
    /** @type {string} */ colour, /** @type {number} */ wide, behind = false,
  ) {
    const { twiceEnergy } = invariants(/** @type {Motion} */ (motion).moments, omegas[0]);
    const places = omegas.map((omega) => placeOf(omega, twiceEnergy));
    ctx.strokeStyle = colour;
    for (const front of behind ? [false, true] : [true]) {
      ctx.lineWidth = front ? wide : wide / 2;
      ctx.setLineDash(front ? [] : [2 * wide, 2 * wide]);
      ctx.beginPath();
      places.forEach(([x, y, z], n) => {
        if (n > 0 && z >= 0 === front) {
          const [fromX, fromY] = places[n - 1];
          if (n === 1 || places[n - 1][2] >= 0 !== front) ctx.moveTo(fromX, fromY);
          ctx.lineTo(x, y);
        }
      });
      ctx.stroke();
    }
    ctx.setLineDash([]);
  }

  /** The sides of the separatrix in the colours of the axes that ω goes round there. */
  function fill(/** @type {Numbers} */ moments, /** @type {Colours} */ colours) {
    const now = JSON.stringify([Array.from(moments), view, colours]);
    if (now === made) return;
    made = now;
    const ctx = cells.getContext("2d");
    if (!ctx) return;
    ctx.clearRect(0, 0, CELLS, CELLS);
    const [small, middle, large] = axesByMoment(moments);
    for (let j = 0; j < CELLS; j++) {
      for (let i = 0; i < CELLS; i++) {
        const [x, y] = [(2 * i + 1) / CELLS - 1, 1 - (2 * j + 1) / CELLS];
        const front = Math.sqrt(1 - x * x - y * y);
        if (Number.isNaN(front)) continue;
        let excess = 0;
        for (let k = 0; k < 3; k++) {
          const u = x * view[0][k] + y * view[1][k] + front * view[2][k];
          excess += (moments[k] - moments[middle]) * u * u;
        }
        ctx.fillStyle = tint(colours, excess < 0 ? small : large);
        ctx.globalAlpha = (colours.highContrast ? 0.35 : 0.16) + 0.14 * front;
        ctx.fillRect(i, j, 1, 1);
      }
    }
  }

  function tint(/** @type {Colours} */ colours, /** @type {number} */ k) {
    return [colours.e1, colours.e2, colours.e3][k];
  }

  /** Where an axis comes out of the sphere towards the reader. */
  function tip(/** @type {Paper} */ sheet, /** @type {number} */ k) {
    const { ctx, em, colours } = sheet;
    const sign = view[2][k] < 0 ? -1 : 1;
    const [x, y] = [
      centre.x + sign * centre.radius * view[0][k], centre.y - sign * centre.radius * view[1][k],
    ];
    ctx.strokeStyle = tint(colours, k);
    ctx.lineWidth = 0.16 * em;
    line(ctx, x - 0.4 * em, y, x + 0.4 * em, y);
    line(ctx, x, y - 0.4 * em, x, y + 0.4 * em);
    ctx.fillStyle = colours.ink;
    write(sheet, `${sign < 0 ? "−" : ""}e_${k + 1}`, x + 0.5 * em, y - 0.7 * em);
  }

  /** What the colours and lines mean. */
  function legend(
    /** @type {Paper} */ sheet, /** @type {number} */ small, /** @type {number} */ large,
  ) {
    const { ctx, em, width, colours } = sheet;
    let at = 0.2 * em;
    for (const k of [small, large]) {
      ctx.fillStyle = tint(colours, k);
      ctx.globalAlpha = colours.highContrast ? 0.5 : 0.3;
      ctx.fillRect(at, 0.4 * em, 1.1 * em, 0.8 * em);
      ctx.globalAlpha = 1;
      ctx.fillStyle = colours.ink;
      at += 1.5 * em;
      at += write(sheet, `round e_${k + 1}`, at, 0.8 * em) + 1.2 * em;
    }
    const name = write(sheet, "separatrix", width - 0.2 * em, 0.8 * em, "right");
    ctx.strokeStyle = colours.ink;
    ctx.lineWidth = 0.14 * em;
    line(ctx, width - name - 1.8 * em, 0.8 * em, width - name - 0.6 * em, 0.8 * em);
  }

  return {
    /** Another motion; hides the map where every ω rests. */
    setMotion(/** @type {Motion} */ next) {
      const { twiceEnergy, squareL } = invariants(next.moments, next.start.omega);
      container.hidden = !(twiceEnergy > 0) ||
        enclosedAxis(next.moments, twiceEnergy, squareL) < 0;
      motion = container.hidden ? null : next;
      last = next.now;
      // While the point is dragged the sphere stays under it.
      if (motion && !dragging()) view = viewOf(next.moments, next.start.omega);
      paper.redrawSoon();
    },
    /** One frame. */
    draw(/** @type {Sample} */ sample) {
      last = sample;
      paper.redrawSoon();
    },
    setColours: paper.setColours,
  };
}

/** What ω will do next, in a few words. */
function future(/** @type {Motion} */ { moments, setup }, /** @type {Sample} */ { omega }) {
  const middle = axesByMoment(moments)[1] + 1;
  const until = untilFlip(moments, omega);
  if (!Number.isFinite(until)) return `ω_${middle} never changes its sign`;
  const flips = nearestToMiddle(moments, omega) < NEARLY_ALONG;
  const time = withUnit(significant(until), setup.clock);
  return flips ? `it turns over in ${time}: ω_${middle} = 0` : `ω_${middle} = 0 in ${time}`;
}

/** A point of the sphere, or that of an axis or the separatrix if it is near one. */
function onto(/** @type {Numbers} */ moments, /** @type {readonly number[]} */ u) {
  for (let k = 0; k < 3; k++) {
    if (Math.abs(u[k]) < Math.cos(CATCH)) continue;
    return [0, 1, 2].map((i) => (i === k ? Math.sign(u[k]) : 0));
  }
  const [small, middle, large] = axesByMoment(moments);
  const [before, behind] = [moments[middle] - moments[small], moments[large] - moments[middle]];
  if (!(before > 0 && behind > 0)) return [...u];
  for (const side of [1, -1]) {
    // The normal of one of its planes.
    const normal = [0, 0, 0];
    [normal[small], normal[large]] = unit([Math.sqrt(before), side * Math.sqrt(behind)]);
    const away = dot(normal, u);
    if (Math.abs(away) < CATCH) return unit(u.map((each, k) => each - away * normal[k]));
  }
  return [...u];
}

/** How the sphere is seen: from the side on which ω is, the axis of the largest moment upwards. */
function viewOf(/** @type {Numbers} */ moments, /** @type {Numbers} */ omega) {
  const axes = axesByMoment(moments);
  const from = [0, 0, 0];
  axes.forEach((k, n) => (from[k] = FROM[n]));
  const side = dot(from, omega) < 0 ? -1 : 1;
  const front = from.map((each) => side * each);
  const up = unit(front.map((each, k) => (k === axes[2] ? 1 : 0) - front[axes[2]] * each));
  const right = [0, 1, 2].map((k) => {
    const [i, j] = [(k + 1) % 3, (k + 2) % 3];
    return up[i] * front[j] - up[j] * front[i];
  });
  return [right, up, front];
}

function dot(/** @type {Numbers} */ a, /** @type {Numbers} */ b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function unit(/** @type {readonly number[]} */ vector) {
  const length = Math.hypot(...vector);
  return vector.map((each) => each / length);
}
