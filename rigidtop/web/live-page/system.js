/** The page of a system: its motion, moved on and drawn frame by frame, with what sets it. */

import { decimal, nice, significant } from "./axes.js";
import { createClock } from "./clock.js";
import { createPick, createSliders, element } from "./controls.js";
import { createFlow } from "./flow.js";
import { createMeter } from "./meter.js";
import { createPoints } from "./points.js";
import { createRecording } from "./recording.js";
import { createTake } from "./take.js";
import { preferredTheme, readColours, setTheme, THEMES } from "./theme.js";
import { createTimePlots, fitted, UNIT } from "./time_plots.js";
import { createTransport } from "./transport.js";

/** @typedef {import("./types").Parameter} Parameter */
/** @typedef {import("./types").SystemData} SystemData */
/** @typedef {import("./flow.js").Flow} Flow */
/** @typedef {import("./flow.js").Moment} Moment */
/** @typedef {import("./time_plots.js").Colour} Colour */

/** The first look at a motion is played in about so many seconds; the plots show so many. */
const LOOK = 20;
const WINDOW = 10;
/** Samples that say how much room the motion takes, and rows of the table. */
const AHEAD = 400;
const ROWS = 1001;
const DEGREE = 180 / Math.PI;
const TURN = Math.PI / 36;

/** @type {readonly Colour[]} */
const COLOURS = ["e3", "omega", "e1", "e2", "torque", "polhode"];

/** @type {SystemData} */
const data = JSON.parse(find("data").textContent ?? "");
const half = data.state.length / 2;
let start = [...data.start];
let values = [...data.values];
let flow = data.recording
  ? createRecording(data, data.recording)
  : createFlow(data, start, values);
const speed = playing(flow.pace);
/** Sliders of the start go as far as the motion that was given, and further. */
const parameters = [
  ...data.parameters.flatMap((each, k) => (data.tied[k] ? [] : [named(each, `p${k}`)])),
  ...data.state.flatMap((each, k) =>
    (data.bound ? [] : [named({ ...each, ...reach(k) }, `s${k}`)])),
];
let factor = 1;
let frames = 0;
let plot = "";
/** Why there is no more of the motion. */
let ended = "";

setTheme(preferredTheme());
find("title").textContent = data.title;
find("version").textContent =
  `rigidtop ${data.version}. This page ${data.recording ? "plays what was computed before it" :
    "computes everything itself"} and sends nothing.`;

const picture = find("scene");
find("about").textContent = data.about;
find("start-title").hidden = data.recording !== null;
find("more").hidden = data.recording !== null;
find("equations").innerHTML = data.equations; // written by the package, as the whole page is
const scene = createPoints(picture, readColours(), data);
/** Without points there is the motion in its phase plane. */
const portrait = data.points > 0 ? null : createTimePlots(picture, readColours(), plottedOf);
const plots = createTimePlots(find("plots"), readColours(), plottedOf);
const meter = createMeter(find("meter"));
const refused = find("refused");
const clock = createClock({ now: () => flow.now.t, go, rate: () => speed * factor, draw });
const transport = createTransport(find("transport"), {
  toStart: () => {
    flow.reset();
    ended = "";
    clock.fresh();
  },
  toggle: clock.toggle,
  step,
  setSpeed: (next) => {
    factor = next;
    clock.wake();
  },
});
const sliders = createSliders({ start: find("start"), body: find("start") }, "free", parameters,
  (wanted) => {
    const next = [...values];
    const from = [...start];
    for (const [name, value] of Object.entries(wanted)) {
      (name[0] === "p" ? next : from)[Number(name.slice(1))] = value;
    }
    try {
      flow = createFlow(data, from, next);
      [start, values] = [from, next];
      refused.textContent = "";
      begin();
    } catch (error) {
      refused.textContent = `${messageOf(error)}. The motion shown is the last possible one.`;
    }
  });
const first = Object.fromEntries(parameters.map(({ name }) =>
  [name, (name[0] === "p" ? values : start)[Number(name.slice(1))]]));
const example = /** @type {import("./types").Preset} */ (
  /** @type {unknown} */ ({ setup: { values: first } }));
sliders.show(first, "s", example);

const choices = [["q", "coordinates"], ["v", "velocities"], ["E", "energy"],
  ["phase", "phase plane"], ...(half > 1 ? [["path", "path in q"]] : [])];
createPick(find("tools"), "plotted", choices.map(([name, words]) => [name, words]), (chosen) => {
  plot = chosen;
  plots.setMotion(flow, null, plot);
  clock.wake();
}).show("q");
const themes = element("select", { "aria-label": "Theme" },
  ...THEMES.map(([name, words]) => element("option", { value: name }, words)));
themes.value = preferredTheme();
themes.addEventListener("change", () => {
  setTheme(/** @type {import("./theme.js").Theme} */ (themes.value));
  for (const each of [scene, plots, portrait]) each?.setColours(readColours());
});
createTake(find("tools"), {
  name: () => "motion",
  scene: picture,
  picture: scene.picture,
  link: null,
  table,
  say,
});
find("tools").append(themes);
find("notice").querySelector("button")?.addEventListener("click", () => {
  find("notice").hidden = true;
});
document.addEventListener("keydown", ({ key, target, ctrlKey, altKey, metaKey }) => {
  if (ctrlKey || altKey || metaKey || !(target instanceof Element)) return;
  if (target.closest("input, select, button, summary, textarea")) return;
  const arrows = target === picture && {
    ArrowLeft: () => scene.turn(-TURN, 0), ArrowRight: () => scene.turn(TURN, 0),
    ArrowUp: () => scene.turn(0, TURN), ArrowDown: () => scene.turn(0, -TURN),
  };
  const does = { ...arrows, " ": () => clock.toggle(1), "+": () => scene.zoom(1.1),
    "-": () => scene.zoom(1 / 1.1), "0": scene.home, ".": () => step(1), ",": () => step(-1) };
  const act = Object.entries(does).find(([name]) => name === key)?.[1];
  if (act) act();
});
// For tests and the curious.
Object.assign(window, { rigidtop: {
  get flow() {
    return flow;
  },
  get frames() {
    return frames;
  },
} });
begin();
clock.start(!matchMedia("(prefers-reduced-motion: reduce)").matches);

