/** The size of the letters: a part of the smaller side of the picture, but at least so much. */
const SIZE = 0.031;
const SMALLEST = 16;
/** The same where the page is presented to a room. */
const SMALLEST_SHOWN = 28;
/** In units of that size: letters nearer than this push each other away, words from farther. */
const APART = 1.06;
/** Of how many letters a word is taken to be at most. */
const WIDEST = 2;
/** How often, since what gives way to one comes near another. */
const ROUNDS = 3;
/** How far letters are beside the tips they name. */
const ASIDE = 0.94;

/**
 * Letters over the picture as HTML, so that they stay crisp whatever the picture's resolution.
 * They are for the eye alone: a screen reader is told of the motion by the page's text.
 */
export function createLabels(/** @type {HTMLElement} */ container) {
  const layer = document.createElement("div");
  layer.setAttribute("aria-hidden", "true");
  layer.style.cssText = "position:absolute;inset:0;overflow:hidden;pointer-events:none;" +
    "font:600 1em/1 'Cambria Math','STIX Two Text',Georgia,'DejaVu Serif',serif;" +
    "user-select:none;-webkit-user-select:none";
  container.append(layer);
  /** @type {Label[]} */
  const all = [];
  const at = new THREE.Vector3();
  let em = NaN;

  return {
    /** A letter; `faint` ones give way and are smaller. */
    add(/** @type {string} */ text, faint = false) {
      const element = document.createElement("span");
      element.textContent = text;
      // A layer of its own is moved and not painted again; its middle is a whole pixel.
      element.style.cssText = "position:absolute;left:0;top:0;width:2em;text-align:center;" +
        "margin:-0.5em 0 0 -1em;will-change:transform;" +
        `display:none;${faint ? "font-size:0.88em;font-weight:400;font-style:italic" : ""}`;
      layer.append(element);
      const label = {
        element,
        faint,
        wide: Math.min(WIDEST, text.replace(/[₁-₃]/, "").length),
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
      const least = document.body.classList.contains("presenting") ? SMALLEST_SHOWN : SMALLEST;
      const size = Math.max(least, Math.round(SIZE * Math.min(width, height)));
      if (size !== em) layer.style.fontSize = `${size}px`;
      em = size;
      at.set(0, 0, 0).project(camera);
      const [originX, originY] = [((1 + at.x) * width) / 2, ((1 - at.y) * height) / 2];
      for (const label of all) {
        if (!label.wanted) continue;
        at.copy(label.at).project(camera);
        const dx = ((1 + at.x) * width) / 2 - originX;
        const dy = ((1 - at.y) * height) / 2 - originY;
        const length = Math.hypot(dx, dy) || 1;
        const [x, y] = [dx / length, dy / length];
        // Beside its tip, on the side to which the arrow leans: there is most room for it, and
        // arrows that lie on one another keep their letters apart.
        const lean = label.faint ? 0 : Math.max(-1, Math.min(1, (dx / em + 0.5) / 0.3));
        const up = Math.max(-1, Math.min(1, -dy / em));
        const beyond = em * (label.faint ? 0.65 : 0.45 + 0.4 * Math.abs(x));
        const aside = em * ASIDE * lean;
        label.x = within(originX + dx + beyond * x + aside * Math.abs(y), width);
        label.y = within(originY + dy + beyond * y + aside * up * x, height);
      }
      for (let round = 0; round < ROUNDS; round++) separate(all, APART * em);
      for (const label of all) {
        [label.x, label.y] = [within(label.x, width), within(label.y, height)];
        show(label);
      }

      /** A letter stays in the picture, even where its arrow leaves it. */
      function within(/** @type {number} */ place, /** @type {number} */ size) {
        return Math.max(0.55 * em, Math.min(size - 0.55 * em, place));
      }
    },
  };
}

/**
 * @typedef {object} Label
 * @property {HTMLElement} element
 * @property {boolean} faint
 * @property {number} wide in letters
 * @property {boolean} shown
 * @property {boolean} wanted
 * @property {THREE.Vector3} at where in the scene
 * @property {number} x where on the picture
 * @property {number} y
 * @property {number} left as last written to the page
 * @property {number} top
 */

/** Push labels apart that lie on one another: both by half, but a faint one gives way alone. */
function separate(/** @type {Label[]} */ labels, /** @type {number} */ apart) {
  for (let i = 0; i < labels.length; i++) {
    const one = labels[i];
    if (!one.wanted) continue;
    for (let j = i + 1; j < labels.length; j++) {
      const two = labels[j];
      if (!two.wanted) continue;
      const wide = (one.wide + two.wide) / 2;
      let dx = (two.x - one.x) / wide;
      let dy = two.y - one.y;
      let distance = Math.hypot(dx, dy);
      if (distance >= apart) continue;
      if (two.faint && !one.faint) {
        two.x = one.x + (dx < 0 ? -wide : wide) * Math.sqrt(apart * apart - dy * dy);
        continue;
      }
      if (distance < 0.5) [dx, dy, distance] = [1, 0, 1];
      const push = (apart - distance) / distance / 2;
      two.x += push * dx * wide;
      two.y += push * dy;
      one.x -= push * dx * wide;
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
