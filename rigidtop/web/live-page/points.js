/** The picture of a system: its points with their trails, rods, and the axes of its bodies. */

import { createPaper, line, listenToHand, write } from "./axes.js";

/** @typedef {import("./types").Colours} Colours */
/** @typedef {import("./types").SystemData} SystemData */
/** @typedef {import("./flow.js").Moment} Moment */

/** Where one looks from at first, as at a top. */
const HOME = { azimuth: 0.6, elevation: 0.36, zoom: 1 };
/** Radians for each pixel that a hand moves. */
const TURN = 0.008;
/** What keeps its distance to this part of it is joined by a rod. */
const RIGID = 1e-6;
/** The part of half the picture that things fill, and the length of a body's axes. */
const FILLED = 0.82;
const ALONG = 0.3;
/** Of the trail, so many samples are seen. */
const TRAIL = 1200;

const COLOURS = /** @type {const} */ (["e3", "omega", "e1", "e2", "torque", "polhode"]);
const AXES = /** @type {const} */ (["e1", "e2", "e3"]);

/**
 * @param {HTMLElement} container
 * @param {Colours} colours
 * @param {SystemData} data
 */
export function createPoints(container, colours, { points: count, bodies, planar, follow }) {
  let { azimuth, elevation, zoom } = HOME;
  /** @type {[Moment, readonly Moment[]] | null} */
  let last = null;
  /** @type {[number, number][]} Points that are joined; −1 is the origin. */
  let rods = [];
  let reach = 1;
  let along = ALONG;
  const paper = createPaper(container, redraw);
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
    redraw();
  }

  function zoomBy(/** @type {number} */ factor) {
    zoom = Math.max(0.2, Math.min(20, zoom * factor));
    redraw();
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

  function redraw() {
    const sheet = last && paper.clear();
    if (!last || !sheet) return;
    const [now, trail] = last;
    const { ctx, width, height, em } = sheet;
    const [middleX, middleY] = [0, 1].map((k) =>
      follow === null ? 0 : now.points[3 * follow + k]);
    const size = (FILLED * zoom * Math.min(width, height)) / 2 / reach;
    /** @returns {[number, number]} */
    const place = (/** @type {ArrayLike<number>} */ at, from = 0) => {
      const [x, y] = seen([at[from] - middleX, at[from + 1] - middleY, at[from + 2]]);
      return [width / 2 + size * x, height / 2 - size * y];
    };
    const thick = (colours.highContrast ? 1.5 : 1) * em;
    drawAxes(sheet, (end) => place([end[0] + middleX, end[1] + middleY, end[2]]));
    const past = trail.slice(-TRAIL);
    for (let k = 0; k < count; k++) {
      ctx.strokeStyle = colourOf(k);
      ctx.lineWidth = 0.09 * thick;
      // The older half fades.
      for (const [part, alpha] of /** @type {const} */ ([[0, 0.3], [0.5, 0.75]])) {
        ctx.globalAlpha = colours.highContrast ? 1 : alpha;
        ctx.beginPath();
        const from = Math.floor(part * past.length);
        for (const each of past.slice(from, part ? past.length : past.length / 2 + 1)) {
          ctx.lineTo(...place(each.points, 3 * k));
        }
        if (part && trail.length > 0 && trail[trail.length - 1].t <= now.t) {
          ctx.lineTo(...place(now.points, 3 * k));
        }
        ctx.stroke();
      }
    }
    ctx.globalAlpha = 1;
    ctx.strokeStyle = colours.ink;
    ctx.lineWidth = 0.14 * thick;
    for (const [from, to] of rods) {
      line(ctx, ...place(from < 0 ? [0, 0, 0] : now.points, 3 * Math.max(from, 0)),
        ...place(now.points, 3 * to));
    }
    const order = Array.from({ length: count }, (_, k) => k).sort((a, b) =>
      seen(now.points, 3 * a)[2] - seen(now.points, 3 * b)[2]);
    for (const k of order) {
      const body = bodies.indexOf(k);
      if (body >= 0) drawBody(sheet, place, now.points, k, 3 * count + 9 * body);
      ctx.beginPath();
      ctx.arc(...place(now.points, 3 * k), (body < 0 ? 0.55 : 0.25) * thick, 0, 2 * Math.PI);
      ctx.fillStyle = colourOf(k);
      ctx.fill();
      ctx.strokeStyle = colours.paper;
      ctx.lineWidth = 1.5;
      ctx.stroke();
    }
  }

  /** e₁, e₂, e₃ of a body from where it is. */
  function drawBody(
    /** @type {import("./axes.js").Paper} */ sheet,
    /** @type {(at: ArrayLike<number>, from?: number) => [number, number]} */ place,
    /** @type {Float64Array} */ all, /** @type {number} */ point, /** @type {number} */ matrix,
  ) {
    const centre = all.subarray(3 * point, 3 * point + 3);
    AXES.forEach((name, axis) => {
      const tip = centre.map((x, row) => x + along * reach * all[matrix + 3 * row + axis]);
      sheet.ctx.strokeStyle = sheet.ctx.fillStyle = colours[name];
      sheet.ctx.lineWidth = 0.2 * sheet.em;
      line(sheet.ctx, ...place(centre), ...place(tip));
      const [x, y] = place(centre.map((from, k) => from + 1.12 * (tip[k] - from)));
      write(sheet, `e_${axis + 1}`, x, y, "center");
    });
  }

  /** x, y and z, thin, with the origin. */
  function drawAxes(
    /** @type {import("./axes.js").Paper} */ sheet,
    /** @type {(at: ArrayLike<number>) => [number, number]} */ place,
  ) {
    const { ctx } = sheet;
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

  function colourOf(/** @type {number} */ k) {
    return colours[COLOURS[k % COLOURS.length]];
  }

  return {
    /** What is to come says how much room it takes, and what is rigid. */
    setMotion(/** @type {readonly Moment[]} */ ahead) {
      const finite = ahead.filter(({ points }) => points.every(Number.isFinite));
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
    draw(/** @type {Moment} */ now, /** @type {readonly Moment[]} */ trail) {
      last = [now, trail];
      redraw();
    },
    setColours(/** @type {Colours} */ next) {
      colours = next;
      redraw();
    },
    turn,
    zoom: zoomBy,
    home() {
      ({ azimuth, elevation, zoom } = HOME);
      redraw();
    },
    /** The canvas with the picture in it. */
    picture: () => container.querySelector("canvas"),
    describe: paper.describe,
  };
}
