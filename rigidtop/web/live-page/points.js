/** The picture of a system: its points with their trails, rods, and the axes of its bodies. */

import { createPaper, line, listenToHand, write } from "./axes.js";

/** @typedef {(at: ArrayLike<number>, from?: number) => [number, number]} Place */

/** Where one looks from at first, as at a top. */
const HOME = { azimuth: 0.6, elevation: 0.36, zoom: 1 };
/** Radians for each pixel that a hand moves. */
const TURN = 0.008;
/** What keeps its distance to this part of it is joined by a rod. */
const RIGID = 1e-6;
/** The part of half the picture that things fill, and the length of a body's axes. */
const FILLED = 0.82;
const ALONG = 0.3;
/** Of the trail, so many samples are seen, and of what is to come so many are looked at. */
const TRAIL = 1200;
const AHEAD = 400;

const COLOURS = /** @type {const} */ (["e3", "omega", "e1", "e2", "torque", "polhode"]);
const AXES = /** @type {const} */ (["e1", "e2", "e3"]);

/**
 * @param {HTMLElement} container
 * @param {SystemData} data
 * @param {number} look How much of the motion says what room it takes (s).
 * @returns {Picture<Moment, Flow>}
 */
export function createPoints(container, { points: count, bodies, planar, follow }, look) {
  let { azimuth, elevation, zoom } = HOME;
  /** @type {Past<Moment> | null} */
  let last = null;
  /** @type {Past<Moment> | null} */
  let ghost = null;
  /** @type {[number, number][]} Points that are joined; −1 is the origin. */
  let rods = [];
  let reach = 1;
  let along = ALONG;
  container.classList.add("points");
  const paper = createPaper(container, drawOn);
  // The container says what is seen.
  paper.canvas.setAttribute("aria-hidden", "true");
  let hand = /** @type {[number, number] | null} */ (null);
  const held = listenToHand(container, (x, y) => {
    if (hand && held()) turn((hand[0] - x) * TURN, (y - hand[1]) * TURN);
    hand = [x, y];
  });
  container.addEventListener("pointerup", () => (hand = null));
  container.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoomBy(Math.exp(-event.deltaY / 600));
  }, { passive: false });

  function turn(/** @type {number} */ around, /** @type {number} */ up) {
    if (planar) return;
    azimuth += around;
    elevation = Math.max(-1.55, Math.min(1.55, elevation + up));
    paper.redraw();
  }

  function zoomBy(/** @type {number} */ factor) {
    zoom = Math.max(0.2, Math.min(20, zoom * factor));
    paper.redraw();
  }

  /** x to the right, y upwards and the depth of a place, in units of length. */
  function seen(/** @type {ArrayLike<number>} */ at, from = 0) {
    const [x, y, z] = [at[from], at[from + 1], at[from + 2]];
    if (planar) return [x, y, 0];
    const [c, s] = [Math.cos(azimuth), Math.sin(azimuth)];
    const [up, level] = [Math.sin(elevation), Math.cos(elevation)];
    const near = x * c + y * s;
    return [y * c - x * s, z * level - near * up, near * level + z * up];
  }

  function drawOn(/** @type {Paper} */ sheet) {
    if (!last) return;
    const { ctx, width, height, colours } = sheet;
    const { points } = last.sample;
    const [middleX, middleY] = [0, 1].map((k) => (follow === null ? 0 : points[3 * follow + k]));
    const size = (FILLED * zoom * Math.min(width, height)) / 2 / reach;
    /** @type {Place} */
    const place = (at, from = 0) => {
      const [x, y] = seen([at[from] - middleX, at[from + 1] - middleY, at[from + 2]]);
      return [width / 2 + size * x, height / 2 - size * y];
    };
    drawAxes(sheet, (end) => place([end[0] + middleX, end[1] + middleY, end[2]]));
    if (ghost) drawMotion(sheet, place, ghost, () => colours.muted);
    drawMotion(sheet, place, last, (k) => colours[COLOURS[k % COLOURS.length]]);
    ctx.globalAlpha = 1;
  }

  /** The trails, then rods and points, and the axes of bodies. */
  function drawMotion(
    /** @type {Paper} */ sheet, /** @type {Place} */ place,
    /** @type {Past<Moment>} */ { sample, trail }, /** @type {(k: number) => string} */ colourOf,
  ) {
    const { ctx, em, colours } = sheet;
    const { points, t } = sample;
    const thick = (colours.highContrast ? 1.5 : 1) * em;
    const shown = trail.slice(-TRAIL);
    const toCome = shown.length > 0 && shown[shown.length - 1].t > t;
    for (let k = 0; k < count; k++) {
      ctx.strokeStyle = colourOf(k);
      ctx.lineWidth = 0.09 * thick;
      // The older half fades.
      for (const [part, alpha] of /** @type {const} */ ([[0, 0.3], [0.5, 0.75]])) {
        ctx.globalAlpha = colours.highContrast ? 1 : alpha;
        ctx.beginPath();
        const from = Math.floor(part * shown.length);
        for (const each of shown.slice(from, part ? shown.length : shown.length / 2 + 1)) {
          ctx.lineTo(...place(each.points, 3 * k));
        }
        if (part && !toCome) ctx.lineTo(...place(points, 3 * k));
        ctx.stroke();
      }
    }
    ctx.globalAlpha = 1;
    ctx.strokeStyle = sample === last?.sample ? colours.ink : colours.muted;
    ctx.lineWidth = 0.14 * thick;
    for (const [from, to] of rods) {
      line(ctx, ...place(from < 0 ? [0, 0, 0] : points, 3 * Math.max(from, 0)),
        ...place(points, 3 * to));
    }
    const order = Array.from({ length: count }, (_, k) => k).sort((a, b) =>
      seen(points, 3 * a)[2] - seen(points, 3 * b)[2]);
    for (const k of order) {
      const body = bodies.indexOf(k);
      if (body >= 0) drawBody(sheet, place, points, k, 3 * count + 9 * body);
      ctx.beginPath();
      ctx.arc(...place(points, 3 * k), (body < 0 ? 0.55 : 0.25) * thick, 0, 2 * Math.PI);
      ctx.fillStyle = colourOf(k);
      ctx.fill();
      ctx.strokeStyle = colours.paper;
      ctx.lineWidth = 1.5;
      ctx.stroke();
    }
  }

  /** e₁, e₂, e₃ of a body from where it is; of the second with a prime, and so on. */
  function drawBody(
    /** @type {Paper} */ sheet, /** @type {Place} */ place, /** @type {Float64Array} */ all,
    /** @type {number} */ point, /** @type {number} */ matrix,
  ) {
    const centre = all.subarray(3 * point, 3 * point + 3);
    const { em, width, height } = sheet;
    const body = bodies.indexOf(point);
    const within = (/** @type {number} */ at, /** @type {number} */ size) =>
      Math.max(0.8 * em, Math.min(size - 0.8 * em, at));
    AXES.forEach((name, axis) => {
      const tip = centre.map((x, row) => x + along * reach * all[matrix + 3 * row + axis]);
      sheet.ctx.strokeStyle = sheet.ctx.fillStyle = sheet.colours[name];
      sheet.ctx.lineWidth = 0.2 * em;
      line(sheet.ctx, ...place(centre), ...place(tip));
      const [x, y] = place(centre.map((from, k) => from + (1.12 + 0.2 * body) * (tip[k] - from)));
      const letter = `e${"′".repeat(body)}_${axis + 1}`;
      write(sheet, letter, within(x, width), within(y, height), "center");
    });
  }

  /** x, y and z, thin, with the origin. */
  function drawAxes(/** @type {Paper} */ sheet, /** @type {Place} */ place) {
    const { ctx, colours } = sheet;
    ctx.strokeStyle = colours.rule;
    ctx.fillStyle = colours.muted;
    ctx.lineWidth = 1;
    ["x", "y", "z"].slice(0, planar ? 2 : 3).forEach((name, k) => {
      const end = [0, 0, 0];
      end[k] = 1.08 * reach;
      line(ctx, ...place(planar ? end.map((x) => -x) : [0, 0, 0]), ...place(end));
      const [x, y] = place(end.map((each) => 1.05 * each));
      write(sheet, name, x, y, "center");
    });
  }

  return {
    /** What is to come says how much room it takes, and what is rigid. */
    setMotion(motion) {
      const finite = motion.ahead(look, AHEAD)
        .filter(({ points }) => points.every(Number.isFinite));
      const extent = Math.max(0, ...finite.map(({ points }) =>
        Math.max(...points.subarray(0, 3 * count).map((x, k) =>
          Math.abs(follow === null || k % 3 === 2 ? x : x - points[3 * follow + (k % 3)])))));
      // A body that turns about a fixed point is all there is.
      [reach, along] = extent > 0 ? [extent, ALONG] : [1, 1];
      rods = [];
      for (let k = 0; k < count; k++) {
        const far = finite.map(({ points }) =>
          Math.hypot(...[0, 1, 2].map((i) =>
            points[3 * k + i] - (k > 0 ? points[3 * k - 3 + i] : 0))));
        const [least, most] = [Math.min(...far), Math.max(...far)];
        if (most > 1e-12 * reach && most - least < RIGID * most) rods.push([k - 1, k]);
      }
    },
    draw(sample, trail, beside) {
      [last, ghost] = [{ sample, trail }, beside];
      paper.redraw();
    },
    setColours: paper.setColours,
    turn,
    zoom: zoomBy,
    home() {
      ({ azimuth, elevation, zoom } = HOME);
      paper.redraw();
    },
    picture: () => paper.canvas,
  };
}
