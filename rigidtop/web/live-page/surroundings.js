import { createStrokes, ringOf } from "./lines.js";
import { mix } from "./palette.js";

/** @typedef {import("./palette").Palette} Palette */

/** How far the axes of the space frame go. */
export const AXIS = 1.25;

/** What stands in space: the axes x, y, z, the floor through the pivot, and the sphere of e₃. */
export function createSurroundings(/** @type {Palette} */ palette) {
  const axisLine = palette.line((c) => mix(c.muted, c.paper, 0.15), 1.2);
  const floorLine = palette.line((c) => mix(c.rule, c.muted, 0.2), 1, { fades: true });
  const sphereLine = palette.line((c) => mix(c.rule, c.muted, 0.2), 1, { fades: true });
  const outlineLine = palette.line((c) => mix(c.rule, c.muted, 0.45), 1.1);
  const standMaterial = palette.solid((c) => mix(c.muted, c.rule, 0.3));

  const axes = createStrokes(
    [0, 0, 0, AXIS, 0, 0, 0, 0, 0, 0, AXIS, 0, 0, 0, 0, 0, 0, AXIS], axisLine,
  );

  // A floor that is only lines: a top may hang below it.
  /** @type {number[]} */
  const rings = [];
  for (const r of [1 / 3, 2 / 3, 1]) {
    rings.push(...ringOf((u) => [r * Math.cos(u), r * Math.sin(u), 0], 40));
  }
  for (let i = 0; i < 12; i++) {
    const [c, s] = [Math.cos((i * Math.PI) / 6), Math.sin((i * Math.PI) / 6)];
    rings.push(c / 3, s / 3, 0, c, s, 0);
  }
  const floor = new THREE.Group();
  const stand = new THREE.Mesh(new THREE.ConeGeometry(0.05, 0.075, 24), standMaterial);
  stand.geometry.rotateX(Math.PI / 2).translate(0, 0, -0.042);
  floor.add(createStrokes(rings, floorLine), stand);

  /** @type {number[]} */
  const graticule = [];
  for (let i = 0; i < 6; i++) {
    const [c, s] = [Math.cos((i * Math.PI) / 6), Math.sin((i * Math.PI) / 6)];
    graticule.push(...ringOf((u) => [c * Math.sin(u), s * Math.sin(u), Math.cos(u)], 40));
  }
  for (const latitude of [-60, -30, 0, 30, 60]) {
    const [r, z] = [Math.cos((latitude * Math.PI) / 180), Math.sin((latitude * Math.PI) / 180)];
    graticule.push(...ringOf((u) => [r * Math.cos(u), r * Math.sin(u), z], 40));
  }
  const sphere = createStrokes(graticule, sphereLine);

  const outline = createStrokes(ringOf((u) => [Math.cos(u), Math.sin(u), 0], 64), outlineLine);

  return {
    axes,
    floor,
    sphere,
    /** The rim of the sphere as the camera sees it; it does not turn with the frame. */
    outline,

    /** Turn the rim to the camera; near by, less than half of the sphere is seen. */
    face(/** @type {THREE.Camera} */ camera) {
      const { position } = camera;
      const away = position.length();
      const nearer = 1 / away;
      const radius = Math.sqrt(Math.max(0, 1 - nearer / away));
      outline.position.copy(position).multiplyScalar(nearer / away);
      outline.scale.set(radius, radius, radius);
      outline.lookAt(position);
    },

    dispose() {
      for (const object of [axes, floor, sphere, outline]) {
        object.traverse((part) => {
          if (part instanceof THREE.Mesh) part.geometry.dispose();
        });
      }
    },
  };
}
