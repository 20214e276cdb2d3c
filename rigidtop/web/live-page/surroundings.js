import { createStrokes, ringOf } from "./lines.js";
import { mix } from "./palette.js";
import { shadowTexture } from "./textures.js";

/** How far the axes of the space frame go. */
export const AXIS = 1.25;

/** How far the table is below the pivot, which no wheel on it reaches, and its radius. */
const [LOWER, WIDE] = [0.6, 0.8];
/** How opaque the table is under a top that stands, and its shadow there. */
const [TABLE, SHADOW] = [0.5, 0.4];

/** What stands in space: the axes x, y, z, the table below the pivot, and the sphere of e₃. */
export function createSurroundings(/** @type {Palette} */ palette) {
  const axisLine = palette.line((c) => mix(c.muted, c.paper, 0.15), 1.2);
  const floorLine = palette.line((c) => mix(c.rule, c.muted, 0.2), 1, { fades: true });
  const sphereLine = palette.line((c) => mix(c.rule, c.muted, 0.2), 1, { fades: true });
  const outlineLine = palette.line((c) => mix(c.rule, c.muted, 0.45), 1.1);
  const standMaterial = palette.solid((c) => mix(c.muted, c.rule, 0.3));

  const axes = createStrokes(
    [0, 0, 0, AXIS, 0, 0, 0, 0, 0, 0, AXIS, 0, 0, 0, 0, 0, 0, AXIS], axisLine,
  );

  // A table with a post on which the top stands; it fades when the top hangs.
  /** @type {number[]} */
  const rings = [];
  for (const r of [1 / 3, 2 / 3, 1]) {
    rings.push(...ringOf((u) => [r * Math.cos(u), r * Math.sin(u), 0], 40));
  }
  const tableMaterial = palette.sheet((c) => mix(c.rule, c.paper, 0.4), 1, THREE.FrontSide, false);
  const table = new THREE.Mesh(new THREE.CircleGeometry(1, 64), tableMaterial);
  const shadowMaterial = new THREE.MeshBasicMaterial({
    map: shadowTexture(), transparent: true, depthWrite: false,
  });
  const shadow = new THREE.Mesh(new THREE.CircleGeometry(1, 48), shadowMaterial);
  [table.renderOrder, shadow.renderOrder] = [-3, -2];
  let dark = 0;
  palette.follow((c) => (dark = c.highContrast ? 0 : SHADOW));
  const stand = new THREE.Mesh(new THREE.ConeGeometry(0.05, 0.075, 24), standMaterial);
  stand.geometry.rotateX(Math.PI / 2).translate(0, 0, -0.042);
  const post = new THREE.Mesh(
    new THREE.CylinderGeometry(0.016, 0.016, LOWER - 0.07, 16), standMaterial,
  );
  post.geometry.rotateX(Math.PI / 2).translate(0, 0, -(LOWER + 0.07) / 2);
  const below = new THREE.Group();
  below.add(table, createStrokes(rings, floorLine));
  below.position.set(0, 0, -LOWER);
  below.scale.set(WIDE, WIDE, 1);
  const floor = new THREE.Group();
  floor.add(below, shadow, stand, post);
  const high = new THREE.Vector3();

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

    /**
     * The shadow of a wheel on the table, straight below it: the fainter the higher it is.
     *
     * @param {{ centre: THREE.Vector3, radius: number }} wheel in the body
     * @param {THREE.Quaternion} attitude
     * @param {Numbers} axis of the wheel, in space
     */
    shade({ centre, radius }, attitude, axis) {
      high.copy(centre).applyQuaternion(attitude);
      const above = Math.max(0, Math.min(1, 4 * high.z));
      below.visible = post.visible = above > 0;
      tableMaterial.opacity = TABLE * above;
      const away = high.z + LOWER;
      shadowMaterial.opacity = (dark * above) / (0.6 + away);
      shadow.position.set(high.x, high.y, 0.002 - LOWER);
      const blur = 1 + 0.3 * away;
      shadow.scale.set(blur * radius * Math.max(Math.abs(axis[2]), 0.15), blur * radius, 1);
      const half = Math.atan2(axis[1], axis[0]) / 2;
      shadow.quaternion.set(0, 0, Math.sin(half), Math.cos(half));
    },

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
  };
}
