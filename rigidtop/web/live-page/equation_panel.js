/** The equations of motion, of which each term can be asked what it is and how large it is now. */

import { atMostEvery, significant, withUnit } from "./axes.js";
import * as equations from "./equations.js";
import { quantities } from "./motion.js";

/** @typedef {import("./types").Equation} Equation */
/** @typedef {import("./types").Motion} Motion */
/** @typedef {import("./types").Sample} Sample */
/** @typedef {(quantities: Record<string, number>) => readonly number[]} TermFunction */

const ARROWS = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

/**
 * The equations one below the other; a term under the pointer, tapped or focused is named below.
 *
 * @param {HTMLElement} container
 * @param {readonly Equation[]} list
 * @param {(arrow: import("./types").Term["arrow"]) => void} light Show what a term is part of.
 */
export function createEquationPanel(container, list, light) {
  container.classList.add("equations");
  const hint = document.createElement("p");
  hint.className = "equations-hint";
  hint.textContent = "Point at a term, tap it, or reach it with Tab and the arrow keys.";
  const entries = list.map((each) => createEntry(each, light));
  container.replaceChildren(hint, ...entries.map((entry) => entry.figure));

  const update = atMostEvery(250, (/** @type {Sample} */ sample, /** @type {Motion} */ motion) => {
    for (const entry of entries) entry.update(sample, motion);
  });
  return { draw: update };
}

/**
 * One equation with the line that names a term of it.
 *
 * @param {Equation} equation
 * @param {(arrow: import("./types").Term["arrow"]) => void} light
 */
function createEntry({ tag, title, mathml, function: values, symmetric, terms }, light) {
  const figure = document.createElement("figure");
  figure.className = "equation";
  figure.setAttribute("aria-label", tag ? `Equation (${tag}): ${title}` : title);
  const heading = document.createElement("p");
  heading.className = "equation-title";
  setWords(heading, title);
  const formula = document.createElement("div");
  formula.className = "equation-formula";
  formula.innerHTML = mathml;
  // Mathematics is one thing to a screen reader, which would not find the terms in it.
  formula.querySelector("math")?.setAttribute("role", "group");
  const number = document.createElement("span");
  number.className = "equation-tag";
  number.textContent = tag && `(${tag})`;
  const naming = document.createElement("p");
  naming.className = "equation-naming";
  const amount = document.createElement("span");
  amount.className = "equation-amount";
  amount.id = `amount-${values}`;
  const meaning = document.createElement("span");
  naming.append(amount, meaning);
  const row = document.createElement("div");
  row.className = "equation-row";
  row.append(formula, number);
  figure.append(heading, row, naming);

  const targets = /** @type {MathMLElement[]} */ ([...formula.querySelectorAll("[data-term]")]);
  /** The term that stays named, and the one under the pointer; −1 for none. */
  let chosen = -1;
  let pointed = -1;
  /** @type {[Sample, Motion] | null} */
  let present = null;

  for (const target of targets) {
    const term = terms[termOf(target)];
    target.setAttribute("role", "button");
    target.setAttribute("aria-label", `${term.text}: ${term.name}`.replace(/_/g, " "));
    target.tabIndex = target === targets[0] ? 0 : -1;
  }

  /**
   * The target that an event is about.
   *
   * @param {Event} event
   */
  function targetOf(event) {
    const element = /** @type {Element} */ (event.target).closest("[data-term]");
    return /** @type {MathMLElement | null} */ (element);
  }

  /** @param {number} term @param {MathMLElement} target */
  function choose(term, target) {
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

  /**
   * "MgR sin θ = 1.240 N m".
   *
   * @param {number} k
   */
  function amountOf(k) {
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
    /** @param {Sample} sample @param {Motion} motion */
    update(sample, motion) {
      figure.hidden = symmetric !== null && symmetric !== motion.symmetric;
      present = [sample, motion];
      show();
    },
  };
}

/**
 * The number of the term that an element stands for.
 *
 * @param {MathMLElement} target
 */
function termOf(target) {
  return Number(target.dataset.term);
}

/**
 * Words in which "p_φ" becomes p with an index; nothing is touched where they are there already.
 *
 * @param {HTMLElement} element
 * @param {string} words
 */
function setWords(element, words) {
  if (element.dataset.words === words) return;
  element.dataset.words = words;
  const parts = words.split(/_(\p{L})/u).map((part, k) => {
    if (k % 2 === 0) return part;
    const index = document.createElement("sub");
    index.textContent = part;
    return index;
  });
  element.replaceChildren(...parts);
}

/**
 * The values of an equation's terms by its function in equations.js.
 *
 * @param {string} name
 * @param {Sample} sample
 * @param {Motion} motion
 */
function termValues(name, sample, motion) {
  const functions = /** @type {Record<string, TermFunction>} */ (
    /** @type {unknown} */ (equations));
  return functions[name](quantities(sample, motion));
}

/**
 * A unit of the equations in the motion's own units: "N m" is "1/d²" by the day, where moments are
 * ratios.
 *
 * @param {string} unit
 * @param {Motion} motion
 */
function unitIn(unit, { setup: { clock } }) {
  if (clock === "s") return unit;
  return unit.replace("N m", `1/${clock}²`).replace("J s", `1/${clock}`);
}
