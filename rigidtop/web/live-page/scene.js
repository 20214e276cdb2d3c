/** The picture: a body in motion, with its arrows, trails, cones and ellipsoid. */
import { createArrows } from "./arrows.js";
import { createCones } from "./cones.js";
import { createGovernor } from "./governor.js";
import { createLabels } from "./labels.js";
import { createPalette, mix } from "./palette.js";
import { createPoinsot } from "./poinsot.js";
import { createBodies } from "./shapes.js";
import { AXIS, createSurroundings } from "./surroundings.js";
import { createTrail } from "./trail.js";

/** Half of the angle of sight along the shorter side of the picture. */
const SIGHT = (13.5 * Math.PI) / 180;
/** What stands on the origin needs room above: the origin is lower by this part of the height. */
const LOWER = 0.045;
/** For what stands in its left corner it moves to the right by this part of the width, */
const ASIDE = 0.08;
/** and is smaller by this factor. */
const SMALLER = 1.08;
/** By how much the pivot's name stands below it. */
const BELOW = 0.04;
/** Where the camera is at first: distance, azimuth from x, elevation. */
const HOME = { distance: 5.2, azimuth: 0.6, elevation: 0.36 };
/** Lengths of arrows for the values at t = 0, and the longest that is drawn. */
const OMEGA = 1.08;
const MOMENTUM = 1.24;
const TORQUE = 1.25;
const LONGEST = 1.7;
/** The most pixels to a unit of length, and after how long a picture counts as standing (ms). */
const FINEST = 2;
const SETTLED = 400;

