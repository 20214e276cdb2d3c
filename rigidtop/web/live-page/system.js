/** The page of a system: what it computes, or what was computed of it before, and its picture. */

import { decimal, nice, significant } from "./axes.js";
import { createFlow } from "./flow.js";
import { createPage } from "./page.js";
import { createPoints } from "./points.js";
import { createRecording } from "./recording.js";
import { find } from "./shell.js";
import { createTimePlots, fitted, UNIT } from "./time_plots.js";

/** The first look at a motion is played in about so many seconds; the plots show so many. */
const LOOK = 20;
const WINDOW = 10;
/** Of the table. */
const ROWS = 1001;
const DEGREE = 180 / Math.PI;
/** By how much a ghost differs. */
const LITTLE = 0.01;

/** @type {readonly Colour[]} */
const COLOURS = ["e3", "omega", "e1", "e2", "torque", "polhode"];

/** @type {SystemData} */
const written = JSON.parse(find("data").textContent ?? "");
const half = written.state.length / 2;
const [first] = written.presets;
const recorded = first.name in written.recordings;
const given = motionOf(first, first.setup.values);
const speed = playing(60 * given.timescale);
const presets = written.presets.map((preset) => ({ ...preset, speed }));
const data = { ...written, presets, first: presets[0],
  parameters: written.parameters.map((each) => ({ ...each, ...reach(each) })) };
const phase = half > 1 ? /** @type {const} */ ([["path", "path in q"]]) : [];
const equations = find("equations");
equations.innerHTML = data.written; // by the package, as the whole page is
// They scroll, also by the keyboard.
for (const [name, value] of [["tabindex", "0"], ["role", "region"], ["aria-label", "Equations"]]) {
  equations.setAttribute(name, value);
}

createPage(data, /** @type {Subject<Moment, Flow>} */ ({
  offers: {
    clock: [],
    view: [],
    shape: [],
    plot: [["q", "coordinates"], ["v", "velocities"], ["E", "energy"], ["phase", "phase plane"],
      ...phase],
    ghost: [["", "nothing"], ...(recorded
      ? presets.map(({ name, title }) => /** @type {const} */ ([name, title]))
      : data.parameters.map(({ name, letter }) => /** @type {const} */ ([name, `${letter} + 1 %`])))
    ],
    layers: [],
  },
  motionOf: ({ preset, values }, beside) => motionOf(preset, values, beside?.timescale),
  factsOf: () => ({ regime: "", turningPoints: null, smallestSpin: null, sleepingSpin: null,
    steady: null, verdict: "" }),
  ghostOf(ghost, state) {
    if (recorded) return { ...state, preset: presets.find(({ name }) => name === ghost) ?? first };
    const size = data.parameters.find(({ name }) => name === ghost)?.most ?? 1;
    const change = LITTLE * (state.values[ghost] || size / 3);
    return { ...state, values: { ...state.values, [ghost]: state.values[ghost] + change } };
  },
  plottedOf,
  pictureIn(container) {
    if (data.points > 0) return createPoints(container, data, LOOK * speed);
    // Without points there is the motion in its phase plane.
    const plots = createTimePlots(container, plottedOf);
    return {
      setMotion: (motion) => plots.setMotion(motion, null, "phase"),
      draw: (sample, trail, ghost) => plots.draw({ sample, trail }, ghost),
      setColours: plots.setColours,
      picture: () => plots.canvas,
    };
  },
  panels: () => [],
  describe: ({ now: { t, state } }) => `The system at t = ${significant(t)} s: ` +
    data.state.slice(0, half).map(({ letter }, k) => `${letter} = ${significant(state[k])}`)
      .join(", "),
  table: (motion, duration) => ({
    names: ["t (s)", ...data.state.map(({ letter }) => letter), "energy"],
    rows: motion.ahead(duration, ROWS).map(
      ({ t, state, energy }) => [t, ...state.subarray(0, 2 * half), energy]),
  }),
}));

/**
 * @param {Preset} preset
 * @param {Readonly<Record<string, number>>} values
 * @param {number} [beside]
 * @returns {Flow}
 */
function motionOf({ name }, values, beside) {
  if (recorded) return createRecording(written, written.recordings[name]);
  const numbers = (/** @type {string} */ group, /** @type {readonly number[]} */ usual) =>
    usual.map((value, k) => values[`${group}${k}`] ?? value);
  return createFlow(written, numbers("s", written.start), numbers("p", written.given), beside);
}

/** So fast that one can follow what is to be looked at: as it is, where that can be. */
function playing(/** @type {number} */ look) {
  return look > LOOK / 10 && look < 10 * LOOK ? 1 : nice(look / LOOK);
}

/** Sliders of the start go as far as the motion that was given, and further. */
function reach(/** @type {Parameter} */ { name, angle }) {
  if (name[0] !== "s" || angle) return {};
  const most = nice(3 * given.sizes[Number(name.slice(1))]);
  return { least: -most, most };
}

/** @returns {Plotted<Moment>} */
function plottedOf(/** @type {Flow} */ { start, sizes }, /** @type {string} */ chosen) {
  const group = (/** @type {number} */ from) =>
    data.state.slice(from, from + half).map((_, k) => panel(from + k, sizes[from + k]));
  const energy = () => line("E", ({ energy: E }) => E, "ink", significant, start.energy);
  const panels = chosen === "E" ? [energy()]
    : chosen === "phase" ? [half, 0].map((k) => panel(k, sizes[k]))
    : chosen === "path" ? [1, 0].map((k) => panel(k, sizes[k]))
    : group(chosen === "v" ? half : 0);
  const across = chosen === "phase" || chosen === "path" ? "up" : "";
  return { panels: panels.slice(0, 4), across, clock: "s", duration: WINDOW * speed, apart: null };
}

/** A component of the state; an angle in degrees. */
function panel(/** @type {number} */ k, /** @type {number} */ size) {
  const { letter, unit, angle } = data.state[k];
  const factor = angle ? DEGREE : 1;
  const title = angle ? `${letter} in °` : unit ? `${letter} in ${unit}` : letter;
  const say = angle ? (/** @type {number} */ x) => `${decimal(x, 1)}°` : significant;
  return line(title, ({ state }) => state[k] * factor, COLOURS[k % half % COLOURS.length], say,
    factor * size);
}

/**
 * @param {string} title
 * @param {(moment: Moment) => number} of
 * @param {Colour} colour
 * @param {(value: number) => string} say
 * @param {number} size What is much less is drawn as if it rested.
 * @returns {Graph<Moment>}
 */
function line(title, of, colour, say, size) {
  return {
    title,
    curves: [[of, colour]],
    follow: (old, seen) => fitted(old, seen, -Infinity, Infinity, 1e-3 * (Math.abs(size) || 1)),
    guides: [],
    now: (moment) => `${title.split(" ")[0]} = ${say(of(moment))}`,
    range: UNIT,
    expected: null,
  };
}
