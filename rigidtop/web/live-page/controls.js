/** What sets the body and its start: sliders with numbers. */

import { button, element } from "./shell.js";
import { listen, trackOf } from "./track.js";

const DEGREE = Math.PI / 180;

/** A finite decimal number, and null for every other text. */
export function numberFrom(/** @type {string} */ text) {
  const plain = text.trim().replace("−", "-");
  if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain)) return null;
  const number = Number(plain);
  return Number.isFinite(number) ? number : null;
}

/** What may stand behind a number that is typed, and by what it multiplies it. */
const SUFFIXES = { deg: DEGREE, "°": DEGREE, rad: 1, rpm: Math.PI / 30 };

/**
 * A number as it is typed, in SI units and radians; null for text that is none.  An angle is in
 * degrees, but for "1rad"; a rate may be in "rpm", or in "deg".
 */
function typedValue(/** @type {string} */ text, /** @type {Parameter} */ { angle, unit }) {
  const [, digits, suffix] = /^(.*?)\s*(deg|°|rad|rpm)?$/.exec(text.trim()) ?? ["", text, ""];
  const number = numberFrom(digits);
  if (number === null) return null;
  if (!suffix) return angle ? number * DEGREE : number;
  if (!(angle ? suffix !== "rpm" : unit === "rad/s")) return null;
  return number * SUFFIXES[/** @type {keyof typeof SUFFIXES} */ (suffix)];
}

/**
 * The range of a parameter: its own, widened to what the preset needs.
 *
 * @returns {[number, number]}
 */
export function limits(/** @type {Parameter} */ parameter, /** @type {Preset} */ preset) {
  const value = preset.setup.values[parameter.name] ?? parameter.least;
  return [Math.min(parameter.least, value), Math.max(parameter.most, value)];
}

const rounded = (
  /** @type {number} */ value, /** @type {number} */ digits,
) => String(Number(value.toPrecision(digits))).replace("-", "−");

/** The unit of a value; by the day moments are ratios. */
function unitOf(/** @type {Parameter} */ parameter, /** @type {Clock} */ clock) {
  if (parameter.angle) return "°";
  if (clock === "s") return parameter.unit;
  return parameter.unit.replace("kg m²", "").replace("/s", "/d");
}

/** A value for a reader: "28.6°", "0.5 kg m²". */
export function shown(
  /** @type {Parameter} */ parameter, /** @type {number} */ value, /** @type {Clock} */ clock,
) {
  const unit = unitOf(parameter, clock);
  if (parameter.angle) return `${rounded(value / DEGREE, 3)}${unit}`;
  return unit ? `${rounded(value, 4)} ${unit}` : rounded(value, 4);
}

/** The letter of a parameter as mathematics. */
function letterOf(/** @type {Parameter} */ parameter) {
  const holder = element("span", { class: "letter" });
  holder.innerHTML = parameter.math; // written by the package, as the whole page is
  return holder;
}

/** A slider and a number field that go together; `changed` takes SI units and radians. */
function createRow(
  /** @type {Parameter} */ parameter, /** @type {(value: number) => void} */ changed,
) {
  const { name } = parameter;
  const scale = parameter.angle ? DEGREE : 1;
  const range = element("input", { type: "range", id: `slider-${name}` });
  // Mathematics alone is no name to everyone.
  if (!parameter.meaning) range.setAttribute("aria-label", parameter.letter);
  const field = element("input", {
    type: "text",
    id: `number-${name}`,
    autocomplete: "off",
    spellcheck: "false",
    "aria-label": [parameter.letter, parameter.meaning].filter(Boolean).join(", "),
    "aria-describedby": `error-${name} unit-${name}`,
  });
  if (parameter.least >= 0) field.inputMode = "decimal";
  const unit = element("span", { class: "unit", id: `unit-${name}` });
  const error = element("p", { class: "error", id: `error-${name}`, "aria-live": "polite" });
  const label = element(
    "label",
    { for: range.id, title: parameter.meaning },
    letterOf(parameter),
    " ",
    element("span", { class: "meaning" }, parameter.meaning),
  );
  const row = element("div", { class: "row", "data-name": name }, label, range, field, unit, error);

  /** @type {Clock} */
  let clock = "s";
  let [least, most] = [parameter.least, parameter.most];
  let track = trackOf(parameter, least, most);
  let value = least;
  /** @type {readonly number[]} */
  let marks = [0];

  function complain(/** @type {string} */ sentence, /** @type {Node[]} */ ...more) {
    error.replaceChildren(sentence, ...more);
    field.setAttribute("aria-invalid", "true");
    row.closest("details")?.setAttribute("open", "");
  }
  /** What could not be taken gives way to what is. */
  function restore() {
    if (error.hasChildNodes()) showField();
    content();
  }
  function content() {
    if (error.hasChildNodes()) error.replaceChildren();
    field.removeAttribute("aria-invalid");
  }
  function setRange() {
    track = trackOf(parameter, least, most);
    [range.min, range.max, range.step] = [track.low, track.high, track.step].map(String);
  }
  function showRange() {
    range.value = String(track.at(value));
    range.setAttribute("aria-valuetext", shown(parameter, value, clock));
  }
  function showField() {
    field.value = rounded(value / scale, 6);
  }

  listen(range, () => ({ track, marks, value }), (asked) => {
    value = asked;
    // The slider stays where the hand is until it is let go.
    range.setAttribute("aria-valuetext", shown(parameter, value, clock));
    showField();
    changed(value);
  });
  range.addEventListener("change", showRange);
  field.addEventListener("change", () => {
    const asked = typedValue(field.value, parameter);
    if (asked === null) {
      complain(`“${field.value}” is not a number; write one such as ${rounded(value / scale, 3)}.`);
      return;
    }
    // A limit in degrees is met to rounding.
    if (asked < least - 1e-12 || asked > most + 1e-12) {
      const ends = [least, most].map((end) => shown(parameter, end, clock));
      complain(`${parameter.letter} goes from ${ends[0]} to ${ends[1]} here.`);
      return;
    }
    value = Math.min(Math.max(asked, least), most);
    showField();
    showRange();
    changed(value);
  });
  field.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    showField();
    content();
  });

  return {
    row,
    complain,
    restore,
    focus: () => range.focus(),
    show(
      /** @type {number} */ now, /** @type {Clock} */ time,
      /** @type {readonly [number, number]} */ ends,
    ) {
      [value, clock] = [now, time];
      if (ends[0] !== least || ends[1] !== most || !range.max) {
        [least, most] = ends;
        setRange();
      }
      unit.textContent = unitOf(parameter, clock);
      showRange();
      showField();
      content();
    },
    /** @param {readonly number[]} next Values that a hand is meant to hit. */
    setMarks(next) {
      marks = next;
    },
    /** @param {boolean} follows Another slider sets this one. */
    setFollowing(follows) {
      range.disabled = follows;
      field.disabled = follows;
    },
  };
}

