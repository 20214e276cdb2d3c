/** The page: a setup becomes a motion, and the motion is moved on and drawn frame by frame. */

import {
  createAddressBar,
  layersOf,
  readAddress,
  shapesOf,
  stateOf,
  writeAddress,
} from "./address.js";
import { createClock } from "./clock.js";
import {
  createChecks,
  createChoice,
  createPick,
  createPresets,
  createSliders,
  createVerdict,
  element,
} from "./controls.js";
import { createEquationPanel } from "./equation_panel.js";
import { factsOf } from "./facts.js";
import { ghostsOf, ghostValues } from "./ghost.js";
import { createKeys } from "./keys.js";
import { createMeter } from "./meter.js";
import { createMotion } from "./motion.js";
import { plotsOf, plottedOf } from "./plotted.js";
import { createPolhodeMap } from "./polhode_map.js";
import { createPotentialPlot } from "./potential_plot.js";
import { createPreview } from "./preview.js";
import { createRegimeMap } from "./regime_map.js";
import { createScene } from "./scene.js";
import { createTake, tableOf } from "./take.js";
import { preferredTheme, readColours, setTheme, THEMES } from "./theme.js";
import { createTimePlots } from "./time_plots.js";
import { createTour } from "./tour.js";
import { createTransport } from "./transport.js";

/** @typedef {import("./types").Facts} Facts */
/** @typedef {import("./types").Motion} Motion */
/** @typedef {import("./types").PageData} PageData */
/** @typedef {import("./types").Preset} Preset */
/** @typedef {import("./types").Sample} Sample */
/** @typedef {import("./types").Setup} Setup */
/** @typedef {import("./address.js").State} State */
/** @typedef {import("./theme.js").Theme} Theme */

/** A single step and the farthest time that an address may ask for, in times of the motion. */
const STEP = 1 / 10;
const FARTHEST = 1e5;
/** While it stands at t = 0 the page shows what is to come in so many seconds of playing. */
const PREVIEW = 12;
/** How fast a blow makes a top that stands still, in √(MgR/λ₁). */
const BLOW = 0.5;
/** How often the picture's description is told anew, in ms. */
const DESCRIPTION = 5000;
/** Where there is no room for the map over the picture, as in style.css. */
const narrow = matchMedia("(max-width: 700px), (max-width: 1000px) and (orientation: portrait)");
/** How a sentence on a ghost that there can't be begins. */
const NO_GHOST = "Nothing is beside it";

const data = pageData();
const presets = data.presets.includes(data.first) ? data.presets : [data.first, ...data.presets];
const prefersStill = matchMedia("(prefers-reduced-motion: reduce)");

/** @type {State} */
let state = stateOf(data.first);
let motion = createMotion(setupOf(state), data.tableau);
let facts = factsOf(motion);
/**
 * The same body with one setting changed.
 *
 * @type {Motion | null}
 */
let ghost = null;
/** What is asked for by the sliders and not yet tried, with the name of the one moved last. */
let asked = /** @type {{ values: Record<string, number>, name: string } | null} */ (null);
let described = -Infinity;
let frames = 0;

setTheme(preferredTheme());
find("title").textContent = data.title;
find("version").textContent =
  `rigidtop ${data.version}. This page computes everything itself and sends nothing.`;

const picture = find("scene");
const scene = sceneIn(picture);
const plots = createTimePlots(find("plots"), readColours(), plottedOf);
const potential = createPotentialPlot(find("potential"), readColours());
const map =
  data.kind === "free"
    ? createPolhodeMap(find("regimes"), readColours(), ([omega1, omega2, omega3]) => {
        sliders.setAll({ omega1, omega2, omega3 });
      })
    : createRegimeMap(find("regimes"), readColours(), (phidot, omega3) => {
        sliders.setAll({ phi_dot: phidot, omega3 });
      });
const meter = createMeter(find("meter"));
const equations = createEquationPanel(find("equations"), data.equations, (arrow) => {
  scene?.light(arrow);
});

