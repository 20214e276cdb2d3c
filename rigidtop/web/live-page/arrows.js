const HEAD_LENGTH = 8.5;
const HEAD_RADIUS = 2.7;
const Z = new THREE.Vector3(0, 0, 1);
const way = new THREE.Vector3();

/** Geometries that all arrows share: both of length 1 along z. */
export function createArrows() {
  const shafts = new THREE.CylinderGeometry(1, 1, 1, 10, 1, true);
  shafts.rotateX(Math.PI / 2).translate(0, 0, 0.5);
  const heads = new THREE.ConeGeometry(1, 1, 20);
  heads.rotateX(Math.PI / 2).translate(0, 0, 0.5);

  return {
    /**
     * An arrow from the origin; its head keeps its size, however long it is.  What a body hides of
     * it is drawn in the material `hidden`, so that one sees where it starts.
     */
    add(
      /** @type {THREE.Material} */ material, /** @type {THREE.Material} */ hidden,
      /** @type {number} */ radius,
    ) {
      const object = new THREE.Group();
      const shaft = new THREE.Mesh(shafts, material);
      const head = new THREE.Mesh(heads, material);
      for (const part of [shaft, head]) {
        const behind = new THREE.Mesh(part.geometry, hidden);
        // After the bodies, before all arrows.
        behind.renderOrder = 1;
        part.renderOrder = 2;
        part.add(behind);
      }
      object.add(shaft, head);
      /** Where it ends. */
      const tip = new THREE.Vector3();
      let thick = radius;
      let long = 0;

      /** Shaft and head for the present length. */
      function fit() {
        const size = Math.min(1, long / (2 * HEAD_LENGTH * thick));
        const [r, headLength] = [thick * size, HEAD_LENGTH * thick * size];
        shaft.scale.set(r, r, long - headLength);
        head.scale.set(HEAD_RADIUS * r, HEAD_RADIUS * r, headLength);
        head.position.set(0, 0, long - headLength);
      }

      return {
        object,
        tip,
        /** Let it point along (x, y, z), this long; one of no length is not seen. */
        point(
          /** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ z,
          /** @type {number} */ length,
        ) {
          way.set(x, y, z);
          const norm = way.length();
          object.visible = norm > 0 && length > 1e-3;
          if (!object.visible) return;
          way.multiplyScalar(1 / norm);
          object.quaternion.setFromUnitVectors(Z, way);
          long = length;
          fit();
          tip.copy(way).multiplyScalar(length);
        },

        /** Make it so many times as thick as it was made. */
        thicken(/** @type {number} */ times) {
          thick = times * radius;
          fit();
        },
      };
    },
  };
}