/** The scene in a container that it fills.  Throws an Error if the browser has no WebGL. */
export function createScene(/** @type {HTMLElement} */ container, /** @type {Colours} */ colours) {
  const canvas = document.createElement("canvas");
  const context = contextOf(canvas);
  const renderer = new THREE.WebGLRenderer({ canvas, context });
  canvas.style.cssText = "display:block;position:absolute;inset:0";
  if (getComputedStyle(container).position === "static") container.style.position = "relative";
  container.append(canvas);

  const scene = new THREE.Scene();
  const paper = new THREE.Color();
  scene.background = paper;
  const camera = new THREE.PerspectiveCamera(30, 1, 0.1, 60);
  camera.up.set(0, 0, 1);
  const sun = new THREE.DirectionalLight(0xffffff, 0.48);
  // The light comes over the shoulder of who looks.
  sun.position.set(-1.2, 2, 2.2);
  camera.add(sun);
  scene.add(camera, new THREE.AmbientLight(0xffffff, 0.64));

  const palette = createPalette(colours);
  const surroundings = createSurroundings(palette);
  const bodies = createBodies(palette);
  const cones = createCones(palette);
  const poinsot = createPoinsot(palette);
  const trace = createTrail(
    palette.line((c) => new THREE.Color(c.trail), 2.6, {
      old: (c) => mix(c.trail, c.paper, c.highContrast ? 0.35 : 0.78),
    }),
    true,
  );
  const ghostTrace = createTrail(palette.line((c) => new THREE.Color(c.polhode), 2));
  const arrows = createArrows();
  const labels = createLabels(container);

  // `world` is at rest in the chosen view; `space` has the axes x, y, z and `inBody` e₁, e₂, e₃.
  const world = new THREE.Group();
  const space = new THREE.Group();
  const inBody = new THREE.Group();
  /** What the trail is drawn on: fixed in space, or in the body when it is seen from there. */
  const dome = new THREE.Group();
  scene.add(world, surroundings.outline);
  world.add(space, inBody, dome);
  space.add(surroundings.axes, surroundings.floor, cones.space, poinsot.space);
  inBody.add(bodies.object, cones.body, poinsot.body);
  dome.add(surroundings.sphere, trace.object, ghostTrace.object);

  const e1 = arrowOf("e₁", (c) => c.e1, 0.0105, inBody);
  const e2 = arrowOf("e₂", (c) => c.e2, 0.0105, inBody);
  const e3 = arrowOf("e₃", (c) => c.e3, 0.0105, inBody);
  const omega = arrowOf("ω", (c) => c.omega, 0.0145, space);
  const momentum = arrowOf("L", (c) => c.L, 0.0125, space);
  const torque = arrowOf("N", (c) => c.torque, 0.0135, space);
  const ghostAxis = arrowOf("", (c) => c.polhode, 0.008, space);
  e1.arrow.point(1, 0, 0, 1);
  e2.arrow.point(0, 1, 0, 1);
  e3.arrow.point(0, 0, 1, 1);
  const axisLabels = ["x", "y", "z"].map((text) => labels.add(text, true));
  /** From the pivot of a held body by R to its centre of mass. */
  const armLabels = ["pivot", "R", "CM"].map((text) => labels.add(text));

  /** @type {Motion | null} */
  let motion = null;
  /** @type {View} */
  let view = "space";
  /** @type {ReadonlySet<Layer>} */
  let layers = new Set(/** @type {Layer[]} */ (["e3", "omega", "L", "trail"]));
  /** @type {Term["arrow"]} */
  let lit = "";
  /** @type {Sample | null} */
  let sample = null;
  /** @type {readonly Sample[]} */
  let trail = [];
  /** @type {Past<Sample> | null} */
  let ghost = null;
  let drawnTime = NaN;
  let dirty = true;
  let request = 0;
  let lost = false;
  let width = 1;
  let height = 1;
  let aside = false;
  let quality = 1;
  let fine = false;
  let settling = 0;
  /** Lengths as drawn for each unit of ω, L and torque. */
  const scales = { omega: 0, momentum: 0, torque: 0 };
  const attitude = new THREE.Quaternion();
  const inverse = new THREE.Quaternion();
  const still = new THREE.Quaternion();
  const ghostAt = new THREE.Vector3();

  const governor = createGovernor((next) => {
    quality = next;
    setResolution();
  });
  const controls = new THREE.OrbitControls(camera, canvas);
  controls.enablePan = false;
  controls.minDistance = 1.8;
  controls.maxDistance = 18;
  controls.rotateSpeed = 0.8;
  controls.addEventListener("change", touch);

  const notice = document.createElement("p");
  notice.setAttribute("role", "status");
  notice.style.cssText = "position:absolute;inset:auto 0 0;margin:0;padding:1em;text-align:center";
  canvas.addEventListener("webglcontextlost", onLost);
  canvas.addEventListener("webglcontextrestored", onRestored);

  recolour();
  resize();
  home();

  function arrowOf(
    /** @type {string} */ text, /** @type {(c: Colours) => string} */ pick,
    /** @type {number} */ radius, /** @type {THREE.Group} */ group,
  ) {
    const arrow = arrows.add(
      palette.solid((c) => new THREE.Color(pick(c))),
      palette.hidden((c) => mix(pick(c), c.body, c.highContrast ? 0.4 : 0.62)),
      radius,
    );
    const holder = new THREE.Group();
    holder.add(arrow.object);
    group.add(holder);
    const label = labels.add(text);
    palette.follow((c) => {
      label.element.style.color = pick(c);
      arrow.thicken(c.highContrast ? 1.5 : 1);
    });
    return { arrow, holder, label };
  }

  function onLost(/** @type {Event} */ event) {
    event.preventDefault();
    lost = true;
    notice.textContent = "The picture is gone for the moment: the browser took WebGL back.";
    container.append(notice);
  }

  function onRestored() {
    lost = false;
    notice.remove();
    touch();
  }

  /** Something changed: draw again soon, whether or not time goes on. */
  function touch() {
    dirty = true;
    if (!request) request = requestAnimationFrame(again);
  }

  function again() {
    cancelAnimationFrame(request);
    request = 0;
    if (dirty && sample) draw(sample, trail);
  }

  /** Pixels to a unit of length while things move. */
  function resolution() {
    return Math.min(FINEST, window.devicePixelRatio || 1) * quality;
  }

  function setResolution() {
    fine = false;
    renderer.setPixelRatio(resolution());
    touch();
  }

  /** A picture that stands may take its time: once more, with smooth edges. */
  function settle() {
    if (lost || resolution() >= FINEST) return;
    fine = true;
    renderer.setPixelRatio(FINEST);
    renderer.render(scene, camera);
  }

  function resize() {
    width = Math.max(1, container.clientWidth);
    height = Math.max(1, container.clientHeight);
    renderer.setSize(width, height);
    palette.resize(width, height);
    aim();
    setResolution();
    // At once: a canvas of another size is empty.
    again();
  }

  /** Fit the scene into the picture. */
  function aim() {
    camera.aspect = width / height;
    const tangent = (Math.tan(SIGHT) / Math.min(1, camera.aspect)) * (aside ? SMALLER : 1);
    camera.fov = (2 * Math.atan(tangent) * 180) / Math.PI;
    const stands = view === "space" || motion?.setup.kind === "heavy-top";
    const lower = stands ? LOWER * height : 0;
    camera.setViewOffset(width, height, aside ? -ASIDE * width : 0, -lower, width, height);
  }

  function recolour() {
    const { paper: back, ink, muted } = palette.colours;
    paper.set(back);
    labels.setHalo(back);
    notice.style.color = ink;
    for (const label of axisLabels) label.element.style.color = muted;
    for (const { element } of armLabels) element.style.cssText += `font-size:0.78em;color:${ink}`;
    touch();
  }

  function home() {
    const { distance, azimuth, elevation } = HOME;
    controls.target.set(0, 0, 0);
    const level = distance * Math.cos(elevation);
    camera.position.set(
      level * Math.cos(azimuth), level * Math.sin(azimuth), distance * Math.sin(elevation),
    );
    controls.update();
    touch();
  }

  function turn(/** @type {number} */ azimuth, /** @type {number} */ elevation) {
    const { position } = camera;
    const distance = position.length();
    const around = Math.atan2(position.y, position.x) + azimuth;
    const now = Math.asin(Math.max(-1, Math.min(1, position.z / distance)));
    const up = Math.max(-1.55, Math.min(1.55, now + elevation));
    const level = distance * Math.cos(up);
    position.set(level * Math.cos(around), level * Math.sin(around), distance * Math.sin(up));
    controls.update();
    touch();
  }

  function zoom(/** @type {number} */ factor) {
    // The controls keep the distance within its limits.
    camera.position.multiplyScalar(1 / factor);
    controls.update();
    touch();
  }

  function setMotion(/** @type {Motion} */ next, /** @type {Shape} */ shape) {
    motion = next;
    bodies.show(next, shape);
    cones.setMotion(next);
    if (next.setup.kind === "free") poinsot.setMotion(next);
    setScales(next);
    aim();
    arrange();
  }

  /** Arrows keep their scale while a body moves, so that one sees their lengths change. */
  function setScales(/** @type {Motion} */ { moments, weight, start }) {
    const reach = Math.hypot(weight[0], weight[1], weight[2]);
    // A body that starts slowly gains speed by falling.
    const fall = reach - (start.energy - kinetic(moments, start.omega));
    const gain = Math.sqrt(2 * Math.max(0, fall) / Math.max(moments[0], moments[1]));
    const speed = Math.max(norm(start.omega), 0.5 * gain);
    const swing = Math.max(norm(start.momentum), 0.5 * gain * Math.max(moments[0], moments[1]));
    scales.omega = speed > 0 ? OMEGA / speed : 0;
    scales.momentum = swing > 0 ? MOMENTUM / swing : 0;
    scales.torque = reach > 0 ? TORQUE / reach : 0;
  }

  /** Show what belongs to the layers, the view and the kind of motion. */
  function arrange() {
    if (!motion) return;
    const heavy = motion.setup.kind === "heavy-top";
    const construction = layers.has("poinsot") && !heavy;
    e1.holder.visible = layers.has("e1");
    e2.holder.visible = layers.has("e2");
    e3.holder.visible = layers.has("e3");
    omega.holder.visible = layers.has("omega");
    momentum.holder.visible = layers.has("L") || lit === "L";
    torque.holder.visible = heavy && (layers.has("torque") || lit === "torque");
    const usual = palette.colours.highContrast ? 1.5 : 1;
    momentum.arrow.thicken(lit === "L" ? 2 * usual : usual);
    torque.arrow.thicken(lit === "torque" ? 2 * usual : usual);
    surroundings.floor.visible = heavy;
    dome.visible = layers.has("trail");
    surroundings.outline.visible = layers.has("trail");
    cones.body.visible = cones.space.visible = layers.has("cones");
    poinsot.body.visible = poinsot.space.visible = construction;
    const size = construction ? poinsot.room(bodies.halves) : 1;
    bodies.object.scale.set(size, size, size);
    touch();
  }

  /** One frame; nothing is done if it would be the same as the last one. */
  function draw(
    /** @type {Sample} */ now, /** @type {readonly Sample[]} */ past,
    /** @type {Past<Sample> | null} */ beside = ghost,
  ) {
    // Of the same moment another motion, or what is to come of it, is drawn too.
    if (past !== trail) dirty = true;
    sample = now;
    trail = past;
    ghost = beside;
    if (lost || !motion || (!dirty && now.t === drawnTime)) return;
    if (now.t !== drawnTime) governor.tick(performance.now());
    dirty = false;
    drawnTime = now.t;

    const { q } = now;
    attitude.set(q[1], q[2], q[3], q[0]);
    inverse.copy(attitude).invert();
    const fromBody = view === "body";
    world.quaternion.copy(fromBody ? inverse : still);
    inBody.quaternion.copy(attitude);
    dome.quaternion.copy(fromBody ? attitude : still);

    const construction = poinsot.body.visible;
    pointTo(omega.arrow, now.omegaSpace, construction ? poinsot.scale : scales.omega);
    pointTo(momentum.arrow, now.momentum, scales.momentum);
    pointTo(torque.arrow, now.torque, scales.torque);

    if (surroundings.floor.visible) surroundings.shade(bodies.ground, attitude, now.e3);
    const traced = trailOf(motion, view, layers);
    if (dome.visible) trace.draw(now, past, traced, 1);
    ghostTrace.object.visible = ghostAxis.holder.visible = ghost !== null;
    if (ghost) {
      ghostTrace.draw(ghost.sample, ghost.trail, traced, 1);
      traced(ghost.sample, ghostAt);
      ghostAxis.holder.visible = view === "space";
      ghostAxis.arrow.point(ghostAt.x, ghostAt.y, ghostAt.z, 1);
    }
    if (layers.has("cones") && !cones.draw(now, past)) touch();
    if (construction) poinsot.draw(now, past);

    if (fine) renderer.setPixelRatio(resolution());
    fine = false;
    palette.look(camera.position.length());
    if (surroundings.outline.visible) surroundings.face(camera);
    renderer.render(scene, camera);
    placeLabels();
    clearTimeout(settling);
    settling = setTimeout(settle, SETTLED);
  }

  function placeLabels() {
    for (const { arrow, holder, label } of [e1, e2, e3]) {
      label.wanted = holder.visible;
      label.at.copy(arrow.tip).applyQuaternion(attitude).applyQuaternion(world.quaternion);
    }
    for (const { arrow, holder, label } of [omega, momentum, torque]) {
      label.wanted = holder.visible && arrow.object.visible;
      label.at.copy(arrow.tip).applyQuaternion(world.quaternion);
    }
    axisLabels.forEach((label, k) => {
      label.wanted = true;
      label.at.set(k === 0 ? 1 : 0, k === 1 ? 1 : 0, k === 2 ? 1 : 0);
      label.at.multiplyScalar(AXIS).applyQuaternion(world.quaternion);
    });
    armLabels.forEach((label, k) => {
      label.wanted = surroundings.floor.visible;
      if (label.wanted) label.at.copy(bodies.ground.centre).multiplyScalar(k / 2);
      label.at.applyQuaternion(attitude).applyQuaternion(world.quaternion);
    });
    if (armLabels[0].wanted) armLabels[0].at.set(0, 0, -BELOW).applyQuaternion(world.quaternion);
    labels.place(camera, width, height);
  }

  return {
    setMotion,
    draw,

    setLayers(/** @type {readonly Layer[]} */ next) {
      layers = new Set(next);
      arrange();
    },

    /** Make an arrow stand out, whether or not it is drawn else; "" for none. */
    light(/** @type {Term["arrow"]} */ arrow) {
      if (lit === arrow) return;
      lit = arrow;
      arrange();
    },

    setView(/** @type {View} */ next) {
      view = next;
      aim();
      touch();
    },

    setColours(/** @type {Colours} */ next) {
      palette.setColours(next);
      recolour();
    },

    /** Whether something lies over the left corner. */
    setAside(/** @type {boolean} */ next) {
      aside = next;
      aim();
      touch();
    },

    turn,
    zoom,
    home,
    resize,

    /** The canvas with the picture in it, drawn once more: later it may be gone. */
    picture(finely = quality === 1) {
      fine = finely;
      if (finely) renderer.setPixelRatio(FINEST);
      renderer.render(scene, camera);
      return canvas;
    },
  };
}

