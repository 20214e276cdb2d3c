/** The equations of motion, of which each term can be asked what it is and how large it is now. */

import { atMostEvery, significant, withUnit } from "./axes.js";
import { element } from "./shell.js";
import * as equations from "./equations.js";
import { quantities } from "./motion.js";

/** @typedef {(quantities: Record<string, number>) => readonly number[]} TermFunction */

const ARROWS = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

/**
 * The equations one below the other; a term under the pointer, tapped or focused is named below.
 *
 * @param {HTMLElement} container
 * @param {readonly Equation[]} list
 * @param {(arrow: Term["arrow"]) => void} light Show what a term is part of.
 */
export function createEquationPanel(container, list, light) {
  const hint = "Point at a term, tap it, or reach it with Tab and the arrow keys.";
  const entries = list.map((each) => createEntry(each, light));
  container.replaceChildren(
    element("p", { class: "equations-hint" }, hint), ...entries.map((entry) => entry.figure));
  /** @type {Motion | null} */
  let motion = null;

  return {
    setMotion(/** @type {Motion} */ next) {
      motion = next;
    },
    draw: atMostEvery(250, (/** @type {Sample} */ sample) => {
      if (motion) for (const entry of entries) entry.update(sample, motion);
    }),
    setColours() {},
  };
}

/** One equation with the line that names a term of it. */
function createEntry(
  /** @type {Equation} */ { tag, title, mathml, function: values, symmetric, terms },
  /** @type {(arrow: Term["arrow"]) => void} */ light,
) {
  const heading = element("p");
  setWords(heading, title);
  const formula = element("div", { class: "equation-formula" });
  formula.innerHTML = mathml;
  formula.replaceChildren(
    ...[...(formula.firstElementChild?.children ?? [])].map((part) => partOf(part, terms)));
  const number = element("span", { class: "equation-tag" }, tag && `(${tag})`);
  const amount = element("span", { class: "equation-amount", id: `amount-${values}` });
  const meaning = element("span");
  const figure = element(
    "figure",
    { class: "equation", "aria-label": tag ? `Equation (${tag}): ${title}` : title },
    heading,
    element("div", { class: "equation-row" }, formula, number),
    element("p", { class: "equation-naming" }, amount, meaning),
  );

  const targets = /** @type {HTMLElement[]} */ ([...formula.querySelectorAll("[data-term]")]);
  /** The term that stays named, and the one under the pointer; −1 for none. */
  let chosen = -1;
  let pointed = -1;
  /** @type {[Sample, Motion] | null} */
  let present = null;

  targets.forEach((target, k) => (target.tabIndex = k === 0 ? 0 : -1));

  /** The target that an event is about. */
  function targetOf(/** @type {Event} */ event) {
    const target = /** @type {Element} */ (event.target).closest("[data-term]");
    return /** @type {HTMLElement | null} */ (target);
  }

  function choose(/** @type {number} */ term, /** @type {HTMLElement} */ target) {
    chosen = term;
    for (const each of targets) {
      each.tabIndex = each === target ? 0 : -1;
      each.removeAttribute("aria-describedby");
    }
    target.setAttribute("aria-describedby", amount.id);
    name();
  }

  /** Name what is pointed at or chosen, and light its arrow. */
  function name() {
    show();
    light(terms[pointed >= 0 ? pointed : chosen]?.arrow ?? "");
  }

  function show() {
    const shown = pointed >= 0 ? pointed : chosen;
    for (const target of targets) target.classList.toggle("named", termOf(target) === shown);
    setWords(amount, shown < 0 ? "" : amountOf(shown));
    setWords(meaning, shown < 0 ? "" : terms[shown].name);
  }

  /** "MgR sin θ = 1.240 N m". */
  function amountOf(/** @type {number} */ k) {
    const { text, unit } = terms[k];
    if (!present) return text;
    const value = termValues(values, ...present)[k];
    return Number.isFinite(value)
      ? `${text} = ${withUnit(significant(value), unitIn(unit, present[1]))}`
      : `${text} is not defined here (sin θ = 0)`;
  }

  formula.addEventListener("pointerover", (event) => {
    const target = targetOf(event);
    pointed = target ? termOf(target) : -1;
    name();
  });
  formula.addEventListener("pointerleave", () => {
    pointed = -1;
    name();
  });
  formula.addEventListener("focusout", () => light(""));
  for (const type of ["focusin", "click"]) {
    formula.addEventListener(type, (event) => {
      const target = targetOf(event);
      if (target) choose(termOf(target), target);
    });
  }
  formula.addEventListener("keydown", (event) => {
    const step = ARROWS[/** @type {keyof typeof ARROWS} */ (event.key)];
    const target = targetOf(event);
    if (!step || !target || event.ctrlKey || event.metaKey || event.altKey) return;
    const next = targets.indexOf(target) + step;
    targets[(next + targets.length) % targets.length].focus();
    event.preventDefault();
    event.stopPropagation();
  });

  return {
    figure,
    update(/** @type {Sample} */ sample, /** @type {Motion} */ motion) {
      figure.hidden = symmetric !== null && symmetric !== motion.symmetric;
      present = [sample, motion];
      show();
    },
  };
}

/**
 * A term or a sign as mathematics of its own: one formula is one thing to a screen reader, which
 * would not find the terms in it.
 */
function partOf(/** @type {Element} */ part, /** @type {readonly Term[]} */ terms) {
  const math = /** @type {Element} */ (part.parentElement).cloneNode(false);
  const term = part.getAttribute("data-term");
  const name = term && terms[Number(term)].name.replace(/_/g, " ");
  if (math instanceof Element) math.removeAttribute("alttext");
  part.removeAttribute("data-term");
  math.appendChild(part.cloneNode(true));
  if (!term) return math;
  const words = element("span", { class: "unseen" }, `: ${name}`);
  return element("span", { role: "button", "data-term": term }, math, words);
}

/** The number of the term that an element stands for. */
function termOf(/** @type {HTMLElement} */ target) {
  return Number(target.dataset.term);
}

/**
 * Words in which "p_φ" becomes p with an index; nothing is touched where they are there already.
 */
function setWords(/** @type {HTMLElement} */ holder, /** @type {string} */ words) {
  if (holder.dataset.words === words) return;
  holder.dataset.words = words;
  const parts = words.split(/_(\p{L})/u);
  holder.replaceChildren(
    ...parts.map((part, k) => (k % 2 === 0 ? part : element("sub", {}, part))));
}

/** The values of an equation's terms by its function in equations.js. */
function termValues(
  /** @type {string} */ name, /** @type {Sample} */ sample, /** @type {Motion} */ motion,
) {
  const functions = /** @type {Record<string, TermFunction>} */ (
    /** @type {unknown} */ (equations));
  return functions[name](quantities(sample, motion));
}

/**
 * A unit of the equations in the motion's own units: "N m" is "1/d²" by the day, where moments are
 * ratios.
 */
function unitIn(/** @type {string} */ unit, /** @type {Motion} */ { setup: { clock } }) {
  if (clock === "s") return unit;
  return unit.replace("N m", `1/${clock}²`).replace("J s", `1/${clock}`);
}
