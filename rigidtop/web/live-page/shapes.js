/**
 * The bodies.  Each shape is built once, of unit size; a body with other moments is the same
 * geometry scaled, so that a slider that moves builds nothing anew.
 */
import { axesByMoment } from "./polhode.js";
import { createStrokes } from "./lines.js";
import { markColour, mix } from "./palette.js";
import { createWheelFace } from "./textures.js";

/** The colours of a rock, of brass and of steel, as far as a theme lets them be. */
const [STONE, BRASS, STEEL] = ["#a3968a", "#c79a3a", "#aab4be"];
/** How far a body may reach from the origin, in units of the sphere of e₃. */
const REACH = 0.72;

/** A surface of revolution about z from a profile of (radius, z) upwards; each point is an edge. */
function turned(
  /** @type {readonly (readonly [number, number])[]} */ profile, /** @type {number} */ segments,
) {
  // Each point twice: what is between the two has no size, and rounds no edge off.
  const twice = profile.flatMap(([r, z]) => [new THREE.Vector2(r, z), new THREE.Vector2(r, z)]);
  const geometry = new THREE.LatheGeometry(twice.slice(1, -1), segments).rotateX(Math.PI / 2);
  const { position, uv } = geometry.attributes;
  // Seen along z.
  for (let k = 0; k < position.count; k++) {
    uv.setXY(k, 0.5 + 0.5 * position.getX(k), 0.5 + 0.5 * position.getY(k));
  }
  return geometry;
}

/** A wheel with a hub; radius 1, and 1 thick at the rim. */
const WHEEL = /** @type {const} */ ([
  [0, -0.85], [0.15, -0.85], [0.2, -0.5], [0.86, -0.5], [1, -0.3],
  [1, 0.3], [0.86, 0.5], [0.2, 0.5], [0.15, 0.85], [0, 0.85],
]);
/** A rod from z = 0 to 1; radius 1. */
const ROD = /** @type {const} */ ([[0, 0], [1, 0], [1, 1], [0, 1]]);
/** The foot of a stem: a point at the pivot. */
const FOOT = /** @type {const} */ ([[0, 0], [1, 1]]);
/** A rod with rounded ends, from z = −1 to 1; radius 1. */
const HANDLE = /** @type {const} */ ([
  [0, -1], [0.6, -0.985], [0.9, -0.95], [1, -0.9], [1, 0.9], [0.9, 0.95], [0.6, 0.985], [0, 1],
]);
/** The part of it that is painted. */
const HANDLE_END = /** @type {const} */ ([
  [1.02, 0.62], [1.02, 0.9], [0.92, 0.955], [0.62, 0.99], [0, 1.01],
]);

/** Half of the edges of a uniform brick, or semi-axes of an ellipsoid: a_i² ∝ λ_j + λ_k − λ_i. */
function proportions(/** @type {Numbers} */ moments) {
  const sum = moments[0] + moments[1] + moments[2];
  const halves = [0, 1, 2].map((i) => Math.sqrt(Math.max(0, sum - 2 * moments[i])));
  const most = Math.max(...halves);
  // Thinner than this it could not be seen.
  return halves.map((a) => Math.max(a / most, 0.06));
}

/** All bodies, of which one is shown. */
export function createBodies(/** @type {Palette} */ palette) {
  // A little behind, so that the edges are seen whole.
  const behind = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
  const body = palette.solid((c) => new THREE.Color(c.body), behind);
  const mark = palette.solid((c) => mix(c.body, markColour(c), 0.55), behind);
  const metal = (/** @type {string} */ colour) =>
    palette.polished((c) =>
      c.highContrast ? mix(c.body, markColour(c), 0.3) : new THREE.Color(colour));
  const [rod, steel] = [metal(BRASS), metal(STEEL)];
  const face = createWheelFace();
  const wood = palette.polished(() => new THREE.Color("#ffffff"), {
    map: face.texture, specular: "#221a10", shininess: 20,
  });
  palette.follow(face.paint);
  const rock = palette.solid((c) => mix(c.body, STONE, 0.7), { vertexColors: true });
  const edge = palette.line((c) => mix(c.body, markColour(c), 0.75), 1.4);
  const dot = palette.dot((c) => new THREE.Color(markColour(c)));

  const object = new THREE.Group();
  /** @type {Map<string, { object: THREE.Object3D, fit: (motion: Motion) => number[] }>} */
  const built = new Map();
  const builders = {
    "top": () => heldTop(wood, rod, dot, ground),
    "wheel": () => freeWheel(wood, rod),
    "brick": () => brick(body, mark, edge),
    "asteroid": () => asteroid(rock),
    "T-handle": () => handle(steel, rod),
  };
  let halves = [1, 1, 1];
  /** Where the wheel of a held top is in the body, and how large. */
  const ground = { centre: new THREE.Vector3(), radius: 0 };

  return {
    object,
    ground,

    /** How far the body goes along e₁, e₂, e₃ from the origin, as drawn. */
    get halves() {
      return halves;
    },

    /** Show the body of a motion. */
    show(/** @type {Motion} */ motion, /** @type {Shape} */ shape) {
      let chosen = built.get(shape);
      if (!chosen) {
        chosen = builders[shape]();
        built.set(shape, chosen);
        object.add(chosen.object);
      }
      for (const other of built.values()) other.object.visible = other === chosen;
      halves = chosen.fit(motion);
    },
  };
}

