/**
 * Lines of any width, as pieces: six numbers for each, its two ends.  All are buffers that are
 * written in place, so that a frame allocates nothing.
 */

/** Room for `capacity` pieces; `show(n)` draws the first n of them after they were written. */
export function createPieces(
  /** @type {number} */ capacity, /** @type {THREE.LineMaterial} */ material, coloured = false,
) {
  const geometry = new THREE.LineSegmentsGeometry();
  geometry.setPositions(new Float32Array(6 * capacity));
  if (coloured) geometry.setColors(new Float32Array(6 * capacity));
  const ends = geometry.attributes.instanceStart.data.setUsage(THREE.DynamicDrawUsage);
  const colours = coloured ? geometry.attributes.instanceColorStart.data : null;
  const object = new THREE.LineSegments2(geometry, material);
  object.frustumCulled = false;
  object.visible = false;
  return {
    object,
    capacity,
    array: ends.array,
    colours,
    show(/** @type {number} */ count) {
      geometry.instanceCount = count;
      object.visible = count > 0;
      ends.updateRange.count = 6 * count;
      ends.needsUpdate = true;
    },
  };
}

/** @typedef {ReturnType<typeof createPieces>} Pieces */

/** Pieces that stay as they are. */
export function createStrokes(
  /** @type {number[]} */ ends, /** @type {THREE.LineMaterial} */ material,
) {
  const geometry = new THREE.LineSegmentsGeometry();
  geometry.setPositions(new Float32Array(ends));
  const object = new THREE.LineSegments2(geometry, material);
  object.frustumCulled = false;
  return object;
}

/**
 * The pieces of a closed curve, given as a function of an angle.
 *
 * @param {(angle: number) => readonly number[]} curve
 * @param {number} count
 */
export function ringOf(curve, count) {
  /** @type {number[]} */
  const ends = [];
  for (let i = 0; i < count; i++) {
    ends.push(...curve((2 * Math.PI * i) / count), ...curve((2 * Math.PI * (i + 1)) / count));
  }
  return ends;
}

/** Write a curve of `count` points (x, y, z one after another) as pieces and show it. */
export function showCurve(
  /** @type {Pieces} */ pieces, /** @type {Float32Array} */ points, /** @type {number} */ count,
) {
  const { array } = pieces;
  const shown = Math.max(0, Math.min(count - 1, pieces.capacity));
  for (let i = 0; i < shown; i++) {
    for (let k = 0; k < 6; k++) array[6 * i + k] = points[3 * i + k];
  }
  pieces.show(shown);
}
