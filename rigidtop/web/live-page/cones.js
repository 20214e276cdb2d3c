/**
 * Body cone and space cone: what the direction of ω sweeps in the body and in space.  They touch
 * along ω, and the first rolls on the second without slipping.
 */
import { createPieces, showCurve } from "./lines.js";
import { enclosedAxis, invariants, polhodeOf, polhodePeriod } from "./polhode.js";

/** How long the sides of the cones are. */
const SIDE = 0.95;
/** The most points on the edge of a cone. */
const MOST = 1200;

/** A fan of triangles from the origin, with its edge and, in high contrast, some of its rays. */
function createFan(
  /** @type {Palette} */ palette, /** @type {(c: Colours) => string} */ pick,
  /** @type {number} */ opacity,
) {
  const sheet = palette.sheet((c) => new THREE.Color(pick(c)), opacity);
  const line = palette.line((c) => new THREE.Color(pick(c)), 2);
  const edge = createPieces(MOST, line);
  const rays = createPieces(MOST / 8, line);

  const places = new THREE.BufferAttribute(new Float32Array(9 * MOST), 3);
  places.setUsage(THREE.DynamicDrawUsage);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", places);
  const mesh = new THREE.Mesh(geometry, sheet);
  mesh.frustumCulled = false;
  const object = new THREE.Group();
  object.add(mesh, edge.object, rays.object);

  const points = new Float32Array(3 * MOST);
  let count = 0;

  /** Where e.g. the top sleeps, ω only changes its length: such points are left out. */
  function add(/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ z) {
    const norm = Math.hypot(x, y, z);
    if (count === MOST || !(norm > 0)) return;
    points[3 * count] = (SIDE * x) / norm;
    points[3 * count + 1] = (SIDE * y) / norm;
    points[3 * count + 2] = (SIDE * z) / norm;
    count += 1;
  }

  function show() {
    // Each triangle has the origin and two points that follow each other.
    for (let i = 0; i + 1 < count; i++) {
      places.array.set(points.subarray(3 * i, 3 * i + 6), 9 * i + 3);
    }
    places.needsUpdate = true;
    geometry.computeVertexNormals();
    geometry.setDrawRange(0, 3 * Math.max(0, count - 1));
    showCurve(edge, points, count);
    let shown = 0;
    if (palette.colours.highContrast) {
      const step = Math.max(1, Math.ceil(count / 24));
      for (let i = 0; i < count; i += step) {
        rays.set(shown, 0, 0, 0, points[3 * i], points[3 * i + 1], points[3 * i + 2]);
        shown += 1;
      }
    }
    rays.show(shown);
  }

  return {
    object,
    clear() {
      count = 0;
    },
    add,
    show,
  };
}

/** While a slider moves, the cones are computed at most this often, in milliseconds. */
const EVERY = 100;

