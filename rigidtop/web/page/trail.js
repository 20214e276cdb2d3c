import { createPieces } from "./lines.js";

/** @typedef {import("./types").Sample} Sample */
/** @typedef {import("./palette").Palette} Palette */

/** The most points that are drawn; older ones are left out. */
const MOST = 3000;

/** A curve whose newest end is the brightest. */
export function createTrail(/** @type {Palette} */ palette) {
  const white = palette.line(() => new THREE.Color("#fff"), 2.6, { vertexColors: true });
  const pieces = createPieces(MOST, white, true);
  const colours = /** @type {THREE.InterleavedBuffer} */ (pieces.colours);
  const fresh = new THREE.Color();
  const old = new THREE.Color();
  let coloured = -1;
  palette.follow((c) => {
    fresh.set(c.trail);
    old.set(c.trail).lerp(new THREE.Color(c.paper), c.highContrast ? 0.35 : 0.78);
    coloured = -1;
  });

  function colour(/** @type {number} */ count) {
    if (count === coloured) return;
    coloured = count;
    for (let i = 0; i < count; i++) {
      for (const [end, age] of [[0, i / count], [3, (i + 1) / count]]) {
        // Most of the fading is done by the older half.
        const part = age * age * (3 - 2 * age);
        colours.array[6 * i + end] = fresh.r + part * (old.r - fresh.r);
        colours.array[6 * i + end + 1] = fresh.g + part * (old.g - fresh.g);
        colours.array[6 * i + end + 2] = fresh.b + part * (old.b - fresh.b);
      }
    }
    colours.updateRange.count = 6 * count;
    colours.needsUpdate = true;
  }

  return {
    object: pieces.object,

    /**
     * Draw the trail of a direction, the newest point first.
     *
     * @param {Sample} now
     * @param {readonly Sample[]} trail
     * @param {(sample: Sample, out: THREE.Vector3) => void} direction
     */
    draw(now, trail, direction) {
      const { array } = pieces;
      direction(now, at);
      let [x, y, z] = [at.x, at.y, at.z];
      let count = 0;
      for (let i = trail.length - 1; i >= 0 && count < MOST; i--) {
        direction(trail[i], at);
        const out = 6 * count;
        array[out] = x;
        array[out + 1] = y;
        array[out + 2] = z;
        array[out + 3] = x = at.x;
        array[out + 4] = y = at.y;
        array[out + 5] = z = at.z;
        count += 1;
      }
      colour(count);
      pieces.show(count);
    },

    dispose() {
      pieces.object.geometry.dispose();
    },
  };
}

const at = new THREE.Vector3();
