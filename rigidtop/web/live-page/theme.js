/** The page's themes. Their colours stand in style.css, where they are read for what is drawn. */

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

/** Dress the page. */
export function setTheme(/** @type {Theme} */ theme) {
  document.documentElement.dataset.theme = theme;
}

/** What the style sheet has a colour for, by the names of its variables. */
const NAMES = /** @type {const} */ ([
  "paper", "ink", "muted", "rule", "body", "e1", "e2", "e3", "omega", "L", "torque", "trail",
  "bodyCone", "spaceCone", "polhode",
]);

/**
 * The colours of the theme that the page wears now.
 *
 * @returns {Colours}
 */
export function readColours() {
  const style = getComputedStyle(document.documentElement);
  const colours = NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]);
  const highContrast = document.documentElement.dataset.theme === "contrast";
  return { ...Object.fromEntries(colours), highContrast };
}