/** Smooth edges double the work of a renderer in software, which then cannot keep up. */
const SOFTWARE = /swiftshader|llvmpipe|software|basic render/i;

/** The drawing context of a canvas. */
function contextOf(/** @type {HTMLCanvasElement} */ canvas) {
  const attributes = { alpha: false, antialias: !drawnInSoftware() };
  const context =
    canvas.getContext("webgl2", attributes) || canvas.getContext("webgl", attributes);
  if (!context) {
    throw new Error("The picture needs WebGL, which this browser does not have or has turned off.");
  }
  return /** @type {WebGL2RenderingContext | WebGLRenderingContext} */ (context);
}

/** Whether the processor itself draws, as far as the browser tells. */
function drawnInSoftware() {
  const context = document.createElement("canvas").getContext("webgl");
  const details = context?.getExtension("WEBGL_debug_renderer_info");
  const name = details ? String(context?.getParameter(details.UNMASKED_RENDERER_WEBGL)) : "";
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return SOFTWARE.test(name);
}

function norm(/** @type {Numbers} */ v) {
  return Math.hypot(v[0], v[1], v[2]);
}

function kinetic(/** @type {Numbers} */ moments, /** @type {Numbers} */ omega) {
  let sum = 0;
  for (let k = 0; k < 3; k++) sum += moments[k] * omega[k] ** 2;
  return sum / 2;
}

