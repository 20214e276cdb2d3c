/**
 * Lines of any width, in pieces from point to point.  All are buffers that are written in place,
 * so that a frame allocates nothing.
 */

/** Room for `capacity` pieces, at most 16383; `show(n)` draws the first n that were written. */
export function createPieces(/** @type {number} */ capacity, /** @type {Line} */ line) {
  const here = new THREE.BufferAttribute(new Float32Array(12 * capacity), 3);
  const there = new THREE.BufferAttribute(new Float32Array(12 * capacity), 3);
  here.setUsage(THREE.DynamicDrawUsage);
  there.setUsage(THREE.DynamicDrawUsage);
  const corners = new Float32Array(12 * capacity);
  const index = new Uint16Array(6 * capacity);
  for (let i = 0; i < capacity; i++) {
    // Side, place along the line, and which of the two ends.
    corners.set([1, i, 1, -1, i, 1, 1, i + 1, -1, -1, i + 1, -1], 12 * i);
    index.set([4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 2, 4 * i + 1, 4 * i + 3], 6 * i);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", here);
  geometry.setAttribute("other", there);
  geometry.setAttribute("corner", new THREE.BufferAttribute(corners, 3));
  geometry.setIndex(new THREE.BufferAttribute(index, 1));
  const object = new THREE.Mesh(geometry, line.material);
  object.frustumCulled = false;
  object.visible = false;
  // Behind what is translucent, which is then drawn over it.
  object.renderOrder = -1;
  const [ends, others] = [here.array, there.array];

  return {
    object,
    capacity,

    /** Write the piece i: it goes from (ax, ay, az) to (bx, by, bz). */
    set(
      /** @type {number} */ i, /** @type {number} */ ax, /** @type {number} */ ay,
      /** @type {number} */ az, /** @type {number} */ bx, /** @type {number} */ by,
      /** @type {number} */ bz,
    ) {
      const at = 12 * i;
      ends[at] = ends[at + 3] = others[at + 6] = others[at + 9] = ax;
      ends[at + 1] = ends[at + 4] = others[at + 7] = others[at + 10] = ay;
      ends[at + 2] = ends[at + 5] = others[at + 8] = others[at + 11] = az;
      others[at] = others[at + 3] = ends[at + 6] = ends[at + 9] = bx;
      others[at + 1] = others[at + 4] = ends[at + 7] = ends[at + 10] = by;
      others[at + 2] = others[at + 5] = ends[at + 8] = ends[at + 11] = bz;
    },

    show(/** @type {number} */ count) {
      object.visible = count > 0;
      geometry.setDrawRange(0, 6 * count);
      here.updateRange.count = there.updateRange.count = 12 * count;
      here.needsUpdate = there.needsUpdate = true;
    },
  };
}

/** Pieces that stay as they are, six numbers for the ends of each. */
export function createStrokes(
  /** @type {number[] | Float32Array} */ ends, /** @type {Line} */ line,
) {
  const pieces = createPieces(ends.length / 6, line);
  for (let i = 0; i < pieces.capacity; i++) {
    const [ax, ay, az, bx, by, bz] = ends.slice(6 * i, 6 * i + 6);
    pieces.set(i, ax, ay, az, bx, by, bz);
  }
  pieces.show(pieces.capacity);
  return pieces.object;
}

/** The pieces of a closed curve, given as a function of an angle. */
export function ringOf(
  /** @type {(angle: number) => readonly number[]} */ curve, /** @type {number} */ count,
) {
  /** @type {number[]} */
  const ends = [];
  for (let i = 0; i < count; i++) {
    ends.push(...curve((2 * Math.PI * i) / count), ...curve((2 * Math.PI * (i + 1)) / count));
  }
  return ends;
}

/** Write a curve of `count` points (x, y, z one after another) as pieces and show it. */
export function showCurve(
  /** @type {Pieces} */ pieces, /** @type {Float32Array} */ p, /** @type {number} */ count,
) {
  const shown = Math.max(0, Math.min(count - 1, pieces.capacity));
  for (let i = 0; i < shown; i++) {
    const at = 3 * i;
    pieces.set(i, p[at], p[at + 1], p[at + 2], p[at + 3], p[at + 4], p[at + 5]);
  }
  pieces.show(shown);
}
