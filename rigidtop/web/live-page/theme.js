/** The page's themes. Their colours stand in style.css, where they are read for what is drawn. */

/** @typedef {import("./types").Colours} Colours */
/** @typedef {import("./types").Theme} Theme */

/** The themes by their names in the address, with the words for a reader. */
export const THEMES = /** @type {const} */ ([
  ["light", "Light"],
  ["dark", "Dark"],
  ["contrast", "High contrast"],
]);

/**
 * What the reader's system asks for.
 *
 * @returns {Theme}
 */
export function preferredTheme() {
  if (matchMedia("(prefers-contrast: more)").matches) return "contrast";
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

/**
 * Dress the page.
 *
 * @param {Theme} theme
 */
export function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
}

/**
 * The colours of the theme that the page wears now.
 *
 * @returns {Colours}
 */
export function readColours() {
  const style = getComputedStyle(document.documentElement);
  /** @param {string} name */
  const colour = (name) => style.getPropertyValue(`--${name}`).trim();
  return {
    paper: colour("paper"),
    ink: colour("ink"),
    muted: colour("muted"),
    rule: colour("rule"),
    body: colour("body"),
    e1: colour("e1"),
    e2: colour("e2"),
    e3: colour("e3"),
    omega: colour("omega"),
    L: colour("L"),
    torque: colour("torque"),
    trail: colour("trail"),
    bodyCone: colour("body-cone"),
    spaceCone: colour("space-cone"),
    polhode: colour("polhode"),
    highContrast: document.documentElement.dataset.theme === "contrast",
  };
}