const clock = createClock({
  now: () => motion.now.t,
  go: (t, deadline) => {
    const reached = motion.go(t, deadline);
    ghost?.go(motion.now.t);
    return reached;
  },
  rate: () => state.preset.speed * state.speed,
  before: tryAsked,
  draw,
  moved: (rests) => {
    if (rests) described = -Infinity;
    address.changed(rests);
  },
});
const preview = createPreview(
  () => {
    const duration = PREVIEW * state.preset.speed;
    const count = Math.round(Math.min(Math.max(300, (4 * duration) / motion.timescale), 3000));
    return [motion, ghost].map((each) => each?.ahead(duration, count) ?? []);
  },
  () => {
    // The scene draws the same moment again only if something was set.
    scene?.setLayers(state.layers);
    clock.wake();
  },
);
const address = createAddressBar(currentAddress);
const transport = createTransport(find("transport"), {
  toStart,
  toggle: clock.toggle,
  step,
  setSpeed: (factor) => {
    state.speed = factor;
    clock.wake();
  },
  ...(data.kind === "heavy-top" && { push }),
});
const examples = createPresets(find("presets"), presets, choosePreset);
const verdict = createVerdict(find("verdict"), (rate) => {
  sliders.setAll({ theta_dot: 0, phi_dot: rate });
});
const sliders = createSliders(
  { start: find("start"), body: find("body") },
  data.kind,
  data.parameters,
  (values, name) => {
    asked = { values, name };
    clock.wake();
  },
);
const switches = find("switches");
const layers = createChecks(switches, "Drawn", layersOf(data.kind), (chosen) => {
  state.layers = chosen;
  showLooks();
});
const view = createChoice(
  switches,
  "seen from",
  /** @type {const} */ ([["space", "space"], ["body", "the body"]]),
  (chosen) => {
    state.view = chosen;
    showLooks();
  },
);
const bodies = shapesOf(data.kind);
const shape =
  bodies.length < 2
    ? null
    : createPick(switches, "drawn as", bodies.map((name) => [name, name]), (chosen) => {
        state.shape = /** @type {import("./types").Shape} */ (chosen);
        scene?.setMotion(motion, state.shape);
        showLooks();
      });
const plotted = createPick(switches, "plotted", plotsOf(data.kind), (chosen) => {
  state.plot = chosen;
  plots.setMotion(motion, ghost, chosen);
  showLooks();
});
const ghosts = ghostsOf(data.kind);
const beside = createPick(switches, "beside it", [["", "nothing"], ...ghosts], (chosen) => {
  state.ghost = chosen;
  setGhost();
  showLooks();
});
const themes = element(
  "select",
  { "aria-label": "Theme" },
  ...THEMES.map(([name, words]) => element("option", { value: name }, words)),
);
const keys = createKeys(picture, /** @type {HTMLDialogElement} */ (find("keys")), {
  play: () => (clock.playing ? clock.pause() : clock.toggle(1)),
  backwards: () => clock.toggle(-1),
  step,
  toStart,
  push,
  zoom: (factor) => scene?.zoom(factor),
  turn: (azimuth, elevation) => scene?.turn(azimuth, elevation),
  home: () => scene?.home(),
  otherView: () => {
    state.view = state.view === "space" ? "body" : "space";
    showLooks();
  },
  preset: (index) => {
    if (index < presets.length) choosePreset(presets[index]);
  },
  present,
  tour: () => tour.start(),
});
const tour = createTour(find("tour"), data.tour, {
  show: (hash, plays) => readState(state.theme ? `${hash}&theme=${state.theme}` : hash, plays),
  end: () => {
    scene?.resize();
    starter.focus();
    clock.wake();
  },
});
const starter = element("button", { type: "button", title: "Guided tour (T)" }, "Tour");
starter.addEventListener("click", tour.start);
const keyList = element("button", { type: "button", "aria-label": "Keys", title: "Keys (?)" }, "?");
keyList.addEventListener("click", keys.help);
const screen = element("button", { type: "button", title: "Show it to a room (P)" }, "Present");
screen.addEventListener("click", present);
createTake(find("tools"), {
  name: () => `${data.kind}-${state.preset.name}`,
  scene: picture,
  picture: (finely) => scene?.picture(finely) ?? null,
  link: () => `${location.href.split("#")[0]}${currentAddress()}`,
  table: () => tableOf(motion, Math.max(motion.now.t, PREVIEW * state.preset.speed)),
  say: (sentence) => complain([sentence]),
});
find("tools").append(starter, screen, themes, keyList);
document.addEventListener("fullscreenchange", () => {
  if (!document.fullscreenElement) document.body.classList.remove("presenting");
  scene?.resize();
  clock.wake();
});