/**
 * A wheel on a stem that stands on the pivot, its centre the centre of mass.  As an elliptic
 * plate has moments M b²/4 and M a²/4 in its plane and their sum about its axis, the semi-axes
 * are a², b² = 2(λ₃ ± (λ₂ − λ₁))/M about its centre: r² = 2λ₃/M for a disc.
 *
 * @param {THREE.Material} wood
 * @param {THREE.Material} rod
 * @param {THREE.Material} dot
 * @param {{ centre: THREE.Vector3, radius: number }} ground What its shadow is made of.
 */
function heldTop(wood, rod, dot, ground) {
  const object = new THREE.Group();
  const disc = new THREE.Mesh(turned(WHEEL, 64), wood);
  const stem = new THREE.Mesh(turned(ROD, 16), rod);
  const foot = new THREE.Mesh(turned(FOOT, 16), rod);
  const arm = new THREE.Mesh(turned(ROD, 12), rod);
  const centre = new THREE.Mesh(new THREE.SphereGeometry(0.02, 16, 10), dot);
  centre.renderOrder = 2;
  object.add(disc, stem, foot, arm, centre);

  function fit(/** @type {Motion} */ motion) {
    const { values } = motion.setup;
    const { moments } = motion;
    const [x, y, z] = Array.from(motion.arm);
    const own = [
      moments[0] - values.M * (y * y + z * z),
      moments[1] - values.M * (x * x + z * z),
      moments[2] - values.M * (x * x + y * y),
    ];
    const semi = (/** @type {number} */ sign) =>
      Math.sqrt(Math.max(0, (2 * (own[2] + sign * (own[1] - own[0]))) / values.M));
    const wide = Math.max(semi(1), semi(-1));
    const distance = Math.hypot(x, y, z);
    const scale = Math.min(0.58 / distance, 0.56 / wide, 0.8 / Math.hypot(distance, wide));
    const clamp = (/** @type {number} */ a) => Math.min(0.62, Math.max(0.13, scale * a));
    const [a, b] = [clamp(semi(1)), clamp(semi(-1))];
    const thick = Math.min(0.13, 0.3 * Math.min(a, b));

    centre.position.set(scale * x, scale * y, scale * z);
    disc.position.copy(centre.position);
    ground.centre.copy(centre.position);
    ground.radius = Math.max(a, b);
    disc.scale.set(a, b, thick);

    // The stem stands on the pivot and ends a little beyond the wheel, on either side of it.
    const up = z < 0 ? -1 : 1;
    const length = Math.abs(scale * z) + Math.max(0.16, 0.9 * thick);
    const point = Math.min(0.12, 0.3 * length);
    foot.scale.set(0.021, 0.021, up * point);
    stem.position.set(0, 0, up * point);
    stem.scale.set(0.021, 0.021, up * (length - point));

    const aside = Math.hypot(x, y) * scale;
    arm.visible = aside > 0.01;
    if (arm.visible) {
      arm.position.set(0, 0, scale * z);
      arm.quaternion.setFromUnitVectors(
        new THREE.Vector3(0, 0, 1), new THREE.Vector3(x, y, 0).normalize(),
      );
      arm.scale.set(0.021, 0.021, aside);
    }
    return [scale * Math.abs(x) + a, scale * Math.abs(y) + b, length];
  }
  return { object, fit };
}

/** A wheel with an axle, held nowhere. */
function freeWheel(/** @type {THREE.Material} */ wood, /** @type {THREE.Material} */ rod) {
  const object = new THREE.Group();
  const disc = new THREE.Mesh(turned(WHEEL, 64), wood);
  const axle = new THREE.Mesh(turned(ROD, 16), rod);
  axle.position.set(0, 0, -0.4);
  axle.scale.set(0.026, 0.026, 0.8);
  object.add(disc, axle);

  function fit(/** @type {Motion} */ motion) {
    const [a, b, c] = proportions(motion.moments);
    const scale = 0.6 / Math.max(a, b, c);
    const thick = Math.max(0.08, 1.2 * scale * c);
    disc.scale.set(scale * a, scale * b, thick);
    axle.position.z = -thick - 0.16;
    axle.scale.z = 2 * thick + 0.32;
    return [scale * a, scale * b, thick + 0.16];
  }
  return { object, fit };
}

/** A brick with one end painted. */
function brick(
  /** @type {THREE.Material} */ body, /** @type {THREE.Material} */ mark,
  /** @type {Line} */ edge,
) {
  const object = new THREE.Group();
  const painted = 0.2;
  const box = new THREE.BoxGeometry(2 - painted, 2, 2).translate(-painted / 2, 0, 0);
  const end = new THREE.BoxGeometry(painted, 2, 2).translate(1 - painted / 2, 0, 0);
  const edges = new THREE.EdgesGeometry(new THREE.BoxGeometry(2, 2, 2)).attributes.position.array;
  object.add(
    new THREE.Mesh(box, body), new THREE.Mesh(end, mark), createStrokes(edges, edge),
  );

  function fit(/** @type {Motion} */ motion) {
    const [a, b, c] = proportions(motion.moments);
    const scale = Math.min(REACH / Math.hypot(a, b, c), 0.58);
    object.scale.set(scale * a, scale * b, scale * c);
    return [scale * a, scale * b, scale * c];
  }
  return { object, fit };
}

