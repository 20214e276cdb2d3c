/** What is chosen by a click: examples, what is drawn, and one of a few words. */

import { element } from "./shell.js";

/**
 * Inputs that look like keys, in a row.
 *
 * @param {HTMLElement} container
 * @param {Record<string, string>} attributes of the group
 * @param {{ type: string, name: string, value: string, content: (Node | string)[] }[]} all
 */
function createChips(container, attributes, all) {
  const group = element("div", attributes);
  const inputs = all.map(({ type, name, value, content }) => {
    const input = element("input", { type, name, value });
    group.append(element("label", { class: "chip" }, input, ...content));
    return input;
  });
  if (all.length > 0) container.append(group);
  return { group, inputs };
}

/** The examples as a row of radio buttons, with the words on the one that is shown. */
export function createPresets(
  /** @type {HTMLElement} */ container, /** @type {readonly Preset[]} */ presets,
  /** @type {(preset: Preset) => void} */ choose,
) {
  const { group, inputs } = createChips(
    container,
    { class: "chips", role: "radiogroup", "aria-label": "Examples" },
    presets.map(({ name: value, title }, k) => {
      const key = k < 9 ? [element("kbd", { "aria-hidden": "true" }, String(k + 1))] : [];
      return { type: "radio", name: "preset", value, content: [...key, title] };
    }),
  );
  // Also a click on the one that is shown, which takes it back to where it started.
  inputs.forEach((input, k) => input.addEventListener("click", () => choose(presets[k])));
  const about = element("p", { class: "about" });
  container.append(about);
  return {
    /**
     * @param {Preset} preset
     * @param {boolean} changed Sliders were moved since.
     */
    show(preset, changed) {
      inputs.forEach((input, k) => {
        if (presets[k] !== preset || input.checked) return;
        input.checked = true;
        // On a phone the row is longer than the screen.
        const [row, chip] = [group, input].map((each) => each.getBoundingClientRect());
        group.scrollLeft += chip.x + chip.width / 2 - row.x - row.width / 2;
      });
      const text = changed
        ? `Changed from “${preset.title}”; choose it again to return.`
        : preset.about;
      if (about.textContent !== text) about.textContent = text;
    },
  };
}

/**
 * Check boxes that look like keys of a legend; `changed` takes the names that are on.
 *
 * @template {string} T
 * @param {HTMLElement} container
 * @param {string} label
 * @param {readonly (readonly [T, string])[]} names Each with its words.
 * @param {(chosen: T[]) => void} changed
 */
export function createChecks(container, label, names, changed) {
  const { inputs } = createChips(
    container,
    { class: "chips", role: "group", "aria-label": label },
    names.map(([value, words]) => {
      const key = element("span", { class: `key key-${value}`, "aria-hidden": "true" });
      return { type: "checkbox", name: "", value, content: [key, words] };
    }),
  );
  for (const input of inputs) {
    input.addEventListener("change", () =>
      changed(names.filter((_, k) => inputs[k].checked).map(([one]) => one)));
  }
  return {
    show(/** @type {readonly T[]} */ chosen) {
      inputs.forEach((input, k) => (input.checked = chosen.includes(names[k][0])));
    },
  };
}

/** Radio buttons in a row. */
export function createChoice(
  /** @type {HTMLElement} */ container, /** @type {string} */ label, /** @type {Choices} */ names,
  /** @type {(chosen: string) => void} */ changed,
) {
  const { group, inputs } = createChips(
    container,
    { class: "chips", role: "radiogroup", "aria-label": label },
    names.map(([value, words]) => ({ type: "radio", name: label, value, content: [words] })),
  );
  group.prepend(element("span", { class: "legend", "aria-hidden": "true" }, label));
  inputs.forEach((input, k) => input.addEventListener("change", () => changed(names[k][0])));
  return {
    show(/** @type {string} */ chosen) {
      inputs.forEach((input, k) => (input.checked = names[k][0] === chosen));
    },
  };
}

/** One of a list, folded. */
export function createPick(
  /** @type {HTMLElement} */ container, /** @type {string} */ label, /** @type {Choices} */ names,
  /** @type {(chosen: string) => void} */ changed,
) {
  const select = element(
    "select", {}, ...names.map(([name, words]) => element("option", { value: name }, words)),
  );
  select.addEventListener("change", () => changed(select.value));
  container.append(element("label", { class: "pick" }, `${label} `, select));
  return {
    show(/** @type {string} */ chosen) {
      select.value = chosen;
    },
  };
}
