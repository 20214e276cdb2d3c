/**
 * The state of the page in its address, as in `#preset=waves&theta=20deg&t=3.5&play=0`.
 *
 * What stands there may come from anybody: only known names, plain numbers and values in range are
 * taken, and each of the others gives a sentence for the reader.
 */

import { limits, numberFrom, shown } from "./controls.js";
import { ghostsOf } from "./ghost.js";
import { THEMES } from "./theme.js";
import { plotsOf } from "./plotted.js";

/** @typedef {import("./types").PageData} PageData */
/** @typedef {import("./types").Preset} Preset */
/** @typedef {import("./types").Clock} Clock */
/** @typedef {import("./types").View} View */
/** @typedef {import("./types").Layer} Layer */
/** @typedef {import("./types").Shape} Shape */
/** @typedef {import("./theme.js").Theme} Theme */

/**
 * Everything that the address can say; `theme` and `play` are null where the reader's system
 * decides.
 *
 * @typedef {object} State
 * @property {Preset} preset
 * @property {Record<string, number>} values
 * @property {Clock} clock
 * @property {number} t
 * @property {boolean | null} play
 * @property {View} view
 * @property {Layer[]} layers
 * @property {Shape} shape
 * @property {number} speed Times the speed of the preset.
 * @property {Theme | null} theme
 * @property {string} plot
 * @property {string} ghost The change that the ghost has, or "" for none.
 * @property {0 | 1 | 2} embed For a frame: the picture and time alone (1), or with the sliders, the
 *   verdict and the equations (2).
 */

/** The slowest and the fastest that the page plays, times the preset's speed. */
export const SPEEDS = /** @type {const} */ ([0.01, 100]);

/** What can be switched on and off, with the letter or the word that names it. */
const LAYERS = /** @type {const} */ ([
  ["e1", "e₁"],
  ["e2", "e₂"],
  ["e3", "e₃"],
  ["omega", "ω"],
  ["L", "L"],
  ["torque", "torque N"],
  ["trail", "trail"],
  ["cones", "cones"],
  ["poinsot", "Poinsot"],
]);

/**
 * The layers that a page offers.
 *
 * @param {PageData["kind"]} kind
 */
export function layersOf(kind) {
  const without = kind === "free" ? "torque" : "poinsot";
  return LAYERS.filter(([name]) => name !== without);
}

/** The largest of the numbers that have no slider (rad, rad/s). */
const LARGEST = 1e4;

/**
 * The shapes that a page offers.
 *
 * @param {PageData["kind"]} kind
 * @returns {Shape[]}
 */
export function shapesOf(kind) {
  return kind === "free" ? ["brick", "wheel", "asteroid", "T-handle"] : ["top"];
}

/**
 * A preset as it stands.
 *
 * @param {Preset} preset
 * @returns {State}
 */
export function stateOf(preset) {
  return {
    preset,
    values: { ...preset.setup.values },
    clock: preset.setup.clock,
    t: 0,
    play: null,
    view: preset.view,
    layers: [...preset.layers],
    shape: preset.shape,
    speed: 1,
    theme: null,
    plot: plotsOf(preset.setup.kind)[0][0],
    ghost: "",
    embed: 0,
  };
}

/**
 * What an address says, and a sentence on each thing that could not be taken.
 *
 * @param {string} hash `location.hash`
 * @param {PageData} data
 * @returns {{ state: State, complaints: string[] }}
 */
export function readAddress(hash, data) {
  /** @type {string[]} */
  const complaints = [];
  const said = pairs(hash, complaints);
  const preset = presetNamed(said.get("preset"), data, complaints);
  said.delete("preset");
  const state = stateOf(preset);

  const values = new Map(data.parameters.map((parameter) => [parameter.name, parameter]));
  for (const [name, text] of said) {
    const parameter = values.get(name);
    if (parameter) {
      const [least, most] = limits(parameter, preset);
      const usual = preset.setup.values[name];
      const used = shown(parameter, usual, state.clock);
      const value = numberIn(name, text, least, most, parameter.angle, used, complaints);
      if (value !== null) state.values[name] = value;
    } else if (Object.prototype.hasOwnProperty.call(preset.setup.values, name)) {
      // What has no slider: θ̇₀, φ₀ and ψ₀ of a motion that was given.
      const usual = preset.setup.values[name];
      const angle = ["theta", "phi", "psi"].includes(name);
      const value = numberIn(name, text, -LARGEST, LARGEST, angle, String(usual), complaints);
      if (value !== null) state.values[name] = value;
    } else if (Object.prototype.hasOwnProperty.call(LOOKS, name)) {
      LOOKS[name](text, state, data, complaints);
    } else {
      complaints.push(`the address names “${short(name)}”, which this page does not know`);
    }
  }
  const usual = preset.setup.values;
  if (data.kind === "heavy-top" && !said.has("lambda2") && usual.lambda1 === usual.lambda2) {
    state.values.lambda2 = state.values.lambda1;
  }
  return { state, complaints };
}