themes.addEventListener("change", () => {
  state.theme = /** @type {Theme} */ (themes.value);
  showTheme();
  address.changed();
});
for (const query of ["(prefers-color-scheme: dark)", "(prefers-contrast: more)"]) {
  matchMedia(query).addEventListener("change", showTheme);
}
narrow.addEventListener("change", placeMap);
find("corner").addEventListener("toggle", placeMap);
const notice = find("notice");
notice.querySelector("button")?.addEventListener("click", () => (notice.hidden = true));
// The address holds the state, so the link to the controls must not set it.
document.querySelector(".skip")?.addEventListener("click", (event) => {
  event.preventDefault();
  find("column").focus();
});
window.addEventListener("hashchange", () => readState(location.hash));
new ResizeObserver(() => {
  scene?.resize();
  clock.wake();
}).observe(picture);

// For tests and the curious.
Object.assign(window, {
  rigidtop: {
    get motion() {
      return motion;
    },
    get playing() {
      return clock.playing;
    },
    /** Frames drawn since the page was opened. */
    get frames() {
      return frames;
    },
  },
});
readState(location.hash);

/**
 * What Python wrote, with the first preset one of the presets if it is.
 *
 * @returns {PageData}
 */
function pageData() {
  /** @type {PageData} */
  const written = JSON.parse(find("data").textContent ?? "");
  const { first, presets: all } = written;
  return { ...written, first: all.find((preset) => preset.name === first.name) ?? first };
}

/** @param {string} id */
function find(id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found;
}

/**
 * The scene, or one sentence in its place.
 *
 * @param {HTMLElement} container
 */
function sceneIn(container) {
  try {
    return createScene(container, readColours());
  } catch (error) {
    const sentence = `${messageOf(error)} All the rest goes on without it.`;
    container.replaceChildren(element("p", { class: "absent" }, sentence));
    return null;
  }
}

/** @param {unknown} error */
function messageOf(error) {
  return error instanceof Error ? error.message : String(error);
}

/**
 * @param {State} of
 * @returns {Setup}
 */
function setupOf({ values, clock }) {
  return { kind: data.kind, clock, values };
}

/**
 * Take the state from an address.
 *
 * @param {string} hash
 * @param {boolean} [plays] whatever the address says
 */
function readState(hash, plays) {
  const { state: said, complaints } = readAddress(hash, data);
  let next = said;
  let found;
  try {
    found = createMotion(setupOf(next), data.tableau);
  } catch (error) {
    complaints.push(
      `there is no motion as the address has it: ${messageOf(error)}; ` +
        `“${next.preset.title}” is shown`,
    );
    next = { ...next, values: { ...next.preset.setup.values }, clock: next.preset.setup.clock };
    found = createMotion(setupOf(next), data.tableau);
  }
  const farthest = FARTHEST * found.timescale;
  if (next.t > farthest) {
    const most = Number(farthest.toPrecision(3));
    complaints.push(`the address says t=${next.t}, which is more than ${most}; 0 is used`);
    next = { ...next, t: 0 };
  }
  state = next;
  document.body.classList.toggle("embedded", state.embed > 0);
  document.body.classList.toggle("settable", state.embed === 2);
  placeMap();
  complain(complaints);
  const usual = plays ?? true;
  start(found, state.play ?? (usual && !prefersStill.matches));
  if (state.t > 0) clock.setGoal(state.t);
}

