/**
 * The state of the page in its address, as in `#preset=waves&theta=20deg&t=3.5&play=0`.
 *
 * What stands there may come from anybody: only known names, plain numbers and values in range are
 * taken, and each of the others gives a sentence for the reader.
 */

import { limits, numberFrom, shown } from "./controls.js";
import { THEMES } from "./theme.js";

/** The slowest and the fastest that the page plays, times the preset's speed. */
const SPEEDS = /** @type {const} */ ([0.01, 100]);

/** The largest of the numbers that have no slider (rad, rad/s). */
const LARGEST = 1e4;

/** The names of the state that are one of a few words, and those that are numbers. */
const WORDS = /** @type {const} */ (
  ["clock", "play", "view", "shape", "theme", "plot", "ghost", "embed"]);
const NUMBERS = /** @type {const} */ ({ t: [0, Number.MAX_VALUE], speed: SPEEDS });

/** The addresses of a page. */
export function createAddresses(/** @type {PageData} */ data, /** @type {Offers} */ offers) {
  /** @type {Record<typeof WORDS[number], readonly string[]>} */
  const known = {
    clock: names(offers.clock),
    play: ["0", "1"],
    view: names(offers.view),
    shape: names(offers.shape),
    theme: names(THEMES),
    plot: names(offers.plot),
    ghost: names(offers.ghost),
    embed: ["0", "1", "2"],
  };
  const sliders = new Map(data.parameters.map((parameter) => [parameter.name, parameter]));

  /**
   * A preset as it stands.
   *
   * @returns {State}
   */
  function stateOf(/** @type {Preset} */ preset) {
    return {
      preset,
      values: { ...preset.setup.values },
      clock: preset.setup.clock,
      t: 0,
      play: "",
      view: preset.view,
      layers: [...preset.layers],
      shape: preset.shape,
      speed: 1,
      theme: "",
      plot: known.plot[0],
      ghost: "",
      embed: "0",
    };
  }

  /** Whether λ₂ goes with λ₁ unless it is set itself: of a preset that is a symmetric top. */
  function follows(/** @type {Preset} */ { setup: { kind, values } }) {
    return kind === "heavy-top" && values.lambda1 === values.lambda2;
  }

  /**
   * What an address says, and a sentence on each thing that could not be taken.
   *
   * @param {string} hash `location.hash`
   * @returns {{ state: State, complaints: string[] }}
   */
  function read(hash) {
    /** @type {string[]} */
    const complaints = [];
    const said = pairs(hash, complaints);
    const preset = presetNamed(said.get("preset"), data, complaints);
    said.delete("preset");
    const begun = stateOf(preset);
    const { values } = begun;
    /** @type {Record<string, unknown>} */
    const state = { ...begun };
    const usual = preset.setup.values;

    for (const [name, text] of said) {
      const parameter = sliders.get(name);
      const word = WORDS.find((each) => each === name && known[each].length > 0);
      if (parameter) {
        const [least, most] = limits(parameter, preset);
        const used = shown(parameter, usual[name], begun.clock);
        values[name] = numberIn(name, text, least, most, parameter.angle, used, complaints)
          ?? values[name];
      } else if (Object.hasOwn(usual, name)) {
        // What has no slider: θ̇₀, φ₀ and ψ₀ of a motion that was given.
        const angle = ["theta", "phi", "psi"].includes(name);
        const used = String(usual[name]);
        values[name] = numberIn(name, text, -LARGEST, LARGEST, angle, used, complaints)
          ?? values[name];
      } else if (word) {
        state[word] = oneOf(word, text, known[word], state[word], complaints) ?? state[word];
      } else if (Object.hasOwn(NUMBERS, name)) {
        const [least, most] = NUMBERS[/** @type {keyof typeof NUMBERS} */ (name)];
        state[name] = numberIn(name, text, least, most, false, String(state[name]), complaints)
          ?? state[name];
      } else if (name === "layers" && offers.layers.length > 0) {
        const layers = offers.layers.map(([each]) => each);
        const asked = text === "none" || text === "" ? [] : text.split(",");
        for (const each of asked) oneOf("layers", each, layers, "", complaints);
        state.layers = layers.filter((each) => asked.includes(each));
      } else {
        complaints.push(`the address names “${short(name)}”, which this page does not know`);
      }
    }
    if (follows(preset) && !said.has("lambda2")) values.lambda2 = values.lambda1;
    return { state: /** @type {State} */ (/** @type {unknown} */ (state)), complaints };
  }

  /** The address of a state: only what differs from its preset. */
  function write(/** @type {State} */ state) {
    const { preset, values } = state;
    const usual = stateOf(preset);
    /** @type {string[]} */
    const parts = [];
    if (data.presets.includes(preset)) parts.push(`preset=${encodeURIComponent(preset.name)}`);
    for (const [name, value] of Object.entries(values)) {
      const follower = name === "lambda2" && follows(preset);
      if (value === (follower ? values.lambda1 : usual.values[name])) continue;
      parts.push(`${name}=${sliders.get(name)?.angle ? angleText(value) : value}`);
    }
    if (state.t !== 0) parts.push(`t=${Number(state.t.toPrecision(6))}`);
    if (state.speed !== 1) parts.push(`speed=${state.speed}`);
    if (!same(state.layers, preset.layers)) {
      parts.push(`layers=${state.layers.join(",") || "none"}`);
    }
    for (const name of WORDS) {
      if (state[name] !== usual[name]) parts.push(`${name}=${state[name]}`);
    }
    return `#${parts.join("&")}`;
  }
  return { stateOf, read, write };
}