/**
 * The address of a state: only what differs from its preset.
 *
 * @param {State} state
 * @param {PageData} data
 */
export function writeAddress(state, data) {
  const { preset } = state;
  const usual = preset.setup.values;
  /** @type {string[]} */
  const parts = [];
  if (data.presets.includes(preset)) parts.push(`preset=${encodeURIComponent(preset.name)}`);
  for (const { name, angle } of data.parameters) {
    const value = state.values[name];
    const follows =
      name === "lambda2" && data.kind === "heavy-top" && usual.lambda1 === usual.lambda2;
    const expected = follows ? state.values.lambda1 : usual[name];
    if (value !== expected) parts.push(`${name}=${angle ? angleText(value) : value}`);
  }
  const sliders = data.parameters.map(({ name }) => name);
  for (const [name, value] of Object.entries(state.values)) {
    if (!sliders.includes(name) && value !== usual[name]) parts.push(`${name}=${value}`);
  }
  if (state.clock !== preset.setup.clock) parts.push(`clock=${state.clock}`);
  if (state.t !== 0) parts.push(`t=${Number(state.t.toPrecision(6))}`);
  if (state.play !== null) parts.push(`play=${state.play ? 1 : 0}`);
  if (state.view !== preset.view) parts.push(`view=${state.view}`);
  if (!same(state.layers, preset.layers)) {
    parts.push(`layers=${state.layers.join(",") || "none"}`);
  }
  if (state.shape !== preset.shape) parts.push(`shape=${state.shape}`);
  if (state.speed !== 1) parts.push(`speed=${state.speed}`);
  if (state.theme !== null) parts.push(`theme=${state.theme}`);
  if (state.plot !== stateOf(preset).plot) parts.push(`plot=${state.plot}`);
  if (state.ghost) parts.push(`ghost=${state.ghost}`);
  if (state.embed) parts.push(`embed=${state.embed}`);
  return `#${parts.join("&")}`;
}

/**
 * Keeps the address in step: at most twice a second, or at once where asked.
 *
 * In a notebook's frame there is no address that could be written; then nothing happens.
 *
 * @param {() => string} hash
 */
export function createAddressBar(hash) {
  const PAUSE = 500;
  let possible = location.protocol !== "about:";
  let last = -Infinity;
  let timer = 0;

  function write() {
    clearTimeout(timer);
    timer = 0;
    last = performance.now();
    const text = hash();
    if (text === location.hash) return;
    try {
      history.replaceState(history.state, "", text);
    } catch {
      possible = false;
    }
  }
  return {
    /** Something changed. */
    changed(atOnce = false) {
      if (!possible) return;
      const wait = last + PAUSE - performance.now();
      if (atOnce) write();
      else if (!timer) timer = window.setTimeout(write, Math.max(wait, 0));
    },
  };
}

/**
 * @typedef {(text: string, state: State, data: PageData, complaints: string[]) => void} Reader
 */

/**
 * How each of the other names is read.
 *
 * @type {Record<string, Reader>}
 */
const LOOKS = {
  t(text, state, _data, complaints) {
    const value = numberIn("t", text, 0, Number.MAX_VALUE, false, "0", complaints);
    if (value !== null) state.t = value;
  },
  speed(text, state, _data, complaints) {
    const value = numberIn("speed", text, ...SPEEDS, false, "1", complaints);
    if (value !== null) state.speed = value;
  },
  play(text, state, _data, complaints) {
    const word = oneOf("play", text, ["0", "1"], null, complaints);
    if (word !== null) state.play = word === "1";
  },
  plot(text, state, data, complaints) {
    const plots = plotsOf(data.kind).map(([name]) => name);
    state.plot = oneOf("plot", text, plots, state.plot, complaints) ?? state.plot;
  },
  ghost(text, state, data, complaints) {
    const ghosts = ghostsOf(data.kind).map(([name]) => name);
    state.ghost = oneOf("ghost", text, ghosts, null, complaints) ?? "";
  },
  embed(text, state, _data, complaints) {
    const said = oneOf("embed", text, ["0", "1", "2"], null, complaints);
    state.embed = /** @type {0 | 1 | 2} */ (Number(said));
  },
  clock(text, state, data, complaints) {
    const clocks = /** @type {Clock[]} */ (data.kind === "free" ? ["s", "d"] : ["s"]);
    state.clock = oneOf("clock", text, clocks, state.clock, complaints) ?? state.clock;
  },
  view(text, state, _data, complaints) {
    const views = /** @type {View[]} */ (["space", "body"]);
    state.view = oneOf("view", text, views, state.view, complaints) ?? state.view;
  },
  shape(text, state, data, complaints) {
    const shapes = shapesOf(data.kind);
    state.shape = oneOf("shape", text, shapes, state.shape, complaints) ?? state.shape;
  },
  theme(text, state, _data, complaints) {
    const themes = THEMES.map(([name]) => name);
    state.theme = oneOf("theme", text, themes, null, complaints);
  },
  layers(text, state, data, complaints) {
    const known = layersOf(data.kind).map(([name]) => name);
    const asked = text === "none" || text === "" ? [] : text.split(",");
    for (const word of asked) oneOf("layers", word, known, null, complaints);
    state.layers = known.filter((name) => asked.includes(name));
  },
};