/** Let an arrow show a vector. */
function pointTo(
  /** @type {Arrow} */ arrow, /** @type {Numbers} */ v,
  /** @type {number} */ scale,
) {
  arrow.point(v[0], v[1], v[2], Math.min(LONGEST, scale * norm(v)));
}

/**
 * The direction whose trail is drawn: of the body's axes the last whose arrow is.  Seen from the
 * body these rest: there it is the vertical that wanders for a heavy body, and the axis of rotation
 * for a free one.
 */
function trailOf(
  /** @type {Motion} */ { setup }, /** @type {View} */ view,
  /** @type {ReadonlySet<Layer>} */ shown,
) {
  if (view === "body") return setup.kind === "free" ? rotationAxis : vertical;
  return shown.has("e3") ? e3Axis : shown.has("e2") ? e2Axis : shown.has("e1") ? e1Axis : e3Axis;
}

const [e1Axis, e2Axis, e3Axis] = [0, 1, 2].map(
  (k) => (/** @type {Sample} */ { rotation }, /** @type {THREE.Vector3} */ out) => {
    out.set(rotation[k], rotation[3 + k], rotation[6 + k]);
  },
);

function rotationAxis(/** @type {Sample} */ { omega }, /** @type {THREE.Vector3} */ out) {
  out.set(omega[0], omega[1], omega[2]).normalize();
}

function vertical(/** @type {Sample} */ { rotation }, /** @type {THREE.Vector3} */ out) {
  out.set(rotation[6], rotation[7], rotation[8]);
}
