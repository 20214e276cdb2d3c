/** The keyboard: every key, what it does, and the list of them that `?` opens. */

import { element } from "./shell.js";

/**
 * @typedef {object} Commands
 * @property {() => void} play Play or pause.
 * @property {() => void} backwards
 * @property {(direction: 1 | -1) => void} step
 * @property {() => void} toStart
 * @property {(() => void) | undefined} push A blow on the axis of a heavy top.
 * @property {(factor: number) => void} zoom
 * @property {(azimuth: number, elevation: number) => void} turn In radians.
 * @property {() => void} home The view as it was at first.
 * @property {(() => void) | undefined} otherView
 * @property {(index: number) => void} preset
 * @property {() => void} present For a room, or back.
 * @property {(() => void) | undefined} tour
 */

/** How far one press turns the view, in radians, and brings it nearer. */
const TURN = Math.PI / 36;
const ZOOM = 1.1;

/** Elements whose own keys come first. */
const TYPING =
  "input:not([type=range], [type=checkbox], [type=radio]), textarea, select, [contenteditable]";
const PRESSED_BY_SPACE = "button, [role=button], summary, a[href], input";
/** What a key that is held down goes on doing. */
const REPEATED = /^([.,=+−-]|Arrow.*)$/;
const WITH_ARROWS = "input[type=range], input[type=radio]";

/**
 * Listen to the keyboard.
 *
 * @param {HTMLElement} scene
 * @param {HTMLDialogElement} dialog Holds a table and the button that closes it.
 * @param {Commands} commands
 * @returns {{ help(): void }} `help` opens the list of keys.
 */
export function createKeys(scene, dialog, commands) {
  const { step, zoom, turn, toStart } = commands;
  /**
   * The keys as they are listed, in words what they do, and by their names what is done.
   *
   * @type {[string[], string, Record<string, (() => void) | undefined>][]}
   */
  const all = [
    [["Space", "K"], "play, pause", { " ": commands.play, k: commands.play }],
    [["J"], "play backwards", { j: commands.backwards }],
    [[".", ","], "one step on, one step back", { ".": () => step(1), ",": () => step(-1) }],
    [["R", "Home"], "to the start", { r: toStart, Home: toStart }],
    [["B"], "a blow on the axis, downwards", { b: commands.push }],
    [["1", "…", "9"], "the examples", {}],
    [["F"], "see it from space, from the body", { f: commands.otherView }],
    [["+", "−"], "zoom", { "+": () => zoom(ZOOM), "=": () => zoom(ZOOM),
      "-": () => zoom(1 / ZOOM), "−": () => zoom(1 / ZOOM) }],
    [["←", "→", "↑", "↓"], "turn the view, when the scene has the focus", {}],
    [["0"], "the view as it was at first", { 0: commands.home }],
    [["P"], "show it to a room: the picture and one sentence; back", { p: commands.present }],
    [["T"], "the guided tour", { t: commands.tour }],
    [["?"], "this list", { "?": help }],
  ];
  const possible = all.filter(([, , does]) => Object.values(does).every(Boolean));
  const anywhere = Object.assign({}, ...possible.map(([, , does]) => does));
  /** @type {Record<string, () => void>} */
  const arrows = {
    ArrowLeft: () => turn(-TURN, 0),
    ArrowRight: () => turn(TURN, 0),
    ArrowUp: () => turn(0, TURN),
    ArrowDown: () => turn(0, -TURN),
  };
  const rows = possible.map(([keys, words]) =>
    element(
      "tr",
      {},
      element("th", { scope: "row" }, ...keys.map((key) => element("kbd", {}, key))),
      element("td", {}, words),
    ),
  );
  dialog.querySelector("tbody")?.replaceChildren(...rows);
  dialog.querySelector("button")?.addEventListener("click", () => dialog.close());

  /** What a key does there, if anything. */
  function commandFor(/** @type {string} */ key, /** @type {Element} */ target) {
    if (target.closest(TYPING)) return null;
    if (key === " " && target.closest(PRESSED_BY_SPACE)) return null;
    if (key === "Home" && target.closest(WITH_ARROWS)) return null;
    if (/^[1-9]$/.test(key)) return () => commands.preset(Number(key) - 1);
    if (target === scene && key in arrows) return arrows[key];
    const name = key.length === 1 ? key.toLowerCase() : key;
    return anywhere[name] ?? null;
  }

  function help() {
    if (!dialog.open) dialog.showModal();
  }

  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented) return;
    if (dialog.open || !(event.target instanceof Element)) return;
    if (event.repeat && !REPEATED.test(event.key)) return;
    const command = commandFor(event.key, event.target);
    if (!command) return;
    event.preventDefault();
    command();
  });
  return { help };
}
