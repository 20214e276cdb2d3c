/** The page of a heavy top or a free body. */

import { createEquationPanel } from "./equation_panel.js";
import { factsOf } from "./facts.js";
import { ghostsOf, ghostValues } from "./ghost.js";
import { createMotion } from "./motion.js";
import { createPage } from "./page.js";
import { plotsOf, plottedOf, tableOf } from "./plotted.js";
import { createPolhodeMap } from "./polhode_map.js";
import { createPotentialPlot } from "./potential_plot.js";
import { createRegimeMap } from "./regime_map.js";
import { createScene } from "./scene.js";
import { find } from "./shell.js";

/** How fast a blow makes a top that stands still, in √(MgR/λ₁). */
const BLOW = 0.5;

/** What can be switched on and off, with the letter or the word that names it. */
const LAYERS = /** @type {[Layer, string][]} */ ([
  ["e1", "e₁"],
  ["e2", "e₂"],
  ["e3", "e₃"],
  ["omega", "ω"],
  ["L", "L"],
  ["torque", "torque N"],
  ["trail", "trail"],
  ["cones", "cones"],
  ["poinsot", "Poinsot"],
]);

const data = pageData();
const kind = data.kind === "free" ? "free" : "heavy-top";
const shapes = kind === "free" ? ["brick", "wheel", "asteroid", "T-handle"] : ["top"];

createPage(data, /** @type {Subject<Sample, Motion>} */ ({
  offers: {
    clock: kind === "free" ? [["s", "seconds"], ["d", "days"]] : [["s", "seconds"]],
    view: [["space", "space"], ["body", "the body"]],
    shape: shapes.map((name) => /** @type {const} */ ([name, name])),
    plot: plotsOf(kind),
    ghost: [["", "nothing"], ...ghostsOf(kind)],
    layers: LAYERS.filter(([name]) => name !== (kind === "free" ? "torque" : "poinsot")),
  },
  motionOf: ({ clock, values }, beside) =>
    createMotion({ kind, clock, values }, data.tableau, beside?.timescale),
  factsOf,
  ghostOf(ghost, state, facts) {
    const values = ghostValues(ghost, state.values, facts);
    if (!values) throw new Error("this top has no steady precession");
    return { ...state, values };
  },
  plottedOf,
  pictureIn: createScene,
  panels: (set, light) => [
    kind === "free"
      ? createPolhodeMap(find("regimes"), ([omega1, omega2, omega3]) => {
          set({ omega1, omega2, omega3 });
        })
      : createRegimeMap(find("regimes"), (phidot, omega3) => set({ phi_dot: phidot, omega3 })),
    createPotentialPlot(find("potential")),
    createEquationPanel(find("equations"), data.equations, light),
  ],
  describe({ now, setup }, facts) {
    const degrees = (/** @type {number} */ angle) =>
      `${Number(((angle * 180) / Math.PI).toFixed(1))}°`;
    const unit = setup.clock === "d" ? "day" : "second";
    const body = kind === "free" ? "A free body" : "A heavy top";
    const ends = facts?.turningPoints;
    const range =
      ends && ends[1] - ends[0] > 1e-6 ? `, θ between ${ends.map(degrees).join(" and ")}` : "";
    const turning = Number.isFinite(now.phi_dot)
      ? `, φ̇ = ${Number(now.phi_dot.toPrecision(3))} radians a ${unit}`
      : "";
    return `${body}, ${facts?.regime || "in motion"}${range}. Now θ = ${degrees(now.theta)}` +
      `${turning}, at t = ${Number(now.t.toPrecision(3))} ${unit}s`;
  },
  table: tableOf,
  /** Downwards: the motion goes on from where it is with more θ̇. */
  blow: kind === "free" ? undefined : ({ now, weight, moments }) => {
    const { theta, theta_dot, phi, phi_dot, psi, omega } = now;
    if (!Number.isFinite(phi_dot)) return null;
    const more = BLOW * Math.sqrt(Math.hypot(...Array.from(weight)) / moments[0]);
    return { theta, phi, psi, theta_dot: theta_dot + more, phi_dot, omega3: omega[2] };
  },
}));

/**
 * What Python wrote, with the first preset one of the presets.
 *
 * @returns {PageData}
 */
function pageData() {
  /** @type {PageData} */
  const written = JSON.parse(find("data").textContent ?? "");
  const { first, presets } = written;
  return { ...written, first: presets.find(({ name }) => name === first.name) ?? first };
}
