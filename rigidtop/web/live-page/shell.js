/** What every page has around its motion: its elements, found and made, and one line to say. */

export function find(/** @type {string} */ id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found;
}

export function messageOf(/** @type {unknown} */ error) {
  return error instanceof Error ? error.message : String(error);
}

/**
 * An element with attributes and children; `true` sets an empty attribute, `false` none.
 *
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag
 * @param {Record<string, string | boolean>} [attributes]
 * @param {(Node | string)[]} children
 * @returns {HTMLElementTagNameMap[K]}
 */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== false) made.setAttribute(name, value === true ? "" : value);
  }
  made.append(...children);
  return made;
}

/** A button with what stands on it, and what it does. */
export function button(
  /** @type {Node | string} */ content, /** @type {() => void} */ act,
  /** @type {Record<string, string>} */ attributes = {},
) {
  const made = element("button", { type: "button", ...attributes }, content);
  made.addEventListener("click", act);
  return made;
}

/** The line on what is wrong, which the reader can send away. */
export function createNotice() {
  const notice = find("notice");
  const text = /** @type {HTMLElement} */ (notice.querySelector("span"));
  notice.querySelector("button")?.addEventListener("click", () => (notice.hidden = true));
  return {
    /** The first of some sentences, and how many more there are. */
    say(/** @type {readonly string[]} */ sentences) {
      notice.hidden = sentences.length === 0;
      if (notice.hidden) return;
      const [first] = sentences;
      const more = sentences.length > 1 ? ` (and ${sentences.length - 1} more)` : "";
      text.textContent = `${first[0].toUpperCase()}${first.slice(1)}${more}.`;
    },
    /** Away with a sentence that begins so. */
    forget(/** @type {string} */ beginning) {
      if (text.textContent?.startsWith(beginning)) notice.hidden = true;
    },
  };
}