/** Both cones of a motion; the object of `body` belongs into the body, that of `space` not. */
export function createCones(/** @type {Palette} */ palette) {
  const body = createFan(palette, (c) => c.bodyCone, 0.36);
  const space = createFan(palette, (c) => c.spaceCone, 0.34);
  /** @type {Motion | null} */
  let motion = null;
  let stale = false;
  let computed = -Infinity;
  let followed = false;
  /** What is drawn ahead: so much time, and whether the curves close, so that it stays valid. */
  let extent = { space: 0, body: 0, closes: true };
  palette.follow(() => (stale = true));

  function bodyPoint(/** @type {Sample} */ { omega }) {
    body.add(omega[0], omega[1], omega[2]);
  }

  function spacePoint(/** @type {Sample} */ { omegaSpace }) {
    space.add(omegaSpace[0], omegaSpace[1], omegaSpace[2]);
  }

  function compute(/** @type {Motion} */ of) {
    body.clear();
    space.clear();
    if (of.setup.kind === "free") extent = computeFree(of);
    else extent = computeHeavy(of);
    body.show();
    space.show();
  }

  /** In a free body ω runs around its polhode, which is known exactly. */
  function computeFree(/** @type {Motion} */ of) {
    const { moments, start, timescale } = of;
    const { twiceEnergy, squareL } = invariants(moments, start.omega);
    const axis = enclosedAxis(moments, twiceEnergy, squareL);
    if (axis < 0 || !(squareL > 0) || !Number.isFinite(timescale)) {
      return { space: 0, body: 0, closes: true };
    }
    // In space, ω goes around L in about 2πλ/L: exactly so where two moments are equal to λ.
    const [least, middle, most] = Array.from(moments).sort((p, q) => p - q);
    const around = (2 * Math.PI * middle) / Math.sqrt(squareL);
    const closes = middle - least <= 1e-9 * most || most - middle <= 1e-9 * most;
    const period = polhodePeriod(moments, twiceEnergy, squareL);
    const shown = Math.min(period, 400 * timescale);
    const duration = closes ? around : Math.max(shown, 1.05 * around);
    const count = Math.min(MOST, Math.max(145, Math.ceil((8 * duration) / timescale)));
    const samples = of.ahead(duration, count);
    samples.forEach(spacePoint);
    if (period < Infinity) {
      const side = Math.sign(start.omega[axis]) || 1;
      for (const [x, y, z] of polhodeOf(moments, twiceEnergy, squareL, axis, side, 144)) {
        body.add(x, y, z);
      }
    } else {
      // On the separatrix ω takes for ever to come to the intermediate axis, where it rests.
      samples.forEach(bodyPoint);
    }
    return { space: duration, body: Infinity, closes };
  }

  /** With a torque: one turn of precession, unless it would last too long. */
  function computeHeavy(/** @type {Motion} */ of) {
    const { start, timescale } = of;
    const first = of.ahead(40 * timescale, 160);
    const last = first[first.length - 1];
    const rate = Math.abs((last.phi - start.phi) / last.t);
    const heights = first.map((sample) => sample.theta);
    const steady = Math.max(...heights) - Math.min(...heights) < 1e-4;
    const turn = rate > 0 ? (2 * Math.PI) / rate : Infinity;
    const duration = Math.min(turn, 240 * timescale);
    const count = Math.min(MOST, Math.max(145, Math.ceil((5 * duration) / timescale)));
    const samples = of.ahead(duration, count);
    samples.forEach(spacePoint);
    const closes = steady && duration === turn;
    const spin = Math.abs(start.psi_dot);
    const own = steady && spin > 0 ? Math.min(duration, (2 * Math.PI) / spin) : duration;
    if (own === duration) samples.forEach(bodyPoint);
    else of.ahead(own, 145).forEach(bodyPoint);
    return { space: duration, body: own, closes };
  }

  /** Where a curve does not close and the motion has left what was drawn ahead: the last of it. */
  function follow(/** @type {readonly Sample[]} */ trail, /** @type {number} */ now) {
    const from = now - extent.space;
    space.clear();
    if (Number.isFinite(extent.body)) body.clear();
    let step = 0;
    for (const { t } of trail) if (t >= from) step += 1;
    step = Math.ceil(step / MOST);
    for (let i = trail.length - 1; i >= 0 && trail[i].t >= from; i -= step) {
      spacePoint(trail[i]);
      if (Number.isFinite(extent.body)) bodyPoint(trail[i]);
    }
    space.show();
    if (Number.isFinite(extent.body)) body.show();
  }

  return {
    body: body.object,
    space: space.object,

    setMotion(/** @type {Motion} */ next) {
      motion = next;
      stale = true;
    },

    /** Bring the cones up to date; false if that has to wait for a later frame. */
    draw(/** @type {Sample} */ sample, /** @type {readonly Sample[]} */ trail) {
      if (!motion) return true;
      const now = performance.now();
      if (stale && now - computed < EVERY) return false;
      if (stale) {
        stale = false;
        compute(motion);
        computed = performance.now();
      }
      const beyond = !extent.closes && sample.t > extent.space;
      if (beyond) follow(trail, sample.t);
      else if (followed) compute(motion);
      followed = beyond;
      return true;
    },
  };
}
