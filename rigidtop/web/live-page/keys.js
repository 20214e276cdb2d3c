/** The keyboard: every key, what it does, and the list of them that `?` opens. */

import { element } from "./controls.js";

/**
 * @typedef {object} Commands
 * @property {() => void} play Play or pause.
 * @property {() => void} backwards
 * @property {(direction: 1 | -1) => void} step
 * @property {() => void} toStart
 * @property {() => void} push A blow on the axis of a heavy top.
 * @property {(factor: number) => void} zoom
 * @property {(azimuth: number, elevation: number) => void} turn In radians.
 * @property {() => void} home The view as it was at first.
 * @property {() => void} otherView
 * @property {(index: number) => void} preset
 * @property {() => void} present For a room, or back.
 * @property {() => void} tour
 */

/** How far one press turns the view, in radians, and brings it nearer. */
const TURN = Math.PI / 36;
const ZOOM = 1.1;

const LIST = [
  [["Space", "K"], "play, pause"],
  [["J"], "play backwards"],
  [[".", ","], "one step on, one step back"],
  [["R", "Home"], "to the start"],
  [["B"], "a blow on the axis of a heavy top, downwards"],
  [["1", "…", "9"], "the examples"],
  [["F"], "see it from space, from the body"],
  [["+", "−"], "zoom"],
  [["←", "→", "↑", "↓"], "turn the view, when the scene has the focus"],
  [["0"], "the view as it was at first"],
  [["P"], "show it to a room: the picture and one sentence; back"],
  [["T"], "the guided tour"],
  [["?"], "this list"],
];

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
  const rows = LIST.map(([keys, does]) =>
    element(
      "tr",
      {},
      element("th", { scope: "row" }, ...[...keys].map((key) => element("kbd", {}, key))),
      element("td", {}, String(does)),
    ),
  );
  dialog.querySelector("tbody")?.replaceChildren(...rows);
  dialog.querySelector("button")?.addEventListener("click", () => dialog.close());

  /** @type {Record<string, () => void>} */
  const arrows = {
    ArrowLeft: () => commands.turn(-TURN, 0),
    ArrowRight: () => commands.turn(TURN, 0),
    ArrowUp: () => commands.turn(0, TURN),
    ArrowDown: () => commands.turn(0, -TURN),
  };
  /** @type {Record<string, () => void>} */
  const anywhere = {
    " ": commands.play,
    k: commands.play,
    j: commands.backwards,
    ".": () => commands.step(1),
    ",": () => commands.step(-1),
    r: commands.toStart,
    Home: commands.toStart,
    b: commands.push,
    f: commands.otherView,
    "+": () => commands.zoom(ZOOM),
    "=": () => commands.zoom(ZOOM),
    "-": () => commands.zoom(1 / ZOOM),
    "−": () => commands.zoom(1 / ZOOM),
    0: commands.home,
    p: commands.present,
    t: commands.tour,
    "?": help,
  };

  /**
   * What a key does there, if anything.
   *
   * @param {string} key
   * @param {Element} target
   */
  function commandFor(key, target) {
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