/** @param {string} id */
function find(id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found;
}

/** @param {unknown} error */
function messageOf(error) {
  return error instanceof Error ? error.message : String(error);
}

/** So fast that one can follow: as it is, where that can be. */
function playing(/** @type {number} */ pace) {
  const look = 60 * pace;
  return look > LOOK / 10 && look < 10 * LOOK ? 1 : nice(look / LOOK);
}

/**
 * @param {import("./types").Letter & import("./types").Reach} each
 * @param {string} name
 * @returns {Parameter}
 */
function named(each, name) {
  return { ...each, name, start: true };
}

/** @param {number} k */
function reach(k) {
  const most = data.state[k].angle ? Math.PI : nice(3 * flow.sizes[k]);
  return { least: -most, most, logarithmic: false };
}

/** A motion that begins. */
function begin() {
  ended = "";
  scene.setMotion(flow.ahead(LOOK * speed, AHEAD));
  plots.setMotion(flow, null, plot);
  portrait?.setMotion(flow, null, "phase");
  clock.fresh();
}

/**
 * @param {Flow} _
 * @param {string} chosen
 * @returns {import("./time_plots.js").Plotted<Moment>}
 */
function plottedOf(_, chosen) {
  const group = (/** @type {number} */ from) =>
    data.state.slice(from, from + half).map((__, k) => panel(from + k));
  const energy = line("E", ({ energy: E }) => E, "ink", significant);
  const panels = chosen === "E" ? [energy]
    : chosen === "phase" ? [panel(half), panel(0)]
    : chosen === "path" ? [panel(1), panel(0)]
    : group(chosen === "v" ? half : 0);
  const across = chosen === "phase" || chosen === "path" ? "up" : "";
  return { panels: panels.slice(0, 4), across, clock: "s", duration: WINDOW * speed, apart: null };
}

/** A component of the state; an angle in degrees. */
function panel(/** @type {number} */ k) {
  const { letter, unit, angle } = data.state[k];
  const scale = angle ? DEGREE : 1;
  const title = angle ? `${letter} in °` : unit ? `${letter} in ${unit}` : letter;
  const say = angle ? (/** @type {number} */ x) => `${decimal(x, 1)}°` : significant;
  return line(title, ({ state }) => state[k] * scale, COLOURS[k % half % COLOURS.length], say,
    scale * flow.sizes[k]);
}

/**
 * @param {string} title
 * @param {(moment: Moment) => number} of
 * @param {Colour} colour
 * @param {(value: number) => string} say
 * @param {number} [size] What is much less is drawn as if it rested.
 * @returns {import("./time_plots.js").Panel<Moment>}
 */
function line(title, of, colour, say, size = Math.abs(of(flow.start)) || 1) {
  return {
    title,
    curves: [[of, colour]],
    follow: (old, seen) => fitted(old, seen, -Infinity, Infinity, 1e-3 * size),
    guides: [],
    now: (moment) => `${title.split(" ")[0]} = ${say(of(moment))}`,
    range: UNIT,
    expected: null,
  };
}

/** @param {1 | -1} way */
function step(way) {
  clock.step((way * WINDOW * speed) / 100);
}

/** Towards t; where the motion ends it stands. */
function go(/** @type {number} */ t, /** @type {number} */ deadline) {
  try {
    ended = "";
    return flow.go(t, deadline);
  } catch (error) {
    ended = `the motion ends here: ${messageOf(error)}`;
    clock.pause();
    return true;
  }
}

function draw() {
  const { now, trail } = flow;
  if (portrait) portrait.draw({ sample: now, trail }, null);
  else scene.draw(now, trail);
  plots.draw({ sample: now, trail }, null);
  meter.draw(flow.drift());
  const said = data.state.slice(0, half).map(({ letter }, k) =>
    `${letter} = ${significant(now.state[k])}`);
  scene.describe(`The system at t = ${significant(now.t)} s: ${said.join(", ")}`);
  transport.show({
    t: now.t,
    clock: "s",
    digits: Math.min(Math.max(0, 2 - Math.floor(Math.log10(speed))), 15),
    playing: clock.playing,
    direction: clock.direction,
    factor,
    rate: speed * factor,
    note: ended || clock.note("s"),
  });
  frames += 1;
}

/** The motion from t = 0 as comma-separated values. */
function table() {
  const names = ["t (s)", ...data.state.map(({ letter }) => letter), "energy"];
  const rows = flow.ahead(Math.max(flow.now.t, WINDOW * speed), ROWS).map(
    ({ t, state, energy }) => [t, ...state.subarray(0, 2 * half), energy].join(","));
  return `${[names.join(","), ...rows].join("\r\n")}\r\n`;
}

/** @param {string} sentence */
function say(sentence) {
  const text = find("notice").querySelector("span");
  if (text) text.textContent = `${sentence}.`;
  find("notice").hidden = false;
}
