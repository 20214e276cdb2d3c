/** The guided tour: it asks what will happen, and then shows it. */

import { button, element } from "./shell.js";

/**
 * The tour in its place; hidden until it is started.
 *
 * @param {HTMLElement} container
 * @param {readonly TourStep[]} steps
 * @param {object} page
 * @param {(address: string, plays: boolean) => void} page.show A motion, at rest or playing.
 * @param {() => void} page.end
 */
export function createTour(container, steps, { show, end }) {
  let at = 0;
  let right = 0;
  /** What was answered at each step. */
  let answers = steps.map(() => -1);
  const place = element("p", { class: "tour-place" });
  const question = element("p", { class: "tour-question", id: "tour-question" });
  const choices = element("div", {
    class: "chips", role: "group", "aria-labelledby": "tour-question",
  });
  const told = element("p", { class: "tour-told", "aria-live": "polite" });
  const back = button("Back", () => go(at - 1));
  const next = button("Next", () => (at + 1 < steps.length ? go(at + 1) : close()));
  const leave = button("End the tour", close);
  container.replaceChildren(
    place, question, choices, told, element("div", { class: "tour-ways" }, back, next, leave),
  );
  container.addEventListener("keydown", (event) => {
    if (event.key === "Escape") close();
  });

  /** Ask the question of a step, or show its answer if it was answered before. */
  function go(/** @type {number} */ step) {
    at = step;
    const { ask, choices: all } = steps[at];
    question.textContent = ask;
    choices.replaceChildren(...all.map((words, k) => button(words, () => answer(k))));
    back.disabled = at === 0;
    next.textContent = at + 1 < steps.length ? "Next" : "End";
    draw();
    const known = answers[at] >= 0;
    show(steps[at].show, known);
    (known ? next : /** @type {HTMLElement} */ (choices.firstChild)).focus();
  }

  function answer(/** @type {number} */ chosen) {
    if (answers[at] >= 0) return;
    answers[at] = chosen;
    right += chosen === steps[at].answer ? 1 : 0;
    draw();
    show(steps[at].show, true);
    next.focus();
  }

  function draw() {
    const { answer: which, told: says } = steps[at];
    const chosen = answers[at];
    const known = chosen >= 0;
    const count = answers.filter((each) => each >= 0).length;
    place.textContent = `${at + 1} of ${steps.length}` +
      (count > 0 ? `; ${right} of ${count} predicted` : "");
    [...choices.children].forEach((each, k) => {
      each.classList.toggle("right", known && k === which);
      each.classList.toggle("wrong", chosen === k && k !== which);
      each.setAttribute("aria-disabled", String(known));
    });
    told.textContent = known ? says : "";
    next.disabled = !known;
    document.body.classList.toggle("asking", !known);
  }

  function close() {
    container.hidden = true;
    document.body.classList.remove("asking");
    end();
  }

  return {
    /** From its first question. */
    start() {
      container.hidden = false;
      [right, answers] = [0, steps.map(() => -1)];
      go(0);
    },
  };
}
