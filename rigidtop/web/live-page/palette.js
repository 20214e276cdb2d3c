/** @typedef {(colours: Colours) => THREE.Color} Pick */

/**
 * Lines as ribbons that face the reader: each corner knows both ends of its piece, and goes half
 * the width aside.  All pieces of a line are one plain mesh, as renderers in software are slow at
 * instances.
 */
const RIBBON = `
attribute vec3 other;
attribute vec3 corner;
uniform vec2 size;
uniform float width;
uniform float count;
uniform float far;
uniform float distance;
varying float aside;
varying float age;
varying float clear;
void main() {
  vec4 here = modelViewMatrix * vec4(position, 1.0);
  clear = far > 0.0 ? 1.0 - far * smoothstep(-0.7, 1.6, -here.z - distance) : 1.0;
  age = count > 0.0 ? corner.y / count : 0.0;
  gl_Position = projectionMatrix * here;
  vec4 there = projectionMatrix * modelViewMatrix * vec4(other, 1.0);
  vec2 way = (there.xy / there.w - gl_Position.xy / gl_Position.w) * size;
  float length = length(way);
  way = length > 1e-4 ? way / length : vec2(1.0, 0.0);
  // Seen from the far end of a piece, left is right.
  aside = corner.x * (0.5 * width + 0.5);
  gl_Position.xy += 2.0 * corner.z * aside * vec2(-way.y, way.x) / size * gl_Position.w;
}`;

/** The edges of a ribbon fade over one pixel, its old end turns into another colour. */
const RIBBON_COLOUR = `
uniform vec3 colour;
uniform vec3 old;
uniform float width;
varying float aside;
varying float age;
varying float clear;
void main() {
  float edge = clamp(0.5 * width + 0.5 - abs(aside), 0.0, 1.0);
  gl_FragColor = vec4(mix(colour, old, age * age * (3.0 - 2.0 * age)), edge * clear);
}`;

/** In high contrast lines are so much thicker, and those that matter more so than thin ones. */
const THICKER = 1.25;

/** A colour on the way from one to another: part 0 is the first, 1 the second. */
export function mix(
  /** @type {string} */ from, /** @type {string} */ to, /** @type {number} */ part,
) {
  return new THREE.Color(from).lerp(new THREE.Color(to), part);
}

/** The colour of ink or of paper, whichever is further from that of the body. */
export function markColour(/** @type {Colours} */ { ink, paper, body }) {
  const light = (/** @type {string} */ colour) => {
    const { r, g, b } = new THREE.Color(colour);
    return r + g + b;
  };
  const middle = light(body);
  return Math.abs(light(ink) - middle) >= Math.abs(light(paper) - middle) ? ink : paper;
}

/**
 * All materials of the scene, each with the rule by which it takes its colour from a theme, so
 * that a new theme recolours what is there.
 */
export function createPalette(/** @type {Colours} */ colours) {
  let current = colours;
  /** @type {((colours: Colours) => void)[]} */
  const rules = [];
  const size = { value: new THREE.Vector2(1, 1) };
  const distance = { value: 1 };

  /** Follow a theme: now, and whenever it changes. */
  function follow(/** @type {(colours: Colours) => void} */ rule) {
    rules.push(rule);
    rule(current);
  }

  function keep(/** @type {THREE.Material} */ material, /** @type {Pick} */ pick) {
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
      return keep(new THREE.MeshLambertMaterial(options), pick);
    },

    /** Lit and polished: a light is seen in it. */
    polished(/** @type {Pick} */ pick, /** @type {THREE.MaterialOptions} */ options = {}) {
      const light = { specular: "#887755", shininess: 45 };
      return keep(new THREE.MeshPhongMaterial({ ...light, ...options }), pick);
    },

    /** One colour whatever the light, drawn only where something solid stands before it. */
    hidden(/** @type {Pick} */ pick) {
      const options = { depthFunc: THREE.GreaterDepth, depthWrite: false };
      return keep(new THREE.MeshBasicMaterial(options), pick);
    },

    /** One colour whatever the light, drawn over all else. */
    dot(/** @type {Pick} */ pick) {
      return keep(new THREE.MeshBasicMaterial({ depthTest: false }), pick);
    },

    /** Translucent; left out in high contrast, where lines stand for it. */
    sheet(
      /** @type {Pick} */ pick, /** @type {number} */ opacity, side = THREE.DoubleSide, lit = true,
    ) {
      const options = { transparent: true, opacity, depthWrite: false, side };
      const material = lit
        ? new THREE.MeshLambertMaterial(options)
        : new THREE.MeshBasicMaterial(options);
      follow((c) => (material.visible = !c.highContrast));
      return keep(material, pick);
    },

    /**
     * A line so many CSS pixels wide.
     *
     * @param {Pick} pick
     * @param {number} width
     * @param {{ fades?: boolean, old?: Pick }} options whether its far parts are fainter, and
     *   the colour of its old end
     * @returns {Line}
     */
    line(pick, width, { fades = false, old = pick } = {}) {
      const colour = { value: new THREE.Color() };
      const oldColour = { value: new THREE.Color() };
      const wide = { value: width };
      const far = { value: 0 };
      const count = { value: 0 };
      const material = new THREE.ShaderMaterial({
        uniforms: { colour, old: oldColour, width: wide, far, count, size, distance },
        vertexShader: RIBBON,
        fragmentShader: RIBBON_COLOUR,
        transparent: true,
        depthWrite: false,
        side: THREE.DoubleSide,
      });
        follow((c) => {
        colour.value.set(pick(c));
        oldColour.value.set(old(c));
        wide.value = c.highContrast ? THICKER * width ** 1.4 : width;
        far.value = fades && !c.highContrast ? 0.75 : 0;
      });
      return { material, count };
    },

    /** Line widths are in CSS pixels: they need the size of the picture. */
    resize(/** @type {number} */ width, /** @type {number} */ height) {
      size.value.x = width;
      size.value.y = height;
    },

    /** How far away the middle of the scene is, behind which lines grow faint. */
    look(/** @type {number} */ away) {
      distance.value = away;
    },

    setColours(/** @type {Colours} */ next) {
      current = next;
      for (const rule of rules) rule(next);
    },
  };
}
