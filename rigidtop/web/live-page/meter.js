/** How far the computed motion has strayed from what the exact one keeps. */

import { atMostEvery, powerOfTen, scientific } from "./axes.js";
import { element } from "./shell.js";

/** Exponents of ten at the ends of the bars, and of what is promised. */
const LEAST = -16;
const MOST = -6;
const PROMISE = -9;

/** @type {Record<string, { symbol: string, meaning: string }>} */
const NAMES = {
  "E + W": { symbol: "E + W", meaning: "energy, with what friction has taken" },
  E: { symbol: "E", meaning: "energy" },
  p_phi: { symbol: "p<sub>φ</sub>", meaning: "p φ, the momentum of φ" },
  p_psi: { symbol: "p<sub>ψ</sub>", meaning: "p ψ, the momentum of ψ" },
  L: { symbol: "L", meaning: "angular momentum" },
};

/** A row for each constant of the motion: its relative drift as a bar, as numbers and as a word. */
export function createMeter(/** @type {HTMLElement} */ container) {
  container.classList.add("meter");
  container.style.setProperty("--promise", percent(10 ** PROMISE));
  /** @type {string} */
  let names = "";
  /** @type {((drift: Drift) => void)[]} */
  let rows = [];

  const draw = atMostEvery(250, (/** @type {readonly Drift[]} */ drifts) => {
    const wanted = drifts.map((drift) => drift.name).join();
    if (wanted !== names) {
      names = wanted;
      container.replaceChildren(heading());
      rows = drifts.map((drift) => createRow(container, drift.name));
      const exact = drifts.some((drift) => drift.exact) ? " ω₃, and with it λ₃ω₃, is" +
        " constant by the form of the equations that are integrated: its zero says nothing." : "";
      container.append(element("p", { class: "meter-note" },
        `The mark at ${powerOfTen(PROMISE)} is what the page promises. A small drift shows that` +
        ` the motion is integrated well, not how large its error in time is.${exact}`));
    }
    drifts.forEach((drift, k) => rows[k](drift));
  });
  return { draw };
}

const span = (/** @type {string} */ name, text = "") => element("span", { class: name }, text);

/** The words above the columns. */
function heading() {
  const [least, promise, most] = [LEAST, PROMISE, MOST].map((n) => span("", powerOfTen(n)));
  const scale = element("span", { class: "meter-scale" }, least, promise, most);
  return element("div", { class: "meter-row meter-heading", "aria-hidden": "true" },
    span(""), scale, span("", "now"), span("", "largest"), span(""));
}

/** A row at the end of the container, and the function that shows a drift in it. */
function createRow(/** @type {HTMLElement} */ container, /** @type {string} */ name) {
  const { symbol, meaning } = NAMES[name] ?? { symbol: "", meaning: name };
  const letter = span("meter-name");
  if (symbol) letter.innerHTML = symbol;
  else letter.textContent = meaning;
  const bar = span("meter-bar");
  const [now, most, word] = [span("meter-number"), span("meter-number"), span("meter-word")];
  const row = element("div", { class: "meter-row", role: "meter",
    "aria-label": `Relative drift of ${meaning}`, "aria-valuemin": String(LEAST),
    "aria-valuemax": String(MOST) }, letter, bar, now, most, word);
  container.append(row);
  let shown = "";

  return (/** @type {Drift} */ drift) => {
    const texts = [drift.now, drift.most].map((value) => scientific(value));
    const held = drift.exact ? "exact" : "held";
    const verdict = drift.most < 10 ** PROMISE ? held : "lost";
    if (shown === texts.join()) return;
    shown = texts.join();
    [now.textContent, most.textContent] = texts;
    word.textContent = verdict;
    row.dataset.verdict = verdict;
    bar.style.setProperty("--now", percent(drift.now));
    bar.style.setProperty("--most", percent(drift.most));
    row.setAttribute("aria-valuenow", exponent(drift.most).toFixed(1));
    row.setAttribute("aria-valuetext",
      `${verdict}: ${spoken(drift.now)} now, ${spoken(drift.most)} at most`);
  };
}

/** The exponent of ten of a drift, within the bar. */
function exponent(/** @type {number} */ drift) {
  return drift < 10 ** MOST ? Math.max(Math.log10(drift), LEAST) : MOST;
}

/** The place of a drift along the bar. */
function percent(/** @type {number} */ drift) {
  return `${(100 * (exponent(drift) - LEAST) / (MOST - LEAST)).toFixed(1)}%`;
}

/** A drift as it is read aloud. */
function spoken(/** @type {number} */ drift) {
  if (drift === 0) return "0";
  if (!Number.isFinite(drift)) return "unknown";
  const [mantissa, power] = drift.toExponential(0).split("e");
  return `${mantissa} times 10 to the ${power.replace("-", "minus ")}`;
}