/**
 * The names and texts of an address, each name once.
 *
 * @param {string} hash
 * @param {string[]} complaints
 */
function pairs(hash, complaints) {
  /** @type {Map<string, string>} */
  const found = new Map();
  for (const part of hash.replace(/^#/, "").split("&")) {
    if (part === "") continue;
    const at = part.indexOf("=");
    const [name, text] = [decoded(part.slice(0, at)), decoded(part.slice(at + 1))];
    if (at < 1 || name === null || text === null) {
      complaints.push(`the address holds “${short(part)}”, which is not of the form name=value`);
    } else if (found.has(name)) {
      complaints.push(`the address sets ${short(name)} twice; the first is used`);
    } else {
      found.set(name, text);
    }
  }
  return found;
}

/** @param {string} text */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return null;
  }
}

/**
 * @param {string | undefined} name
 * @param {PageData} data
 * @param {string[]} complaints
 */
function presetNamed(name, data, complaints) {
  if (name === undefined) return data.first;
  const preset = data.presets.find((one) => one.name === name);
  if (preset) return preset;
  complaints.push(
    `the address says preset=${short(name)}, which is none of the examples; ` +
      `“${data.first.title}” is shown`,
  );
  return data.first;
}

/**
 * @param {string} name
 * @param {string} text
 * @param {number} least
 * @param {number} most
 * @param {boolean} angle
 * @param {string} used What is used instead, for the complaint.
 * @param {string[]} complaints
 */
function numberIn(name, text, least, most, angle, used, complaints) {
  const inDegrees = angle && text.endsWith("deg");
  const number = numberFrom(inDegrees ? text.slice(0, -3) : text);
  if (number === null) {
    complaints.push(
      `the address says ${name}=${short(text)}, which is not a number; ${used} is used`,
    );
    return null;
  }
  const value = inDegrees ? (number * Math.PI) / 180 : number;
  // A limit in degrees is met to rounding.
  if (value >= least - 1e-12 && value <= most + 1e-12) {
    return Math.min(Math.max(value, least), most);
  }
  const unit = angle && !inDegrees ? ` (an angle is in radians, or written ${number}deg)` : "";
  complaints.push(
    `the address says ${name}=${short(text)}, which is out of range${unit}; ${used} is used`,
  );
  return null;
}

/**
 * @template {string} T
 * @param {string} name
 * @param {string} text
 * @param {readonly T[]} known
 * @param {T | null} used
 * @param {string[]} complaints
 * @returns {T | null}
 */
function oneOf(name, text, known, used, complaints) {
  const word = known.find((one) => one === text);
  if (word !== undefined) return word;
  const instead = used === null ? "" : `; ${used} is used`;
  complaints.push(
    `the address says ${name}=${short(text)}, which is none of ${known.join(", ")}${instead}`,
  );
  return null;
}

/**
 * The shorter of degrees and radians, each exact to twelve digits.
 *
 * @param {number} value
 */
function angleText(value) {
  const degrees = `${Number(((value * 180) / Math.PI).toPrecision(12))}deg`;
  const radians = String(value);
  return degrees.length <= radians.length + 3 ? degrees : radians;
}

/**
 * Strangers' text, cut to what a line can hold.
 *
 * @param {string} text
 */
function short(text) {
  return text.length > 30 ? `${text.slice(0, 29)}…` : text;
}

/**
 * @param {readonly string[]} one
 * @param {readonly string[]} other
 */
function same(one, other) {
  return one.length === other.length && one.every((name) => other.includes(name));
}
