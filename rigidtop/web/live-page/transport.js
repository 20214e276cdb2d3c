/** The buttons of time: to the start, backwards, one step, play and pause, how fast, the clock. */

import { button, element } from "./shell.js";

/** The speeds that the slider offers, times the preset's own. */
export const FACTORS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];

/** Outlines of the buttons in a square of 24. */
const ICONS = {
  start: "M5 5h3v14H5zM20 5v14L9 12z",
  backwards: "M18 4v16L5 12z",
  back: "M17 5h3v14h-3zM14 5v14L4 12z",
  play: "M6 4v16l13-8z",
  pause: "M6 4h4.5v16H6zM13.5 4H18v16h-4.5z",
  forward: "M4 5h3v14H4zM10 5v14l10-7z",
  push: "M10 3h4v9h5l-7 9-7-9h5z",
};

function icon(/** @type {keyof typeof ICONS} */ name) {
  const space = "http://www.w3.org/2000/svg";
  const picture = document.createElementNS(space, "svg");
  const path = document.createElementNS(space, "path");
  picture.setAttribute("viewBox", "0 0 24 24");
  picture.setAttribute("aria-hidden", "true");
  path.setAttribute("d", ICONS[name]);
  picture.append(path);
  return picture;
}

/**
 * @typedef {object} Actions
 * @property {() => void} toStart
 * @property {(direction: 1 | -1) => void} toggle Play that way, or pause if it does.
 * @property {(direction: 1 | -1) => void} step
 * @property {(factor: number) => void} setSpeed
 * @property {() => void} [push] A blow on the axis.
 */

/**
 * @typedef {object} Transport
 * @property {number} t
 * @property {Clock} clock
 * @property {number} digits Decimals of t.
 * @property {boolean} playing
 * @property {1 | -1} direction
 * @property {number} factor
 * @property {number} rate Units of the clock for each second that passes.
 * @property {string} note "" or one line.
 */

/** The bar of time; `show` is called each frame and touches only what changed. */
export function createTransport(
  /** @type {HTMLElement} */ container, /** @type {Actions} */ actions,
) {
  const made = (
    /** @type {keyof typeof ICONS} */ name, /** @type {string} */ label, /** @type {string} */ key,
    /** @type {() => void} */ act,
  ) => button(icon(name), act, { "aria-label": label, title: `${label} (${key})` });
  const start = made("start", "To the start", "R", actions.toStart);
  const backwards = made("backwards", "Play backwards", "J", () => actions.toggle(-1));
  const back = made("back", "One step back", ",", () => actions.step(-1));
  const play = made("play", "Play", "space", () => actions.toggle(1));
  const forward = made("forward", "One step on", ".", () => actions.step(1));
  play.classList.add("main");
  const { push } = actions;
  const blow = push ? [made("push", "Push the axis down", "B", push)] : [];

  const speed = element("input", {
    type: "range",
    id: "speed",
    min: "0",
    max: String(FACTORS.length - 1),
    step: "1",
    title: "Slow motion to fast",
  });
  speed.addEventListener("input", () => actions.setSpeed(FACTORS[Number(speed.value)]));
  const factor = element("output", { for: "speed" });
  const clock = element("output", { class: "clock", "aria-label": "Time" });
  const note = element("p", { class: "note", role: "status" });
  container.replaceChildren(
    element("div", { class: "buttons" }, start, backwards, back, play, forward),
    clock,
    element("div", { class: "speed" }, element("label", { for: "speed" }, "speed"), speed, factor,
      element("div", { class: "buttons" }, ...blow)),
    note,
  );
  /** @type {Partial<Transport>} */
  let before = {};

  function write(/** @type {HTMLElement} */ what, /** @type {string} */ text) {
    if (what.textContent !== text) what.textContent = text;
  }
  function showRunning(
    /** @type {HTMLButtonElement} */ what, /** @type {boolean} */ runs,
    /** @type {"play" | "backwards"} */ name,
  ) {
    const label = runs ? "Pause" : name === "play" ? "Play" : "Play backwards";
    what.replaceChildren(icon(runs ? "pause" : name));
    what.setAttribute("aria-label", label);
    what.title = `${label} (${name === "play" ? "space" : "J"})`;
  }

  return {
    show(/** @type {Transport} */ now) {
      const t = now.t.toFixed(now.digits);
      write(clock, `t = ${t.replace("-", "−")} ${now.clock}`);
      write(note, now.note);
      if (now.playing !== before.playing || now.direction !== before.direction) {
        showRunning(play, now.playing && now.direction > 0, "play");
        showRunning(backwards, now.playing && now.direction < 0, "backwards");
      }
      if (now.factor !== before.factor || now.rate !== before.rate || now.clock !== before.clock) {
        const nearest = FACTORS.map((one) => Math.abs(Math.log(one / now.factor)));
        speed.value = String(nearest.indexOf(Math.min(...nearest)));
        const rate = `${Number(now.rate.toPrecision(3))} ${now.clock} each second`;
        factor.textContent = `×${Number(now.factor.toPrecision(3))}`;
        factor.title = rate;
        speed.setAttribute("aria-valuetext", `${factor.textContent}, ${rate}`);
      }
      before = now;
    },
  };
}