/** The map of starts, over a corner of the picture or, on a phone, below what it sets. */
function placeMap() {
  const corner = find("corner");
  if (narrow.matches) find("more").prepend(corner);
  else picture.after(corner);
  scene?.setAside(corner.offsetWidth > 0 && !narrow.matches && corner.hasAttribute("open"));
}

/** What is shown now, as an address. */
function currentAddress() {
  return writeAddress({ ...state, t: motion.now.t, play: clock.playing }, data);
}

/** The picture and one sentence on the whole screen, or all as it was. */
function present() {
  const shows = document.body.classList.toggle("presenting");
  if (shows) document.documentElement.requestFullscreen?.().catch(() => {});
  else if (document.fullscreenElement) document.exitFullscreen().catch(() => {});
  scene?.resize();
  clock.wake();
}

/** One line on what is wrong with the address, which the reader can send away. */
function complain(/** @type {readonly string[]} */ complaints) {
  notice.hidden = complaints.length === 0;
  if (notice.hidden) return;
  const [first] = complaints;
  const more = complaints.length > 1 ? ` (and ${complaints.length - 1} more)` : "";
  const text = notice.querySelector("span");
  if (text) text.textContent = `${first[0].toUpperCase()}${first.slice(1)}${more}.`;
}

/** Show a motion that begins, with everything that belongs to it. */
function start(/** @type {Motion} */ next, /** @type {boolean} */ plays) {
  asked = null;
  clock.start(plays);
  begin(next);
  sliders.show(state.values, state.clock, state.preset);
  showTheme();
  showLooks();
  showFacts();
}

/** @param {Motion} next */
function begin(next) {
  motion = next;
  facts = factsOf(motion);
  described = -Infinity;
  preview.forget();
  scene?.setMotion(motion, state.shape);
  setGhost();
  potential.setMotion(motion);
  map.setMotion(motion);
  clock.fresh();
}

/** The ghost that is asked for, at the time at which the motion is, if there is such a body. */
function setGhost() {
  ghost = null;
  if (notice.textContent?.startsWith(NO_GHOST)) notice.hidden = true;
  if (state.ghost) {
    const words = ghosts.find(([name]) => name === state.ghost)?.[1];
    const values = ghostValues(state.ghost, state.values, facts);
    try {
      if (!values) throw new Error("this top has no steady precession");
      ghost = createMotion(setupOf({ ...state, values }), data.tableau, motion.timescale);
      ghost.go(motion.now.t);
    } catch (error) {
      complain([`${NO_GHOST} with ${words}: ${messageOf(error)}`]);
    }
  }
  preview.forget();
  plots.setMotion(motion, ghost, state.plot);
}

/** @param {Preset} preset */
function choosePreset(preset) {
  const { theme, speed, embed, plot, ghost: ghostNow } = state;
  state = { ...stateOf(preset), theme, speed, embed, plot, ghost: ghostNow };
  start(createMotion(setupOf(state), data.tableau), clock.playing);
}

/** What the sliders ask for, if there is such a body; if not, the slider says why. */
function tryAsked() {
  if (!asked) return;
  const { values, name } = asked;
  asked = null;
  const wanted = { ...state, values };
  let found;
  try {
    found = createMotion(setupOf(wanted), data.tableau);
  } catch (error) {
    sliders.refuse(name, messageOf(error), () =>
      sliders.show(state.values, state.clock, state.preset),
    );
    return;
  }
  state = wanted;
  begin(found);
  showFacts();
  address.changed();
}

function showFacts() {
  sliders.setMarks(facts);
  verdict.show(facts, sliders.limits("phi_dot"));
  const usual = state.preset.setup.values;
  const changed = data.parameters.some(({ name }) => state.values[name] !== usual[name]);
  examples.show(state.preset, changed);
}