/** How far the rock stands out at a point of the unit sphere; waves of a few lengths. */
function bump(/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ z) {
  return 0.035 * Math.sin(2.3 * x + 1.1) * Math.cos(2.9 * y - 0.4) +
    0.028 * Math.sin(4.1 * y + 2.2 * z + 0.7) +
    0.02 * Math.sin(6.7 * z - 3.1 * x + 2.0) +
    0.012 * Math.sin(11 * x + 7 * y) * Math.cos(9 * z + 1.3);
}

/** Craters: the way to each, its radius and its depth. */
const CRATERS = /** @type {const} */ ([
  [0.55, 0.62, 0.56, 0.36, 0.085], [-0.35, 0.8, -0.49, 0.28, 0.07], [0.2, -0.75, 0.63, 0.33, 0.08],
  [-0.8, -0.3, 0.52, 0.3, 0.07], [0.75, -0.5, -0.43, 0.26, 0.06], [-0.1, 0.25, 0.96, 0.22, 0.05],
  [-0.62, 0.1, -0.78, 0.3, 0.07], [0.95, 0.1, 0.3, 0.2, 0.05],
]);

/** A rocky ellipsoid: its bumps are the same every time. */
function asteroid(/** @type {THREE.Material} */ rock) {
  const geometry = new THREE.IcosahedronGeometry(1, 9);
  const { array, count } = geometry.attributes.position;
  const shades = new Float32Array(3 * count);
  for (let n = 0; n < count; n++) {
    const [x, y, z] = [array[3 * n], array[3 * n + 1], array[3 * n + 2]];
    let height = bump(x, y, z);
    let shade = 0.95 + 2.2 * height;
    for (const [cx, cy, cz, radius, depth] of CRATERS) {
      const away = Math.hypot(x - cx, y - cy, z - cz) / radius;
      if (away >= 1.25) continue;
      // A bowl with a low rim.
      height += away < 1 ? depth * (away * away - 0.85) : depth * 0.15 * (1.25 - away) / 0.25;
      if (away < 1) shade -= 0.13 * (1 - away * away);
    }
    for (let k = 0; k < 3; k++) {
      array[3 * n + k] *= 1 + height;
      shades[3 * n + k] = Math.min(1, shade);
    }
  }
  geometry.setAttribute("color", new THREE.BufferAttribute(shades, 3));
  // The triangles share no corners: each keeps its own normal, which looks like rock.
  geometry.computeVertexNormals();
  const object = new THREE.Mesh(geometry, rock);

  function fit(/** @type {Motion} */ motion) {
    const halves = proportions(motion.moments).map((a) => 0.64 * a);
    object.scale.set(halves[0], halves[1], halves[2]);
    return halves;
  }
  return { object, fit };
}

/**
 * A T: its crossbar along the axis of the smallest moment, its stem along the intermediate axis,
 * about which it flips, and the largest moment across its plane.  To be known, not to scale.
 */
function handle(/** @type {THREE.Material} */ body, /** @type {THREE.Material} */ mark) {
  const object = new THREE.Group();
  const t = new THREE.Group();
  const bar = new THREE.Group();
  const stem = new THREE.Mesh(turned(HANDLE, 20), body);
  bar.add(
    new THREE.Mesh(turned(HANDLE, 20), body),
    new THREE.Mesh(turned(HANDLE_END, 20), mark),
  );
  // The local axes are those of the smallest, the intermediate and the largest moment.
  const x = new THREE.Vector3(1, 0, 0);
  const y = new THREE.Vector3(0, 1, 0);
  const z = new THREE.Vector3(0, 0, 1);
  bar.quaternion.setFromUnitVectors(z, x);
  bar.position.set(0, -0.16, 0);
  bar.scale.set(0.085, 0.085, 0.6);
  stem.quaternion.setFromUnitVectors(z, y);
  stem.position.set(0, 0.16, 0);
  stem.scale.set(0.072, 0.072, 0.34);
  t.add(bar, stem);
  object.add(t);

  function fit(/** @type {Motion} */ motion) {
    const [a, b, c] = axesByMoment(motion.moments);
    const units = [x, y, z];
    // A rotation, not a reflection; the T is the same on both sides of its plane.
    const even = (b - a + 3) % 3 === 1;
    const across = new THREE.Vector3().copy(units[c]).multiplyScalar(even ? 1 : -1);
    t.quaternion.setFromRotationMatrix(new THREE.Matrix4().makeBasis(units[a], units[b], across));
    const halves = [0, 0, 0];
    [halves[a], halves[b], halves[c]] = [0.6, 0.5, 0.09];
    return halves;
  }
  return { object, fit };
}