/**
 * The sliders. `changed` takes all the values that are asked for, and the name of the one that was
 * moved.
 */
export function createSliders(
  /** @type {{ start: HTMLElement, body: HTMLElement }} */ places, /** @type {Kind} */ kind,
  /** @type {readonly Parameter[]} */ parameters,
  /** @type {(values: Record<string, number>, name: string) => void} */ changed,
) {
  /** @type {Record<string, number>} */
  let values = {};
  /** @type {Preset | null} */
  let preset = null;
  /** @type {Clock} */
  let clock = "s";
  /** @type {{ name: string, back: () => void } | null} */
  let refused = null;

  const rows = new Map(parameters.map((parameter) => [parameter.name, rowOf(parameter)]));
  const symmetric = element("input", { type: "checkbox", id: "symmetric" });
  const second = kind === "heavy-top" ? rows.get("lambda2") : undefined;
  if (second) {
    const words = "λ₂ = λ₁ (symmetric)";
    const label = element("label", { class: "chip", for: "symmetric" }, symmetric, words);
    second.row.querySelector("label")?.after(label);
    symmetric.addEventListener("change", () => {
      second.setFollowing(symmetric.checked);
      if (symmetric.checked && values.lambda2 !== values.lambda1) set("lambda1", values.lambda1);
    });
  }
  for (const { name, start } of parameters) {
    const made = rows.get(name);
    if (made) (start ? places.start : places.body).append(made.row);
  }

  function rowOf(/** @type {Parameter} */ parameter) {
    return createRow(parameter, (value) => set(parameter.name, value));
  }

  function set(/** @type {string} */ name, /** @type {number} */ value) {
    if (refused && refused.name !== name) {
      // What was refused does not stay, or another slider would be blamed for it.
      refused.back();
      refused = null;
      values[name] = value;
      showRow(name);
    }
    values[name] = value;
    if (second && name === "lambda1" && symmetric.checked) {
      values.lambda2 = value;
      showRow("lambda2");
    }
    for (const row of rows.values()) row.restore();
    changed({ ...values }, name);
  }

  function showRow(/** @type {string} */ name) {
    const parameter = parameters.find((one) => one.name === name);
    if (!parameter || !preset) return;
    rows.get(name)?.show(values[name], clock, limits(parameter, preset));
  }

  const sliders = {
    /** All values anew. */
    show(/** @type {Values} */ now, /** @type {Clock} */ time, /** @type {Preset} */ example) {
      [values, clock, preset, refused] = [{ ...now }, time, example, null];
      for (const { name } of parameters) showRow(name);
      symmetric.checked = values.lambda1 === values.lambda2;
      second?.setFollowing(symmetric.checked);
    },
    /** As if the sliders were moved there, within their ranges. */
    setAll(/** @type {Record<string, number>} */ asked) {
      for (const [name, value] of Object.entries(asked)) {
        const [least, most] = sliders.limits(name);
        values[name] = Math.min(Math.max(value, least), most);
        showRow(name);
        set(name, values[name]);
      }
    },
    /** What the sliders of a motion catch on. */
    setMarks(/** @type {Facts} */ { steady, smallestSpin }) {
      rows.get("phi_dot")?.setMarks([0, ...(steady ?? [])].filter(Number.isFinite));
      const least = smallestSpin ?? 0;
      rows.get("omega3")?.setMarks([0, least, -least]);
    },
    /**
     * The range of a slider now.
     *
     * @returns {[number, number]}
     */
    limits(/** @type {string} */ name) {
      const parameter = parameters.find((one) => one.name === name);
      return parameter && preset ? limits(parameter, preset) : [-Infinity, Infinity];
    },
    /** Say at the slider `name` why there is no such motion, and offer the way back. */
    refuse(
      /** @type {string} */ name, /** @type {string} */ sentence, /** @type {() => void} */ back,
    ) {
      refused = { name, back };
      const undo = button("Take it back", () => {
        back();
        rows.get(name)?.focus();
      });
      rows.get(name)?.complain(`${sentence}. The motion shown is the last possible one. `, undo);
    },
  };
  return sliders;
}