function showLooks() {
  scene?.setLayers(state.layers);
  scene?.setView(state.view);
  layers.show(state.layers);
  view.show(state.view);
  plotted.show(state.plot);
  beside.show(state.ghost);
  shape?.show(state.shape);
  address.changed();
  clock.wake();
}

function showTheme() {
  const theme = state.theme ?? preferredTheme();
  setTheme(theme);
  themes.value = theme;
  const colours = readColours();
  scene?.setColours(colours);
  plots.setColours(colours);
  potential.setColours(colours);
  map.setColours(colours);
  clock.wake();
}

/** A little on or back. */
function step(/** @type {1 | -1} */ way) {
  clock.step(way * STEP * motion.timescale);
}

/** Begin anew, from the start itself. */
function toStart() {
  motion.reset();
  ghost?.reset();
  described = -Infinity;
  address.changed();
  clock.fresh();
}

/** A blow on the axis, downwards: the motion goes on from where it is with more θ̇. */
function push() {
  const { theta, theta_dot, phi, phi_dot, psi, omega } = motion.now;
  if (data.kind === "free" || !Number.isFinite(phi_dot)) return;
  const blow = BLOW * Math.sqrt(Math.hypot(...Array.from(motion.weight)) / motion.moments[0]);
  const rates = { theta_dot: theta_dot + blow, phi_dot, omega3: omega[2] };
  sliders.setAll({ theta, phi, psi, ...rates });
}

/** @param {number} now */
function draw(now) {
  const sample = motion.now;
  const { ahead: [trail, ghostTrail], mirrored: [past, ghostPast] } = trailsNow();
  scene?.draw(sample, past, ghost && { sample: ghost.now, trail: ghostPast });
  plots.draw({ sample, trail }, ghost && { sample: ghost.now, trail: ghostTrail });
  potential.draw(sample);
  map.draw(sample);
  meter.draw(motion.drift());
  equations.draw(sample, motion);
  const step = STEP * motion.timescale;
  transport.show({
    t: sample.t,
    clock: state.clock,
    digits: Math.min(Math.max(2, Math.ceil(-Math.log10(step))), 6),
    playing: clock.playing,
    direction: clock.direction,
    factor: state.speed,
    rate: state.preset.speed * state.speed,
    note: clock.note(state.clock),
  });
  if (now > described + DESCRIPTION) {
    described = now;
    picture.setAttribute("aria-label", description(sample));
  }
  frames += 1;
}

/**
 * The trails of the motion and its ghost until now, for the plots and for the scene; at rest at
 * t = 0 what is to come, as soon as it is computed.
 */
function trailsNow() {
  const trails = [motion.trail, ghost?.trail ?? []];
  const usual = { ahead: trails, mirrored: trails };
  const rests = !clock.runs && motion.now.t === 0;
  if (!rests) preview.forget();
  return (rests && !asking() && preview.shown()) || usual;
}

/** Whether the tour asks what will happen: then nothing on the page tells. */
function asking() {
  return document.body.classList.contains("asking");
}

/**
 * The motion in words.
 *
 * @param {Sample} sample
 */
function description({ t, theta, phi_dot }) {
  const degrees = (/** @type {number} */ angle) =>
    `${Number(((angle * 180) / Math.PI).toFixed(1))}°`;
  const { regime, turningPoints } = asking() ? { regime: "", turningPoints: null } : facts;
  const unit = state.clock === "d" ? "day" : "second";
  const body = data.kind === "free" ? "A free body" : "A heavy top";
  const range =
    turningPoints && turningPoints[1] - turningPoints[0] > 1e-6
      ? `, θ between ${turningPoints.map(degrees).join(" and ")}`
      : "";
  const turning = Number.isFinite(phi_dot)
    ? `, φ̇ = ${Number(phi_dot.toPrecision(3))} radians a ${unit}`
    : "";
  const time = `at t = ${Number(t.toPrecision(3))} ${unit}s`;
  return (
    `${body}, ${regime || "in motion"}${range}. Now θ = ${degrees(theta)}${turning}, ${time}; ` +
    `${clock.playing ? "playing" : "paused"}.`
  );
}
