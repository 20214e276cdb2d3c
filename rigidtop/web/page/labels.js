/** @typedef {import("./palette").Palette} Palette */

/** Letters less than this apart, in pixels, push each other away. */
const APART = 17;
/** How far letters are from the tips they name: beyond them, and to the right of the way there. */
const BEYOND = 7;
const ASIDE = 15;

/**
 * Letters over the picture as HTML, so that they stay crisp whatever the picture's resolution.
 * They are for the eye alone: a screen reader is told of the motion by the page's text.
 */
export function createLabels(/** @type {HTMLElement} */ container) {
  const layer = document.createElement("div");
  layer.setAttribute("aria-hidden", "true");
  layer.style.cssText = "position:absolute;inset:0;overflow:hidden;pointer-events:none;" +
    "font:600 16px/1 'Cambria Math','STIX Two Text',Georgia,'DejaVu Serif',serif;" +
    "user-select:none;-webkit-user-select:none";
  container.append(layer);
  /** @type {Label[]} */
  const all = [];
  const at = new THREE.Vector3();

  return {
    /** A letter; `faint` ones give way and are smaller. */
    add(/** @type {string} */ text, faint = false) {
      const element = document.createElement("span");
      element.textContent = text;
      // A layer of its own is moved and not painted again; its middle is a whole pixel.
      element.style.cssText = "position:absolute;left:0;top:0;width:2em;text-align:center;" +
        "margin:-0.5em 0 0 -1em;will-change:transform;" +
        `display:none;${faint ? "font-size:14px;font-weight:400;font-style:italic" : ""}`;
      layer.append(element);
      const label = {
        element,
        faint,
        shown: false,
        wanted: false,
        at: new THREE.Vector3(),
        x: 0,
        y: 0,
        left: NaN,
        top: NaN,
      };
      all.push(label);
      return label;
    },

    /** The halo that sets letters off from what is behind them. */
    setHalo(/** @type {string} */ paper) {
      layer.style.textShadow = `0 0 2px ${paper},0 0 3px ${paper},0 0 4px ${paper}`;
    },

    /** Put every wanted label by the point in the scene that it names. */
    place(
      /** @type {THREE.Camera} */ camera, /** @type {number} */ width,
      /** @type {number} */ height,
    ) {
      for (const label of all) {
        if (!label.wanted) continue;
        at.copy(label.at).project(camera);
        const dx = (at.x * width) / 2;
        const dy = (-at.y * height) / 2;
        const length = Math.hypot(dx, dy) || 1;
        // Arrows that lie on one another keep their letters apart if these stand beside them.
        const beyond = (label.faint ? 1.5 * BEYOND : BEYOND) / length;
        const aside = (label.faint ? 0 : ASIDE) / length;
        label.x = width / 2 + dx + beyond * dx - aside * dy;
        label.y = height / 2 + dy + beyond * dy + aside * dx;
      }
      separate(all);
      for (const label of all) show(label);
    },

    dispose() {
      layer.remove();
    },
  };
}

/**
 * @typedef {object} Label
 * @property {HTMLElement} element
 * @property {boolean} faint
 * @property {boolean} shown
 * @property {boolean} wanted
 * @property {THREE.Vector3} at where in the scene
 * @property {number} x where on the picture
 * @property {number} y
 * @property {number} left as last written to the page
 * @property {number} top
 */

/** Push labels apart that lie on one another: both by half, but a faint one gives way alone. */
function separate(/** @type {Label[]} */ labels) {
  for (let i = 0; i < labels.length; i++) {
    const one = labels[i];
    if (!one.wanted) continue;
    for (let j = i + 1; j < labels.length; j++) {
      const two = labels[j];
      if (!two.wanted) continue;
      let dx = two.x - one.x;
      let dy = two.y - one.y;
      let distance = Math.hypot(dx, dy);
      if (distance >= APART) continue;
      if (two.faint && !one.faint) {
        two.x = one.x + (dx < 0 ? -1 : 1) * Math.sqrt(APART * APART - dy * dy);
        continue;
      }
      if (distance < 0.5) [dx, dy, distance] = [1, 0, 1];
      const push = (APART - distance) / distance / 2;
      two.x += push * dx;
      two.y += push * dy;
      one.x -= push * dx;
      one.y -= push * dy;
    }
  }
}

/** Write a label's place to the page, but only what has changed. */
function show(/** @type {Label} */ label) {
  const { style } = label.element;
  if (label.wanted !== label.shown) {
    label.shown = label.wanted;
    style.display = label.wanted ? "" : "none";
  }
  if (!label.wanted) return;
  const left = Math.round(label.x);
  const top = Math.round(label.y);
  if (left === label.left && top === label.top) return;
  label.left = left;
  label.top = top;
  style.transform = `translate(${left}px,${top}px)`;
}
