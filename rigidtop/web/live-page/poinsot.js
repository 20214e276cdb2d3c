/**
 * Poinsot's construction for a body without torque: the ellipsoid Σ λ_k ω_k² = 2T, fixed in the
 * body, rolls on the invariable plane; it touches the plane at ω, which runs along the polhode on
 * the ellipsoid and along the herpolhode in the plane.
 */
import { createPieces, createStrokes, ringOf } from "./lines.js";
import { mix } from "./palette.js";
import { enclosedAxis, familyOf, invariants, polhodeOf, polhodePoint } from "./polhode.js";
import { createTrail } from "./trail.js";

/** The longest semi-axis as drawn. */
const LONGEST = 1.1;
/** Where the neighbouring polhodes are, between the intermediate axis (0) and an outer one (1). */
const NEIGHBOURS = [0.12, 0.4, 0.75];
const FINE = 160;
const COARSE = 64;
const Z = new THREE.Vector3(0, 0, 1);

/** Ellipsoid and polhodes, to be fixed in the body, and plane and herpolhode, fixed in space. */
export function createPoinsot(/** @type {Palette} */ palette) {
  const skin = palette.sheet((c) => mix(c.polhode, c.body, 0.6), 0.2, THREE.FrontSide);
  const faint = palette.line((c) => mix(c.polhode, c.paper, c.highContrast ? 0.2 : 0.55), 1);
  const middle = palette.line((c) => mix(c.polhode, c.ink, 0.45), 1.6);
  const strong = palette.line((c) => new THREE.Color(c.polhode), 3.2);
  const trace = palette.line((c) => mix(c.omega, c.ink, 0.15), 2.4);
  const floor = palette.sheet((c) => mix(c.L, c.paper, 0.45), 0.16, THREE.DoubleSide, false);
  const grid = palette.line((c) => mix(c.L, c.paper, c.highContrast ? 0.2 : 0.6), 1);
  const touch = palette.dot((c) => new THREE.Color(c.omega));

  const ellipsoid = new THREE.Mesh(new THREE.SphereGeometry(1, 40, 24), skin);
  ellipsoid.renderOrder = 1;
  const own = createPieces(FINE, strong);
  const others = createPieces(4 * NEIGHBOURS.length * COARSE, faint);
  const separatrix = createPieces(4 * COARSE, middle);
  const body = new THREE.Group();
  body.add(ellipsoid, own.object, others.object, separatrix.object);

  const plane = new THREE.Group();
  const disc = new THREE.Mesh(new THREE.CircleGeometry(1, 64), floor);
  /** @type {number[]} */
  const rings = [];
  for (const r of [0.25, 0.5, 0.75, 1]) {
    rings.push(...ringOf((u) => [r * Math.cos(u), r * Math.sin(u), 0], 64));
  }
  plane.add(disc, createStrokes(rings, grid));
  const herpolhode = createTrail(trace);
  const contact = new THREE.Mesh(new THREE.SphereGeometry(0.022, 14, 10), touch);
  contact.renderOrder = 2;
  const space = new THREE.Group();
  space.add(plane, herpolhode.object, contact);

  let scale = 1;
  let stale = false;
  /** @type {Motion | null} */
  let motion = null;
  const point = [0, 0, 0];

  /** Write curves, as drawn. */
  function write(/** @type {Pieces} */ pieces, /** @type {number[][][]} */ curves) {
    let count = 0;
    for (const curve of curves) {
      for (let i = 1; i < curve.length; i++) {
        const [[a, b, c], [p, q, r]] = [curve[i - 1], curve[i]];
        pieces.set(count, scale * a, scale * b, scale * c, scale * p, scale * q, scale * r);
        count += 1;
      }
    }
    pieces.show(count);
  }

  function rebuild(/** @type {Motion} */ of) {
    const { moments, start } = of;
    const { twiceEnergy, squareL } = invariants(moments, start.omega);

    ellipsoid.scale.set(
      ...(/** @type {[number, number, number]} */ (
        Array.from(moments, (moment) => scale * Math.sqrt(twiceEnergy / moment))
      )),
    );

    const axis = enclosedAxis(moments, twiceEnergy, squareL);
    const side = Math.sign(start.omega[axis]) || 1;
    write(own, axis < 0 ? [] : [polhodeOf(moments, twiceEnergy, squareL, axis, side, FINE)]);
    const family = familyOf(moments, twiceEnergy, NEIGHBOURS, COARSE);
    write(others, family.others);
    write(separatrix, family.separatrix);

    // The plane is at the distance 2T/L from the centre, across L.
    const { momentum } = start;
    const length = Math.sqrt(squareL);
    plane.visible = length > 0;
    if (!plane.visible) return;
    const towards = new THREE.Vector3(momentum[0], momentum[1], momentum[2]).normalize();
    plane.quaternion.setFromUnitVectors(Z, towards);
    plane.position.copy(towards).multiplyScalar((scale * twiceEnergy) / length);
    const radius = Math.max(0.6, widest(of, twiceEnergy, squareL) + 0.12);
    plane.scale.set(radius, radius, radius);
  }

  /** How far the herpolhode gets from L, as drawn: ω is furthest out at an end of its polhode. */
  function widest(
    /** @type {Motion} */ { moments }, /** @type {number} */ twiceEnergy,
    /** @type {number} */ squareL,
  ) {
    const axis = enclosedAxis(moments, twiceEnergy, squareL);
    if (axis < 0) return 0;
    let most = 0;
    for (const angle of [0, Math.PI / 2]) {
      const [x, y, z] = polhodePoint(moments, twiceEnergy, squareL, axis, 1, angle, point);
      most = Math.max(most, x * x + y * y + z * z - twiceEnergy ** 2 / squareL);
    }
    return scale * Math.sqrt(most);
  }

  return {
    body,
    space,

    /** Length of the arrow of ω for each rad per unit of time, so that it ends on the plane. */
    get scale() {
      return scale;
    },

    setMotion(/** @type {Motion} */ next) {
      motion = next;
      stale = true;
      const { twiceEnergy } = invariants(next.moments, next.start.omega);
      const least = Math.min(next.moments[0], next.moments[1], next.moments[2]);
      scale = twiceEnergy > 0 ? LONGEST / Math.sqrt(twiceEnergy / least) : 0;
    },

    /** By how much a body with these half-axes must shrink to stay inside the ellipsoid. */
    room(/** @type {readonly number[]} */ halves) {
      if (!motion || !(scale > 0)) return 1;
      const { moments, start } = motion;
      const { twiceEnergy } = invariants(moments, start.omega);
      let corner = 0;
      for (let k = 0; k < 3; k++) {
        corner += (halves[k] ** 2 * moments[k]) / (scale ** 2 * twiceEnergy);
      }
      return Math.min(1, 0.92 / Math.sqrt(corner));
    },

    draw(/** @type {Sample} */ sample, /** @type {readonly Sample[]} */ trail) {
      if (!motion) return;
      if (stale) rebuild(motion);
      stale = false;
      herpolhode.draw(sample, trail, rotation, scale);
      const { omegaSpace } = sample;
      contact.position.set(omegaSpace[0], omegaSpace[1], omegaSpace[2]).multiplyScalar(scale);
    },
  };
}

function rotation(/** @type {Sample} */ { omegaSpace }, /** @type {THREE.Vector3} */ out) {
  out.set(omegaSpace[0], omegaSpace[1], omegaSpace[2]);
}
