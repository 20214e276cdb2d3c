/** What the motion will do, in a sentence. */

import { button, element } from "./shell.js";

/** How long a slider must rest before the verdict is read out, in ms. */
const REST = 800;

/** A relation with its sides, such as "|ω₃| ≥ 6.578 rad/s", or a time; an index stands below. */
const RELATION = new RegExp(
  "([^ ]+ [=≥<>] (?:L/λ₁ = |\\(λ₁ − λ₃\\)ω₃/λ₁ = )?[^ ]*[^ .:,;](?: rad/[sd])?" +
    "|[\\d.]+ (?:rad/[sd]|s\\b|days))");

/** A sentence whose relations are not broken between two lines. */
function withRelations(/** @type {string} */ sentence) {
  return sentence.split(RELATION).map((part, k) => {
    if (k % 2 === 0) return part;
    const [letter, index, rest] = part.split(/(?<=Ω)_(\w)/);
    const inside = index ? [letter, element("sub", {}, index), rest] : [part];
    return element("span", { class: "relation" }, ...inside);
  });
}

/** The verdict, and the buttons that set φ̇₀ to a steady precession. */
export function createVerdict(
  /** @type {HTMLElement} */ container, /** @type {(rate: number) => void} */ setPrecession,
) {
  const sentence = element("p", { class: "verdict" });
  const aloud = element("p", { class: "unseen", "aria-live": "polite" });
  const names = /** @type {const} */ ([
    ["Ω₋", "slow"],
    ["Ω₊", "fast"],
  ]);
  let rates = [0, 0];
  const buttons = names.map((_, k) => button("", () => setPrecession(rates[k])));
  const steady = element("p", { class: "steady", hidden: true }, ...buttons);
  container.replaceChildren(sentence, steady, aloud);
  let timer = 0;
  let said = "";

  return {
    /**
     * @param {Facts} facts
     * @param {readonly [number, number]} range of φ̇₀
     */
    show(facts, range) {
      container.hidden = facts.verdict === "";
      if (said !== facts.verdict) {
        said = facts.verdict;
        const end = said.indexOf(". ") + 1 || said.length;
        const further = element("span", { class: "further" }, ...withRelations(said.slice(end)));
        sentence.replaceChildren(...withRelations(said.slice(0, end)), further);
        clearTimeout(timer);
        timer = window.setTimeout(() => (aloud.textContent = sentence.textContent), REST);
      }
      steady.hidden = facts.steady === null;
      if (facts.steady === null) return;
      rates = [...facts.steady];
      buttons.forEach((each, k) => {
        const [letter, word] = names[k];
        const possible = rates[k] >= range[0] && rates[k] <= range[1];
        each.textContent = `set φ̇₀ to ${letter} (${word})`;
        each.disabled = !possible;
        each.title = possible ? "" : "beyond the range of φ̇₀";
      });
    },
  };
}
