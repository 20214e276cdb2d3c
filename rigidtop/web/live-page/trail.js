import { createPieces } from "./lines.js";

/** The most pieces that are drawn. */
const MOST = 3000;
/** The way between two samples is cut into pieces not longer than this, but not into more. */
const PIECE = 0.05;
const PARTS = 4;

/**
 * The way of a vector until now, its newest end first.  Samples are far apart: between them the
 * curve is a cubic, with the slope at each sample as a parabola through it and its neighbours has.
 */
export function createTrail(/** @type {Line} */ line, fading = false) {
  const pieces = createPieces(MOST, line);
  // Times, places and slopes of four samples that follow each other, from new to old.
  const times = new Float64Array(3);
  const places = new Float64Array(9);
  const slopes = new Float64Array(6);
  const at = new THREE.Vector3();

  return {
    object: pieces.object,

    /** Draw what `vectorOf` writes for each sample, times `scale`. */
    draw(
      /** @type {Sample} */ now, /** @type {readonly Sample[]} */ trail,
      /** @type {(sample: Sample, out: THREE.Vector3) => void} */ vectorOf,
      /** @type {number} */ scale,
    ) {
      let count = 0;
      let next = trail.length - 1;
      // What is drawn is between the samples 0 and 1; 2 is the one before them.
      while (next >= 0 && trail[next].t >= now.t) next -= 1;
      read(0, now);
      if (next >= 0) read(1, trail[next]);
      let first = true;
      for (let i = next; i >= 0 && count + PARTS <= MOST; i--) {
        const last = i === 0;
        if (!last) read(2, trail[i - 1]);
        slope(last, first);
        count = write(count);
        first = false;
        shift();
      }
      line.count.value = fading ? count : 0;
      pieces.show(count);

      function read(/** @type {number} */ k, /** @type {Sample} */ sample) {
        vectorOf(sample, at);
        times[k] = sample.t;
        places[3 * k] = scale * at.x;
        places[3 * k + 1] = scale * at.y;
        places[3 * k + 2] = scale * at.z;
      }
    },
  };

  /** Slopes at the samples 0 and 1; that at 0 is known unless it is the first. */
  function slope(/** @type {boolean} */ last, /** @type {boolean} */ first) {
    const h = times[0] - times[1];
    const g = times[1] - times[2];
    for (let k = 0; k < 3; k++) {
      const near = (places[k] - places[3 + k]) / h;
      const far = last ? near : (places[3 + k] - places[6 + k]) / g;
      const middle = last ? near : (g * near + h * far) / (g + h);
      slopes[3 + k] = middle;
      if (first) slopes[k] = 2 * near - middle;
    }
  }

  function write(/** @type {number} */ count) {
    const h = times[1] - times[0];
    const chord = Math.hypot(places[3] - places[0], places[4] - places[1], places[5] - places[2]);
    const parts = Math.min(PARTS, Math.ceil(chord / PIECE));
    let [x, y, z] = places;
    for (let part = 1; part <= parts; part++) {
      const u = part / parts;
      const v = 1 - u;
      const a = v * v * (1 + 2 * u);
      const b = u * u * (1 + 2 * v);
      const c = h * u * v * v;
      const d = -h * u * u * v;
      const p = a * places[0] + b * places[3] + c * slopes[0] + d * slopes[3];
      const q = a * places[1] + b * places[4] + c * slopes[1] + d * slopes[4];
      const r = a * places[2] + b * places[5] + c * slopes[2] + d * slopes[5];
      pieces.set(count, x, y, z, p, q, r);
      [x, y, z] = [p, q, r];
      count += 1;
    }
    return count;
  }

  /** Go one sample back. */
  function shift() {
    times[0] = times[1];
    times[1] = times[2];
    places.copyWithin(0, 3);
    slopes.copyWithin(0, 3);
  }
}
