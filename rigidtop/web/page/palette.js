/** @typedef {import("./types").Colours} Colours */
/** @typedef {(colours: Colours) => THREE.Color} Pick */

/** A colour on the way from one to another: part 0 is the first, 1 the second. */
export function mix(
  /** @type {string} */ from, /** @type {string} */ to, /** @type {number} */ part,
) {
  return new THREE.Color(from).lerp(new THREE.Color(to), part);
}

/**
 * All materials of the scene, each with the rule by which it takes its colour from a theme, so
 * that a new theme recolours what is there.
 */
export function createPalette(/** @type {Colours} */ colours) {
  let current = colours;
  /** @type {((colours: Colours) => void)[]} */
  const rules = [];
  /** @type {THREE.Material[]} */
  const materials = [];
  /** @type {THREE.LineMaterial[]} */
  const lines = [];
  const size = new THREE.Vector2(1, 1);

  /** Follow a theme: now, and whenever it changes. */
  function follow(/** @type {(colours: Colours) => void} */ rule) {
    rules.push(rule);
    rule(current);
  }

  /**
   * @template {THREE.Material} T
   * @param {T} material
   * @param {Pick} pick
   */
  function keep(material, pick) {
    materials.push(material);
    follow((c) => material.color.set(pick(c)));
    return material;
  }

  return {
    get colours() {
      return current;
    },
    follow,

    /** Lit and opaque. */
    solid(/** @type {Pick} */ pick, /** @type {THREE.MaterialOptions} */ options = {}) {
      return keep(new THREE.MeshLambertMaterial({ fog: false, ...options }), pick);
    },

    /** One colour whatever the light, drawn over all else. */
    dot(/** @type {Pick} */ pick) {
      const material = new THREE.MeshBasicMaterial({ fog: false, depthTest: false });
      return keep(material, pick);
    },

    /** Translucent; left out in high contrast, where lines stand for it. */
    sheet(
      /** @type {Pick} */ pick, /** @type {number} */ opacity, side = THREE.DoubleSide, lit = true,
    ) {
      const options = { fog: false, transparent: true, opacity, depthWrite: false, side };
      const material = lit
        ? new THREE.MeshLambertMaterial(options)
        : new THREE.MeshBasicMaterial(options);
      follow((c) => (material.visible = !c.highContrast));
      return keep(material, pick);
    },

    /** A line so many CSS pixels wide; `fog` lets its far parts fade. */
    line(
      /** @type {Pick} */ pick, /** @type {number} */ width,
      /** @type {THREE.MaterialOptions} */ options = {},
    ) {
      const material = new THREE.LineMaterial({ fog: false, ...options });
      material.resolution.set(size.x, size.y);
      lines.push(material);
      follow((c) => (material.linewidth = c.highContrast ? 1.8 * width : width));
      return keep(material, pick);
    },

    /** Line widths are in CSS pixels: they need the size of the picture. */
    resize(/** @type {number} */ width, /** @type {number} */ height) {
      size.x = width;
      size.y = height;
      for (const material of lines) material.resolution.set(width, height);
    },

    setColours(/** @type {Colours} */ next) {
      current = next;
      for (const rule of rules) rule(next);
    },

    dispose() {
      for (const material of materials) material.dispose();
    },
  };
}

/** @typedef {ReturnType<typeof createPalette>} Palette */