/**
 * Keeps the address in step: at most twice a second.
 *
 * In a notebook's frame there is no address that could be written; then nothing happens.
 */
export function createAddressBar(/** @type {() => string} */ hash) {
  const PAUSE = 500;
  let possible = location.protocol !== "about:";
  let last = -Infinity;
  let timer = 0;

  function write() {
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
    changed() {
      if (!possible || timer) return;
      timer = window.setTimeout(write, Math.max(last + PAUSE - performance.now(), 0));
    },
  };
}

/** The names and texts of an address, each name once. */
function pairs(/** @type {string} */ hash, /** @type {string[]} */ complaints) {
  /** @type {Map<string, string>} */
  const found = new Map();
  // A plus is that of a number, no blank.
  const said = new URLSearchParams(hash.replace(/^#/, "").replaceAll("+", "%2B"));
  for (const [name, text] of said) {
    if (!found.has(name)) found.set(name, text);
    else complaints.push(`the address sets ${short(name)} twice; the first is used`);
  }
  return found;
}

function presetNamed(
  /** @type {string | undefined} */ name, /** @type {PageData} */ data,
  /** @type {string[]} */ complaints,
) {
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
 * @param {string} name
 * @param {string} text
 * @param {readonly string[]} known
 * @param {unknown} used What is used instead, "" for nothing.
 * @param {string[]} complaints
 */
function oneOf(name, text, known, used, complaints) {
  if (known.includes(text)) return text;
  const instead = used === "" ? "" : `; ${used} is used`;
  complaints.push(
    `the address says ${name}=${short(text)}, which is none of ${known.join(", ")}${instead}`,
  );
  return null;
}

/** The shorter of degrees and radians, each exact to twelve digits. */
function angleText(/** @type {number} */ value) {
  const degrees = `${Number(((value * 180) / Math.PI).toPrecision(12))}deg`;
  const radians = String(value);
  return degrees.length <= radians.length + 3 ? degrees : radians;
}

/** Strangers' text, cut to what a line can hold. */
function short(/** @type {string} */ text) {
  return text.length > 30 ? `${text.slice(0, 29)}…` : text;
}

function names(/** @type {Choices} */ choices) {
  return choices.map(([name]) => name).filter(Boolean);
}

function same(/** @type {readonly string[]} */ one, /** @type {readonly string[]} */ other) {
  return one.length === other.length && one.every((name) => other.includes(name));
}
